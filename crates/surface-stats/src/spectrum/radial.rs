//! The two-dimensional spectrum and its average over directions.

use super::window;
use crate::{Edges, StatsError, scale};
use contact_types::{Grid, HeightMap, RoughnessSpectrum, Shell, SpectralMoments};
use grid_fft::{Complex, GridFft};
use std::f64::consts::{PI, TAU};

/// All waves of a map: `|H|²` on the half spectrum.
#[derive(Debug, Clone)]
pub struct PowerSpectrum {
    grid: Grid,
    waves: Vec<Complex<f64>>,
}

/// Waves whose |q| lies within one step of a ring.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Ring {
    /// Root mean square of |q|, weighted by variance (unweighted if the ring is empty) (rad/m).
    pub wavenumber: f64,
    /// Variance of all its waves (m²).
    pub variance: f64,
    /// Mean of the PSD C(q) over its waves (m⁴).
    pub psd: f64,
    /// How many waves of the full plane it holds; q and -q both count.
    pub waves: usize,
    /// From its smallest to its largest |q| (rad/m).
    pub width: f64,
}

impl PowerSpectrum {
    /// Of the map as it repeats, or, with open edges, under a Hann window.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        scale::check(map)?;
        Ok(Self::windowed(map, edges))
    }

    /// The same of heights that may be a little out of range, as levelling may leave them.
    pub(crate) fn windowed(map: &HeightMap, edges: Edges) -> Self {
        let mut fft = GridFft::new(map.grid().shape());
        let mut waves = fft.new_spectrum();
        fft.forward_rows(window(map, edges), &mut waves);
        Self { grid: map.grid(), waves }
    }

    /// Of heights that are already about their mean and windowed.
    pub(crate) fn of_field(grid: Grid, field: &[f64]) -> Self {
        let mut fft = GridFft::new(grid.shape());
        let mut waves = fft.new_spectrum();
        fft.forward(field, &mut waves);
        Self { grid, waves }
    }

    /// Calls `visit([qy, qx], weight, variance)` for every wave of the half spectrum but q = 0: its wave
    /// vector (rad/m), how many waves of the full plane it stands for (1 or 2), the variance of each (m²).
    pub(crate) fn for_each(&self, mut visit: impl FnMut([f64; 2], f64, f64)) {
        let [_, nx] = self.grid.shape();
        let nq = nx / 2 + 1;
        let n = self.grid.len() as f64;
        for (iy, row) in self.waves.chunks_exact(nq).enumerate() {
            for (ix, wave) in row.iter().enumerate() {
                if iy == 0 && ix == 0 {
                    continue;
                }
                // The waves that a half spectrum leaves out mirror these; Nyquist is its own mirror.
                let weight = if ix == 0 || 2 * ix == nx { 1.0 } else { 2.0 };
                let amplitude = *wave / n;
                visit(self.grid.wave_vector(iy, ix), weight, amplitude.norm_sqr());
            }
        }
    }

    /// Moments by the spectrum, as by differences the means of profiles along both axes: `m0 = Σ S`,
    /// `m2 = ½ Σ S (qx² + qy²)`, `m4 = ½ Σ S (qx⁴ + qy⁴)`.
    /// Of an isotropic surface `m4 = ⅜ Σ S q⁴`; of a lay or a pattern m4 depends on how it lies on the axes.
    pub fn moments(&self) -> SpectralMoments {
        let mut m = SpectralMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
        self.for_each(|[qy, qx], weight, variance| {
            let (s, qx2, qy2) = (weight * variance, qx * qx, qy * qy);
            let q2 = qx2 + qy2;
            m.m0 += s;
            m.m2 += 0.5 * s * q2;
            m.m4 += 0.5 * s * (qx2 * qx2 + qy2 * qy2);
        });
        m
    }

    /// Rms gradient that forward differences see of these waves over the one they have: 1 if all
    /// waves are long, and without a wave; 2/π if all are two pixels short.
    pub(crate) fn resolved_gradient(&self) -> f64 {
        let [dy, dx] = self.grid.pixel();
        let (mut seen, mut all) = (0.0, 0.0);
        self.for_each(|[qy, qx], weight, variance| {
            let [ty, tx] = [(qy, dy), (qx, dx)].map(|(q, d)| 2.0 * (0.5 * q * d).sin() / d);
            seen += weight * variance * (ty * ty + tx * tx);
            all += weight * variance * (qy * qy + qx * qx);
        });
        if all > 0.0 { (seen / all).sqrt() } else { 1.0 }
    }

    /// PSD averaged over directions: waves gathered into rings of strictly rising wavenumber, as wide as the finer of the
    /// two wavenumber steps of the map (wider only if the sides differ so much that there would be more than 8 rings per
    /// row and column).
    pub fn rings(&self) -> Vec<Ring> {
        let ([ny, nx], [ly, lx]) = (self.grid.shape(), self.grid.size());
        let [dy, dx] = self.grid.pixel();
        let longest = (PI / dy).hypot(PI / dx) / (8 * (ny + nx)) as f64;
        let (cell, width) = (TAU / ly * (TAU / lx), (TAU / ly.max(lx)).max(longest));
        let mut sums: Vec<[f64; 4]> = Vec::new(); // waves, S, S q², q²
        self.for_each(|[qy, qx], weight, variance| {
            let q2 = qy * qy + qx * qx;
            let ring = (q2.sqrt() / width).round() as usize;
            if ring >= sums.len() {
                sums.resize(ring + 1, [0.0; 4]);
            }
            let sum = &mut sums[ring];
            let s = weight * variance;
            for (total, part) in sum.iter_mut().zip([weight, s, s * q2, weight * q2]) {
                *total += part;
            }
        });
        let mut last = 0.0f64;
        sums.iter()
            .filter(|[waves, ..]| *waves > 0.0)
            .map(|&[waves, variance, weighted, plain]| {
                let q2 = if variance > 0.0 { weighted / variance } else { plain / waves };
                // Rounding must not put two rings that meet on one wavenumber.
                let wavenumber = q2.sqrt().max(last.next_up());
                last = wavenumber;
                Ring {
                    wavenumber,
                    variance,
                    psd: variance / waves / cell,
                    waves: waves as usize,
                    width,
                }
            })
            .collect()
    }
}

/// Height variance by wavenumber, as Persson's theory takes it, of the map as it repeats, gathered into rings. Each stands
/// at the root mean square wavenumber of its variance, so that m0 and m2 are exactly those of the map; m4 is low
/// by the relative ring width squared at the wavelengths that carry it.
///
/// # Errors
/// [`StatsError::OutOfRange`].
pub fn radial(map: &HeightMap) -> Result<RoughnessSpectrum, StatsError> {
    let rings = PowerSpectrum::of(map, Edges::Periodic)?.rings();
    let shell = |r: &Ring| Shell { wavenumber: r.wavenumber, variance: r.variance };
    Ok(RoughnessSpectrum::new(rings.iter().map(shell).collect())?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use proptest::prelude::*;

    proptest! {
        /// One wave of amplitude A: variance A²/2 at its |q| and nothing elsewhere; twice that at
        /// Nyquist, where only cos² = 1 is sampled. Odd, even, non-square.
        #[test]
        fn a_wave_lands_where_it_belongs(
            ny in 1usize..30, nx in 1usize..30, ky in 0usize..15, kx in 0usize..15,
        ) {
            prop_assume!(2 * ky <= ny && 2 * kx <= nx && (ky, kx) != (0, 0));
            let (dy, dx, amplitude) = (3e-7, 2e-7, 1e-8);
            let grid = Grid::new([ny, nx], [dy, dx]).unwrap();
            let q = grid.wave_vector(ky, kx);
            let map =
                HeightMap::from_fn(grid, |y, x| 7.0 + amplitude * (q[0] * y + q[1] * x).cos())
                    .unwrap();
            let own_mirror = (ky == 0 || 2 * ky == ny) && (kx == 0 || 2 * kx == nx);
            let variance = amplitude * amplitude * if own_mirror { 1.0 } else { 0.5 };
            let q2 = q[0] * q[0] + q[1] * q[1];
            let spectrum = radial(&map).unwrap();
            let m = spectrum.moments();
            let rounding = 1e-6; // 7 m of offset leave eight digits of 1e-8 m
            close(m.m0, variance, rounding);
            close(m.m2, variance * q2 / 2.0, rounding);
            close(m.m4, variance * q2 * q2 * 0.375, rounding);
            let shell = spectrum.shells().iter().max_by(|a, b| a.variance.total_cmp(&b.variance));
            close(shell.unwrap().wavenumber, q2.sqrt(), rounding);
        }
    }

    /// Pixels of any aspect: no more rings than rows and columns allow, m0 and m2 exact.
    #[test]
    fn extreme_aspects_make_no_extreme_number_of_rings() {
        for (shape, pixel) in
            [([1, 500], [1.0, 1e-9]), ([40, 30], [1e-9, 1.0]), ([500, 1], [1.0, 1.0])]
        {
            let grid = Grid::new(shape, pixel).unwrap();
            let heights = (0..grid.len()).map(|i| (1.3 * (i * i) as f64).sin()).collect();
            let map = HeightMap::new(grid, heights).unwrap();
            let power = PowerSpectrum::of(&map, Edges::Periodic).unwrap();
            let (exact, found) = (power.moments(), radial(&map).unwrap());
            assert!(found.shells().len() <= 8 * (shape[0] + shape[1]) + 1);
            close(found.moments().m0, exact.m0, 1e-12);
            close(found.moments().m2, exact.m2, 1e-12);
        }
    }

    /// A tilted wave that does not fit the map: without a window a hundredth of the gradient
    /// variance is above twice its wavenumber, with one almost nothing; the variance stays within
    /// the sampling error of 10 waves.
    #[test]
    fn a_window_takes_the_jump_and_keeps_the_variance() {
        let grid = Grid::new([200, 200], [1.0, 1.0]).unwrap();
        let q = TAU * 10.4 / 200.0;
        let map = HeightMap::from_fn(grid, |y, x| (q * (0.8 * x + 0.6 * y)).sin()).unwrap();
        let short = |edges| {
            let power = PowerSpectrum::of(&map, edges).unwrap();
            let (mut high, mut all, mut variance) = (0.0, 0.0, 0.0);
            power.for_each(|[qy, qx], weight, s| {
                let q2 = qy * qy + qx * qx;
                all += weight * s * q2;
                variance += weight * s;
                if q2 > 4.0 * q * q {
                    high += weight * s * q2;
                }
            });
            (high / all, variance)
        };
        let ((bare, _), (windowed, variance)) = (short(Edges::Periodic), short(Edges::Open));
        assert!(bare > 1e-2 && windowed < 1e-5, "{bare:e} {windowed:e}");
        close(variance, 0.5, 0.02);
    }
}
