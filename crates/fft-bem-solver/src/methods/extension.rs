//! Pull–push extension `E` of values on the contact set to the whole grid, and its transpose.
//!
//! On the contact set F the inverse of `u = K p` is close to `E^T S E`: `E` continues the field
//! smoothly from the contact into the gap, as an elastic surface would, and `S = K^-1` acts on
//! the whole grid, where it is cheap. `E` is a pyramid: *pull* averages what is known into ever
//! coarser cells, *push* interpolates it back into the cells that know nothing,
//!
//! ```text
//! w0 = 1 on F, else 0;     m = down(w_l);    d_(l+1) = 1/m;    w_(l+1) = m (1 + b (1 - m))
//! pull   v0 = r,           v_(l+1) = d_(l+1) down(w_l v_l)
//! push   x_top = w_top v_top,      x_l = w_l v_l + (1 - w_l) up(x_(l+1))
//! ```
//!
//! The weights are capacities, not area fractions: a cell partly in contact counts for more than
//! its share, because the field outside an isolated contact falls off as 1/r and not at once;
//! hence `b > 0`. Where pixels are so long that a whole line of them is one cell before cells are
//! square, the cell leans on its neighbours as much less as it is longer than wide: `(1 - w)/w`
//! counts [`COUPLING`] times width over length. Everything is single precision: the result is a step, corrected by the next one.

use super::node::NodeState;
use super::stiffness::Stiffness;
use super::transfer::{FilledPart, Transfer};
use crate::row_work::TASK;
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

/// Where a cell knows nothing, its value is 0 instead of 0/0. Small enough that `E` leaves a constant
/// as it is: thin pixels resist what is left of it a thousand times more than the constant.
const EPSILON: f32 = 1e-30;
/// What a line of long pixels takes from the lines beside it, for each ratio of its length to their
/// width, in what it takes from them if that ratio is 1.
const COUPLING: f64 = 0.3;
/// b of the module documentation, where cells are halved along both axes, and along one.
const GAIN: [f32; 2] = [0.6, 0.45];
/// Axes whose pixels are less than this times as long as the finest are halved together.
const ALIKE: f64 = 1.5;

/// From the filled fraction of a cell to its weight.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Capacity {
    /// b of the module documentation.
    gain: f32,
}

impl Capacity {
    /// Weight of a cell of which a fraction `m` is filled.
    pub(crate) fn of(self, m: f32) -> f32 {
        m * (1.0 + self.gain * (1.0 - m))
    }

    /// `w/m = 1 + b (1 - m)` of a cell of weight `w`.
    fn per_filled(self, w: f32) -> f32 {
        let most = 1.0 + self.gain;
        0.5 * (most + (most * most - 4.0 * self.gain * w).sqrt())
    }
}

/// d of the module documentation.
fn inverse(m: f32) -> f32 {
    1.0 / (m + EPSILON)
}

pub(crate) struct PyramidLevel {
    /// From the next finer grid to this one.
    pub(crate) transfer: Transfer,
    pub(crate) capacity: Capacity,
    /// Factor on `(1 - w)/w`; below 1 for the cells that hold a whole line of long pixels.
    coupling: f32,
    pub(crate) weight: Vec<f32>,
    pub(crate) value: Vec<f32>,
}

impl PyramidLevel {
    /// `pixel` is that of this level.
    fn new(transfer: Transfer, pixel: [f64; 2]) -> Self {
        let n = transfer.coarse[0] * transfer.coarse[1];
        let gain = GAIN[usize::from(transfer.halved != [true, true])];
        let capacity = Capacity { gain };
        let zeros = || vec![0.0; n];
        let ends = |a: usize| transfer.halved[a] && transfer.coarse[a] == 1;
        let slenderness = match [ends(0), ends(1)] {
            [true, false] => pixel[0] / pixel[1],
            [false, true] => pixel[1] / pixel[0],
            _ => 1.0,
        };
        let coupling = if slenderness < 1.0 { (COUPLING * slenderness) as f32 } else { 1.0 };
        Self { transfer, capacity, coupling, weight: zeros(), value: zeros() }
    }

    /// Rows of this level that one task handles: about a fixed number of fine pixels.
    pub(crate) fn rows_per_task(&self) -> usize {
        (TASK / (self.transfer.fine[1] * self.transfer.rows_per_coarse_row())).max(1)
    }

    pub(super) fn pull<W: FilledPart>(&mut self, w: &[W], v: &[f32]) {
        let (t, capacity, rows) = (self.transfer, self.capacity, self.rows_per_task());
        let (fine, coarse) = (rows * t.rows_per_coarse_row() * t.fine[1], rows * t.coarse[1]);
        let here = self.weight.par_chunks_mut(coarse).zip(self.value.par_chunks_mut(coarse));
        if t.has_cut_cells() {
            here.enumerate().for_each(|(task, (weight, value))| {
                vectorised!(pull_cut_rows(&t, capacity, task * rows, w, v, weight, value));
            });
        } else {
            let below = w.par_chunks(fine).zip(v.par_chunks(fine));
            below.zip(here).for_each(|((w, v), (weight, value))| {
                vectorised!(pull_rows(&t, capacity, w, v, weight, value));
            });
        }
    }

    /// Lets the cells lean less on their neighbours.
    fn uncouple(&mut self) {
        if self.coupling < 1.0 {
            for w in self.weight.iter_mut().filter(|w| **w > 0.0) {
                *w /= *w + self.coupling * (1.0 - *w);
            }
        }
    }

    /// Changes the values row by row: `change(row, weights, values)`.
    fn change_rows(&mut self, change: impl Fn(usize, &[f32], &mut [f32]) + Sync) {
        let nx = self.transfer.coarse[1];
        let rows = (TASK / nx).max(1);
        let values = self.value.par_chunks_mut(rows * nx);
        values.zip(self.weight.par_chunks(rows * nx)).enumerate().for_each(|(task, (x, w))| {
            vectorised!(for (i, (x, w)) in
                x.chunks_exact_mut(nx).zip(w.chunks_exact(nx)).enumerate()
            {
                change(task * rows + i, w, x);
            });
        });
    }

    /// `x_l = w_l v_l + (1 - w_l) up(x_(l+1))` in place.
    fn push(&mut self, coarser: &Self) {
        self.change_rows(
            #[inline(always)]
            |i, weight, value| {
                coarser.transfer.up_row(
                    i,
                    &coarser.value,
                    #[inline(always)]
                    |ix, up| {
                        for ((x, w), up) in value[ix..].iter_mut().zip(&weight[ix..]).zip(up) {
                            *x = w * *x + (1.0 - w) * up;
                        }
                    },
                );
            },
        );
    }

    /// `up^T` of a field on the next finer grid, of which `add(first, factor, line)` adds `factor`
    /// times the values from that pixel on.
    pub(super) fn hand_up(&mut self, add: impl Fn(usize, f32, &mut [f32]) + Sync) {
        let (t, rows, mx) = (self.transfer, self.rows_per_task(), self.transfer.coarse[1]);
        self.value.par_chunks_mut(rows * mx).enumerate().for_each(|(task, value)| {
            vectorised!(for (j, out) in value.chunks_exact_mut(mx).enumerate() {
                t.up_transposed_row(
                    task * rows + j,
                    out,
                    #[inline(always)]
                    |first, factor, line| add(first, factor, line),
                );
            });
        });
    }

    /// `x_(l+1) = up^T ((1 - w_l) x_l)`.
    fn gather<W: FilledPart>(&mut self, w: &[W], x: &[f32]) {
        self.hand_up(
            #[inline(always)]
            |first, factor, line| {
                let (w, x) = (&w[first..][..line.len()], &x[first..][..line.len()]);
                for ((l, w), x) in line.iter_mut().zip(w).zip(x) {
                    *l += factor * (1.0 - w.value()) * x;
                }
            },
        );
    }

    /// `w_l d_l` of cells of these weights, times `x`.
    #[inline(always)]
    fn weigh(capacity: Capacity, coupling: f32, weight: &[f32], x: &mut [f32]) {
        if coupling < 1.0 {
            for (x, w) in x.iter_mut().zip(weight) {
                // The weight before the cells were uncoupled is w over this.
                let less = (1.0 - (1.0 - coupling) * w) / coupling;
                *x *= if *w > 0.0 { less * capacity.per_filled(w / less) } else { 0.0 };
            }
            return;
        }
        for (x, w) in x.iter_mut().zip(weight) {
            *x *= if *w > 0.0 { capacity.per_filled(*w) } else { 0.0 };
        }
    }

    /// `v_l = w_l (x_l + down^T (d_(l+1) v_(l+1)))`, stored times `d_l`, in place.
    fn scatter(&mut self, coarser: Option<&Self>) {
        let (capacity, coupling) = (self.capacity, self.coupling);
        self.change_rows(
            #[inline(always)]
            |i, weight, value| {
                match coarser {
                    Some(Self { transfer: t, value: above, .. }) if t.has_cut_cells() => {
                        t.add_down_row_of_transposed(i, above, value);
                    }
                    Some(Self { transfer: t, value: above, .. }) => {
                        t.add_down_transposed(i, 0, above, value);
                    }
                    None => {}
                }
                Self::weigh(capacity, coupling, weight, value);
            },
        );
    }
}

/// Pulls the fine rows `w` and `v` into the coarse rows that cover them.
#[inline(always)]
pub(crate) fn pull_rows<W: FilledPart>(
    t: &Transfer,
    capacity: Capacity,
    w: &[W],
    v: &[f32],
    weight: &mut [f32],
    value: &mut [f32],
) {
    let (nx, mx) = (t.fine[1], t.coarse[1]);
    let fine = t.rows_per_coarse_row() * nx;
    let coarse = weight.chunks_exact_mut(mx).zip(value.chunks_exact_mut(mx));
    for ((w, v), (weight, value)) in w.chunks(fine).zip(v.chunks(fine)).zip(coarse) {
        // Two rows, or the single one twice.
        let last = w.len() - nx;
        t.down_row([&w[..nx], &w[last..]], [&v[..nx], &v[last..]], weight, value);
        let share = if t.halved[0] && last == 0 { 0.5 } else { 1.0 };
        for (w, v) in weight.iter_mut().zip(value) {
            let m = share * *w;
            *v *= share * inverse(m);
            *w = capacity.of(m);
        }
    }
}

/// Pulls the finer level `w`, `v` into the coarse rows from `first` on, where cells cut pixels.
#[inline(always)]
fn pull_cut_rows<W: FilledPart>(
    t: &Transfer,
    capacity: Capacity,
    first: usize,
    w: &[W],
    v: &[f32],
    weight: &mut [f32],
    value: &mut [f32],
) {
    let mx = t.coarse[1];
    let lines = weight.chunks_exact_mut(mx).zip(value.chunks_exact_mut(mx));
    for (r, (weight, value)) in lines.enumerate() {
        t.down_row_of(
            first + r,
            weight,
            #[inline(always)]
            |from, share, line| {
                let w = &w[from..][..line.len()];
                line.iter_mut().zip(w).for_each(|(l, w)| *l += share * w.value());
            },
        );
        t.down_row_of(
            first + r,
            value,
            #[inline(always)]
            |from, share, line| {
                let w = w[from..][..line.len()].iter();
                let fields = line.iter_mut().zip(w.zip(&v[from..]));
                fields.for_each(|(l, (w, v))| *l += share * w.value() * v);
            },
        );
        for (w, v) in weight.iter_mut().zip(value) {
            *v *= inverse(*w);
            *w = capacity.of(*w);
        }
    }
}

/// Row `i` of the field extended on the finest grid.
#[inline(always)]
fn push_finest_row(
    t: &Transfer,
    i: usize,
    nodes: &[NodeState],
    r: &[f32],
    coarse: &[f32],
    x: &mut [f32],
) {
    t.up_row(
        i,
        coarse,
        #[inline(always)]
        |ix, up| {
            let fields = x[ix..].iter_mut().zip(&nodes[ix..]).zip(&r[ix..]);
            for (((x, m), r), up) in fields.zip(up) {
                *x = r + (1.0 - m.value()) * up; // r is 0 off F: an `if` would choose between addresses
            }
        },
    );
}

/// The levels above the finest grid, finest first; on a grid of at most 4 x 4 one with the same
/// cells, which knows nothing that the grid does not.
pub(crate) struct Pyramid {
    pub(crate) levels: Vec<PyramidLevel>,
}

impl Pyramid {
    /// For a grid of `shape` pixels of size `pixel`. At each level every axis is halved whose
    /// pixel is below [`ALIKE`] times the finest of the axes that still have more than one cell, until
    /// no axis has more than 4 cells.
    pub(crate) fn new(shape: [usize; 2], pixel: [f64; 2]) -> Self {
        let (mut n, mut d) = (shape, pixel);
        let mut levels = Vec::new();
        let is_large = |n: [usize; 2]| n[0].max(n[1]) > 4;
        while levels.is_empty() || is_large(n) {
            let divisible = |a: usize| if n[a] > 1 { d[a] } else { f64::INFINITY };
            let finest = divisible(0).min(divisible(1));
            let halved = [0, 1].map(|a| is_large(n) && n[a] > 1 && d[a] < ALIKE * finest);
            // The sweep needs nodes of the finest grid that belong to one cell each.
            let transfer = Transfer::new(n, halved, !levels.is_empty());
            for axis in 0..2 {
                if halved[axis] {
                    d[axis] *= 2.0;
                }
            }
            n = transfer.coarse;
            levels.push(PyramidLevel::new(transfer, d));
        }
        Self { levels }
    }

    /// Weights of the set of all nodes of the finest grid. Nothing is left for `E^T` to hand up: the values of the first
    /// level are 0.
    pub(crate) fn know_all(&mut self) {
        let first = &mut self.levels[0];
        let (t, capacity) = (first.transfer, first.capacity);
        let share = |i: usize, a: usize| {
            let lacks = t.halved[a] && 2 * i + 1 == t.fine[a];
            if lacks { 0.5 } else { 1.0 }
        };
        let mx = t.coarse[1];
        first.weight.par_chunks_mut(mx).enumerate().for_each(|(j, weight)| {
            let rows = share(j, 0);
            weight.fill(capacity.of(rows));
            weight[mx - 1] = capacity.of(rows * share(mx - 1, 1));
        });
        first.value.fill(0.0);
        self.pull_above();
    }

    /// Brings the weights of all levels up to date with those of the first; with its values, means of them.
    pub(crate) fn pull_above(&mut self) {
        for l in 1..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(l);
            coarser[0].pull(&finer[l - 1].weight, &finer[l - 1].value);
            coarser[0].uncouple();
        }
    }

    /// Pulls and pushes: from weights and values of the first level to the extended field on it.
    pub(crate) fn extend_above(&mut self) {
        self.pull_above();
        let top = self.levels.last_mut().expect("there is one at least");
        for (x, w) in top.value.iter_mut().zip(&top.weight) {
            *x *= w;
        }
        for l in (1..self.levels.len()).rev() {
            let (finer, coarser) = self.levels.split_at_mut(l);
            finer[l - 1].push(&coarser[0]);
        }
    }

    /// `E` on the finest grid: the residual on F, what the pyramid knows elsewhere; with the means over
    /// the cells of `S`.
    pub(crate) fn push(
        &self,
        nodes: &[NodeState],
        residual: &[f32],
        stiffness: &mut Stiffness,
        extended: &mut [f32],
    ) {
        let first = &self.levels[0];
        let nx = first.transfer.fine[1];
        stiffness.fill(extended, |i, x| {
            let (nodes, r) = (&nodes[i * nx..][..nx], &residual[i * nx..][..nx]);
            vectorised!(push_finest_row(&first.transfer, i, nodes, r, &first.value, x));
        });
    }

    /// `E^T` of a field on the finest grid, but for the last step down to it.
    pub(crate) fn restrict(&mut self, nodes: &[NodeState], field: &[f32]) {
        self.levels[0].gather(nodes, field);
        self.restrict_above();
    }

    /// The transpose: from the values gathered on the first level, to those that `down^T` hands
    /// to the finest grid.
    pub(crate) fn restrict_above(&mut self) {
        for l in 1..self.levels.len() {
            let (finer, coarser) = self.levels.split_at_mut(l);
            coarser[0].gather(&finer[l - 1].weight, &finer[l - 1].value);
        }
        for l in (0..self.levels.len()).rev() {
            let (finer, coarser) = self.levels.split_at_mut(l + 1);
            finer[l].scatter(coarser.first());
        }
    }
}
