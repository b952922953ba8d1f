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

/// Whether a PSD with these means over the lower and the upper half of its last octave has stopped
/// falling there: d ln(PSD) / d ln(frequency) is `flat` or more.
pub(crate) fn is_flat([lower, upper]: [f64; 2], flat: f64) -> bool {
    // The halves of the octave are centred at 5/8 and 7/8 of its end.
    let slope = (upper / lower).ln() / (0.875f64 / 0.625).ln();
    upper > 0.0 && slope >= flat
}

impl Warning {
    /// Whether slopes and curvatures are those of the instrument: of the height step (m) if it
    /// explains the noise, else of the noise. Rounding to steps of height Q is white noise of rms
    /// Q/√12, if the relief changes by a step or more from pixel to pixel.
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
        let rms = noise.map_or(0.0, |n| n.rms);
        if let Some(step) = step {
            let rounding = step / 12f64.sqrt();
            let [m2_share, m4_share] = shares(rounding);
            if matters([m2_share, m4_share]) && rms < 2.0 * rounding {
                return Some(Self::Stepped { step, m2_share, m4_share });
            }
        }
        let ([m2_share, m4_share], reliable) = (shares(rms), noise.and_then(|n| n.reliable));
        matters([m2_share, m4_share]).then_some(Self::Noisy { rms, m2_share, m4_share, reliable })
    }
}

impl NoiseFloor {
    /// Reads the floor off the last octave of the radial PSD before the Nyquist wavenumber of the
    /// coarser pixel side. `None` if the PSD still falls there faster than 1/q, or if the map has
    /// too few waves (fewer than 8 rings in that octave).
    ///
    /// Noise that the instrument has smoothed is not white and is not seen.
    pub(crate) fn of(rings: &[Ring], [dy, dx]: [f64; 2]) -> Option<Self> {
        let nyquist = PI / dy.max(dx);
        let last_octave: Vec<&Ring> = rings
            .iter()
            .filter(|r| r.wavenumber > 0.5 * nyquist && r.wavenumber <= nyquist)
            .collect();
        if last_octave.len() < 8 {
            return None;
        }
        let mean = |rings: &[&Ring]| {
            let waves: f64 = rings.iter().map(|r| r.waves as f64).sum();
            rings.iter().map(|r| r.waves as f64 * r.psd).sum::<f64>() / waves
        };
        let (low, high) = last_octave.split_at(last_octave.len() / 2);
        let psd = mean(high);
        if !is_flat([mean(low), psd], FLAT_SLOPE) {
            return None;
        }
        // Averaged over three rings, so that a single strong wave of noise does not count. In the octave that was found flat
        // the middle one of five: a line there, as where every second column is off, is no surface.
        let is_signal = |r: &&[Ring]| {
            if r[2].wavenumber > 0.5 * nyquist {
                r.iter().filter(|r| r.psd >= SIGNAL * psd).count() > r.len() / 2
            } else {
                mean(&[&r[1], &r[2], &r[3]]) >= SIGNAL * psd
            }
        };
        let reliable = rings.windows(5).rfind(is_signal).map(|r| TAU / r[2].wavenumber);
        Some(Self { rms: TAU * (psd / (dy * dx)).sqrt(), reliable })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{PowerSpectrum, Window};
    use crate::synthesis::rough;
    use crate::{DirectionalMoments, Edges};
    use approx::assert_relative_eq;
    use contact_types::{Grid, HeightMap};

    fn surface(cutoff: f64, rms: f64, seed: u64) -> HeightMap {
        let grid = Grid::new([300, 256], [1e-6, 1.2e-6]).unwrap();
        rough(grid, 0.8, [if cutoff > 5e-6 { 40e-6 } else { cutoff }, cutoff], rms, seed)
    }

    fn white(rms: f64) -> HeightMap {
        let noise = surface(2.4e-6, rms, 5);
        // The recipe cuts the corners of the wavenumber plane; alternate signs put the waves it
        // has at the corners, and both together cover the plane evenly enough for 5 %.
        let [_, nx] = noise.grid().shape();
        let mirrored = surface(2.4e-6, rms, 6);
        let heights = (0..noise.heights().len())
            .map(|i| {
                let sign = if (i / nx + i % nx).is_multiple_of(2) { 1.0 } else { -1.0 };
                (noise.heights()[i] + sign * mirrored.heights()[i]) / 2f64.sqrt()
            })
            .collect();
        HeightMap::new(noise.grid(), heights).unwrap()
    }

    #[test]
    fn moments_of_white_noise() {
        let map = white(3e-9);
        let [m2, m4] = white_noise_moments(3e-9, map.grid().pixel());
        let m = DirectionalMoments::of(&map, Edges::Periodic).unwrap().isotropic(9e-18);
        assert_relative_eq!(m.m2, m2, max_relative = 0.1);
        assert_relative_eq!(m.m4, m4, max_relative = 0.1);
    }

    /// Noise of 2 nm under a surface that ends at 8 um: level and end of the reliable band; also
    /// with every second column off by as much as the noise, a line at the shortest wave, which is
    /// no surface.
    #[test]
    fn finds_the_floor_and_where_it_begins() {
        let (clean, noise) = (surface(8e-6, 200e-9, 1), surface(2.4e-6, 2e-9, 2));
        let (pixel, [_, nx]) = (clean.grid().pixel(), clean.grid().shape());
        let floor = |map: &HeightMap| {
            let rings = PowerSpectrum::of(map, Window::None).unwrap().rings();
            NoiseFloor::of(&rings, pixel).unwrap()
        };
        for line in [0.0, 2e-9] {
            let both = clean.heights().iter().zip(noise.heights()).enumerate();
            let heights =
                both.map(|(i, (a, b))| a + b + if i % nx % 2 == 0 { line } else { -line });
            let floor = floor(&HeightMap::new(clean.grid(), heights.collect()).unwrap());
            assert_relative_eq!(floor.reliable.unwrap(), 8e-6, max_relative = 0.05);
            if line <= 0.0 {
                // The noise fills a circle of radius 2 pi / 2.4 um of the plane (2 pi)² / (dy dx).
                let q = TAU / 2.4e-6;
                let psd = 4e-18 / (PI * q * q);
                assert_relative_eq!(floor.rms, TAU * (psd / 1.2e-12).sqrt(), max_relative = 0.025);
            }
        }
        assert_eq!(floor(&noise).reliable, None);
    }

    #[test]
    fn a_falling_spectrum_has_no_floor() {
        let grid = Grid::new([256, 256], [1e-6, 1e-6]).unwrap();
        let map = rough(grid, 0.3, [40e-6, 2e-6], 1e-7, 3);
        let rings = PowerSpectrum::of(&map, Window::None).unwrap().rings();
        assert_eq!(NoiseFloor::of(&rings, [1e-6, 1e-6]), None);
    }
}
