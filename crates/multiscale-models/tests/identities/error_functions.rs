//! The error functions and their inverses.

use approx::assert_relative_eq;
use multiscale_models::special::{erf, erf_inv, erfc, erfc_inv};
use special::{Error, Gamma};

#[test]
fn inverse_error_functions() {
    // erf(1/2), erfc(5), erfc(26): 20 digits by mpmath.
    for (y, a) in [(1e-12, 1.1283791670955125739e-12), (0.5, 0.52049987781304653768)] {
        assert_relative_eq!(erf_inv(a), y, max_relative = 3e-16);
    }
    for (y, b) in [
        (0.5, 0.47950012218695346232),
        (5.0, 1.5374597944280348502e-12),
        (20.0, 5.3958656116079009289e-176),
        (26.0, 5.6631924088561428465e-296),
    ] {
        assert_relative_eq!(erfc_inv(b), y, max_relative = 3e-16);
    }
    assert!(erf_inv(1.0).is_infinite() && erfc_inv(0.0).is_infinite());
    assert!(erf_inv(-0.1).is_nan() && erfc_inv(1.1).is_nan());
}

/// Against the crate `special`, whose code has nothing in common with ours here: its incomplete gamma
/// function gives `erf x = P(1/2, x^2)`, its inverse error function is a fit with one step of Halley's.
/// (Its `erf` and `erfc` themselves are those of `libm`, as ours are: no second opinion.)
#[test]
fn another_implementation_agrees() {
    let [mut direct, mut complement, mut inverse] = [0.0f64; 3];
    for i in 1..=1600 {
        let x = f64::from(i) / 320.0; // to 5
        let other = (x * x).inc_gamma(0.5);
        direct = direct.max((erf(x) / other - 1.0).abs());
        complement = complement.max((erfc(x) - (1.0 - other)).abs());
        let y = f64::from(i) / 1601.0;
        inverse = inverse.max((erf_inv(y) / y.inv_error() - 1.0).abs());
    }
    println!("erf {direct:.1e}, erfc {complement:.1e} (absolute), inverse {inverse:.1e}");
    assert!(direct < AGREE[0] && complement < AGREE[1] && inverse < AGREE[2]);
}

/// Measured: 8.7e-15, 7.2e-15, 1.3e-15.
const AGREE: [f64; 3] = [2e-14, 2e-14, 3e-15];
