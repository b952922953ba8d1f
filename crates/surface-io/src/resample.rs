//! From a profile whose points are not evenly spaced to one whose points are.

use crate::{FillError, Measurement};
use contact_types::Grid;

/// Largest distance of neighbouring points that a straight line bridges, in mean distances.
const LARGEST_GAP: f64 = 10.0;

impl Measurement {
    /// Puts the points of a profile at equal distances: as many points over the same length, on the
    /// straight lines between neighbouring points. That adds no height that was not between two measured
    /// ones, and takes away slope and curvature of waves shorter than a few of the longest steps. A
    /// line that ends in a missing point is missing. What is evenly spaced stays as it is; of anything else the shortest
    /// and the longest distance of the points before (m) are returned as well.
    ///
    /// # Errors
    /// [`FillError::Gap`] for neighbours more than ten mean distances apart.
    pub fn evenly_spaced(mut self) -> Result<(Self, Option<[f64; 2]>), FillError> {
        let positions = self.positions.take().filter(|x| x.len() == self.heights.len());
        let Some(x) = positions else { return Ok((self, None)) };
        let n = x.len();
        let length = x.last().copied().unwrap_or(0.0);
        let spacing = length / (n.max(2) - 1) as f64;
        let steps = x
            .windows(2)
            .map(|x| x[1] - x[0])
            .fold([f64::INFINITY, 0.0], |[low, high], d| [d.min(low), d.max(high)]);
        if steps[1] > LARGEST_GAP * spacing {
            return Err(FillError::Gap { gap: steps[1], spacing, limit: LARGEST_GAP });
        }
        let mut heights = Vec::with_capacity(n);
        let mut left = 0;
        for i in 0..n {
            let at = (i as f64 * spacing).min(length);
            while left + 2 < n && x[left + 1] <= at {
                left += 1;
            }
            let share = ((at - x[left]) / (x[left + 1] - x[left])).clamp(0.0, 1.0);
            let [a, b] = [self.heights[left], self.heights[left + 1]];
            // At a point only that point counts, also beside a missing one.
            heights.push(match share {
                0.0 => a,
                1.0 => b,
                share => a + share * (b - a),
            });
        }
        self.grid = Grid::new(self.grid.shape(), [spacing; 2]).map_err(FillError::Surface)?;
        self.heights = heights;
        self.uneven = None;
        Ok((self, Some(steps)))
    }
}
