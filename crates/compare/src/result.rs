//! What a study finds, as plain data.

use crate::adhesion::Adhesion;
use crate::conducted::Conduction;
use crate::distribution::Distributions;
use crate::finding::Verdict;
use crate::materials::{MaterialUse, spreads};
use crate::needs::Inputs;
use crate::pressure_maps::{FirstContact, PressureMaps};
use crate::theory::{BuildError, Card};
use crate::{EdgesName, Origin, Settings, Spikes};
use contact_accuracy::{Answered, Budget, Leaks, Map, Numbers, Reached};
use contact_types::{ContactModel, ContactState, HeightMap, ModelError, SpectralMoments};
use fft_bem_solver::{Diagnostics, Solution, SolverError};
use serde::Serialize;
use surface_stats::SurfaceStatistics;

/// A finished study.
#[derive(Debug, Serialize)]
#[non_exhaustive]
pub struct Comparison {
    /// What was asked for.
    pub settings: Settings,
    /// The surfaces in the order given.
    pub surfaces: Vec<SurfaceComparison>,
    /// Surfaces that were given and have no study.
    pub refused: Vec<Refused>,
    /// Wall-clock time of all of it (s).
    pub seconds: f64,
}

/// A surface without a study.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refused {
    /// What it is called.
    pub name: String,
    /// Why it has none.
    pub reason: String,
}

/// One surface: its numbers, the deterministic curve, every model beside it.
#[derive(Debug, Serialize)]
#[non_exhaustive]
pub struct SurfaceComparison {
    /// What the report calls it.
    pub name: String,
    /// Where it came from.
    pub origin: Origin,
    /// The heights after form removal.
    pub surface: HeightMap,
    /// What the solver put beyond their edges.
    pub edges: EdgesName,
    /// Statistics of those heights.
    pub statistics: SurfaceStatistics,
    /// What the models were given.
    pub inputs: Inputs,
    /// The same by the spectrum.
    pub spectral: Spectral,
    /// Seconds spent on statistics and spectra, once per map.
    pub setup_seconds: f64,
    /// The deterministic solution at each load, by rising pressure; of bodies that yield, if a hardness
    /// was given.
    pub deterministic: Vec<DeterministicPoint>,
    /// The same of elastic bodies, beside those that yield; empty without a hardness.
    pub elastic: Vec<DeterministicPoint>,
    /// Single points far from their neighbours.
    pub spikes: Spikes,
    /// What the map says about the accuracy of answers on it.
    pub map: Map,
    /// Seconds spent on every second point, and on twice the points, for the uncertainties.
    pub beside_seconds: [f64; 2],
    /// The headline load on coarser grids; empty unless asked for, see
    /// [`Comparison::look_around`].
    pub coarser: Vec<Coarser>,
    /// Other choices in preparing the map, each with the area with it over that without, less 1, see
    /// [`Comparison::look_around`]; `None` unless asked for.
    pub choices: Option<Vec<(ChoiceKind, f64)>>,
    /// What the contact conducts, if resistivities or conductivities were given.
    pub conduction: Option<Conduction>,
    /// The leak at each load, at the headline with the map of its flux; nothing unless asked for.
    #[serde(skip)]
    pub leaks: Vec<Option<Leaks>>,
    /// Whether the bodies stick, if a work of adhesion was given.
    pub adhesion: Option<Adhesion>,
    /// The rung that was reached, if an accuracy or a fast answer was asked for.
    pub plan: Option<Reached>,
    /// The heights on the grid that was solved, if it is not the given one.
    pub solved: Option<HeightMap>,
    /// Index of the load of headline and maps.
    pub headline: usize,
    /// Nominal area that the loads press on (m²), if they are read as forces.
    pub load_area: Option<f64>,
    /// Pressure field at that load (Pa) on the grid solved; empty if there is no solution.
    pub pressure: Vec<f64>,
    /// The rest of that solution but for its gap.
    #[serde(skip)]
    pub(crate) solution: Option<Solution>,
    /// The contact of every load; `None` unless every load has a solution in which points only join.
    pub first_contact: Option<FirstContact>,
    /// The pressure of every load; `None` unless every load has a solution.
    pub pressure_maps: Option<PressureMaps>,
    /// One row of the grid solved at each load; `None` of a load without a solution.
    pub sections: Vec<Option<Section>>,
    /// How pressure, gap and spots are distributed at each load; `None` where nothing touches.
    pub distributions: Vec<Option<Distributions>>,
    /// Every model of the list.
    pub models: Vec<ModelComparison>,
}

/// What lies along one row of the map, signs and units as in [`Solution`].
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Section {
    /// The row, counted from 0.
    pub row: usize,
    /// Pressure (Pa), `nx` of them.
    pub pressure: Vec<f64>,
    /// Gap (m), `nx` of them.
    pub gap: Vec<f64>,
}

/// What the spectrum of a map says.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spectral {
    /// Moments.
    pub moments: SpectralMoments,
    /// Part of the rms gradient that forward differences see (-).
    pub resolved: f64,
    /// True if a Hann window was applied, because the map does not repeat.
    pub windowed: bool,
    /// Radial PSD for the figure, `[wavelength (m), C (m⁴)]`, long to short.
    pub psd: Vec<[f64; 2]>,
}

/// The deterministic solution at one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DeterministicPoint {
    /// Nominal pressure (Pa).
    pub mean_pressure: f64,
    /// The numbers, if the solver came to any.
    pub answer: Option<DeterministicAnswer>,
    /// Why not, or why not to tolerance.
    pub trouble: Option<String>,
}

/// Numbers of one deterministic solution.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DeterministicAnswer {
    /// Points that carry pressure over all points.
    pub touching_fraction: f64,
    /// Real over nominal area: that less what the contact line cuts.
    pub area_fraction: f64,
    /// Area, gap, real pressure and stiffness with their errors by source.
    pub budget: Budget,
    /// The same load on every second point.
    pub coarser: Vec<Numbers>,
    /// The same load on twice the points, where the answer depends on what lies between them.
    pub finer: Option<Numbers>,
    /// Mean gap (m).
    pub mean_gap: Option<f64>,
    /// Approach since first touch (m).
    pub approach: f64,
    /// How it was found, and what the field is like; its seconds are those of all grids.
    pub diagnostics: Diagnostics,
    /// True if the tolerance was reached.
    pub converged: bool,
}

impl DeterministicAnswer {
    /// Of a load on a map of which `map` tells, with its fields, or of the best iterate of one that missed its tolerance.
    /// Modulus and hardness are known as well as those of the `materials` that were used, which moves the uncertainty of an
    /// answer, not of an iterate. `None` of an error without an iterate.
    pub fn of(
        result: Result<Answered, SolverError>,
        materials: &[MaterialUse],
        map: &Map,
    ) -> Option<(Self, Solution)> {
        use SolverError::{NotConverged, Rounding, Stopped};
        let (solution, budget, coarser, finer, converged) = match result {
            Ok(answered) => {
                let found = answered.with_materials(spreads(materials));
                (found.solution, found.budget, found.coarser, found.finer, true)
            }
            Err(NotConverged(best) | Rounding(best) | Stopped(best)) => {
                let budget = Budget::of_iterate(&best, map);
                (*best, budget, Vec::new(), None, false)
            }
            Err(_) => return None,
        };
        let answer = Self {
            touching_fraction: solution.touching_fraction(),
            area_fraction: solution.state.area_fraction,
            budget,
            coarser,
            finer,
            mean_gap: solution.state.mean_gap,
            approach: solution.approach,
            diagnostics: solution.diagnostics.clone(),
            converged,
        };
        Some((answer, solution))
    }
}

/// A choice that was tried.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ChoiceKind {
    /// A paraboloid removed too.
    Paraboloid,
    /// Waves shorter than this (m), twice the shortest of the map, removed.
    Cutoff(f64),
    /// So many spikes removed.
    WithoutSpikes(usize),
    /// Mirror images at the edges instead of the same map again.
    Mirrored,
}

/// The map with points left out, solved from nothing, to the tolerance of the study.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Coarser {
    /// Point spacing over that of the map.
    pub factor: usize,
    /// Points `[ny, nx]`.
    pub shape: [usize; 2],
    /// Points that carry pressure over all points.
    pub touching_fraction: f64,
    /// Real over nominal area: that less what the contact line cuts.
    pub area_fraction: f64,
    /// Signed relative error of the corrected area against that of the map as given.
    #[serde(rename = "area_error")]
    pub error: f64,
    /// Wall-clock time of the solution (s).
    pub seconds: f64,
}

/// One model beside the deterministic curve.
#[derive(Debug, Serialize)]
#[non_exhaustive]
pub struct ModelComparison {
    /// What it is.
    pub card: Card,
    /// Its answers at the loads, or why it has none on this surface.
    pub outcome: Result<ModelCurve, BuildError>,
    /// Whether its theory covers this surface.
    pub verdict: Verdict,
}

/// A model's answers.
#[derive(Debug, Serialize)]
#[non_exhaustive]
pub struct ModelCurve {
    /// One answer per load.
    pub points: Vec<Result<ContactState, ModelError>>,
    /// Seconds that reading its inputs off the levelled map took, once for all loads; 0 of traces.
    pub preparation: f64,
    /// Seconds per load, the median of repeated runs.
    pub seconds: f64,
    /// Signed relative error of the area at each load, where both sides answer: against the solution for the
    /// bodies the theory is about, which are elastic or yield.
    pub errors: Vec<Option<f64>>,
    /// 95 % interval of the area at each load: over surfaces, of a theory that knows its own error
    /// ([`contact_types::ContactModel::area_interval`]); of profiles over traces like these, where the model is made of
    /// moments and the traces are long enough to tell.
    pub intervals: Vec<Option<[f64; 2]>>,
}

impl ModelCurve {
    /// Of answers at all loads, with what the theory knows of its own error.
    pub(crate) fn of(
        model: &dyn ContactModel,
        points: Vec<Result<ContactState, ModelError>>,
        seconds: f64,
    ) -> Self {
        let of = |point: &Result<ContactState, ModelError>| {
            model.area_interval(point.as_ref().ok()?.area_fraction)
        };
        let intervals = points.iter().map(of).collect();
        let errors = vec![None; points.len()];
        Self { points, preparation: 0.0, seconds, errors, intervals }
    }

    /// Signed relative error of largest size, and mean size, over the loads.
    pub fn worst_and_mean(&self) -> Option<(f64, f64)> {
        let present: Vec<f64> = self.errors.iter().flatten().copied().collect();
        let worst = present.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let mean = present.iter().map(|e| e.abs()).sum::<f64>() / present.len() as f64;
        Some((worst, mean))
    }

    /// Smallest and largest signed error.
    pub fn range(&self) -> Option<(f64, f64)> {
        let present = || self.errors.iter().flatten().copied();
        Some((present().min_by(f64::total_cmp)?, present().max_by(f64::total_cmp)?))
    }
}

impl SurfaceComparison {
    /// What the models were given, with the radial spectrum, which not every study asks for.
    pub(crate) fn inputs_with_spectrum(&self) -> Inputs {
        let own = || surface_stats::spectrum::radial(&self.surface).ok();
        Inputs { spectrum: self.inputs.spectrum.clone().or_else(own), ..self.inputs.clone() }
    }

    /// Nominal area that the loads press on (m²): the one given, or that of the map.
    pub fn nominal_area(&self) -> f64 {
        self.load_area.unwrap_or(self.surface.grid().area())
    }

    /// The deterministic answer at the headline load.
    pub fn headline_answer(&self) -> Option<&DeterministicAnswer> {
        self.deterministic.get(self.headline)?.answer.as_ref()
    }

    /// The heights on the grid of the deterministic solution.
    pub fn solved_map(&self) -> &HeightMap {
        self.solved.as_ref().unwrap_or(&self.surface)
    }

    /// Pressure of the headline (Pa).
    pub fn headline_pressure(&self) -> f64 {
        self.deterministic.get(self.headline).map_or(0.0, |p| p.mean_pressure)
    }
}
