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
use super::extension::{Capacity, Pyramid, PyramidLevel};
use super::node::NodeState;
use super::transfer::Transfer;
use crate::simd::vectorised;
use crate::{Real, fields};
use grid_fft::parallel::prelude::*;

/// Cells that are looked at together.
const BLOCK: usize = 32;
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
    pub(crate) fn new(first: &PyramidLevel) -> Self {
        let [my, mx] = first.transfer.coarse;
        let tasks = my.div_ceil(rows_per_task(first));
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
    pub(crate) fn added_below(&self, i: usize, t: &Transfer) -> &[f32] {
        &self.added[t.parent(i) * t.coarse[1]..][..t.coarse[1]]
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
        let fills = |m: NodeState| C::IS_FINITE && m == NodeState::Filled;
        let is_off = |m: NodeState| (m == NodeState::Released) | fills(m);
        pyramid.levels[0].hand_up(
            #[inline(always)]
            |first, factor, line| {
                let nodes = &nodes[first..][..line.len()];
                if !nodes.iter().fold(false, |any, m| any | is_off(*m)) {
                    return; // as most lines, but in a first step
                }
                for ((l, m), p) in line.iter_mut().zip(nodes).zip(&trial[first..]) {
                    let top = if fills(*m) { ceiling.top() } else { T::zero() };
                    let beyond = (*p - top).narrow(); // read anyway: no branch
                    *l += factor * if is_off(*m) { beyond } else { 0.0 };
                }
            },
        );
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

fn rows_per_task(level: &PyramidLevel) -> usize {
    level.rows_per_task().max(ROWS)
}

fn add(row: Option<&[f32]>, to: &mut [f32]) {
    for (to, x) in to.iter_mut().zip(row.unwrap_or(&[])) {
        *to += x;
    }
}

/// Of a block of cells, 1 for those below which a pressure is negative once so much is added.
#[inline(always)]
fn tension_flags(smallest: &[f32], added: &[f32], has_ceiling: bool) -> [u8; BLOCK] {
    // Towards the ceiling the same addition takes the other sign: one of the two bounds is passed.
    let worst = |a: f32| if has_ceiling { -a.abs() } else { a };
    let mut flags = [0; BLOCK];
    for ((flag, s), a) in flags.iter_mut().zip(smallest).zip(added) {
        *flag = u8::from(s + worst(*a) < 0.0);
    }
    flags
}

/// Some rows of cells, with the rows of nodes below them.
struct CellRows<'a, T, C> {
    t: Transfer,
    capacity: Capacity,
    /// The bound, and whether it counts by now.
    ceiling: C,
    fills: bool,
    trial: &'a [T],
    nodes: &'a mut [NodeState],
    weight: &'a mut [f32],
    /// The load that the nodes hand to these rows, and to the one before and after.
    value: &'a mut [f32],
    beyond: &'a mut [f32],
    /// What was handed up so far, and of how many nodes.
    found: (f64, usize),
}

impl<T: Real, C: Ceiling<T>> CellRows<'_, T, C> {
    /// Takes the nodes below row `r` of the cells out of the contact that are in tension, or above the ceiling if it
    /// counts; lowers the weights and hands up what they would carry beyond the bound.
    #[inline(always)]
    fn drop_beyond(&mut self, r: usize, added: &[f32], smallest: &mut [f32]) {
        let blocks = smallest.chunks_mut(BLOCK).zip(added.chunks(BLOCK)).enumerate();
        for (k, (smallest, added)) in blocks {
            let flags = tension_flags(smallest, added, C::IS_FINITE);
            if flags == [0; BLOCK] {
                continue; // as most
            }
            for c in (0..BLOCK).filter(|c| flags[*c] > 0) {
                self.drop_cell([r, k * BLOCK + c], added[c], &mut smallest[c]);
            }
        }
    }

    /// The nodes below one cell. `smallest` becomes the smallest trial pressure of those that stay.
    #[inline(always)]
    fn drop_cell(&mut self, [r, c]: [usize; 2], added: f32, smallest: &mut f32) {
        let t = self.t;
        let (nodes, trial) = (&mut *self.nodes, self.trial);
        let nx = t.fine[1];
        let (rows, columns) = (t.rows_per_coarse_row(), if t.halved[1] { 2 } else { 1 });
        let first = r * rows * nx + c * columns;
        let has_right = columns == 2 && c * columns + 1 < nx;
        let has_lower = rows == 2 && first + nx < nodes.len();
        let (right, lower) = (usize::from(has_right), if has_lower { nx } else { 0 });
        let places = [first, first + right, first + lower, first + lower + right];
        let exists = [true, has_right, has_lower, has_lower & has_right];

        let q = places.map(|place| trial[place]);
        let p = q.map(|q| q.wide() + f64::from(added));
        let (mut on, mut drops, mut load, mut rest) = ([false; 4], [false; 4], [0.0; 4], [0.0; 4]);
        for k in 0..4 {
            on[k] = exists[k] & nodes[places[k]].is_in();
            drops[k] = on[k] & (p[k] < 0.0);
            load[k] = if drops[k] { p[k] } else { 0.0 };
            rest[k] = if on[k] & !drops[k] { q[k].narrow() } else { f32::INFINITY };
        }
        for (place, drops) in places.iter().zip(drops) {
            nodes[*place] = nodes[*place].or(NodeState::Gap, drops);
        }
        if C::IS_FINITE {
            for k in 0..4 {
                let top = self.ceiling.top();
                let fills = on[k] & self.fills & (p[k] > top.wide());
                nodes[places[k]] = nodes[places[k]].or(NodeState::Full, fills);
                load[k] += if fills { p[k] - top.wide() } else { 0.0 };
                drops[k] |= fills;
                let nearer = q[k].narrow().min((top - q[k]).narrow());
                rest[k] = if on[k] & !drops[k] { nearer } else { f32::INFINITY };
            }
        }
        let count = |flags: [bool; 4]| flags.iter().map(|f| usize::from(*f)).sum::<usize>();
        let least = |x: f32, y: f32| if x < y { x } else { y };
        let (all, dropped) = (count(on), count(drops));
        if dropped > 0 {
            if self.found.1 == 0 {
                // Before the first node hands anything, everything is zero.
                self.value.fill(0.0);
                self.beyond.fill(0.0);
            }
            let [left, right, lower, last] = load.map(|load| load as f32);
            self.hand_up(r, c, [[left, right], [lower, last]]);
        }
        self.found.0 += load.iter().map(|load| load.abs()).sum::<f64>();
        self.found.1 += dropped;
        *smallest = least(least(rest[0], rest[1]), least(rest[2], rest[3]));
        let filled = (all - dropped) as f32;
        self.weight[r * t.coarse[1] + c] = self.capacity.of(filled * t.node_share());
    }

    /// Adds the loads of the nodes below cell `(r, c)` with the transpose of the interpolation.
    #[inline(always)]
    fn hand_up(&mut self, r: usize, c: usize, [upper, lower]: [[f32; 2]; 2]) {
        let mx = self.t.coarse[1];
        if !self.t.halved[0] {
            return self.t.add_columns_transposed(c, upper, &mut self.value[r * mx..][..mx]);
        }
        let last = self.value.len() / mx - 1;
        let (before, after) = self.beyond.split_at_mut(mx);
        let above = if r == 0 { before } else { &mut self.value[(r - 1) * mx..][..mx] };
        self.t.add_columns_transposed(c, upper.map(|x| 0.25 * x), above);
        let below = if r == last { after } else { &mut self.value[(r + 1) * mx..][..mx] };
        self.t.add_columns_transposed(c, lower.map(|x| 0.25 * x), below);
        let both = [upper[0] + lower[0], upper[1] + lower[1]].map(|x| 0.75 * x);
        self.t.add_columns_transposed(c, both, &mut self.value[r * mx..][..mx]);
    }
}
