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
}

/// The contact for one position of the contact line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwoHarmonicContact {
    surface: TwoHarmonic,
    half_angle: f64, // t_a
    q: [f64; 2],     // Q = q[0] + q[1] X [Pa]
}

impl TwoHarmonic {
    /// Height (m) at `x` from the middle of the strip.
    pub(crate) fn height(&self, x: f64) -> f64 {
        let t = TAU * x / self.wavelength;
        self.amplitudes[0] * t.cos() + self.amplitudes[1] * (2.0 * t).cos()
    }

    /// The contact whose strip covers `area_fraction` (between 0 and 1) of each period.
    pub(crate) fn at_area_fraction(&self, area_fraction: f64) -> TwoHarmonicContact {
        let half_angle = PI * area_fraction;
        let p = |n: usize| {
            PI * self.modulus.pascals() * n as f64 * self.amplitudes[n - 1] / self.wavelength
        };
        let q = [p(1) - p(2) * (1.0 - half_angle.cos()), 2.0 * p(2)];
        TwoHarmonicContact { surface: *self, half_angle, q }
    }
}

impl TwoHarmonicContact {
    /// Fraction of the surface in contact.
    pub(crate) fn area_fraction(&self) -> f64 {
        self.half_angle / PI
    }

    /// Mean pressure (Pa): the integral of the pressure over the strip, over the wavelength.
    pub(crate) fn mean_pressure(&self) -> f64 {
        let x_a = self.half_angle.cos();
        let p2 = 0.5 * self.q[1];
        0.5 * self.q[0] * (1.0 - x_a) + 0.5 * p2 * (1.0 - x_a + 0.5 * (1.0 - x_a * x_a))
    }

    /// Pressure (Pa) at `x` (m) from the middle of the strip.
    pub(crate) fn pressure(&self, x: f64) -> f64 {
        let (cosine, x_a) = ((TAU * x / self.surface.wavelength).cos(), self.half_angle.cos());
        let inside = (1.0 + cosine) * (cosine - x_a);
        inside.max(0.0).sqrt() * (self.q[0] + self.q[1] * cosine)
    }

    /// Gap (m) at `x` (m) from the middle of the strip: the slope integrated from the contact line.
    /// With `t = t_a + v^2` the integrand is smooth; Simpson's rule with 256 intervals.
    pub(crate) fn gap(&self, x: f64) -> f64 {
        let turns = (x / self.surface.wavelength).rem_euclid(1.0);
        let t_end = TAU * turns.min(1.0 - turns);
        if t_end <= self.half_angle {
            return 0.0;
        }
        let x_a = self.half_angle.cos();
        let slope = |v: f64| {
            let cosine = (self.half_angle + v * v).cos();
            let root = ((1.0 + cosine) * (x_a - cosine)).max(0.0).sqrt();
            root * (self.q[0] + self.q[1] * cosine) * 2.0 * v // dt = 2 v dv
        };
        let intervals = 256;
        let step = (t_end - self.half_angle).sqrt() / f64::from(intervals);
        let weight = |i: i32| match i {
            i if i == 0 || i == intervals => 1.0,
            i if i % 2 == 1 => 4.0,
            _ => 2.0,
        };
        let sum: f64 = (0..=intervals).map(|i| weight(i) * slope(f64::from(i) * step)).sum();
        let dx_dt = self.surface.wavelength / TAU;
        2.0 / self.surface.modulus.pascals() * dx_dt * sum * step / 3.0
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
        let two = TwoHarmonic { amplitudes: [0.2, 0.0], wavelength: 4.0, modulus };
        let one = Westergaard::new(0.2, 4.0, modulus).unwrap();
        let contact = two.at_area_fraction(0.4);
        let exact = one.at_pressure(contact.mean_pressure()).unwrap();
        close(exact.area_fraction(), 0.4, 1e-12);
        for x in [0.0, 0.3, 0.7, 1.1, 1.7, 2.0] {
            close(contact.pressure(x), exact.pressure(x), 1e-12);
            close(contact.gap(x), exact.gap(x), 1e-8);
        }
    }
}
