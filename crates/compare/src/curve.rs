//! The deterministic curve while it is solved.

use crate::EdgesName;
use crate::distribution::{Distributions, FieldDistributions};
use crate::first_contact::FirstContact;
use crate::pressure_maps::PressureMaps;
use crate::progress::{Progress, StudyError};
use crate::result::{DeterministicAnswer, DeterministicPoint};
use crate::sections::Sections;
use crate::spots::{Spots, spot_list};
use contact_accuracy::{Answered, Leaks, Map, Sink};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Iteration, Solution, SolverError};
use grid_fft::parallel::join;
use std::ops::ControlFlow;

/// Area fraction the headline is looked for at.
const TYPICAL_AREA: f64 = 0.02;

/// The deterministic curve while it grows; of the fields only that of the headline is kept, of the others
/// what touches, and the pressure in a byte a dot.
pub(crate) struct Curve {
    pub(crate) map: Map,
    /// Relative half widths of modulus and hardness.
    materials: [f64; 2],
    wanted: Option<f64>,
    edges: EdgesName,
    pub(crate) points: Vec<DeterministicPoint>,
    /// Index of the load of headline and maps.
    pub(crate) headline: usize,
    score: f64,
    /// Pressure field of the headline (Pa).
    pub(crate) pressure: Vec<f64>,
    /// The leak at each load; of that of the headline the map of the flux too.
    pub(crate) leaks: Vec<Option<Leaks>>,
    /// The contact of all loads so far.
    pub(crate) first: Option<FirstContact>,
    /// The pressure of all loads so far.
    pub(crate) pressures: Option<PressureMaps>,
    /// One row of all loads so far.
    pub(crate) sections: Option<Sections>,
    /// How pressure, gap and spots are distributed at each load, if the solver keeps gaps.
    pub(crate) distributions: Vec<Option<Distributions>>,
    /// Contact spots of the headline, if the solver keeps gaps.
    pub(crate) spots: Option<Spots>,
    /// The map on the grid solved on, if it is not the given one.
    pub(crate) solved: Option<HeightMap>,
    /// Seconds on every second point and on twice the points.
    pub(crate) beside_seconds: [f64; 2],
    left: Option<Left>,
}

impl Curve {
    pub(crate) fn new(
        map: Map,
        wanted: Option<f64>,
        edges: EdgesName,
        materials: [f64; 2],
    ) -> Self {
        Self {
            map,
            materials,
            wanted,
            edges,
            points: Vec::new(),
            headline: 0,
            score: f64::INFINITY,
            pressure: Vec::new(),
            leaks: Vec::new(),
            first: None,
            pressures: None,
            sections: None,
            distributions: Vec::new(),
            spots: None,
            solved: None,
            beside_seconds: [0.0; 2],
            left: None,
        }
    }

    /// A load. What the progress does not tell is left for [`settle`](Self::settle), which is to come before the next
    /// load.
    pub(crate) fn take(&mut self, mean_pressure: f64, result: Result<Answered, SolverError>) {
        let of_iterate = |best: Box<Solution>, how: &str| {
            let reached = best.diagnostics.residuals.preconditioned;
            let text = format!("{how}: relative rms pressure error about {reached:.1e}");
            (Some(DeterministicAnswer::of_iterate(&best, &self.map)), Some(*best), Some(text))
        };
        let mut leak = None;
        let (answer, mut solution, trouble) = match result {
            Ok(answered) => {
                let mut answered = answered.with_materials(self.materials);
                leak = answered.leak.take();
                let [coarser, finer] = answered.seconds;
                self.beside_seconds =
                    [self.beside_seconds[0] + coarser, self.beside_seconds[1] + finer];
                (Some(DeterministicAnswer::of(&answered)), Some(answered.solution), None)
            }
            Err(SolverError::NotConverged(best)) => of_iterate(best, "not converged"),
            Err(SolverError::Rounding(best)) => of_iterate(best, "stopped at rounding"),
            Err(error) => (None, None, Some(error.to_string())),
        };
        let index = self.points.len();
        let section = solution.as_mut().and_then(|s| s.section.take());
        self.sections = Sections::with(self.sections.take(), index, section);
        let found = solution.as_ref();
        let pressure = found.map_or(&[][..], |s| &s.pressure);
        let (first, maps) = (self.first.take(), self.pressures.take());
        let (first, maps) = join(
            || FirstContact::with(first, index, pressure),
            || found.and_then(|s| PressureMaps::with(maps, index, s.grid, pressure)),
        );
        (self.first, self.pressures) = (first, maps);
        let score = self.distance(mean_pressure, answer.as_ref());
        self.points.push(DeterministicPoint { mean_pressure, answer, trouble });
        if score < self.score {
            self.score = score;
            self.headline = index;
            (self.spots, self.pressure) = (None, Vec::new());
        }
        self.leaks.push(leak);
        let others = self.leaks.iter_mut().enumerate().filter(|(i, _)| *i != self.headline);
        others.filter_map(|(_, leak)| leak.as_mut()).for_each(Leaks::drop_maps);
        match solution {
            Some(solution) => self.left = Some(Left { index, solution }),
            None => self.distributions.push(None),
        }
    }

    /// The rest of the last load, each look at its fields on a thread of its own if one is free.
    pub(crate) fn settle(&mut self) {
        let Some(Left { index, solution }) = self.left.take() else { return };
        let Solution { pressure, gap, grid, .. } = &solution;
        let repeats = self.edges == EdgesName::Periodic;
        let is_kept = !gap.is_empty();
        let (list, fields) = join(
            || if is_kept { spot_list(pressure, *grid, repeats) } else { Vec::new() },
            || if is_kept { FieldDistributions::of(pressure, gap) } else { None },
        );
        self.distributions.push(fields.and_then(|fields| Distributions::with(fields, &list)));
        if self.headline == index {
            self.spots = Spots::of(&list);
            self.pressure = solution.pressure;
        }
    }

    /// What happened at a load.
    pub(crate) fn news(&self, index: usize) -> Progress<'_> {
        let DeterministicPoint { mean_pressure, answer, .. } = &self.points[index];
        let area_fraction = answer.as_ref().map(|a| a.area_fraction);
        let maps = self.pressures.as_ref();
        Progress::Solved { index, mean_pressure: *mean_pressure, area_fraction, maps }
    }

    /// How far a load is from the one wanted, or from the typical area; both as a ratio.
    fn distance(&self, mean_pressure: f64, answer: Option<&DeterministicAnswer>) -> f64 {
        match (self.wanted, answer) {
            (Some(wanted), _) => (mean_pressure / wanted).ln().abs(),
            (None, Some(a)) if a.touching_fraction > 0.0 => {
                let penalty = if a.converged { 0.0 } else { 50.0 };
                (a.touching_fraction / TYPICAL_AREA).ln().abs() + penalty
            }
            _ => 1e3,
        }
    }
}

/// What is left of a load to be looked at.
struct Left {
    index: usize,
    solution: Solution,
}

/// The solutions of a climb, put into the curve.
pub(crate) struct ToCurve<'a> {
    pub(crate) curve: &'a mut Curve,
    pub(crate) given: Grid,
    pub(crate) pressures: &'a [f64],
    pub(crate) tell: &'a mut (dyn FnMut(Progress<'_>) -> Result<(), StudyError> + Send),
}

impl Sink for ToCurve<'_> {
    fn begin(&mut self, map: &HeightMap, known: &Map) {
        let Curve { wanted, edges, materials, .. } = *self.curve;
        *self.curve = Curve::new(*known, wanted, edges, materials);
        self.curve.solved = (map.grid() != self.given).then(|| map.clone());
    }

    fn iterated(&mut self, index: usize, now: &Iteration<'_>) -> ControlFlow<()> {
        match (self.tell)(Progress::of_iteration(index, now)) {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    }

    fn take(&mut self, index: usize, result: Result<Answered, SolverError>) -> ControlFlow<()> {
        self.curve.take(self.pressures[index], result);
        self.curve.settle();
        match (self.tell)(self.curve.news(index)) {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    }
}
