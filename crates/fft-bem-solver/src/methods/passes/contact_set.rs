//! Level of the flat, contact set and residual of an iterate.

use super::step;
use super::sums::{Largest, Sum, TILE};
use crate::Real;
use crate::methods::ceiling::Ceiling;
use crate::methods::extension::{Pyramid, pull_rows};
use crate::methods::node::NodeState;
use crate::methods::transfer::FilledPart;
use crate::row_work::{Partial, TASK, total};
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;

/// The level of the flat under a pressure: the plain mean of `u - h` over its contact, `p > 0`.
pub(crate) fn level<T: Real>(p: &[T], u: &[T], h: &[T], partial: &mut [Partial]) -> f64 {
    let used = p.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(p.par_chunks(TASK))
        .zip(u.par_chunks(TASK))
        .zip(h.par_chunks(TASK))
        .for_each(|(((partial, p), u), h)| *partial = contact_sums(p, u, h));
    level_of_sums(&partial[..used])
}

/// The same from the sums over all pieces.
pub(crate) fn level_of_sums(partial: &[Partial]) -> f64 {
    let [sum, contact] = total(partial);
    sum / contact.max(1.0)
}

/// Sum over the contact (`p > 0`) of `u - h`, and its number of nodes.
fn contact_sums<T: Real>(p: &[T], u: &[T], h: &[T]) -> Partial {
    vectorised!(x => step::contact_sums(x, p, u, h))
}

/// The level of the flat under a pressure with a ceiling: that at which the gap has no mean over the
/// nodes that have still to give way, those between the bounds, those at the ceiling that stand off and
/// those without load that overlap. Where there is none, any level is right that parts the loaded from
/// the others, and this one does. The sums it searches by Newton's method fall as the level rises.
pub(crate) fn level_under<T: Real, C: Ceiling<T>>(
    ceiling: C,
    [p, u, h]: [&[T]; 3],
    partial: &mut [Partial],
) -> f64 {
    let sums = |level: Option<f64>, partial: &mut [Partial]| -> [f64; 4] {
        let used = p.len().div_ceil(TASK);
        partial[..used]
            .par_iter_mut()
            .zip(p.par_chunks(TASK))
            .zip(u.par_chunks(TASK).zip(h.par_chunks(TASK)))
            .enumerate()
            .for_each(|(task, ((partial, p), (u, h)))| {
                let ceiling = ceiling.after(task * TASK);
                vectorised!(_vectors => {
                    let (mut sum, mut count, mut full, mut its_sum) = (0.0, 0.0, 0.0, 0.0);
                    for (i, ((p, u), h)) in p.iter().zip(u).zip(h).enumerate() {
                        let rise = (*u - *h).wide();
                        let (is_loaded, is_full) = (*p > T::zero(), ceiling.is_reached(i, *p));
                        let counts = match level {
                            Some(level) if !is_loaded => rise < level,
                            Some(level) if is_full => rise > level,
                            _ => is_loaded & !is_full,
                        };
                        sum += if counts { rise } else { 0.0 };
                        count += f64::from(u8::from(counts));
                        its_sum += if is_full { rise } else { 0.0 };
                        full += f64::from(u8::from(is_full));
                    }
                    *partial = [sum, count, its_sum, full, 0.0, 0.0, 0.0, 0.0];
                });
            });
        total(&partial[..used])
    };
    let [sum, count, full_sum, full] = sums(None, partial);
    let mut level = if count > 0.0 { sum / count } else { full_sum / full.max(1.0) };
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    for _ in 0..NEWTON_STEPS {
        let [sum, count, ..] = sums(Some(level), partial);
        if count <= 0.0 {
            break;
        }
        let next = sum / count;
        if next > level {
            low = level;
        } else if next < level {
            high = level;
        } else {
            break;
        }
        level = if next > low && next < high { next } else { 0.5 * (low + high) };
    }
    level
}

/// Most steps of it; a few are enough.
const NEWTON_STEPS: usize = 60;

/// Where the gap comes from.
#[derive(Clone, Copy)]
pub(crate) enum GapSource<'a, T> {
    /// It is `u - h - level`.
    Of { u: &'a [T], h: &'a [T], level: f64 },
    /// The residual field holds it, but for this constant to be taken off.
    Known { excess: f64 },
}

/// The set F.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactSet {
    /// Its nodes.
    pub(crate) size: usize,
    /// Whether nodes outside F carry load, or less than the ceiling that they are to carry.
    pub(crate) has_released: bool,
}

/// The set `F = {p > release max(g, 0)} or {g < 0}`, the residual g on it, and the first level of the
/// pyramid over it. With `closing`, how much the next step will lower the gap where it is not in
/// contact yet, nodes that it would make overlap, `g <= closing`, belong to F.
///
/// Under a ceiling H a node must also be pressed less than that, `H - p > release max(-g, 0)`, or stand
/// off, `g > 0`.
#[allow(clippy::too_many_arguments, reason = "a pass over nine fields")]
pub(crate) fn residual<T: Real, C: Ceiling<T>>(
    ceiling: C,
    p: &[T],
    gap: GapSource<'_, T>,
    release: f64,
    closing: Option<&[f32]>,
    [rows, nx]: [usize; 2],
    nodes: &mut [NodeState],
    residual: &mut [f32],
    pyramid: &mut Pyramid,
    partial: &mut [Partial],
) -> ContactSet {
    let chunk = rows * nx;
    let used = p.len().div_ceil(chunk);
    let classify = Classify { ceiling, gap, release, closing };
    let fields = partial[..used]
        .par_iter_mut()
        .zip(p.par_chunks(chunk))
        .zip(nodes.par_chunks_mut(chunk))
        .zip(residual.par_chunks_mut(chunk));
    match pyramid.levels.first_mut() {
        None => fields.enumerate().for_each(|(task, (((partial, p), m), r))| {
            *partial = vectorised!(classify.nodes(task * chunk, p, m, r));
        }),
        Some(first) => {
            let (t, capacity) = (first.transfer, first.capacity);
            let coarse = chunk / (t.rows_per_coarse_row() * nx) * t.coarse[1];
            fields
                .zip(first.weight.par_chunks_mut(coarse))
                .zip(first.value.par_chunks_mut(coarse))
                .enumerate()
                .for_each(|(task, (((((partial, p), m), r), weight), value))| {
                    vectorised!({
                        *partial = classify.nodes(task * chunk, p, m, r);
                        pull_rows(&t, capacity, m, r, weight, value);
                    });
                });
        }
    }
    let [active, released] = total(&partial[..used]);
    ContactSet { size: active as usize, has_released: released > 0.0 }
}

/// What decides whether a node belongs to F.
#[derive(Clone, Copy)]
struct Classify<'a, T, C> {
    ceiling: C,
    gap: GapSource<'a, T>,
    release: f64,
    closing: Option<&'a [f32]>,
}

/// Nodes looked at together.
const BLOCK: usize = 256;

impl<T: Real, C: Ceiling<T>> Classify<'_, T, C> {
    /// Marks the nodes from pixel `first` on and leaves the gap on those of F. Returns how many these
    /// are, and how many carry load but do not belong. In single precision, as the gap is.
    #[inline(always)]
    fn nodes(&self, first: usize, p: &[T], nodes: &mut [NodeState], gap: &mut [f32]) -> Partial {
        let release = self.release as f32;
        let blocks = p.chunks(BLOCK).zip(nodes.chunks_mut(BLOCK)).zip(gap.chunks_mut(BLOCK));
        let (mut active, mut released) = (0, 0);
        let (mut load, mut is_in) = ([0.0; BLOCK], [0.0; BLOCK]);
        for (k, ((p, nodes), g)) in blocks.enumerate() {
            let first = first + k * BLOCK;
            let [load, is_in] = [&mut load, &mut is_in].map(|x| &mut x[..p.len()]);
            match self.gap {
                GapSource::Of { u, h, level } => {
                    gap_of(&u[first..][..p.len()], &h[first..][..p.len()], T::of(level), g);
                }
                GapSource::Known { excess } => g.iter_mut().for_each(|g| *g -= excess as f32),
            }
            load.iter_mut().zip(p).for_each(|(load, p)| *load = p.narrow());
            for ((is_in, load), g) in is_in.iter_mut().zip(&*load).zip(&*g) {
                let open = if *g > 0.0 { *g } else { 0.0 };
                *is_in = if (*load > release * open) | (*g < 0.0) { 1.0 } else { 0.0 };
            }
            nodes.iter_mut().zip(&*is_in).for_each(|(m, is_in)| *m = NodeState::of(*is_in > 0.0));
            let ceiling = self.ceiling.after(first);
            if C::IS_FINITE {
                for (i, ((m, p), g)) in nodes.iter_mut().zip(p).zip(&*g).enumerate() {
                    let room = ceiling.at(i) - *p;
                    let yields = room <= T::of(self.release * f64::from((-g).max(0.0)));
                    *m = m.or(NodeState::Full, yields & (*g <= 0.0));
                }
            }
            if let Some(closing) = self.closing {
                for ((m, e), g) in nodes.iter_mut().zip(&closing[first..]).zip(&*g) {
                    *m = m.or(
                        NodeState::Contact,
                        (g <= e) & !(C::IS_FINITE && *m == NodeState::Full),
                    );
                }
            }
            if C::IS_FINITE || self.closing.is_some() {
                is_in.iter_mut().zip(&*nodes).for_each(|(is_in, m)| *is_in = m.value());
            }
            for (g, is_in) in g.iter_mut().zip(&*is_in) {
                *g = if *is_in > 0.0 { *g } else { 0.0 };
            }
            for ((m, load), is_in) in nodes.iter_mut().zip(&*load).zip(&*is_in) {
                let is_off = (*load > 0.0) & (*is_in <= 0.0) & !(C::IS_FINITE && m.is_full());
                *m = m.or(NodeState::Released, is_off);
            }
            active += nodes.iter().map(|m| u32::from(m.is_in())).sum::<u32>();
            released += nodes.iter().map(|m| u32::from(*m == NodeState::Released)).sum::<u32>();
            if C::IS_FINITE {
                for (i, (m, p)) in nodes.iter_mut().zip(p).enumerate() {
                    let top = ceiling.at(i);
                    let is_filled = m.is_full() & ((*p < top) | (*p > top));
                    *m = m.or(NodeState::Filled, is_filled);
                    released += u32::from(is_filled);
                }
            }
        }
        [f64::from(active), f64::from(released), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    }
}

/// `g = u - h - level`.
#[inline(always)]
fn gap_of<T: Real>(u: &[T], h: &[T], level: T, gap: &mut [f32]) {
    for ((g, u), h) in gap.iter_mut().zip(u).zip(h) {
        *g = (*u - *h - level).narrow();
    }
}

/// `|g|^2` on F.
pub(crate) fn residual_norm2<T: Real>(
    [u, h]: [&[T]; 2],
    level: f64,
    nodes: &[NodeState],
    partial: &mut [Partial],
) -> f64 {
    let level = T::of(level);
    let square = |from: usize, u: &[T]| -> Partial {
        let (mut sum, mut gap) = (Sum::default(), [0.0; TILE]);
        vectorised!({
            let tiles = u.chunks(TILE).zip(h[from..].chunks(TILE)).zip(nodes[from..].chunks(TILE));
            for ((u, h), m) in tiles {
                for (((g, u), h), m) in gap.iter_mut().zip(u).zip(h).zip(m) {
                    *g = f64::from(u8::from(m.is_in())) * (*u - *h - level).wide();
                }
                sum.add_product(&gap[..u.len()], &gap[..u.len()]);
            }
        });
        [sum.total(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    };
    super::pieces::sums(u, &square, partial)[0]
}

/// Whether the residual on F is no more than the rounding of the fields it is a difference of.
pub(crate) fn is_rounding<T: Real>(
    [u, h]: [&[T]; 2],
    level: f64,
    nodes: &[NodeState],
    partial: &mut [Partial],
) -> bool {
    let level = T::of(level);
    let used = u.len().div_ceil(TASK);
    partial[..used]
        .par_iter_mut()
        .zip(u.par_chunks(TASK))
        .zip(h.par_chunks(TASK))
        .zip(nodes.par_chunks(TASK))
        .for_each(|(((partial, u), h), m)| {
            let (mut largest, mut room) = ([Largest::default(); 3], [[0.0; TILE]; 3]);
            vectorised!({
                let tiles = u.chunks(TILE).zip(h.chunks(TILE)).zip(m.chunks(TILE));
                for ((u, h), m) in tiles {
                    let n = u.len().min(TILE);
                    let [gap, rise, height] = room.each_mut().map(|x| &mut x[..n]);
                    for i in 0..n {
                        let on = f64::from(u8::from(m[i].is_in()));
                        gap[i] = on * (u[i] - h[i] - level).wide().abs();
                        rise[i] = u[i].wide().abs();
                        height[i] = on * h[i].wide().abs();
                    }
                    largest[0].take(gap);
                    largest[1].take(rise);
                    largest[2].take(height);
                }
            });
            partial[..3].copy_from_slice(&largest.map(Largest::total));
        });
    let largest = |k: usize| partial[..used].iter().fold(0.0_f64, |m, x| m.max(x[k]));
    largest(0) <= 2.0 * T::EPSILON * (largest(1) + largest(2))
}
