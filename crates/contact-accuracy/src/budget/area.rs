//! How far the area found on a grid may be from that of the surface the grid samples.

use super::no_interval::{MOST_CORRECTION, MOST_STEP, NoAreaInterval};
use crate::continuation::window_for;
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{BOUNDARY_CORRECTION, Boundary, Diagnostics, Solution};
use surface_stats::spectrum::PowerSpectrum;
use surface_stats::{StatsError, height_step, repeats};

/// Part of the correction that is left as uncertainty where its edges run in all directions.
pub const LEFT_OF_CORRECTION: f64 = 0.3;

/// The same of an isolated contact, whose edge of the map is part of the contact line.
const LEFT_OF_CORRECTION_FREE: f64 = 0.4;

/// Variance of the number of points inside a closed line at a random place on their grid, per edge
/// of the line: 0.676 per radius of a circle (Kendall 1948, doi:10.1093/qmath/os-19.1.1), which has
/// 8 edges per radius.
const POINTS_INSIDE: f64 = 0.676 / 8.0;

/// Waves, by their part in the mean square gradient, below which a surface is a regular pattern. Above,
/// the less of the points along its contact lines come in together: as its square.
const FEW_WAVES: f64 = 3.2;

/// Points by which an area may be wrong per edge of the contact line of a regular pattern: half a
/// point to either side of the count, from which the correction has moved away.
const TOGETHER: f64 = 0.5 + BOUNDARY_CORRECTION;

/// Ratio of mean square slopes up to which edges run in all directions.
const ISOTROPIC: f64 = 3.0;

/// Relative area error per relative rms pressure error that is left by stopping the iteration.
pub const AREA_PER_RESIDUAL: f64 = 9.0;

/// Share of the rms gradient that differences must see.
const LEAST_RESOLUTION: f64 = 0.94;

/// The same where height steps, finer than [`MOST_STEP`], make part of the gradient.
const LEAST_RESOLUTION_STEPPED: f64 = 0.90;

/// The pressure error above which the area error of the iteration is not known.
const LOOSEST: f64 = 1e-2;

/// What a map tells about the accuracy of areas computed on it: the gate, and the bar inside it.
/// Made once per surface, on demand.
///
/// A contact line cuts pixels. [`Diagnostics::area_fraction_corrected`] takes
/// that into account on average; what is left is a part of the correction, as long as the map
/// resolves its shortest waves. Whether it does is read off the rms gradient: by differences
/// between pixels it is smaller than from the spectrum, the more so the shorter the waves. How
/// often the bar held, on which kinds of surface, is measured in the book, "Error budget".
///
/// The interval is for the band-limited surface through the points of the map. It knows nothing of
/// what the instrument did not see, nor of the sampling error of one map as a sample of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct AreaAccuracy {
    /// Rms gradient by forward differences over that from the spectrum, g_FD / g_SP; 1 for a
    /// surface that is smooth on the scale of a pixel.
    pub resolution: f64,
    /// Height step over (rms gradient times pixel side); 0 if the heights are not stepped.
    pub step_ratio: f64,
    /// Mean square slope across the lay over that along it, at least 1.
    pub directions: f64,
    /// Independent waves of equal weight that would make a mean square gradient as certain as
    /// this one: `(sum S)^2 / sum S^2` over half the plane. A sine has 1, a rough map hundreds;
    /// infinite if not looked at.
    pub waves: f64,
    /// What lies beyond the edges.
    pub boundary: Boundary,
    grid: Grid,
}

impl AreaAccuracy {
    /// Looks at edges, gradients and steps of `surface`; if its edges do not meet, at its waves
    /// under a Hann window. One transform and one sort.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`].
    pub fn of(surface: &HeightMap) -> Result<Self, StatsError> {
        let power = PowerSpectrum::of(surface, window_for(repeats(surface)))?;
        Ok(Self::of_waves(surface.grid(), &power, height_step(surface.heights())))
    }

    /// From the waves of a map on `grid`, under a window if its edges do not meet, or the jump there
    /// would count as waves that are not resolved; and the step that its heights came in (m), if
    /// any.
    pub fn of_waves(grid: Grid, power: &PowerSpectrum, step: Option<f64>) -> Self {
        let (moments, [x, y]) = power.moments();
        let [dy, dx] = grid.pixel();
        let relief = moments.rms_gradient() * dy.min(dx);
        let step_ratio = if relief > 0.0 { step.unwrap_or(0.0) / relief } else { 0.0 };
        let resolution = power.resolved_gradient().unwrap_or(1.0);
        Self::known(grid, resolution, step_ratio).with_slopes([y, x]).with_waves(waves(power))
    }

    /// From what is known already, of slopes alike in all directions and many waves.
    pub fn known(grid: Grid, resolution: f64, step_ratio: f64) -> Self {
        let (directions, waves) = (1.0, f64::INFINITY);
        Self { resolution, step_ratio, directions, waves, boundary: Boundary::Periodic, grid }
    }

    /// The grid of the map.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// The same waves on another grid, which resolves them as well or better.
    #[must_use]
    pub fn on(self, grid: Grid) -> Self {
        Self { grid, ..self }
    }

    /// The same map pressed with another boundary.
    #[must_use]
    pub fn with_boundary(self, boundary: Boundary) -> Self {
        Self { boundary, ..self }
    }

    /// The same with the number of [`waves`](Self::waves) that carry its gradient.
    #[must_use]
    pub fn with_waves(self, waves: f64) -> Self {
        Self { waves, ..self }
    }

    /// The same with the mean square slopes along y and x, in any common unit.
    #[must_use]
    pub fn with_slopes(self, [y, x]: [f64; 2]) -> Self {
        let least = y.min(x);
        let directions = match (least > 0.0, y.max(x) > 0.0) {
            (true, _) => y.max(x) / least,
            (false, true) => f64::INFINITY,
            (false, false) => 1.0,
        };
        Self { directions, ..self }
    }

    /// Whether the map itself allows an interval, whatever the load.
    ///
    /// # Errors
    /// The reason if it does not.
    pub fn gate(&self) -> Result<(), NoAreaInterval> {
        if self.grid.shape().contains(&1) {
            return Err(NoAreaInterval::NotStudied("profiles"));
        }
        let [dy, dx] = self.grid.pixel();
        if (dy / dx).max(dx / dy) > 2.0 {
            return Err(NoAreaInterval::NotStudied("pixels longer than twice their width"));
        }
        let Self { resolution, step_ratio, .. } = *self;
        if step_ratio > MOST_STEP {
            return Err(NoAreaInterval::Stepped { ratio: step_ratio });
        }
        let needed = if step_ratio > 0.0 { LEAST_RESOLUTION_STEPPED } else { LEAST_RESOLUTION };
        if resolution < needed {
            return Err(NoAreaInterval::Unresolved { resolution, needed });
        }
        Ok(())
    }

    /// Half width of the interval around the corrected area that the pixels of this grid leave, as
    /// [`line_half_width`](Self::line_half_width) of a map inside the gate; 0 where no pixel is cut.
    ///
    /// # Errors
    /// [`NoAreaInterval`] where no such interval is known to hold, with the reason.
    pub fn grid_half_width(&self, solution: &Solution) -> Result<f64, NoAreaInterval> {
        if solution.grid != self.grid {
            return Err(NoAreaInterval::OtherGrid { map: self.grid, solution: solution.grid });
        }
        let found = &solution.diagnostics;
        if found.contact_pixels == 0 || found.contact_perimeter <= 0.0 {
            return Ok(0.0); // nothing or everything: no pixel is cut
        }
        let here = self.with_boundary(found.boundary);
        here.half_width_of(solution.state.area_fraction, found.contact_perimeter)
    }

    /// The same from the raw area fraction and the contact-line edges per pixel.
    ///
    /// # Errors
    /// [`NoAreaInterval`] where no such interval is known to hold, with the reason.
    pub fn half_width_of(
        &self,
        area_fraction: f64,
        contact_perimeter: f64,
    ) -> Result<f64, NoAreaInterval> {
        self.gate()?;
        self.line_half_width(area_fraction, contact_perimeter)
    }

    /// The same without a look at the gate: for a grid that is known to resolve the map.
    ///
    /// # Errors
    /// [`NoAreaInterval::SpotsTooSmall`].
    pub fn line_half_width(
        &self,
        area_fraction: f64,
        contact_perimeter: f64,
    ) -> Result<f64, NoAreaInterval> {
        let ratio = BOUNDARY_CORRECTION * contact_perimeter / area_fraction;
        if ratio > MOST_CORRECTION {
            return Err(NoAreaInterval::SpotsTooSmall { ratio });
        }
        Ok(self.line_left_over(contact_perimeter))
    }

    /// What a contact line of `contact_perimeter` edges per pixel leaves in doubt of the corrected
    /// area: a part of the correction ([`left_of_correction`]), and chance. A line through a grid of
    /// points takes in a few more or less of them; twice the standard deviation. On a regular
    /// pattern, which one or two waves make, the points along a line come in all at once: half a
    /// point per edge. Of more waves less, as the square of their number.
    pub fn line_left_over(&self, contact_perimeter: f64) -> f64 {
        let left_over = self.left_of_correction() * BOUNDARY_CORRECTION * contact_perimeter;
        let chance = 2.0 * (POINTS_INSIDE * contact_perimeter / self.grid.len() as f64).sqrt();
        let regular = match self.boundary {
            Boundary::Periodic => (FEW_WAVES / self.waves).min(1.0).powi(2),
            Boundary::Free => 0.0,
        };
        left_over.hypot(chance).max(regular * TOGETHER * contact_perimeter)
    }

    /// By how much a lay or a regular pattern widens the bar of the area, at least 1: where the edges
    /// of a contact line run alike, all that depends on them is wrong in one direction.
    pub fn widened(&self, contact_perimeter: f64) -> f64 {
        let any = Self { directions: 1.0, waves: f64::INFINITY, ..*self };
        let ratio = self.line_left_over(contact_perimeter) / any.line_left_over(contact_perimeter);
        if ratio > 1.0 { ratio } else { 1.0 } // no line, no ratio
    }

    /// Part of the correction that is left as uncertainty on this map: [`left_of_correction`], with
    /// 0.4 in place of 0.3 for an isolated contact.
    pub fn left_of_correction(&self) -> f64 {
        let least = match self.boundary {
            Boundary::Periodic => LEFT_OF_CORRECTION,
            Boundary::Free => LEFT_OF_CORRECTION_FREE,
        };
        left_of_correction(self.directions).max(least)
    }

    /// The interval for the area fraction of `solution`, found on the surface this was made from:
    /// the corrected area plus or minus what the grid and the iteration leave, cut to 0..=1.
    ///
    /// # Errors
    /// [`NoAreaInterval`] where no such interval is known to hold, with the reason.
    pub fn interval(&self, solution: &Solution) -> Result<[f64; 2], NoAreaInterval> {
        let half = self.grid_half_width(solution)? + iteration_half_width(&solution.diagnostics)?;
        let middle = solution.diagnostics.area_fraction_corrected;
        Ok([(middle - half).max(0.0), (middle + half).min(1.0)])
    }
}

/// Part of the correction that is left as uncertainty where the mean square slopes across and along
/// a lay have the ratio `directions`: 0.3 up to 3, towards 1 beyond. Edges that all run along one
/// axis cut no pixel on average, so that all of a correction made for edges of all directions is in
/// doubt.
pub fn left_of_correction(directions: f64) -> f64 {
    let aligned = 1.0 - (ISOTROPIC / directions).min(1.0);
    LEFT_OF_CORRECTION + (1.0 - LEFT_OF_CORRECTION) * aligned
}

/// Half width of the interval around the corrected area that stopping the iteration leaves:
/// the estimated relative rms error of the pressure times [`AREA_PER_RESIDUAL`].
///
/// # Errors
/// [`NoAreaInterval::TooLooselySolved`] above 1e-2.
pub fn iteration_half_width(found: &Diagnostics) -> Result<f64, NoAreaInterval> {
    let residual = found.residuals.preconditioned;
    if residual > LOOSEST {
        return Err(NoAreaInterval::TooLooselySolved { residual, limit: LOOSEST });
    }
    let is_exact = found.exact.is_some();
    Ok(if is_exact {
        0.0
    } else {
        AREA_PER_RESIDUAL * residual.max(0.0) * found.area_fraction_corrected
    })
}

/// Independent waves of equal weight that would carry the gradient as this spectrum does, for
/// [`AreaAccuracy::waves`]. Waves q and -q are one.
fn waves(power: &PowerSpectrum) -> f64 {
    let (mut sum, mut squares) = (0.0, 0.0);
    power.for_each(|[qy, qx], weight, variance| {
        let slope = variance * (qy * qy + qx * qx);
        sum += weight * slope;
        squares += weight * slope * slope;
    });
    if squares > 0.0 { 0.5 * sum * sum / squares } else { f64::INFINITY }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::{PI, TAU};
    use surface_stats::spectrum::Window;

    #[test]
    fn resolution_of_one_wave_is_known() {
        // Forward differences see |sin(q d/2) / (q d/2)| of a wave along an axis.
        for pixels in [4_usize, 8, 16] {
            let grid = Grid::new([64, 64], [1e-6, 1e-6]).unwrap();
            let q = TAU / (pixels as f64 * 1e-6);
            let map = HeightMap::from_fn(grid, |_, x| 1e-7 * (q * x).cos()).unwrap();
            let half = PI / pixels as f64;
            let found = AreaAccuracy::of(&map).unwrap().resolution;
            assert_relative_eq!(found, half.sin() / half, max_relative = 1e-9);
        }
    }

    /// Ridges along y: all slope along x. Twice as long waves along y: a quarter of the slope.
    #[test]
    fn a_lay_leaves_more_of_the_correction() {
        let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
        let wave = |k: f64, s: f64| (TAU * k * s / 64.0).cos();
        let map = |along: f64| {
            HeightMap::from_fn(grid, |y, x| along * wave(2.0, y) + wave(4.0, x)).unwrap()
        };
        assert_relative_eq!(
            AreaAccuracy::of(&map(1.0)).unwrap().directions,
            4.0,
            max_relative = 1e-9
        );
        assert!(AreaAccuracy::of(&map(0.0)).unwrap().directions > 1e9);
        assert_relative_eq!(left_of_correction(1.0), 0.3);
        assert_relative_eq!(left_of_correction(3.0), 0.3);
        assert_relative_eq!(left_of_correction(4.0), 0.3 + 0.7 * 0.25);
        assert_relative_eq!(left_of_correction(f64::INFINITY), 1.0);
    }

    fn smooth(side: usize) -> AreaAccuracy {
        AreaAccuracy::known(Grid::new([side, side], [1.0, 1.0]).unwrap(), 1.0, 0.0)
    }

    #[test]
    fn many_edges_leave_a_part_of_the_correction_and_few_leave_chance() {
        let wide = smooth(1 << 14).half_width_of(0.1, 0.05).unwrap();
        assert_relative_eq!(wide, 0.3 * BOUNDARY_CORRECTION * 0.05, max_relative = 1e-3);
        // One circle of radius 10 pixels on 100 x 100 points: deviation 2.6 pixels.
        let narrow = 1e4 * smooth(100).half_width_of(0.0314, 80.0 / 1e4).unwrap();
        let expected = (0.3 * BOUNDARY_CORRECTION * 80.0).hypot(2.0 * 6.76f64.sqrt());
        assert_relative_eq!(narrow, expected, max_relative = 1e-9);
        let lay = smooth(1 << 14).with_slopes([1.0, 1e9]).half_width_of(0.1, 0.05).unwrap();
        assert_relative_eq!(lay, BOUNDARY_CORRECTION * 0.05, max_relative = 1e-2);
        let isolated = smooth(1 << 14).with_boundary(Boundary::Free).line_left_over(0.05);
        assert_relative_eq!(isolated, 0.4 * BOUNDARY_CORRECTION * 0.05, max_relative = 1e-3);
        assert_relative_eq!(smooth(99).with_waves(2.0).line_left_over(0.05), 0.05 * TOGETHER);
        let spots = smooth(100).half_width_of(0.01, 0.05);
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
        assert!((0.4..1.6).contains(&(variance / (8.0 * POINTS_INSIDE * radius))), "{variance}");
    }

    /// One wave, an egg box of two, and ten of equal slope.
    #[test]
    fn waves_are_counted_by_their_part_in_the_gradient() {
        let grid = Grid::new([64, 64], [1.0, 1.0]).unwrap();
        let waves = |ks: &[[f64; 2]]| {
            let wave = |y: f64, x: f64| -> f64 {
                let one = |k: &[f64; 2]| {
                    (TAU * (k[0] * y + k[1] * x) / 64.0 + k[0] * k[1]).cos() / k[0].hypot(k[1])
                };
                ks.iter().map(one).sum()
            };
            AreaAccuracy::of(&HeightMap::from_fn(grid, wave).unwrap()).unwrap().waves
        };
        assert_relative_eq!(waves(&[[0.0, 3.0]]), 1.0, max_relative = 1e-9);
        assert_relative_eq!(waves(&[[2.0, 2.0], [2.0, -2.0]]), 2.0, max_relative = 1e-9);
        let ten: Vec<[f64; 2]> = (1..11).map(|k| [f64::from(k), f64::from(11 - k)]).collect();
        assert_relative_eq!(waves(&ten), 10.0, max_relative = 1e-9);
    }

    #[test]
    fn steps_are_found_and_continuous_heights_have_none() {
        let grid = Grid::new([40, 40], [1.0, 1.0]).unwrap();
        let wave =
            |y: f64, x: f64| (0.731 * x + 0.2 * y).sin() + (0.417 * y * (1.0 + 0.01 * x)).cos();
        let smooth = HeightMap::from_fn(grid, wave).unwrap();
        assert!(AreaAccuracy::of(&smooth).unwrap().step_ratio.abs() < 1e-12);
        let stepped = HeightMap::from_fn(grid, |y, x| (wave(y, x) / 0.1).round() * 0.1).unwrap();
        let found = AreaAccuracy::of(&stepped).unwrap();
        let relief = PowerSpectrum::of(&stepped, Window::Hann).unwrap().moments().0.rms_gradient();
        assert_relative_eq!(found.step_ratio, 0.1 / relief, max_relative = 1e-6);
    }
}
