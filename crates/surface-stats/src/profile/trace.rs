//! One line of evenly spaced heights.

use crate::clean::{gaussian_filter, short_waves};
use crate::level::without_form;
use crate::{Edges, StatsError};
use contact_types::{Grid, HeightMap};

/// Fewest points of which statistics of a profile are taken.
pub(crate) const LEAST_POINTS: usize = 32;

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

    /// Number of points.
    #[expect(clippy::len_without_is_empty, reason = "it has at least LEAST_POINTS points")]
    pub fn len(&self) -> usize {
        self.0.heights().len()
    }

    /// From the first point to the last (m).
    pub fn length(&self) -> f64 {
        (self.len() - 1) as f64 * self.spacing()
    }

    /// Heights (m).
    pub fn heights(&self) -> &[f64] {
        self.0.heights()
    }

    /// As a height map of one row.
    pub fn as_map(&self) -> &HeightMap {
        &self.0
    }

    /// Without the least-squares polynomial of this degree: 0 the mean, 1 the line.
    pub(super) fn levelled(&self, degree: usize) -> Result<Self, StatsError> {
        Ok(Self(without_form(&self.0, degree)?))
    }

    /// Without the waves shorter than `nesting_index` (m): the Gaussian filter of ISO 16610-21,
    /// of which half an amplitude passes at the nesting index.
    fn without_short_waves(&self, nesting_index: f64) -> Result<Self, StatsError> {
        let heights = gaussian_filter(self.0.grid(), self.heights(), nesting_index, Edges::Open)?;
        Self::new(self.spacing(), heights)
    }

    /// Without the waves longer than `nesting_index` (m), as
    /// [`without_short_waves`](Self::without_short_waves) leaves them.
    fn without_long_waves(&self, nesting_index: f64) -> Result<Self, StatsError> {
        let heights = short_waves(self.0.grid(), self.heights(), nesting_index, Edges::Open)?;
        Self::new(self.spacing(), heights)
    }

    /// Without the waves shorter than `short` and those longer than `long` (m), where given. `long`
    /// also takes half of itself off both ends, where the filter has seen only one side.
    pub(super) fn filtered(
        &self,
        short: Option<f64>,
        long: Option<f64>,
    ) -> Result<Self, StatsError> {
        let shortened = short.map(|s| self.without_short_waves(s)).transpose()?;
        match long {
            Some(long) => {
                let trace = shortened.as_ref().unwrap_or(self);
                trace.without_long_waves(long)?.without_ends(0.5 * long)
            }
            None => Ok(shortened.unwrap_or_else(|| self.clone())),
        }
    }

    /// Points `start` to `end` (exclusive).
    pub(crate) fn part(&self, start: usize, end: usize) -> Result<Self, StatsError> {
        let end = end.min(self.len());
        Self::new(self.spacing(), self.heights()[start.min(end)..end].to_vec())
    }

    /// Without `distance` (m) at both ends.
    fn without_ends(&self, distance: f64) -> Result<Self, StatsError> {
        let cut = (distance / self.spacing() - 1e-9).ceil().max(0.0) as usize;
        self.part(cut, self.len().saturating_sub(cut))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};
    use std::f64::consts::{LN_2, TAU};

    fn wave(amplitude: f64, wavelength: f64, spacing: f64, n: usize) -> Trace {
        let z = |i: usize| amplitude * (TAU * i as f64 * spacing / wavelength).sin();
        Trace::new(spacing, (0..n).map(z).collect()).unwrap()
    }

    /// ISO 16610-21: transmission exp(-π (α λc/λ)²) = 2^(-(λc/λ)²), one half at the cut-off, and
    /// the roughness is what is left. Away from the ends by one cut-off nothing else is seen.
    #[test]
    fn half_of_an_amplitude_passes_at_the_cut_off() {
        let (cutoff, spacing) = (0.8e-3, 0.5e-6);
        for ratio in [0.25, 0.5, 1.0, 2.0, 3.0] {
            let wavelength = cutoff * ratio;
            let trace = wave(1e-6, wavelength, spacing, 12_001);
            let long = trace.without_short_waves(cutoff).unwrap();
            let short = trace.without_long_waves(cutoff).unwrap();
            let passes = (-LN_2 / (ratio * ratio)).exp();
            for i in (3000..9000).step_by(37) {
                let z = trace.heights()[i];
                assert_abs_diff_eq!(long.heights()[i], passes * z, epsilon = 1e-13);
                assert_abs_diff_eq!(short.heights()[i], (1.0 - passes) * z, epsilon = 1e-13);
            }
        }
    }

    /// Half a cut-off from an end 0.4 % of the weights are missing: a wave of a quarter of the
    /// cut-off is disturbed by less than that, and a constant not at all.
    #[test]
    fn half_a_cut_off_from_the_ends_the_filter_is_undisturbed() {
        let cutoff = 0.25e-3;
        let trace = wave(1e-6, cutoff / 4.0, 0.5e-6, 4001);
        let short = trace.without_long_waves(cutoff).unwrap();
        let inner = short.without_ends(cutoff / 2.0).unwrap();
        assert_eq!(inner.len(), 4001 - 2 * 250);
        let passes = 1.0 - (-LN_2 * 16.0).exp();
        for (i, z) in inner.heights().iter().enumerate() {
            let expected = passes * trace.heights()[i + 250];
            assert_abs_diff_eq!(*z, expected, epsilon = 0.004e-6);
        }
        let level = Trace::new(1e-6, vec![3.0; 500]).unwrap();
        let long = level.without_short_waves(1e-4).unwrap();
        assert!(long.heights().iter().all(|z| (z - 3.0).abs() < 1e-14));
    }

    #[test]
    fn lines_and_polynomials_are_taken_off() {
        let form = |x: f64| 5e-3 + 0.02 * x - 3.0 * x * x + 400.0 * x * x * x;
        let spacing = 1e-6;
        let z =
            |i: usize| form(i as f64 * spacing) + if i.is_multiple_of(2) { 1e-8 } else { -1e-8 };
        let trace = Trace::new(spacing, (0..2000).map(z).collect()).unwrap();
        let flat = trace.levelled(3).unwrap();
        for (i, z) in flat.heights().iter().enumerate() {
            let expected = if i.is_multiple_of(2) { 1e-8 } else { -1e-8 };
            assert_abs_diff_eq!(*z, expected, epsilon = 1e-10);
        }
        let line = trace.levelled(1).unwrap();
        let mean = line.heights().iter().sum::<f64>() / 2000.0;
        assert_abs_diff_eq!(mean, 0.0, epsilon = 1e-15);
        assert_relative_eq!(trace.length(), 1999e-6, max_relative = 1e-12);
    }

    #[test]
    fn too_few_points_are_refused_with_the_limit() {
        let refused = Trace::new(1e-6, vec![0.0; 31]);
        assert!(matches!(refused, Err(StatsError::TooFewPoints { needed: 32, found: 31, .. })));
        assert!(Trace::new(0.0, vec![0.0; 100]).is_err());
        assert!(Trace::new(1e-6, vec![f64::NAN; 100]).is_err());
    }
}
