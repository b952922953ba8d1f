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

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;

    use crate::{Fill, FillError, ReadOptions, read_bytes};

    fn read(text: &str) -> crate::Measurement {
        read_bytes(text.as_bytes(), &ReadOptions::default()).unwrap()
    }

    /// Heights on a line stay on it; between 1 and 4 µm a straight line stands for the tent.
    #[test]
    fn points_lie_on_the_lines_between_their_neighbours() {
        let profile = read("x [um];z [nm]\n5.00;0\n6.00;1\n9.00;7\n10.00;9\n11.00;11\n");
        assert!(profile.uneven.is_some());
        assert_eq!(profile.positions.as_ref().unwrap().len(), 5);
        let (even, steps) = profile.evenly_spaced().unwrap();
        let (spacing, longest) = (even.grid().pixel()[1], steps.unwrap()[1]);
        assert!((spacing - 1.5e-6).abs() < 1e-18 && (longest - 3e-6).abs() < 1e-18);
        let map = even.fill(Fill::Refuse).unwrap();
        // 5, 6.5, 8, 9.5, 11 µm.
        for (z, nm) in map.heights().iter().zip([0.0, 2.0, 5.0, 8.0, 11.0]) {
            assert!((z - 1e-9 * nm).abs() < 1e-20, "{z:e} {nm}");
        }
    }

    /// Falling positions give the same; what is even is left as it is.
    #[test]
    fn either_direction_and_even_profiles() {
        let up = read("x [um];z [nm]\n0.00;1\n1.00;5\n4.00;2\n5.00;7\n").evenly_spaced().unwrap().0;
        let down =
            read("x [um];z [nm]\n5.00;7\n4.00;2\n1.00;5\n0.00;1\n").evenly_spaced().unwrap().0;
        assert_eq!(up.heights(), down.heights());
        assert!((up.heights()[1] - 13e-9 / 3.0).abs() < 1e-20, "{up:?}");
        let even = read("x [um];z [nm]\n0;1\n1;5\n2;2\n3;7\n");
        let (same, steps) = even.clone().evenly_spaced().unwrap();
        assert!(steps.is_none() && same == even);
    }

    #[test]
    fn a_gap_is_not_bridged() {
        let mut text = String::from("x [um];z [nm]\n");
        for i in 0..30 {
            let x = if i < 15 { i } else { i + 100 };
            writeln!(text, "{x};{}", i % 3).unwrap();
        }
        let refused = read(&text).evenly_spaced();
        assert!(matches!(refused, Err(FillError::Gap { .. })), "{refused:?}");
    }
}
