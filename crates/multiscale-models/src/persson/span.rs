//! How far a spectrum reaches, and integrals over the part of it that matters.

use crate::special::gauss_legendre;
use contact_types::{ModelError, require};

/// Name of the theory in errors.
pub(super) const MODEL: &str = "Persson";

/// Where an integrand that falls as `exp(-(x/rho)^2)` towards small `rho` matters, and how fast it
/// changes: long waves are flattened out completely.
#[derive(Clone, Copy)]
pub(super) struct Range {
    pub(super) x: f64,
}

/// An integrand whose exponent is this far above the smallest is less than rounding, even if
/// its waves are 1e18 times longer.
const NEGLIGIBLE: f64 = 80.0;

impl Range {
    /// Exponent `(x/rho)^2` of the integrand.
    fn exponent(self, rho: f64) -> f64 {
        (self.x / rho) * (self.x / rho)
    }

    /// True if nothing at or below `rho` matters.
    pub(super) fn is_negligible(self, rho: f64) -> bool {
        self.exponent(rho) > self.exponent(1.0) + NEGLIGIBLE
    }

    /// Change of the exponent from `hi` down to `lo`.
    pub(super) fn steepness(self, lo: f64, hi: f64) -> f64 {
        self.exponent(lo) - self.exponent(hi)
    }

    /// `int_lo^hi f d rho` in panels that halve `rho` or change the exponent by at most 8.
    pub(super) fn integrate(self, lo: f64, hi: f64, f: impl Fn(f64) -> f64) -> f64 {
        let mut sum = 0.0;
        let mut b = hi;
        // Below 1e-18 of the upper end the rest is less than rounding: f falls towards 0.
        while b > lo && b > 1e-18 * hi && !self.is_negligible(b) {
            let mut a = lo.max(0.5 * b);
            if self.steepness(a, b) > 8.0 {
                a = a.max(self.x / (self.exponent(b) + 8.0).sqrt());
            }
            if a >= b {
                break; // the panel is thinner than one rounding
            }
            let strength = ((b - a) / (b + a)).max(self.steepness(a, b) / 20.0);
            sum += gauss_legendre(a, b, strength, &f);
            b = a;
        }
        sum
    }
}

/// The integrals resolve wavelengths over 18 decades.
pub(super) fn check_span(
    model: &'static str,
    quantity: &'static str,
    span: f64,
) -> Result<(), ModelError> {
    let domain = 1.0..=1e18;
    if domain.contains(&span) {
        return Ok(());
    }
    let reason = "a spectrum of more than 18 decades is none of a surface";
    Err(require::outside(model, quantity, span, domain, reason))
}
