//! A cheap stand-in for `S = K^-1`, symbol `|q|/2`: a short stencil at full resolution, and a
//! transform on a coarser grid for the smooth rest.
//!
//! ```text
//! S x = stencil * x  +  replicate( IFFT_c[ s_res / B^2  FFT( mean x ) ] ),    s_res = |q|/2 - symbol of the stencil
//! ```
//!
//! The kernel of `|q|/2` falls off as 1/r^3, so a 5 x 5 piece of it carries the short waves and
//! the quarter-resolution grid the long ones, at 1/20 of the cost of a transform at full size.
//! `B`, the response of the block mean, makes the long waves come out at full strength.

use super::equal_cells::EqualCells;
use super::thin_pixels;
use crate::half_space_free::love_transform;
use crate::row_work::TASK;
use crate::simd::vectorised;
use contact_types::Grid;
use grid_fft::Convolution;
use grid_fft::parallel::prelude::*;
use std::f64::consts::{PI, TAU};

/// Below this many pixels an axis is not coarsened.
const SHORTEST: usize = 16;
const TILE: usize = 512;
/// Pixels per coarse cell: about square, and 16 to 32 of them.
const CELLS: &[[usize; 2]] = &[[4, 4], [4, 8], [2, 8], [2, 16], [1, 16]];
/// Waves of which the mean over a cell leaves less are not brought to full strength: they are too short
/// for the coarse grid, and what it answers comes back at other wavelengths as well.
const LEAST_RESPONSE: f64 = 0.8;
/// Largest radius of the stencil: half a cell.
const MAX_RADIUS: usize = 8;

pub(crate) struct Stiffness {
    shape: [usize; 2],
    /// Pixels per coarse cell along each axis; [1, 1] if the coarse grid is the grid itself and
    /// the transform does everything.
    factor: [usize; 2],
    radius: [usize; 2],
    /// Stencil of `dy` in `0..=radius[0]`, `dx` in `0..=radius[1]`; it is even in both.
    taps: [[f32; MAX_RADIUS + 1]; MAX_RADIUS + 1],
    cells: [EqualCells; 2],
    transform: Convolution<f32>,
    /// Symbol of the coarse part, `kx`-major, `ky` in `0..=cy/2`.
    symbol: Vec<f32>,
    /// Means over the coarse cells, then the smooth part of the result on them.
    coarse: Vec<f32>,
    /// Cost of one application in FFT convolutions.
    pub(crate) cost: f64,
}

/// Pixels per coarse cell along each axis. An axis with few pixels is kept as it is; on a line of
/// pixels, cells are as on very long ones.
fn factors(shape: [usize; 2], pixel: [f64; 2]) -> [usize; 2] {
    let sides = [0, 1].map(|a| if shape[a] > 1 { pixel[a] } else { f64::MAX });
    let mut factor = thin_pixels::cell(sides, CELLS);
    let short = usize::from(sides[1] < sides[0]);
    if factor[short] == factor[1 - short] {
        return [0, 1].map(|a| if shape[a] < SHORTEST { 1 } else { factor[a] });
    }
    // Few pixels across: smaller cells, of the same shape.
    let most = 1 << (shape[short] / 2).max(1).ilog2();
    while factor[short] > most {
        factor = factor.map(|f| (f / 2).max(1));
    }
    if shape[1 - short] < SHORTEST {
        factor[1 - short] = 1;
    }
    factor
}

fn relative_cost(small: [usize; 2], large: [usize; 2]) -> f64 {
    let (m, n) = ((small[0] * small[1]) as f64, (large[0] * large[1]) as f64);
    m * m.max(2.0).log2() / (n * n.max(2.0).log2())
}

/// `|q|/2` of the waves `[ky, kx]` on a grid.
fn half_wavenumber(shape: [usize; 2], pixel: [f64; 2]) -> impl Fn([usize; 2]) -> f64 {
    let grid = Grid::new(shape, pixel).expect("it is the grid of a problem, or a piece of it");
    move |[ky, kx]| 0.5 * grid.wavenumber(ky, kx)
}

impl Stiffness {
    /// For a periodic grid of `shape` pixels of size `pixel`.
    pub(crate) fn new(shape: [usize; 2], pixel: [f64; 2]) -> Self {
        Self::with_symbol(shape, pixel, half_wavenumber(shape, pixel))
    }

    /// For an isolated map, padded to this grid: the symbol is the inverse of that of the kernel in
    /// place of `|q|/2`. They differ where a wave is as long as the grid: the copies of the map, which
    /// `|q|/2` knows of, would make a line of long pixels much softer.
    pub(crate) fn isolated(shape: [usize; 2], pixel: [f64; 2]) -> Self {
        let transform = love_transform(shape, pixel, 1.0);
        let columns = shape[1] / 2 + 1;
        let periodic = half_wavenumber(shape, pixel);
        Self::with_symbol(shape, pixel, |k| {
            let compliance = transform[k[0] * columns + k[1]];
            if compliance > 0.0 { 1.0 / compliance } else { periodic(k) }
        })
    }

    /// `symbol(wave)` for waves that the coarse grid has.
    fn with_symbol(shape: [usize; 2], pixel: [f64; 2], wanted: impl Fn([usize; 2]) -> f64) -> Self {
        let factor = factors(shape, pixel);
        let radius = [0, 1].map(|a| match factor[a] {
            1 if shape[a] < SHORTEST => 2.min(shape[a] / 2),
            f => f / 2,
        });
        let cells = [0, 1].map(|a| EqualCells::new(shape[a], factor[a]));
        let coarse = [cells[0].len(), cells[1].len()];
        let transform = Convolution::new(coarse);
        let is_exact = factor == [1, 1];
        let taps = if is_exact { Default::default() } else { stencil(shape, pixel, radius) };
        let size = coarse[0] * coarse[1];
        let (sy, sx) = (coarse[0] / 2 + 1, coarse[1] / 2 + 1);
        let mut symbol = vec![0.0; sy * sx];
        // Phases per pixel of the finest grid.
        let along = |count: usize, a: usize| -> Vec<AxisResponse> {
            let phase = |k: usize| TAU * k as f64 / shape[a] as f64;
            (0..count).map(|k| AxisResponse::new(phase(k), factor[a], radius[a])).collect()
        };
        let (along_y, along_x) = (along(sy, 0), along(sx, 1));
        for kx in 0..sx {
            for ky in 0..sy {
                let q = wanted([ky, kx]);
                symbol[kx * sy + ky] = if is_exact {
                    q
                } else {
                    let both = [&along_y[ky], &along_x[kx]];
                    let response: f64 = both.iter().flat_map(|axis| &axis.halvings).product();
                    let b = response.max(LEAST_RESPONSE);
                    (q - stencil_symbol(&taps, both)) / (b * b)
                } as f32;
            }
        }
        Self {
            shape,
            factor,
            radius,
            taps: taps.map(|row| row.map(|t| t as f32)),
            cells,
            transform,
            symbol,
            coarse: vec![0.0; size],
            cost: if is_exact { 1.0 } else { relative_cost(coarse, shape) },
        }
    }

    /// `y = S x`.
    pub(crate) fn apply(&mut self, x: &mut [f32], y: &mut [f32]) {
        self.fill(x, |_, _| ());
        self.apply_to_filled(x, y);
    }

    /// Writes a field x row by row, `write(row, x)`, and takes the means that `S x` needs, while it is
    /// in cache if the cells cut no rows.
    pub(crate) fn fill(&mut self, x: &mut [f32], write: impl Fn(usize, &mut [f32]) + Sync + Send) {
        let nx = self.shape[1];
        let [along_y, along_x] = &self.cells;
        let cx = along_x.len();
        let add = |share: f32, x: &[f32], mean: &mut [f32]| {
            vectorised!(along_x.add_means(share, x, mean));
        };
        if let Some(fy) = along_y.whole {
            let cells = (TASK / (fy * nx)).max(1);
            let pieces =
                x.par_chunks_mut(cells * fy * nx).zip(self.coarse.par_chunks_mut(cells * cx));
            pieces.enumerate().for_each(|(task, (x, mean))| {
                mean.fill(0.0);
                for (i, x) in x.chunks_exact_mut(nx).enumerate() {
                    write(task * cells * fy + i, x);
                    add(1.0 / fy as f32, x, &mut mean[i / fy * cx..][..cx]);
                }
            });
            return;
        }
        let rows = (TASK / nx).max(1);
        x.par_chunks_mut(rows * nx).enumerate().for_each(|(task, x)| {
            for (i, x) in x.chunks_exact_mut(nx).enumerate() {
                write(task * rows + i, x);
            }
        });
        let cells = rows.div_ceil(self.factor[0]);
        self.coarse.par_chunks_mut(cells * cx).enumerate().for_each(|(task, mean)| {
            mean.fill(0.0);
            for (j, mean) in mean.chunks_exact_mut(cx).enumerate() {
                for (i, share) in along_y.pixels(task * cells + j) {
                    add(share, &x[i * nx..(i + 1) * nx], mean);
                }
            }
        });
    }

    /// `y = S x` of the x that [`fill`](Self::fill) has written.
    pub(crate) fn apply_to_filled(&mut self, x: &[f32], y: &mut [f32]) {
        let (symbol, rows) = (&self.symbol, self.cells[0].len() / 2 + 1);
        let write = |kx: usize, column: &mut [f32]| {
            column.copy_from_slice(&symbol[kx * rows..][..rows]);
        };
        if self.factor == [1, 1] {
            self.transform.apply(x, write, y);
            return;
        }
        self.transform.apply_in_place(&mut self.coarse, write);
        self.stencil_and_smooth(x, y);
    }

    /// Tests: multiplies the operator by `factor`, and its coarse part by an oscillation.
    #[cfg(test)]
    pub(crate) fn spoil(&mut self, factor: f64, ripple: f64) {
        for tap in self.taps.iter_mut().flatten() {
            *tap *= factor as f32;
        }
        for (k, s) in self.symbol.iter_mut().enumerate() {
            *s *= (factor * (1.0 + ripple * (k as f64).sin())) as f32;
        }
    }

    /// `y = stencil * x + replicate(smooth)`.
    fn stencil_and_smooth(&self, x: &[f32], y: &mut [f32]) {
        let nx = self.shape[1];
        let rows = (TASK / nx).max(1);
        y.par_chunks_mut(rows * nx).enumerate().for_each(|(task, y)| {
            let mut line = [0.0; TILE + 2 * MAX_RADIUS];
            vectorised!({
                for (r, y) in y.chunks_exact_mut(nx).enumerate() {
                    self.stencil_and_smooth_row(task * rows + r, x, y, &mut line);
                }
            });
        });
    }

    /// Row `i` of it. `line` has room for a tile of columns and what the stencil reaches beyond.
    #[inline(always)]
    fn stencil_and_smooth_row(&self, i: usize, x: &[f32], y: &mut [f32], line: &mut [f32]) {
        let ([ny, nx], [ry, rx]) = (self.shape, self.radius);
        let [along_y, along_x] = &self.cells;
        let cx = along_x.len();
        let row = |i: usize| &x[i * nx..(i + 1) * nx];
        for (k, (j, share)) in along_y.cells_of(i).enumerate() {
            let smooth = &self.coarse[j * cx..(j + 1) * cx];
            match k {
                0 => along_x.spread(share, smooth, y),
                _ => along_x.replicate(share, smooth, y),
            }
        }
        for (t, y) in y.chunks_mut(TILE).enumerate() {
            let (first, width) = (t * TILE, y.len());
            for dy in 0..=ry {
                let both = [row((i + ny - dy) % ny), row((i + dy) % ny)];
                let factor = if dy == 0 { 0.5 } else { 1.0 }; // the row itself comes twice
                let line = &mut line[..width + 2 * rx];
                fold_rows(both, factor, first, rx, line);
                add_stencil_row(&self.taps[dy], rx, line, y);
            }
        }
    }
}

/// `factor` times the sum of two rows, from `reach` columns before the column `first` on; rows repeat.
#[inline(always)]
fn fold_rows(
    [above, below]: [&[f32]; 2],
    factor: f32,
    first: usize,
    reach: usize,
    line: &mut [f32],
) {
    let (nx, length) = (above.len(), line.len());
    let (begin, end) = (first.saturating_sub(reach), (first + length - reach).min(nx));
    let skip = begin + reach - first;
    let inner = skip..skip + end - begin;
    let rows = above[begin..end].iter().zip(&below[begin..end]);
    for (l, (a, b)) in line[inner.clone()].iter_mut().zip(rows) {
        *l = factor * (a + b);
    }
    let before = nx * reach.div_ceil(nx) - reach;
    for k in (0..inner.start).chain(inner.end..length) {
        let mut column = first + k + before;
        while column >= nx {
            column -= nx; // once or twice, but on narrow grids: a division would cost more
        }
        line[k] = factor * (above[column] + below[column]);
    }
}

/// Adds one row of the stencil: `y(i) += taps(0) line(i) + sum taps(d) (line(i-d) + line(i+d))`.
#[inline(always)]
fn add_stencil_row(taps: &[f32; MAX_RADIUS + 1], radius: usize, line: &[f32], y: &mut [f32]) {
    let n = y.len();
    let shifted = |d: usize| &line[d..d + n];
    match radius {
        0 => {
            for (y, c) in y.iter_mut().zip(shifted(0)) {
                *y += taps[0] * c;
            }
        }
        1 => {
            let (l, c, r) = (shifted(0), shifted(1), shifted(2));
            for i in 0..n {
                y[i] += taps[0] * c[i] + taps[1] * (l[i] + r[i]);
            }
        }
        3.. => {
            add_stencil_row(taps, 0, &line[radius..][..n], y);
            for d in (1..=radius).step_by(2) {
                let pair = |d: usize| (&line[radius - d..][..n], &line[radius + d..][..n]);
                let ((l, r), (ll, rr)) = (pair(d), pair(d + 1));
                for i in 0..n {
                    y[i] += taps[d] * (l[i] + r[i]) + taps[d + 1] * (ll[i] + rr[i]);
                }
            }
        }
        2 => {
            let (ll, l, c, r, rr) = (shifted(0), shifted(1), shifted(2), shifted(3), shifted(4));
            for i in 0..n {
                y[i] += taps[0] * c[i] + taps[1] * (l[i] + r[i]) + taps[2] * (ll[i] + rr[i]);
            }
        }
    }
}

type Taps = [[f64; MAX_RADIUS + 1]; MAX_RADIUS + 1];

/// The kernel of `|q|/2` near the origin, from a small grid of the same pixels.
fn stencil(shape: [usize; 2], pixel: [f64; 2], radius: [usize; 2]) -> Taps {
    let probe = [0, 1].map(|a| shape[a].min(64 * (radius[a] / 2).max(1)));
    let [py, px] = probe;
    let mut impulse = vec![0.0; py * px];
    impulse[0] = 1.0;
    let mut kernel = vec![0.0; py * px];
    let symbol = half_wavenumber(probe, pixel);
    let write = |kx: usize, column: &mut [f64]| {
        for (ky, s) in column.iter_mut().enumerate() {
            *s = symbol([ky, kx]);
        }
    };
    Convolution::new(probe).apply(&impulse, write, &mut kernel);
    let mut taps = Taps::default();
    for dy in 0..=radius[0] {
        for dx in 0..=radius[1] {
            // A distance of half the grid is reached from both sides: half for each.
            let shared = |d: usize, n: usize| if 2 * d == n { 0.5 } else { 1.0 };
            taps[dy][dx] = kernel[dy * px + dx] * shared(dy, shape[0]) * shared(dx, shape[1]);
        }
    }
    taps
}

/// What the taps and the cells are to a wave, along one axis.
struct AxisResponse {
    /// `cos(d phase)`, twice where a tap has a mirror image, for each distance d.
    waves: Vec<f64>,
    /// How much of the wave the mean over a cell leaves: a cosine for each halving.
    halvings: Vec<f64>,
}

impl AxisResponse {
    /// For a wave of this phase per pixel, cells of `factor` pixels and taps up to `radius`.
    fn new(phase: f64, factor: usize, radius: usize) -> Self {
        debug_assert!(phase.abs() <= 1.001 * PI);
        let both_sides = |d: usize| if d == 0 { 1.0 } else { 2.0 };
        let halving = |j: u32| (0.5 * phase * f64::from(1 << j)).cos();
        Self {
            waves: (0..=radius).map(|d| both_sides(d) * (d as f64 * phase).cos()).collect(),
            halvings: (0..factor.ilog2()).map(halving).collect(),
        }
    }
}

fn stencil_symbol(taps: &Taps, [along_y, along_x]: [&AxisResponse; 2]) -> f64 {
    let mut sum = 0.0;
    for (row, y) in taps.iter().zip(&along_y.waves) {
        for (tap, x) in row.iter().zip(&along_x.waves) {
            sum += tap * (y * x);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Long waves come out as `|q|/2` says, whatever the pixels; short ones within a factor.
    #[test]
    fn long_waves_have_the_right_stiffness() {
        for (shape, pixel) in [
            ([64, 64], [1.0, 1.0]),
            ([96, 128], [1.0, 1.0]),
            ([64, 128], [2.0, 1.0]),
            ([32, 256], [8.0, 1.0]),
            ([1, 256], [1.0, 1.0]),
            ([12, 256], [1.0, 1.0]),
        ] {
            let mut s = Stiffness::new(shape, pixel);
            let [ny, nx] = shape;
            for k in [[0, 1], [0, 3], [1, 2], [2, 0]] {
                if 8 * k[0] > ny || k == [0, 0] {
                    continue;
                }
                let mut x: Vec<f32> = (0..ny * nx)
                    .map(|i| {
                        let y = (k[0] * (i / nx)) as f64 / ny as f64;
                        let x = (k[1] * (i % nx)) as f64 / nx as f64;
                        (TAU * (y + x)).cos() as f32
                    })
                    .collect();
                let mut y = vec![0.0; x.len()];
                s.apply(&mut x, &mut y);
                let expected = half_wavenumber(shape, pixel)(k);
                let dot: f64 = x.iter().zip(&y).map(|(a, b)| f64::from(*a) * f64::from(*b)).sum();
                let found = 2.0 * dot / (ny * nx) as f64;
                let off = (found / expected - 1.0).abs();
                assert!(off < 0.05, "{shape:?} {pixel:?} {k:?}: {found} for {expected}");
            }
        }
    }

    /// A constant has no stiffness, whatever is left over at the edges.
    #[test]
    fn a_constant_has_no_stiffness() {
        for shape in [[64, 65], [66, 67], [17, 18], [19, 21], [1, 33], [5, 29], [33, 8]] {
            for pixel in [[1.0, 1.0], [1.0, 2.0], [4.0, 1.0]] {
                let mut s = Stiffness::new(shape, pixel);
                let mut y = vec![f32::NAN; shape[0] * shape[1]];
                s.apply(&mut vec![1.0; y.len()], &mut y);
                assert!(y.iter().all(|y| y.abs() < 1e-5), "{shape:?} {pixel:?}");
            }
        }
    }
}
