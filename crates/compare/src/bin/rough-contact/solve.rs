//! `rough-contact solve`: the deterministic solution.

use crate::args::{self, Bodies, Common, List};
use crate::input::{Complete, Input};
use crate::intervals::{Errors, Finest, Intervals, Refined, under};
use crate::outcome::{Failure, Reply, variant};
use crate::output::Folder;
use crate::planned;
use crate::progress::Progress;
use crate::text::{self, Columns};
use clap::Args;
use compare::budget::{Between, Budget, Given, Map, NoAreaInterval, Stiffness, grid};
use compare::plan::Request;
use compare::{
    EdgesName, LevelName, MethodName, NotRefined, PrecisionName, Surrounded, TwiceFiner, on_given,
};
use contact_types::Grid;
use fft_bem_solver::{Boundary, Load, Maps, Solution, Solver, SolverError};
use serde_json::{Value, json};
use std::borrow::Cow;
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
    /// Beyond the edges of a periodic map: the map again, or its mirror images (four times the
    /// points, memory and time), which take the jump out of a map that does not repeat
    #[arg(long, value_name = "EDGES", value_parser = args::edges(), default_value = "periodic")]
    edges: EdgesName,
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
    #[arg(conflicts_with_all = ["tolerance", "precision", "refine"])]
    accuracy: Option<Request>,
    /// Solve loads that have no error interval once more on a twice finer grid, which gives one:
    /// four times the points, about five times the time
    #[arg(long)]
    refine: bool,
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

/// Most points of a map that is solved on a twice finer grid without being asked: 1024 x 1024.
const MOST_UNASKED: usize = 1 << 20;

/// Why an isolated contact is not solved for its gap.
const FREE_GAP: &str = "--gap cannot be prescribed with --boundary free: the mean gap of an isolated \
                        contact depends on where one stops looking; give --pressure, or solve with \
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
        let boundary = match self.boundary.as_str() {
            "free" if self.gap.is_some() => return Err(Failure::refused("combination", FREE_GAP)),
            "free" => Boundary::Free,
            _ => Boundary::Periodic,
        };
        args::refuse_mirrored(self.edges, self.accuracy.is_some(), self.boundary == "free")?;
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
            intervals: Intervals::default(),
            grid: surface.grid(),
        };
        let known = Map::with_step(&surface, height_step)
            .map_err(|e| Failure::in_file(&self.input.file, &e))?;
        let given = surface.grid();
        let part = (self.edges == EdgesName::Mirrored).then(|| surface.clone());
        let surface = Surrounded::new(Cow::Owned(surface), self.edges)
            .map_err(|e| Failure::in_file(&self.input.file, &e))?
            .into_map();
        let can_be_refined = TwiceFiner::is_possible(surface.grid());
        let mut progress = Progress::new(common.quiet, loads.len());
        if let Some(request) = self.accuracy {
            let asked = planned::Asked {
                surface: &surface,
                known: &known,
                boundary,
                modulus,
                request,
                method: self.method,
                certified: self.certify,
                fields: self.maps.is_some(),
                threads: common.threads(),
            };
            let outcome = asked.solve(&loads, &mut work, &mut progress)?;
            drop(progress);
            let refinable = work.intervals.refinable.is_some() && can_be_refined;
            let mut reply = self.reply(work, modulus.pascals(), "");
            reply.text.insert_str(0, &text::cleaning(&cleaned));
            reply.json["cleaning"] = compare::report::cleaning_json(&cleaned);
            planned::state(&outcome, refinable, &mut reply);
            return Ok(reply);
        }
        let builder = Solver::builder()
            .method(self.method.into())
            .boundary(boundary)
            .precision(self.precision.into())
            .tolerance(self.tolerance)
            .threads(common.threads());
        let mut solver = builder
            .clone()
            .certified(self.certify)
            // The budget of errors looks at the pressure.
            .maps(if work.maps.is_some() { Maps::PressureAndGap } else { Maps::Pressure })
            .build(surface.grid(), modulus)
            .map_err(|e| Failure::from_error(&e))?;
        let finer = Finest { builder: builder.maps(Maps::None), boundary, modulus, made: None };
        // What lies between the points is looked at where each load touches.
        let mut errors = Errors { known, whole: surface, part, finer };
        // Rising load, each solution the start of the next.
        for index in rising(&loads) {
            let load = loads[index];
            progress.working_on(&shown(load));
            let result = on_given(solver.solve(&errors.whole, load), given);
            let (budget, refined) = self.budget(load, &result, &mut solver, &mut errors);
            work.take(index, load, &result, budget.as_ref(), refined);
            progress.step(&shown(load));
        }
        drop(progress);
        let notes = work.intervals.notes(!self.refine && can_be_refined);
        let mut reply = self.reply(work, modulus.pascals(), &notes);
        reply.text.insert_str(0, &text::cleaning(&cleaned));
        reply.json["cleaning"] = compare::report::cleaning_json(&cleaned);
        Ok(reply)
    }

    /// The errors of a solution: with its stiffness, and with what a twice finer grid says of it, if
    /// those were asked for.
    fn budget(
        &self,
        load: Load,
        result: &Result<Solution, SolverError>,
        solver: &mut Solver,
        errors: &mut Errors,
    ) -> (Option<Budget>, Option<Result<Refined, NotRefined>>) {
        let solution = match result {
            Ok(solution) => solution,
            Err(error) => {
                let none = Err(NoAreaInterval::NotConverged);
                let budget =
                    error.solution().map(|s| Budget::of(s, &errors.known).with_grid(none, 0.0));
                return (budget, None);
            }
        };
        let mut budget = Budget::of(solution, &errors.known);
        let given = errors.part.as_ref().unwrap_or(&errors.whole);
        let repeats = errors.known.repeats && self.boundary != "free";
        let modulus = solver.modulus();
        if let Some(found) = Between::of(given, repeats, &solution.pressure, modulus) {
            budget = budget.between(&found);
        }
        let surface = &errors.whole;
        if self.stiffness {
            // Loads beside one that was solved are no reason to fail: without them there is no
            // number.
            let pressure = solution.state.mean_pressure;
            if let Ok(Some(near)) = Stiffness::near(solver, surface, &errors.known, pressure) {
                let line = grid::Line::of(solution);
                budget = budget.with_stiffness(&near, &errors.known, line);
            }
        }
        let budget = under(load, &budget, solution);
        // Where the points do not fix what touches, the answer itself may be wrong by factors: a
        // finer grid is solved unasked if it is no more than a few million points.
        let unasked = matches!(budget.area.grid, Err(NoAreaInterval::BetweenPoints { .. }))
            && surface.grid().len() <= MOST_UNASKED;
        if !((self.refine || unasked) && TwiceFiner::helps(&budget)) {
            return (Some(budget), None);
        }
        let refined = errors.finer.solve(load, surface, &errors.known, self.stiffness);
        let budget = refined.as_ref().map_or(budget, |r| budget.refined(&r.found));
        (Some(budget), Some(refined))
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

    fn reply(&self, work: Work, modulus: f64, notes: &str) -> Reply {
        let mut headings = vec!["mean pressure"];
        if self.gap.is_some() {
            headings.push("±"); // the load is an answer too
        }
        headings.extend([
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
        ]);
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
            "edges": self.edges.name(),
            "method": work.method,
            "precision": self.precision.name(),
            "modulus": modulus,
            "tolerance": self.tolerance,
            "points": points,
        });
        Reply { text: columns.to_string() + notes, json, trouble: work.trouble }
    }
}

/// What is collected while the loads are solved. Fields go to the map files and are dropped.
pub(crate) struct Work {
    maps: Option<Folder>,
    trouble: Option<Failure>,
    method: String,
    points: Vec<Option<Point>>,
    intervals: Intervals,
    grid: Grid,
}

impl Work {
    /// Forgets what was taken: the loads are solved again, on `grid`.
    pub(crate) fn begin(&mut self, grid: Grid) {
        self.points.iter_mut().for_each(|point| *point = None);
        self.trouble = None;
        self.intervals = Intervals::default();
        self.grid = grid;
    }

    /// A load by its place in the list, with the errors of its numbers.
    pub(crate) fn take(
        &mut self,
        index: usize,
        load: Load,
        result: &Result<Solution, SolverError>,
        budget: Option<&Budget>,
        refined: Option<Result<Refined, NotRefined>>,
    ) {
        let (solution, error) = match result {
            Ok(solution) => (Some(solution), None),
            Err(error) => (error.solution(), Some(error)),
        };
        let refined = match refined {
            Some(Err(why)) => {
                let message = format!("{}: {why}", shown(load));
                self.report(Failure::incomplete("not_refined", message));
                None
            }
            Some(Ok(refined)) => Some(refined),
            None => None,
        };
        let mut point = point(load, solution.zip(budget), error);
        point.json["refined"] = json!(refined.as_ref().map(Refined::json));
        self.points[index] = Some(point);
        if let (Ok(solution), Some(budget)) = (result, budget) {
            self.intervals.take(&shown(load), solution, budget, refined);
        }
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
    let mut cells = vec![text::pressure(state.mean_pressure)];
    if budget.given == Given::Gap {
        let load = budget.mean_pressure;
        cells.push(text::relative(load.comparison_half_width().ok(), load.value));
    }
    cells.extend([
        text::percent(state.area_fraction),
        text::percent(d.area_fraction_corrected),
        text::area_bar(budget.area.comparison_half_width().ok(), budget.area.value),
        text::area_bar(budget.area.prediction_half_width(), budget.area.value),
        state.mean_gap.map_or_else(|| "–".to_owned(), text::length),
        real.map_or_else(|| "–".to_owned(), |r| text::pressure(r.value())),
        text::pressure(d.max_pressure),
        text::number(d.transforms),
        format!("{:.1e}", d.residuals.preconditioned),
        text::seconds(d.seconds),
    ]);
    cells.extend(budget.stiffness.map(|k| text::stiffness(k.value)));
    Point { json, cells }
}

/// Adds the keys of the budget, all `null` without one.
fn with_keys(point: &mut Value, budget: Option<&Budget>) {
    if let Value::Object(keys) = point {
        keys.extend(compare::report::budget_keys(budget));
    }
}
