//! The deterministic solution of one map at many loads: what `rough-contact solve` answers.

use crate::failure::Failure;
use crate::hardness;
use crate::loads::{Spread, rising};
use crate::planned;
use crate::point::Point;
use crate::scene;
use crate::watch::Watch;
use crate::work::SolvedLoads;
use contact_accuracy::{Aim, Ladder, LadderError, Setup};
use contact_compare::{
    AccuracyRequest, Adhesion, Body, EdgesName, Finding, Hardness, Joint, LeakRequest, Level,
    MaterialUse, Method, PairOrigin, Precision, Reached, Solved, Spikes, WorkOfAdhesion,
};
use contact_types::{ContactModulus, HeightMap, Named};
use fft_bem_solver::{Boundary, Load, Maps, Solver, SolverError};
use serde_json::{Value, json};
use std::path::Path;
use surface_stats::StatsError;
use surface_stats::clean::Record;

/// Why a contact has no leak.
const NO_SEAL: &str = "a leak is that of a map which touches all over, from one edge to the other: a profile has no \
                       way around its contacts, and around an isolated contact everything is open; solve a map with a \
                       periodic boundary, or leave the leak out";

/// What is asked, and how it is to be solved.
#[derive(Clone, Debug)]
#[expect(clippy::struct_excessive_bools, reason = "one for each thing that may be asked for")]
pub struct SolveRequest {
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
    /// Uncertainty of the area to stay within: grid, precision and tolerance are then chosen for it.
    pub accuracy: Option<AccuracyRequest>,
    /// Every second point at once, with its wider uncertainty.
    pub fast: bool,
    /// Prove how wrong each answer may be.
    pub certify: bool,
    /// The contact stiffness too.
    pub stiffness: bool,
    /// Highest pressure that the softer body bears (Pa).
    pub hardness: Option<f64>,
    /// What the contact conducts.
    pub conduction: Joint,
    /// What leaks through the gap.
    pub leak: Option<LeakRequest>,
    /// Whether the bodies stick.
    pub adhesion: Option<WorkOfAdhesion>,
    /// Materials whose numbers are among these.
    pub materials: Vec<MaterialUse>,
    /// Distributions of pressure, gap and spots.
    pub distributions: bool,
    /// Whether the gap is kept too; the pressure always is.
    pub keep_gap: bool,
}

/// The map that is asked about, and where it comes from.
#[derive(Debug)]
pub struct SolveInput<'a> {
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
    /// The two bodies, if it is a pair.
    pub pair: Option<&'a PairOrigin>,
}

/// What was found.
#[derive(Debug)]
pub struct SolveResult {
    /// The object that scripts see.
    pub json: Value,
    /// What was taken off the map.
    pub level: Level,
    /// One for each load that was taken, in the order asked.
    pub points: Vec<Point>,
    /// What may change a conclusion, worst first.
    pub findings: Vec<Finding>,
    /// The rung that was reached, if an accuracy or a fast answer was asked for.
    pub plan: Option<Reached>,
    /// The hardness, if one was given.
    pub hardness: Option<Hardness>,
    /// What went wrong although there is an answer.
    pub trouble: Option<Failure>,
    /// True if who watched stopped it: loads are missing.
    pub is_stopped: bool,
}

impl SolveRequest {
    /// What of the resistance of the part is known; without an area of its own, that of the map is the part's (m²).
    fn joint(&self, map_area: f64) -> Joint {
        let given = self.conduction.area.or(self.spread.as_ref().map(|s| s.area));
        let area = Some(given.unwrap_or(map_area));
        Joint { area, hardness: self.hardness, ..self.conduction }
    }

    /// Solves the map for the loads, by rising load, each the start of the next, on the threads of the caller.
    ///
    /// # Errors
    /// [`Failure`], before any load is solved. A load that is not is in the [`SolveResult`].
    pub fn solve(
        &self,
        subject: SolveInput<'_>,
        watch: &mut dyn Watch,
    ) -> Result<SolveResult, Failure> {
        self.solve_on(subject, &mut None, watch)
    }

    /// The same from where the last call ended: `kept` is the ladder of a call of this question on the same grid,
    /// or none, and is that of this call afterwards. With an accuracy to be reached none is kept.
    ///
    /// # Errors
    /// As [`solve`](Self::solve); then none is kept.
    pub fn solve_on(
        &self,
        subject: SolveInput<'_>,
        kept: &mut Option<Ladder>,
        watch: &mut dyn Watch,
    ) -> Result<SolveResult, Failure> {
        if self.leak.is_some() && (self.plane_strain || self.boundary == Boundary::Free) {
            return Err(Failure::refused("leak", NO_SEAL));
        }
        let SolveInput { path, map: surface, missing, fill, cleaned, pair } = subject;
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
        self.conduction.check().map_err(|e| Failure::from_error(&e))?;
        let largest = surface.heights().iter().fold(0.0, |most: f64, h| most.max(h.abs()));
        // Before levelling, as they are removed.
        let spikes = Spikes::left(&surface, cleaned, pair);
        let level = self.level.on(&surface).map_err(refused)?;
        let surface = surface_stats::level(&surface, level).map_err(refused)?;
        solved.scene = scene::of(&surface, self.modulus, self.plane_strain).map_err(refused)?;
        solved.scene.spacing = largest * f64::EPSILON;
        if self.boundary == Boundary::Periodic {
            solved.scene.tilted = surface_stats::tilted(&surface, self.level).map_err(refused)?;
        }
        watch.levelled(&surface);
        let sticking = self.adhesion.map(|given| (given, surface.clone()));
        let mut work =
            SolvedLoads::new(self.loads.len(), self.method.to_string(), level, surface.grid());
        work.spikes = spikes;
        let repeats = self.boundary == Boundary::Periodic && self.edges == EdgesName::Periodic;
        work.leak = self.leak;
        work.distributions = self.distributions.then_some(repeats);
        solved.spikes = work.spikes.clone();
        let grid = surface.grid();
        // The indicator looks at the pressure.
        let gap_too = self.keep_gap || self.distributions;
        let builder = Solver::builder()
            .method(self.method)
            .precision(self.precision)
            .tolerance(self.tolerance)
            .hardness(self.hardness.unwrap_or(f64::INFINITY))
            .certified(self.certify)
            .maps(if gap_too { Maps::PressureAndGap } else { Maps::Pressure });
        let setup = Setup {
            boundary: self.boundary,
            mirrored: self.edges == EdgesName::Mirrored,
            jump: self.conduction.gas.map(|gas| gas.jump()),
            leak: self.leak.map_or_else(Vec::new, |leak| leak.along.axes().to_vec()),
            stiffness: self.stiffness || self.conduction.is_asked(),
            ..Setup::new(builder, self.modulus)
        };
        let joint = self.joint(grid.area());
        let part = setup.stiffness.then_some((&joint, self.modulus));
        let mut plan = None;
        let mut is_stopped = false;
        let materials = contact_compare::spreads(&self.materials);
        let aim = match (self.accuracy, self.fast) {
            (Some(request), _) => Some(Aim::Within(request)),
            (None, true) => Some(Aim::Fast),
            (None, false) => None,
        };
        if let Some(aim) = aim {
            let climbed = planned::PlannedSolve { surface: &surface, setup, aim, materials, part };
            plan = climbed.solve(&self.loads, &mut work, watch)?;
            is_stopped = plan.is_none();
        } else {
            let failed = |e: LadderError| Failure::from_error(&e);
            let mut ladder = match kept.take().filter(|ladder| ladder.map().grid() == grid) {
                Some(mut ladder) => {
                    ladder.take_map(surface).map_err(failed)?;
                    ladder
                }
                None => Ladder::new(surface, setup).map_err(failed)?,
            };
            for index in rising(&self.loads) {
                let load = self.loads[index];
                watch.working_on(load);
                let result = ladder.solve(load, |now| watch.iterated(index, load, now));
                let result = result.map(|found| found.with_materials(materials));
                if matches!(result, Err(SolverError::Stopped(_))) {
                    is_stopped = true;
                    break;
                }
                work.take(index, load, result, &ladder.known, part, watch);
                watch.done(load);
            }
            *kept = Some(ladder);
        }
        (solved.loads, solved.indicators) = (work.without_uncertainty(), work.indicators());
        solved.small = work.small();
        // With a hardness no pressure is beyond it: nothing is left to warn of.
        if self.hardness.is_none() {
            solved.scene.pressed = work.pressed();
        }
        solved.spike_share = work.spike_share;
        if let Some((given, map)) = &sticking {
            let contacts = work.contacts();
            let found = scene::adhesion(*given, map, self.modulus, &contacts).map_err(refused)?;
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
        Ok(SolveResult { json, level, points, findings, plan, hardness, trouble, is_stopped })
    }

    /// What scripts see, and the points that were taken.
    fn object(
        &self,
        work: SolvedLoads,
        findings: &[Finding],
        plan: Option<&Reached>,
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
            "bodies": contact_report::bodies_json(pair, &self.bodies),
            "pair": pair.map(contact_report::pair_json),
            "points": objects,
            "cleaning": contact_report::cleaning_json(cleaned),
            "findings": contact_report::findings_json(findings),
        });
        if let Some(hardness) = hardness {
            json["hardness"] = hardness::object(hardness);
        }
        if let Some(gas) = &self.conduction.gas {
            json["gas"] = contact_report::gas_json(gas);
        }
        if self.conduction.is_asked() {
            json["nominal_area"] = json!(self.joint(work.grid.area()).area);
        }
        if let Some(leak) = &self.leak {
            json["leak"] = contact_report::leak_json(leak, hardness.is_some());
        }
        if let Some(adhesion) = adhesion {
            json["adhesion"] = json!(adhesion);
        }
        if !self.materials.is_empty() {
            json["materials"] = contact_report::materials_json(&self.materials);
        }
        if let Some(plan) = plan {
            json["accuracy"] = contact_report::accuracy_json(plan);
        }
        (json, points)
    }
}
