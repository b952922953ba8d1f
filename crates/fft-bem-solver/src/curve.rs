//! Many loads on one surface.

use crate::{Iteration, Load, Observer, Solution, Solver, SolverError};
use contact_types::HeightMap;
use std::ops::ControlFlow;

impl Solver {
    /// Solves for each of `mean_pressures` (Pa), given in any order, and hands each result over
    /// as it comes, with its index in `mean_pressures`. Loads are visited in rising order. Each
    /// starts from the one before, scaled, and with [`Method::Chord`](crate::Method) from the last
    /// two, extrapolated; the answers are those of cold starts, to the tolerance. An error of one
    /// load does not keep the others from being solved. `Break` ends the curve.
    pub fn curve(
        &mut self,
        surface: &HeightMap,
        mean_pressures: &[f64],
        each: impl FnMut(usize, Result<Solution, SolverError>) -> ControlFlow<()>,
    ) {
        let mut observer = |_: &Iteration<'_>| ControlFlow::Continue(());
        self.curve_observed(surface, mean_pressures, &mut observer, each);
    }

    /// As [`curve`](Self::curve) while `observer` looks on: at every load its iterations are counted
    /// from 0 again. Where it breaks, that load is [`SolverError::Stopped`] and the curve goes on
    /// unless `each` ends it.
    pub fn curve_observed(
        &mut self,
        surface: &HeightMap,
        mean_pressures: &[f64],
        observer: &mut dyn Observer,
        mut each: impl FnMut(usize, Result<Solution, SolverError>) -> ControlFlow<()>,
    ) {
        let mut order: Vec<usize> = (0..mean_pressures.len()).collect();
        order.sort_by(|&i, &j| mean_pressures[i].total_cmp(&mean_pressures[j]));
        self.extrapolate(true);
        for index in order {
            let load = Load::MeanPressure(mean_pressures[index]);
            let result = self.solve_observed(surface, load, observer);
            if each(index, result).is_break() {
                break;
            }
        }
        self.extrapolate(false);
    }
}
