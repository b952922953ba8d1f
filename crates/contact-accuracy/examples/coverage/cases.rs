//! What is solved: a family on given points, and as the truth on four times as many.

use crate::families::{self, FAMILIES, FEW, Heights, MANY_WAVES, family, map};
use contact_accuracy::{
    Axis, ContactModulus, Estimate, Grid, HeightMap, Ladder, Leak, Load, Map, Maps, Setup,
    Solution, Solver, SolverBuilder, median, thinned,
};
use gap_flow::Gap;

const POINTS: usize = 128;
const FINER: usize = 4;
/// Area fractions on the given map that the loads are looked for at.
const AREAS: [f64; 5] = [0.005, 0.03, 0.15, 0.5, 0.95];

/// Length of the temperature jumps of the gas, over the rms height.
const JUMP: f64 = 0.3;

/// How a family is asked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Case {
    /// At pressures.
    Pressure,
    /// At the gaps of these pressures.
    Gap,
    /// With a hardness of half of E* times the rms gradient.
    Yielding,
    /// Pixels 2.7 times as long as wide.
    Oblong,
    /// 127 points along each side.
    Odd,
    /// Heights rounded to a twentieth of their rms, as an instrument may; the truth is the surface that was measured.
    Rounded,
    /// On every second point.
    Fast,
    /// For the gas and the leak through the gap.
    Gaps,
}

impl Case {
    /// Those that a family takes part in.
    pub(crate) fn all(name: &str) -> Vec<Self> {
        let mut all = vec![Self::Pressure, Self::Gap, Self::Fast, Self::Gaps];
        if FEW.contains(&name) {
            all.extend([Self::Yielding, Self::Oblong, Self::Odd, Self::Rounded]);
        }
        all
    }
}

/// Errors and half widths of one number, over the value (of a gap over the rms height).
#[derive(Default, Clone)]
pub(crate) struct Held(pub(crate) Vec<[f64; 2]>);

impl Held {
    fn take(&mut self, stated: &Estimate, truth: f64, unit: f64) {
        let Ok(half) = stated.half_width() else { return };
        let unit = if unit > 0.0 { unit } else { stated.value }; // nothing touches in truth
        self.0.push([(stated.value - truth).abs() / unit, half / unit]);
    }

    /// Of a permeability and a bound of one: as logarithms, for each is stated with a factor.
    fn take_leak(&mut self, bounds: &mut Self, stated: &Leak, truth: f64) {
        match stated.interval() {
            Some([low, high]) if low > 0.0 => {
                let k = stated.flow.permeability;
                self.0.push([(k / truth).ln().abs(), (high / k).ln()]);
            }
            Some([_, high]) => bounds.0.push([truth, high]),
            None => {}
        }
    }

    pub(crate) fn count(&self) -> usize {
        self.0.iter().filter(|[error, half]| *error <= half.max(f64::MIN_POSITIVE)).count()
    }

    pub(crate) fn share(&self) -> f64 {
        self.count() as f64 / self.0.len() as f64
    }

    /// Of errors and half widths.
    pub(crate) fn medians(&self) -> [f64; 2] {
        [0, 1].map(|k| median(self.0.iter().map(|of| of[k])).unwrap_or(f64::NAN))
    }
}

/// Of one family or more: area, gap (at a gap the pressure), stiffness, and where they are asked gas, permeability, bounds
/// of it; seconds on the map and beside it.
#[derive(Default, Clone)]
pub(crate) struct Coverage {
    pub(crate) held: [Held; 6],
    /// Share of each that held in the family where that is least.
    pub(crate) worst: Option<[f64; 6]>,
    pub(crate) seconds: [f64; 3],
}

impl Coverage {
    /// Adds other families, or another map of the same.
    pub(crate) fn add(&mut self, other: &Self) {
        for (a, b) in self.held.iter_mut().zip(&other.held) {
            a.0.extend(&b.0);
        }
        let of = other.worst.unwrap_or_else(|| other.held.each_ref().map(Held::share));
        // Five answers of one map are no family.
        if other.held[0].0.len() > AREAS.len() {
            let least = self.worst.unwrap_or(of);
            self.worst = Some(std::array::from_fn(|k| least[k].min(of[k])));
        }
        (0..3).for_each(|k| self.seconds[k] += other.seconds[k]);
    }
}

fn modulus() -> ContactModulus {
    ContactModulus::from_pascals(1.0).unwrap()
}

/// A solver for this map, on one thread.
fn solver_of(map: &HeightMap, builder: SolverBuilder) -> Solver {
    let mut solver = builder.threads(1).build(map.grid(), modulus()).unwrap();
    solver.take_surface(map).unwrap();
    solver
}

/// One map of a family, asked as `case` says.
pub(crate) fn solved(heights: &Heights, case: Case) -> Coverage {
    let points = if case == Case::Odd { POINTS - 1 } else { POINTS };
    let on = |n: usize| {
        if case != Case::Oblong {
            return map(n, heights);
        }
        let grid = Grid::new([n, n], [1.0 / n as f64, 2.7 / n as f64]).unwrap();
        HeightMap::from_fn(grid, |y, x| heights(y, x / 2.7)).unwrap()
    };
    let (mut given, fine) = (on(points), on(FINER * points));
    if case == Case::Rounded {
        let step = 0.05 * Map::of(&given).rms_height;
        let rounded = given.heights().iter().map(|h| (h / step).round() * step).collect();
        given = HeightMap::new(given.grid(), rounded).unwrap();
    }
    let unit = Map::of(&given).rms_height;
    let half = thinned(&given, [0, 0]).unwrap();
    let mut probe = solver_of(&half, Solver::builder().tolerance(1e-3));
    let pressures: Vec<f64> =
        AREAS.iter().map(|a| pressure_for(&mut probe, *a, 10.0 * unit)).collect();
    // Between the pressures of 15 and 50 % of the area.
    let hardness = if case == Case::Yielding { 1.5 * pressures[3] } else { f64::INFINITY };
    let builder = Solver::builder().hardness(hardness);
    let setup = Setup {
        finer: case != Case::Fast,
        jump: (case == Case::Gaps).then_some(JUMP * unit),
        leak: if case == Case::Gaps { vec![Axis::X] } else { Vec::new() },
        ..Setup::new(builder.clone().threads(1), modulus())
    };
    let used = if case == Case::Fast { half } else { given };
    let with = |stiffness| Ladder::new(used.clone(), Setup { stiffness, ..setup.clone() }).unwrap();
    // Where it is asked for, the maps beside are solved more closely.
    let (mut ladder, mut stiff) = (with(false), with(true));
    let maps = if case == Case::Gaps { Maps::PressureAndGap } else { Maps::Pressure };
    let mut exact = solver_of(&fine, builder.tolerance(1e-5).maps(maps));
    let mut found = Coverage::default();
    let mut loads: Vec<Load> =
        pressures.into_iter().filter(|p| *p < 0.9 * hardness).map(Load::MeanPressure).collect();
    if case == Case::Gap {
        let mut gap = |load| ladder.solve(load, |_| ()).unwrap().solution.state.mean_gap.unwrap();
        loads = loads.into_iter().map(|load| Load::MeanGap(gap(load))).collect();
    }
    for load in loads {
        let answered = ladder.solve(load, |_| ()).unwrap();
        let Ok(truth) = exact.solve_again(load, None, |_| ()) else { continue };
        let set = exact.contact_stiffness(|i| truth.pressure[i] > 0.0).unwrap();
        let (budget, true_area) = (answered.budget, truth.state.area_fraction);
        found.held[0].take(&budget.area, true_area, true_area);
        if case == Case::Gap {
            let pressure = truth.state.mean_pressure;
            found.held[1].take(&budget.mean_pressure, pressure, pressure);
        } else if let (Some(gap), Some(truth)) = (&budget.mean_gap, truth.state.mean_gap) {
            found.held[1].take(gap, truth, unit);
        }
        if let (Some(gas), Some(leak)) = (&budget.gas, &answered.leak) {
            let true_gas = families::gas(&truth, JUMP * unit);
            found.held[3].take(gas, true_gas, true_gas);
            let [_, _, _, _, rates, bounds] = &mut found.held;
            let stated = leak.along[0].1.as_ref().unwrap();
            rates.take_leak(bounds, stated, permeability(&truth, ladder.known.repeats));
        }
        let [coarser, finer] = answered.seconds;
        found.seconds[0] += answered.solution.diagnostics.seconds - coarser - finer;
        found.seconds[1] += coarser;
        found.seconds[2] += finer;
        let stiffness = stiff.answer(load, answered.solution, |_| ()).unwrap().budget.stiffness;
        if let Some(stiffness) = stiffness.filter(|_| set.per_area.is_finite()) {
            found.held[2].take(&stiffness, set.per_area, set.per_area);
        }
    }
    found
}

/// Permeability along x of a gap that touches where it carries pressure and repeats along the flow or does not.
fn permeability(solution: &Solution, repeats: bool) -> f64 {
    let open = solution.open_gap();
    Gap::new(solution.grid, &open).repeating([repeats, true]).permeability(Axis::X).unwrap()
}

/// Pressure at which the area on the map of `solver` is `area`, about.
fn pressure_for(solver: &mut Solver, area: f64, guess: f64) -> f64 {
    let mut at = |p: f64| {
        let solution = solver.solve_again(Load::MeanPressure(p), None, |_| ()).unwrap();
        solution.state.area_fraction
    };
    let (mut low, mut high) = (guess, guess);
    while at(low) > area && low > 1e-9 * guess {
        low *= 0.3;
    }
    while at(high) < area && high < 1e3 * guess {
        high *= 2.0;
    }
    for _ in 0..7 {
        let middle = (low * high).sqrt();
        if at(middle) < area { low = middle } else { high = middle }
    }
    (low * high).sqrt()
}

/// Maps of each family whose mean stands for the surface.
const MAPS: u64 = 20;

/// The sampling variability: of each map of a family, whether it holds the mean of all.
pub(crate) fn sampling() -> String {
    let families: Vec<&str> = FAMILIES
        .iter()
        .map(|f| f.0)
        .chain([MANY_WAVES])
        .filter(|name| !name.starts_with("egg box") && *name != "sawtooth" && *name != "turned")
        .collect();
    let builder = || Solver::builder().tolerance(1e-3).threads(1);
    let mut all: [Vec<[f64; 2]>; 3] = Default::default(); // distance over half width, half width
    let mut worst = [(1.0, ""); 3];
    for name in families {
        let mut numbers: Vec<Vec<[Option<[f64; 2]>; 3]>> = vec![Vec::new(); 3];
        let pressures: Vec<f64> = {
            let given = map(POINTS, &family(name, 100).unwrap());
            let unit = Map::of(&given).rms_height;
            let mut probe = solver_of(&given, builder());
            [0.01, 0.1, 0.5].map(|a| pressure_for(&mut probe, a, 10.0 * unit)).to_vec()
        };
        for seed in 100..100 + MAPS {
            let setup = Setup { finer: false, stiffness: true, ..Setup::new(builder(), modulus()) };
            let mut ladder = Ladder::new(map(POINTS, &family(name, seed).unwrap()), setup).unwrap();
            for (k, p) in pressures.iter().enumerate() {
                let b = ladder.solve(Load::MeanPressure(*p), |_| ()).unwrap().budget;
                let of = |e: Option<Estimate>| e.and_then(|e| Some([e.value, e.sampling?]));
                numbers[k].push([of(Some(b.area)), of(b.mean_gap), of(b.stiffness)]);
            }
        }
        for k in 0..3 {
            let mut here = Vec::new();
            for maps in &numbers {
                let known: Vec<[f64; 2]> = maps.iter().filter_map(|m| m[k]).collect();
                let mean = known.iter().map(|v| v[0]).sum::<f64>() / known.len() as f64;
                here.extend(known.iter().map(|[v, half]| [(v - mean).abs() / half, half / v]));
            }
            let share = here.iter().filter(|h| h[0] <= 1.0).count() as f64 / here.len() as f64;
            if share < worst[k].0 {
                worst[k] = (share, name);
            }
            all[k].extend(here);
        }
    }
    let mut rows = vec![
        "| sampling variability of | coverage | worst family | median ± |\n|---|---:|---|---:|"
            .to_owned(),
    ];
    for (k, name) in ["area", "mean gap", "stiffness"].into_iter().enumerate() {
        let held = all[k].iter().filter(|h| h[0] <= 1.0).count() as f64 / all[k].len() as f64;
        let width = median(all[k].iter().map(|h| h[1])).unwrap();
        let (least, family) = worst[k];
        rows.push(format!(
            "| {name} | {:.1} % | {:.0} % ({family}) | ±{:.0} % |",
            100.0 * held,
            100.0 * least,
            100.0 * width
        ));
    }
    rows.join("\n")
}
