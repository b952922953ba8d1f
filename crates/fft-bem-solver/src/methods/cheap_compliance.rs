//! A cheap stand-in for `K`, symbol `2/|q|`: a short stencil at full resolution, and a transform on the
//! coarse grid of [`Stiffness`] for the smooth rest.
//!
//! ```text
//! K x = stencil * x  +  I( IFFT_c[ k_res / B^2  FFT( I^T x ) ] ),    k_res = 2/|q| - symbol of the stencil
//! ```
//!
//! I interpolates with cubic splines; B is what it leaves of a wave. On square pixels the pressure
//! that belongs to the displacement is wrong by 0.6 % for white noise, at
//! 1/20 of the cost of a transform at full size. Good for one or two digits of a *change* of the
//! pressure whose displacement is known before.

use super::fitted_stencil::{MAX_REACH, Waves, dot};
use super::folded_rows::fold_rows;
use super::spline::Axis;
use super::stiffness::Stiffness;
use crate::Real;
use crate::row_work::Partial;
use crate::simd::vectorised;
use grid_fft::parallel::prelude::*;
use std::f64::consts::TAU;

/// Most columns handled at a time.
const TILE: usize = 512;
/// Partial sums of a tile.
const SUMS: usize = 16;

/// `K` for one grid, nearly.
pub(crate) struct CheapCompliance {
    shape: [usize; 2],
    /// Pixels that the stencil reaches beyond its centre along each axis.
    reach: [usize; 2],
    /// Its taps at `(dy, dx)`, `dx` fastest; it is even in both.
    taps: Vec<f32>,
    axes: [Axis; 2],
    /// Symbol of the coarse part, `kx`-major, `ky` in `0..=cy/2`.
    symbol: Vec<f32>,
}

impl CheapCompliance {
    /// For a grid of this finest pixel side 1; `None` if its coarse grid is the grid itself.
    pub(crate) fn new(stiffness: &Stiffness, pixel: [f64; 2]) -> Option<Self> {
        let (shape, coarse) = (stiffness.shape(), stiffness.coarse_shape());
        if shape == coarse {
            return None;
        }
        let axes = [0, 1].map(|a| Axis::new(shape[a], coarse[a]));
        let width = [axes[0].width(), axes[1].width()];
        let stencil = Waves { pixel, width: width.map(f64::round) }.fitted_stencil(shape);
        let waves = Waves { pixel, width };
        let (sy, sx) = (coarse[0] / 2 + 1, coarse[1] / 2 + 1);
        let phase = |k: usize, a: usize| TAU * k as f64 / shape[a] as f64;
        let along_y: Vec<Vec<f64>> = (0..sy).map(|k| stencil.along(0, phase(k, 0))).collect();
        let mut symbol = vec![0.0; sy * sx];
        symbol.par_chunks_mut(sy).enumerate().for_each(|(kx, column)| {
            let summed = stencil.summed_along_x(phase(kx, 1));
            for (ky, s) in column.iter_mut().enumerate() {
                let local = dot(&summed, &along_y[ky]);
                *s = waves.symbol([phase(ky, 0), phase(kx, 1)], local) as f32;
            }
        });
        let taps = stencil.taps.iter().map(|t| *t as f32).collect();
        Some(Self { shape, reach: stencil.reach, taps, axes, symbol })
    }

    /// `u += K x`, or `u = base + K x`. `room` is as long as x, at least; what it holds is lost. Pieces of so many
    /// rows are given to `sums(first pixel, u, <x, K x>)`, while they are in cache, and what it returns is kept in order.
    #[allow(clippy::too_many_arguments, reason = "four fields and what is done with them")]
    pub(crate) fn add<T: Real>(
        &self,
        x: &[f32],
        stiffness: &mut Stiffness,
        room: &mut [f32],
        base: Option<&[T]>,
        u: &mut [T],
        rows: usize,
        sums: impl Fn(usize, &[T], f64) -> Partial + Sync + Send,
        partial: &mut [Partial],
    ) {
        let [my, mx] = stiffness.coarse_shape();
        let (nx, [along_y, along_x]) = (self.shape[1], &self.axes);
        // Rows of cells, but columns of pixels.
        let between = &mut room[..my * nx];
        let share = (1.0 / (along_y.width() * along_x.width())) as f32;
        between.par_chunks_mut(nx).enumerate().for_each(|(j, sum)| {
            sum.fill(0.0);
            for (i, part) in along_y.pixels_of(j) {
                vectorised!(add_multiple(share * part, &x[i * nx..(i + 1) * nx], sum));
            }
        });
        let gathered = &*between;
        let gather = |j: usize, out: &mut [f32]| {
            vectorised!(along_x.gather(&gathered[j * nx..(j + 1) * nx], out));
        };
        let smooth = stiffness.convolve_coarse(gather, &self.symbol);
        between.par_chunks_mut(nx).zip(smooth.par_chunks(mx)).for_each(|(row, smooth)| {
            vectorised!(along_x.interpolate(smooth, row));
        });
        let between = &*between;
        let pieces = u.par_chunks_mut(rows * nx).zip(partial.par_iter_mut());
        pieces.enumerate().for_each(|(task, (u, partial))| {
            let work = vectorised!({
                let mut work = 0.0;
                for (r, u) in u.chunks_exact_mut(nx).enumerate() {
                    let i = task * rows + r;
                    let base = base.map(|base| &base[i * nx..(i + 1) * nx]);
                    work += self.add_row(x, between, i, base, u);
                }
                work
            });
            *partial = sums(task * rows * nx, u, work);
        });
    }

    /// Row `i` of it, from the smooth part at the rows of cells. Returns `<x, K x>` of the row.
    #[inline(always)]
    fn add_row<T: Real>(
        &self,
        x: &[f32],
        smooth: &[f32],
        i: usize,
        base: Option<&[T]>,
        u: &mut [T],
    ) -> f64 {
        let nx = self.shape[1];
        let mut work = 0.0;
        let near = self.axes[0].cells_of(i).map(|(j, part)| (&smooth[j * nx..(j + 1) * nx], part));
        for (t, u) in u.chunks_mut(TILE).enumerate() {
            let (first, width) = (t * TILE, u.len());
            let mut sum = [0.0_f32; TILE];
            let sum = &mut sum[..width];
            let [(r0, s0), (r1, s1), (r2, s2), (r3, s3)] =
                near.map(|(row, part)| (&row[first..][..width], part));
            for k in 0..width {
                sum[k] = (s0 * r0[k] + s1 * r1[k]) + (s2 * r2[k] + s3 * r3[k]);
            }
            self.add_stencil(x, i, first, sum);
            work += f64::from(inner_product(sum, &x[i * nx + first..][..width]));
            let Some(base) = base else {
                u.iter_mut().zip(&*sum).for_each(|(u, y)| *u += T::of(f64::from(*y)));
                continue;
            };
            for ((u, base), y) in u.iter_mut().zip(&base[first..]).zip(&*sum) {
                *u = *base + T::of(f64::from(*y));
            }
        }
        work
    }

    /// Adds the stencil to the nodes of row `i` from column `first` on.
    #[inline(always)]
    fn add_stencil(&self, x: &[f32], i: usize, first: usize, y: &mut [f32]) {
        let ([ny, nx], [ry, rx], width) = (self.shape, self.reach, y.len());
        let row = |i: usize| &x[i * nx..(i + 1) * nx];
        let mut line = [0.0_f32; TILE + 2 * MAX_REACH];
        let line = &mut line[..width + 2 * rx];
        for (dy, taps) in self.taps.chunks_exact(rx + 1).enumerate() {
            let both = [row((i + ry * ny - dy) % ny), row((i + dy) % ny)];
            let factor = if dy == 0 { 0.5 } else { 1.0 }; // the row itself comes twice
            fold_rows(both, factor, first, rx, line);
            add_taps(taps, line, y);
        }
    }
}

/// Adds one row of the stencil: `y(i) += taps(0) line(i) + sum taps(d) (line(i-d) + line(i+d))`.
#[inline(always)]
fn add_taps(taps: &[f32], line: &[f32], y: &mut [f32]) {
    let (n, reach) = (y.len(), taps.len() - 1);
    let at = |d: usize| &line[d..d + n];
    if let &[t0, t1, t2, t3, t4, t5] = taps {
        // Square pixels: all six at a time.
        let [l5, l4, l3, l2, l1, c] = [at(0), at(1), at(2), at(3), at(4), at(5)];
        let [r1, r2, r3, r4, r5] = [at(6), at(7), at(8), at(9), at(10)];
        for k in 0..n {
            let near = t0 * c[k] + t1 * (l1[k] + r1[k]);
            let next = t2 * (l2[k] + r2[k]) + t3 * (l3[k] + r3[k]);
            let far = t4 * (l4[k] + r4[k]) + t5 * (l5[k] + r5[k]);
            y[k] += near + (next + far);
        }
        return;
    }
    add_multiple(taps[0], at(reach), y);
    for (d, tap) in taps.iter().enumerate().skip(1) {
        for ((y, l), r) in y.iter_mut().zip(at(reach - d)).zip(at(reach + d)) {
            *y += tap * (l + r);
        }
    }
}

/// `<a, b>` over a tile.
#[inline(always)]
fn inner_product(a: &[f32], b: &[f32]) -> f32 {
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<SUMS>(), b.as_chunks::<SUMS>());
    let mut lanes = [0.0_f32; SUMS];
    for (a, b) in a.iter().zip(b) {
        lanes.iter_mut().zip(a).zip(b).for_each(|((sum, a), b)| *sum += a * b);
    }
    let last = a_rest.iter().zip(b_rest).map(|(a, b)| a * b);
    lanes.into_iter().chain(last).sum()
}

/// `sum += factor x`.
#[inline(always)]
fn add_multiple(factor: f32, x: &[f32], sum: &mut [f32]) {
    for (s, x) in sum.iter_mut().zip(x) {
        *s += factor * x;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use grid_fft::Convolution;

    /// Relative error of the pressure that belongs to `K x`, rms.
    fn error(shape: [usize; 2], pixel: [f64; 2], x: &[f32]) -> f32 {
        let mut stiffness = Stiffness::new(shape, pixel);
        let cheap = CheapCompliance::new(&stiffness, pixel).unwrap();
        let mut u = vec![0.0_f32; x.len()];
        let (mut room, rows) = (vec![f32::NAN; x.len()], shape[0]);
        let mut partial = [Partial::default()];
        let sums = |_: usize, _: &[f32], work: f64| [work, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        cheap.add(x, &mut stiffness, &mut room, None, &mut u, rows, sums, &mut partial);
        let work: f64 = x.iter().zip(&u).map(|(x, u)| f64::from(*x) * f64::from(*u)).sum();
        assert!(
            (partial[0][0] / work - 1.0).abs() < 1e-3,
            "{shape:?}: {} for {work}",
            partial[0][0]
        );
        let write = |kx: usize, column: &mut [f32]| {
            for (ky, s) in column.iter_mut().enumerate() {
                let q = [0, 1].map(|a| TAU * [ky, kx][a] as f64 / shape[a] as f64 / pixel[a]);
                *s = (0.5 * q[0].hypot(q[1])) as f32;
            }
        };
        let mut p = vec![0.0_f32; x.len()];
        Convolution::new(shape).apply(&u, write, &mut p);
        let size = |x: &mut dyn Iterator<Item = f32>| x.map(|x| x * x).sum::<f32>().sqrt();
        size(&mut x.iter().zip(&p).map(|(a, b)| a - b)) / size(&mut x.iter().copied())
    }

    /// Noise of mean zero; each value the mean of `width` by `width` pixels.
    fn noise([ny, nx]: [usize; 2], width: usize) -> Vec<f32> {
        let cells = nx.div_ceil(width);
        let mut state = 1_u64;
        let values: Vec<f32> = (0..ny.div_ceil(width) * cells)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 40) as f32 / (1_u64 << 24) as f32
            })
            .collect();
        let at = |i: usize| values[i / nx / width * cells + i % nx / width];
        let mean = (0..ny * nx).map(at).sum::<f32>() / (ny * nx) as f32;
        (0..ny * nx).map(|i| at(i) - mean).collect()
    }

    /// `S K x = x`, nearly: noise to the pixel and coarser, odd sides, long pixels, a line.
    #[test]
    fn pressures_come_back() {
        for (shape, pixel, width, limit) in [
            ([128, 128], [1.0, 1.0], 1, 0.007),
            ([128, 128], [1.0, 1.0], 8, 0.006),
            ([101, 99], [1.0, 1.0], 1, 0.007),
            ([101, 99], [1.0, 1.0], 9, 0.006),
            ([64, 128], [2.0, 1.0], 1, 0.006),
            ([64, 128], [8.0, 1.0], 1, 0.015),
            ([128, 64], [1.0, 1000.0], 1, 0.022),
            ([1, 256], [1.0, 1.0], 1, 0.022),
        ] {
            let found = error(shape, pixel, &noise(shape, width));
            assert!(found < limit, "{shape:?} {pixel:?} {width}: {found}");
        }
    }

    /// A long wave comes back nearly as it was.
    #[test]
    fn long_waves_come_back() {
        for shape in [[128, 128], [127, 129]] {
            let wave = |i: usize| {
                let phase = (i / shape[1]) as f64 / shape[0] as f64
                    + 2.0 * (i % shape[1]) as f64 / shape[1] as f64;
                (TAU * phase).cos() as f32
            };
            let x: Vec<f32> = (0..shape[0] * shape[1]).map(wave).collect();
            let found = error(shape, [1.0, 1.0], &x);
            assert!(found < 1e-3, "{shape:?}: {found}");
        }
    }
}
