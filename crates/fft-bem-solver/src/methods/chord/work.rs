//! What a chord iteration works with, allocated once: fields, pyramid, coarse grids.

use crate::Real;
use crate::methods::contract::State;
use crate::methods::extension::Pyramid;
use crate::methods::node::NodeState;
use crate::methods::stiffness::Stiffness;
use crate::methods::sweep::Sweep;
use crate::row_work::{BLOCK_ROWS, Partial, TASK};
use contact_types::Grid;

pub(crate) struct Work<T: Real> {
    /// Rows that one task of a pass handles.
    pub(super) rows: usize,
    /// Of which the finer pixel side is 1.
    pub(super) grid: Grid,
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
    pub(super) fn columns(&self) -> usize {
        self.grid.shape()[1]
    }

    pub(super) fn new(scaled: Grid, is_isolated: bool) -> Self {
        let (shape, pixel, n) = (scaled.shape(), scaled.pixel(), scaled.len());
        let stiffness = if is_isolated { Stiffness::isolated } else { Stiffness::new };
        let pyramid = Pyramid::new(shape, pixel);
        let first = &pyramid.levels[0];
        let rows = first.rows_per_task() * first.transfer.rows_per_coarse_row();
        let tasks = n.div_ceil(rows * shape[1]).max(n.div_ceil(TASK));
        let pieces = tasks.max(shape[0].div_ceil(BLOCK_ROWS));
        Self {
            rows,
            grid: scaled,
            nodes: vec![NodeState::Gap; n],
            residual: vec![0.0; n],
            stiffness: stiffness(shape, pixel),
            sweep: Sweep::new(first),
            pyramid,
            pairs: Pairs { trial: State::new(n), before: State::new(0) },
            partial: vec![Partial::default(); pieces],
            holds_flattening: false,
        }
    }
}

/// The trial and, where there is [room](Self::has_room) for it, the iterate before the present one. The present
/// one belongs to the caller.
///
/// Until a convolution has been spent on the displacement of the trial, its place is the *spare*: room for a field in
/// single precision, first `E g`, then the smallest trial pressure below each cell.
pub(crate) struct Pairs<T> {
    pub(crate) trial: State<T>,
    pub(crate) before: State<T>,
}

impl<T: Real> Pairs<T> {
    pub(crate) fn has_room(&self) -> bool {
        self.before.pressure.len() == self.trial.pressure.len()
    }

    /// The pressure of the trial, and the spare.
    pub(crate) fn trial_and_spare(&mut self) -> (&mut [T], &mut [f32]) {
        let State { pressure, displacement, .. } = &mut self.trial;
        let n = displacement.len();
        (pressure, &mut T::as_single(displacement)[..n])
    }
}
