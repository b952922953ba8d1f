//! One map: its answers with their intervals as the command states them, beside the same surface on
//! four times as many points along each side; and what `--accuracy` claims of it.

use crate::{fresh, judged, tuning};
use contact_accuracy::budget::grid::Line;
use contact_accuracy::budget::{Between, Budget, Map, Stiffness};
use contact_accuracy::plan::{self, Request, Sink, Task};
use contact_accuracy::{TwiceFiner, regrid};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Boundary, Iteration, Load, Maps, Method, Solution, Solver, SolverError};
use std::error::Error;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use studies::drawing::{log_between, van_der_corput};
use studies::maps::{Draw, GRADIENT, scaled};

/// Points along each side.
const POINTS: usize = 96;
/// Contact modulus \[Pa\]; every number kept is free of it.
const MODULUS: f64 = 1e11;
/// Mean pressure over E* times the rms gradient, before it is moved about a little.
const LOADS: [f64; 6] = [0.0005, 0.003, 0.015, 0.08, 0.4, 1.3];
/// Accuracies asked for.
pub(crate) const REQUESTS: [f64; 2] = [0.05, 0.02];
/// Loads they are asked for at, by place.
const ASKED_AT: [usize; 3] = [1, 2, 3];

/// First line of the table.
pub(crate) fn header() -> String {
    let mut line = String::from("family,map,load,repeats,own,rms");
    for name in ["area", "gap", "stiffness"] {
        let _ = write!(line, ",{name},{name}_half,{name}_truth");
    }
    for percent in ["5", "2"] {
        let _ = write!(line, ",claimed{percent}");
    }
    line
}

/// The rows of one map, one per load. Intervals that are not stated have a half width of NaN; so has
/// what is claimed where nothing is.
pub(crate) fn map(family: &str, index: usize) -> Result<String, Box<dyn Error>> {
    let salt = family.bytes().map(u64::from).sum::<u64>();
    let shift = 0.137 * (salt % 97) as f64;
    let t = [2, 3, 5, 7].map(|base| (van_der_corput(index, base) + shift).fract());
    let draw = Draw { n: POINTS, seed: 7_000_000 + 100 * salt + index as u64, t };
    let heights = if fresh::FRESH.contains(&family) {
        fresh::heights(family, &draw)
    } else if judged::JUDGED.contains(&family) {
        judged::heights(family, &draw)
    } else {
        tuning::heights(family, &draw)
    }?;
    let map = scaled(&heights, POINTS)?;
    let jitter = log_between(0.7, 1.5, van_der_corput(index, 11));
    let loads = LOADS.map(|x| (x * jitter).clamp(0.0005, 1.3));
    let known = Map::of(&map)?;
    let stated = stated(&map, &known, &loads)?;
    let fine = regrid(&map, [4 * POINTS; 2], known.repeats)?;
    let truth = truth(&fine, &loads)?;
    let claimed = claimed(&map, &known, &loads)?;
    let mut rows = String::new();
    for (k, load) in loads.iter().enumerate() {
        let budget = &stated[k];
        let own = budget.own.map_or_else(|why| name(&format!("{why:?}")), |()| "own".into());
        let repeats = u8::from(known.repeats);
        let _ = write!(rows, "{family},{index},{load:.5},{repeats},{own},{:.5e}", known.rms_height);
        let numbers = [Some(budget.area), budget.mean_gap, budget.stiffness];
        for (number, truth) in numbers.iter().zip(truth[k]) {
            let value = number.map_or(f64::NAN, |n| n.value);
            let half = number.and_then(|n| n.comparison_half_width().ok()).unwrap_or(f64::NAN);
            let _ = write!(rows, ",{value:.7e},{half:.4e},{truth:.7e}");
        }
        for claims in &claimed {
            let _ = write!(rows, ",{:.7e}", claims[k]);
        }
        rows.push('\n');
    }
    Ok(rows)
}

/// The first word of a reason.
fn name(reason: &str) -> String {
    reason.split([' ', '{', '(']).next().unwrap_or_default().to_owned()
}

fn modulus() -> Result<ContactModulus, Box<dyn Error>> {
    Ok(ContactModulus::from_pascals(MODULUS)?)
}

fn pressure(load: f64) -> f64 {
    load * MODULUS * GRADIENT
}

/// What the command states, with a finer grid where the given one has no bar.
fn stated(map: &HeightMap, known: &Map, loads: &[f64]) -> Result<Vec<Budget>, Box<dyn Error>> {
    let builder = Solver::builder().threads(1);
    let mut solver = builder.clone().build(map.grid(), modulus()?)?;
    let mut finer = TwiceFiner::of(map, known, Boundary::Periodic, builder, modulus()?)?;
    let mut list = Vec::new();
    for load in loads {
        let at = Load::MeanPressure(pressure(*load));
        let solution = solver.solve(map, at)?;
        let mut budget = Budget::of(&solution, known);
        if let Some(between) = Between::of(map, known.repeats, &solution.pressure, modulus()?) {
            budget = budget.between(&between);
        }
        if let Some(near) = Stiffness::near(&mut solver, map, pressure(*load))? {
            budget = budget.with_stiffness(&near, known, Line::of(&solution));
        }
        if TwiceFiner::is_wanted(&budget, known) {
            budget = budget.refined(&finer.solve(at, &budget)?);
        }
        list.push(budget);
    }
    Ok(list)
}

/// Area, gap and stiffness, NaN where there is none.
fn truth(fine: &HeightMap, loads: &[f64]) -> Result<Vec<[f64; 3]>, Box<dyn Error>> {
    let mut solver = Solver::builder().tolerance(1e-5).threads(1).build(fine.grid(), modulus()?)?;
    let mut list = Vec::new();
    for load in loads {
        let found = solver.solve(fine, Load::MeanPressure(pressure(*load)))?;
        let near = Stiffness::near(&mut solver, fine, pressure(*load))?;
        list.push([
            found.diagnostics.area_fraction_corrected,
            found.state.mean_gap.unwrap_or(f64::NAN),
            near.map_or(f64::NAN, |near| near.value),
        ]);
    }
    Ok(list)
}

/// The area that is claimed to meet each request at each load.
fn claimed(map: &HeightMap, known: &Map, loads: &[f64]) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let mut list = Vec::new();
    for asked in REQUESTS {
        let mut claims = vec![f64::NAN; loads.len()];
        for place in ASKED_AT {
            let at = [Load::MeanPressure(pressure(loads[place]))];
            let task = Task {
                map,
                known,
                modulus: modulus()?,
                loads: &at,
                boundary: Boundary::Periodic,
                request: Request::new(asked)?,
                method: Method::Auto,
                certified: false,
                maps: Maps::Pressure,
                section: None,
                threads: 1,
            };
            let mut last = Last(f64::NAN);
            let outcome = plan::run(&task, &mut last)?;
            if outcome.met {
                claims[place] = last.0;
            }
        }
        list.push(claims);
    }
    Ok(list)
}

/// Keeps the corrected area of the last solution.
struct Last(f64);

impl Sink for Last {
    fn begin(&mut self, _: &HeightMap) {}

    fn iterated(&mut self, _: usize, _: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    fn take(
        &mut self,
        _: usize,
        result: Result<Solution, SolverError>,
        _: Option<Budget>,
    ) -> ControlFlow<()> {
        self.0 = result.map_or(f64::NAN, |s| s.diagnostics.area_fraction_corrected);
        ControlFlow::Continue(())
    }
}
