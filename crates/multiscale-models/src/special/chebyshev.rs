//! Chebyshev series.

/// Sum of Chebyshev polynomials `c[j] T_j(t)` (Clenshaw).
pub(super) fn chebyshev(c: &[f64], t: f64) -> f64 {
    let (mut b1, mut b2) = (0.0, 0.0);
    for &cj in c[1..].iter().rev() {
        (b1, b2) = (cj + 2.0 * t * b1 - b2, b1);
    }
    c[0] + t * b1 - b2
}
