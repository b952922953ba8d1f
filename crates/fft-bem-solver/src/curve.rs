//! Many loads on one surface.

use crate::observer::Answer;
use crate::{Iteration, Load, Solution, Solver, SolverError};
use contact_types::HeightMap;
use std::ops::ControlFlow;

impl Solver {
    /// Solves for each of `mean_pressures` (Pa), given in any order, and returns the results in that
    /// order. Loads are visited in rising order. Each starts from the one before, scaled; the answers are
    /// those of cold starts, to the tolerance. An error of one load does not keep the others from being solved.
    ///
    /// All solutions are kept, with their [maps](crate::SolverBuilder::maps):
    /// [`curve_observed`](Self::curve_observed) hands them over one by one.
    pub fn curve(
        &mut self,
        surface: &HeightMap,
        mean_pressures: &[f64],
    ) -> Vec<Result<Solution, SolverError>> {
        let mut found: Vec<_> = mean_pressures.iter().map(|_| None).collect();
        self.curve_observed(
            surface,
            mean_pressures,
            |_| (),
            |index, result| {
                found[index] = Some(result);
                ControlFlow::Continue(())
            },
        );
        found.into_iter().flatten().collect()
    }

    /// As [`curve`](Self::curve), but hands each result over as it comes, with its index in
    /// `mean_pressures`, while `observer` looks on: at every load its iterations are counted
    /// from 0 again. Where it breaks, that load is [`SolverError::Stopped`] and the curve goes on
    /// unless `each` breaks, which ends it. The observer is called on a thread of the solver, `each` on that
    /// of the caller.
    pub fn curve_observed<A: Answer>(
        &mut self,
        surface: &HeightMap,
        mean_pressures: &[f64],
        mut observer: impl FnMut(&Iteration<'_>) -> A + Send,
        mut each: impl FnMut(usize, Result<Solution, SolverError>) -> ControlFlow<()>,
    ) {
        let mut order: Vec<usize> = (0..mean_pressures.len()).collect();
        order.sort_by(|&i, &j| mean_pressures[i].total_cmp(&mean_pressures[j]));
        for index in order {
            let load = Load::MeanPressure(mean_pressures[index]);
            let result = self.solve_observed(surface, load, &mut observer);
            if each(index, result).is_break() {
                break;
            }
        }
    }
}
