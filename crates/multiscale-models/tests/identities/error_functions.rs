//! The inverse error functions.

use approx::assert_relative_eq;
use multiscale_models::special::{erf_inv, erfc_inv};

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
