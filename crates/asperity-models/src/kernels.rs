//! What one summit contributes, averaged over the shape of its curvature ellipse.

/// A kernel W(t) of the curvature t, as a Chebyshev series times its limit for sharp summits:
/// `W = T(y) / (lead (x + shift))`, x = t², `y = (x - 14)/(x + 14)`.
pub(crate) struct Kernel {
    pub(crate) lead: f64,
    pub(crate) shift: f64,
    pub(crate) coefficients: &'static [f64],
}

impl Kernel {
    /// W(t), t ≥ 0. Relative error below 1e-15.
    pub(crate) fn at(&self, t: f64) -> f64 {
        let x = t * t;
        let y = (x - 14.0) / (x + 14.0);
        let (mut b1, mut b2) = (0.0, 0.0);
        for &c in self.coefficients[1..].iter().rev() {
            (b1, b2) = (2.0 * y * b1 - b2 + c, b1);
        }
        (self.coefficients[0] + (y * b1 - b2)) / (self.lead * (x + self.shift))
    }
}

/// t² - 1 + e^{-t²}; starts as t⁴/2.
pub(crate) fn summit_weight(t: f64) -> f64 {
    let x = t * t;
    if x > 1.0 { x - 1.0 + (-x).exp() } else { x * x * weight_series(x) }
}

/// W_N = (t² - 1 + e^{-t²})/(2t⁴): the contact of a sphere of the mean curvature, averaged over the
/// curvature ellipses at t.
pub(crate) fn mean_kernel(t: f64) -> f64 {
    let x = t * t;
    if x > 1.0 { (x - 1.0 + (-x).exp()) / (2.0 * x * x) } else { 0.5 * weight_series(x) }
}

/// (x - 1 + e^{-x})/x² = 1/2! - x/3! + x²/4! - ..., x ≤ 1.
fn weight_series(x: f64) -> f64 {
    let (mut term, mut sum) = (0.5, 0.0);
    for k in 3..22 {
        sum += term;
        term *= -x / f64::from(k);
    }
    sum
}
