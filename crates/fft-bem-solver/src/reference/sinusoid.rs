//! Westergaard: a sinusoidal ridge pattern against a flat.

use contact_types::ContactModulus;
use std::f64::consts::{FRAC_2_PI, PI};

/// The surface `z = amplitude cos(2 pi x / wavelength)`, the same at every y, pressed on a flat.
///
/// ```math
/// p^*=\frac{\pi E^*\Delta}{\lambda},\quad m=\frac{\bar p}{p^*}=\sin^2\psi_a,\quad
/// \psi=\frac{\pi x}{\lambda},\quad p=2p^*\cos\psi\sqrt{m-\sin^2\psi}
/// ```
///
/// `p*` closes every gap.
///
/// # Source
/// Westergaard (1939), *J. Appl. Mech.* 6, A49; Johnson (1985), *Contact Mechanics*, §13.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Westergaard {
    /// Amplitude (m), above 0.
    pub amplitude: f64,
    /// Wavelength (m), above 0.
    pub wavelength: f64,
    /// Contact modulus.
    pub modulus: ContactModulus,
    /// Mean pressure over `p*`, at least 0.
    pub m: f64,
}

impl Westergaard {
    /// Height (m) of the undeformed surface at `x` from a crest.
    pub fn height(&self, x: f64) -> f64 {
        self.amplitude * (2.0 * PI * x / self.wavelength).cos()
    }

    /// Mean pressure p* that closes every gap (Pa).
    pub fn closing_pressure(&self) -> f64 {
        PI * self.modulus.pascals() * self.amplitude / self.wavelength
    }

    /// Fraction of the surface in contact, `2/pi asin sqrt m`.
    pub fn area_fraction(&self) -> f64 {
        FRAC_2_PI * self.m.min(1.0).sqrt().asin()
    }

    /// Pressure (Pa) at `x` (m) from a crest.
    pub fn pressure(&self, x: f64) -> f64 {
        let p_star = self.closing_pressure();
        let psi = PI * x / self.wavelength;
        if self.m >= 1.0 {
            // All in contact: the mean and the wave that flattens the surface.
            return p_star * (self.m + (2.0 * psi).cos());
        }
        let inside = self.m - psi.sin().powi(2);
        2.0 * p_star * psi.cos().abs() * inside.max(0.0).sqrt()
    }

    /// Gap (m) at `x` (m) from a crest:
    /// `2 amplitude (s sqrt(s^2 - m) - m arcosh(s / sqrt m))`, `s = |sin psi|`.
    pub fn gap(&self, x: f64) -> f64 {
        let s = (PI * x / self.wavelength).sin().abs();
        let m = self.m;
        if s * s <= m || m >= 1.0 {
            return 0.0;
        }
        let logarithm = if m > 0.0 { m * (s / m.sqrt()).acosh() } else { 0.0 };
        2.0 * self.amplitude * (s * (s * s - m).sqrt() - logarithm)
    }

    /// Mean gap (m), `amplitude (1 - m + m ln m)`.
    pub(crate) fn mean_gap(&self) -> f64 {
        let m = self.m;
        match m {
            0.0 => self.amplitude,
            _ if m < 1.0 => self.amplitude * (1.0 - m + m * m.ln()),
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_abs_diff_eq;

    /// 25-digit values; columns m, area fraction, mean gap / amplitude, energy / (p* amplitude),
    /// then x / wavelength, p / p*, gap / amplitude.
    #[test]
    fn agrees_with_the_table() {
        let table = include_str!("../../../../fixtures/reference/westergaard.csv");
        let modulus = ContactModulus::from_pascals(7.0).unwrap();
        let mut rows = 0;
        for line in table.lines().filter(|l| !l.starts_with('#')).skip(1) {
            let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            let &[m, area, mean_gap, _, x, p, gap] = &v[..] else { panic!("{line}") };
            let contact = Westergaard { amplitude: 0.3, wavelength: 5.0, modulus, m };
            let p_star = contact.closing_pressure();
            close(contact.area_fraction(), area, 1e-12);
            // 1 - m + m ln m loses digits as m -> 1.
            assert_abs_diff_eq!(contact.mean_gap() / 0.3, mean_gap, epsilon = 1e-15);
            // Near the contact line p goes as the root of a difference.
            let epsilon = 1e-7 * f64::from(p < 1e-6) + 1e-12;
            assert_abs_diff_eq!(contact.pressure(5.0 * x) / p_star, p, epsilon = epsilon);
            assert_abs_diff_eq!(contact.gap(5.0 * x) / 0.3, gap, epsilon = 1e-12);
            rows += 1;
        }
        assert!(rows >= 30);
    }
}
