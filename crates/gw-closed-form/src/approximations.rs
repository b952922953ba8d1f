//! What was used before the closed form: kept to show what it costs.
//!
//! Each function returns an approximation of J_n(h). Relative error against
//! [`partial_moments`](crate::partial_moments) (`tests/approximations.rs` checks the figures):
//!
//! | h | [`exponential_height_law`], n = 3/2 | [`power_fit`], n = 5/2 | [`log_quadratic_fit`], n = 5/2 |
//! |---|---|---|---|
//! | 0 | +237 % | -10.7 % | -11.3 % |
//! | 1 | -4.6 % | -3.5 % | -12.8 % |
//! | 2 | -46 % | -9.2 % | +4.6 % |
//! | 3 | -32 % | -74 % | +25 % |
//! | 3.5 | +4.4 % | -98 % | +30 % |
//! | 4 | +101 % | -100 % | -100 % |
//!
//! The exact value takes 26 ns, the exponential law 7 ns, the power fit 35 ns, the log-quadratic
//! fit 17 ns (`cargo bench -p gw-closed-form`): what they save at best is 20 ns.

use crate::partial_moments::Order;

/// J_n with the Gaussian replaced by 17 exp(-3s).
///
/// ```math
/// J_n(h) \approx 17 \int_h^\infty (s-h)^n e^{-3s}\,ds = 17\,\Gamma(n+1)\,\frac{e^{-3h}}{3^{n+1}}
/// ```
///
/// An exponential makes area proportional to load at every separation; a Gaussian does not.
///
/// # Source
/// The height law of early elastic-plastic asperity models; Greenwood & Williamson (1966),
/// doi:10.1098/rspa.1966.0242, use exp(-s) for the same purpose.
pub fn exponential_height_law(order: Order, h: f64) -> f64 {
    // (n, Gamma(n+1) / 3^(n+1))
    let factor = match order {
        Order::Zero => 1.0 / 3.0,
        Order::Half => 0.886_226_925_452_758 / 5.196_152_422_706_632,
        Order::One => 1.0 / 9.0,
        Order::ThreeHalves => 1.329_340_388_179_137 / 15.588_457_268_119_895,
        Order::FiveHalves => 3.323_350_970_447_842_6 / 46.765_371_804_359_69,
    };
    17.0 * factor * libm::exp(-3.0 * h)
}

/// F_{5/2}(h) ≈ 4.4086e-5 (4 - h)^6.804, and 0 for h ≥ 4: the fit found in most
/// mixed-lubrication codes. Made for 0 ≤ h ≤ 4.
pub fn power_fit(h: f64) -> f64 {
    if h < 4.0 { 4.4086e-5 * libm::pow(4.0 - h, 6.804) } else { 0.0 }
}

/// F_{5/2}(h) ≈ 2.134e-4 exp(3.804 L + 1.34 L²), L = ln(4 - h), and 0 for h ≥ 4. Made for
/// 0 ≤ h ≤ 4.
pub fn log_quadratic_fit(h: f64) -> f64 {
    if h >= 4.0 {
        return 0.0;
    }
    let l = libm::log(4.0 - h);
    2.134e-4 * libm::exp(3.804 * l + 1.34 * l * l)
}
