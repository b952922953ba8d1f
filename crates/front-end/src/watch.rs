//! Looking on while loads are solved.

use crate::failure::Failure;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Iteration, Load, Solution};
use std::ops::ControlFlow;

/// Who is told what happens, takes the maps, and may stop it.
pub trait Watch: Send {
    /// The map that is solved, once its form is off.
    fn levelled(&mut self, _map: &HeightMap) {}

    /// A grid was chosen for an accuracy: all loads begin again, on this one.
    fn begin(&mut self, _grid: Grid, _loads: usize) {}

    /// A load begins.
    fn working_on(&mut self, _load: Load) {}

    /// An iteration on a load, by its place in the list, is done. It is called on a thread of the solver.
    /// `Break` ends everything: what was solved is kept.
    fn iterated(&mut self, _index: usize, _load: Load, _now: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// A load was solved on this grid; the maps may be taken out of the solution.
    ///
    /// # Errors
    /// Why the maps could not be kept: the numbers of the load stay.
    fn keep(
        &mut self,
        _index: usize,
        _grid: Grid,
        _solution: &mut Solution,
    ) -> Result<(), Failure> {
        Ok(())
    }

    /// A load, by its place in the list, is done with, whether it was solved or not.
    fn done(&mut self, _index: usize, _load: Load) {}
}
