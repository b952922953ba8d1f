//! Elastic contact of one bi-sinusoidal surface with a flat: real area over nominal area.

use crate::wide::Wide;
use std::f64::consts::PI;

/// Real over nominal area of a bi-sinusoid `Δ cos(2πx/λ) cos(2πy/λ)` at the mean pressure `x = p/p*` over that of
/// complete contact, which must not be zero: the fit of Jackson & Streator to the points of Johnson, Greenwood &
/// Higginson. Both ends are exact, Hertz contact of the crests and the last valleys, which close as penny-shaped
/// cracks; between them it is up to 12 % too large (x = 0.05) and 7 % too small (x = 0.3).
pub(crate) fn area_fraction(x: Wide) -> Wide {
    let load = x.value();
    if load < 1e-60 {
        // g1 is exact to rounding, also beyond the range of a double.
        let root = (x * (3.0 / (8.0 * PI))).cbrt();
        return root * root * PI;
    }
    let hertz = PI * (3.0 * load / (8.0 * PI)).cbrt().powi(2);
    let last_valleys = 1.0 - 3.0 / (2.0 * PI) * (1.0 - load);
    Wide::from(if load < 0.8 {
        hertz * (1.0 - load.powf(1.51)) + last_valleys * load.powf(1.04)
    } else {
        last_valleys.min(1.0)
    })
}
