//! What measurement noise does to the moments, and where a spectrum ends in it.

use crate::spectrum::Ring;
use contact_types::SpectralMoments;
use std::f64::consts::{PI, TAU};

/// A PSD falls at least as q⁻² on any self-affine surface; flatter than this at the shortest
/// waves is taken for noise.
const FLAT_SLOPE: f64 = -1.0;

/// Waves belong to the surface where the PSD is this many times the floor.
const SIGNAL: f64 = 3.0;

/// What white noise of rms `s` (m) adds to the moments by finite differences on pixels
/// `[dy, dx]` (m): s² to m0, `s² (1/dx² + 1/dy²)` to m2, `3 s² (1/dx⁴ + 1/dy⁴)` to m4.
///
/// Rounding to steps of height Q is noise of rms Q/√12, if the relief changes by a step or more
/// from pixel to pixel.
pub(crate) fn white_noise_moments(s: f64, [dy, dx]: [f64; 2]) -> SpectralMoments {
    SpectralMoments {
        m0: s * s,
        m2: (s / dx).powi(2) + (s / dy).powi(2),
        m4: 3.0 * ((s / dx / dx).powi(2) + (s / dy / dy).powi(2)),
    }
}

/// The level at which a PSD stops falling.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct NoiseFloor {
    /// C of the floor (m⁴).
    pub psd: f64,
    /// Rms height of white noise with this PSD (m).
    pub rms: f64,
    /// Shortest wavelength at which the PSD is three times the floor (m): the end of the reliable
    /// bandwidth. `None` if there is none: the map cannot be told from noise.
    pub reliable: Option<f64>,
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
        // Slope from the means of the two halves of the octave, whose centres are 0.75 / 0.5 and
        // 1 / 0.75 of each other: ln ratio of the centres is ln(0.875 / 0.625).
        let (low, high) = last_octave.split_at(last_octave.len() / 2);
        let psd = mean(high);
        let slope = (psd / mean(low)).ln() / (0.875f64 / 0.625).ln();
        if psd <= 0.0 || slope < FLAT_SLOPE {
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
        Some(Self { psd, rms: TAU * (psd / (dy * dx)).sqrt(), reliable })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{PowerSpectrum, Window};
    use crate::synthesis::{Scale, SelfAffine};
    use crate::{DirectionalMoments, Edges};
    use approx::assert_relative_eq;
    use contact_types::{Grid, HeightMap};

    fn surface(cutoff: f64, rms: f64, seed: u64) -> HeightMap {
        let recipe = SelfAffine {
            grid: Grid::new([300, 256], [1e-6, 1.2e-6]).unwrap(),
            hurst: 0.8,
            rolloff: if cutoff > 5e-6 { 40e-6 } else { cutoff },
            cutoff,
            scale: Scale::RmsHeight(rms),
            seed,
            quantise: None,
        };
        recipe.generate().unwrap()
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
        let expected = white_noise_moments(3e-9, map.grid().pixel());
        let m = DirectionalMoments::of(&map, Edges::Periodic).unwrap().isotropic(9e-18);
        assert_relative_eq!(m.m2, expected.m2, max_relative = 0.1);
        assert_relative_eq!(m.m4, expected.m4, max_relative = 0.1);
    }

    /// Noise of 2 nm under a surface that ends at 8 um: level and end of the reliable band.
    #[test]
    fn finds_the_floor_and_where_it_begins() {
        let (clean, noise) = (surface(8e-6, 200e-9, 1), surface(2.4e-6, 2e-9, 2));
        let heights = clean.heights().iter().zip(noise.heights()).map(|(a, b)| a + b).collect();
        let noisy = HeightMap::new(clean.grid(), heights).unwrap();
        let pixel = noisy.grid().pixel();
        let rings = PowerSpectrum::of(&noisy, Window::None).unwrap().rings();
        let floor = NoiseFloor::of(&rings, pixel).unwrap();
        // The noise fills a circle of radius 2 pi / 2.4 um of the plane (2 pi)² / (dy dx).
        let q = TAU / 2.4e-6;
        assert_relative_eq!(floor.psd, 4e-18 / (PI * q * q), max_relative = 0.05);
        assert_relative_eq!(floor.rms, TAU * (floor.psd / 1.2e-12).sqrt(), max_relative = 1e-12);
        assert_relative_eq!(floor.reliable.unwrap(), 8e-6, max_relative = 0.05);
        let rings = PowerSpectrum::of(&noise, Window::None).unwrap().rings();
        assert_eq!(NoiseFloor::of(&rings, pixel).unwrap().reliable, None);
    }

    /// Every second column off by as much as the noise: a line at the shortest wave, which is no surface.
    #[test]
    fn a_line_in_the_noise_is_no_band() {
        let (clean, noise) = (surface(8e-6, 200e-9, 1), surface(2.4e-6, 2e-9, 2));
        let [_, nx] = clean.grid().shape();
        let both = clean.heights().iter().zip(noise.heights()).enumerate();
        let heights = both.map(|(i, (a, b))| a + b + if i % nx % 2 == 0 { 2e-9 } else { -2e-9 });
        let map = HeightMap::new(clean.grid(), heights.collect()).unwrap();
        let rings = PowerSpectrum::of(&map, Window::None).unwrap().rings();
        let floor = NoiseFloor::of(&rings, map.grid().pixel()).unwrap();
        assert_relative_eq!(floor.reliable.unwrap(), 8e-6, max_relative = 0.05);
    }

    #[test]
    fn a_falling_spectrum_has_no_floor() {
        let recipe = SelfAffine {
            grid: Grid::new([256, 256], [1e-6, 1e-6]).unwrap(),
            hurst: 0.3,
            rolloff: 40e-6,
            cutoff: 2e-6,
            scale: Scale::RmsHeight(1e-7),
            seed: 3,
            quantise: None,
        };
        let rings = PowerSpectrum::of(&recipe.generate().unwrap(), Window::None).unwrap().rings();
        assert_eq!(NoiseFloor::of(&rings, [1e-6, 1e-6]), None);
    }
}
