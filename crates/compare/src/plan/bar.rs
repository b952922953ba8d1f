//! The error budget of an area on a grid that need not be the given one.
//!
//! Three parts, each calibrated on 106 maps of 256² points in seven families at five loads, on
//! grids from 1/8 to 2 times the given one, against the map on 1024² points:
//! - what is left of the correction for the contact line (Yastrebov, Anciaux & Molinari 2017) after
//!   it is subtracted: 30 % of it, more where most edges run along one axis;
//! - chance: a line through a grid of points takes in a few more or less of them. For a circle at a
//!   random place the variance is 0.676 times its radius in pixels (Kendall 1948,
//!   doi:10.1093/qmath/os-19.1.1), 0.085 per edge of its line, and the bar is twice the deviation;
//! - the gradient that a coarser grid loses: the area at a light load is as 1/h'_rms. The largest
//!   excess seen was 1.41 times the loss.

use super::Candidate;
use crate::budget::iteration::area_error;
use fft_bem_solver::{BOUNDARY_CORRECTION, NoAreaInterval, Solution, left_of_correction};

/// Variance of the points inside a line, per edge of it.
const VARIANCE: f64 = 0.676 / 8.0;
/// Relative area error per relative loss of gradient.
const LOST: f64 = 1.5;
/// Largest correction over raw area.
const MOST: f64 = 0.2;

/// The contact line of one solution, from which the bar on another grid follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Corrected area fraction.
    pub area: f64,
    /// Edges per point, S_d.
    pub edges: f64,
}

impl Line {
    /// Of a solution.
    pub fn of(solution: &Solution) -> Self {
        let d = &solution.diagnostics;
        Self { area: d.area_fraction_corrected, edges: d.contact_perimeter }
    }

    /// The same line on a grid with pixels `scale` times as long: as much longer in pixels as
    /// there are more of them, per point shorter.
    #[must_use]
    pub fn on_pixels(self, scale: f64) -> Self {
        Self { edges: scale * self.edges, ..self }
    }

    /// Half width from the grid, in area fraction.
    ///
    /// # Errors
    /// [`NoAreaInterval::SpotsTooSmall`] or [`NoAreaInterval::Empty`].
    pub fn half_width(self, on: &Candidate, directions: f64) -> Result<f64, NoAreaInterval> {
        let correction = BOUNDARY_CORRECTION * self.edges;
        let raw = self.area + correction;
        if raw <= 0.0 {
            return Err(NoAreaInterval::Empty);
        }
        if correction > MOST * raw {
            return Err(NoAreaInterval::SpotsTooSmall { ratio: correction / raw });
        }
        let left_over = left_of_correction(directions) * correction;
        let chance = 2.0 * (VARIANCE * self.edges / on.grid.len() as f64).sqrt();
        Ok(left_over.hypot(chance) + LOST * on.lost * self.area)
    }
}

/// Half widths around the corrected area, in area fraction: from the grid and from the iteration.
///
/// # Errors
/// [`NoAreaInterval`] if this grid or this load has none.
pub fn bar(
    solution: &Solution,
    on: &Candidate,
    directions: f64,
) -> Result<[f64; 2], NoAreaInterval> {
    let d = &solution.diagnostics;
    let touches_everywhere = d.contact_pixels > 0 && d.contact_perimeter <= 0.0;
    if !touches_everywhere {
        on.gate?;
    }
    let grid = Line::of(solution).half_width(on, directions)?;
    // Exact for these points is not exact for the surface: only the iteration is out of doubt.
    let residual = if d.exact.is_some() { 0.0 } else { d.residuals.preconditioned };
    Ok([grid, area_error(residual) * d.area_fraction_corrected])
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    fn on(side: usize, lost: f64) -> Candidate {
        let grid = Grid::new([side, side], [1.0, 1.0]).unwrap();
        Candidate { factor: 1.0, grid, lost, gate: Ok(()) }
    }

    #[test]
    fn many_edges_leave_a_part_of_the_correction_and_few_leave_chance() {
        let line = Line { area: 0.1, edges: 0.05 };
        let wide = line.half_width(&on(1 << 14, 0.0), 1.0).unwrap();
        assert!((wide / (0.3 * BOUNDARY_CORRECTION * 0.05) - 1.0).abs() < 1e-3);
        // One circle of radius 10 pixels on 100 x 100 points: deviation 2.6 pixels.
        let circle = Line { area: 0.0314, edges: 80.0 / 1e4 };
        let narrow = circle.half_width(&on(100, 0.0), 1.0).unwrap() * 1e4;
        let expected = (0.3 * BOUNDARY_CORRECTION * 80.0).hypot(2.0 * 6.76f64.sqrt());
        assert!((narrow / expected - 1.0).abs() < 1e-9);
        let lossy = line.half_width(&on(1 << 14, 0.01), 1.0).unwrap();
        assert!(((lossy - wide) / 0.0015 - 1.0).abs() < 1e-9);
        let lay = line.half_width(&on(1 << 14, 0.0), 1e9).unwrap();
        assert!((lay / (BOUNDARY_CORRECTION * 0.05) - 1.0).abs() < 1e-2);
        let spots = Line { area: 0.01, edges: 0.05 }.half_width(&on(100, 0.0), 1.0);
        assert!(matches!(spots, Err(NoAreaInterval::SpotsTooSmall { .. })));
    }

    /// The count of points in circles at random places varies as the budget says.
    #[test]
    fn variance_of_the_points_in_a_circle() {
        let (radius, trials) = (9.3f64, 4000);
        let place = |k: usize, by: f64| (k as f64 * by).fract();
        let count = |k: usize| {
            let (x0, y0) = (place(k, 0.754_877_666), place(k, 0.569_840_290));
            let inside = |i: i32, j: i32| {
                (f64::from(i) - x0).powi(2) + (f64::from(j) - y0).powi(2) < radius * radius
            };
            let points = (-11..=12).flat_map(|i| (-11..=12).map(move |j| (i, j)));
            points.filter(|&(i, j)| inside(i, j)).count() as f64
        };
        let counts: Vec<f64> = (0..trials).map(count).collect();
        let mean = counts.iter().sum::<f64>() / f64::from(trials as u32);
        let square = counts.iter().map(|c| (c - mean).powi(2)).sum::<f64>();
        let variance = square / f64::from(trials as u32);
        // It swings about the mean over radii by half of it.
        assert!((0.4..1.6).contains(&(variance / (8.0 * VARIANCE * radius))), "{variance}");
    }
}
