//! The sweep that frees a trial pressure of tension.
//!
//! A step along the preconditioned residual leaves negative pressures at nodes that are about to
//! lose contact. Clipping them would leave the neighbours under-loaded. Their (negative) load is
//! instead handed to the nodes that stay, with the transpose of the extension, `E^T`: what an
//! elastic body does when it loses a support. Nodes that were just released are swept likewise.
//!
//! What `E^T` adds is the same for all nodes below one cell of the first level, so a sweep works
//! on that level alone; the finest grid is visited only where a node changes sides.
//!
//! Under a ceiling, what a node would carry beyond it is handed on likewise, once little tension is left.

use super::ceiling::Ceiling;
use super::extension::{Pyramid, PyramidLevel};
use super::node::NodeState;
use super::tension::CellRows;
use crate::simd::vectorised;
use crate::{Real, fields};
use grid_fft::parallel::prelude::*;

/// Most rounds of sweeping.
pub(crate) const ROUNDS: u8 = 12;
/// Tension, as a part of the load and of the present relative error, that may be clipped.
pub(crate) const NEGLIGIBLE: f64 = 1e-3;
/// Tension, as a part of the load, above which nobody asks for the ceiling.
pub(crate) const LITTLE: f64 = 0.1;
/// Largest change of the load that nodes below the ceiling are given by a factor.
pub(crate) const ROUGH: f64 = 0.1;
/// Fewest rows of cells that one task handles: each has two more to hand load to.
const ROWS: usize = 16;

/// Memory of the sweep.
pub(crate) struct Sweep {
    /// What the nodes below each cell carry beside the trial: a constant that belongs to the step, and what the sweeps
    /// hand down.
    added: Vec<f32>,
    /// Load handed to the row before and the row after those of each task.
    beyond: Vec<f32>,
    /// For each task, the load handed up, and how many nodes it is from.
    found: Vec<(f64, usize)>,
}

impl Sweep {
    /// For the first level of a pyramid above a grid; without one each pixel is a cell.
    pub(crate) fn new(shape: [usize; 2], first: Option<&PyramidLevel>) -> Self {
        let [my, mx] = first.map_or(shape, |level| level.transfer.coarse);
        let tasks = first.map_or(0, |level| my.div_ceil(rows_per_task(level)));
        Self {
            added: vec![0.0; my * mx],
            beyond: vec![0.0; 2 * mx * tasks],
            found: vec![(0.0, 0); tasks],
        }
    }

    /// For a new trial, from which a constant was left out.
    pub(crate) fn begin(&mut self, shift: f32) {
        fields::fill(f64::from(shift), &mut self.added);
    }

    /// What the nodes of row `i` of the finest grid carry beside the trial.
    #[inline(always)]
    pub(crate) fn added_below(&self, i: usize, pyramid: &Pyramid, nx: usize) -> &[f32] {
        let cells = |level: &PyramidLevel| (level.transfer.parent(i), level.transfer.coarse[1]);
        let (row, mx) = pyramid.levels.first().map_or((i, nx), cells);
        &self.added[row * mx..][..mx]
    }

    /// Sweeps released nodes, then negative pressures, until no more than a `negligible` tension is left; from a
    /// `little` on the ceiling counts as well. `smallest` holds the smallest trial pressure below each cell of the first
    /// level; `active` nodes are in contact. On return a node carries the trial and what is added to it, clipped, if it
    /// is still in contact.
    #[allow(clippy::too_many_arguments, reason = "a pass over four fields")]
    pub(crate) fn run<T: Real, C: Ceiling<T>>(
        &mut self,
        ceiling: C,
        pyramid: &mut Pyramid,
        trial: &[T],
        nodes: &mut [NodeState],
        smallest: &mut [f32],
        active: usize,
        has_released: bool,
        [negligible, little]: [f64; 2],
    ) {
        if pyramid.levels.is_empty() {
            return; // up to 4 x 4 pixels: E^T is the restriction to the contact
        }
        if has_released {
            Self::hand_up_released(ceiling, pyramid, trial, nodes);
            pyramid.restrict_above();
        }
        let (mut left, mut has_more) = (active, has_released);
        let mut fills = false;
        for _ in 0..=(if C::IS_FINITE { 2 * ROUNDS } else { ROUNDS }) {
            let (excess, count) =
                self.drop_beyond(ceiling, fills, pyramid, trial, nodes, smallest, has_more);
            let is_all = !C::IS_FINITE || fills;
            fills |= C::IS_FINITE && excess <= little;
            if (excess <= negligible && is_all) || count >= left {
                return;
            }
            left -= count;
            has_more = false;
            if count == 0 {
                continue; // only the ceiling is still to be looked at
            }
            self.collect(pyramid);
            pyramid.pull_above();
            pyramid.restrict_above();
            has_more = true;
        }
    }

    /// Hands the load of released nodes up. They have no part in the shift.
    fn hand_up_released<T: Real, C: Ceiling<T>>(
        ceiling: C,
        pyramid: &mut Pyramid,
        trial: &[T],
        nodes: &[NodeState],
    ) {
        let level = &mut pyramid.levels[0];
        let (t, rows) = (level.transfer, level.rows_per_task());
        let (nx, mx) = (t.fine[1], t.coarse[1]);
        level.value.par_chunks_mut(rows * mx).enumerate().for_each(|(task, value)| {
            vectorised!({
                for (j, out) in value.chunks_exact_mut(mx).enumerate() {
                    t.up_transposed_row(
                        task * rows + j,
                        out,
                        #[inline(always)]
                        |iy, factor, ix, line: &mut [f32]| {
                            let first = iy * nx + ix;
                            let nodes = &nodes[first..][..line.len()];
                            let fills = |m: NodeState| C::IS_FINITE && m == NodeState::Filled;
                            let is_off = |m: NodeState| (m == NodeState::Released) | fills(m);
                            if !nodes.iter().fold(false, |any, m| any | is_off(*m)) {
                                return; // as most lines, but in a first step
                            }
                            let fields = line.iter_mut().zip(nodes).zip(&trial[first..]);
                            for ((l, m), p) in fields {
                                let top = if fills(*m) { ceiling.top() } else { T::zero() };
                                let beyond = (*p - top).narrow(); // read anyway: no branch
                                *l += factor * if is_off(*m) { beyond } else { 0.0 };
                            }
                        },
                    );
                }
            });
        });
    }

    /// Takes the nodes beyond a bound out of the contact, lowers the weights above and hands up what they
    /// would carry beyond it. Returns that and their number. With `has_more`, what the first level hands
    /// down is added before.
    #[allow(clippy::too_many_arguments, reason = "a pass over three fields")]
    fn drop_beyond<T: Real, C: Ceiling<T>>(
        &mut self,
        ceiling: C,
        fills: bool,
        pyramid: &mut Pyramid,
        trial: &[T],
        nodes: &mut [NodeState],
        smallest: &mut [f32],
        has_more: bool,
    ) -> (f64, usize) {
        let level = &mut pyramid.levels[0];
        let (t, capacity, rows) = (level.transfer, level.capacity, rows_per_task(level));
        let (nx, mx, share) = (t.fine[1], t.coarse[1], t.node_share());
        let fine = rows * t.rows_per_coarse_row() * nx;
        self.found
            .par_iter_mut()
            .zip(smallest.par_chunks_mut(rows * mx))
            .zip(self.added.par_chunks_mut(rows * mx))
            .zip(self.beyond.par_chunks_mut(2 * mx))
            .zip(level.value.par_chunks_mut(rows * mx))
            .zip(level.weight.par_chunks_mut(rows * mx))
            .zip(nodes.par_chunks_mut(fine).zip(trial.par_chunks(fine)))
            .for_each(|(cells, (nodes, trial))| {
                let (((((found, smallest), added), beyond), value), weight) = cells;
                vectorised!({
                    if has_more {
                        for (a, more) in added.iter_mut().zip(&*value) {
                            *a += share * more;
                        }
                    }
                    let t = &t;
                    let mut rows = CellRows {
                        t,
                        capacity,
                        ceiling,
                        fills,
                        trial,
                        nodes,
                        weight,
                        value,
                        beyond,
                        found: (0.0, 0),
                    };
                    let lines = smallest.chunks_exact_mut(mx).zip(added.chunks_exact(mx));
                    for (r, (smallest, added)) in lines.enumerate() {
                        rows.drop_beyond(r, added, smallest);
                    }
                    *found = rows.found;
                });
            });
        self.found.iter().fold((0.0, 0), |(t, n), f| (t + f.0, n + f.1))
    }

    /// Completes the load handed up: where nothing was, it is zero, and the rows of a task are given what
    /// the tasks beside it have for them.
    fn collect(&self, pyramid: &mut Pyramid) {
        let level = &mut pyramid.levels[0];
        let (mx, rows) = (level.transfer.coarse[1], rows_per_task(level));
        let tasks = self.found.len();
        let from = |task: usize, row: usize| {
            let beyond = &self.beyond[(2 * task + row) * mx..][..mx];
            (self.found[task].1 > 0).then_some(beyond)
        };
        level.value.par_chunks_mut(rows * mx).enumerate().for_each(|(task, value)| {
            if self.found[task].1 == 0 {
                value.fill(0.0);
            }
            if level.transfer.halved[0] {
                let last = value.len() - mx;
                add(from((task + tasks - 1) % tasks, 1), &mut value[..mx]);
                add(from((task + 1) % tasks, 0), &mut value[last..]);
            }
        });
    }
}

/// Rows of cells that one task of the sweep handles.
fn rows_per_task(level: &PyramidLevel) -> usize {
    level.rows_per_task().max(ROWS)
}

/// Adds a row, if there is one, to another.
fn add(row: Option<&[f32]>, to: &mut [f32]) {
    for (to, x) in to.iter_mut().zip(row.unwrap_or(&[])) {
        *to += x;
    }
}
