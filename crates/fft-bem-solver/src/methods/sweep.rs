//! The trial pressure, and the sweep that frees it of tension.
//!
//! A step along the preconditioned residual leaves negative pressures at nodes that are about to
//! lose contact. Clipping them would leave the neighbours under-loaded. Their (negative) load is
//! instead handed to the nodes that stay, with the transpose of the extension, `E^T`: what an
//! elastic body does when it loses a support. Nodes that were just released are swept likewise.
//!
//! What `E^T` adds is the same for all nodes below one cell of the first level, so a sweep works
//! on that level alone; the finest grid is visited only where a node changes sides.

use super::extension::{Level, Pyramid};
use super::transfer::ON;
use crate::Real;
use grid_fft::parallel::prelude::*;

/// Most rounds of sweeping.
pub(crate) const ROUNDS: u8 = 12;
/// Tension, as a part of the load, that may be clipped.
pub(crate) const NEGLIGIBLE: f64 = 1e-3;
/// Mark of a node that carries load but was released before the trial.
pub(crate) const RELEASED: u8 = 2;
/// Mark of the nodes dropped in round k: this plus k.
const DROPPED: u8 = 3;

/// Memory of the sweep.
pub(crate) struct Sweep {
    /// Smallest trial pressure below each cell of the first level.
    pub(crate) smallest: Vec<f32>,
    /// What belongs to the step but is not in the trial: a constant on the contact.
    pub(crate) shift: f32,
    /// What is added to each node below a cell: the shift, and what the sweeps hand on.
    pub(crate) added: Vec<f32>,
    /// For each row of cells, the last mark set below it.
    marks: Vec<u8>,
    /// For each task, the tension found and the nodes it is on.
    found: Vec<(f64, usize)>,
}

impl Sweep {
    /// For the first level of a pyramid.
    pub(crate) fn new(first: Option<&Level>) -> Self {
        let Some(level) = first else {
            let (smallest, added, marks, found) = (vec![], vec![], vec![], vec![]);
            return Self { smallest, shift: 0.0, added, marks, found };
        };
        let [my, mx] = level.transfer.coarse;
        Self {
            smallest: vec![0.0; my * mx],
            shift: 0.0,
            added: vec![0.0; my * mx],
            marks: vec![0; my],
            found: vec![(0.0, 0); my.div_ceil(level.rows_per_task())],
        }
    }

    /// Sweeps released nodes, then negative pressures, until what is left is negligible.
    /// `trial` and `mask` are on the finest grid; `active` nodes are in contact; `total` is the
    /// load against which what is left must be negligible: the whole load, or, since what is clipped is
    /// spread over the map, as much less as lines of long pixels can take over less from each other. On return a node carries `trial + added` of its cell if its mark is [`ON`].
    pub(crate) fn run<T: Real>(
        &mut self,
        pyramid: &mut Pyramid,
        trial: &[T],
        mask: &mut [u8],
        active: usize,
        has_released: bool,
        total: f64,
    ) {
        if pyramid.levels.is_empty() {
            return; // up to 4 x 4 pixels: E^T is the restriction to the contact
        }
        self.added.fill(self.shift);
        if has_released {
            self.marks.fill(RELEASED); // they can be anywhere
            self.spread(pyramid, trial, mask, RELEASED, -self.shift); // they have no part in it
        }
        let mut left = active;
        for round in 0..ROUNDS {
            let (tension, count) = self.tension(pyramid, trial, mask);
            if tension <= NEGLIGIBLE * total || count >= left {
                return;
            }
            left -= count;
            self.drop_negative(pyramid, trial, mask, DROPPED + round);
            pyramid.reweigh_above();
            self.spread(pyramid, trial, mask, DROPPED + round, 0.0);
        }
    }

    /// Sum of the negative pressures and number of nodes that bear them.
    fn tension<T: Real>(&mut self, pyramid: &Pyramid, trial: &[T], mask: &[u8]) -> (f64, usize) {
        let level = &pyramid.levels[0];
        let (t, rows) = (level.transfer, level.rows_per_task());
        let mx = t.coarse[1];
        self.found
            .par_iter_mut()
            .zip(self.smallest.par_chunks(rows * mx))
            .zip(self.added.par_chunks(rows * mx))
            .enumerate()
            .for_each(|(task, ((found, smallest), added))| {
                *found = (0.0, 0);
                for (c, (s, a)) in smallest.iter().zip(added).enumerate() {
                    if s + a < 0.0 {
                        for node in nodes_below(&t, task * rows + c / mx, c % mx) {
                            let p = trial[node].wide() + f64::from(*a);
                            if mask[node] == ON && p < 0.0 {
                                found.0 -= p;
                                found.1 += 1;
                            }
                        }
                    }
                }
            });
        self.found.iter().fold((0.0, 0), |(t, n), f| (t + f.0, n + f.1))
    }

    /// Takes the negative nodes out of the contact, with a mark, and lowers the weights above.
    fn drop_negative<T: Real>(
        &mut self,
        pyramid: &mut Pyramid,
        trial: &[T],
        mask: &mut [u8],
        mark: u8,
    ) {
        let level = &mut pyramid.levels[0];
        let (t, capacity, rows) = (level.transfer, level.capacity, level.rows_per_task());
        let (nx, mx) = (t.fine[1], t.coarse[1]);
        let fine_rows = rows * t.rows_per_coarse_row();
        mask.par_chunks_mut(fine_rows * nx)
            .zip(trial.par_chunks(fine_rows * nx))
            .zip(self.smallest.par_chunks_mut(rows * mx))
            .zip(self.added.par_chunks(rows * mx))
            .zip(self.marks.par_chunks_mut(rows))
            .zip(level.weight.par_chunks_mut(rows * mx))
            .zip(level.inverse.par_chunks_mut(rows * mx))
            .enumerate()
            .for_each(
                |(task, ((((((mask, trial), smallest), added), marks), weight), inverse))| {
                    let origin = task * fine_rows * nx;
                    for c in 0..smallest.len() {
                        if smallest[c] + added[c] < 0.0 {
                            marks[c / mx] = mark;
                            let mut rest = f32::INFINITY;
                            let mut filled = 0.0;
                            for node in nodes_below(&t, task * rows + c / mx, c % mx) {
                                let i = node - origin;
                                if mask[i] == ON {
                                    if trial[i].wide() + f64::from(added[c]) < 0.0 {
                                        mask[i] = mark;
                                    } else {
                                        filled += 1.0;
                                        rest = rest.min(trial[i].wide() as f32);
                                    }
                                }
                            }
                            smallest[c] = rest;
                            (weight[c], inverse[c]) = capacity.of(filled * t.node_share());
                        }
                    }
                },
            );
    }

    /// `added += E^T` of the load on the nodes with this mark, `trial + added + shift`.
    fn spread<T: Real>(
        &mut self,
        pyramid: &mut Pyramid,
        trial: &[T],
        mask: &[u8],
        mark: u8,
        shift: f32,
    ) {
        let level = &mut pyramid.levels[0];
        let (t, rows) = (level.transfer, level.rows_per_task());
        let (nx, [my, mx]) = (t.fine[1], t.coarse);
        let (marks, added) = (&self.marks, &self.added);
        level.value.par_chunks_mut(rows * mx).enumerate().for_each(|(task, value)| {
            for (r, out) in value.chunks_exact_mut(mx).enumerate() {
                let j = task * rows + r;
                let near = if t.halved[0] { [(j + my - 1) % my, j, (j + 1) % my] } else { [j; 3] };
                if near.iter().all(|&k| marks[k] != mark) {
                    out.fill(0.0);
                    continue;
                }
                t.up_transposed_row(j, out, |iy, factor, ix, line| {
                    let parent = t.parent(iy);
                    if marks[parent] != mark {
                        return;
                    }
                    let first = iy * nx + ix;
                    let (m, p) = (&mask[first..][..line.len()], &trial[first..][..line.len()]);
                    let above = &added[parent * mx..][..mx];
                    for_each_marked(m, mark, |i| {
                        let column = if t.halved[1] { (ix + i) >> 1 } else { ix + i };
                        let load = p[i].wide() as f32 + (above[column] + shift);
                        line[i] += factor * load;
                    });
                });
            }
        });
        pyramid.restrict_above();
        let level = &pyramid.levels[0];
        let share = level.transfer.node_share();
        self.added.par_chunks_mut(rows * mx).zip(level.value.par_chunks(rows * mx)).for_each(
            |(added, value)| {
                for (a, v) in added.iter_mut().zip(value) {
                    *a += share * v;
                }
            },
        );
    }
}

/// Calls `found` with every node that bears the mark, most of which do not.
fn for_each_marked(nodes: &[u8], mark: u8, mut found: impl FnMut(usize)) {
    for (k, block) in nodes.chunks(16).enumerate() {
        // Without a way out in between, a block is looked at in one go.
        if block.iter().fold(false, |any, m| any | (*m == mark)) {
            for (i, _) in block.iter().enumerate().filter(|node| *node.1 == mark) {
                found(16 * k + i);
            }
        }
    }
}

/// Indices of the nodes below cell `(j, c)`.
fn nodes_below(
    t: &super::transfer::Transfer,
    j: usize,
    c: usize,
) -> impl Iterator<Item = usize> + use<> {
    let [ny, nx] = t.fine;
    let span = |halved: bool, k: usize, n: usize| {
        if halved { 2 * k..(2 * k + 2).min(n) } else { k..k + 1 }
    };
    let columns = span(t.halved[1], c, nx);
    span(t.halved[0], j, ny).flat_map(move |iy| columns.clone().map(move |ix| iy * nx + ix))
}
