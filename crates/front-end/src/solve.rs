//! The deterministic solution of one map at many loads: what `rough-contact solve` answers.

use crate::complete::Subject;
use crate::failure::Failure;
use crate::loads::Spread;
use crate::shown::unusual_hardness;
use crate::statistics::with_spectrum;
use crate::study::unmet;
use crate::work::{Point, SolvedLoads, Watch};
use contact_accuracy::{Aim, Ladder, LadderError, Task, climb};
use contact_compare::{
    AccuracyRequest, Adhesion, Cleaning, EdgesName, Finding, Hardness, Inputs, Joint, Level,
    Origin, PairOrigin, Reached, Scene, Settings, Solved, Spikes, Surface,
};
use contact_types::{ContactModulus, HeightMap, Named, SpectralMoments};
use fft_bem_solver::{Boundary, Load, Maps};
use serde::Deserialize;
use serde_json::{Value, json};
use std::iter;
use surface_stats::clean::Record;
use surface_stats::profile::{self, Trace};
use surface_stats::{Edges, StatsError, Warning, moments, spectral_scales};

/// Why a contact has no leak.
const NO_SEAL: &str = "a leak is that of a map which touches all over, from one edge to the other: a profile has no \
                       way around its contacts, and around an isolated contact everything is open; solve a map with a \
                       periodic boundary, or leave the leak out";

const NO_PART: &str = "an isolated contact is the whole part: no area but that of its map carries a force or has a \
                       resistance; leave the area out, or solve with a periodic boundary";

const NO_PERIOD: &str =
    "the S- and L-filter cut the ends of a trace off, which is then no period; leave them out";

/// What is asked, and how it is to be solved.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(clippy::struct_excessive_bools, reason = "one for each thing that may be asked for")]
pub struct SolveRequest {
    /// Mean pressures or mean gaps, in the order of the answer.
    #[serde(skip)]
    pub loads: Vec<Load>,
    /// Where the pressures come from, if forces were given.
    #[serde(skip)]
    pub spread: Option<Spread>,
    /// As of a study, whose loads and models are not used.
    pub settings: Settings,
    /// What lies beyond the edges.
    pub boundary: Boundary,
    /// The map is the cross-section of ridges.
    #[serde(default)]
    pub plane_strain: bool,
    /// Prove how wrong each answer may be.
    #[serde(default)]
    pub certify: bool,
    /// The contact stiffness too.
    #[serde(default)]
    pub stiffness: bool,
    /// Distributions of pressure, gap and spots.
    #[serde(default)]
    pub distributions: bool,
    /// Whether the gap is kept too; the pressure always is.
    pub keep_gap: bool,
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
    /// What went wrong although there is an answer, an accuracy that is not met too.
    pub trouble: Option<Failure>,
}

impl SolveRequest {
    /// What of the resistance of the part is known; without an area of its own, that of the map is the part's (m²).
    fn joint(&self, map_area: f64) -> Joint {
        let joint = self.settings.joint();
        let given = joint.area.or(self.spread.as_ref().map(|s| s.area));
        Joint { area: Some(given.unwrap_or(map_area)), ..joint }
    }

    /// Solves the map for the loads, by rising load, each the start of the next, on the threads of the caller. `kept` is
    /// the ladder of a call of this question on the same grid, or none, and is that of this call afterwards. With an
    /// accuracy to be reached none is kept.
    ///
    /// # Errors
    /// [`Failure`], before any load is solved; then none is kept. A load that is not solved is in the [`SolveResult`].
    pub fn solve(
        &self,
        subject: Subject<'_>,
        kept: &mut Option<Ladder>,
        watch: &mut dyn Watch,
    ) -> Result<SolveResult, Failure> {
        let settings = &self.settings;
        if settings.leak.is_some() && (self.plane_strain || self.boundary == Boundary::Free) {
            return Err(Failure::refused("leak", NO_SEAL));
        }
        let is_part =
            settings.joint().area.is_some() || self.spread.as_ref().is_some_and(|s| !s.is_of_map);
        if is_part && self.boundary == Boundary::Free {
            return Err(Failure::refused("area", NO_PART));
        }
        let modulus =
            ContactModulus::from_pascals(settings.modulus).map_err(|e| Failure::from(&e))?;
        let Subject { path, surface: Surface { origin, heights, .. }, cleaned, fill } = subject;
        let is_cut = |c: &Cleaning| c.s_filter.or(c.l_filter).is_some();
        if self.plane_strain && matches!(&origin, Origin::File(file) if is_cut(&file.cleaning)) {
            return Err(Failure::refused("profile", format!("{}: {NO_PERIOD}", path.display())));
        }
        let (pair, asked) = (origin.pair(), origin.level(settings.level));
        let refused = |e: StatsError| Failure::in_file(path, &e);
        let mut solved = Solved {
            // Of two bodies each says its own.
            missing: if pair.is_some() { 0 } else { origin.missing() },
            pair,
            points: heights.grid().len(),
            fill,
            cleaned: &cleaned,
            ..Solved::default()
        };
        settings.joint().check().map_err(|e| Failure::from(&e))?;
        let largest = heights.heights().iter().fold(0.0, |most: f64, h| most.max(h.abs()));
        // Before levelling, as they are removed.
        let spikes = Spikes::left(&heights, &cleaned, pair);
        let (level, surface) = asked.taken_off(heights).map_err(refused)?;
        let (scene, moments) = scene(&surface, modulus, self.plane_strain).map_err(refused)?;
        solved.scene = Scene { spacing: largest * f64::EPSILON, ..scene };
        if self.boundary == Boundary::Periodic {
            solved.scene.warned.extend(surface_stats::tilted(&surface, asked).map_err(refused)?);
        }
        watch.levelled(&surface);
        let sticking = settings.adhesion.map(|given| {
            let ([cutoff, _], _) = spectral_scales(&surface, Edges::Open)?;
            Ok((given, with_spectrum(&surface, modulus, moments), cutoff))
        });
        let sticking = sticking.transpose().map_err(refused)?;
        let grid = surface.grid();
        solved.spikes = spikes.clone();
        // The indicator looks at the pressure.
        let gap_too = self.keep_gap || self.distributions;
        let maps = if gap_too { Maps::PressureAndGap } else { Maps::Pressure };
        let builder = settings.solver().boundary(self.boundary).certified(self.certify);
        let mut setup = settings.setup(builder.maps(maps), modulus);
        setup.stiffness |= self.stiffness;
        let conducts = settings.joint().is_asked();
        let part = conducts.then(|| (self.joint(grid.area()), modulus));
        let repeats = self.boundary == Boundary::Periodic && settings.edges == EdgesName::Periodic;
        let distributions = self.distributions.then_some(repeats);
        let asked = (&self.loads[..], settings);
        let mut work = SolvedLoads::new(asked, distributions, part, (grid, spikes), watch);
        let accuracy = settings.accuracy.map(AccuracyRequest::new).transpose();
        let accuracy = accuracy.map_err(|e| Failure::from(&e))?;
        let as_given = if settings.fast { Aim::Fast } else { Aim::AsGiven };
        let aim = accuracy.map_or(as_given, Aim::Within);
        let loads: Vec<Load> = work.order.iter().map(|&i| self.loads[i]).collect();
        let task = Task { map: surface, setup, loads: &loads, aim, kept };
        let plan = match climb(task, &mut work) {
            Err(LadderError::Stopped) => None,
            Err(e) => return Err(Failure::from(&e)),
            Ok(reached) => Some(reached).filter(|_| aim != Aim::AsGiven),
        };
        work.add_to(&mut solved);
        solved.adhesion = sticking
            .map(|(given, inputs, cutoff)| Adhesion::of(given, &inputs, cutoff, &work.contacts()));
        solved.plan = plan.as_ref();
        let findings = solved.findings();
        let (modulus, gradient) = (settings.modulus, solved.scene.gradient);
        let hardness = settings.hardness.map(|pascals| Hardness { pascals, modulus, gradient });
        let unmet = plan.as_ref().and_then(|plan| unmet("", plan));
        let trouble = work.trouble.take().into_iter().chain(unmet).reduce(Failure::and);
        let found = (hardness, solved.adhesion);
        let (mut json, points) =
            self.object(work, &findings, plan.as_ref(), found, (&cleaned, pair));
        json["level"] = json!(level.name());
        Ok(SolveResult { json, level, points, findings, plan, hardness, trouble })
    }

    /// What scripts see, and the points that were taken.
    fn object(
        &self,
        work: SolvedLoads<'_>,
        findings: &[Finding],
        plan: Option<&Reached>,
        (hardness, adhesion): (Option<Hardness>, Option<Adhesion>),
        (cleaned, pair): (&[Record], Option<&PairOrigin>),
    ) -> (Value, Vec<Point>) {
        let (mut points, mut objects) = (Vec::new(), Vec::new());
        for mut point in work.points.into_iter().flatten() {
            let mut object = point.json.take();
            if let Some(spread) = &self.spread {
                point.force = object["mean_pressure"].as_f64().map(|p| p * spread.area);
                object["load"] = json!(point.force);
            }
            // The keys of what has yielded, absent in a load that was refused.
            for key in ["saturated_fraction", "plastic_load_fraction", "elastic_area_fraction"] {
                if hardness.is_some() && object.get(key).is_none() {
                    object[key] = Value::Null;
                }
            }
            objects.push(object);
            points.push(point);
        }
        let settings = &self.settings;
        let mut json = json!({
            "shape": work.grid.shape(),
            "pixel": work.grid.pixel(),
            "boundary": self.boundary.name(),
            "edges": settings.edges.name(),
            "plane_strain": self.plane_strain,
            "method": work.method,
            "precision": plan.map_or(settings.precision, |plan| plan.precision).name(),
            "modulus": settings.modulus,
            "tolerance": plan.map_or(settings.tolerance, |plan| plan.tolerance),
            "load_area": self.spread.as_ref().map(|s| s.area),
            "bodies": contact_report::bodies_json(pair, &settings.bodies),
            "pair": pair.map(contact_report::pair_json),
            "points": objects,
            "cleaning": contact_report::cleaning_json(cleaned),
            "findings": contact_report::findings_json(findings),
        });
        if let Some(hardness) = hardness {
            json["hardness"] = json!({
                "pascals": hardness.pascals,
                "modulus_gradient_over_hardness": hardness.indices(None).modulus_gradient_over_hardness,
                "warning": unusual_hardness(hardness),
            });
        }
        if let Some(gas) = &settings.gas {
            json["gas"] = contact_report::gas_json(gas);
        }
        if settings.joint().is_asked() {
            json["nominal_area"] = json!(self.joint(work.grid.area()).area);
        }
        if let Some(leak) = &settings.leak {
            json["leak"] = contact_report::leak_json(leak, hardness.is_some());
        }
        if let Some(adhesion) = adhesion {
            json["adhesion"] = json!(adhesion);
        }
        if !settings.materials.is_empty() {
            json["materials"] = contact_report::materials_json(&settings.materials);
        }
        if let Some(plan) = plan {
            json["accuracy"] = contact_report::accuracy_json(plan);
        }
        (json, points)
    }
}

/// The scene of a map, or of the section of ridges.
fn scene(
    map: &HeightMap,
    modulus: ContactModulus,
    plane_strain: bool,
) -> Result<(Scene, SpectralMoments), StatsError> {
    let inputs = |moments| Inputs { moments: Some(moments), ..Inputs::new(modulus) };
    let of = |moments| Scene::of(&inputs(moments), iter::empty());
    if plane_strain {
        // Of ridges the slope of the section is the gradient.
        let trace = Trace::new(map.grid().pixel()[1], map.heights().to_vec())?;
        let moments = profile::moments(&trace);
        let gradient = Some(moments.m2.sqrt());
        return Ok((Scene { gradient, radius: None, ..of(moments) }, moments));
    }
    let (moments, mut warned) = moments(map, Edges::Open)?;
    warned.retain(|w| matches!(w, Warning::RowsJump { .. })); // no model is asked
    Ok((Scene { warned, ..of(moments) }, moments))
}
