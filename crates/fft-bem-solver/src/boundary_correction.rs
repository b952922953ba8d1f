//! What a count of pixels says too much.

use std::f64::consts::{LN_2, PI};

/// Area by which a count of pixels is too large, in pixels per edge of the contact line, for edges
/// of all directions: (π − 1 + ln 2)/24 (Yastrebov, Anciaux & Molinari 2017,
/// doi:10.1016/j.triboint.2017.04.023).
pub const BOUNDARY_CORRECTION: f64 = (PI - 1.0 + LN_2) / 24.0;
