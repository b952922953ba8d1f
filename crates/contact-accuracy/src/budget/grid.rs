//! Error of the grid: contact lines cut pixels, peaks stand between points.
//!
//! The bar of the area is [`AreaAccuracy`](super::AreaAccuracy)'s. Gap and stiffness converge faster;
//! their bars are parts of the same measure of resolution, the share of the contact line,
//! `0.118 S_d / A`.

use super::map::Map;
use contact_types::Grid;
use fft_bem_solver::{BOUNDARY_CORRECTION, Solution};

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
    /// Its mean pressure (Pa).
    pub pressure: f64,
    /// Half width that its own contact line leaves, as on a map inside the gate.
    pub bar: f64,
}

impl Finer {
    /// From the solution on `grid`, twice as fine as that of `map`.
    pub fn of(solution: &Solution, map: &Map, grid: Grid) -> Self {
        let found = &solution.diagnostics;
        let correction = BOUNDARY_CORRECTION * found.contact_perimeter;
        let own = map.accuracy.on(grid).with_boundary(found.boundary);
        Self {
            area: found.area_fraction_corrected,
            correction,
            gap: solution.state.mean_gap,
            pressure: solution.state.mean_pressure,
            bar: own.line_left_over(found.contact_perimeter),
        }
    }

    /// Half width around the area on the given grid: what refining moved, and what is left on the
    /// finer grid, as much again or the bar of the finer grid, whichever is larger.
    pub fn area_half_width(&self, given: f64) -> f64 {
        let moved = (self.area - given).abs();
        moved + moved.max(self.bar)
    }

    /// Half width around the mean gap on the given grid (m): twice what refining moved.
    pub fn gap_half_width(&self, given: f64) -> Option<f64> {
        self.gap.map(|gap| 2.0 * (gap - given).abs())
    }

    /// Half width around the mean pressure that belongs to a given gap (Pa): twice what refining
    /// moved.
    pub fn pressure_half_width(&self, given: f64) -> f64 {
        2.0 * (self.pressure - given).abs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refined_bar_covers_both_areas_and_what_is_left() {
        let finer =
            Finer { area: 0.023, correction: 0.01, gap: Some(2.5e-7), pressure: 3e6, bar: 0.003 };
        assert!((finer.area_half_width(0.020) - (0.003 + 0.003)).abs() < 1e-15);
        assert!((finer.area_half_width(0.0225) - (0.0005 + 0.003)).abs() < 1e-15);
        assert!((finer.gap_half_width(2e-7).unwrap() - 1e-7).abs() < 1e-18);
        assert!((finer.pressure_half_width(2.9e6) - 2e5).abs() < 1e-6);
    }
}
