//! What a chord iteration works with, allocated once: fields, pyramid, coarse grids.

use crate::Real;
use crate::methods::contract::State;
use crate::methods::extension::{Pyramid, PyramidLevel};
use crate::methods::node::NodeState;
use crate::methods::stiffness::Stiffness;
use crate::methods::sweep::Sweep;
use crate::methods::thin_pixels;
use crate::row_work::{BLOCK_ROWS, Partial, TASK};
use contact_types::Grid;

/// The trial and the iterate before, one field in single precision, the contact set, the pyramid
/// and the coarse grids.
pub(crate) struct Work<T: Real> {
    /// Rows that one task of a pass handles, and columns.
    pub(super) rows: usize,
    pub(super) columns: usize,
    /// Longer over shorter side of a pixel, and of the map.
    pub(super) elongation: f64,
    pub(super) slenderness: f64,
    /// Longer side of the map.
    pub(super) longest: f64,
    /// The contact set F.
    pub(crate) nodes: Vec<NodeState>,
    /// The residual gap on F; `S E g` once it was preconditioned; the gap of the trial, once that has its
    /// displacement.
    pub(crate) residual: Vec<f32>,
    pub(crate) pyramid: Pyramid,
    pub(crate) stiffness: Stiffness,
    pub(crate) sweep: Sweep,
    pub(crate) pairs: Pairs<T>,
    pub(super) partial: Vec<Partial>,
    /// Whether the residual field holds `S E g` of a constant pressure on the surface at hand: the negative of
    /// the pressure that flattens it.
    pub(super) holds_flattening: bool,
}

impl<T: Real> Work<T> {
    /// For a grid whose finer pixel side is 1.
    pub(super) fn new(scaled: Grid, stiffness: Stiffness) -> Self {
        let (shape, n) = (scaled.shape(), scaled.len());
        let pyramid = Pyramid::new(shape, scaled.pixel());
        // Whole rows of cells of the first level.
        let whole =
            |level: &PyramidLevel| level.rows_per_task() * level.transfer.rows_per_coarse_row();
        let rows = pyramid.levels.first().map_or(shape[0], whole);
        let tasks = n.div_ceil(rows * shape[1]).max(n.div_ceil(TASK));
        let pieces = tasks.max(shape[0].div_ceil(BLOCK_ROWS));
        Self {
            rows,
            columns: shape[1],
            elongation: thin_pixels::ratio(shape, scaled.pixel()),
            slenderness: thin_pixels::ratio(shape, scaled.size()),
            longest: scaled.size().into_iter().fold(1.0, f64::max),
            nodes: vec![NodeState::Gap; n],
            residual: vec![0.0; n],
            stiffness,
            sweep: Sweep::new(shape, pyramid.levels.first()),
            pyramid,
            pairs: Pairs::new(n),
            partial: vec![Partial::default(); pieces],
            holds_flattening: false,
        }
    }
}

/// The trial and, where there is [room](Self::make_room) for it, the iterate before the present one. The present
/// one belongs to the caller.
///
/// Until a convolution has been spent on the displacement of the trial, its place is the *spare*: room for a field in
/// single precision, first `E g`, then the smallest trial pressure below each cell.
pub(crate) struct Pairs<T> {
    pub(crate) trial: State<T>,
    pub(crate) before: State<T>,
}

impl<T: Real> Pairs<T> {
    pub(super) fn new(n: usize) -> Self {
        Self { trial: State::new(n), before: State::new(0) }
    }

    /// Makes room for the iterate before, which a step of two directions needs.
    pub(super) fn make_room(&mut self) {
        if !self.has_room() {
            self.before = State::new(self.trial.pressure.len());
        }
    }

    pub(crate) fn has_room(&self) -> bool {
        self.before.pressure.len() == self.trial.pressure.len()
    }

    /// As on a grid too large for it.
    #[cfg(test)]
    pub(crate) fn give_up_room(&mut self) {
        self.before = State::new(0);
    }

    /// The pressure of the trial, and the spare.
    pub(crate) fn trial_and_spare(&mut self) -> (&mut [T], &mut [f32]) {
        let State { pressure, displacement, .. } = &mut self.trial;
        let n = displacement.len();
        (pressure, &mut T::as_single(displacement)[..n])
    }

    /// Multiplies the pairs that the next step will use by the factor of the load: K is linear.
    pub(super) fn scale(&mut self, factor: f64, iterate: &mut State<T>) {
        // The step before must stay one that changes no load.
        self.before.scale(factor);
        iterate.scale(factor);
    }

    /// Makes the trial the iterate and, where there is room, the iterate the one before.
    pub(super) fn take_trial(&mut self, iterate: &mut State<T>) {
        std::mem::swap(&mut self.trial, iterate);
        if self.has_room() {
            std::mem::swap(&mut self.before, &mut self.trial);
        }
    }
}
