//! A spectrum as Persson's mean gap sees it: how the slope builds up with wavenumber.
//!
//! Everything is a mean over `rho`, from 0 to 1, with `rho^2` the share of the mean square slope
//! that comes from wavenumbers below `q`:
//!
//! ```math
//! \rho^2(q) = Q(q)/m_2, \qquad Q(q) = \pi\int_{q_0}^{q} q'^3 C(q')\,dq', \qquad
//! \int_0^1 f\!\left(\tfrac{x}{\rho}\right) \frac{q_0}{q(\rho)}\, d\rho
//! ```

use super::MODEL;
use super::self_affine::SelfAffineSpectrum;
use crate::special::gauss_legendre;
use crate::wide::Wide;
use contact_types::{ModelError, Shell};

/// The two kinds of spectrum.
#[derive(Debug)]
pub(super) enum Scales {
    /// Shells of a measured spectrum, without those that carry nothing.
    Shells(Vec<Step>),
    /// A continuous spectrum.
    SelfAffine(SelfAffineSpectrum),
}

/// One shell: `rho` rises to `rho` at wavenumber `wavenumber`.
#[derive(Debug)]
pub(super) struct Step {
    wavenumber: f64,
    rho: f64,
}

/// How an integrand falls towards small `rho`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Decay {
    /// As exp(-(x/rho)^2): long waves are flattened out completely.
    Gaussian,
    /// Not at all, only with the weight.
    None,
}

impl Scales {
    /// `sqrt(m2)` and the scales of a measured spectrum. Shells that carry nothing do not count.
    pub(super) fn from_shells(shells: &[Shell]) -> Result<(Wide, Self), ModelError> {
        let shells: Vec<Shell> = shells.iter().filter(|s| s.variance > 0.0).copied().collect();
        if let [first, .., last] = shells[..] {
            let span = (Wide::from(last.wavenumber) / first.wavenumber).value().min(f64::MAX);
            check_span(MODEL, "largest over smallest wavenumber", span)?;
        }
        // sqrt(S/2) q, the rms profile slope of one shell, scaled by the largest: no overflow.
        let slopes: Vec<Wide> =
            shells.iter().map(|s| (Wide::from(s.variance) / 2.0).sqrt() * s.wavenumber).collect();
        let largest = slopes
            .iter()
            .filter(|s| !s.is_zero())
            .copied()
            .reduce(|a, b| if (a / b).value() < 1.0 { b } else { a });
        let Some(largest) = largest else {
            return Ok((Wide::from(0.0), Self::Shells(Vec::new())));
        };
        let mut total = CompensatedSum::default();
        let mut steps: Vec<Step> = Vec::new();
        for (shell, slope) in shells.iter().zip(&slopes) {
            let ratio = (*slope / largest).value();
            if ratio > 0.0 {
                total.add(ratio * ratio);
                steps.push(Step { wavenumber: shell.wavenumber, rho: total.value().sqrt() });
            }
        }
        let all = total.value().sqrt();
        for step in &mut steps {
            step.rho /= all;
        }
        Ok((largest * all, Self::Shells(steps)))
    }

    /// `q_0` \[rad/m\]; 1 for an empty spectrum, where it multiplies 0.
    pub(super) fn smallest_wavenumber(&self) -> f64 {
        match self {
            Self::Shells(steps) => steps.first().map_or(1.0, |s| s.wavenumber),
            Self::SelfAffine(spectrum) => spectrum.smallest_wavenumber(),
        }
    }

    /// `rho(q)`.
    pub(super) fn slope_fraction(&self, wavenumber: f64) -> f64 {
        match self {
            Self::Shells(steps) => {
                let below = steps.partition_point(|s| s.wavenumber <= wavenumber);
                if below == 0 { 0.0 } else { steps[below - 1].rho }
            }
            Self::SelfAffine(spectrum) => spectrum.slope_fraction(wavenumber),
        }
    }

    /// `int_0^1 f(rho) q_0/q(rho) d rho`, where `f` depends on `rho` through `x / rho` and falls
    /// towards 0 as `decay` says. Relative error about 1e-14 (measured) at any `x > 0`.
    pub(super) fn integrate(&self, x: f64, decay: Decay, f: impl Fn(f64) -> f64) -> f64 {
        let range = Range { x, decay };
        match self {
            Self::Shells(steps) => {
                let q0 = self.smallest_wavenumber();
                let mut lo = 0.0;
                let mut sum = 0.0;
                for step in steps {
                    sum += q0 / step.wavenumber * range.integrate(lo, step.rho, &f);
                    lo = step.rho;
                }
                sum
            }
            Self::SelfAffine(spectrum) => spectrum.integrate(range, &f),
        }
    }
}

/// Where an integrand of `x / rho` matters and how fast it changes.
#[derive(Clone, Copy)]
pub(super) struct Range {
    x: f64,
    decay: Decay,
}

/// An integrand whose exponent is this far above the smallest is less than rounding, even if
/// its waves are 1e18 times longer.
const NEGLIGIBLE: f64 = 80.0;

/// Beyond this exponent the error function is 1 to rounding.
const ERF_IS_ONE: f64 = 40.0;

impl Range {
    /// Exponent `(x/rho)^2` of the integrand.
    pub(super) fn exponent(self, rho: f64) -> f64 {
        (self.x / rho) * (self.x / rho)
    }

    /// True if nothing at or below `rho` matters.
    pub(super) fn is_negligible(self, rho: f64) -> bool {
        self.decay == Decay::Gaussian && self.exponent(rho) > self.exponent(1.0) + NEGLIGIBLE
    }

    /// Change of the exponent from `hi` down to `lo`, as far as it can still be seen.
    pub(super) fn steepness(self, lo: f64, hi: f64) -> f64 {
        let top = self.exponent(hi);
        if self.decay == Decay::None && top > ERF_IS_ONE { 0.0 } else { self.exponent(lo) - top }
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
    Err(ModelError::OutsideDomain { model, quantity, value: span, domain, reason })
}

/// Neumaier's sum: rounding does not grow with the number of terms.
#[derive(Default)]
struct CompensatedSum {
    sum: f64,
    lost: f64,
}

impl CompensatedSum {
    fn add(&mut self, term: f64) {
        let sum = self.sum + term;
        self.lost +=
            if self.sum >= term { (self.sum - sum) + term } else { (term - sum) + self.sum };
        self.sum = sum;
    }

    fn value(&self) -> f64 {
        self.sum + self.lost
    }
}
