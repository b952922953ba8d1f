//! Error of the grid: contact lines cut pixels, peaks stand between points.
//!
//! The bar of the area is [`fft_bem_solver::AreaAccuracy`]'s. Gap and stiffness converge faster;
//! their bars are parts of the same measure of resolution, the share of the contact line,
//! `0.118 S_d / A`.

use super::Map;
use fft_bem_solver::{BOUNDARY_CORRECTION, Solution, left_of_correction};

/// Gap error over (rms height times share of the contact line), on a map that repeats.
const GAP: f64 = 0.012;
/// The same on a map whose edges do not match.
const GAP_AT_SEAM: f64 = 0.08;
/// Relative error of the stiffness over the share of the contact line.
const STIFFNESS: f64 = 0.15;
/// The same on a map whose edges do not match.
const STIFFNESS_AT_SEAM: f64 = 0.25;

/// Share of the contact line: correction over corrected area, 0 without a line (-).
pub fn line_share(solution: &Solution) -> f64 {
    let found = &solution.diagnostics;
    let correction = BOUNDARY_CORRECTION * found.contact_perimeter;
    if correction > 0.0 { correction / found.area_fraction_corrected } else { 0.0 }
}

/// Half width of the mean gap (m) at this share of the contact line.
pub fn gap_half_width(map: &Map, line_share: f64) -> f64 {
    let part = if map.repeats { GAP } else { GAP_AT_SEAM };
    part * map.rms_height * line_share
}

/// Relative half width of the stiffness at this share of the contact line.
pub fn stiffness_half_width(map: &Map, line_share: f64) -> f64 {
    let part = if map.repeats { STIFFNESS } else { STIFFNESS_AT_SEAM };
    part * line_share
}

/// What a solution on twice as many points along each side says of the one on the given grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Finer {
    /// Its corrected area fraction.
    pub area: f64,
    /// Its correction for the contact line, 0.118 S_d.
    pub correction: f64,
    /// Its mean gap (m).
    pub gap: Option<f64>,
    /// Part of its correction left as uncertainty.
    pub left_over: f64,
}

impl Finer {
    /// From the solution.
    pub fn of(solution: &Solution, map: &Map) -> Self {
        let found = &solution.diagnostics;
        Self {
            left_over: left_of_correction(map.accuracy.directions),
            area: found.area_fraction_corrected,
            correction: BOUNDARY_CORRECTION * found.contact_perimeter,
            gap: solution.state.mean_gap,
        }
    }

    /// Half width around the area on the given grid: what refining moved, and what is left on the
    /// finer grid, as much again or the bar of the finer grid, whichever is larger.
    pub fn area_half_width(&self, given: f64) -> f64 {
        let moved = (self.area - given).abs();
        moved + moved.max(self.left_over * self.correction)
    }

    /// Half width around the mean gap on the given grid (m): twice what refining moved.
    pub fn gap_half_width(&self, given: f64) -> Option<f64> {
        self.gap.map(|gap| 2.0 * (gap - given).abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refined_bar_covers_both_areas_and_what_is_left() {
        let finer = Finer { area: 0.023, correction: 0.01, gap: Some(2.5e-7), left_over: 0.3 };
        assert!((finer.area_half_width(0.020) - (0.003 + 0.003)).abs() < 1e-15);
        assert!((finer.area_half_width(0.0225) - (0.0005 + 0.3 * 0.01)).abs() < 1e-15);
        assert!((finer.gap_half_width(2e-7).unwrap() - 1e-7).abs() < 1e-18);
    }
}
