//! Real area by Persson's law.

use super::span::MODEL;
use super::theory::{AreaLaw, Persson};
use crate::special::{erf, erfc, gauss_legendre};
use crate::wide::Wide;
use contact_types::{ModelError, require};

impl Persson {
    /// Real area fraction at a nominal pressure \[Pa\].
    pub(super) fn area_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        require::pressure(MODEL, pressure)?;
        let Some(x) = self.load(pressure) else {
            return Ok(if pressure > 0.0 { 1.0 } else { 0.0 }); // flat: all or nothing
        };
        Ok(erf(match self.area_law {
            AreaLaw::Diffusion => x.value(),
            AreaLaw::ReducedDiffusion => reduced_argument(x, self.gamma),
        }))
    }
}

/// `X` from `x` by the area law in which partial contact slows the diffusion.
///
/// With `x = p / sqrt(2 V)` (all roughness) and `X = p / sqrt(2 V_eff)` the rule
/// `dV_eff = [gamma + (1 - gamma) erf^2 X] dV` integrates to
///
/// ```math
/// \frac{1}{x^2} = T(X) = \int_X^\infty \frac{2\,dy}{y^3\,[\gamma + (1-\gamma)\operatorname{erf}^2 y]}
///   = \frac{1}{X^2} + \int_X^\infty \frac{2}{y^3}\,
///     \frac{(1-\gamma)\operatorname{erfc}y\,(1+\operatorname{erf}y)}
///          {\gamma + (1-\gamma)\operatorname{erf}^2 y}\, dy
/// ```
///
/// All terms are positive. Limits: `X -> x` near full contact, `X -> x / sqrt(gamma)` at light
/// load.
fn reduced_argument(x: Wide, gamma: f64) -> f64 {
    // Below 1e-9 the light-load limit is exact to rounding (its correction is x^2 ln x).
    if x.value() < 1e-9 {
        return (x / gamma.sqrt()).value();
    }
    let x = x.value();
    if x > 6.0 {
        return x; // full contact to rounding
    }
    let mut big_x = x;
    // T X^2 is between 1 and 1/gamma and falls with X: Newton in ln X rises monotonically.
    for _ in 0..30 {
        let t = scaled_time(big_x, gamma); // T X^2
        let slope = -2.0 / (t * weight(big_x, gamma)); // d ln T / d ln X
        let step = (t.ln() - 2.0 * (big_x.ln() - x.ln())) / slope;
        big_x *= (-step).exp();
        if step.abs() < 1e-15 {
            break;
        }
    }
    big_x
}

fn weight(y: f64, gamma: f64) -> f64 {
    gamma + (1.0 - gamma) * erf(y) * erf(y)
}

/// `T(X) X^2 = 1 + int 2 e^{-2s} B(X e^s) ds`, the integral over s = ln(y/X) from 0.
fn scaled_time(big_x: f64, gamma: f64) -> f64 {
    // Past y = 6 erfc is below rounding; past s = 20 the factor e^{-2s} is.
    let end = (6.0 / big_x).ln().min(20.0);
    let mut sum = 1.0;
    let mut s = 0.0;
    while s < end {
        let next = (s + 0.5).min(end);
        sum += gauss_legendre(s, next, 1.0, |s| {
            let y = big_x * s.exp();
            let lack = (1.0 - gamma) * erfc(y) * (1.0 + erf(y)) / weight(y, gamma);
            2.0 * (-2.0 * s).exp() * lack
        });
        s = next;
    }
    sum
}
