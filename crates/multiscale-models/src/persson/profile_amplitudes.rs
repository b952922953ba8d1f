//! Amplitudes of the profiles of a self-affine surface: what the stacked models take.

use super::self_affine::{MODEL, SelfAffineSpectrum};
use crate::special::gauss_legendre;
use contact_types::{AmplitudeSpectrum, ModelError, Wave, require};
use std::f64::consts::{PI, SQRT_2, TAU};

/// More waves than this on one record are refused: nobody measures such a profile.
const MOST_WAVES: f64 = 1e6;

impl SelfAffineSpectrum {
    /// Expected amplitudes of the waves `f_k = k/L` on profiles of length `L = record_length` (m).
    ///
    /// The profile through a surface of two-dimensional PSD C has the one-sided PSD
    ///
    /// ```math
    /// C_1(q) = 4 \int_0^\infty C\left(\sqrt{q^2 + t^2}\right) dt, \qquad
    /// v_k = \frac{2\pi}{L}\, C_1\!\left(\frac{2\pi k}{L}\right)
    /// ```
    ///
    /// and the amplitude of a Gaussian profile's k-th wave is Rayleigh distributed about its
    /// variance `v_k`, with the mean `sqrt(pi/2) sqrt(v_k)`: the mean modulus that a measured
    /// surface gives. It falls with the record length as `L^-1/2`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] for a record length that is not finite and positive;
    /// [`ModelError::OutsideDomain`] if it holds no wave of the spectrum, or more than a million.
    pub fn profile_amplitudes(&self, record_length: f64) -> Result<AmplitudeSpectrum, ModelError> {
        let length = require::positive(MODEL, "record length", record_length)?;
        let [_, rolloff, cutoff] = self.wavenumbers;
        let count = length * (cutoff / TAU) * (1.0 + 1e-12);
        if !(1.0..=MOST_WAVES).contains(&count) {
            let quantity = "record length over shortest wavelength";
            let reason = "a record needs at least one wave, and not more than a million";
            return Err(require::outside(MODEL, quantity, count, 1.0..=MOST_WAVES, reason));
        }
        let step = TAU / length / rolloff; // wavenumbers in units of the roll-off
        let waves = (1..=count as usize).map(|k| {
            // 2 pi C_1/(L m0), with C0 q_r^2 = m0 / (2 pi integral(0))
            let variance = step * self.profile_psd(k as f64 * step) * self.m0;
            Wave {
                frequency: k as f64 / length,
                amplitude: 0.5 * SQRT_2 * PI.sqrt() * variance.sqrt(),
            }
        });
        let requirement = "its amplitudes must be within the range of a double";
        AmplitudeSpectrum::new(waves.collect(), length)
            .map_err(|_| require::refused(MODEL, "record length", record_length, requirement))
    }

    /// `C_1(q) q_r / m0` at `x = q/q_r`.
    fn profile_psd(&self, x: f64) -> f64 {
        let [lower, rolloff, cutoff] = self.wavenumbers;
        let (low, high) = (lower / rolloff, cutoff / rolloff);
        // t from r = a to r = b along the line at distance x, r^2 = x^2 + t^2
        let chord = |r: f64| ((r - x) * (r + x)).max(0.0).sqrt();
        let plateau = chord(1.0) - chord(low).min(chord(1.0));
        // r = x cosh s:  int r^(-2-2H) dt = x^(-1-2H) int cosh(s)^(-1-2H) ds
        let exponent = -1.0 - 2.0 * self.hurst;
        let s_at = |r: f64| (r / x).max(1.0).acosh();
        let (from, to) = (s_at(1.0), s_at(high));
        let panels = ((to - from) / 0.5).ceil().max(1.0);
        let panel = (to - from) / panels;
        let mut power = 0.0;
        for i in 0..panels as usize {
            let start = from + i as f64 * panel;
            // x cosh(s) directly, so that a small x to a high power cannot overflow
            power += gauss_legendre(start, start + panel, 0.4, |s| (x * s.cosh()).powf(exponent));
        }
        2.0 / PI * (plateau + power) / self.integral(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    fn spectrum() -> SelfAffineSpectrum {
        // 0.5 um rms, roll-off 50 um, plateau to 200 um, cut-off 4 um
        let wavenumbers = [200e-6, 50e-6, 4e-6].map(|wavelength| TAU / wavelength);
        SelfAffineSpectrum::from_wavenumbers(0.7, wavenumbers, 0.25e-12).unwrap()
    }

    /// Variances of all waves add up to those of the surface: heights to m0 and slopes to m2.
    /// `v = 2 amplitude^2 / pi` undoes the Rayleigh mean.
    #[test]
    fn profiles_have_the_variance_and_slope_of_the_surface() {
        let length = 0.05; // so many waves that the sums are integrals
        let amplitudes = spectrum().profile_amplitudes(length).unwrap();
        let (mut m0, mut m2) = (0.0, 0.0);
        for wave in amplitudes.waves() {
            let variance = 2.0 * wave.amplitude.powi(2) / PI;
            m0 += variance;
            m2 += variance * (TAU * wave.frequency).powi(2);
        }
        let moments = spectrum().moments();
        // The wave at zero frequency, half of which belongs to the sum, is left out of m0.
        let zero = 0.5 * TAU / length * 4.0 * line_through_the_centre();
        close(m0 + zero, moments.m0, 1e-4);
        close(m2, moments.m2, 1e-4);
    }

    /// `int C(t) dt` from q_L to q_s, elementary.
    fn line_through_the_centre() -> f64 {
        let s = spectrum();
        let [lower, rolloff, cutoff] = s.wavenumbers;
        let plateau = 1.0 - lower / rolloff;
        let e = 1.0 + 2.0 * s.hurst;
        let power = (1.0 - (cutoff / rolloff).powf(-e)) / e;
        let c0 = s.m0 / (TAU * rolloff * rolloff * s.integral(0));
        c0 * rolloff * (plateau + power)
    }

    /// Another record of the same surface: amplitudes fall as L^-1/2.
    #[test]
    fn amplitudes_depend_on_the_record_length() {
        let one = spectrum().profile_amplitudes(200e-6).unwrap();
        let four = spectrum().profile_amplitudes(800e-6).unwrap();
        let (a, b) = (one.waves()[9].amplitude, four.waves()[39].amplitude);
        close(a, 2.0 * b, 1e-12);
        assert!(spectrum().profile_amplitudes(1e-6).is_err());
        assert!(spectrum().profile_amplitudes(1e3).is_err());
        assert!(spectrum().profile_amplitudes(f64::NAN).is_err());
    }
}
