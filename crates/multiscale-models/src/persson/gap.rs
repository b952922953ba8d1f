//! Mean gap and stiffness.

use super::scales::Scales;
use super::span::MODEL;
use super::theory::Persson;
use crate::special::{erf, half_e1_of_square, squared_erf_tail};
use crate::wide::Wide;
use contact_types::{ModelError, require};
use std::f64::consts::FRAC_2_SQRT_PI;

/// Below this load `x = p / (E* sqrt(m2))` the limits of light load are exact to rounding.
const LIGHT: f64 = 1e-290;

/// Above this `x` the integrals of the gap are below the smallest double.
const FULL: f64 = 27.5;

impl Persson {
    /// Mean gap between the deformed surfaces \[m\] at nominal pressure `p` \[Pa\]:
    ///
    /// ```math
    /// \bar u(p) = \sqrt\pi\int dq\, q^2 C(q)\, w\, I\!\left(\frac{w p}{E^*}\right), \qquad
    /// I(x) = \int_x^\infty [\gamma + 3(1-\gamma)\operatorname{erf}^2 y]\, \frac{e^{-y^2}}{y}\,dy
    /// ```
    ///
    /// with `w = (pi int_{q0}^{q} q'^3 C dq')^(-1/2)`, evaluated as
    /// `(2/sqrt(pi)) sqrt(m2) int_0^1 I(x/rho)/q(rho) d rho`. It grows like `ln(1/p)` at light
    /// load: a Gaussian surface has no highest point. 0 where it is below the smallest double.
    ///
    /// # Source
    /// Persson (2007), doi:10.1103/PhysRevLett.99.125502, eq. (17); Yang & Persson (2008),
    /// doi:10.1088/0953-8984/20/21/215214.
    pub(super) fn mean_gap(&self, scales: &Scales, pressure: f64) -> Result<f64, ModelError> {
        let Some(load) = self.load(pressure) else {
            return Ok(0.0); // flat
        };
        let x = load.value();
        if x > FULL {
            return Ok(0.0);
        }
        let gamma = self.gamma;
        let x_used = x.max(LIGHT);
        let mut integral = scales.integrate(x_used, |rho| separation(x_used / rho, gamma));
        if x < LIGHT {
            // u = u0 ln(... / p): continue the logarithm exactly.
            let share = scales.integrate(x_used, |_| 1.0);
            integral += gamma * share * (LIGHT.ln() - load.ln());
        }
        let length = self.slope / scales.smallest_wavenumber();
        let gap = (length * FRAC_2_SQRT_PI * integral).value();
        require::answer(MODEL, gap, "mean pressure", pressure)
    }

    /// Normal contact stiffness per nominal area, `-dp/du` \[Pa/m\], at nominal pressure `p` \[Pa\]:
    ///
    /// ```math
    /// -\frac{dp}{d\bar u} = \frac{p}{\sqrt\pi\int dq\,q^2 C w
    ///   [\gamma+3(1-\gamma)\operatorname{erf}^2(wp/E^*)]\, e^{-(wp/E^*)^2}}
    /// ```
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless the pressure is finite and positive, or if the model was made from moments;
    /// [`ModelError::OutsideDomain`] where the stiffness exceeds the largest double: the contact is full.
    pub fn stiffness(&self, pressure: f64) -> Result<f64, ModelError> {
        require::positive(MODEL, "mean pressure", pressure)?;
        let requirement =
            "it needs more than moments: use Persson::from_spectrum or Persson::from_self_affine";
        let scales = self.scales.as_deref().ok_or_else(|| {
            require::refused(MODEL, "number of shells of the spectrum", 0.0, requirement)
        })?;
        let x = self.load(pressure).map_or(f64::INFINITY, Wide::value);
        let integral = if x > FULL {
            0.0
        } else {
            let (x, gamma) = (x.max(LIGHT), self.gamma);
            scales.integrate(x, |rho| {
                let y = x / rho;
                (gamma + 3.0 * (1.0 - gamma) * erf(y).powi(2)) * (-y * y).exp()
            })
        };
        let length = self.slope / scales.smallest_wavenumber() * FRAC_2_SQRT_PI * integral;
        let stiffness =
            if length.is_zero() { f64::INFINITY } else { (Wide::from(pressure) / length).value() };
        require::answer(MODEL, stiffness, "mean pressure", pressure)
    }
}

/// `I(x) = (gamma/2) E1(x^2) + 3 (1 - gamma) K(x)`.
fn separation(x: f64, gamma: f64) -> f64 {
    let persson = gamma * half_e1_of_square(x);
    if gamma < 1.0 { persson + 3.0 * (1.0 - gamma) * squared_erf_tail(x) } else { persson }
}
