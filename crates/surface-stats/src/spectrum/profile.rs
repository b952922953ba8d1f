//! Spectra of the rows of a map.

use super::window::hann;
use crate::StatsError;
use contact_types::{AmplitudeSpectrum, HeightMap, Wave};
use grid_fft::GridFft;

/// One frequency of a profile spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ProfileBin {
    /// f = 1/wavelength (1/m).
    pub(crate) frequency: f64,
    /// One-sided PSD S(f) with `∫_0^∞ S df` the variance of a profile about its own mean (m³).
    pub(crate) psd: f64,
}

/// Amplitude of the sinusoids of the rows, averaged over rows: input of the stacked multiscale
/// models.
///
/// ```math
/// \Delta_k = \frac{2}{N} \langle |H_k| \rangle, \qquad f_k = \frac{k}{L}, \qquad
/// k = 1 \dots N/2 \quad (\tfrac1N \text{ at Nyquist})
/// ```
///
/// The moduli are averaged, not the squares, and neither a window nor a detrending is applied.
/// The amplitudes of a random surface fall as the square root of the record length L, which is
/// therefore part of the result.
///
/// # Errors
/// [`StatsError::TooSmall`] for rows of a single point.
///
/// # Source
/// Jackson & Streator (2006), doi:10.1016/j.wear.2006.03.015.
pub fn amplitudes(map: &HeightMap) -> Result<AmplitudeSpectrum, StatsError> {
    let (shape, [_, length]) = (map.grid().shape(), map.grid().size());
    let [rows, n] = shape;
    StatsError::require_shape("a profile spectrum", shape, [1, 2])?;
    let (mean, mut fft) = (map.mean(), GridFft::new([1, n]));
    let (mut line, mut spectrum) = (vec![0.0; n], fft.new_spectrum());
    let mut moduli = vec![0.0; n / 2 + 1];
    for row in map.heights().chunks_exact(n) {
        line.iter_mut().zip(row).for_each(|(z, h)| *z = h - mean);
        fft.forward(&line, &mut spectrum);
        moduli.iter_mut().zip(&spectrum).for_each(|(sum, wave)| *sum += wave.norm());
    }
    let wave = |k: usize| Wave {
        frequency: k as f64 / length,
        amplitude: moduli[k] / rows as f64 * if 2 * k == n { 1.0 } else { 2.0 } / n as f64,
    };
    Ok(AmplitudeSpectrum::new((1..moduli.len()).map(wave).collect(), length)?)
}

/// One-sided PSD of a map of one row, under a Hann window.
pub(crate) fn psd_1d(line: &HeightMap) -> Vec<ProfileBin> {
    let ([_, n], [_, length]) = (line.grid().shape(), line.grid().size());
    let (mean, weights) = (line.mean(), hann(n));
    let mut field: Vec<f64> = line.heights().iter().map(|h| h - mean).collect();
    let own = field.iter().zip(&weights).map(|(z, w)| z * w).sum::<f64>();
    let own = own / weights.iter().sum::<f64>();
    field.iter_mut().zip(&weights).for_each(|(z, w)| *z = w * (*z - own));
    let mut fft = GridFft::new([1, n]);
    let mut spectrum = fft.new_spectrum();
    fft.forward(&field, &mut spectrum);
    let bin = |k: usize| {
        let sides = if 2 * k == n { 1.0 } else { 2.0 };
        let variance = sides * (spectrum[k] / n as f64).norm_sqr();
        ProfileBin { frequency: k as f64 / length, psd: variance * length }
    };
    (1..spectrum.len()).map(bin).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_relative_eq;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    /// Amplitude A of a cosine, and its variance A²/2 under the PSD; of an odd number of points too.
    #[test]
    fn a_cosine_along_the_rows() {
        for n in [24, 25] {
            let grid = Grid::new([1, n], [2e-6, 1e-6]).unwrap();
            let ([_, length], amplitude) = (grid.size(), 3e-8);
            let wave = |_: f64, x: f64| 1e-3 + amplitude * (TAU * 5.0 / length * x).cos();
            let map = HeightMap::from_fn(grid, wave).unwrap();
            for (i, wave) in amplitudes(&map).unwrap().waves().iter().enumerate() {
                let expected = if i == 4 { amplitude } else { 0.0 };
                assert_relative_eq!(wave.amplitude, expected, epsilon = 1e-18);
            }
            let variance: f64 = psd_1d(&map).iter().map(|bin| bin.psd / length).sum();
            close(variance, amplitude * amplitude / 2.0, 1e-9);
        }
        let point = HeightMap::new(Grid::new([4, 1], [1.0, 1.0]).unwrap(), vec![0.0; 4]).unwrap();
        assert!(matches!(amplitudes(&point), Err(StatsError::TooSmall { .. })));
    }
}
