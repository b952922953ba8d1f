//! Height distribution.

use contact_types::HeightMap;

/// Parameters of the heights about their mean (ISO 25178-2:2021, 4.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HeightStatistics {
    /// Sq: root mean square height (m).
    pub rms_height: f64,
    /// Sa: mean absolute height (m).
    pub mean_abs_height: f64,
    /// Ssk: mean cube over Sq³ (-); 0 for a Gaussian. `None` for a flat map.
    pub skewness: Option<f64>,
    /// Sku: mean fourth power over Sq⁴ (-); 3 for a Gaussian. `None` for a flat map.
    pub kurtosis: Option<f64>,
    /// Sp: highest peak above the mean (m).
    pub peak_height: f64,
    /// Sv: deepest pit below the mean (m), as a positive number.
    pub pit_depth: f64,
}

impl HeightStatistics {
    /// Of all pixels, each with the same weight.
    pub(crate) fn of(map: &HeightMap) -> Self {
        let mean = map.mean();
        let (low, high) = map.range();
        let (peak_height, pit_depth) = ((high - mean).max(0.0), (mean - low).max(0.0));
        let reach = peak_height.max(pit_depth);
        let unit = if reach > 0.0 { reach } else { 1.0 };
        // In units of the largest deviation, so that fourth powers stay in range; row by row, so
        // that a long sum loses no digits.
        let nx = map.grid().shape()[1];
        let mut sums = [0.0; 5];
        for row in map.heights().chunks_exact(nx) {
            let mut row_sums = [0.0; 5];
            for h in row {
                let z = (h - mean) / unit;
                let square = z * z;
                row_sums[0] += square;
                row_sums[1] += z.abs();
                row_sums[2] += square * z;
                row_sums[3] += square * square;
                row_sums[4] += z;
            }
            for (sum, row_sum) in sums.iter_mut().zip(row_sums) {
                *sum += row_sum;
            }
        }
        let n = map.heights().len() as f64;
        // The last is what rounding left of the mean.
        let [square, abs, cube, fourth, residue] = sums.map(|s| s / n);
        let variance = (square - residue * residue).max(0.0);
        let rms = variance.sqrt();
        Self {
            rms_height: rms * reach,
            mean_abs_height: abs * reach,
            skewness: (rms > 0.0).then(|| cube / (variance * rms)),
            kurtosis: (rms > 0.0).then(|| fourth / (variance * variance)),
            peak_height,
            pit_depth,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use contact_types::Grid;

    /// 0, 0, 0, 4: mean 1, variance 3, mean absolute deviation 3/2, third moment 6, fourth 21.
    #[test]
    fn four_points_by_hand_at_any_scale_and_offset() {
        for (scale, offset) in [(1.0, 0.0), (1e-55, 0.0), (1e55, 0.0), (1.0, 1048576.0)] {
            let heights = [0.0, 0.0, 0.0, 4.0].map(|h| offset + scale * h).to_vec();
            let map = HeightMap::new(Grid::new([1, 4], [1.0, 1.0]).unwrap(), heights).unwrap();
            let s = HeightStatistics::of(&map);
            close(s.rms_height, scale * 3f64.sqrt(), 1e-15);
            close(s.mean_abs_height, scale * 1.5, 1e-15);
            let skewness = 6.0 / 3f64.powf(1.5);
            close(s.skewness.unwrap(), skewness, 1e-15);
            close(s.kurtosis.unwrap(), 21.0 / 9.0, 1e-15);
            close(s.peak_height + s.pit_depth, 4.0 * scale, 1e-15);
        }
    }
}
