//! Nodes in tension, cell by cell: which of them are dropped, and what they hand up.
//!
//! Most blocks of cells hold none.

use super::ceiling::Ceiling;
use super::extension::Capacity;
use super::node::NodeState;
use super::transfer::Transfer;
use crate::Real;

/// Cells or nodes that are looked at in one go. Most blocks hold nothing to do.
const BLOCK: usize = 32;

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
pub(super) struct CellRows<'a, T, C> {
    pub(super) t: &'a Transfer,
    pub(super) capacity: Capacity,
    /// The bound, and whether it counts by now.
    pub(super) ceiling: C,
    pub(super) fills: bool,
    pub(super) trial: &'a [T],
    pub(super) nodes: &'a mut [NodeState],
    pub(super) weight: &'a mut [f32],
    /// The load that the nodes hand to these rows, and to the one before and after.
    pub(super) value: &'a mut [f32],
    pub(super) beyond: &'a mut [f32],
    /// What was handed up so far, and of how many nodes.
    pub(super) found: (f64, usize),
}

impl<T: Real, C: Ceiling<T>> CellRows<'_, T, C> {
    /// Takes the nodes below row `r` of the cells out of the contact that are in tension, or above the ceiling if it
    /// counts; lowers the weights and hands up what they would carry beyond the bound.
    #[inline(always)]
    pub(super) fn drop_beyond(&mut self, r: usize, added: &[f32], smallest: &mut [f32]) {
        let blocks = smallest.chunks_mut(BLOCK).zip(added.chunks(BLOCK)).enumerate();
        for (k, (smallest, added)) in blocks {
            let flags = tension_flags(smallest, added, C::IS_FINITE);
            for_each_set(&flags, |c| {
                self.drop_cell([r, k * BLOCK + c], added[c], &mut smallest[c]);
            });
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
            nodes[*place] = nodes[*place].or(NodeState::Dropped, drops);
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

/// Calls `found` with the place of every flag that is 1 and not 0. Most blocks have none.
#[inline(always)]
fn for_each_set(flags: &[u8; BLOCK], mut found: impl FnMut(usize)) {
    if *flags == [0; BLOCK] {
        return;
    }
    for (k, flags) in flags.as_chunks::<8>().0.iter().enumerate() {
        let mut bits = u64::from_le_bytes(*flags);
        while bits != 0 {
            found(8 * k + bits.trailing_zeros() as usize / 8);
            bits &= bits - 1;
        }
    }
}
