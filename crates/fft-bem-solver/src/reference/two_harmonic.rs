//! A ridge pattern of two harmonics with one contact strip per period.

use contact_types::ContactModulus;
use std::f64::consts::{PI, TAU};

/// The surface `z = amplitudes[0] cos t + amplitudes[1] cos 2t`, `t = 2 pi x / wavelength`.
///
/// With `P_n = pi E* n amplitude_n / wavelength`, `X = cos t` and the contact line at
/// `X_a = cos t_a`,
///
/// ```math
/// p=\sqrt{(1+X)(X-X_a)}\,Q(X),\qquad
/// \frac{dg}{dx}=\frac{2}{E^*}\,\mathrm{sgn}(\sin t)\sqrt{(1+X)(X_a-X)}\,Q(X),
/// ```
/// ```math
/// Q=q_0+q_1X,\quad q_1=2P_2,\quad q_0=P_1-P_2(1-X_a),\quad
/// \bar p=\tfrac{q_0}{2}(1-X_a)+\tfrac{P_2}{2}\bigl(1-X_a+\tfrac12(1-X_a^2)\bigr)
/// ```
///
/// One strip per period is assumed, which holds where the formula gives neither tension nor overlap.
///
/// # Source
/// After Manners (1998), *J. Mech. Phys. Solids* 46, 1; checked here by quadrature and against the
/// solver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwoHarmonic {
    /// Of the first (positive) and second (any sign) harmonic (m).
    pub(crate) amplitudes: [f64; 2],
    /// Of the first (m).
    pub(crate) wavelength: f64,
    pub(crate) modulus: ContactModulus,
    /// t_a at the contact line, between 0 and pi.
    pub(crate) half_angle: f64,
}

impl TwoHarmonic {
    /// Height (m) of the undeformed surface at `x` from the middle of the strip.
    pub(crate) fn height(&self, x: f64) -> f64 {
        let t = TAU * x / self.wavelength;
        self.amplitudes[0] * t.cos() + self.amplitudes[1] * (2.0 * t).cos()
    }

    /// X_a, q_0 and q_1 (Pa).
    fn line_and_q(&self) -> (f64, [f64; 2]) {
        let x_a = self.half_angle.cos();
        let p = |n: usize| {
            PI * self.modulus.pascals() * n as f64 * self.amplitudes[n - 1] / self.wavelength
        };
        (x_a, [p(1) - p(2) * (1.0 - x_a), 2.0 * p(2)])
    }

    /// Fraction of the surface in contact.
    pub(crate) fn area_fraction(&self) -> f64 {
        self.half_angle / PI
    }

    /// Mean pressure (Pa): the integral of the pressure over the strip, over the wavelength.
    pub(crate) fn mean_pressure(&self) -> f64 {
        let (x_a, q) = self.line_and_q();
        let p2 = 0.5 * q[1];
        0.5 * q[0] * (1.0 - x_a) + 0.5 * p2 * (1.0 - x_a + 0.5 * (1.0 - x_a * x_a))
    }

    /// Pressure (Pa) at `x` (m) from the middle of the strip.
    pub(crate) fn pressure(&self, x: f64) -> f64 {
        let (x_a, q) = self.line_and_q();
        let cosine = (TAU * x / self.wavelength).cos();
        let inside = (1.0 + cosine) * (cosine - x_a);
        inside.max(0.0).sqrt() * (q[0] + q[1] * cosine)
    }

    /// Gap (m) at `x` (m) from the middle of the strip: the slope integrated from the contact line.
    /// With `t = t_a + v^2` the integrand is smooth; Simpson's rule with 256 intervals.
    pub(crate) fn gap(&self, x: f64) -> f64 {
        let (x_a, q) = self.line_and_q();
        let turns = (x / self.wavelength).rem_euclid(1.0);
        let t_end = TAU * turns.min(1.0 - turns);
        if t_end <= self.half_angle {
            return 0.0;
        }
        let slope = |v: f64| {
            let cosine = (self.half_angle + v * v).cos();
            let root = ((1.0 + cosine) * (x_a - cosine)).max(0.0).sqrt();
            root * (q[0] + q[1] * cosine) * 2.0 * v // dt = 2 v dv
        };
        let intervals = 256;
        let step = (t_end - self.half_angle).sqrt() / f64::from(intervals);
        let weight = |i: i32| match i {
            i if i == 0 || i == intervals => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=intervals).map(|i| weight(i) * slope(f64::from(i) * step)).sum();
        let dx_dt = self.wavelength / TAU;
        2.0 / self.modulus.pascals() * dx_dt * sum * step / 3.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use crate::reference::Westergaard;

    #[test]
    fn one_harmonic_is_westergaard() {
        let modulus = ContactModulus::from_pascals(3.0).unwrap();
        let (amplitudes, half_angle) = ([0.2, 0.0], 0.4 * PI);
        let contact = TwoHarmonic { amplitudes, wavelength: 4.0, modulus, half_angle };
        let one = Westergaard { amplitude: 0.2, wavelength: 4.0, modulus, m: 1.0 };
        let m = contact.mean_pressure() / one.closing_pressure();
        let exact = Westergaard { m, ..one };
        close(exact.area_fraction(), 0.4, 1e-12);
        for x in [0.0, 0.3, 0.7, 1.1, 1.7, 2.0] {
            close(contact.pressure(x), exact.pressure(x), 1e-12);
            close(contact.gap(x), exact.gap(x), 1e-8);
        }
    }
}
