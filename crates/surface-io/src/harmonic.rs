//! Laplace's equation on the missing points.
//!
//! ```math
//! \frac{\partial^2 h}{\partial x^2} + \frac{\partial^2 h}{\partial y^2} = 0
//! ```
//!
//! on every missing point, with the valid points as boundary values and no flux across the edge
//! of the map. Conjugate gradients with one multigrid cycle as preconditioner: points are
//! joined two by two (four by four neighbours) into coarser unknowns, whose bonds are rescaled so
//! that they are again the five-point formula of the coarser grid (Braess 1995,
//! doi:10.1007/BF02238481). Any shape of hole is fine, and the work is proportional to the
//! number of missing points. Memory: about 200 bytes per missing point.

use crate::FillError;
use contact_types::Grid;

const NONE: u32 = u32::MAX;
/// Relative residual to reach, and the one beyond which the result is refused.
const TOLERANCE: f64 = 1e-12;
const ACCEPTED: f64 = 1e-8;
const MAX_ITERATIONS: usize = 200;

/// Replaces every NaN. At least one height must be valid.
pub(crate) fn fill(grid: Grid, heights: &mut [f64]) -> Result<(), FillError> {
    let (finest, sums, [low, high]) = GridLevel::finest(grid, heights);
    if low > high {
        return Ok(()); // nothing is missing
    }
    // Heights are counted from the middle of the rim, so that a common offset costs no digits.
    let origin = 0.5 * (low + high);
    let b: Vec<f64> = sums.iter().map(|[s, w]| s - w * origin).collect();
    let mut levels = levels(finest, grid.pixel());
    let x = solve(&mut levels, b)?;
    for (&i, x) in levels[0].cells.iter().zip(x) {
        // The maximum principle holds for the exact solution; rounding must not break it.
        heights[i as usize] = (origin + x).clamp(low, high);
    }
    Ok(())
}

/// One grid: every unknown with its bonds to the west, east, north and south.
struct GridLevel {
    shape: [usize; 2],
    /// Place of every unknown on the grid.
    cells: Vec<u32>,
    neighbours: Vec<[u32; 4]>,
    bonds: Vec<[f64; 4]>,
    /// Bonds to valid points along x and y.
    pins: Vec<[f64; 2]>,
    diagonal: Vec<f64>,
    /// Coarse unknown that each unknown belongs to; empty on the coarsest level.
    parent: Vec<u32>,
    x: Vec<f64>,
    b: Vec<f64>,
}

impl GridLevel {
    fn new(
        shape: [usize; 2],
        cells: Vec<u32>,
        neighbours: Vec<[u32; 4]>,
        bonds: Vec<[f64; 4]>,
        pins: Vec<[f64; 2]>,
    ) -> Self {
        let diagonal =
            bonds.iter().zip(&pins).map(|(w, p)| w.iter().sum::<f64>() + p[0] + p[1]).collect();
        let (x, b, parent) = (vec![0.0; pins.len()], vec![0.0; pins.len()], Vec::new());
        Self { shape, cells, neighbours, bonds, pins, diagonal, parent, x, b }
    }

    /// The five-point formula in flux form: bonds dy/dx along x and dx/dy along y. And of the valid points beside the
    /// holes: per unknown the sums of bond times height and of bonds, and their lowest and highest height.
    fn finest(grid: Grid, heights: &[f64]) -> (Self, Vec<[f64; 2]>, [f64; 2]) {
        let holes = (0..heights.len()).filter(|&i| heights[i].is_nan());
        let holes: Vec<u32> = holes.map(|i| i as u32).collect();
        let [ny, nx] = grid.shape();
        let [dy, dx] = grid.pixel();
        let mut number = vec![NONE; heights.len()];
        for (k, &i) in holes.iter().enumerate() {
            number[i as usize] = k as u32;
        }
        let n = holes.len();
        let mut neighbours = vec![[NONE; 4]; n];
        let (mut bonds, mut pins) = (vec![[0.0; 4]; n], vec![[0.0; 2]; n]);
        let flux = [dy / dx, dx / dy];
        let (mut sums, mut range) = (vec![[0.0; 2]; n], [f64::INFINITY, f64::NEG_INFINITY]);
        for (k, &i) in holes.iter().enumerate() {
            let i = i as usize;
            let (iy, ix) = (i / nx, i % nx);
            let around = [
                (ix > 0).then(|| i - 1),
                (ix + 1 < nx).then(|| i + 1),
                (iy > 0).then(|| i - nx),
                (iy + 1 < ny).then(|| i + nx),
            ];
            for (side, j) in around.into_iter().enumerate() {
                let Some(j) = j else { continue };
                let w = flux[side / 2];
                if number[j] == NONE {
                    pins[k][side / 2] += w;
                    sums[k][0] += w * heights[j];
                    sums[k][1] += w;
                    range = [range[0].min(heights[j]), range[1].max(heights[j])];
                } else {
                    neighbours[k][side] = number[j];
                    bonds[k][side] = w;
                }
            }
        }
        (Self::new([ny, nx], holes, neighbours, bonds, pins), sums, range)
    }

    /// Joins `block = [by, bx]` neighbours into one unknown each.
    fn coarser(&mut self, block: [usize; 2]) -> Self {
        let [ny, nx] = self.shape;
        let coarse = [ny.div_ceil(block[0]), nx.div_ceil(block[1])];
        let mut number = vec![NONE; coarse[0] * coarse[1]];
        let mut coarse_cells = Vec::new();
        self.parent = self
            .cells
            .iter()
            .map(|&cell| {
                let (iy, ix) = (cell as usize / nx, cell as usize % nx);
                let at = iy / block[0] * coarse[1] + ix / block[1];
                if number[at] == NONE {
                    number[at] = coarse_cells.len() as u32;
                    coarse_cells.push(at as u32);
                }
                number[at]
            })
            .collect();
        // A bond across a joined direction spans twice the distance.
        let factor = [if block[1] == 2 { 0.5 } else { 1.0 }, if block[0] == 2 { 0.5 } else { 1.0 }];
        let n = coarse_cells.len();
        let mut neighbours = vec![[NONE; 4]; n];
        let (mut bonds, mut pins) = (vec![[0.0; 4]; n], vec![[0.0; 2]; n]);
        for (k, &parent) in self.parent.iter().enumerate() {
            let c = parent as usize;
            for side in 0..4 {
                let j = self.neighbours[k][side];
                if j != NONE && self.parent[j as usize] != parent {
                    neighbours[c][side] = self.parent[j as usize];
                    bonds[c][side] += factor[side / 2] * self.bonds[k][side];
                }
            }
            pins[c][0] += factor[0] * self.pins[k][0];
            pins[c][1] += factor[1] * self.pins[k][1];
        }
        Self::new(coarse, coarse_cells, neighbours, bonds, pins)
    }

    /// Sum of bonds times neighbours.
    fn pull(&self, x: &[f64], k: usize) -> f64 {
        let pairs = self.bonds[k].iter().zip(&self.neighbours[k]).filter(|(_, j)| **j != NONE);
        pairs.fold(0.0, |sum, (w, &j)| sum + w * x[j as usize])
    }

    /// One Gauss-Seidel sweep on `A x = b`, forwards or backwards.
    fn sweep(&mut self, is_forward: bool) {
        let n = self.b.len();
        let mut x = std::mem::take(&mut self.x);
        for k in 0..n {
            let k = if is_forward { k } else { n - 1 - k };
            x[k] = (self.b[k] + self.pull(&x, k)) / self.diagonal[k];
        }
        self.x = x;
    }
}

/// The finest level and all coarser ones.
fn levels(finest: GridLevel, [dy, dx]: [f64; 2]) -> Vec<GridLevel> {
    let mut levels = vec![finest];
    let (mut wx, mut wy) = (dy / dx, dx / dy);
    while let Some(last) = levels.last_mut().filter(|level| level.b.len() > 32) {
        // Join along the stronger bonds until both directions are alike.
        let side = |n: usize, is_weak: bool| if n == 1 || is_weak { 1 } else { 2 };
        let [ny, nx] = last.shape;
        let block = [side(ny, wx > 3.0 * wy), side(nx, wy > 3.0 * wx)];
        if block == [1, 1] {
            break;
        }
        let level = last.coarser(block);
        let turn = block[0] as f64 / block[1] as f64;
        (wx, wy) = (wx * turn, wy / turn);
        levels.push(level);
    }
    levels
}

/// One W-cycle on level `l`: `x = B b`, symmetric.
fn cycle(levels: &mut [GridLevel]) {
    let [level, coarser @ ..] = levels else { return };
    level.x.fill(0.0);
    if coarser.is_empty() {
        for _ in 0..8 {
            level.sweep(true);
            level.sweep(false);
        }
        return;
    }
    level.sweep(true);
    for turn in 0..2 {
        coarser[0].b.fill(0.0);
        for k in 0..level.b.len() {
            let residual = level.b[k] - level.diagonal[k] * level.x[k] + level.pull(&level.x, k);
            coarser[0].b[level.parent[k] as usize] += residual;
        }
        cycle(coarser);
        for (x, &parent) in level.x.iter_mut().zip(&level.parent) {
            *x += coarser[0].x[parent as usize];
        }
        if turn == 0 {
            level.sweep(false);
            level.sweep(true);
        }
    }
    level.sweep(false);
}

/// Conjugate gradients on the finest level.
fn solve(levels: &mut [GridLevel], b: Vec<f64>) -> Result<Vec<f64>, FillError> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let n = b.len();
    let size = dot(&b, &b).sqrt();
    let (mut x, mut r) = (vec![0.0; n], b);
    if size == 0.0 {
        return Ok(x);
    }
    let (mut p, mut product) = (vec![0.0; n], vec![0.0; n]);
    let (mut rho, mut residual) = (f64::INFINITY, 1.0);
    for _ in 0..MAX_ITERATIONS {
        levels[0].b.copy_from_slice(&r);
        cycle(levels);
        let finest = &levels[0];
        let next = dot(&r, &finest.x);
        let beta = next / rho; // 0 at first
        rho = next;
        for k in 0..n {
            p[k] = finest.x[k] + beta * p[k];
        }
        for k in 0..n {
            product[k] = finest.diagonal[k] * p[k] - finest.pull(&p, k);
        }
        let alpha = rho / dot(&p, &product);
        for k in 0..n {
            x[k] += alpha * p[k];
            r[k] -= alpha * product[k];
        }
        residual = dot(&r, &r).sqrt() / size;
        if residual <= TOLERANCE {
            return Ok(x);
        }
    }
    if residual <= ACCEPTED {
        return Ok(x);
    }
    Err(FillError::NotConverged { residual, iterations: MAX_ITERATIONS })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn filled(grid: Grid, truth: &[f64], is_hole: impl Fn(usize, usize) -> bool) -> Vec<f64> {
        let nx = grid.shape()[1];
        let mut heights: Vec<f64> = truth
            .iter()
            .enumerate()
            .map(|(i, h)| if is_hole(i / nx, i % nx) { f64::NAN } else { *h })
            .collect();
        fill(grid, &mut heights).unwrap();
        heights
    }

    /// x y and x^2 - y^2 are harmonic, and the five-point formula is exact for them on any
    /// pixel: a hole must come back to rounding, under an offset of 10^6 times the relief.
    #[test]
    fn quadratic_harmonics_come_back_exactly() {
        for (ny, nx, dy, dx) in [(40, 50, 1.0, 1.0), (61, 33, 0.2, 1.0), (30, 90, 7.0, 1.0)] {
            let grid = Grid::new([ny, nx], [dy, dx]).unwrap();
            let truth: Vec<f64> = (0..ny * nx)
                .map(|i| {
                    let (y, x) = ((i / nx) as f64 * dy, (i % nx) as f64 * dx);
                    1e9 + x * y + x * x - y * y
                })
                .collect();
            let back = filled(grid, &truth, |iy, ix| {
                (3..ny - 2).contains(&iy) && (2..nx - 1).contains(&ix) && (iy * ix) % 29 != 5
            });
            let scale = (ny as f64 * dy).max(nx as f64 * dx).powi(2);
            for (found, exact) in back.iter().zip(&truth) {
                assert!((found - exact).abs() < 1e-10 * scale + 1e-6, "{found} {exact}");
            }
        }
    }

    /// Half the map missing, at the edge: sinh(qy) decays, error falls with h^2.
    #[test]
    fn order_of_convergence_is_two_in_a_large_hole() {
        let mut errors = Vec::new();
        for n in [16usize, 32, 64, 128] {
            let h = 1.0 / n as f64;
            let grid = Grid::new([n + 1, n + 1], [h, h]).unwrap();
            let exact = |y: f64, x: f64| (TAU * x).cos() * (TAU * y).cosh() / TAU.cosh();
            let truth: Vec<f64> = (0..(n + 1) * (n + 1))
                .map(|i| exact((i / (n + 1)) as f64 * h, (i % (n + 1)) as f64 * h))
                .collect();
            let back = filled(grid, &truth, |iy, ix| iy > 0 && iy < n && ix > 0 && ix < n);
            let error = back.iter().zip(&truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            errors.push(error);
        }
        for pair in errors.windows(2) {
            let order = (pair[0] / pair[1]).log2();
            assert!((1.8..2.3).contains(&order), "{errors:?}");
        }
    }

    /// Every filled point is the mean of its neighbours and between the extremes of the rim.
    #[test]
    fn one_valid_point_fills_everything_with_its_height() {
        let grid = Grid::new([17, 23], [1.0, 3.0]).unwrap();
        let truth = vec![0.0763; 17 * 23];
        let back = filled(grid, &truth, |iy, ix| (iy, ix) != (16, 0));
        assert!(back.iter().all(|h| h.to_bits() == 0.0763f64.to_bits()));
    }
}
