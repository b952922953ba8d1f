//! What measurement noise does to the moments, and where a spectrum ends in it.

use crate::spectrum::Ring;
use crate::{SpectralMoments, Warning};
use std::f64::consts::{PI, TAU};

/// A PSD falls at least as q⁻² on any self-affine surface; flatter than this at the shortest
/// waves is taken for noise.
const FLAT_SLOPE: f64 = -1.0;

/// Waves belong to the surface where the PSD is this many times the floor.
pub(crate) const SIGNAL: f64 = 3.0;

/// What white noise of rms `s` (m) adds to m2 and m4 by finite differences on pixels `[dy, dx]`
/// (m): `s² (1/dx² + 1/dy²)` and `3 s² (1/dx⁴ + 1/dy⁴)`.
fn white_noise_moments(s: f64, [dy, dx]: [f64; 2]) -> [f64; 2] {
    let m2 = (s / dx).powi(2) + (s / dy).powi(2);
    [m2, 3.0 * ((s / dx / dx).powi(2) + (s / dy / dy).powi(2))]
}

/// The level at which a PSD stops falling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct NoiseFloor {
    /// Rms height of white noise with the PSD of the floor (m).
    pub(crate) rms: f64,
    /// Shortest wavelength at which the PSD is three times the floor (m): the end of the reliable
    /// bandwidth. `None` if there is none: the surface cannot be told from noise.
    pub(crate) reliable: Option<f64>,
}

/// Mean PSD of values with their numbers of waves.
fn mean(values: &[[f64; 2]]) -> f64 {
    let waves: f64 = values.iter().map(|[_, waves]| waves).sum();
    values.iter().map(|[psd, waves]| waves * psd).sum::<f64>() / waves
}

/// The mean PSD over the upper half of a last octave, given as values with their numbers of waves. `None` if it still falls
/// there, d ln(PSD) / d ln(frequency) being less than `flat`, and of fewer than 8 values.
pub(crate) fn last_octave(values: &[[f64; 2]], flat: f64) -> Option<f64> {
    let (low, high) = values.split_at(values.len() / 2);
    let (lower, upper) = (mean(low), mean(high));
    // The halves of the octave are centred at 5/8 and 7/8 of its end.
    let slope = (upper / lower).ln() / (0.875f64 / 0.625).ln();
    (values.len() >= 8 && upper > 0.0 && slope >= flat).then_some(upper)
}

impl Warning {
    /// Whether slopes and curvatures are those of the instrument: of the height step (m) if it explains the noise, else of
    /// the noise. Rounding to steps of height Q is white noise of rms Q/√12.
    pub(crate) fn of_noise(
        moments: SpectralMoments,
        pixel: [f64; 2],
        step: Option<f64>,
        noise: Option<NoiseFloor>,
    ) -> Option<Self> {
        let shares = |rms: f64| {
            let [m2, m4] = white_noise_moments(rms, pixel);
            [(m2 / moments.m2).min(1.0), (m4 / moments.m4).min(1.0)]
        };
        let matters = |[m2, m4]: [f64; 2]| m2 > 1.0 / 12.0 || m4 > 0.25;
        let floor = noise.map_or(0.0, |n| n.rms);
        let rounding = |step: f64| step / 12f64.sqrt();
        let explains = |step: &f64| floor < 2.0 * rounding(*step);
        let step = step.filter(explains);
        let rms = step.map_or(floor, rounding);
        let ([m2_share, m4_share], reliable) = (shares(rms), noise.and_then(|n| n.reliable));
        let found = Self::Noisy { step, rms, m2_share, m4_share, reliable };
        matters([m2_share, m4_share]).then_some(found)
    }
}

impl NoiseFloor {
    /// Reads the floor off the last octave of the radial PSD before the Nyquist wavenumber of the
    /// coarser pixel side. Noise that the instrument has smoothed is not white and is not seen.
    pub(crate) fn of(rings: &[Ring], [dy, dx]: [f64; 2]) -> Option<Self> {
        let nyquist = PI / dy.max(dx);
        let value = |r: &Ring| [r.psd, r.waves as f64];
        let octave: Vec<[f64; 2]> = rings
            .iter()
            .filter(|r| r.wavenumber > 0.5 * nyquist && r.wavenumber <= nyquist)
            .map(value)
            .collect();
        let psd = last_octave(&octave, FLAT_SLOPE)?;
        // Averaged over three rings, so that a single strong wave of noise does not count. In the octave that was found flat
        // the middle one of five: a line there, as where every second column is off, is no surface.
        let is_signal = |r: &&[Ring]| {
            if r[2].wavenumber > 0.5 * nyquist {
                r.iter().filter(|r| r.psd >= SIGNAL * psd).count() > r.len() / 2
            } else {
                mean(&[value(&r[1]), value(&r[2]), value(&r[3])]) >= SIGNAL * psd
            }
        };
        let reliable = rings.windows(5).rfind(is_signal).map(|r| TAU / r[2].wavenumber);
        Some(Self { rms: TAU * (psd / (dy * dx)).sqrt(), reliable })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use crate::spectrum::PowerSpectrum;
    use crate::synthesis::rough;
    use crate::{Edges, moments};
    use contact_types::{Grid, HeightMap};
    use rand_pcg::Pcg64;
    use rand_pcg::rand_core::Rng;

    fn floor(map: &HeightMap) -> Option<NoiseFloor> {
        let rings = PowerSpectrum::of(map, Edges::Periodic).unwrap().rings();
        NoiseFloor::of(&rings, map.grid().pixel())
    }

    /// White noise has the moments stated. Under a surface that ends at 8 µm level and end of
    /// the band are found; a line at the shortest wave is no surface.
    #[test]
    fn white_noise_is_found_under_a_surface() {
        let grid = Grid::new([300, 256], [1e-6, 1.2e-6]).unwrap();
        let (mut random, rms) = (Pcg64::new(5, 1), 3e-9);
        let mut uniform = || (f64::from(random.next_u32()) + 0.5) / 4_294_967_296.0 - 0.5;
        let noise: Vec<f64> = (0..grid.len()).map(|_| rms * 12f64.sqrt() * uniform()).collect();
        let map = |height: &dyn Fn(usize) -> f64| {
            HeightMap::new(grid, (0..grid.len()).map(height).collect()).unwrap()
        };
        let white = map(&|i| noise[i]);
        let ([m2, m4], found) =
            (white_noise_moments(rms, grid.pixel()), moments(&white, Edges::Periodic).unwrap().0);
        close(found.m2, m2, 0.03);
        close(found.m4, m4, 0.03);
        assert_eq!(floor(&white).unwrap().reliable, None);

        let clean = rough(grid, 0.8, [40e-6, 8e-6], 200e-9, 1);
        for line in [0.0, rms] {
            let sign = |i: usize| if (i % 256).is_multiple_of(2) { line } else { -line };
            let found = floor(&map(&|i| clean.heights()[i] + noise[i] + sign(i))).unwrap();
            close(found.reliable.unwrap(), 8e-6, 0.05);
            if line <= 0.0 {
                close(found.rms, rms, 0.025);
            }
        }
    }

    #[test]
    fn a_falling_spectrum_has_no_floor() {
        let grid = Grid::new([256, 256], [1e-6, 1e-6]).unwrap();
        assert_eq!(floor(&rough(grid, 0.3, [40e-6, 2e-6], 1e-7, 3)), None);
    }
}
