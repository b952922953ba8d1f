//! What the solver puts beyond the edges of a map: the map again, or its mirror images.

use crate::EdgesName;
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

    /// What the solver gets, to be handed over to it.
    pub fn into_map(self) -> HeightMap {
        self.map.into_owned()
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

/// The part of an answer that belongs to the map on `given`, if that is a quarter of what was
/// solved; the answer itself otherwise. Fields are those of the map. Area, contact line, gap, load
/// and residuals are per pixel, means over the map and its images; the edges of the map are no
/// contact lines, for each pixel there faces its own image.
///
/// # Errors
/// The one given, its iterate cut likewise.
pub fn on_given(
    result: Result<Solution, SolverError>,
    given: Grid,
) -> Result<Solution, SolverError> {
    let quarter = |mut solution: Solution| {
        if solution.pressure.len() != 4 * given.len() {
            return solution;
        }
        solution.grid = given;
        let [ny, nx] = given.shape();
        for field in [&mut solution.pressure, &mut solution.gap] {
            if field.len() == 4 * given.len() {
                let rows = field.chunks_exact(2 * nx).take(ny);
                *field = rows.flat_map(|row| row[..nx].iter().copied()).collect();
            }
        }
        if let Some(section) = &mut solution.section {
            section.pressure.truncate(nx);
            section.gap.truncate(nx);
        }
        // Rounded: the images may differ by what the iteration left.
        solution.diagnostics.contact_pixels = (solution.diagnostics.contact_pixels + 2) / 4;
        solution
    };
    match result {
        Ok(solution) => Ok(quarter(solution)),
        Err(SolverError::NotConverged(best)) => {
            Err(SolverError::NotConverged(Box::new(quarter(*best))))
        }
        Err(SolverError::Rounding(best)) => Err(SolverError::Rounding(Box::new(quarter(*best)))),
        Err(SolverError::Stopped(last)) => Err(SolverError::Stopped(Box::new(quarter(*last)))),
        Err(error) => Err(error),
    }
}
