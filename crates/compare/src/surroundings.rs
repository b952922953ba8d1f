//! What the solver puts beyond the edges of a map: the map again, or its mirror images.

use crate::EdgesName;
use contact_accuracy::on_given;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Answer, Iteration, Load, Solution, Solver, SolverError};
use std::borrow::Cow;
use surface_stats::StatsError;
use surface_stats::clean::mirrored;

/// A map with its surroundings, as the solver gets it, which repeats it periodically.
///
/// Mirror images make a map that repeats without a jump, of four times the points: four times the
/// memory and time. By symmetry every quarter has the same answer but for what stopping the
/// iteration leaves; that of the given map is cut out. Its FFT pairs are those of all four.
#[derive(Debug, Clone)]
pub struct Surrounded<'a> {
    map: Cow<'a, HeightMap>,
    given: Grid,
}

impl<'a> Surrounded<'a> {
    /// The map as it is, or with its mirror images.
    ///
    /// # Errors
    /// [`StatsError::Surface`] if the mirror images make too many points.
    pub fn new(map: Cow<'a, HeightMap>, edges: EdgesName) -> Result<Self, StatsError> {
        let given = map.grid();
        Ok(match edges {
            EdgesName::Periodic => Self { map, given },
            EdgesName::Mirrored => Self { map: Cow::Owned(mirrored(&map)?), given },
        })
    }

    /// What the solver gets.
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// Solves, and cuts the answer of the given map out.
    ///
    /// # Errors
    /// [`SolverError`]; the iterate inside is that of the given map too.
    pub fn solve(&self, solver: &mut Solver, load: Load) -> Result<Solution, SolverError> {
        on_given(solver.solve(&self.map, load), self.given)
    }

    /// The same while `observer` looks on and may stop it.
    ///
    /// # Errors
    /// As [`solve`](Self::solve), and [`SolverError::Stopped`].
    pub fn solve_observed<A: Answer>(
        &self,
        solver: &mut Solver,
        load: Load,
        observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Solution, SolverError> {
        on_given(solver.solve_observed(&self.map, load, observer), self.given)
    }
}
