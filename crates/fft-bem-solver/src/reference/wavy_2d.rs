//! The bi-sinusoid: an egg-box against a flat.

use contact_types::require::positive;
use contact_types::{ContactModulus, ModelError};
use std::f64::consts::{PI, SQRT_2};

/// The surface `z = amplitude cos(2 pi x / wavelength) cos(2 pi y / wavelength)` pressed on a flat.
///
/// No closed form is known between its two limits; a table in this module holds converged calculations.
///
/// ```math
/// p^*=\sqrt2\,\pi E^*\frac{\Delta}{\lambda},\quad x=\frac{\bar p}{p^*},\quad
/// \frac{A_r}{A_n}\to\pi\Bigl(\frac{3x}{8\pi}\Bigr)^{2/3}\ (x\to0),\quad
/// \frac{A_r}{A_n}\to1-\frac{3}{2\pi}(1-x)\ (x\to1)
/// ```
///
/// # Source
/// Johnson, Greenwood & Higginson (1985), *Int. J. Mech. Sci.* 27, 383–396,
/// doi:10.1016/0020-7403(85)90029-3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BiSinusoid {
    amplitude: f64,
    wavelength: f64,
    modulus: ContactModulus,
}

/// One row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BiSinusoidRow {
    /// Mean pressure over p*.
    pub(crate) pressure_ratio: f64,
    /// Area fraction.
    pub(crate) area_fraction: f64,
    /// Its uncertainty.
    pub(crate) area_uncertainty: f64,
    /// Mean gap over amplitude.
    pub(crate) mean_gap: f64,
    /// Its uncertainty.
    pub(crate) gap_uncertainty: f64,
}

const fn row(
    x: f64,
    area: f64,
    area_uncertainty: f64,
    gap: f64,
    gap_uncertainty: f64,
) -> BiSinusoidRow {
    BiSinusoidRow {
        pressure_ratio: x,
        area_fraction: area,
        area_uncertainty,
        mean_gap: gap,
        gap_uncertainty,
    }
}

/// FFT conjugate-gradient solutions with 1024 x 1024 nodes per asperity, area by sub-pixel
/// extrapolation of the squared pressure to zero; uncertainty from the change between 512 and 1024
/// nodes. Independent check: the mean gap integrates over x to 0.125004 (exact: 1/8).
pub(crate) const ROWS: [BiSinusoidRow; 21] = [
    row(0.0005, 0.004822, 2e-5, 0.9718326, 1e-6),
    row(0.001, 0.007658, 2.1e-5, 0.95611729, 3e-6),
    row(0.005, 0.022685, 2.4e-5, 0.88015147, 9e-7),
    row(0.01, 0.036405, 2e-5, 0.81829047, 8e-7),
    row(0.05, 0.112986, 2e-5, 0.55637067, 1e-6),
    row(0.1, 0.1906, 2e-5, 0.38474924, 4e-7),
    row(0.2, 0.345216, 3.7e-5, 0.20463362, 1e-6),
    row(0.25, 0.443669, 3.3e-5, 0.15819466, 4e-7),
    row(0.3, 0.51412, 5e-5, 0.124881, 1e-6),
    row(0.35, 0.570822, 2e-5, 0.098390347, 2e-7),
    row(0.4, 0.619974, 4.2e-5, 0.076908215, 9e-8),
    row(0.5, 0.704252, 2e-5, 0.045077954, 1e-7),
    row(0.55, 0.741451, 3e-5, 0.033479867, 9e-8),
    row(0.65, 0.808972, 2e-5, 0.016813954, 4e-8),
    row(0.7, 0.839964, 2e-5, 0.011131324, 9e-8),
    row(0.8, 0.897641, 3.4e-5, 0.0038465266, 6e-8),
    row(0.85, 0.924671, 2.3e-5, 0.0018327577, 3e-8),
    row(0.9, 0.95068, 5e-5, 6.5145e-4, 1e-8),
    row(0.95, 0.975765, 7.1e-5, 0.00011296285, 2e-9),
    row(0.98, 0.990402, 1.19e-4, 1.1308283e-5, 5e-9),
    row(0.99, 0.99524, 1.2e-4, 1.992e-6, 5e-9),
];

impl BiSinusoid {
    /// Amplitude (mean plane to summit) and wavelength along x and y in m.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if one is not finite and positive.
    pub fn new(
        amplitude: f64,
        wavelength: f64,
        modulus: ContactModulus,
    ) -> Result<Self, ModelError> {
        positive("bi-sinusoid", "amplitude", amplitude)?;
        positive("bi-sinusoid", "wavelength", wavelength)?;
        Ok(Self { amplitude, wavelength, modulus })
    }

    /// Height (m) at `(y, x)` from a summit.
    pub fn height(&self, y: f64, x: f64) -> f64 {
        let turn = 2.0 * PI / self.wavelength;
        self.amplitude * (turn * y).cos() * (turn * x).cos()
    }

    /// Mean pressure p* that closes every gap (Pa).
    pub fn closing_pressure(&self) -> f64 {
        SQRT_2 * PI * self.modulus.pascals() * self.amplitude / self.wavelength
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The energy put in from first touch to full contact is p* amplitude / 8, and it is the
    /// integral of the mean gap over the load.
    #[test]
    fn table_integrates_to_the_exact_energy() {
        // The gap leaves 1 as x^(2/3): integrate over t = x^(1/3), dx = 3 t^2 dt, trapezium with
        // the ends of the range added.
        let mut points = vec![(0.0, 1.0)];
        points.extend(ROWS.iter().map(|r| (r.pressure_ratio.cbrt(), r.mean_gap)));
        points.push((1.0, 0.0));
        let integral: f64 = points
            .windows(2)
            .map(|w| {
                let ((t0, g0), (t1, g1)) = (w[0], w[1]);
                // Simpson on 3 t^2 times the chord of g is exact for that product.
                let f = |s: f64| {
                    let t = t0 + s * (t1 - t0);
                    3.0 * t * t * (g0 + s * (g1 - g0))
                };
                (t1 - t0) * (f(0.0) + 4.0 * f(0.5) + f(1.0)) / 6.0
            })
            .sum();
        assert!((integral / 0.125 - 1.0).abs() < 0.03, "{integral}");
    }

    /// Each summit a Hertz contact; each open region a penny-shaped crack.
    #[test]
    fn table_meets_both_limits() {
        let first = ROWS[0];
        let hertz = PI * (3.0 * first.pressure_ratio / (8.0 * PI)).powf(2.0 / 3.0);
        assert!((first.area_fraction / hertz - 1.0).abs() < 0.01); // interaction: +0.5 %
        for last in &ROWS[19..] {
            let crack = 1.0 - 3.0 / (2.0 * PI) * (1.0 - last.pressure_ratio);
            assert!((last.area_fraction - crack).abs() < 2.0 * last.area_uncertainty);
        }
    }
}
