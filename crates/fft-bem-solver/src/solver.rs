//! The solver: settings checked once, transforms planned once, memory taken once.

use crate::builder::SolverBuilder;
use crate::engine::{AnyEngine, Engine};
use crate::observer::ObserverResult;
use crate::pool::Pool;
use crate::{
    Boundary, HalfSpace, Iteration, Load, Method, Precision, Real, SetStiffness, Solution,
    SolverError, memory, mixed_problem, problem,
};
use contact_types::{Clock, ContactModulus, Grid, HeightMap};

impl SolverBuilder {
    /// Checks the settings, plans the transforms and allocates: iterations allocate nothing.
    ///
    /// # Errors
    /// [`SolverError::BadSetting`] or [`SolverError::Range`] if a setting or the grid cannot be used,
    /// [`SolverError::Memory`] if the machine does not have the memory it would take.
    pub fn build(self, grid: Grid, modulus: ContactModulus) -> Result<Solver, SolverError> {
        let bad = |setting, value, limit| Err(SolverError::BadSetting { setting, value, limit });
        if !(self.tolerance > 0.0 && self.tolerance < 1.0) {
            return bad("tolerance", self.tolerance, "it must lie between 0 and 1");
        }
        if self.threads == Some(0) {
            return bad("threads", 0.0, "use at least 1 thread");
        }
        if !cfg!(feature = "parallel") && self.threads.is_some_and(|t| t > 1) {
            let threads = self.threads.unwrap_or(1) as f64;
            return bad("threads", threads, "enable the feature `parallel` or use 1 thread");
        }
        if (cfg!(test) || !cfg!(feature = "single")) && self.precision == Precision::Single {
            return bad("precision", 32.0, "enable the feature `single`, or use double");
        }
        if self.hardness.is_nan() || self.hardness <= 0.0 {
            return bad("hardness", self.hardness, "it must be a pressure above 0 Pa, or infinite");
        }
        if self.hardness.is_finite() && self.method != Method::Chord {
            return Err(SolverError::Combination {
                first: "a hardness",
                second: "a method other than chord",
                way_out: "choose the method chord, or solve for elastic bodies",
            });
        }
        let scaled = problem::scaled_grid(grid)?;
        memory::check(grid, memory::bytes(&self, grid))?;
        // Transforms are planned for the threads of the pool they are planned in.
        let pool = Pool::new(self.threads)?;
        let boundary = self.boundary;
        let engine = pool.run(|| {
            #[cfg(all(feature = "single", not(test)))]
            // unit tests take none: half the code of their build
            if self.precision == Precision::Single {
                return boxed::<f32>(self, modulus, scaled);
            }
            boxed::<f64>(self, modulus, scaled)
        })??;
        Ok(Solver { grid, boundary, modulus, engine, pool })
    }
}

fn boxed<T: Real>(
    settings: SolverBuilder,
    modulus: ContactModulus,
    scaled: Grid,
) -> Result<Box<dyn AnyEngine>, SolverError> {
    Ok(Box::new(Engine::<T>::new(settings, modulus, scaled)?))
}

/// Finds the contact of a rough surface with a flat, for one grid and modulus. Solving again on the same surface starts
/// from the last solution, which changes the answer only within the tolerance.
pub struct Solver {
    grid: Grid,
    boundary: Boundary,
    modulus: ContactModulus,
    engine: Box<dyn AnyEngine>,
    pool: Pool,
}

impl std::fmt::Debug for Solver {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Solver")
            .field("grid", &self.grid)
            .field("modulus", &self.modulus)
            .finish_non_exhaustive()
    }
}

impl Solver {
    /// Default settings, to be changed and built.
    pub fn builder() -> SolverBuilder {
        SolverBuilder::default()
    }

    /// Forgets the last solution: the next solve starts from nothing.
    pub fn forget(&mut self) {
        self.engine.forget();
    }

    /// Solves the contact under `load`.
    ///
    /// # Errors
    /// [`SolverError::Grid`] if the surface does not stand on the solver's grid,
    /// [`SolverError::BadLoad`] if the load is no number or cannot be carried, [`SolverError::NotConverged`] if the
    /// iterations ran out, [`SolverError::Rounding`] if rounding ended them; both with the last iterate.
    pub fn solve(&mut self, surface: &HeightMap, load: Load) -> Result<Solution, SolverError> {
        self.solve_observed(surface, load, |_| ())
    }

    /// Solves the contact under `load` while `observer` looks on: a closure that is called after each
    /// iteration and returns nothing, or `ControlFlow::Break(())` to stop.
    ///
    /// It is called on a thread of the solver. If it panics, so does this call, and the next solve starts from
    /// nothing.
    ///
    /// # Errors
    /// As [`solve`](Self::solve), and [`SolverError::Stopped`], with the iterate reached, if the
    /// observer breaks.
    pub fn solve_observed<A: ObserverResult>(
        &mut self,
        surface: &HeightMap,
        load: Load,
        observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Solution, SolverError> {
        self.take_surface(surface)?;
        self.solve_again(load, None, observer)
    }

    /// Takes a surface over, for [`solve_again`](Self::solve_again): the map is no longer needed.
    ///
    /// # Errors
    /// As [`solve`](Self::solve), of the surface.
    pub fn take_surface(&mut self, surface: &HeightMap) -> Result<(), SolverError> {
        let (expected, found) = (self.grid, surface.grid());
        if found != expected {
            return Err(SolverError::Grid { expected, found });
        }
        self.pool.run(|| self.engine.keep(surface))?
    }

    /// Solves the contact of the last surface, [taken](Self::take_surface) or solved, under another load while
    /// `observer` looks on. It begins at `start`, the pressure (Pa) of each pixel by its index, such as that of a coarser or finer
    /// grid there, for one FFT convolution; without it, where the last solution ended.
    ///
    /// # Errors
    /// As [`solve_observed`](Self::solve_observed); [`SolverError::NoSurface`] if there was none.
    pub fn solve_again<A: ObserverResult>(
        &mut self,
        load: Load,
        start: Option<&(dyn Fn(usize) -> f64 + Sync)>,
        mut observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Solution, SolverError> {
        let clock = Clock::now();
        let mut observe = |iteration: &Iteration<'_>| observer(iteration).flow();
        self.pool.run(|| {
            start.map_or(Ok(()), |pressure| self.engine.begin_at(pressure))?;
            self.engine.solve(load, &mut observe, clock)
        })?
    }

    /// Stiffness of the contact of these pixels, by their index, such as those of a solution that carry pressure: the
    /// [mixed problem](SetStiffness). About five FFT convolutions in double precision, and memory for four fields and six
    /// more of the pixels in contact.
    ///
    /// # Errors
    /// [`SolverError::Memory`] if the machine does not have the memory for it beside the solver.
    pub fn contact_stiffness(
        &self,
        touches: impl Fn(usize) -> bool + Send,
    ) -> Result<SetStiffness, SolverError> {
        let (grid, boundary) = (self.grid, self.boundary);
        self.pool.run(|| {
            let contact: Vec<bool> = (0..grid.len()).map(touches).collect();
            memory::check_set(grid, boundary, contact.iter().filter(|is_in| **is_in).count())?;
            let scaled = problem::scaled_grid(grid)?;
            let unit = self.modulus.pascals() / problem::fine_pixel(grid);
            let mut operator = HalfSpace::scaled(scaled, boundary);
            Ok(mixed_problem::solve(scaled, &mut operator, &contact, unit))
        })?
    }
}
