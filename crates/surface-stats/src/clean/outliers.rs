//! Spikes: single points far from their neighbours.

use crate::{StatsError, height_step};
use contact_types::Grid;

/// When a point is a spike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlierRule {
    /// Half width of the square window of neighbours, in pixels; 2 sees spikes up to 3 x 3.
    pub reach: usize,
    /// How many robust standard deviations a point must be off.
    pub threshold: f64,
}

impl Default for OutlierRule {
    /// A 5 x 5 window and eight standard deviations: on Gaussian relief, one point in 10¹⁵.
    fn default() -> Self {
        Self { reach: 2, threshold: 8.0 }
    }
}

/// What was found; nothing has been changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Outliers {
    /// Indices of the spikes, rising.
    pub indices: Vec<usize>,
    /// Distance from the local median beyond which a point is a spike (m).
    pub limit: f64,
    /// Largest distance found among the spikes (m); 0 without one.
    pub largest: f64,
}

impl Outliers {
    /// Makes the spikes missing points (NaN), to be filled like others.
    ///
    /// # Panics
    /// If `heights` are fewer than those searched.
    pub fn remove_from(&self, heights: &mut [f64]) {
        for &index in &self.indices {
            heights[index] = f64::NAN;
        }
    }
}

/// Finds points of `heights` (m, NaN = missing) whose distance from the median of their valid
/// neighbours exceeds `threshold` times 1.4826 times the median of all such distances (the
/// standard deviation, if they were Gaussian), and a whole height step at least.
///
/// The median does not see the spike it judges, so that one spike hides no other unless they fill
/// half the window. The rule is local: a steep edge of a step is not a spike.
///
/// # Errors
/// [`StatsError::Shape`]; [`StatsError::BadSetting`] for a reach of 0 or above 20 or a threshold
/// that is not positive.
pub fn find_outliers(
    grid: Grid,
    heights: &[f64],
    rule: OutlierRule,
) -> Result<Outliers, StatsError> {
    if heights.len() != grid.len() {
        let (expected, found) = (grid.len(), heights.len());
        return Err(StatsError::Shape { what: "heights", expected, found });
    }
    if !(1..=20).contains(&rule.reach) {
        return Err(StatsError::BadSetting {
            setting: "reach of the outlier window",
            value: rule.reach as f64,
            requirement: "must be 1 to 20 pixels",
        });
    }
    if !(rule.threshold.is_finite() && rule.threshold > 0.0) {
        return Err(StatsError::BadSetting {
            setting: "outlier threshold",
            value: rule.threshold,
            requirement: "must be finite and greater than 0",
        });
    }
    let mut distances = distances(grid, heights, rule.reach);
    let mut sorted: Vec<f64> = distances.iter().copied().filter(|d| !d.is_nan()).collect();
    let spread = 1.4826 * median(&mut sorted).unwrap_or(0.0);
    drop(sorted);
    let limit = (rule.threshold * spread).max(height_step(heights).unwrap_or(0.0));
    // Rounding of the heights is no spike either, where the relief is flat.
    let magnitude = heights.iter().filter(|h| !h.is_nan()).fold(0.0f64, |m, h| m.max(h.abs()));
    let limit = limit.max(16.0 * f64::EPSILON * magnitude);
    let indices: Vec<usize> = (0..distances.len()).filter(|&i| distances[i] > limit).collect();
    let largest = indices.iter().map(|&i| distances[i]).fold(0.0, f64::max);
    distances.clear();
    Ok(Outliers { indices, limit, largest })
}

/// Distance of every valid point from the median of its neighbours; NaN where there are none.
fn distances(grid: Grid, heights: &[f64], reach: usize) -> Vec<f64> {
    let [ny, nx] = grid.shape();
    let mut window = Vec::with_capacity((2 * reach + 1).pow(2));
    let mut distances = vec![f64::NAN; heights.len()];
    for iy in 0..ny {
        let rows = iy.saturating_sub(reach)..(iy + reach + 1).min(ny);
        for ix in 0..nx {
            let here = heights[iy * nx + ix];
            if here.is_nan() {
                continue;
            }
            let columns = ix.saturating_sub(reach)..(ix + reach + 1).min(nx);
            window.clear();
            for y in rows.clone() {
                let row = &heights[y * nx..(y + 1) * nx];
                for x in columns.clone() {
                    if (y, x) != (iy, ix) && !row[x].is_nan() {
                        window.push(row[x]);
                    }
                }
            }
            if let Some(middle) = median(&mut window) {
                distances[iy * nx + ix] = (here - middle).abs();
            }
        }
    }
    distances
}

/// The middle value (the upper of two); the order is lost.
fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis::{Scale, SelfAffine};

    fn rough(quantise: Option<f64>) -> (Grid, Vec<f64>) {
        let grid = Grid::new([90, 120], [1e-6, 1e-6]).unwrap();
        let recipe = SelfAffine {
            grid,
            hurst: 0.7,
            rolloff: 30e-6,
            cutoff: 5e-6,
            scale: Scale::RmsHeight(1e-7),
            seed: 4,
            quantise,
        };
        (grid, recipe.generate().unwrap().into_heights())
    }

    /// Planted spikes, one of them a pair, one beside missing points, are found and nothing else.
    #[test]
    fn finds_what_was_planted_and_nothing_else() {
        for quantise in [None, Some(1e-8)] {
            let (grid, mut heights) = rough(quantise);
            let clean = find_outliers(grid, &heights, OutlierRule::default()).unwrap();
            assert!(clean.indices.is_empty());
            heights[3000..3003].fill(f64::NAN);
            for index in [0, 777, 778, 3003, 10_799] {
                heights[index] += 2e-6;
            }
            heights[5000] -= 1e-6;
            let found = find_outliers(grid, &heights, OutlierRule::default()).unwrap();
            assert_eq!(found.indices, [0, 777, 778, 3003, 5000, 10_799]);
            found.remove_from(&mut heights);
            assert_eq!(heights.iter().filter(|h| h.is_nan()).count(), 9);
        }
    }

    #[test]
    fn a_step_edge_and_a_flat_map_have_no_spikes() {
        let grid = Grid::new([20, 20], [1.0, 1.0]).unwrap();
        let edge: Vec<f64> = (0..400).map(|i| if i % 20 < 9 { 0.0 } else { 1.0 }).collect();
        for heights in [edge, vec![76e-3; 400], vec![f64::NAN; 400]] {
            let found = find_outliers(grid, &heights, OutlierRule::default()).unwrap();
            assert!(found.indices.is_empty());
        }
    }

    #[test]
    fn a_spike_on_a_flat_map_is_found() {
        let grid = Grid::new([20, 20], [1.0, 1.0]).unwrap();
        let mut heights = vec![76e-3; 400];
        heights[123] += 1e-9;
        let found = find_outliers(grid, &heights, OutlierRule::default()).unwrap();
        assert_eq!(found.indices, [123]);
    }

    #[test]
    fn senseless_rules_are_refused() {
        let grid = Grid::new([2, 2], [1.0, 1.0]).unwrap();
        for (reach, threshold) in [(0, 8.0), (21, 8.0), (2, 0.0), (2, f64::NAN)] {
            let error = find_outliers(grid, &[0.0; 4], OutlierRule { reach, threshold });
            assert!(matches!(error, Err(StatsError::BadSetting { .. })));
        }
    }
}
