//! Spikes: single points far from their neighbours.

use crate::{StatsError, height_step, scale};
use contact_types::Grid;

/// When a point is a spike.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct OutlierRule {
    /// Half width of the square window of neighbours, in pixels; 2 sees spikes up to 3 x 3.
    pub reach: usize,
    /// How many robust standard deviations a point must be off.
    pub threshold: f64,
}

impl OutlierRule {
    /// Points more than `threshold` robust standard deviations off, the rest as by default.
    pub fn beyond(threshold: f64) -> Self {
        Self { threshold, ..Self::default() }
    }
}

impl Default for OutlierRule {
    /// A 5 x 5 window and eight standard deviations: on Gaussian relief, one point in 10¹⁵.
    fn default() -> Self {
        Self { reach: 2, threshold: 8.0 }
    }
}

/// What was found; nothing has been changed.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
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
    pub(crate) fn remove_from(&self, heights: &mut [f64]) {
        for &index in &self.indices {
            heights[index] = f64::NAN;
        }
    }
}

/// Points whose distances give the standard deviation, with a standard error of 1 to 2 %.
const SAMPLE: usize = 8_000;

/// Parts of a Gaussian's distances and how many standard deviations they stay within. Where half of a map is flat, as worn
/// tops are or heights in coarse steps, the median says nothing of the rest.
const WITHIN: [(f64, f64); 2] = [(0.5, 1.0 / 1.4826), (0.9, 1.644_853_6)];

/// Robust standard deviation of these distances: by the first of the parts that is not all zero.
fn spread(distances: &mut [f64]) -> f64 {
    WITHIN
        .into_iter()
        .filter_map(|(part, deviations)| {
            let rank = (part * distances.len() as f64) as usize;
            Some(select(distances, rank.min(distances.len().checked_sub(1)?))? / deviations)
        })
        .find(|&spread| spread > 0.0)
        .unwrap_or(0.0)
}

/// Finds points of `heights` (m, NaN = missing) that are off by more than `threshold` robust
/// standard deviations and a whole height step at least.
///
/// How far a point is off is the smaller of two distances: from the median of its valid
/// neighbours, which is small beside a step, and from the means of opposite neighbours (the lower
/// median over all pairs, and lines through two points at the rim), which is small on a slope. The
/// standard deviation is 1.4826 times the median of this distance over the map, which neither
/// spikes nor steps can raise; where that is zero, what nine in ten stay within over 1.645.
///
/// # Errors
/// [`StatsError::Shape`]; [`StatsError::Surface`] for infinite heights; [`StatsError::OutOfRange`];
/// [`StatsError::BadSetting`] for a reach of 0 or above 20 or a threshold
/// that is not positive.
pub fn find_outliers(
    grid: Grid,
    heights: &[f64],
    rule: OutlierRule,
) -> Result<Outliers, StatsError> {
    scale::check_measured(grid, heights)?;
    let OutlierRule { reach, threshold } = rule;
    let setting = "reach of the outlier window";
    let within = (1..=20).contains(&reach);
    StatsError::require(setting, reach as f64, within, "must be 1 to 20 pixels")?;
    let positive = threshold.is_finite() && threshold > 0.0;
    let requirement = "must be finite and greater than 0";
    StatsError::require("outlier threshold", threshold, positive, requirement)?;
    let mut window = Neighbourhood::new(grid, heights, reach);
    // An odd stride, so that the sample does not run down a few columns.
    let stride = (heights.len() / SAMPLE) | 1;
    let mut sample: Vec<f64> =
        (0..heights.len()).step_by(stride).filter_map(|i| window.distance(i)).collect();
    let spread = spread(&mut sample);
    // Neither a height step nor rounding is a spike, where the relief is flat.
    let magnitude = heights.iter().filter(|h| !h.is_nan()).fold(0.0f64, |m, h| m.max(h.abs()));
    let limit = (threshold * spread)
        .max(height_step(heights).unwrap_or(0.0))
        .max(16.0 * f64::EPSILON * magnitude);
    let (mut indices, mut largest) = (Vec::new(), 0.0f64);
    for index in 0..heights.len() {
        if let Some(distance) = window.distance_beyond(index, limit) {
            indices.push(index);
            largest = largest.max(distance);
        }
    }
    Ok(Outliers { indices, limit, largest })
}

/// The neighbours of a point.
struct Neighbourhood<'a> {
    heights: &'a [f64],
    shape: [isize; 2],
    reach: isize,
    /// One of every two opposite offsets, `[y, x]`, and how far on in the list of heights it leads.
    half: Vec<([isize; 2], isize)>,
    values: Vec<f64>,
}

impl<'a> Neighbourhood<'a> {
    fn new(grid: Grid, heights: &'a [f64], reach: usize) -> Self {
        let reach = reach.cast_signed();
        let offsets = (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| [y, x]));
        let shape = grid.shape().map(usize::cast_signed);
        let half = offsets.filter(|&[y, x]| y > 0 || (y == 0 && x > 0));
        let half = half.map(|[y, x]| ([y, x], y * shape[1] + x)).collect();
        Self { heights, shape, reach, half, values: Vec::new() }
    }

    /// Whether the whole window of a point lies on the map.
    fn is_whole(&self, [iy, ix]: [isize; 2]) -> bool {
        let within = |i: isize, n: isize| i >= self.reach && i + self.reach < n;
        within(iy, self.shape[0]) && within(ix, self.shape[1])
    }

    /// Heights to both sides of a point, whose window `is_whole` or not; `None` where missing or outside.
    fn sides(
        &self,
        index: usize,
        is_whole: bool,
        &(offset, step): &([isize; 2], isize),
    ) -> [Option<f64>; 2] {
        if is_whole {
            let height = |step| Some(self.heights[index.wrapping_add_signed(step)]);
            [step, -step].map(|step| height(step).filter(|h| !h.is_nan()))
        } else {
            [1, -1].map(|side| self.neighbour(self.position(index), offset, side))
        }
    }

    /// Height at `times` an offset from a point; `None` if missing or outside.
    fn neighbour(&self, [iy, ix]: [isize; 2], [dy, dx]: [isize; 2], times: isize) -> Option<f64> {
        let ([ny, nx], y, x) = (self.shape, iy + times * dy, ix + times * dx);
        let inside = (0..ny).contains(&y) && (0..nx).contains(&x);
        let height = || self.heights[(y * nx + x).cast_unsigned()];
        inside.then(height).filter(|h| !h.is_nan())
    }

    fn position(&self, index: usize) -> [isize; 2] {
        let index = index.cast_signed();
        [index / self.shape[1], index % self.shape[1]]
    }

    /// How far a valid point is off; `None` for a missing or lonely one.
    fn distance(&mut self, index: usize) -> Option<f64> {
        let (here, at) = (self.heights[index], self.position(index));
        if here.is_nan() {
            return None;
        }
        let is_whole = self.is_whole(at);
        let mut values = std::mem::take(&mut self.values);
        values.clear();
        for offset in &self.half {
            if let [Some(a), Some(b)] = self.sides(index, is_whole, offset) {
                values.push((here - f64::midpoint(a, b)).abs());
            }
        }
        if values.len() < 3 {
            for &(offset, _) in &self.half {
                for side in [1, -1] {
                    let line = [1, 2].map(|k| self.neighbour(at, offset, k * side));
                    if let [Some(near), Some(far)] = line {
                        values.push((here - (2.0 * near - far)).abs());
                    }
                }
            }
        }
        let lower = values.len().saturating_sub(1) / 2;
        let from_pairs = select(&mut values, lower).unwrap_or(f64::INFINITY);

        values.clear();
        for offset in &self.half {
            values.extend(self.sides(index, is_whole, offset).into_iter().flatten());
        }
        let middle = values.len() / 2;
        let far = |side: f64| values.iter().filter(|h| side * (here - **h) >= from_pairs).count();
        // Where the median is among those that are farther off, it need not be found.
        let is_nearer = far(1.0) <= middle && far(-1.0) + middle < values.len();
        let median = is_nearer.then(|| select(&mut values, middle)).flatten();
        let distance = median.map_or(from_pairs, |m| (here - m).abs().min(from_pairs));
        let found = (!values.is_empty()).then_some(distance);
        self.values = values;
        found
    }

    /// The distance, if it exceeds `limit`. Most points are done without sorting: if more than
    /// half of the neighbours are within the limit, so is their median.
    fn distance_beyond(&mut self, index: usize, limit: f64) -> Option<f64> {
        let (here, is_whole) = (self.heights[index], self.is_whole(self.position(index)));
        let mut near = 0;
        for offset in &self.half {
            for h in self.sides(index, is_whole, offset).into_iter().flatten() {
                near += usize::from((here - h).abs() <= limit);
            }
            // Already more than half of all that there may be.
            if near > self.half.len() {
                return None;
            }
        }
        self.distance(index).filter(|&d| d > limit)
    }
}

/// The value of this rank; the order is lost.
fn select(values: &mut [f64], rank: usize) -> Option<f64> {
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(rank, f64::total_cmp).1)
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

    fn spikes(grid: Grid, heights: &[f64]) -> Vec<usize> {
        find_outliers(grid, heights, OutlierRule::default()).unwrap().indices
    }

    /// Planted spikes, one of them a pair, one beside missing points, are found and nothing else.
    #[test]
    fn finds_what_was_planted_and_nothing_else() {
        for quantise in [None, Some(1e-8)] {
            let (grid, mut heights) = rough(quantise);
            assert!(spikes(grid, &heights).is_empty());
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

    /// From the median of the neighbours or the lower median of what opposite ones say.
    #[test]
    fn a_distance_is_the_smaller_of_both() {
        let (grid, heights) = rough(None);
        let nx = grid.shape()[1];
        let rank = |mut values: Vec<f64>, rank: usize| {
            *values.select_nth_unstable_by(rank, f64::total_cmp).1
        };
        let mut window = Neighbourhood::new(grid, &heights, 2);
        for index in (2..88).flat_map(|iy| (2..118).map(move |ix| iy * nx + ix)) {
            let around: Vec<f64> =
                (0..25).map(|k| heights[index + k / 5 * nx + k % 5 - 2 * nx - 2]).collect();
            let off = |k: usize| (around[12] - f64::midpoint(around[k], around[24 - k])).abs();
            let median = rank([&around[..12], &around[13..]].concat(), 12);
            let expected = (around[12] - median).abs().min(rank((0..12).map(off).collect(), 5));
            assert_eq!(window.distance(index), Some(expected));
        }
    }

    /// A slope of a hundred times the relief, up to the corners.
    #[test]
    fn a_steep_slope_has_no_spikes_and_hides_none() {
        let (grid, mut heights) = rough(None);
        for (i, h) in heights.iter_mut().enumerate() {
            *h += 3e-7 * (i % 120) as f64 - 5e-7 * (i / 120) as f64;
        }
        assert_eq!(spikes(grid, &heights), [0; 0]);
        heights[6060] += 2e-6;
        heights[119] -= 4e-6;
        assert_eq!(spikes(grid, &heights), [119, 6060]);
    }

    #[test]
    fn a_step_edge_and_a_flat_map_have_no_spikes_but_those_put_there() {
        let grid = Grid::new([20, 20], [1.0, 1.0]).unwrap();
        let edge: Vec<f64> = (0..400).map(|i| if i % 20 < 9 { 0.0 } else { 1.0 }).collect();
        let mut flat = vec![76e-3; 400];
        for heights in [&edge, &flat, &vec![f64::NAN; 400]] {
            assert_eq!(spikes(grid, heights), [0; 0]);
        }
        flat[123] += 1e-9;
        assert_eq!(spikes(grid, &flat), [123]);
    }

    /// Worn flat over 60 and 80 % of the map: hardly a point of its valleys is a spike, and spikes in both are found.
    #[test]
    fn worn_tops_make_no_spikes_of_their_valleys() {
        let (grid, rough) = rough(None);
        let mut sorted = rough.clone();
        sorted.sort_by(f64::total_cmp);
        for worn in [0.6, 0.8] {
            let top = sorted[((1.0 - worn) * sorted.len() as f64) as usize];
            let mut heights: Vec<f64> = rough.iter().map(|&h| h.min(top)).collect();
            let clean = spikes(grid, &heights);
            // By the median alone, all that is not worn.
            assert!(clean.len() <= heights.len() / 250, "{worn}: {}", clean.len());
            let flat = heights.iter().position(|&h| h >= top).unwrap();
            let valley = heights.iter().position(|&h| h < top).unwrap();
            for index in [flat, valley] {
                heights[index] += 2e-6;
            }
            let mut expected = [clean, vec![flat, valley]].concat();
            expected.sort_unstable();
            assert_eq!(spikes(grid, &heights), expected);
        }
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
