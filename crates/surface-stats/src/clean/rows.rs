//! Scan lines: rows of a probe microscope that stand at heights of their own.

use super::outliers::select;
use crate::polynomial::Polynomial;
use crate::{StatsError, Warning, scale};
use contact_types::Grid;

/// Share of the differences from which rows are said to jump.
const LEAST_SHARE: f64 = 0.25;

/// How many times the share of the columns that must be.
const LEAST_RATIO: f64 = 4.0;

/// Mean square change of the jump from row to row over the mean square jump, below which the offsets are waves that the
/// rows resolve: 1 is a wave of six rows, 2 independent jumps, 3 independent rows.
const LEAST_ROUGHNESS: f64 = 1.0;

/// Rows that must jump at least, up and down, or the part of all: fewer are edges of the surface, steps or terraces.
const LEAST_JUMPING: [f64; 2] = [6.0, 0.125];

/// Rows and columns below which medians say nothing.
const FEWEST: usize = 32;

/// How rows of a map of `heights` (m, row-major, NaN = missing) stand against each other, by the median of the differences
/// of neighbouring rows. A probe that loses or catches something between two rows, or drifts, makes that median jump from
/// row to row; a surface makes it small (its slopes cancel along a row) or smooth (a lay along the rows, sampled by several
/// of them).
///
/// - the jumps from row to row (m): these medians less their own, that of a tilt;
/// - their rms (m);
/// - that the rows jump: their jumps make a good part of the slope across them, far more than those of columns, and are
///   neither waves nor a few edges. A lay along the rows that is as fine as the rows looks the same.
///
/// # Errors
/// [`StatsError::Shape`]; [`StatsError::Surface`] for infinite heights; [`StatsError::OutOfRange`].
pub fn row_jumps(
    grid: Grid,
    heights: &[f64],
) -> Result<(Vec<f64>, f64, Option<Warning>), StatsError> {
    scale::check_measured(grid, heights)?;
    let [ny, nx] = grid.shape();
    let (jumps_of_rows, share) = jumps(ny, nx, |line, i| heights[line * nx + i]);
    let change: f64 = jumps_of_rows.windows(2).map(|j| (j[1] - j[0]).powi(2)).sum();
    let square: f64 = jumps_of_rows.iter().map(|j| j * j).sum();
    let rows_jump = ny >= FEWEST
        && share >= LEAST_SHARE
        && change >= LEAST_ROUGHNESS * square
        && are_many(&jumps_of_rows)
        && share >= LEAST_RATIO * jumps(nx, ny, |line, i| heights[i * nx + line]).1;
    let jump = (square / jumps_of_rows.len().max(1) as f64).sqrt();
    let warning = rows_jump.then_some(Warning::RowsJump { jump, share });
    Ok((jumps_of_rows, jump, warning))
}

/// Whether many jumps make up the sum of their squares, (Σ jump²)² / Σ jump⁴; more, if all go one way as of a staircase.
fn are_many(jumps: &[f64]) -> bool {
    let largest = jumps.iter().fold(0.0, |a: f64, j| a.max(j.abs()));
    let sum = |term: fn(f64) -> f64| jumps.iter().map(|j| term(j / largest)).sum::<f64>();
    let one_way = sum(|j| j) / sum(f64::abs);
    let (count, [both_ways, part]) = (sum(|j| j * j).powi(2) / sum(|j| j.powi(4)), LEAST_JUMPING);
    count * (1.0 - one_way * one_way) >= both_ways || count >= part * jumps.len() as f64
}

/// Height of each row (m): the sum of the jumps, less the straight line through them, a tilt, which stays.
pub(super) fn offsets(jumps: &[f64]) -> Result<Vec<f64>, StatsError> {
    let mut offsets = vec![0.0; jumps.len() + 1];
    for (i, jump) in jumps.iter().enumerate() {
        offsets[i + 1] = offsets[i] + jump;
    }
    let grid = Grid::new([1, offsets.len()], [1.0, 1.0])?;
    Polynomial::fit(grid, &offsets, 1)?.remove_from(&mut offsets);
    Ok(offsets)
}

/// Median difference of each of `lines` lines of `points` points to the one before, less the median
/// of these, and the share of the mean square difference that such jumps make.
fn jumps(lines: usize, points: usize, at: impl Fn(usize, usize) -> f64) -> (Vec<f64>, f64) {
    let mut differences = Vec::with_capacity(points);
    let mut medians = Vec::with_capacity(lines);
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    // The lower one of two; of none 0.
    let median =
        |values: &mut [f64]| select(values, values.len().saturating_sub(1) / 2).unwrap_or(0.0);
    for line in 1..lines {
        differences.clear();
        let pairs = (0..points).map(|i| at(line, i) - at(line - 1, i));
        differences.extend(pairs.filter(|d| !d.is_nan()));
        for d in &differences {
            sums[0] += d;
            sums[1] += d * d;
        }
        count += differences.len() as f64;
        // A row without a neighbour stays where it is.
        medians.push(median(&mut differences));
    }
    let tilt = median(&mut medians.clone());
    let jumps: Vec<f64> = medians.iter().map(|m| m - tilt).collect();
    let square = jumps.iter().map(|j| j * j).sum::<f64>() / jumps.len().max(1) as f64;
    // Mean square of all differences about the tilt.
    let all =
        if count > 0.0 { sums[1] / count - tilt * (2.0 * sums[0] / count - tilt) } else { 0.0 };
    let share = if all > 0.0 && points >= FEWEST { (square / all).min(1.0) } else { 0.0 };
    (jumps, share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::clean::{Record, Step, apply};
    use crate::synthesis::rough;
    use approx::assert_abs_diff_eq;

    const SHAPE: [usize; 2] = [128, 160];

    fn relief(seed: u64) -> (Grid, Vec<f64>) {
        let grid = Grid::new(SHAPE, [1e-6, 1e-6]).unwrap();
        (grid, rough(grid, 0.8, [40e-6, 4e-6], 20e-9, seed).into_heights())
    }

    /// Independent numbers between -1 and 1.
    fn noise(i: usize) -> f64 {
        let x = (i as f64 * 12.9898).sin() * 43758.5453;
        2.0 * (x - x.floor()) - 1.0
    }

    /// Beside missing points and a tilt, which stays.
    #[test]
    fn planted_offsets_come_off() {
        let (grid, mut heights) = relief(3);
        assert!(row_jumps(grid, &heights).unwrap().2.is_none());
        let align = |heights: &mut Vec<f64>| {
            let records = apply(grid, heights, &[Step::Rows]).unwrap();
            let Record::Rows { jump, largest } = records[0] else { panic!("{records:?}") };
            [jump, largest]
        };
        align(&mut heights); // what the medians see of the relief itself
        let nx = SHAPE[1];
        let wanted = heights.clone();
        for (iy, row) in heights.chunks_exact_mut(nx).enumerate() {
            for h in row {
                *h += 30e-9 * noise(iy);
            }
        }
        heights[5000..5100].fill(f64::NAN);
        assert!(row_jumps(grid, &heights).unwrap().2.is_some());
        let [jump, largest] = align(&mut heights);
        // The difference of two numbers between -1 and 1 has the variance 2/3.
        assert!((jump / 30e-9 - (2.0f64 / 3.0).sqrt()).abs() < 0.1, "{jump:e}");
        assert!((25e-9..45e-9).contains(&largest), "{largest:e}");
        // What is left differs from the relief by a tilt, which is not ours to take.
        let left: Vec<f64> = (0..SHAPE[0]).map(|iy| heights[iy * nx] - wanted[iy * nx]).collect();
        let steps: Vec<f64> = left.windows(2).map(|l| l[1] - l[0]).collect();
        let bent = offsets(&steps).unwrap();
        for (i, (h, w)) in heights.iter().zip(&wanted).enumerate() {
            if (5000..5100).contains(&i) {
                assert!(h.is_nan());
            } else {
                // The median of the rows with missing points is that of fewer points.
                assert_abs_diff_eq!(bent[i / nx], 0.0, epsilon = 1e-9);
                assert_abs_diff_eq!(*h, w + left[i / nx], epsilon = 1e-15);
            }
        }
        assert!(row_jumps(grid, &heights).unwrap().2.is_none());
    }

    /// A lay that several rows show, along or across them, a tilt, a step edge and terraces are no scan lines.
    #[test]
    fn surfaces_are_no_scan_lines() {
        for seed in 0..5 {
            let (grid, relief) = relief(seed);
            let shapes: [fn(f64, f64) -> f64; 7] = [
                |y, _| 60e-9 * (0.5 * y).sin() + 30e-9 * (0.23 * y).cos(),
                |_, x| 60e-9 * (0.5 * x).sin(),
                |y, x| 4e-9 * y - 2e-9 * x,
                |y, _| if y < 60.0 { 0.0 } else { 2e-6 },
                |y, _| 4e-7 * (y / 30.0).floor(),
                |y, _| 4e-7 * (y / 9.0).floor(),
                |y, x| 1e-6 * (0.02 * (y + x)).sin(),
            ];
            for (k, shape) in shapes.iter().enumerate() {
                let heights: Vec<f64> = relief
                    .iter()
                    .enumerate()
                    .map(|(i, h)| h + shape((i / SHAPE[1]) as f64, (i % SHAPE[1]) as f64))
                    .collect();
                let found = row_jumps(grid, &heights).unwrap();
                assert!(found.2.is_none(), "{seed} {k}: {found:?}");
            }
        }
    }

    #[test]
    fn small_flat_and_missing_maps_do_not_jump() {
        for (shape, height) in
            [([1, 50], 1.0), ([50, 1], 1.0), ([40, 40], 76e-3), ([40, 40], f64::NAN)]
        {
            let grid = Grid::new(shape, [1e-6, 1e-6]).unwrap();
            let (_, jump, warning) = row_jumps(grid, &vec![height; grid.len()]).unwrap();
            assert!(warning.is_none() && jump == 0.0);
        }
    }
}
