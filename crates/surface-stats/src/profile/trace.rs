//! One line of evenly spaced heights.

use crate::StatsError;
use crate::clean::{gaussian_filter, short_waves};
use crate::polynomial::Polynomial;
use contact_types::{Grid, HeightMap};
use std::ops::Deref;

/// Fewest points of which statistics of a profile are taken.
pub(super) const LEAST_POINTS: usize = 32;

/// One line of evenly spaced heights: a height map of one row, so that everything that is defined
/// for rows of maps holds here too.
#[derive(Debug, Clone, PartialEq)]
pub struct Trace(HeightMap);

impl Trace {
    /// Heights (m) at a `spacing` (m).
    ///
    /// # Errors
    /// [`StatsError::TooFewPoints`], which names the fewest, [`StatsError::Surface`] for a spacing
    /// or a height that is no usable number.
    pub fn new(spacing: f64, heights: Vec<f64>) -> Result<Self, StatsError> {
        let found = heights.len();
        if found < LEAST_POINTS {
            let what = "a profile";
            return Err(StatsError::TooFewPoints { what, needed: LEAST_POINTS, found });
        }
        let grid = Grid::new([1, found], [spacing; 2])?;
        Ok(Self(HeightMap::new(grid, heights)?))
    }

    /// Distance of neighbouring points (m).
    pub fn spacing(&self) -> f64 {
        self.0.grid().pixel()[1]
    }

    /// From the first point to the last (m).
    pub fn length(&self) -> f64 {
        (self.heights().len() - 1) as f64 * self.spacing()
    }

    /// Without the least-squares polynomial of this degree: 0 the mean, 1 the line.
    pub(super) fn levelled(&self, degree: usize) -> Result<Self, StatsError> {
        let form = Polynomial::fit(self.grid(), self.heights(), degree)?;
        Ok(Self(form.taken_off(self.0.clone())?))
    }

    /// Without the waves shorter than `short` and those longer than `long` (m), where given: the Gaussian filter of ISO
    /// 16610-21, of which half an amplitude passes. `long` also takes half of itself off both ends, where the filter has
    /// seen only one side.
    pub(super) fn filtered(
        &self,
        short: Option<f64>,
        long: Option<f64>,
    ) -> Result<Self, StatsError> {
        let mut trace = self.clone();
        if let Some(short) = short {
            let heights = gaussian_filter(self.grid(), self.heights(), short)?;
            trace = Self::new(self.spacing(), heights)?;
        }
        if let Some(long) = long {
            let heights = short_waves(self.grid(), trace.heights(), long)?;
            let cut = (0.5 * long / self.spacing() - 1e-9).ceil() as usize;
            let end = heights.len().saturating_sub(cut);
            trace = Self::new(self.spacing(), heights[cut.min(end)..end].to_vec())?;
        }
        Ok(trace)
    }
}

impl Deref for Trace {
    type Target = HeightMap;

    fn deref(&self) -> &HeightMap {
        &self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use std::f64::consts::{LN_2, TAU};

    /// ISO 16610-21: transmission exp(-π (α λc/λ)²) = 2^(-(λc/λ)²), one half at the cut-off, and
    /// the roughness is what is left. Away from the ends by one cut-off nothing else is seen; half a cut-off from them
    /// 0.4 % of the weights are missing, and a wave of a quarter of the cut-off is disturbed by less.
    #[test]
    fn half_of_an_amplitude_passes_at_the_cut_off() {
        let (cutoff, spacing, amplitude) = (0.8e-3, 0.5e-6, 1e-6);
        for ratio in [0.25, 0.5, 1.0, 2.0, 3.0] {
            let z = |i: usize| amplitude * (TAU * i as f64 * spacing / (cutoff * ratio)).sin();
            let trace = Trace::new(spacing, (0..12_001).map(z).collect()).unwrap();
            let short = trace.filtered(None, Some(cutoff)).unwrap();
            assert_eq!(short.heights().len(), 12_001 - 2 * 800);
            let passes = (-LN_2 / (ratio * ratio)).exp();
            for i in (3000..9000).step_by(37) {
                let expected = (1.0 - passes) * z(i);
                assert_abs_diff_eq!(short.heights()[i - 800], expected, epsilon = 1e-13);
            }
            let is_short = ratio <= 0.25;
            for (i, found) in short.heights().iter().enumerate().filter(|_| is_short) {
                let expected = (1.0 - passes) * z(i + 800);
                assert_abs_diff_eq!(*found, expected, epsilon = 0.004 * amplitude);
            }
        }
    }

    #[test]
    fn too_few_points_are_refused_with_the_limit() {
        let refused = Trace::new(1e-6, vec![0.0; 31]);
        assert!(matches!(refused, Err(StatsError::TooFewPoints { needed: 32, found: 31, .. })));
        assert!(Trace::new(0.0, vec![0.0; 100]).is_err());
        assert!(Trace::new(1e-6, vec![f64::NAN; 100]).is_err());
    }
}
