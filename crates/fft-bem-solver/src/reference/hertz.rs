//! Hertz: two elastic bodies with curved surfaces.

use contact_types::require::{not_negative, positive};
use contact_types::{ContactModulus, ModelError};
use std::f64::consts::{FRAC_PI_2, PI};

/// A smooth, non-conforming contact without friction: a paraboloid
/// `z = -x^2 / (2 R_x) - y^2 / (2 R_y)` against a flat.
///
/// ```math
/// p = p_0\sqrt{1-(x/a)^2-(y/b)^2},\quad F=\tfrac23\pi a b\,p_0,\quad
/// \text{sphere: } a^3=\frac{3FR}{4E^*},\ \delta=\frac{a^2}{R}
/// ```
///
/// For unequal radii, with `k = b/a <= 1` the ratio of the semi-axes, `m = 1 - k^2` and the complete
/// elliptic integrals `K(m)`, `E(m)`,
///
/// ```math
/// \frac{\kappa_2}{\kappa_1}=\frac{k^2(K-E)}{E-k^2K},\quad
/// b^2=\frac{2\delta E}{K(\kappa_1+\kappa_2)},\quad p_0=\frac{E^*\delta}{bK}
/// ```
///
/// with the curvatures `kappa_1 >= kappa_2`; `b` lies along the larger curvature.
///
/// # Source
/// Hertz (1882), *J. reine angew. Math.* 92, 156; Johnson (1985), *Contact Mechanics*, §4.2,
/// doi:10.1017/CBO9781139171731.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Hertz {
    radii: [f64; 2],
    /// Force (N).
    pub force: f64,
    /// Approach of distant points (m).
    pub approach: f64,
    /// Semi-axes of the contact along y and x, `[a_y, a_x]` (m).
    pub semi_axes: [f64; 2],
    /// Pressure in the middle (Pa).
    pub max_pressure: f64,
}

impl Hertz {
    /// The contact of `radii = [R_y, R_x]` of curvature (m), up to 1 : 1e12, when distant points have approached by
    /// `approach` (m). Those of a sphere are equal; of two, `1/R = 1/R_1 + 1/R_2`.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if a radius is not finite and positive, or the approach not finite or negative.
    pub fn at_approach(
        radii: [f64; 2],
        modulus: ContactModulus,
        approach: f64,
    ) -> Result<Self, ModelError> {
        for (radius, name) in radii.into_iter().zip(["radius R_y", "radius R_x"]) {
            positive("Hertz", name, radius)?;
        }
        let approach = not_negative("Hertz", "approach", approach)?;
        let axis_ratio = axis_ratio(radii[0].min(radii[1]) / radii[0].max(radii[1]));
        let (k_integral, e_integral, _) = elliptic(axis_ratio);
        let curvatures = 1.0 / radii[0] + 1.0 / radii[1];
        let b = (2.0 * approach * e_integral / (k_integral * curvatures)).sqrt();
        let a = b / axis_ratio;
        let semi_axes = if radii[0] <= radii[1] { [b, a] } else { [a, b] };
        let max_pressure =
            if approach > 0.0 { modulus.pascals() * approach / (b * k_integral) } else { 0.0 };
        let force = 2.0 / 3.0 * PI * a * b * max_pressure;
        Ok(Self { radii, force, approach, semi_axes, max_pressure })
    }

    /// The same under `force` (N), which grows as approach to the power 3/2.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if a radius is not finite and positive, or the force not finite or negative.
    pub fn at_force(
        radii: [f64; 2],
        modulus: ContactModulus,
        force: f64,
    ) -> Result<Self, ModelError> {
        let force = not_negative("Hertz", "force", force)?;
        let unit = radii[0].min(radii[1]);
        let at_unit = Self::at_approach(radii, modulus, unit)?;
        let approach = unit * (force / at_unit.force).powf(2.0 / 3.0);
        Ok(Self { force, ..Self::at_approach(radii, modulus, approach)? })
    }

    /// Height of the undeformed paraboloid (m) at `(y, x)` from its highest point.
    pub fn height(&self, y: f64, x: f64) -> f64 {
        -0.5 * (y * y / self.radii[0] + x * x / self.radii[1])
    }

    /// Area of contact (m²).
    pub(crate) fn area(&self) -> f64 {
        PI * self.semi_axes[0] * self.semi_axes[1]
    }

    /// Pressure (Pa) at `(y, x)` from the middle (m).
    pub(crate) fn pressure(&self, y: f64, x: f64) -> f64 {
        let [a_y, a_x] = self.semi_axes;
        self.max_pressure * (1.0 - (x / a_x).powi(2) - (y / a_y).powi(2)).max(0.0).sqrt()
    }
}

/// `K(1 - k^2)`, `E(1 - k^2)` and `kappa_2 / kappa_1` of the ellipse with axis ratio `k`, by the
/// arithmetic-geometric mean: `K = pi / (2 agm(1, k))`, `1 - E/K = sum 2^(n-1) c_n^2`. No
/// difference of nearly equal numbers is formed as k -> 1.
fn elliptic(k: f64) -> (f64, f64, f64) {
    let m = (1.0 - k) * (1.0 + k);
    let (mut a, mut b) = (1.0, k);
    let (mut weight, mut beyond_first) = (0.5, 0.0); // sum over n >= 1
    for _ in 0..40 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
        weight *= 2.0;
        beyond_first += weight * c * c;
        if c.abs() <= 1e-17 * a {
            break;
        }
    }
    let k_integral = FRAC_PI_2 / a;
    let k_minus_e = 0.5 * m + beyond_first; // (K - E) / K
    let e_minus_k2k = 0.5 * m - beyond_first; // (E - k^2 K) / K
    let ratio = if m > 0.0 { k * k * k_minus_e / e_minus_k2k } else { 1.0 };
    (k_integral, k_integral * (1.0 - k_minus_e), ratio)
}

/// The axis ratio k of the ellipse for a ratio of curvatures, by bisection in `ln k`.
fn axis_ratio(curvature_ratio: f64) -> f64 {
    if curvature_ratio >= 1.0 {
        return 1.0;
    }
    let (mut low, mut high) = (-40.0_f64, 0.0_f64);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        let (_, _, ratio) = elliptic(middle.exp());
        if ratio < curvature_ratio {
            low = middle;
        } else {
            high = middle;
        }
    }
    (0.5 * (low + high)).exp()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    #[test]
    fn sphere_has_the_textbook_formulas() {
        let modulus = ContactModulus::from_pascals(115e9).unwrap();
        let (radius, force) = (2e-3, 3.0);
        let contact = Hertz::at_force([radius; 2], modulus, force).unwrap();
        let a = (3.0 * force * radius / (4.0 * 115e9_f64)).cbrt();
        close(contact.semi_axes[0], a, 1e-14);
        close(contact.semi_axes[1], a, 1e-14);
        close(contact.approach, a * a / radius, 1e-14);
        let p0 = 3.0 * force / (2.0 * PI * a * a);
        close(contact.max_pressure, p0, 1e-14);
    }

    /// 30-digit values from the ellipsoidal potential; larger curvature, modulus and approach 1.
    #[test]
    fn ellipse_agrees_with_the_table() {
        let table = include_str!("../../../../fixtures/reference/hertz_ellipse.csv");
        let mut rows = 0;
        for line in table.lines().filter(|l| !l.starts_with('#')).skip(1) {
            let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
            let &[ratio, k, a, b, p0, area, load] = &v[..] else { panic!("{line}") };
            let modulus = ContactModulus::from_pascals(1.0).unwrap();
            let contact = Hertz::at_approach([1.0, 1.0 / ratio], modulus, 1.0).unwrap();
            close(contact.semi_axes[0] / contact.semi_axes[1], k, 2e-13);
            close(contact.semi_axes[0], b, 2e-13);
            close(contact.semi_axes[1], a, 2e-13);
            close(contact.max_pressure, p0, 2e-13);
            close(contact.area(), area, 2e-13);
            close(contact.force, load, 2e-13);
            rows += 1;
        }
        assert!(rows >= 9);
    }
}
