//! Spikes: single points far from their neighbours.

use crate::{StatsError, height_step, scale};
use contact_types::Grid;
use grid_fft::parallel;
use std::ops::Range;

/// Half width of the square window of neighbours (pixels): it sees spikes up to 3 x 3.
const REACH: usize = 2;

/// What was found; nothing has been changed.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Outliers {
    /// Indices of the spikes, rising.
    pub indices: Vec<usize>,
    /// Distance from the local median beyond which a point is a spike (m).
    pub limit: f64,
    /// Largest distance found among the spikes (m); 0 without one.
    pub largest: f64,
}

/// Points whose distances give the standard deviation, with a standard error of 1 to 2 %.
const SAMPLE: usize = 8_000;

/// Parts of a Gaussian's distances and how many standard deviations they stay within. Where half of a map is flat, the
/// median says nothing of the rest.
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
/// standard deviation is 1.4826 times the median of this distance; where that is zero, what nine in ten stay
/// within over 1.645. On Gaussian relief one point in 10¹⁵ is off by more than eight.
///
/// # Errors
/// [`StatsError::Shape`]; [`StatsError::Surface`] for infinite heights; [`StatsError::OutOfRange`];
/// [`StatsError::BadSetting`] for a threshold that is not positive.
pub fn find_outliers(grid: Grid, heights: &[f64], threshold: f64) -> Result<Outliers, StatsError> {
    let (low, high) = scale::check_measured(grid, heights)?;
    let positive = threshold.is_finite() && threshold > 0.0;
    let requirement = "must be finite and greater than 0";
    StatsError::require("outlier threshold", threshold, positive, requirement)?;
    let [ny, nx] = grid.shape();
    let blocks: Vec<_> = (0..ny).step_by(BLOCK).map(|y| y..ny.min(y + BLOCK)).collect();
    let window = |rows: &Range<usize>| Neighbourhood::new(grid, heights, rows.clone());
    // An odd stride, so that the sample does not run down a few columns.
    let stride = (heights.len() / SAMPLE) | 1;
    let sample = |distance: fn(&Neighbourhood, usize, &mut Vec<f64>) -> Option<f64>| {
        let of_block = |rows: &Range<usize>| -> Vec<f64> {
            let (window, mut scratch) = (window(rows), Vec::new());
            let first = (rows.start * nx).next_multiple_of(stride);
            let points = (first..rows.end * nx).step_by(stride);
            points.filter_map(|i| distance(&window, i, &mut scratch)).collect()
        };
        spread(&mut parallel::map(&blocks, of_block).concat())
    };
    let mut deviation = sample(Neighbourhood::distance);
    // Neither a height step nor rounding is a spike, where the relief is flat.
    let rounding = 16.0 * f64::EPSILON * low.abs().max(high.abs());
    if deviation <= rounding {
        // On ridges all but the crests are their neighbours' median.
        deviation = sample(Neighbourhood::distance_from_pairs);
    }
    let limit = (threshold * deviation).max(height_step(heights).unwrap_or(0.0)).max(rounding);
    let found = parallel::map(&blocks, |rows| -> Vec<_> {
        let (window, mut scratch) = (window(rows), Vec::new());
        let (mut is_within, mut found) = (vec![false; nx], Vec::new());
        for first in rows.clone().map(|y| y * nx) {
            window.find_within(first, limit, &mut is_within);
            for index in (0..nx).filter(|ix| !is_within[*ix]).map(|ix| first + ix) {
                let distance = window.distance(index, &mut scratch);
                found.extend(distance.filter(|d| *d > limit).map(|d| (index, d)));
            }
        }
        found
    });
    let (indices, distances): (Vec<_>, Vec<_>) = found.into_iter().flatten().unzip();
    Ok(Outliers { indices, limit, largest: distances.into_iter().fold(0.0, f64::max) })
}

/// Rows looked at together.
const BLOCK: usize = 64;

struct Neighbourhood {
    /// The rows and a rim as wide as two neighbours in line are away; beyond the map missing points.
    heights: Vec<f64>,
    /// First of the rows.
    first: usize,
    /// Columns of the map.
    nx: usize,
    /// How far on in `heights` one of every two opposite neighbours is, the nearest first.
    half: Vec<isize>,
}

impl Neighbourhood {
    const RIM: usize = 2 * REACH;

    fn new(grid: Grid, heights: &[f64], rows: Range<usize>) -> Self {
        let (nx, first) = (grid.shape()[1], rows.start);
        let width = nx + 2 * Self::RIM;
        let mut padded = vec![f64::NAN; (rows.len() + 2 * Self::RIM) * width];
        let above = first.saturating_sub(Self::RIM);
        let rim = padded.chunks_exact_mut(width).skip(Self::RIM + above - first);
        for (row, own) in rim.zip(heights.chunks_exact(nx).skip(above)) {
            row[Self::RIM..Self::RIM + nx].copy_from_slice(own);
        }
        let (reach, width) = (REACH.cast_signed(), width.cast_signed());
        let offsets = (0..=reach).flat_map(|y| (-reach..=reach).map(move |x| [y, x]));
        let mut half: Vec<_> = offsets.filter(|&[y, x]| y > 0 || x > 0).collect();
        half.sort_by_key(|[y, x]| y * y + x * x);
        let half = half.into_iter().map(|[y, x]| y * width + x).collect();
        Self { heights: padded, first, nx, half }
    }

    /// Heights from `step` after a point of the map on; NaN where missing or outside.
    fn from<'a>(&'a self, index: usize) -> impl Fn(isize) -> &'a [f64] {
        let (row, column) = (index / self.nx - self.first, index % self.nx + Self::RIM);
        let index = (row + Self::RIM) * (self.nx + 2 * Self::RIM) + column;
        move |step| &self.heights[index.wrapping_add_signed(step)..]
    }

    /// How far a valid point is from the means of opposite neighbours; `None` for a missing or lonely one.
    fn distance_from_pairs(&self, index: usize, values: &mut Vec<f64>) -> Option<f64> {
        values.clear();
        let from = self.from(index);
        let at = |step: isize| from(step)[0];
        let here = at(0);
        let pairs = self.half.iter().map(|&k| (here - f64::midpoint(at(k), at(-k))).abs());
        values.extend(pairs.filter(|d| !d.is_nan()));
        if values.len() < 3 {
            let lines = self.around().map(|k| (here - (2.0 * at(k) - at(2 * k))).abs());
            values.extend(lines.filter(|d| !d.is_nan()));
        }
        let lower = values.len().saturating_sub(1) / 2;
        select(values, lower)
    }

    fn around(&self) -> impl Iterator<Item = isize> {
        self.half.iter().flat_map(|&k| [k, -k])
    }

    /// How far a valid point is off; `None` for a missing or lonely one.
    fn distance(&self, index: usize, values: &mut Vec<f64>) -> Option<f64> {
        let from_pairs = self.distance_from_pairs(index, values).unwrap_or(f64::INFINITY);
        let from = self.from(index);
        let here = from(0)[0];
        values.clear();
        values.extend(self.around().map(|k| from(k)[0]).filter(|h| !h.is_nan()));
        let middle = values.len() / 2;
        let far = |side: f64| values.iter().filter(|h| side * (here - **h) >= from_pairs).count();
        // Where the median is among those that are farther off, it need not be found.
        let is_nearer = far(1.0) <= middle && far(-1.0) + middle < values.len();
        let median = is_nearer.then(|| select(values, middle)).flatten();
        let distance = median.map_or(from_pairs, |m| (here - m).abs().min(from_pairs));
        (!here.is_nan() && !values.is_empty()).then_some(distance)
    }

    /// Marks points of the row from `first` on whose nearest pairs of neighbours, as many as decide the lower median over
    /// all, agree with it to `limit`: they are no farther off.
    fn find_within(&self, first: usize, limit: f64, is_within: &mut [bool]) {
        let from = self.from(first);
        is_within.fill(true);
        for &k in &self.half[..self.half.len().div_ceil(2)] {
            let pairs = from(k).iter().zip(from(-k)).zip(from(0));
            for (is_within, ((a, b), here)) in is_within.iter_mut().zip(pairs) {
                *is_within &= (here - 0.5 * (a + b)).abs() <= limit;
            }
        }
    }
}

/// The value of this rank; the order is lost.
pub(super) fn select(values: &mut [f64], rank: usize) -> Option<f64> {
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(rank, f64::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::synthesis;

    fn rough(quantise: Option<f64>) -> (Grid, Vec<f64>) {
        let grid = Grid::new([90, 120], [1e-6, 1e-6]).unwrap();
        let mut heights = synthesis::rough(grid, 0.7, [30e-6, 5e-6], 1e-7, 4).into_heights();
        if let Some(step) = quantise {
            for h in &mut heights {
                *h = (*h / step).round() * step;
            }
        }
        (grid, heights)
    }

    fn spikes(grid: Grid, heights: &[f64]) -> Vec<usize> {
        find_outliers(grid, heights, 8.0).unwrap().indices
    }

    /// A pair, beside missing points, up to the corners, on a slope of a hundred times the relief.
    #[test]
    fn finds_what_was_planted_and_nothing_else() {
        for (quantise, slope) in [(None, 0.0), (Some(1e-8), 0.0), (None, 1e-7)] {
            let (grid, mut heights) = rough(quantise);
            for (i, h) in heights.iter_mut().enumerate() {
                *h += slope * (3.0 * (i % 120) as f64 - 5.0 * (i / 120) as f64);
            }
            assert_eq!(spikes(grid, &heights), [0; 0]);
            heights[3000..3003].fill(f64::NAN);
            let planted = [0, 119, 777, 778, 3003, 5000, 10_799];
            for index in planted {
                heights[index] += if index == 5000 { -2e-6 } else { 4e-6 };
            }
            assert_eq!(spikes(grid, &heights), planted, "{quantise:?} {slope:e}");
        }
    }

    /// From the median of the neighbours or the lower median of what opposite ones say.
    #[test]
    fn a_distance_is_the_smaller_of_both() {
        let (grid, heights) = rough(None);
        let nx = grid.shape()[1];
        let rank = |mut values: Vec<f64>, rank: usize| select(&mut values, rank).unwrap();
        let window = Neighbourhood::new(grid, &heights, 0..90);
        for index in (2..88).flat_map(|iy| (2..118).map(move |ix| iy * nx + ix)) {
            let around: Vec<f64> =
                (0..25).map(|k| heights[index + k / 5 * nx + k % 5 - 2 * nx - 2]).collect();
            let off = |k: usize| (around[12] - f64::midpoint(around[k], around[24 - k])).abs();
            let median = rank([&around[..12], &around[13..]].concat(), 12);
            let expected = (around[12] - median).abs().min(rank((0..12).map(off).collect(), 5));
            assert_eq!(window.distance(index, &mut Vec::new()), Some(expected));
        }
    }

    #[test]
    fn a_step_edge_and_a_flat_map_have_no_spikes_but_those_put_there() {
        let grid = Grid::new([20, 20], [1.0, 1.0]).unwrap();
        let edge: Vec<f64> = (0..400).map(|i| if i % 20 < 9 { 0.0 } else { 1.0 }).collect();
        let mut flat = vec![76e-3; 400];
        let ridges: Vec<f64> = (0..400).map(|i| f64::from(i % 20).cos()).collect();
        for heights in [&edge, &flat, &vec![f64::NAN; 400], &ridges] {
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
    fn senseless_thresholds_are_refused() {
        let grid = Grid::new([2, 2], [1.0, 1.0]).unwrap();
        for threshold in [0.0, f64::NAN] {
            let error = find_outliers(grid, &[0.0; 4], threshold);
            assert!(matches!(error, Err(StatsError::BadSetting { .. })));
        }
    }
}
