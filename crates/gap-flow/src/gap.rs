//! A map of the gap, and the closed forms that need no more than its heights.

use contact_types::Grid;

/// A map of the gap.
#[derive(Debug, Clone, Copy)]
pub struct Gap<'a> {
    pub(crate) grid: Grid,
    pub(crate) heights: &'a [f64],
    /// Along the flow, and across it.
    pub(crate) repeats: [bool; 2],
}

impl<'a> Gap<'a> {
    /// Gap in metres, row-major `[ny, nx]`; 0 and less is contact. The map repeats along both axes.
    ///
    /// # Panics
    /// If there is not one number for each point.
    pub fn new(grid: Grid, heights: &'a [f64]) -> Self {
        assert_eq!(grid.len(), heights.len(), "one gap for each point");
        Self { grid, heights, repeats: [true; 2] }
    }

    /// The same that repeats along the flow, and across it, or does not: then it lies between inlet and outlet, and between walls.
    #[must_use]
    pub fn repeating(self, repeats: [bool; 2]) -> Self {
        Self { repeats, ..self }
    }

    fn open(&self) -> impl Iterator<Item = f64> {
        self.heights.iter().copied().filter(|g| *g > 0.0)
    }

    /// Mean gap ⟨g⟩ (m), contact counted as 0.
    pub fn mean(&self) -> f64 {
        self.open().fold(0.0, |sum, g| sum + g) / self.heights.len() as f64
    }

    /// Permeability (m³) by Bruggeman's effective medium in two dimensions: the K at which
    ///
    /// ```math
    /// \sum_i \frac{\kappa_i - K}{\kappa_i + K} = 0, \qquad \kappa = g^3;
    /// ```
    ///
    /// 0 from half of the points in contact on. A property of the histogram of the gap alone.
    ///
    /// # Source
    /// Bruggeman (1935), doi:10.1002/andp.19354160705; Kirkpatrick (1973), doi:10.1103/RevModPhys.45.574 with
    /// four neighbours.
    pub fn bruggeman(&self) -> f64 {
        let highest = self.open().fold(0.0, f64::max);
        let conductivities: Vec<f64> = self.open().map(|g| (g / highest).powi(3)).collect();
        let closed = (self.heights.len() - conductivities.len()) as f64;
        if 2.0 * closed >= self.heights.len() as f64 {
            return 0.0;
        }
        let balance =
            |k: f64| conductivities.iter().map(|c| (c - k) / (c + k)).sum::<f64>() - closed;
        // The sum falls with K. Bisection of ln K, to the last bits.
        let lowest = conductivities.iter().copied().fold(1.0, f64::min);
        let (mut low, mut high) = (lowest.ln() - 40.0, 0.0);
        while high - low > 1e-14 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if balance(middle.exp()) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        (0.5 * (low + high)).exp() * highest.powi(3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four gaps, 1000 points, against the root found at 45 digits with mpmath.
    #[test]
    fn bruggeman_is_the_root_of_its_sum() {
        let mixture: [(f64, usize); 4] = [(0.3, 308), (0.571, 249), (6.8e-6, 263), (0.045, 180)];
        let gaps: Vec<f64> = mixture.iter().flat_map(|&(k, n)| vec![k.cbrt(); n]).collect();
        let grid = Grid::new([1, 1000], [1.0, 1.0]).unwrap();
        let found = Gap::new(grid, &gaps).bruggeman();
        assert!((found / 0.0990423016956590790 - 1.0).abs() < 1e-12, "{found}");
    }

    /// Two phases in equal parts: √(κ1 κ2), exactly (Dykhne 1971). From one half of contact on nothing flows.
    #[test]
    fn limits_of_bruggeman() {
        let grid = Grid::new([1, 4], [1.0, 1.0]).unwrap();
        let of = |gaps: [f64; 4]| Gap::new(grid, &gaps).bruggeman();
        assert!((of([1e-6, 1e-6, 3e-6, 3e-6]) / (3e-12_f64).powf(1.5) - 1.0).abs() < 1e-12);
        assert!((of([2e-6; 4]) / 8e-18 - 1.0).abs() < 1e-12);
        assert!(of([0.0, 0.0, 1e-6, 2e-6]) <= 0.0 && of([0.0; 4]) <= 0.0);
        // One quarter in contact: K = κ/2, as 3 (κ − K) = κ + K.
        assert!((of([0.0, 1e-6, 1e-6, 1e-6]) / 0.5e-18 - 1.0).abs() < 1e-12);
    }
}
