//! Error of stopping the iteration.
//!
//! The estimate of the relative rms pressure error, which the tolerance is compared with, says how
//! far the fields may be off; a study says what that does to each number. The area has its own
//! constant ([`AREA_PER_RESIDUAL`]): no energy bound controls it.

use super::area::AREA_PER_RESIDUAL;
use super::map::Map;
use fft_bem_solver::Diagnostics;

/// Gap error over (rms height times relative rms pressure error).
pub const GAP: f64 = 0.6;

/// Relative error of the area at this relative rms pressure error.
pub fn area_error(residual: f64) -> f64 {
    AREA_PER_RESIDUAL * residual.max(0.0)
}

/// Half width of the mean gap (m).
pub fn gap_half_width(map: &Map, found: &Diagnostics) -> f64 {
    let is_exact = found.exact.is_some();
    if is_exact { 0.0 } else { GAP * map.rms_height * found.residuals.preconditioned.max(0.0) }
}
