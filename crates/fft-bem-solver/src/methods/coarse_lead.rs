//! The first trial from a coarser grid: the surface averaged over blocks of 4 x 4 pixels, solved
//! to a third, or to a tenth if it has to find the load as well, and interpolated. It costs 0.1 to 0.15 pairs and saves one to three.

use super::chord::Chord;
use super::stiffness::relative_cost;
use super::transfer::Transfer;
use super::{Start, State, Target, Task};
use crate::problem::{Problem, Units};
use crate::{HalfSpace, Real, fields};
use contact_types::{ContactModulus, Grid};
use grid_fft::parallel::prelude::*;
use std::ops::ControlFlow;

/// An axis with fewer pixels is not coarsened.
const SHORTEST: usize = 128;
/// Accuracy to which the coarse problem is solved.
const TOLERANCE: f64 = 0.3;
/// The same where the load has to be found as well.
const TOLERANCE_OF_LOAD: f64 = 0.1;
/// Iterations it may take.
const ITERATIONS: usize = 12;

/// A solver on the coarser grid.
pub(crate) struct CoarseLead<T: Real> {
    /// From the grid to half its size, and from there to a quarter.
    transfers: [Transfer; 2],
    /// Finer pixel side of the coarse grid, in those of the grid.
    unit: f64,
    relative_cost: f64,
    chord: Chord<T>,
    half_space: HalfSpace<T>,
    problem: Problem<T>,
    state: State<T>,
}

/// What the coarse grid gave.
pub(crate) struct Found {
    /// Mean pressure of the guess; `None` if there is no guess.
    pub(crate) load: Option<f64>,
    /// Cost in pairs of the fine grid.
    pub(crate) transforms: f64,
}

impl<T: Real> CoarseLead<T> {
    /// For a grid whose finer pixel side is 1; `None` if it is too small.
    pub(crate) fn new(scaled: Grid) -> Option<Self> {
        let halved = scaled.shape().map(|n| n >= SHORTEST);
        if halved == [false, false] {
            return None;
        }
        let first = Transfer::new(scaled.shape(), halved).with_cut_cells();
        let second = Transfer::new(first.coarse, halved).with_cut_cells();
        let mut pixel = scaled.pixel();
        for axis in 0..2 {
            pixel[axis] *= scaled.shape()[axis] as f64 / second.coarse[axis] as f64;
        }
        let grid = Grid::new(second.coarse, pixel).ok()?;
        let unit = crate::problem::fine_pixel(grid);
        let grid = Grid::new(second.coarse, pixel.map(|d| d / unit)).ok()?;
        let n = grid.len();
        let problem = Problem {
            grid,
            heights: vec![T::zero(); n],
            mean_height: 0.0,
            units: Units { origin: 0.0, height: 1.0, pressure: 1.0 },
        };
        let modulus = ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus");
        Some(Self {
            transfers: [first, second],
            unit,
            relative_cost: relative_cost(second.coarse, scaled.shape()),
            chord: Chord::new(grid),
            half_space: HalfSpace::new(grid, modulus),
            problem,
            state: State::new(n),
        })
    }

    /// Solves the averaged problem and writes pressure and displacement to `guess`.
    pub(crate) fn find(
        &mut self,
        task: &Task<'_, T>,
        load: f64,
        guess: (&mut [T], &mut [T]),
    ) -> Found {
        let none = |transforms| Found { load: None, transforms };
        self.average(&task.problem.heights);
        let highest = fields::max(&self.problem.heights);
        let shift = T::of(highest);
        for h in &mut self.problem.heights {
            *h -= shift;
        }
        if fields::min(&self.problem.heights) >= 0.0 {
            return none(0.0); // nothing is left of the roughness
        }
        self.problem.mean_height =
            fields::sum(&self.problem.heights) / self.problem.heights.len() as f64;
        let target = match task.target {
            Target::Pressure(_) => Target::Pressure(load * self.unit),
            Target::Level(level, _) => {
                // The same mean gap.
                let mean_gap = -level - task.problem.mean_height;
                let level = -mean_gap - self.problem.mean_height;
                if level <= 0.0 {
                    return none(0.0);
                }
                Target::Level(level, load * self.unit)
            }
        };
        let tolerance = match target {
            Target::Pressure(_) => TOLERANCE,
            Target::Level(..) => TOLERANCE_OF_LOAD,
        };
        let coarse = Task { problem: &self.problem, target, tolerance, max_iterations: ITERATIONS };
        let outcome = self.chord.solve_quietly(&coarse, &mut self.half_space, &mut self.state);
        let transforms = outcome.transforms * self.relative_cost;
        let (p, u) = guess;
        self.interpolate(&self.state.pressure, 1.0 / self.unit, p);
        self.interpolate(&self.state.displacement, 1.0, u);
        let reached = fields::sum(p) / p.len() as f64;
        if reached.is_nan() || reached <= 0.0 {
            return none(transforms);
        }
        let load = match task.target {
            Target::Pressure(load) => {
                super::passes::scale(load / reached, p);
                super::passes::scale(load / reached, u);
                load
            }
            Target::Level(..) => reached,
        };
        Found { load: Some(load), transforms }
    }

    /// Heights of the coarse grid: repeated means over the children.
    fn average(&mut self, heights: &[T]) {
        let half = means(&self.transfers[0], heights);
        self.problem.heights = means(&self.transfers[1], &half);
    }

    /// Linear interpolation to the fine grid, times `factor`.
    fn interpolate(&self, coarse: &[T], factor: f64, fine: &mut [T]) {
        let narrow: Vec<f32> = coarse.iter().map(|x| (factor * x.wide()) as f32).collect();
        let [first, second] = &self.transfers;
        let [hy, hx] = first.coarse;
        let mut half = vec![0.0_f32; hy * hx];
        for (i, row) in half.chunks_exact_mut(hx).enumerate() {
            second.up_row(i, &narrow, |ix, v| row[ix..ix + v.len()].copy_from_slice(v));
        }
        let nx = first.fine[1];
        fine.par_chunks_mut(nx).enumerate().for_each(|(i, row)| {
            first.up_row(i, &half, |ix, values| {
                for (x, v) in row[ix..].iter_mut().zip(values) {
                    *x = T::of(f64::from(*v));
                }
            });
        });
    }
}

/// Means over the cells.
fn means<T: Real>(t: &Transfer, fine: &[T]) -> Vec<T> {
    let ([_, nx], [my, mx]) = (t.fine, t.coarse);
    let mut out = vec![T::zero(); my * mx];
    out.par_chunks_mut(mx).enumerate().for_each(|(j, row)| {
        let mut line = vec![0.0_f32; mx];
        t.down_row_of(j, &mut line, |iy, share, ix, line| {
            let x = &fine[iy * nx + ix..][..line.len()];
            line.iter_mut().zip(x).for_each(|(l, x)| *l += share * x.narrow());
        });
        row.iter_mut().zip(line).for_each(|(x, l)| *x = T::of(f64::from(l)));
    });
    out
}

impl<T: Real> Chord<T> {
    fn solve_quietly(
        &mut self,
        task: &Task<'_, T>,
        half_space: &mut HalfSpace<T>,
        state: &mut State<T>,
    ) -> super::Outcome {
        use super::ContactMethod;
        self.solve(task, half_space, Start::Cold, state, &mut |_| ControlFlow::Continue(()))
    }
}
