//! A spectrum as Persson's mean gap sees it: how the slope builds up with wavenumber.
//!
//! Everything is a mean over `rho`, from 0 to 1, with `rho^2` the share of the mean square slope
//! that comes from wavenumbers below `q`:
//!
//! ```math
//! \rho^2(q) = Q(q)/m_2, \qquad Q(q) = \pi\int_{q_0}^{q} q'^3 C(q')\,dq', \qquad
//! \int_0^1 f\!\left(\tfrac{x}{\rho}\right) \frac{q_0}{q(\rho)}\, d\rho
//! ```

use super::self_affine::SelfAffineSpectrum;
use super::span::{MODEL, Range, check_span};
use crate::wide::Wide;
use contact_types::{ModelError, Shell};

/// The two kinds of spectrum.
#[derive(Debug)]
pub(super) enum Scales {
    /// Shells of a measured spectrum, without those that carry nothing.
    Shells(Vec<SlopeStep>),
    /// A continuous spectrum.
    SelfAffine(SelfAffineSpectrum),
}

/// One shell: `rho` rises to `rho` at wavenumber `wavenumber`.
#[derive(Debug)]
pub(super) struct SlopeStep {
    wavenumber: f64,
    rho: f64,
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
        let mut steps: Vec<SlopeStep> = Vec::new();
        for (shell, slope) in shells.iter().zip(&slopes) {
            let ratio = (*slope / largest).value();
            if ratio > 0.0 {
                total.add(ratio * ratio);
                steps.push(SlopeStep { wavenumber: shell.wavenumber, rho: total.value().sqrt() });
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
            Self::SelfAffine(spectrum) => spectrum.wavenumbers[0],
        }
    }

    /// `int_0^1 f(rho) q_0/q(rho) d rho`, where `f` falls as `exp(-(x/rho)^2)`
    /// towards small `rho`. Relative error about 1e-14 (measured) at any `x > 0`.
    pub(super) fn integrate(&self, x: f64, f: impl Fn(f64) -> f64) -> f64 {
        let range = Range { x };
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
