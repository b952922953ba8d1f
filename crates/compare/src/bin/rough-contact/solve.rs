//! `rough-contact solve`: the deterministic solution.

use crate::args::{self, Bodies, Common, List};
use crate::input::{Complete, Input};
use crate::outcome::{Failure, Reply, variant};
use crate::output::Folder;
use crate::planned;
use crate::progress::Progress;
use crate::text::{self, Columns};
use clap::Args;
use compare::budget::{Budget, Map, Stiffness, grid};
use compare::plan::Request;
use compare::{LevelName, MethodName, PrecisionName};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{
    Boundary, Iteration, Load, Maps, NoAreaInterval, Precision, Solution, Solver, SolverError,
};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::PathBuf;

#[derive(Args)]
pub(crate) struct Solve {
    #[command(flatten)]
    bodies: Bodies,
    /// Mean pressures to solve for
    #[arg(long, value_name = "LIST", value_parser = args::pressures, allow_hyphen_values = true)]
    #[arg(required_unless_present = "gap", conflicts_with = "gap")]
    pressure: Option<List>,
    /// Mean gaps to solve for, instead of --pressure
    #[arg(long, value_name = "LIST", value_parser = args::lengths, allow_hyphen_values = true)]
    gap: Option<List>,
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = args::level(), default_value = "none")]
    level: LevelName,
    /// What lies beyond the edges: the same map again, or nothing
    #[arg(long, value_parser = ["periodic", "free"], default_value = "periodic")]
    boundary: String,
    /// How to solve
    #[arg(long, value_parser = args::method(), default_value = "auto")]
    method: MethodName,
    /// Floating-point type of the iteration; results are always f64
    #[arg(long, value_parser = args::precision(), default_value = "f64")]
    precision: PrecisionName,
    /// Relative rms error of the pressure to reach
    #[arg(long, value_name = "T", value_parser = args::number, allow_hyphen_values = true)]
    #[arg(default_value = "1e-4")]
    tolerance: f64,
    /// Error of the area to stay within, as 2%: grid, precision and tolerance are chosen for it
    #[arg(long, value_name = "A%", value_parser = Request::parse, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["tolerance", "precision", "gap"])]
    accuracy: Option<Request>,
    /// Prove how wrong each answer may be, for one more FFT pair: energy_bound in the JSON
    #[arg(long)]
    certify: bool,
    /// Contact stiffness too, -dp/d(mean gap), from two more solutions beside each load
    #[arg(long, conflicts_with = "accuracy")]
    stiffness: bool,
    /// Folder for pressure-000.npy and gap-000.npy of each load
    #[arg(long, value_name = "DIR")]
    maps: Option<PathBuf>,
    #[command(flatten)]
    input: Input,
}

/// Why a free boundary has no plan.
const FREE: &str = "--accuracy cannot be planned with --boundary free: the error of the area was \
                    studied for periodic maps only; give --tolerance, or solve with \
                    --boundary periodic";

/// A load that was solved for.
struct Point {
    json: Value,
    cells: Vec<String>,
}

impl Solve {
    pub(crate) fn run(&self, common: &Common) -> Result<Reply, Failure> {
        let modulus = self.bodies.required()?;
        let loads = self.loads()?;
        let free = self.boundary == "free";
        if free && self.accuracy.is_some() {
            return Err(Failure::refused("accuracy", FREE));
        }
        let maps = match &self.maps {
            None => None,
            Some(path) => Some(Folder::prepare(path, &map_names(loads.len()), common.force)?),
        };
        let Complete { map: surface, cleaned, height_step, .. } = self.input.surface()?;
        let surface = match self.level {
            LevelName::None => surface,
            form => surface_stats::level(&surface, args::form(form))
                .map_err(|e| Failure::in_file(&self.input.file, &e))?,
        };
        let mut work = Work {
            maps,
            trouble: None,
            method: self.method.to_string(),
            points: loads.iter().map(|_| None).collect(),
            grid: surface.grid(),
        };
        let mut progress = Progress::new(common.quiet, loads.len());
        if let Some(request) = self.accuracy {
            let asked = planned::Asked {
                surface: &surface,
                height_step,
                modulus,
                request,
                method: self.method,
                certified: self.certify,
                fields: self.maps.is_some(),
                threads: common.threads(),
            };
            let outcome = asked.solve(&loads, &mut work, &mut progress)?;
            drop(progress);
            let mut reply = self.reply(work, modulus.pascals());
            reply.text.insert_str(0, &text::cleaning(&cleaned));
            reply.json["cleaning"] = compare::report::cleaning_json(&cleaned);
            planned::state(&outcome, &mut reply);
            return Ok(reply);
        }
        let boundary = if free { Boundary::Free } else { Boundary::Periodic };
        let precision = match self.precision {
            PrecisionName::F64 => Precision::Double,
            PrecisionName::F32 => Precision::Single,
        };
        let mut solver = Solver::builder()
            .method(args::solver_method(self.method))
            .boundary(boundary)
            .precision(precision)
            .tolerance(self.tolerance)
            .threads(common.threads())
            .certified(self.certify)
            // The budget of errors looks at the pressure.
            .maps(if work.maps.is_some() { Maps::PressureAndGap } else { Maps::Pressure })
            .build(surface.grid(), modulus)
            .map_err(|e| Failure::from_error(&e))?;

        let map = Map::of(&surface).map_err(|e| Failure::in_file(&self.input.file, &e))?;
        // Only the stiffness needs the map again.
        let (kept, taken) = if self.stiffness {
            (Some(surface), Ok(()))
        } else {
            (None, solver.take_surface(surface))
        };
        let mut watch = |_: &Iteration<'_>| ControlFlow::Continue(());
        // Rising load, each solution the start of the next.
        for index in rising(&loads) {
            progress.working_on(&shown(loads[index]));
            let result = match (&kept, &taken) {
                (Some(surface), _) => solver.solve(surface, loads[index]),
                (None, Ok(())) => solver.solve_again(loads[index], &mut watch),
                (None, Err(error)) => Err(error.clone()),
            };
            let budget = Self::budget(&result, &mut solver, kept.as_ref(), &map);
            work.take(index, loads[index], &result, budget.as_ref());
            progress.step(&shown(loads[index]));
        }
        drop(progress);
        let mut reply = self.reply(work, modulus.pascals());
        reply.text.insert_str(0, &text::cleaning(&cleaned));
        reply.json["cleaning"] = compare::report::cleaning_json(&cleaned);
        Ok(reply)
    }

    /// The errors of a solution, with its stiffness if that was asked for.
    fn budget(
        result: &Result<Solution, SolverError>,
        solver: &mut Solver,
        surface: Option<&HeightMap>,
        map: &Map,
    ) -> Option<Budget> {
        let solution = match result {
            Ok(solution) => solution,
            Err(error) => {
                let none = Err(NoAreaInterval::NotConverged);
                return Some(Budget::of(error.solution()?, map).with_grid(none, 1.0));
            }
        };
        let budget = Budget::of(solution, map);
        let Some(surface) = surface else { return Some(budget) };
        // Loads beside one that was solved are no reason to fail: without them there is no number.
        let near = Stiffness::near(solver, surface, map, solution.state.mean_pressure);
        Some(match near {
            Ok(Some(found)) => budget.with_stiffness(&found, map, grid::line_share(solution)),
            _ => budget,
        })
    }

    /// The loads in the order given; zero and negative ones are refused before any work.
    fn loads(&self) -> Result<Vec<Load>, Failure> {
        if let Some(List(pressures)) = &self.pressure {
            for &p in pressures {
                positive("mean pressure", p, "Pa", "at which something touches")?;
            }
            return Ok(pressures.iter().map(|&p| Load::MeanPressure(p)).collect());
        }
        let List(gaps) = self.gap.as_ref().expect("clap requires one of the two");
        for &g in gaps {
            positive("mean gap", g, "m", "or use --pressure for a closed gap")?;
        }
        Ok(gaps.iter().map(|&g| Load::MeanGap(g)).collect())
    }

    fn reply(&self, work: Work, modulus: f64) -> Reply {
        let mut headings = vec![
            "mean pressure",
            "area",
            "corrected",
            "±",
            "± sample",
            "mean gap",
            "real pressure",
            "highest",
            "FFT pairs",
            "residual",
            "time",
        ];
        if self.stiffness {
            headings.push("stiffness");
        }
        let mut columns = Columns::new(&headings);
        let mut points = Vec::new();
        for point in work.points.into_iter().flatten() {
            columns.row(point.cells);
            points.push(point.json);
        }
        let json = json!({
            "shape": work.grid.shape(),
            "pixel": work.grid.pixel(),
            "level": self.level.name(),
            "boundary": self.boundary,
            "method": work.method,
            "precision": self.precision.name(),
            "modulus": modulus,
            "tolerance": self.tolerance,
            "points": points,
        });
        Reply { text: columns.to_string(), json, trouble: work.trouble }
    }
}

/// What is collected while the loads are solved. Fields go to the map files and are dropped.
pub(crate) struct Work {
    maps: Option<Folder>,
    trouble: Option<Failure>,
    method: String,
    points: Vec<Option<Point>>,
    grid: Grid,
}

impl Work {
    /// Forgets what was taken: the loads are solved again, on `grid`.
    pub(crate) fn begin(&mut self, grid: Grid) {
        self.points.iter_mut().for_each(|point| *point = None);
        self.trouble = None;
        self.grid = grid;
    }

    /// A load by its place in the list, with the errors of its numbers.
    pub(crate) fn take(
        &mut self,
        index: usize,
        load: Load,
        result: &Result<Solution, SolverError>,
        budget: Option<&Budget>,
    ) {
        let (solution, error) = match result {
            Ok(solution) => (Some(solution), None),
            Err(error) => (error.solution(), Some(error)),
        };
        self.points[index] = Some(point(load, solution.zip(budget), error));
        if let Some(error) = error {
            let message = format!("{}: {error}", shown(load));
            self.report(match error {
                SolverError::NotConverged(_) => Failure::incomplete("not_converged", message),
                _ => Failure::refused(&variant(error), message),
            });
        }
        let Some(solution) = solution else { return };
        self.method = solution.diagnostics.method.to_string();
        if let Some(Err(failure)) = self.maps.as_ref().map(|maps| self.write(maps, index, solution))
        {
            self.report(failure);
        }
    }

    fn report(&mut self, failure: Failure) {
        self.trouble = Some(match self.trouble.take() {
            None => failure,
            Some(earlier) => earlier.and(failure),
        });
    }

    fn write(&self, maps: &Folder, index: usize, solution: &Solution) -> Result<(), Failure> {
        for (name, field) in [("pressure", &solution.pressure), ("gap", &solution.gap)] {
            let name = map_name(name, index);
            maps.write(&name, |out| surface_io::write::npy_array(out, self.grid.shape(), field))?;
        }
        Ok(())
    }
}

fn map_name(field: &str, index: usize) -> String {
    format!("{field}-{index:03}.npy")
}

fn map_names(loads: usize) -> Vec<String> {
    (0..loads).flat_map(|i| [map_name("pressure", i), map_name("gap", i)]).collect()
}

fn positive(what: &str, value: f64, unit: &str, hint: &str) -> Result<(), Failure> {
    if value > 0.0 {
        return Ok(());
    }
    let message = format!("{what} {value} {unit} must be greater than 0; give a {what} {hint}");
    Err(Failure::refused("bad_load", message))
}

/// Indices from the lightest load to the heaviest.
pub(crate) fn rising(loads: &[Load]) -> Vec<usize> {
    let weight = |load: &Load| match *load {
        Load::MeanGap(gap) => -gap,
        Load::MeanPressure(load) | Load::Approach(load) => load,
        _ => 0.0,
    };
    let mut order: Vec<usize> = (0..loads.len()).collect();
    order.sort_by(|&i, &j| weight(&loads[i]).total_cmp(&weight(&loads[j])));
    order
}

pub(crate) fn shown(load: Load) -> String {
    match load {
        Load::MeanPressure(p) => text::pressure(p),
        Load::MeanGap(g) => format!("gap {}", text::length(g)),
        other => format!("{other:?}"),
    }
}

fn point(load: Load, found: Option<(&Solution, &Budget)>, error: Option<&SolverError>) -> Point {
    let error_json = error.map(|e| json!({ "kind": variant(e), "message": e.to_string() }));
    let Some((solution, budget)) = found else {
        let asked = if let Load::MeanPressure(p) = load { Some(p) } else { None };
        let mut json = json!({
                "mean_pressure": asked, "area_fraction": null, "area_fraction_corrected": null,
                "mean_gap": if let Load::MeanGap(g) = load { Some(g) } else { None },
                "approach": null, "max_pressure": null, "real_pressure": null,
                "converged": false, "iterations": null, "transforms": null, "seconds": null,
                "residuals": null, "duality_gap": null, "error": error_json,
        });
        with_keys(&mut json, None);
        return Point { json, cells: vec![shown(load), "refused".to_owned()] };
    };
    let (state, d) = (&solution.state, &solution.diagnostics);
    let real = state.real_pressure();
    let mut json = json!({
        "mean_pressure": state.mean_pressure,
        "area_fraction": state.area_fraction,
        "area_fraction_corrected": d.area_fraction_corrected,
        "mean_gap": state.mean_gap,
        "approach": solution.approach,
        "max_pressure": d.max_pressure,
        "real_pressure": real,
        "converged": error.is_none(),
        "iterations": d.iterations,
        "transforms": d.transforms,
        "seconds": d.seconds,
        "residuals": {
            "preconditioned": d.residuals.preconditioned,
            "complementarity": d.residuals.complementarity,
            "penetration": d.residuals.penetration,
        },
        "duality_gap": d.duality_gap,
        "energy_bound": d.energy_bound,
        "contact_pixels": d.contact_pixels,
        "contact_perimeter": d.contact_perimeter,
        "exact": d.exact,
        "error": error_json,
    });
    with_keys(&mut json, Some(budget));
    let real = budget.real_pressure();
    let mut cells = vec![
        text::pressure(state.mean_pressure),
        text::percent(state.area_fraction),
        text::percent(d.area_fraction_corrected),
        text::relative(budget.area.comparison_half_width().ok(), budget.area.value),
        text::relative(budget.area.prediction_half_width(), budget.area.value),
        state.mean_gap.map_or_else(|| "–".to_owned(), text::length),
        real.map_or_else(|| "–".to_owned(), |r| text::pressure(r.value())),
        text::pressure(d.max_pressure),
        text::number(d.transforms),
        format!("{:.1e}", d.residuals.preconditioned),
        text::seconds(d.seconds),
    ];
    cells.extend(budget.stiffness.map(|k| text::stiffness(k.value)));
    Point { json, cells }
}

/// Adds the keys of the budget, all `null` without one.
fn with_keys(point: &mut Value, budget: Option<&Budget>) {
    if let Value::Object(keys) = point {
        keys.extend(compare::report::budget_keys(budget));
    }
}
