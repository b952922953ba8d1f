//! The Gaussian, and how one order is evaluated: Taylor series between tabled nodes, and the two far ends.

use super::far_field;
use super::nodes::{self, Node};
use crate::arithmetic::{clamp_to_finite, exp_half_square, half_power, two_product};

/// The standard normal density φ(α).
pub(super) fn density(alpha: f64) -> f64 {
    times_gaussian(FRAC_1_SQRT_2PI, alpha)
}

/// `factor` times exp(-α²/2), with no digit lost in α² and no underflow before the result itself
/// underflows.
pub fn times_gaussian(factor: f64, alpha: f64) -> f64 {
    if alpha.abs() > 1e3 {
        return 0.0;
    }
    let [outer, inner] = exp_half_square(alpha);
    (factor * outer * inner) * outer
}

/// 1/√(2π).
const FRAC_1_SQRT_2PI: f64 = 0.398_942_280_401_432_7;

/// Where the Chebyshev series in 64/α² takes over.
pub(super) const FAR: f64 = 8.0;
/// Where the overlap series takes over.
pub(super) const NEAR: f64 = -10.0;
/// Nodes per unit of α.
const PER_UNIT: f64 = 4.0;

/// What distinguishes one order from another.
pub(super) struct Function {
    pub(super) n: f64,
    /// From -10 on, of order 0 from 0 on.
    nodes: &'static [Node],
    far: &'static [f64],
    /// Γ(n+1)/√(2π).
    pub(super) factor: f64,
    /// Argument where J_n = 1, its rounding error, and the slope there.
    pub(super) unity: Option<Node>,
}

pub(super) static ZERO: Function = Function {
    n: 0.0,
    nodes: &nodes::ZERO,
    far: &far_field::ZERO,
    factor: FRAC_1_SQRT_2PI,
    unity: None,
};
pub(super) static HALF: Function = Function {
    n: 0.5,
    nodes: &nodes::HALF,
    far: &far_field::HALF,
    factor: 0.353_553_390_593_273_8, // sqrt(2)/4
    unity: Some(nodes::UNITY_HALF),
};
pub(super) static ONE: Function = Function {
    n: 1.0,
    nodes: &nodes::ONE,
    far: &far_field::ONE,
    factor: FRAC_1_SQRT_2PI,
    unity: Some(nodes::UNITY_ONE),
};
pub(super) static THREE_HALVES: Function = Function {
    n: 1.5,
    nodes: &nodes::THREE_HALVES,
    far: &far_field::THREE_HALVES,
    factor: 0.530_330_085_889_910_6, // 3 sqrt(2)/8
    unity: Some(nodes::UNITY_THREE_HALVES),
};

impl Function {
    pub(super) fn value(&self, alpha: f64) -> f64 {
        if self.n <= 0.0 && alpha < 0.0 {
            1.0 - self.value(-alpha) // J_0(-x) = 1 - J_0(x)
        } else if alpha >= FAR {
            if alpha > 39.0 { 0.0 } else { times_gaussian(self.far_scaled(alpha), alpha) }
        } else if alpha <= NEAR {
            self.overlap(-alpha)
        } else {
            let (at, [value, low, slope]) = self.node(alpha);
            value + (low + taylor(self.n, at, [value, slope], alpha - at))
        }
    }

    /// The node next to α, between the far ends.
    fn node(&self, alpha: f64) -> (f64, Node) {
        let k = libm::rint(PER_UNIT * alpha);
        let first = if self.n > 0.0 { PER_UNIT * NEAR } else { 0.0 };
        (k / PER_UNIT, self.nodes[(k - first) as usize])
    }

    /// dJ_n/dα between the far ends: a moment of order n - 1 but for its factor.
    pub(super) fn slope(&self, alpha: f64) -> f64 {
        let (at, [value, _, slope]) = self.node(alpha);
        slope + taylor(self.n - 1.0, at, [slope, self.n * value - at * slope], alpha - at)
    }

    /// α -> -∞: J_n = x^n (1 + c), x = -α, with x^n as a sum of two doubles.
    fn overlap(&self, x: f64) -> f64 {
        if x == f64::INFINITY {
            return f64::MAX;
        }
        let (power, low, exponent) = half_power((2.0 * self.n) as i32, x);
        let sum = power + (low + power * overlap_correction(self.n, x));
        clamp_to_finite(libm::scalbn(sum, exponent))
    }

    /// exp(α²/2) J_n(α) √(2π) α^{n+1} / Γ(n+1) for α ≥ 8; tends to 1.
    pub(super) fn far_series(&self, alpha: f64) -> f64 {
        let ratio = FAR / alpha;
        chebyshev(self.far, 2.0 * (ratio * ratio) - 1.0)
    }

    pub(super) fn far_scaled(&self, alpha: f64) -> f64 {
        let mut scaled = self.factor * self.far_series(alpha);
        let mut halves = (2.0 * self.n) as i32 + 2; // divide by alpha^{n+1}
        if halves % 2 == 1 {
            scaled /= libm::sqrt(alpha);
            halves -= 1;
        }
        while halves > 0 {
            scaled /= alpha;
            halves -= 2;
        }
        scaled
    }
}

/// J(at + delta) - J(at) from value and slope at `at`: the terms u_k of the Taylor series
/// follow from J'' = n J - α J'.
pub(super) fn taylor(n: f64, at: f64, [value, slope]: [f64; 2], delta: f64) -> f64 {
    const TERMS: usize = 20;
    let (x, y) = (-at * delta, delta * delta);
    let mut u = [0.0; TERMS];
    // The rounding error of the first term is kept: without it neighbouring arguments can
    // come out in the wrong order.
    let (first, first_low) = two_product(slope, delta);
    (u[0], u[1]) = (value, first);
    for k in 0..TERMS - 2 {
        let m = k as f64;
        u[k + 2] = (x * RECIPROCAL[k + 2]) * u[k + 1]
            + (y * (n - m) * (RECIPROCAL[k + 1] * RECIPROCAL[k + 2])) * u[k];
    }
    first + (first_low + u[2..].iter().rev().sum::<f64>())
}

/// What α -> -∞ leaves, J_n = x^n (1 + c): c = Σ_{k>0} (-n)_{2k} / (k! (2x²)^k); ends by itself for integer n.
pub(super) fn overlap_correction(n: f64, x: f64) -> f64 {
    if x > 1e9 {
        return 0.0;
    }
    let inverse = 0.5 / (x * x);
    let mut term = 1.0;
    let mut terms = [0.0; 16];
    for (k, slot) in terms.iter_mut().enumerate() {
        let m = 2.0 * k as f64 - n;
        term *= m * (m + 1.0) * inverse / (k as f64 + 1.0);
        *slot = term;
        if term.abs() < 1e-20 {
            break;
        }
    }
    terms.iter().rev().sum()
}

/// Σ c_k T_k(x) by Clenshaw's recurrence.
fn chebyshev(coefficients: &[f64], x: f64) -> f64 {
    let (mut b1, mut b2) = (0.0, 0.0);
    for &c in coefficients[1..].iter().rev() {
        (b1, b2) = (2.0 * x * b1 - b2 + c, b1);
    }
    coefficients[0] + (x * b1 - b2)
}

/// 1/k.
static RECIPROCAL: [f64; 21] = {
    let mut r = [0.0; 21];
    let mut k = 1;
    while k < 21 {
        r[k] = 1.0 / k as f64;
        k += 1;
    }
    r
};
