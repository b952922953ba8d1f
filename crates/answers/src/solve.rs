//! The deterministic solution of one map at many loads: what `rough-contact solve` answers.

use crate::adhesion;
use crate::conduction::Conduction;
use crate::failure::Failure;
use crate::finer::{Errors, Finest, Refined, under};
use crate::hardness;
use crate::loads::{Spread, rising};
use crate::planned;
use crate::point::Point;
use crate::scene;
use crate::watch::Watch;
use crate::work::Work;
use compare::budget::{Between, Budget, Map, NoAreaInterval, Stiffness, grid};
use compare::plan::{Outcome, Request};
use compare::{
    Adhesion, Body, EdgesName, Finding, Hardness, Level, MaterialUse, Method, NotRefined,
    PairOrigin, Precision, Solved, Spikes, Surrounded, TwiceFiner, WorkOfAdhesion, on_given,
};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Boundary, Load, Maps, SetStiffness, Solution, Solver, SolverError};
use serde_json::{Value, json};
use std::borrow::Cow;
use std::path::Path;
use std::time::Instant;
use surface_stats::StatsError;
use surface_stats::clean::Record;

/// What is asked, and how it is to be solved.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "one for each thing that may be asked for")]
pub struct Question {
    /// Mean pressures or mean gaps, in the order of the answer.
    pub loads: Vec<Load>,
    /// Where the pressures come from, if forces were given.
    pub spread: Option<Spread>,
    /// Contact modulus E*.
    pub modulus: ContactModulus,
    /// The elastic bodies it is made of, if they are known.
    pub bodies: Vec<Body>,
    /// Form that is taken off first.
    pub level: Level,
    /// What lies beyond the edges.
    pub boundary: Boundary,
    /// Beyond the edges of a periodic map: the map again, or its mirror images.
    pub edges: EdgesName,
    /// The map is the cross-section of ridges.
    pub plane_strain: bool,
    /// How to solve.
    pub method: Method,
    /// Floating-point type of the iteration.
    pub precision: Precision,
    /// Relative rms error of the pressure to reach.
    pub tolerance: f64,
    /// Error of the area to stay within: grid, precision and tolerance are then chosen for it.
    pub accuracy: Option<Request>,
    /// Loads without an error interval are solved on a twice finer grid too.
    pub refine: bool,
    /// Prove how wrong each answer may be.
    pub certify: bool,
    /// The contact stiffness too.
    pub stiffness: bool,
    /// Highest pressure that the softer body bears (Pa).
    pub hardness: Option<f64>,
    /// What the contact conducts.
    pub conduction: Conduction,
    /// Whether the bodies stick.
    pub adhesion: Option<WorkOfAdhesion>,
    /// Materials whose numbers are among these.
    pub materials: Vec<MaterialUse>,
    /// Distributions of pressure, gap and spots.
    pub distributions: bool,
    /// Whether the gap is kept too; the pressure always is.
    pub keep_gap: bool,
    /// Threads of the solver.
    pub threads: usize,
}

/// The map that is asked about, and where it comes from.
#[derive(Debug)]
pub struct Subject<'a> {
    /// Name in front of what is refused.
    pub path: &'a Path,
    /// The heights before they are levelled.
    pub map: HeightMap,
    /// Points that were filled.
    pub missing: usize,
    /// The rule they were filled by.
    pub fill: &'a str,
    /// Steps of cleaning.
    pub cleaned: &'a [Record],
    /// Height step that is still in the heights (m).
    pub height_step: Option<f64>,
    /// The two bodies, if it is a pair.
    pub pair: Option<&'a PairOrigin>,
}

/// What was found.
#[derive(Debug)]
pub struct Answer {
    /// The object that scripts see.
    pub json: Value,
    /// What was taken off the map.
    pub level: Level,
    /// One for each load that was taken, in the order asked.
    pub points: Vec<Point>,
    /// What may change a conclusion, worst first.
    pub findings: Vec<Finding>,
    /// What was chosen for an accuracy, if one was asked for.
    pub plan: Option<Outcome>,
    /// The hardness, if one was given.
    pub hardness: Option<Hardness>,
    /// Whether a twice finer grid is possible.
    pub can_be_refined: bool,
    /// What went wrong although there is an answer.
    pub trouble: Option<Failure>,
    /// True if who watched stopped it: loads are missing.
    pub is_stopped: bool,
}

/// Most points of a map that is solved on a twice finer grid without being asked: 1024 x 1024.
const MOST_UNASKED: usize = 1 << 20;

impl Question {
    /// Solves the map for the loads, by rising load, each the start of the next.
    ///
    /// # Errors
    /// [`Failure`], before any load is solved. A load that is not is in the [`Answer`].
    pub fn solve(&self, subject: Subject<'_>, watch: &mut dyn Watch) -> Result<Answer, Failure> {
        self.solve_on(subject, &mut None, watch)
    }

    /// The same from where the last call ended: `kept` is the solver of a call of this question on the same grid,
    /// or none, and is that of this call afterwards. With an accuracy to be reached none is kept.
    ///
    /// # Errors
    /// As [`solve`](Self::solve); then no solver is kept.
    pub fn solve_on(
        &self,
        subject: Subject<'_>,
        kept: &mut Option<Solver>,
        watch: &mut dyn Watch,
    ) -> Result<Answer, Failure> {
        let Subject { path, map: surface, missing, fill, cleaned, height_step, pair } = subject;
        let refused = |e: StatsError| Failure::in_file(path, &e);
        let mut solved = Solved {
            // Of two bodies each says its own.
            missing: if pair.is_some() { 0 } else { missing },
            pair,
            points: surface.grid().len(),
            fill,
            cleaned,
            ..Solved::default()
        };
        let largest = surface.heights().iter().fold(0.0, |most: f64, h| most.max(h.abs()));
        // Before levelling, as they are removed.
        let spikes = Spikes::left(&surface, cleaned, pair);
        let level = self.level.on(&surface).map_err(refused)?;
        let surface = match level {
            Level::None => surface,
            form => surface_stats::level(&surface, form).map_err(refused)?,
        };
        solved.scene = scene::of(&surface, self.modulus, self.plane_strain).map_err(refused)?;
        solved.scene.spacing = largest * f64::EPSILON;
        watch.levelled(&surface);
        let sticking = self.adhesion.map(|given| (given, surface.clone()));
        let mut work = Work::new(self.loads.len(), self.method.to_string(), level, surface.grid());
        work.spikes = spikes;
        let repeats = self.boundary == Boundary::Periodic && self.edges == EdgesName::Periodic;
        work.distributions = self.distributions.then_some(repeats);
        solved.spikes = work.spikes.clone();
        let known = Map::with_step(&surface, height_step).map_err(refused)?;
        let given = surface.grid();
        let part = (self.edges == EdgesName::Mirrored).then(|| surface.clone());
        let surface = Surrounded::new(Cow::Owned(surface), self.edges).map_err(refused)?.into_map();
        let can_be_refined = TwiceFiner::is_possible(surface.grid());
        // The budget of errors looks at the pressure.
        let gap_too = self.keep_gap || self.distributions;
        let maps = if gap_too { Maps::PressureAndGap } else { Maps::Pressure };
        let mut plan = None;
        let mut is_stopped = false;
        if let Some(request) = self.accuracy {
            let asked = planned::Asked {
                surface: &surface,
                known: &known,
                boundary: self.boundary,
                modulus: self.modulus,
                request,
                method: self.method,
                certified: self.certify,
                maps,
                threads: self.threads,
            };
            plan = asked.solve(&self.loads, &mut work, watch)?;
            is_stopped = plan.is_none();
        } else {
            let builder = Solver::builder()
                .method(self.method)
                .boundary(self.boundary)
                .precision(self.precision)
                .tolerance(self.tolerance)
                .threads(self.threads)
                .hardness(self.hardness.unwrap_or(f64::INFINITY));
            let fresh = builder.clone().certified(self.certify).maps(maps);
            let known_grid = kept.take().filter(|solver| solver.grid() == surface.grid());
            let mut solver = match known_grid {
                Some(solver) => solver,
                None => fresh
                    .build(surface.grid(), self.modulus)
                    .map_err(|e| Failure::from_error(&e))?,
            };
            let builder = builder.maps(Maps::None);
            let (boundary, modulus) = (self.boundary, self.modulus);
            let finer = Finest { builder, boundary, modulus, made: None };
            // What lies between the points is looked at where each load touches.
            let mut errors = Errors { known, whole: surface, part, finer };
            // As a study does, so that both give the same digits.
            solver.follow_curve(self.loads.len());
            for index in rising(&self.loads) {
                let load = self.loads[index];
                watch.working_on(load);
                let result = solver
                    .solve_observed(&errors.whole, load, |now| watch.iterated(index, load, now));
                if matches!(result, Err(SolverError::Stopped(_))) {
                    is_stopped = true;
                    break;
                }
                let result = on_given(result, given);
                let is_asked = self.stiffness || self.conduction.is_asked();
                let clock = Instant::now();
                let set = (is_asked && result.is_ok()).then(|| solver.contact_stiffness());
                let set = set.transpose().map_err(|e| Failure::from_error(&e))?;
                let seconds = clock.elapsed().as_secs_f64();
                let set = set.as_ref().map(|set| (set, seconds));
                let (budget, refined) = self.budget(load, &result, set, &mut solver, &mut errors);
                let is_solved = result.is_ok();
                work.take(index, load, result, budget.as_ref(), refined, watch);
                let point = work.points[index].as_mut().filter(|_| is_solved);
                if let Some((point, (set, _))) = point.zip(set) {
                    let (modulus, area) = (self.modulus, given.area());
                    point.conducted = self.conduction.add(&mut point.json, set, modulus, area)?;
                }
                watch.done(load);
            }
            *kept = Some(solver);
        }
        solved.loads = work.found();
        // With a hardness no pressure is beyond it: nothing is left to warn of.
        if self.hardness.is_none() {
            solved.scene.pressed = work.pressed();
        }
        solved.spike_share = work.spike_share;
        if let Some((given, map)) = &sticking {
            let contacts = work.contacts();
            let found = adhesion::of_map(*given, map, self.modulus, &contacts).map_err(refused)?;
            solved.adhesion = Some(found);
        }
        solved.plan = plan.as_ref();
        let findings = solved.findings();
        let hardness = self.hardness.map(|pascals| Hardness {
            pascals,
            modulus: self.modulus.pascals(),
            gradient: solved.scene.gradient,
        });
        let trouble = work.trouble.take();
        let found = (hardness, solved.adhesion);
        let (json, points) = self.object(work, &findings, plan.as_ref(), found, (cleaned, pair));
        Ok(Answer {
            json,
            level,
            points,
            findings,
            plan,
            hardness,
            can_be_refined,
            trouble,
            is_stopped,
        })
    }

    /// The errors of a solution: with its stiffness, and with what a twice finer grid says of it, if
    /// those were asked for.
    fn budget(
        &self,
        load: Load,
        result: &Result<Solution, SolverError>,
        set: Option<(&SetStiffness, f64)>,
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
        let repeats = errors.known.repeats && self.boundary != Boundary::Free;
        let modulus = solver.modulus();
        if let Some(found) = Between::of(given, repeats, &solution.pressure, modulus) {
            budget = budget.between(&found);
        }
        let surface = &errors.whole;
        if let Some((set, seconds)) = set
            && let Some(found) = Stiffness::of(set, solution, seconds)
        {
            budget = budget.with_stiffness(&found, &errors.known, grid::Line::of(solution));
        }
        let budget = under(load, &budget, solution);
        // Where the points do not fix what touches, the answer itself may be wrong by factors, and on a
        // pattern of like cells the points along the contact lines come in together: a finer grid is
        // solved unasked if it is no more than a few million points.
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

    /// What scripts see, and the points that were taken.
    fn object(
        &self,
        work: Work,
        findings: &[Finding],
        plan: Option<&Outcome>,
        (hardness, adhesion): (Option<Hardness>, Option<Adhesion>),
        (cleaned, pair): (&[Record], Option<&PairOrigin>),
    ) -> (Value, Vec<Point>) {
        let (mut points, mut objects) = (Vec::new(), Vec::new());
        for mut point in work.points.into_iter().flatten() {
            let mut object = point.json.take();
            if let Some(spread) = &self.spread {
                point.force = object["mean_pressure"].as_f64().map(|p| spread.force(p));
                object["load"] = json!(point.force);
            }
            if hardness.is_some() {
                hardness::complete(&mut object);
            }
            objects.push(object);
            points.push(point);
        }
        let mut json = json!({
            "shape": work.grid.shape(),
            "pixel": work.grid.pixel(),
            "level": work.level.name(),
            "boundary": self.boundary.name(),
            "edges": self.edges.name(),
            "plane_strain": self.plane_strain,
            "method": work.method,
            "precision": plan.map_or(self.precision, |plan| plan.precision).name(),
            "modulus": self.modulus.pascals(),
            "tolerance": plan.map_or(self.tolerance, |plan| plan.tolerance),
            "load_area": self.spread.as_ref().map(|s| s.area),
            "bodies": report::bodies_json(pair, &self.bodies),
            "pair": pair.map(report::pair_json),
            "points": objects,
            "cleaning": report::cleaning_json(cleaned),
            "findings": report::findings_json(findings),
        });
        if let Some(hardness) = hardness {
            json["hardness"] = hardness::object(hardness);
        }
        if let Some(adhesion) = adhesion {
            json["adhesion"] = json!(adhesion);
        }
        if !self.materials.is_empty() {
            json["materials"] = report::materials_json(&self.materials);
        }
        if let Some(plan) = plan {
            json["accuracy"] = report::accuracy_json(plan);
        }
        (json, points)
    }
}
