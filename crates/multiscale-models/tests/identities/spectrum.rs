//! The self-affine spectrum as it is defined.

use crate::quadrature::geometric_integral;
use libm::erf;
use std::f64::consts::PI;

/// A self-affine spectrum written out as in the definition.
pub(crate) struct Definition {
    hurst: f64,
    q: [f64; 3],
    c0: f64,
}

impl Definition {
    pub(crate) fn new(hurst: f64, q: [f64; 3], m0: f64) -> Self {
        let mut definition = Self { hurst, q, c0: 1.0 };
        definition.c0 = m0 / (2.0 * PI * definition.moment(1, q[2]));
        definition
    }

    pub(crate) fn psd(&self, q: f64) -> f64 {
        let [lower, rolloff, cutoff] = self.q;
        if q < lower || q > cutoff {
            0.0
        } else if q <= rolloff {
            self.c0
        } else {
            self.c0 * (q / rolloff).powf(-2.0 - 2.0 * self.hurst)
        }
    }

    /// `int q^n C dq` up to `q`, by quadrature on both sides of the kink.
    pub(crate) fn moment(&self, n: i32, q: f64) -> f64 {
        let f = |k: f64| k.powi(n) * self.psd(k);
        let [lower, rolloff, _] = self.q;
        geometric_integral(lower, q.min(rolloff), 4.0, f)
            + if q > rolloff { geometric_integral(rolloff, q, 4.0, f) } else { 0.0 }
    }

    /// The mean gap as printed, `sqrt(pi) int q^2 C w I(w p/E*) dq`, with I by its series and
    /// asymptotics replaced by plain quadrature.
    pub(crate) fn mean_gap(&self, p_over_e: f64, gamma: f64) -> f64 {
        let f = |q: f64| {
            let w = (PI * self.moment(3, q)).powf(-0.5);
            let x = w * p_over_e;
            if x > 9.0 {
                return 0.0;
            }
            let kernel =
                |y: f64| (gamma + 3.0 * (1.0 - gamma) * erf(y).powi(2)) * (-y * y).exp() / y;
            q * q * self.psd(q) * w * geometric_integral(x, x + 9.0, 4.0, kernel)
        };
        let [lower, rolloff, cutoff] = self.q;
        let mut sum = geometric_integral(rolloff, cutoff, 3.0, f);
        if rolloff > lower {
            sum += geometric_integral(lower, rolloff, 3.0, f);
        }
        PI.sqrt() * sum
    }
}

/// The four kinds of spectrum: with plateau, without, H = 1 (logarithm in m2), H = 0 (in m0).
pub(crate) const SPECTRA: [(f64, [f64; 3]); 4] = [
    (0.8, [1.0, 4.0, 90.0]),
    (0.3, [2.0, 2.0, 50.0]),
    (1.0, [1.0, 1.0, 30.0]),
    (0.0, [1.0, 1.5, 8.0]),
];
