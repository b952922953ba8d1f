//! By how much a count of touching points exceeds the area: a point stays in contact until the true edge has
//! passed it by some part of the pixel.
//!
//! Of a straight edge that part follows from the discrete operator alone. Let the edge have its normal along
//! the lattice vector `(m, n)`, so that rows of points parallel to it stand `d = h/√(m² + n²)` apart. Then the
//! problem is one-dimensional, with the symbol `1/r(θ)`, `r = |wrapped θ (m, n)| / √(m² + n²)`, and its
//! Wiener–Hopf factors are known: with `2 sin(θ/2)/r(θ) = s(z) s(1/z)` the pressure of the row `k` behind the
//! edge is the coefficient of `z^k` in `(1 − z)^(−3/2) / s(z)` at the moment when the row before it comes in.
//! Its expansion far inside, `√(k − x₀)`, says where the true edge is then, and the mean excess of the count per
//! length of the edge is
//!
//! ```math
//! d \left( \frac14 + \frac{1}{2\pi} \int_0^\pi \cot\frac\theta2 \left( \frac12 \cot\frac\theta2
//!   - \frac{r'}{r} \right) d\theta \right)
//! ```
//!
//! 0.190 pixels for an edge along a row of points, 0.134 at 45°, 0.114 to 0.13 between. The mean over all
//! directions, per edge between a point in contact and one that is not (4/π per length), is the constant below.

/// Area by which a count of points is too large, in pixels per edge of the contact line, for straight edges of all
/// directions and the periodic half-space: derived in this module.
///
/// On rough maps 0.104 fits best (68 %: 0.092 to 0.122; `examples/coverage` of `contact-accuracy`). That of a *given*
/// region whose points are counted is another, (π − 1 + ln 2)/24 = 0.118 (Yastrebov, Anciaux & Molinari 2017,
/// doi:10.1016/j.triboint.2017.04.023).
pub const PERIMETER_CORRECTION: f64 = 0.1013;
