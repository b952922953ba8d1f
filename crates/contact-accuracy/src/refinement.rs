//! Bars outside the gate, from solutions on a twice finer grid.

use crate::budget::{Budget, Map, NoAreaInterval, grid::Finer};
use crate::continuation::regrid;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Iteration, Load, Solver, SolverBuilder, SolverError};
use std::ops::ControlFlow;
use surface_stats::StatsError;

/// Most points times loads that are solved on twice finer grids: 16 loads of 2048 x 2048.
const MOST_REFINED: usize = 1 << 26;

/// A map on twice as many points along each side, ready to be solved.
#[derive(Debug)]
pub struct TwiceFiner {
    known: Map,
    grid: Grid,
    solver: Solver,
}

/// Why a map is not solved on a twice finer grid.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum NotRefined {
    /// Too few points to interpolate between, or too many to solve.
    #[error(
        "{ny} x {nx} points cannot be refined 2 times: it takes at least 4 x 4 points, and at most \
         {most} million refined ones; give a larger part of the surface, or a smaller one",
        ny = shape[0], nx = shape[1], most = MOST_REFINED >> 20
    )]
    Size {
        /// Points of the map.
        shape: [usize; 2],
    },
    /// The map cannot be interpolated.
    #[error(transparent)]
    Statistics(#[from] StatsError),
    /// The solver refuses the settings.
    #[error(transparent)]
    Solver(#[from] SolverError),
}

impl TwiceFiner {
    /// Whether a twice finer grid gives the area of this budget a bar: it has none for want of
    /// resolution.
    pub fn helps(budget: &Budget) -> bool {
        matches!(
            budget.area.grid,
            Err(NoAreaInterval::Unresolved { .. }
                | NoAreaInterval::Stepped { .. }
                | NoAreaInterval::SpotsTooSmall { .. })
        )
    }

    /// Whether a map on `grid` can be put on a twice finer one: at least 4 x 4 points, and not so
    /// many that there would be more than 64 million.
    pub fn is_possible(grid: Grid) -> bool {
        let [ny, nx] = grid.shape();
        ny.min(nx) >= 4 && fits(grid, 1)
    }

    /// Interpolates `map`, of which `known` tells the rest: by its waves if it is continued by
    /// itself, by its cosines if its edges do not match or nothing lies beyond them. `solver` is
    /// built for the boundary.
    ///
    /// # Errors
    /// [`NotRefined`].
    pub fn of(
        map: &HeightMap,
        known: &Map,
        boundary: Boundary,
        solver: SolverBuilder,
        modulus: ContactModulus,
    ) -> Result<Self, NotRefined> {
        let shape = map.grid().shape();
        if !Self::is_possible(map.grid()) {
            return Err(NotRefined::Size { shape });
        }
        let continued = known.repeats && boundary == Boundary::Periodic;
        let finer = regrid(map, shape.map(|n| 2 * n), continued)?;
        let grid = finer.grid();
        let mut solver = solver.boundary(boundary).build(grid, modulus)?;
        solver.take_surface(finer)?;
        Ok(Self { known: *known, grid, solver })
    }

    /// The grid.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Solves for a load, the next one from where this one ended.
    ///
    /// # Errors
    /// [`SolverError`].
    pub fn solve(&mut self, load: Load) -> Result<Finer, SolverError> {
        let mut watch = |_: &Iteration<'_>| ControlFlow::Continue(());
        let solution = self.solver.solve_again(load, &mut watch)?;
        Ok(Finer::of(&solution, &self.known, self.grid))
    }
}

/// Whether so many `loads` of a map on the grid `given` may be solved on a twice finer grid.
pub fn fits(given: Grid, loads: usize) -> bool {
    loads.saturating_mul(4).saturating_mul(given.len()) <= MOST_REFINED
}
