//! Real area by Persson's law, and its inverse.

use super::span::MODEL;
use super::theory::{AreaLaw, Persson};
use crate::answer::outside;
use crate::special::{erf, erf_inv, erfc, erfc_inv, gauss_legendre};
use crate::wide::Wide;
use contact_types::{ModelError, require};
use std::f64::consts::FRAC_2_SQRT_PI;

impl Persson {
    /// Real area fraction `A/A_0 = erf(p / (E* sqrt(m2)))` \[-\] at nominal pressure `p` \[Pa\].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn area_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        Ok(erf(self.area_argument(pressure)?))
    }

    /// Fraction of the nominal area out of contact, `1 - A/A_0 = erfc(p / (E* sqrt(m2)))` \[-\], with the
    /// digits that `1 - area_fraction` has lost near full contact.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] if the pressure is negative or not finite.
    pub fn open_fraction(&self, pressure: f64) -> Result<f64, ModelError> {
        let x = self.area_argument(pressure)?;
        let open = erfc(x);
        if self.area_law != AreaLaw::Diffusion || self.slope.is_zero() || pressure <= 0.0 {
            return Ok(open);
        }
        // One rounding of x is worth 2 x² roundings of the answer: what x lost is given back.
        let modulus = Wide::from(self.modulus.pascals());
        let error = Wide::from(pressure).quotient_error(self.slope * modulus)
            - self.slope.product_error(modulus)
            - self.slope_error;
        // erfc(x (1 + error)), to first order; nothing is left of it where x is infinite
        let change = FRAC_2_SQRT_PI * error * (x * (-x * x).exp());
        Ok(if change.is_finite() { (open - change).max(0.0) } else { open })
    }

    /// The nominal pressure \[Pa\] at which the area fraction is `area_fraction`.
    ///
    /// ```math
    /// p = E^* \sqrt{m_2}\, \operatorname{erf}^{-1}\frac{A}{A_0}
    /// ```
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless `0 <= area_fraction <= 1`;
    /// [`ModelError::OutsideDomain`] for an area of 1, which no finite pressure reaches, and for
    /// any other area but 0 of a flat surface.
    pub fn pressure_at_area(&self, area_fraction: f64) -> Result<f64, ModelError> {
        require::fraction(MODEL, "area fraction", area_fraction)?;
        self.pressure_at_argument(erf_inv(area_fraction), area_fraction)
    }

    /// The nominal pressure \[Pa\] at which the fraction out of contact, `1 - A/A_0`, is
    /// `open_fraction`. Use it near full contact.
    ///
    /// # Errors
    /// As [`pressure_at_area`](Self::pressure_at_area).
    pub fn pressure_at_open_fraction(&self, open_fraction: f64) -> Result<f64, ModelError> {
        require::fraction(MODEL, "open fraction", open_fraction)?;
        self.pressure_at_argument(erfc_inv(open_fraction), 1.0 - open_fraction)
    }

    /// Argument of the error function.
    fn area_argument(&self, pressure: f64) -> Result<f64, ModelError> {
        require::pressure(MODEL, pressure)?;
        let Some(x) = self.load(pressure) else {
            return Ok(if pressure > 0.0 { f64::INFINITY } else { 0.0 }); // flat: all or nothing
        };
        Ok(match self.area_law {
            AreaLaw::Diffusion => x.value(),
            AreaLaw::ReducedDiffusion => reduced_argument(x, self.gamma),
        })
    }

    fn pressure_at_argument(&self, argument: f64, area_fraction: f64) -> Result<f64, ModelError> {
        let unreachable = |reason| {
            let domain = 0.0..=1.0 - f64::EPSILON / 2.0;
            Err(outside(MODEL, "area fraction", area_fraction, domain, reason))
        };
        if argument <= 0.0 {
            return Ok(0.0);
        }
        if self.slope.is_zero() {
            return unreachable("a flat surface touches everywhere under any pressure");
        }
        if argument.is_infinite() {
            return unreachable("full contact is reached only as the pressure grows to infinity");
        }
        let x = match self.area_law {
            AreaLaw::Diffusion => Wide::from(argument),
            AreaLaw::ReducedDiffusion => load_of_reduced(argument, self.gamma),
        };
        let pressure = x * self.slope * self.modulus.pascals();
        require::representable(MODEL, "mean pressure", pressure.value())
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

/// `x` from `X`: explicit.
fn load_of_reduced(big_x: f64, gamma: f64) -> Wide {
    Wide::from(big_x) / scaled_time(big_x, gamma).sqrt()
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
