//! How far the area found on a grid may be from that of the surface the grid samples.

use crate::{Boundary, Solution};
use contact_types::HeightMap;
use grid_fft::GridFft;
use std::f64::consts::{LN_2, PI};

/// Area by which a count of pixels is too large, in pixels per edge of the contact line, for edges
/// of all directions: (π − 1 + ln 2)/24 (Yastrebov, Anciaux & Molinari 2017,
/// doi:10.1016/j.triboint.2017.04.023).
pub const BOUNDARY_CORRECTION: f64 = (PI - 1.0 + LN_2) / 24.0;

/// What a map tells about the accuracy of areas computed on it. Made once per surface, on demand.
///
/// A contact line cuts pixels. [`Diagnostics::area_fraction_corrected`](crate::Diagnostics) takes
/// that into account on average; what is left was within 30 % of the correction in 95–100 % of 200
/// refinement studies of self-affine maps, as long as the map resolves its shortest waves. Whether
/// it does is read off the rms gradient: by differences between pixels it is smaller than from the
/// spectrum, the more so the shorter the waves.
///
/// The interval is for the band-limited surface through the points of the map. It knows nothing of
/// what the instrument did not see, nor of the sampling error of one map as a sample of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaAccuracy {
    /// Rms gradient by forward differences over that from the spectrum, g_FD / g_SP; 1 for a
    /// surface that is smooth on the scale of a pixel.
    pub resolution: f64,
    /// Height step over (rms gradient times pixel side); 0 if the heights are not stepped.
    pub step_ratio: f64,
    shape: [usize; 2],
    pixel_ratio: f64,
}

/// Why there is no interval for an area.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoAreaInterval {
    /// The shortest waves of the map are too short for its pixels, or the heights too coarsely
    /// stepped.
    #[error(
        "the map does not resolve its shortest waves: gradients by differences and from the \
         spectrum have the ratio {resolution:.3} (needed: 0.94, or 0.90 where height steps are \
         below half of gradient x pixel; here {step_ratio:.2}); solve on a map refined 2 x"
    )]
    Unresolved {
        /// g_FD / g_SP.
        resolution: f64,
        /// Height step over (rms gradient times pixel side).
        step_ratio: f64,
    },
    /// The contact spots are too small for the pixels.
    #[error(
        "the contact spots are too small for the pixels: the correction for cut pixels is \
         {ratio:.2} of the area (at most 0.2); solve on a finer map or at a higher load"
    )]
    SpotsTooSmall {
        /// Correction over raw area.
        ratio: f64,
    },
    /// The iteration stopped too early.
    #[error(
        "the pressure is known to {residual:.1e} only; an interval for the area needs a tolerance \
         of {limit:.0e}"
    )]
    TooLooselySolved {
        /// Estimated relative pressure error.
        residual: f64,
        /// What it must not exceed.
        limit: f64,
    },
    /// The interval was not studied for this kind of problem.
    #[error("no interval is known for {0}")]
    NotStudied(&'static str),
}

/// The pressure error above which the area error of the iteration is no longer negligible.
const LOOSEST: f64 = 2e-4;

impl AreaAccuracy {
    /// Looks at the gradients and steps of `surface`. One transform and one sort.
    pub fn of(surface: &HeightMap) -> Self {
        let grid = surface.grid();
        let [ny, nx] = grid.shape();
        let [dy, dx] = grid.pixel();
        let top = surface.range().1;
        let h: Vec<f64> = surface.heights().iter().map(|h| h - top).collect();
        let n = h.len() as f64;
        let mut differences = 0.0;
        for iy in 0..ny {
            for ix in 0..nx {
                let here = h[iy * nx + ix];
                let below = h[(iy + 1) % ny * nx + ix];
                let right = h[iy * nx + (ix + 1) % nx];
                differences += ((below - here) / dy).powi(2) + ((right - here) / dx).powi(2);
            }
        }
        let mut fft = GridFft::<f64>::new(grid.shape());
        let mut spectrum = fft.new_spectrum();
        fft.forward(&h, &mut spectrum);
        let nq = nx / 2 + 1;
        let mut spectral = 0.0;
        for (i, wave) in spectrum.iter().enumerate() {
            let (iy, ix) = (i / nq, i % nq);
            let twice = if ix == 0 || 2 * ix == nx { 1.0 } else { 2.0 };
            spectral += twice * grid.wavenumber(iy, ix).powi(2) * wave.norm_sqr();
        }
        let (by_differences, by_spectrum) = ((differences / n).sqrt(), spectral.sqrt() / n);
        let ratio = |a: f64, b: f64| if b > 0.0 { a / b } else { 1.0 };
        let step = height_step(h);
        Self {
            resolution: ratio(by_differences, by_spectrum),
            step_ratio: if step > 0.0 { ratio(step, by_spectrum * dy.min(dx)) } else { 0.0 },
            shape: grid.shape(),
            pixel_ratio: (dy / dx).max(dx / dy),
        }
    }

    /// The interval for the area fraction of `solution`, found on the surface this was made from:
    /// the corrected area plus or minus 0.3 of the correction, cut to 0..=1.
    ///
    /// # Errors
    /// [`NoAreaInterval`] where no such interval is known to hold, with the reason.
    pub fn interval(&self, solution: &Solution) -> Result<[f64; 2], NoAreaInterval> {
        let found = &solution.diagnostics;
        let area = solution.state.area_fraction;
        if found.contact_pixels == 0 || found.contact_perimeter <= 0.0 {
            return Ok([area, area]); // nothing or everything: no pixel is cut
        }
        if found.boundary == Boundary::Free {
            return Err(NoAreaInterval::NotStudied("the free boundary"));
        }
        if self.shape.contains(&1) {
            return Err(NoAreaInterval::NotStudied("profiles"));
        }
        if self.pixel_ratio > 2.0 {
            return Err(NoAreaInterval::NotStudied("pixels longer than twice their width"));
        }
        let residual = found.residuals.preconditioned;
        if residual > LOOSEST {
            return Err(NoAreaInterval::TooLooselySolved { residual, limit: LOOSEST });
        }
        let Self { resolution, step_ratio, .. } = *self;
        if !(resolution >= 0.94 || (resolution >= 0.90 && step_ratio <= 0.5)) {
            return Err(NoAreaInterval::Unresolved { resolution, step_ratio });
        }
        let correction = area - found.area_fraction_corrected;
        let ratio = correction / area;
        if ratio > 0.2 {
            return Err(NoAreaInterval::SpotsTooSmall { ratio });
        }
        let middle = found.area_fraction_corrected;
        let half = 0.3 * correction;
        Ok([(middle - half).max(0.0), (middle + half).min(1.0)])
    }
}

/// The step in which heights are given: the median distance of neighbouring distinct values, if
/// many pixels share their value with others; 0 if the heights are continuous.
fn height_step(mut heights: Vec<f64>) -> f64 {
    let pixels = heights.len();
    heights.sort_by(f64::total_cmp);
    let range = heights[pixels - 1] - heights[0];
    let same = 1e-9 * range; // rounding of heights written as multiples of a step
    let mut gaps: Vec<f64> =
        heights.windows(2).map(|w| w[1] - w[0]).filter(|d| *d > same).collect();
    if gaps.is_empty() || gaps.len() > pixels / 4 {
        return 0.0;
    }
    gaps.sort_by(f64::total_cmp);
    gaps[gaps.len() / 2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use contact_types::Grid;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn resolution_of_one_wave_is_known() {
        // Forward differences see |sin(q d/2) / (q d/2)| of a wave along an axis.
        for pixels in [4_usize, 8, 16] {
            let grid = Grid::new([64, 64], [1e-6, 1e-6]).unwrap();
            let q = TAU / (pixels as f64 * 1e-6);
            let map = HeightMap::from_fn(grid, |_, x| 1e-7 * (q * x).cos()).unwrap();
            let half = PI / pixels as f64;
            let found = AreaAccuracy::of(&map).resolution;
            assert_relative_eq!(found, half.sin() / half, max_relative = 1e-9);
        }
    }

    #[test]
    fn steps_are_found_and_continuous_heights_have_none() {
        let grid = Grid::new([40, 40], [1.0, 1.0]).unwrap();
        let wave =
            |y: f64, x: f64| (0.731 * x + 0.2 * y).sin() + (0.417 * y * (1.0 + 0.01 * x)).cos();
        let smooth = HeightMap::from_fn(grid, wave).unwrap();
        assert!(AreaAccuracy::of(&smooth).step_ratio.abs() < 1e-12);
        let stepped = HeightMap::from_fn(grid, |y, x| (wave(y, x) / 0.1).round() * 0.1).unwrap();
        assert_relative_eq!(height_step(stepped.into_heights()), 0.1, max_relative = 1e-6);
    }
}
