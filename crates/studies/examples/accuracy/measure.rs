//! One surface: the truth, and what every request made of it.

use crate::ensemble::Recipe;
use compare::budget::{Budget, Map};
use compare::plan::{Miss, NoBar, Request, Sink, Task, Unmet, run};
use contact_accuracy::NoAreaInterval;
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{
    BOUNDARY_CORRECTION, Boundary, Load, Maps, Method, Solution, Solver, SolverError,
};
use std::error::Error;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use surface_stats::clean::{resample, resample_mirrored};
use surface_stats::height_step;
use surface_stats::spectrum::{PowerSpectrum, Window};

/// Columns of the table. `mode` is what was prescribed: the mean pressure; the mean gap that the
/// truth has at that pressure; the mean pressure of an isolated contact. Areas are corrected
/// fractions. Of a given gap, `other` is the error of the pressure found and `other_bar` its half
/// width, both relative; of a given pressure the same of the gap, over the rms height. `work` is
/// points × pairs × bytes of the program's choice and of the default, the given grid in f64 to 1e-4.
pub(crate) const HEADER: &str = "surface,family,cutoff,mode,load,truth,truth_bar,request,claimed,\
     half_width,error,other,other_bar,factor,given_up,work,work_default,reason";

/// Mean pressure over E* h'_rms.
const LOADS: [f64; 3] = [0.003, 0.02, 0.1];
/// Relative half widths asked for.
const REQUESTS: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];
/// Points per side of the truth over those of the map.
const FINER: usize = 8;

/// What is prescribed.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Mode {
    Pressure,
    Gap,
    Isolated,
}

impl Mode {
    pub(crate) const ALL: [Self; 3] = [Self::Pressure, Self::Gap, Self::Isolated];

    /// As in the table.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Pressure => "pressure",
            Self::Gap => "gap",
            Self::Isolated => "isolated",
        }
    }

    fn boundary(self) -> Boundary {
        match self {
            Self::Isolated => Boundary::Free,
            _ => Boundary::Periodic,
        }
    }
}

/// The rows of one surface.
pub(crate) fn surface(index: usize, recipe: &Recipe) -> Result<String, Box<dyn Error>> {
    let map = recipe.make()?;
    let known = Map::with_step(&map, height_step(map.heights()))?;
    let mut rows = String::new();
    let periodic = truths(&map, &known, Mode::Pressure)?;
    let isolated = truths(&map, &known, Mode::Isolated)?;
    for (mode, truths) in
        [(Mode::Pressure, &periodic), (Mode::Gap, &periodic), (Mode::Isolated, &isolated)]
    {
        for (load, truth) in LOADS.into_iter().zip(truths) {
            for request in REQUESTS {
                let first = format!("{index},{},{:.2}", recipe.family.name(), recipe.cutoff);
                let _ =
                    writeln!(rows, "{first},{}", row(&map, &known, mode, load, truth, request)?);
            }
        }
    }
    Ok(rows)
}

/// Solutions on a much finer grid.
fn truths(map: &HeightMap, known: &Map, mode: Mode) -> Result<Vec<Solution>, Box<dyn Error>> {
    let window = if known.repeats { Window::None } else { Window::Hann };
    let gradient = PowerSpectrum::of(map, window)?.moments().0.rms_gradient();
    let shape = map.grid().shape().map(|n| FINER * n);
    let fine = if known.repeats && mode.boundary() == Boundary::Periodic {
        resample(map, shape, surface_stats::Edges::Periodic)?
    } else {
        resample_mirrored(map, shape)?
    };
    let modulus = ContactModulus::from_pascals(1.0)?;
    let mut tight = Solver::builder()
        .boundary(mode.boundary())
        .tolerance(1e-6)
        .maps(Maps::None)
        .threads(1)
        .build(fine.grid(), modulus)?;
    tight.take_surface(fine)?;
    let mut solve = |load: f64| tight.solve_again(Load::MeanPressure(load * gradient));
    Ok(LOADS.into_iter().map(&mut solve).collect::<Result<_, SolverError>>()?)
}

/// A request beside the truth.
fn row(
    map: &HeightMap,
    known: &Map,
    mode: Mode,
    load: f64,
    truth: &Solution,
    request: f64,
) -> Result<String, Box<dyn Error>> {
    let modulus = ContactModulus::from_pascals(1.0)?;
    let gap = truth.state.mean_gap.ok_or("no gap")?;
    let prescribed = match mode {
        Mode::Gap => Load::MeanGap(gap),
        _ => Load::MeanPressure(truth.state.mean_pressure),
    };
    let mut usual =
        Solver::builder().boundary(mode.boundary()).threads(1).build(map.grid(), modulus)?;
    let default = usual.solve(map, prescribed)?.diagnostics.transforms;
    let task = Task {
        map,
        known,
        modulus,
        loads: &[prescribed],
        boundary: mode.boundary(),
        request: Request::new(request)?,
        method: Method::Auto,
        certified: false,
        maps: Maps::None,
        section: None,
        threads: 1,
    };
    let mut found = Found(None);
    let outcome = run(&task, &mut found)?;
    let budget = found.0.ok_or("not solved")?;
    let d = &truth.diagnostics;
    let area = d.area_fraction_corrected;
    let relative =
        |half: Option<f64>, scale: f64| half.map_or(String::new(), |h| format!("{:.5}", h / scale));
    let (other, other_bar) = if mode == Mode::Gap {
        let (p, exact) = (budget.mean_pressure, truth.state.mean_pressure);
        (p.value / exact - 1.0, relative(p.comparison_half_width().ok(), exact))
    } else {
        let estimate = budget.mean_gap.ok_or("no gap")?;
        let rms = known.rms_height;
        ((estimate.value - gap) / rms, relative(estimate.comparison_half_width().ok(), rms))
    };
    Ok(format!(
        "{},{load},{area:.5e},{:.4},{request},{},{},{:.5},{other:.5},{other_bar},{},{},{:.4e},{:.4e},{}",
        mode.name(),
        0.3 * BOUNDARY_CORRECTION * d.contact_perimeter / area,
        u8::from(outcome.met),
        relative(outcome.half_width, 1.0),
        budget.area.value / area - 1.0,
        outcome.factor,
        outcome.given_up.len(),
        outcome.work,
        default * map.grid().len() as f64 * 8.0,
        outcome.unmet.as_ref().map_or("", kind),
    ))
}

/// A word for why a request is not met.
fn kind(unmet: &Unmet) -> &'static str {
    match unmet {
        Unmet::Map(why)
        | Unmet::Loads { why: Miss::Bar { here: Err(NoBar::Area(why)), .. }, .. } => match why {
            NoAreaInterval::Stepped { .. } => "stepped",
            NoAreaInterval::Unresolved { .. } => "unresolved",
            _ => "spots",
        },
        Unmet::Loads { .. } => "spots",
    }
}

/// Keeps the budget.
struct Found(Option<Budget>);

impl Sink for Found {
    fn begin(&mut self, _: &HeightMap) {}

    fn take(
        &mut self,
        _: usize,
        _: Result<Solution, SolverError>,
        budget: Option<Budget>,
    ) -> ControlFlow<()> {
        self.0 = budget;
        ControlFlow::Continue(())
    }
}
