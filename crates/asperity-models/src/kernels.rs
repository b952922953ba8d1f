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
