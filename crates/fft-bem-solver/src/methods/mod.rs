//! The contract between the solver and a method.
//!
//! A method receives a [`Task`]: the scaled [`Problem`] (heights from -1 to 0, finer pixel side 1,
//! `K` with symbol `2/|q|`), what is prescribed, when to stop. It changes a [`State`], the pair
//! `pressure`, `displacement = K pressure` and the `level` of the rigid flat, and returns an
//! [`Outcome`]. The gap is `displacement - heights - level` and is never stored by the solver.
//!
//! - With [`Start::Cold`] the contents of the state mean nothing. With [`Start::Warm`] they are
//!   the solution for another load on the same surface, `displacement = K pressure` included:
//!   both may be scaled to the new load without a transform.
//! - On return, whatever the [`End`], `pressure >= 0`, its mean is the prescribed one (for
//!   [`Target::Pressure`]), `displacement` belongs to it, and `level` is the pressure-weighted mean
//!   of `displacement - heights`.
//! - Memory is allocated by the method's constructor; iterations allocate nothing.
//! - `watch` is called once per iteration and may end the run.
//! - `transforms` counts applications of `K` (or `K^-1`) at full size as 1; work on coarser grids
//!   in proportion `m log m / (n log n)`.
//! - A method that does not control the level itself (`controls_level`) is driven by
//!   [`control`](crate::control): a secant in the logarithm of the load.

#![allow(
    clippy::inline_always,
    clippy::needless_bitwise_bool,
    reason = "inner loops belong to each version of `vectorised!`, and have no branches"
)]

mod cheap_compliance;
mod chord;
mod cut_cells;
mod equal_cells;
mod extension;
mod extrapolation;
mod face_cg;
#[cfg(test)]
mod figures;
mod fitted_stencil;
mod free_chord;
mod level_control;
mod passes;
mod polonsky_keer;
#[cfg(test)]
mod safeguards;
mod spline;
mod stanley_kato;
mod stiffness;
mod sweep;
mod thin_pixels;
mod transfer;

use crate::problem::Problem;
use crate::{Boundary, FreeHalfSpace, HalfSpace, Method, Real, SolverError};
use contact_types::Grid;
use grid_fft::parallel::prelude::*;
pub(crate) use passes::Partial;
use std::ops::ControlFlow;

pub(crate) use chord::Chord;
pub(crate) use free_chord::FreeChord;
pub(crate) use polonsky_keer::PolonskyKeer;
pub(crate) use stanley_kato::StanleyKato;

/// From first pixel, factor, pressure and displacement, and a third field to sums over them.
pub(crate) trait Finish<T>: Fn(usize, T, [&mut [T]; 2], &mut [f32]) -> Partial {}

impl<T, F: Fn(usize, T, [&mut [T]; 2], &mut [f32]) -> Partial> Finish<T> for F {}

/// What is done with the fields around an application of `K`, in blocks of whole rows while they are
/// in cache. Each is given the first pixel of the block.
pub(crate) struct RowWork<'a, T> {
    /// Ends the pressure, before it is transformed; returns sums over it.
    pub(crate) prepare: &'a (dyn Fn(usize, &mut [T]) -> Partial + Sync),
    /// From these sums: by what the displacement is to be multiplied; `None` stops here.
    pub(crate) factor: &'a mut dyn FnMut(&[Partial]) -> Option<f64>,
    /// Sees that factor, pressure and displacement, and a third field once the displacement is there.
    pub(crate) finish: &'a (dyn Finish<T> + Sync),
    /// Pixels of a block, where the operator has none of its own.
    pub(crate) pixels: usize,
}

/// `u = K p` and, where it is diagonal, its inverse.
pub(crate) trait Compliance<T: Real>: Send {
    /// `displacement = K pressure`.
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]);
    /// As [`apply`](Self::apply), with `work` on the fields on the way, and a third field `gap` for it
    /// to write to. Returns the sums of `work.finish`, `None` where `work.factor` stopped; `partial`
    /// then holds what `work.prepare` found.
    fn apply_around(
        &mut self,
        pressure: &mut [T],
        displacement: &mut [T],
        gap: &mut [f32],
        work: RowWork<'_, T>,
        partial: &mut [Partial],
    ) -> Option<Partial> {
        let size = work.pixels;
        let blocks = pressure.par_chunks_mut(size).zip(partial.par_iter_mut()).enumerate();
        blocks.for_each(|(k, (p, partial))| *partial = (work.prepare)(k * size, p));
        let partial = &mut partial[..pressure.len().div_ceil(size)];
        let factor = T::of((work.factor)(partial)?);
        self.apply(pressure, displacement);
        pressure
            .par_chunks_mut(size)
            .zip(displacement.par_chunks_mut(size))
            .zip(gap.par_chunks_mut(size))
            .zip(partial.par_iter_mut())
            .enumerate()
            .for_each(|(k, (((p, u), gap), partial))| {
                for u in u.iter_mut() {
                    *u *= factor;
                }
                *partial = (work.finish)(k * size, factor, [p, u], gap);
            });
        Some(passes::total(partial))
    }
    /// Replaces `w` by `B w`, where `<w, B w> >= <w, K^-1 w>`; periodic: `B = K^-1` on fields of mean
    /// zero. False, and nothing done, if there is no such `B` that costs one pair.
    fn invert(&mut self, field: &mut [T]) -> bool;
    /// Which kind of half space this is.
    fn boundary(&self) -> Boundary;
}

impl<T: Real> Compliance<T> for HalfSpace<T> {
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]) {
        self.displacement(pressure, displacement);
    }
    fn apply_around(
        &mut self,
        pressure: &mut [T],
        displacement: &mut [T],
        gap: &mut [f32],
        work: RowWork<'_, T>,
        partial: &mut [Partial],
    ) -> Option<Partial> {
        let partial = &mut partial[..Self::pieces(self.grid().shape())];
        self.displacement_around(pressure, displacement, gap, work, partial)?;
        Some(passes::total(partial))
    }
    fn invert(&mut self, field: &mut [T]) -> bool {
        self.press(field).is_ok()
    }
    fn boundary(&self) -> Boundary {
        Boundary::Periodic
    }
}

/// A free half space and the memory its inverse needs.
pub(crate) struct Free<T: Real> {
    half_space: FreeHalfSpace<T>,
    scratch: Vec<T>,
}

impl<T: Real> Free<T> {
    pub(crate) fn new(half_space: FreeHalfSpace<T>, pixels: usize) -> Self {
        Self { half_space, scratch: Vec::with_capacity(pixels) }
    }
}

impl<T: Real> Compliance<T> for Free<T> {
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]) {
        self.half_space.displacement(pressure, displacement);
    }
    fn invert(&mut self, field: &mut [T]) -> bool {
        self.half_space.dominating_inverse(field, &mut self.scratch)
    }
    fn boundary(&self) -> Boundary {
        Boundary::Free
    }
}

/// What is prescribed, in scaled units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Target {
    /// Mean pressure.
    Pressure(f64),
    /// `displacement - heights` in contact. The number beside it is a first guess of the mean
    /// pressure.
    Level(f64, f64),
}

/// One problem to solve.
#[derive(Clone, Copy)]
pub(crate) struct Task<'a, T> {
    pub(crate) problem: &'a Problem<T>,
    pub(crate) target: Target,
    /// Relative rms pressure error to reach.
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
}

/// Where the iteration begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    Cold,
    Warm,
}

/// The iterate.
pub(crate) struct State<T> {
    pub(crate) pressure: Vec<T>,
    pub(crate) displacement: Vec<T>,
    pub(crate) level: f64,
}

impl<T: Real> State<T> {
    pub(crate) fn new(n: usize) -> Self {
        Self { pressure: vec![T::zero(); n], displacement: vec![T::zero(); n], level: 0.0 }
    }
}

/// What `watch` is shown.
pub(crate) struct Step<'a, T> {
    pub(crate) iteration: usize,
    pub(crate) transforms: f64,
    /// Estimated relative rms pressure error; infinite while there is none.
    pub(crate) residual: f64,
    pub(crate) state: &'a State<T>,
}

/// Called once per iteration; `Break` ends the run.
pub(crate) type Watch<'a, T> = dyn FnMut(&Step<'_, T>) -> ControlFlow<()> + Send + 'a;

/// Why a method returned.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    Converged,
    Exhausted,
    Stopped,
}

/// What a method reports.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Outcome {
    pub(crate) end: End,
    pub(crate) iterations: usize,
    pub(crate) transforms: f64,
    /// Estimated relative rms pressure error of the state returned.
    pub(crate) residual: f64,
}

/// One way of solving the contact problem.
pub(crate) trait ContactMethod<T: Real>: Send {
    /// Solves the task, see the module documentation.
    fn solve(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome;

    /// Whether [`Target::Level`] is understood.
    fn controls_level(&self) -> bool {
        false
    }

    /// From now on (or no longer), each warm start extrapolates from the last two solutions. Costs
    /// memory for one more of them. A method without extrapolation ignores it.
    fn extrapolate(&mut self, is_on: bool) {
        let _ = is_on;
    }

    /// The mean pressure from which it is worth one pair to see if every gap closes, and what finding
    /// that out cost in pairs. A method that spends many pairs anyway says: from any.
    fn suspected_closing_load(&mut self, problem: &Problem<T>) -> (f64, f64) {
        let _ = problem;
        (0.0, 0.0)
    }
}

/// The method asked for, with its memory; and which one `Auto` became.
pub(crate) fn build<T: Real>(
    method: Method,
    scaled: Grid,
    boundary: Boundary,
) -> Result<(Method, Box<dyn ContactMethod<T>>), SolverError> {
    Ok(match (method, boundary) {
        (Method::Auto | Method::Chord, Boundary::Periodic) => {
            (Method::Chord, Box::new(Chord::new(scaled)))
        }
        (Method::Auto | Method::Chord, Boundary::Free) => {
            (Method::Chord, Box::new(FreeChord::new(scaled)?))
        }
        (Method::PolonskyKeer, _) => {
            (Method::PolonskyKeer, Box::new(PolonskyKeer::new(scaled.len())))
        }
        (Method::StanleyKato, _) => (Method::StanleyKato, Box::new(StanleyKato::new(scaled.len()))),
    })
}
