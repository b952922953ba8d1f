//! One surface: the truth, and what every request made of it.

use crate::ensemble::Recipe;
use compare::plan::{Candidates, Request, Sink, Task, run};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{
    BOUNDARY_CORRECTION, Load, Maps, Method, NoAreaInterval, Solution, Solver, SolverError,
};
use std::error::Error;
use std::fmt::Write as _;
use std::ops::ControlFlow;
use surface_stats::clean::{resample, resample_mirrored};
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::{Boundary, height_step};

/// Columns of the table. Areas are corrected fractions; `work` is points × pairs × bytes of the
/// program's choice and of the default, the given grid in f64 to 1e-4.
pub(crate) const HEADER: &str = "surface,family,cutoff,load,truth,truth_bar,request,claimed,half_width,error,\
     factor,given_up,work,work_default,reason";

/// Mean pressure over E* h'_rms.
const LOADS: [f64; 3] = [0.003, 0.02, 0.1];
/// Relative half widths asked for.
const REQUESTS: [f64; 5] = [0.1, 0.05, 0.02, 0.01, 0.005];
/// Points per side of the truth over those of the map.
const FINER: usize = 8;

/// The rows of one surface.
pub(crate) fn surface(index: usize, recipe: &Recipe) -> Result<String, Box<dyn Error>> {
    let map = recipe.make()?;
    let modulus = ContactModulus::from_pascals(1.0)?;
    let step = height_step(map.heights());
    let repeats = Candidates::of(&map, step)?.repeats;
    let window = if repeats { Window::None } else { Window::Hann };
    let gradient = PowerSpectrum::of(&map, window)?.moments().0.rms_gradient();
    let shape = map.grid().shape().map(|n| FINER * n);
    let fine = if repeats {
        resample(&map, shape, Boundary::Periodic)?
    } else {
        resample_mirrored(&map, shape)?
    };
    let mut tight = Solver::builder().tolerance(1e-6).threads(1).build(fine.grid(), modulus)?;
    let mut usual = Solver::builder().threads(1).build(map.grid(), modulus)?;
    let mut rows = String::new();
    for load in LOADS {
        let pressure = load * gradient;
        let truth = tight.solve(&fine, Load::MeanPressure(pressure))?.diagnostics;
        let area = truth.area_fraction_corrected;
        let bar = 0.3 * BOUNDARY_CORRECTION * truth.contact_perimeter / area;
        usual.forget();
        let default = usual.solve(&map, Load::MeanPressure(pressure))?.diagnostics.transforms;
        for request in REQUESTS {
            let task = Task {
                map: &map,
                height_step: step,
                modulus,
                pressures: &[pressure],
                request: Request::new(request)?,
                method: Method::Auto,
                certified: false,
                maps: Maps::None,
                threads: 1,
            };
            let mut found = Area(f64::NAN);
            let outcome = run(&task, &mut found)?;
            // Writing to a String cannot fail.
            let _ = writeln!(
                rows,
                "{index},{},{:.2},{load},{area:.5e},{bar:.4},{request},{},{},{:.5},{},{},{:.4e},\
                 {:.4e},{}",
                recipe.family.name(),
                recipe.cutoff,
                u8::from(outcome.met),
                outcome.half_width.map_or(String::new(), |h| format!("{h:.5}")),
                found.0 / area - 1.0,
                outcome.factor,
                outcome.given_up.len(),
                outcome.work,
                default * map.grid().len() as f64 * 8.0,
                outcome.reason.as_deref().map_or("", kind),
            );
        }
    }
    Ok(rows)
}

/// A word for why a request is not met.
fn kind(reason: &str) -> &'static str {
    if reason.contains("height step") {
        "stepped"
    } else if reason.contains("no grid makes up") {
        "unresolved"
    } else {
        "spots"
    }
}

/// Keeps the area.
struct Area(f64);

impl Sink for Area {
    fn begin(&mut self, _: &HeightMap) {}

    fn take(
        &mut self,
        _: usize,
        result: Result<Solution, SolverError>,
        _: Result<[f64; 2], NoAreaInterval>,
    ) -> ControlFlow<()> {
        self.0 = result.map_or(f64::NAN, |s| s.diagnostics.area_fraction_corrected);
        ControlFlow::Continue(())
    }
}
