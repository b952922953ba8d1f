//! Many loads on one surface.

use crate::{Load, Solution, Solver, SolverError};
use contact_types::HeightMap;

impl Solver {
    /// Solves for each of `mean_pressures` (Pa), given in any order, and returns the results in that
    /// order. Loads are visited in rising order. Each starts from the one before, scaled; the answers are
    /// those of cold starts, to the tolerance. An error of one load does not keep the others from being solved.
    ///
    /// All solutions are kept, with their [maps](crate::SolverBuilder::maps).
    pub fn curve(
        &mut self,
        surface: &HeightMap,
        mean_pressures: &[f64],
    ) -> Vec<Result<Solution, SolverError>> {
        let mut order: Vec<usize> = (0..mean_pressures.len()).collect();
        order.sort_by(|&i, &j| mean_pressures[i].total_cmp(&mean_pressures[j]));
        let mut found: Vec<_> = mean_pressures.iter().map(|_| None).collect();
        for index in order {
            let load = Load::MeanPressure(mean_pressures[index]);
            found[index] = Some(self.solve(surface, load));
        }
        found.into_iter().flatten().collect()
    }
}
