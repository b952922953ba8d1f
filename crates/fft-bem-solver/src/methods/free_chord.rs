//! The chord iteration for the free boundary.
//!
//! `E^T S E` is made for a periodic half space. It serves an isolated contact if the copies of the map are kept
//! apart: the iteration runs on a grid a quarter larger along each axis, whose additional pixels lie too deep to
//! touch. The displacement is that of the free half space, computed on the map alone. Where the map is much longer
//! than wide, `S` is made from the kernel of the free half space itself.

use super::ceiling::{Ceiling, under};
use super::chord::Chord;
use super::compliance::Compliance;
use super::contract::{
    ContactMethod, ContactTask, IterateView, Means, Outcome, Start, State, Target,
};
use crate::problem::Problem;
use crate::{Boundary, End, Real, SolverError, fields};
use contact_types::Grid;

/// Height of the pixels around the map; those of the map lie between -1 and 0.
const DEPTH: f64 = -2.0;
/// A map that is more times longer than wide has its copies nearer than its own ends: the padding does
/// not keep them apart, and a kernel that knows of no copies must.
const SLENDER: f64 = 2.0;

pub(crate) struct FreeChord<T: Real> {
    chord: Chord<T>,
    map: [usize; 2],
    problem: Problem<T>,
    state: State<T>,
    on_map: State<T>,
}

impl<T: Real> FreeChord<T> {
    pub(crate) fn new(scaled: Grid) -> Result<Self, SolverError> {
        let map = scaled.shape();
        let shape = map.map(|n| if n == 1 { 1 } else { n + n.div_ceil(4) });
        let grid = Grid::new(shape, scaled.pixel()).map_err(|_| SolverError::Range {
            quantity: "number of pixels",
            value: scaled.len() as f64,
            way_out: "choose the method polonsky-keer or a coarser map",
        })?;
        let n = grid.len();
        let [height, width] = scaled.size();
        let is_slender = (height / width).max(width / height) > SLENDER;
        Ok(Self {
            chord: Chord::new(grid, is_slender),
            map,
            problem: Problem::unscaled(grid, vec![T::of(DEPTH); n]),
            state: State::new(n),
            on_map: State::new(scaled.len()),
        })
    }
}

/// Copies a map of `[ny, nx]` into rows of `stride`, the rest of `to` takes `around`.
fn embed<T: Real>([_, nx]: [usize; 2], from: &[T], around: T, stride: usize, to: &mut [T]) {
    let mut rows = from.chunks_exact(nx);
    for to in to.chunks_exact_mut(stride) {
        match rows.next() {
            Some(from) => {
                to[..nx].copy_from_slice(from);
                to[nx..].fill(around);
            }
            None => to.fill(around),
        }
    }
}

/// Copies the map out of the larger grid.
fn cut<T: Real>([_, nx]: [usize; 2], from: &[T], stride: usize, to: &mut [T]) {
    for (to, from) in to.chunks_exact_mut(nx).zip(from.chunks_exact(stride)) {
        to.copy_from_slice(&from[..nx]);
    }
}

/// The free half space under the map, on fields of the larger grid. Pixels around the map are given
/// a displacement above all others: they carry nothing, and nothing depends on it but that no
/// overlap is seen there.
struct Around<'a, T> {
    inner: &'a mut dyn Compliance<T>,
    map: [usize; 2],
    stride: usize,
    buffer: &'a mut State<T>,
}

impl<T: Real> Compliance<T> for Around<'_, T> {
    fn apply(&mut self, pressure: &[T], displacement: &mut [T]) {
        let State { pressure: p, displacement: u, .. } = self.buffer;
        cut(self.map, pressure, self.stride, p);
        self.inner.apply(p, u);
        let around = T::of(1.5 * fields::max(u).max(0.0));
        embed(self.map, u, around, self.stride, displacement);
    }
    fn invert(&mut self, _field: &mut [T]) -> bool {
        false
    }
    fn boundary(&self) -> Boundary {
        Boundary::Free
    }
}

impl<T: Real> ContactMethod<T> for FreeChord<T> {
    fn solve(&mut self, task: &ContactTask<'_, T>, means: Means<'_, '_, T>) -> Outcome {
        let Means { operator, state, watch } = means;
        let (map, stride) = (self.map, self.problem.grid.shape()[1]);
        let share = state.pressure.len() as f64 / self.state.pressure.len() as f64;
        let depth = T::of(DEPTH);
        embed(map, &task.problem.heights, depth, stride, &mut self.problem.heights);
        let Target::Pressure(load) = task.target else {
            unreachable!("an isolated contact has no mean gap to prescribe")
        };
        // The pressure begins as constant on the map, and K is not known to make nothing of it.
        // Nor may what stood near the ceiling be scaled beyond it.
        let factor = load * state.pressure.len() as f64 / fields::sum(&state.pressure);
        let is_beyond = under!(task.ceiling, top => top.is_passed(factor, &state.pressure));
        let is_begun = task.start == Start::Cold || is_beyond;
        let transforms = if is_begun { state.fill(load, operator) } else { 0.0 };
        let around = T::of(1.5 * fields::max(&state.displacement).max(0.0));
        embed(map, &state.pressure, T::zero(), stride, &mut self.state.pressure);
        embed(map, &state.displacement, around, stride, &mut self.state.displacement);
        let target = Target::Pressure(share * load);
        let task = ContactTask { problem: &self.problem, target, start: Start::Warm, ..*task };
        let mut shown = |step: &IterateView<'_, T>| {
            watch(&IterateView { transforms: transforms + step.transforms, ..*step })
        };
        let mut around = Around { inner: operator, map, stride, buffer: &mut self.on_map };
        let means = Means { operator: &mut around, state: &mut self.state, watch: &mut shown };
        let mut outcome = self.chord.solve(&task, means);
        cut(map, &self.state.pressure, stride, &mut state.pressure);
        cut(map, &self.state.displacement, stride, &mut state.displacement);
        state.level = self.state.level;
        outcome.transforms += transforms;
        // Pressure beside the map would be load that is lost.
        let (kept, all) = (fields::sum(&state.pressure), fields::sum(&self.state.pressure));
        if (kept - all).abs() > 1e-6 * all {
            outcome.end = End::Exhausted;
            outcome.residual = f64::INFINITY;
        }
        outcome
    }
}
