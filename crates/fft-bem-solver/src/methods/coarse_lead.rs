//! The first trial from a coarser grid: the surface averaged over blocks of 4 x 4 pixels, of long pixels
//! over fewer of them and more abreast, solved
//! to a third, or to a tenth if it has to find the load as well, and interpolated. It costs 0.1 to 0.15 pairs and saves one to three.

use super::chord::Chord;
use super::stiffness::relative_cost;
use super::transfer::Transfer;
use super::{Start, State, Target, Task, thin_pixels};
use crate::problem::{Problem, Units};
use crate::{HalfSpace, Real, fields};
use contact_types::{ContactModulus, Grid};
use grid_fft::parallel::prelude::*;
use std::ops::ControlFlow;

/// Pixels per coarse cell, no longer than wide: lines of long pixels are not to be mixed.
const CELLS: &thin_pixels::Cells = &[[4, 4], [4, 4], [2, 8], [1, 8]];
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
    /// From the grid to the coarse one, halving by halving.
    transfers: Vec<Transfer>,
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
        let transfers = transfers(scaled);
        let coarse = transfers.last()?.coarse;
        let mut pixel = scaled.pixel();
        for axis in 0..2 {
            pixel[axis] *= scaled.shape()[axis] as f64 / coarse[axis] as f64;
        }
        let grid = Grid::new(coarse, pixel).ok()?;
        let unit = crate::problem::fine_pixel(grid);
        let grid = Grid::new(coarse, pixel.map(|d| d / unit)).ok()?;
        let n = grid.len();
        let problem = Problem {
            grid,
            heights: vec![T::zero(); n],
            mean_height: 0.0,
            units: Units { origin: 0.0, height: 1.0, pressure: 1.0 },
        };
        let modulus = ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus");
        Some(Self {
            transfers,
            unit,
            relative_cost: relative_cost(coarse, scaled.shape()),
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
        let (first, others) = self.transfers.split_first().expect("there is one");
        let once = means(first, heights);
        self.problem.heights = others.iter().fold(once, |x, t| means(t, &x));
    }

    /// Linear interpolation to the fine grid, times `factor`.
    fn interpolate(&self, coarse: &[T], factor: f64, fine: &mut [T]) {
        let mut half: Vec<f32> = coarse.iter().map(|x| (factor * x.wide()) as f32).collect();
        let (first, others) = self.transfers.split_first().expect("there is one");
        for t in others.iter().rev() {
            let [ny, nx] = t.fine;
            let mut finer = vec![0.0_f32; ny * nx];
            for (i, row) in finer.chunks_exact_mut(nx).enumerate() {
                t.up_row(i, &half, |ix, v| row[ix..ix + v.len()].copy_from_slice(v));
            }
            half = finer;
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

/// The halvings that lead to the coarse grid; none if the grid is too small.
fn transfers(scaled: Grid) -> Vec<Transfer> {
    let (shape, pixel) = (scaled.shape(), scaled.pixel());
    let long = [0, 1].map(|a| if shape[a] > 1 { pixel[a] } else { f64::MAX });
    let cell = thin_pixels::cell(long, CELLS);
    let halvings = [0, 1].map(|a| if shape[a] < SHORTEST { 0 } else { cell[a].ilog2() });
    let most = halvings[0].max(halvings[1]);
    let mut transfers: Vec<Transfer> = Vec::new();
    for left in (1..=most).rev() {
        let fine = transfers.last().map_or(shape, |t| t.coarse);
        // The shorter pixel sides first.
        let halved = halvings.map(|h| h >= most + 1 - left);
        transfers.push(Transfer::new(fine, halved).with_cut_cells());
    }
    transfers
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
