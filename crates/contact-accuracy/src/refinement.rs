//! Bars outside the gate, from solutions on a twice finer grid.

use crate::budget::grid::{Finer, Line, stiffness_half_width};
use crate::budget::{Between, Budget, Map, NoAreaInterval, Stiffness};
use crate::continuation::regrid;
use crate::monotone::twice_as_fine;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Solver, SolverBuilder, SolverError};
use surface_stats::StatsError;

/// Most points times loads that are solved on twice finer grids: 16 loads of 2048 x 2048.
const MOST_REFINED: usize = 1 << 26;

/// A map on twice as many points along each side, ready to be solved.
#[derive(Debug)]
pub struct TwiceFiner {
    known: Map,
    grid: Grid,
    solver: Solver,
    /// The given map, and how to solve it, for a second surface through its points.
    map: HeightMap,
    continued: bool,
    builder: SolverBuilder,
    modulus: ContactModulus,
    monotone: Option<Solver>,
    /// The map on the finer grid, once it is looked at.
    surface: Option<HeightMap>,
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
        // How often that bar holds was not counted where the contact yields.
        !budget.yields
            && matches!(
                budget.area.grid,
                Err(NoAreaInterval::Unresolved { .. }
                    | NoAreaInterval::Stepped { .. }
                    | NoAreaInterval::SpotsTooSmall { .. }
                    | NoAreaInterval::BetweenPoints { .. })
            )
    }

    /// Whether one is solved unasked where it can be: it [`helps`](Self::helps), or `map` is a pattern of
    /// like cells, whose own bar is not known to hold alone.
    pub fn is_wanted(budget: &Budget, map: &Map) -> bool {
        let cut = |half: f64| half > 0.0; // in full contact no pixel is
        let like_cells = map.is_regular() && !budget.yields;
        Self::helps(budget) || like_cells && budget.area.grid.is_ok_and(cut)
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
        let builder = solver.boundary(boundary);
        let mut solver = builder.clone().build(grid, modulus)?;
        solver.take_surface(finer)?;
        let (known, map) = (*known, map.clone());
        let (monotone, surface) = (None, None);
        Ok(Self { known, grid, solver, map, continued, builder, modulus, monotone, surface })
    }

    /// The grid.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Solves for a load, the next one from where this one ended: for all that `budget`, of the given
    /// grid, has without a bar of its own. With its stiffness that of the contact set there too;
    /// where what lies between the points decides, the monotone surface through them as well.
    ///
    /// # Errors
    /// [`NotRefined`].
    pub fn solve(&mut self, load: Load, budget: &Budget) -> Result<Finer, NotRefined> {
        let Self { known, grid, solver, map, continued, surface, modulus, .. } = self;
        let solution = solver.solve_again(load)?;
        let mut finer = Finer::of(&solution, known, *grid);
        if budget.stiffness.is_some() {
            let near = Stiffness::of_set(solver, &solution)?;
            if let Some(near) = near {
                let left = stiffness_half_width(&known.on(*grid), Line::of(&solution));
                finer.stiffness = Some([near.value, near.value * left]);
            }
        }
        if let Some(bend) = &budget.bend {
            finer = finer.at_contact(budget.few_spots(), bend);
        }
        if budget.doubted {
            let finer_map = match surface {
                Some(surface) => surface,
                none => none.insert(regrid(map, grid.shape(), *continued)?),
            };
            let between = Between::of(finer_map, *continued, &solution.pressure, *modulus);
            finer.doublings = between.map_or(0.0, |between| between.doublings());
            let other = self.monotone()?.solve_again(load)?;
            let area = other.diagnostics.area_fraction_corrected;
            finer.monotone = Some((area, other.state.mean_gap, other.state.mean_pressure));
        }
        Ok(finer)
    }

    /// The solver of the monotone surface, made for the first load that needs it.
    fn monotone(&mut self) -> Result<&mut Solver, NotRefined> {
        let Self { map, continued, builder, modulus, grid, monotone, .. } = self;
        if let Some(solver) = monotone {
            return Ok(solver);
        }
        let finer = twice_as_fine(map, *continued).map_err(StatsError::from)?;
        let mut solver = builder.clone().build(*grid, *modulus)?;
        solver.take_surface(finer)?;
        Ok(monotone.insert(solver))
    }
}

/// Whether so many `loads` of a map on the grid `given` may be solved on a twice finer grid.
pub fn fits(given: Grid, loads: usize) -> bool {
    loads.saturating_mul(4).saturating_mul(given.len()) <= MOST_REFINED
}
