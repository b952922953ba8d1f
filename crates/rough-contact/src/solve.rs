//! `rough-contact solve`: the deterministic solution.

use crate::against::{self, Against};
use crate::args::{self, Bodies, Common};
use crate::batch::{self, PerFile};
use crate::conduction::Conduction;
use crate::fields::{Fields, Sink};
use crate::files::folder_name;
use crate::hardness;
use crate::input::{Complete, Input, Measured};
use crate::intervals::{Errors, Finest, Refined, under};
use crate::loads::{Loads, Spread, rising, shown};
use crate::outcome::{Failure, Reply};
use crate::planned;
use crate::profiles::Traces;
use crate::progress::Progress;
use crate::rows::{How, Shown};
use crate::scene;
use crate::text::{self, Columns};
use crate::work::{Point, Work};
use clap::Args;
use compare::Hardness;
use compare::budget::{Between, Budget, Map, NoAreaInterval, Stiffness, grid};
use compare::plan::Request;
use compare::{
    EdgesName, Level, Method, NotRefined, PairOrigin, Precision, Solved, Spikes, Surrounded,
    TwiceFiner, on_given,
};
use fft_bem_solver::{Boundary, Load, Maps, Solution, Solver, SolverError};
use serde_json::json;
use std::borrow::Cow;
use std::path::{Path, PathBuf};

#[derive(Args, Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "one for each flag of the command")]
pub(crate) struct Solve {
    #[command(flatten)]
    bodies: Bodies,
    #[command(flatten)]
    loads: Loads,
    /// Form to remove by least squares first
    #[arg(long, value_name = "FORM", value_parser = args::level(), default_value = args::LEVEL)]
    level: Level,
    /// What lies beyond the edges: the same map again, or nothing
    #[arg(long, value_parser = ["periodic", "free"], default_value = "periodic")]
    boundary: String,
    /// Beyond the edges of a periodic map: the map again, or its mirror images (four times the
    /// points, memory and time), which take the jump out of a map that does not repeat
    #[arg(long, value_name = "EDGES", value_parser = args::edges(), default_value = "periodic")]
    edges: EdgesName,
    /// How to solve
    #[arg(long, value_parser = args::method(), default_value = "auto")]
    method: Method,
    /// Floating-point type of the iteration; results are always f64
    #[arg(long, value_parser = args::precision(), default_value = "f64")]
    precision: Precision,
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
    /// Highest pressure that the softer body bears, as 2GPa: metals yield there, and the area grows
    #[arg(long, value_name = "H", value_parser = args::pressure, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["accuracy", "stiffness"])]
    hardness: Option<f64>,
    #[command(flatten)]
    conduction: Conduction,
    /// Take a profile for the cross-section of ridges that are infinitely long: plane strain
    #[arg(long)]
    plane_strain: bool,
    #[command(flatten)]
    fields: Fields,
    /// Distributions of pressure, gap and contact spots of each load: in the JSON
    #[arg(long)]
    distributions: bool,
    #[command(flatten)]
    against: Against,
    #[command(flatten)]
    input: Input,
}

/// Most points of a map that is solved on a twice finer grid without being asked: 1024 x 1024.
const MOST_UNASKED: usize = 1 << 20;

/// What a profile is taken for.
const PLANE_STRAIN: &str = "plane strain: the trace is the cross-section of parallel ridges that are \
infinitely long and repeat with its length; a surface that is rough in both directions touches \
differently. Mean pressure is load per length of ridge over the length of the trace. If the two ends \
of the trace differ in height, --edges mirrored takes the jump between them out.\n";

/// Why heights and displacements are not written on a chosen grid.
const CHOSEN_GRID: &str = "--fields heights and displacement are on the grid of the file, and --accuracy chooses \
                           a grid of its own; leave them out, or give --tolerance";

/// Why an isolated contact is not solved for its gap.
const FREE_GAP: &str = "--gap cannot be prescribed with --boundary free: the mean gap of an isolated \
                        contact depends on where one stops looking; give --pressure, or solve with \
                        --boundary periodic";

impl Solve {
    pub(crate) fn run(&self, common: &Common) -> Result<Reply, Failure> {
        batch::run(self, &self.input.files, common)
    }
}

impl PerFile for Solve {
    const NAME: &'static str = "solve";
    const SHOWN: &'static [Shown] = &[
        Shown { head: "points", at: &["/shape"], how: How::Shape },
        Shown { head: "against", at: &["/pair/second/name"], how: How::Word },
        Shown { head: "load", at: &["/points/*/load"], how: How::Force },
        Shown { head: "mean pressure", at: &["/points/*/mean_pressure"], how: How::Pressure },
        Shown {
            head: "area",
            at: &["/points/*/area_fraction_corrected", "/points/*/area_fraction"],
            how: How::Percent,
        },
        Shown { head: "mean gap", at: &["/points/*/mean_gap"], how: How::Length },
        Shown {
            head: "real pressure",
            at: &["/points/*/real_pressure_corrected"],
            how: How::Pressure,
        },
        Shown { head: "time", at: &["/points/*/seconds"], how: How::Seconds },
        Shown { head: "to check", at: &["/findings"], how: How::Checks },
    ];

    /// Maps of several files are kept apart in folders with the names of the files.
    fn on(&self, file: &Path) -> Self {
        let only = self.input.files.only().is_some();
        let apart = |maps: &PathBuf| if only { maps.clone() } else { maps.join(folder_name(file)) };
        let maps = self.fields.maps.as_ref().map(apart);
        let fields = self.fields.to(maps);
        Self { input: self.input.on(file), fields, ..self.clone() }
    }

    fn beside(&self) -> String {
        self.against.content()
    }

    fn is_complete(&self, file: &Path) -> bool {
        let loads = self.loads.count().unwrap_or(0);
        let names = self.fields.names(loads);
        let all = |maps: &PathBuf| names.iter().all(|name| maps.join(name).exists());
        self.on(file).fields.maps.as_ref().is_none_or(all)
    }

    fn answer(&self, common: &Common) -> Result<Reply, Failure> {
        let modulus = self.bodies.required()?;
        hardness::check(self.hardness)?;
        let count = self.loads.count()?;
        let boundary = match self.boundary.as_str() {
            "free" if self.loads.is_by_gap() => {
                return Err(Failure::refused("combination", FREE_GAP));
            }
            "free" => Boundary::Free,
            _ => Boundary::Periodic,
        };
        args::refuse_mirrored(self.edges, self.accuracy.is_some(), self.boundary == "free")?;
        let repeats = boundary == Boundary::Periodic && self.edges == EdgesName::Periodic;
        if self.accuracy.is_some() && self.fields.needs_heights() {
            return Err(Failure::refused("combination", CHOSEN_GRID));
        }
        let (complete, pair) = self.section()?;
        let mut maps = Sink::prepare(&self.fields, count, repeats, common.force)?;
        let Complete { map: surface, cleaned, height_step, missing, .. } = complete;
        let spread = self.loads.forces.spread([surface.grid().area()])?;
        let loads = self.loads.each(spread.as_ref());
        let mut solved = Solved {
            // Of two bodies each says its own.
            missing: if pair.is_some() { 0 } else { missing },
            pair: pair.as_ref(),
            points: surface.grid().len(),
            fill: self.input.reading.fill.name(),
            cleaned: &cleaned,
            ..Solved::default()
        };
        let largest = surface.heights().iter().fold(0.0, |most: f64, h| most.max(h.abs()));
        let spikes = Spikes::of(&surface); // before levelling, as they are removed
        let surface = match self.level {
            Level::None => surface,
            form => surface_stats::level(&surface, form)
                .map_err(|e| Failure::in_file(&self.input.file, &e))?,
        };
        solved.scene = scene::of(&surface, modulus, self.plane_strain)
            .map_err(|e| Failure::in_file(&self.input.file, &e))?;
        solved.scene.spacing = largest * f64::EPSILON;
        if let Some(maps) = maps.as_mut().filter(|_| self.fields.needs_heights()) {
            maps.surface = Some(surface.clone());
        }
        let mut work = Work::new(maps, loads.len(), self.method.to_string(), surface.grid());
        work.spikes = spikes;
        work.distributions = self.distributions.then_some(repeats);
        solved.spikes = work.spikes.clone();
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
                fields: self.fields.needs_gap() || self.distributions,
                threads: common.threads(),
            };
            let outcome = asked.solve(&loads, &mut work, &mut progress)?;
            drop(progress);
            let refinable = work.intervals.refinable.is_some() && can_be_refined;
            solved.loads = work.found();
            solved.scene.pressed = work.pressed();
            solved.spike_share = work.spike_share;
            solved.plan = Some(&outcome);
            let mut reply = self.reply(work, modulus.pascals(), "", &solved, spread.as_ref());
            planned::state(&outcome, refinable, &mut reply);
            return Ok(reply);
        }
        let builder = Solver::builder()
            .method(self.method)
            .boundary(boundary)
            .precision(self.precision)
            .tolerance(self.tolerance)
            .threads(common.threads())
            .hardness(self.hardness.unwrap_or(f64::INFINITY));
        let mut solver = builder
            .clone()
            .certified(self.certify)
            // The budget of errors looks at the pressure.
            .maps(if self.fields.needs_gap() || self.distributions {
                Maps::PressureAndGap
            } else {
                Maps::Pressure
            })
            .build(surface.grid(), modulus)
            .map_err(|e| Failure::from_error(&e))?;
        let finer = Finest { builder: builder.maps(Maps::None), boundary, modulus, made: None };
        // What lies between the points is looked at where each load touches.
        let mut errors = Errors { known, whole: surface, part, finer };
        // Rising load, each solution the start of the next.
        for index in rising(&loads) {
            let load = loads[index];
            progress.working_on(&shown(load));
            let result = solver.solve_observed(&errors.whole, load, |now| {
                progress.iterating(|| text::iterating(&shown(load), now.number, now.residual));
            });
            let result = on_given(result, given);
            let (budget, refined) = self.budget(load, &result, &mut solver, &mut errors);
            work.take(index, load, &result, budget.as_ref(), refined);
            if let Some(Point { json, cells }) =
                work.points[index].as_mut().filter(|_| result.is_ok())
            {
                self.conduction.add(json, cells, &mut solver, given.area())?;
            }
            progress.step(&shown(load));
        }
        drop(progress);
        let notes = work.intervals.notes(!self.refine && can_be_refined);
        solved.loads = work.found();
        // With a hardness no pressure is beyond it: nothing is left to warn of.
        if self.hardness.is_none() {
            solved.scene.pressed = work.pressed();
        }
        solved.spike_share = work.spike_share;
        Ok(self.reply(work, modulus.pascals(), &notes, &solved, spread.as_ref()))
    }
}

impl Solve {
    /// The map, or the one trace that is to be solved in plane strain.
    fn section(&self) -> Result<(Complete, Option<PairOrigin>), Failure> {
        if self.against.given()?.is_some() && !self.plane_strain {
            let pair = self.against.complete(&self.input.file, self.input.how(), self.level)?;
            return Ok((pair.0, Some(pair.1)));
        }
        self.alone().map(|complete| (complete, None))
    }

    fn alone(&self) -> Result<Complete, Failure> {
        let path = &self.input.file;
        let refused = |message: &str| {
            Err(Failure::refused("profile", format!("{}: {message}", path.display())))
        };
        match (self.input.measured()?, self.plane_strain) {
            (Measured::Surface(complete), false) => Ok(complete),
            (Measured::Surface(_), true) => refused(
                "this is a map, and --plane-strain is for a profile; leave it out, or cut out a row with \
                 --crop Y0,0,1,NX",
            ),
            (Measured::Profile(_), false) => refused(
                "this is a profile, and a surface has no deterministic answer from one line of it; give \
                 --plane-strain if it is the cross-section of long parallel ridges, or see `model` and \
                 `compare`, which take it for a line of an isotropic surface",
            ),
            (Measured::Profile(_), true) if self.against.given()?.is_some() => refused(
                "--against presses two maps on each other, and --plane-strain is for one profile; leave \
                 one of them out",
            ),
            (Measured::Profile(_), true) if self.loads.forces.given()?.is_some() => refused(
                "--load is a force on an area, and in plane strain a load is a force on a length of ridge; \
                 give --pressure",
            ),
            (Measured::Profile(_), true) if self.boundary == "free" => refused(
                "--boundary free is for a contact that ends in all directions; ridges in plane strain do \
                 not: leave it out",
            ),
            (Measured::Profile(_), true)
                if self.accuracy.is_some() || self.refine || self.stiffness =>
            {
                refused(
                    "--accuracy, --refine and --stiffness rest on studies of maps; give --tolerance with \
                     --plane-strain",
                )
            }
            (Measured::Profile(traces), true) => {
                let (map, traces) = traces.only(path)?;
                let Traces { missing, cleaned, height_step, format, .. } = traces;
                Ok(Complete { map, missing, cleaned, height_step, format })
            }
        }
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
                let why = |s: &Solution| Err(NoAreaInterval::of_end(s.diagnostics.end));
                let budget =
                    error.solution().map(|s| Budget::of(s, &errors.known).with_grid(why(s), 0.0));
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
        // Where the points do not fix what touches, the answer itself may be wrong by factors, and on a
        // pattern of like cells the points along the contact lines come in together: a finer grid is solved unasked if it is no more than a few million points.
        let decides = matches!(budget.area.grid, Err(NoAreaInterval::BetweenPoints { .. }))
            || errors.known.is_regular();
        let unasked = decides && surface.grid().len() <= MOST_UNASKED;
        if !((self.refine || unasked) && TwiceFiner::is_wanted(&budget, &errors.known)) {
            return (Some(budget), None);
        }
        let refined = errors.finer.solve(load, surface, &errors.known, &budget);
        let budget = refined.as_ref().map_or(budget, |r| budget.refined(&r.found));
        (Some(budget), Some(refined))
    }

    fn reply(
        &self,
        work: Work,
        modulus: f64,
        notes: &str,
        solved: &Solved<'_>,
        spread: Option<&Spread>,
    ) -> Reply {
        let findings = solved.findings();
        let mut headings = if spread.is_some() { vec!["load"] } else { Vec::new() };
        headings.push("mean pressure");
        if self.loads.is_by_gap() {
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
        let yields = self.hardness.map(|pascals| Hardness {
            pascals,
            modulus,
            gradient: solved.scene.gradient,
        });
        if yields.is_some() {
            headings.extend(hardness::HEADINGS);
        }
        headings.extend(self.conduction.headings());
        let mut columns = Columns::new(&headings);
        let mut points = Vec::new();
        for mut point in work.points.into_iter().flatten() {
            if let Some(spread) = spread {
                let force = point.json["mean_pressure"].as_f64().map(|p| spread.force(p));
                point.cells.insert(0, force.map_or_else(|| "–".to_owned(), text::force));
                point.json["load"] = json!(force);
            }
            if yields.is_some() {
                hardness::complete(&mut point.json);
            }
            columns.row(point.cells);
            points.push(point.json);
        }
        let mut json = json!({
            "shape": work.grid.shape(),
            "pixel": work.grid.pixel(),
            "level": self.level.name(),
            "boundary": self.boundary,
            "edges": self.edges.name(),
            "plane_strain": self.plane_strain,
            "method": work.method,
            "precision": self.precision.name(),
            "modulus": modulus,
            "tolerance": self.tolerance,
            "load_area": spread.map(|s| s.area),
            "bodies": report::bodies_json(solved.pair, &self.bodies.listed()),
            "pair": against::json(solved.pair),
            "points": points,
            "cleaning": report::cleaning_json(solved.cleaned),
            "findings": report::findings_json(&findings),
        });
        let mut notes = notes.to_owned();
        if let Some(yields) = yields {
            json["hardness"] = hardness::json(yields);
            let solved = json["points"].as_array().into_iter().flatten();
            let solved = solved.filter(|p| !p["area_fraction"].is_null());
            let highest = solved.filter_map(|p| p["mean_pressure"].as_f64()).fold(0.0, f64::max);
            notes += &hardness::lines(yields, highest);
        }
        let text =
            text::cleaning(solved.cleaned) + &text::findings(&findings) + &columns.to_string();
        let text = text + &spread.map_or_else(String::new, Spread::line);
        let text = text + &against::lines(solved.pair, Some((modulus, self.bodies.listed())));
        let text = text + &text::level(self.level) + self.conduction.line();
        let text = if self.plane_strain { text + PLANE_STRAIN } else { text };
        Reply { text: text + &notes, json, trouble: work.trouble }
    }
}
