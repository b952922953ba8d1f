//! The error budget of a solution on a grid that need not be the given one.
//!
//! What the contact line leaves is the bar of the area ([`AreaAccuracy`]); a coarser grid also loses
//! gradient: the area at a light load is as 1/h'_rms. Calibrated on 106 maps of 256² points in seven
//! families at five loads, on grids from 1/8 to 2 times the given one, against the map on 1024²
//! points: the largest excess seen was 1.41 times the loss.
//!
//! [`AreaAccuracy`]: crate::budget::AreaAccuracy

use super::Candidate;
use crate::budget::{Between, Budget, Map, NoAreaInterval, area_per_load, grid, least_fall};
use fft_bem_solver::{BOUNDARY_CORRECTION, Load, Solution};

/// Relative area error per relative loss of gradient.
const LOST: f64 = 1.5;
/// Gap error over (rms height times relative loss of gradient).
const GAP_LOST: f64 = 1.0;

/// The contact line of one solution, from which the bar on another grid follows.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Line {
    /// Corrected area fraction.
    pub area: f64,
    /// Edges per point, S_d.
    pub edges: f64,
    /// Fall of the gap per e-fold load (m), if the gap is given.
    pub fall: Option<f64>,
}

impl Line {
    /// Of a solution under `load`.
    pub fn of(solution: &Solution, load: Load) -> Self {
        let d = &solution.diagnostics;
        let is_gap = matches!(load, Load::MeanGap(_));
        Self {
            area: d.area_fraction_corrected,
            edges: d.contact_perimeter,
            fall: is_gap.then(|| least_fall(solution)),
        }
    }

    /// The same line on a grid with pixels `scale` times as long: as much longer in pixels as
    /// there are more of them, per point shorter.
    #[must_use]
    pub fn on_pixels(self, scale: f64) -> Self {
        Self { edges: scale * self.edges, ..self }
    }

    /// Half width from the grid, in area fraction; with what a given gap leaves open in the load.
    ///
    /// # Errors
    /// [`NoAreaInterval::SpotsTooSmall`] or [`NoAreaInterval::Empty`].
    pub fn half_width(self, on: &Candidate, map: &Map) -> Result<f64, NoAreaInterval> {
        let half = self.at_given_load(on)?;
        let gap = self.gap_half_width(on, map);
        let load = self.fall.filter(|_| gap > 0.0).map_or(0.0, |fall| gap / fall);
        Ok(half + load * self.area * area_per_load(self.area))
    }

    /// Half width from the grid at a given load, in area fraction.
    fn at_given_load(self, on: &Candidate) -> Result<f64, NoAreaInterval> {
        let raw = self.area + BOUNDARY_CORRECTION * self.edges;
        if raw <= 0.0 {
            return Err(NoAreaInterval::Empty);
        }
        Ok(on.accuracy.line_half_width(raw, self.edges)? + LOST * on.lost * self.area)
    }

    /// Half width of the mean gap at a given load (m).
    fn gap_half_width(self, on: &Candidate, map: &Map) -> f64 {
        let line = grid::Line { area: self.area, edges: self.edges };
        grid::gap_half_width(&map.on(on.grid), line) + more_of_gap(on, map)
    }
}

/// By how much the error of the gap from the grid grows for the waves that a grid cannot hold (m).
fn more_of_gap(on: &Candidate, map: &Map) -> f64 {
    GAP_LOST * map.rms_height * on.lost
}

/// The budget of a solution under `load` on this grid; `between` is what is known of the given
/// points at its contact.
pub fn budget(
    solution: &Solution,
    load: Load,
    on: &Candidate,
    map: &Map,
    between: Option<&Between>,
) -> Budget {
    let line = Line::of(solution, load);
    let d = &solution.diagnostics;
    let touches_everywhere = d.contact_pixels > 0 && d.contact_perimeter <= 0.0;
    let gate = if touches_everywhere { Ok(()) } else { on.accuracy.gate() };
    let grid = gate.and_then(|()| line.at_given_load(on));
    let found = Budget::of(solution, &map.on(on.grid)).with_grid(grid, more_of_gap(on, map));
    let found = between.map_or(found, |between| found.between(between));
    if line.fall.is_some() { found.at_given_gap(solution) } else { found }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::budget::AreaAccuracy;
    use contact_types::{Grid, HeightMap};

    #[test]
    fn a_loss_of_gradient_and_a_given_gap_widen_the_bar() {
        let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
        let wave = |y: f64, x: f64| (0.3 * y).sin() + (0.4 * x).cos();
        let map = Map::of(&HeightMap::from_fn(grid, wave).unwrap()).unwrap();
        let on = |lost: f64| Candidate {
            factor: 1.0,
            grid,
            lost,
            accuracy: AreaAccuracy::known(grid, 1.0, 0.0),
        };
        let line = Line { area: 0.1, edges: 0.05, fall: None };
        let half = line.half_width(&on(0.0), &map).unwrap();
        assert!((half - on(0.0).accuracy.half_width_of(0.11, 0.05).unwrap()).abs() < 1e-15);
        let lossy = line.half_width(&on(0.01), &map).unwrap();
        assert!(((lossy - half) / 0.0015 - 1.0).abs() < 1e-9);
        // The gap to 1 % of its fall per e-fold load: the area to 1 % more.
        let gap = line.gap_half_width(&on(0.0), &map);
        let given = Line { fall: Some(100.0 * gap), ..line };
        assert!(
            ((given.half_width(&on(0.0), &map).unwrap() - half) / 0.001 - 0.99f64.sqrt()).abs()
                < 1e-9
        );
        let spots = Line { area: 0.01, ..line }.half_width(&on(0.0), &map);
        assert!(matches!(spots, Err(NoAreaInterval::SpotsTooSmall { .. })));
        let none = Line { area: 0.0, edges: 0.0, fall: None }.half_width(&on(0.0), &map);
        assert_eq!(none, Err(NoAreaInterval::Empty));
    }
}
