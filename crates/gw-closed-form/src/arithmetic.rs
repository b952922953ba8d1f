//! Floating-point pieces that keep digits: none of them knows any physics.

/// `exp(-α²/2) = outer * inner * outer`.
///
/// α²/2 rounded to a double would cost α²/2 units in the last place. Here α is cut after four
/// binary places, `h`; h² is exact and the rest is `(α-h)(α+h)`.
pub(crate) fn exp_half_square(alpha: f64) -> [f64; 2] {
    let h = libm::trunc(16.0 * alpha) / 16.0;
    let d = (alpha - h) * (alpha + h);
    [libm::exp(-0.25 * h * h), libm::exp(-0.5 * d)]
}

/// x^{twice/2}, twice ≥ 0, as `(high + low) 2^exponent`, x > 0.
pub(crate) fn half_power(twice: i32, x: f64) -> (f64, f64, i32) {
    let (mantissa, exponent) = libm::frexp(x);
    // An even exponent, so that its square root is a power of two.
    let (m, e) =
        if exponent % 2 == 0 { (mantissa, exponent) } else { (2.0 * mantissa, exponent - 1) };
    let root = libm::sqrt(m);
    let (square, error) = two_product(root, root);
    let root_low = ((m - square) - error) / (2.0 * root);
    let (mut high, mut low) = if twice % 2 == 0 { (1.0, 0.0) } else { (root, root_low) };
    for _ in 0..twice / 2 {
        let (product, error) = two_product(high, m);
        (high, low) = (product, error + low * m);
    }
    (high, low, e / 2 * twice)
}

/// `a * b` and its rounding error (Dekker 1971, doi:10.1007/BF01397083). Without fused
/// multiply-add, which is a slow function call on the default x86-64 target.
pub(crate) fn two_product(a: f64, b: f64) -> (f64, f64) {
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    let product = a * b;
    let error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    (product, error)
}

/// Two halves of 26 bits.
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a; // 2^27 + 1
    let high = c - (c - a);
    (high, a - high)
}

/// Infinity becomes the largest double of the same sign.
pub(crate) fn clamp_to_finite(x: f64) -> f64 {
    x.clamp(-f64::MAX, f64::MAX)
}
