//! Spectra of the rows or columns of a map.

use super::Window;
use crate::{StatsError, scale};
use contact_types::{AmplitudeSpectrum, Axis, HeightMap, Wave};
use grid_fft::{Complex, GridFft};

/// One frequency of a profile spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct ProfileBin {
    /// f = 1/wavelength (1/m).
    pub frequency: f64,
    /// One-sided PSD S(f) with `∫_0^∞ S df` the variance of a profile about its own mean,
    /// averaged over profiles (m³).
    pub psd: f64,
}

/// Calls `visit` with the half spectrum of every profile along `axis`.
fn for_each_profile(
    map: &HeightMap,
    axis: Axis,
    window: Window,
    mut visit: impl FnMut(&[Complex<f64>]),
) {
    let [ny, nx] = map.grid().shape();
    let (n, profiles) = if axis == Axis::X { (nx, ny) } else { (ny, nx) };
    let weights = window.weights(n);
    let weight_sum: f64 = weights.iter().sum();
    let mean = map.mean();
    let mut fft = GridFft::new([1, n]);
    let (mut line, mut spectrum) = (vec![0.0; n], fft.new_spectrum());
    for p in 0..profiles {
        for (i, z) in line.iter_mut().enumerate() {
            let h = if axis == Axis::X { map.at(p, i) } else { map.at(i, p) };
            *z = h - mean;
        }
        if window != Window::None {
            let own = line.iter().zip(&weights).map(|(z, w)| z * w).sum::<f64>() / weight_sum;
            for (z, w) in line.iter_mut().zip(&weights) {
                *z = w * (*z - own);
            }
        }
        fft.forward(&line, &mut spectrum);
        visit(&spectrum);
    }
}

/// Amplitude of the sinusoids of the profiles along `axis`, averaged over profiles: input of the
/// stacked multiscale models.
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
/// [`StatsError::TooSmall`] for profiles of a single point; [`StatsError::OutOfRange`].
///
/// # Source
/// Jackson & Streator (2006), doi:10.1016/j.wear.2006.03.015.
pub fn amplitudes(map: &HeightMap, axis: Axis) -> Result<AmplitudeSpectrum, StatsError> {
    scale::check(map)?;
    amplitudes_of_levelled(map, axis)
}

/// Of a map whose unlevelled heights were in range: what levelling leaves may be rounding.
pub(crate) fn amplitudes_of_levelled(
    map: &HeightMap,
    axis: Axis,
) -> Result<AmplitudeSpectrum, StatsError> {
    let (n, profiles, length) = profiles(map, axis)?;
    let mut moduli = vec![0.0; n / 2 + 1];
    for_each_profile(map, axis, Window::None, |spectrum| {
        for (sum, wave) in moduli.iter_mut().zip(spectrum) {
            *sum += wave.norm();
        }
    });
    let wave = |k: usize| Wave {
        frequency: k as f64 / length,
        amplitude: moduli[k] / profiles as f64 * if 2 * k == n { 1.0 } else { 2.0 } / n as f64,
    };
    Ok(AmplitudeSpectrum::new((1..moduli.len()).map(wave).collect(), length)?)
}

/// One-sided PSD of the profiles along `axis`, averaged over profiles.
///
/// # Errors
/// [`StatsError::TooSmall`] for profiles of a single point; [`StatsError::OutOfRange`].
pub fn psd_1d(map: &HeightMap, axis: Axis, window: Window) -> Result<Vec<ProfileBin>, StatsError> {
    scale::check(map)?;
    let (n, profiles, length) = profiles(map, axis)?;
    let mut power = vec![0.0; n / 2 + 1];
    for_each_profile(map, axis, window, |spectrum| {
        for (sum, wave) in power.iter_mut().zip(spectrum) {
            *sum += (*wave / n as f64).norm_sqr();
        }
    });
    let bin = |k: usize| {
        let sides = if 2 * k == n { 1.0 } else { 2.0 };
        let variance = sides * power[k] / profiles as f64;
        ProfileBin { frequency: k as f64 / length, psd: variance * length }
    };
    Ok((1..power.len()).map(bin).collect())
}

/// Points per profile, number of profiles, length in metres.
fn profiles(map: &HeightMap, axis: Axis) -> Result<(usize, usize, f64), StatsError> {
    let (shape, size) = (map.grid().shape(), map.grid().size());
    let n = shape[axis.index()];
    if n < 2 {
        let what = "a profile spectrum";
        let needed = if axis == Axis::X { [1, 2] } else { [2, 1] };
        return Err(StatsError::TooSmall { what, shape, needed });
    }
    Ok((n, shape[1 - axis.index()], size[axis.index()]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    /// Along each axis: amplitude A of a cosine, and its variance A²/2 under the PSD.
    #[test]
    fn a_cosine_along_either_axis() {
        for (axis, shape) in [(Axis::X, [5, 24]), (Axis::Y, [24, 5]), (Axis::X, [1, 25])] {
            let grid = Grid::new(shape, [2e-6, 1e-6]).unwrap();
            let length = grid.size()[axis.index()];
            let (amplitude, q) = (3e-8, TAU * 5.0 / length);
            let along = |y, x| if axis == Axis::X { x } else { y };
            let map = HeightMap::from_fn(grid, |y, x| 1e-3 + amplitude * (q * along(y, x)).cos())
                .unwrap();
            let spectrum = amplitudes(&map, axis).unwrap();
            assert_relative_eq!(spectrum.record_length(), length);
            for (i, wave) in spectrum.waves().iter().enumerate() {
                let expected = if i == 4 { amplitude } else { 0.0 };
                assert_relative_eq!(wave.amplitude, expected, epsilon = 1e-18);
            }
            let ratio = spectrum.max_amplitude_ratio();
            assert_relative_eq!(ratio, amplitude * 5.0 / length, max_relative = 1e-10);
            let psd = psd_1d(&map, axis, Window::None).unwrap();
            let variance: f64 = psd.iter().map(|bin| bin.psd / length).sum();
            assert_relative_eq!(variance, amplitude * amplitude / 2.0, max_relative = 1e-9);
        }
    }

    #[test]
    fn one_point_is_no_profile() {
        let map = HeightMap::new(Grid::new([1, 4], [1.0, 1.0]).unwrap(), vec![0.0; 4]).unwrap();
        assert!(matches!(amplitudes(&map, Axis::Y), Err(StatsError::TooSmall { .. })));
    }
}
