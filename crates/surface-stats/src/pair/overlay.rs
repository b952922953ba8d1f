//! Which points of two maps lie on each other.

use crate::StatsError;
use contact_types::Grid;

/// How two maps were laid on each other.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Placed {
    /// How far the second was moved along `[y, x]` (m): the shift asked for in whole points.
    pub shift: [f64; 2],
    /// Whether both repeat, so that what moves out on one side comes in on the other; else the common
    /// part was cut out.
    pub is_rolled: bool,
    /// The grids of both maps as given.
    pub grids: [Grid; 2],
    /// The grid of their common part.
    pub common: Grid,
    /// Which of them were put on the points of the other.
    pub resampled: [bool; 2],
    /// Part of the area of each map that lies on the other \[-\].
    pub shares: [f64; 2],
    /// Larger over smaller distance of points, of the axis where they differ most \[-\].
    pub pixel_ratio: f64,
}

/// The part of two maps that lies on each other along one axis, in points of each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Overlap {
    /// Distance of the points (m): that of the finer map.
    pub(super) pixel: f64,
    /// How far the second was moved (m).
    pub(super) shift: f64,
    /// Where the points are in each map.
    pub(super) along: [AxisPoints; 2],
}

/// Fewest points of its own with which a map is interpolated: those of one cubic.
const FEWEST: f64 = 4.0;

/// Along one axis, centres on each other and the second moved by `shift`, in whole points of the finer.
pub(super) fn common(n: [usize; 2], d: [f64; 2], shift: f64) -> Result<Overlap, StatsError> {
    let pixel = d[0].min(d[1]);
    let whole = (shift / pixel).round();
    let shift = whole * pixel;
    let too_little = |found| Err(StatsError::TooLittle { shift, found });
    // Points that drift apart by less than half of one over the smaller map lie on each other.
    if (d[0] - d[1]).abs() * n[0].min(n[1]) as f64 <= 0.5 * pixel {
        let offset = ((n[0] as f64 - n[1] as f64) / 2.0).floor() + whole;
        let (low, high) = (offset.max(0.0), (offset + n[1] as f64).min(n[0] as f64));
        if high - low < 2.0 {
            return too_little((high - low).max(0.0));
        }
        let at = |first| AxisPoints { first, step: 1.0, count: (high - low) as usize };
        let along = [at(low), at(low - offset)];
        return Ok(Overlap { pixel: d[0], shift, along });
    }
    let (fine, coarse) = if d[0] < d[1] { (0, 1) } else { (1, 0) };
    // The first points, seen from the centre of the first map.
    let centre = |k: usize| -0.5 * (n[k] - 1) as f64 * d[k];
    let start = [centre(0), centre(1) + shift];
    let end = |k: usize| start[k] + (n[k] - 1) as f64 * d[k];
    let (low, high) = (start[0].max(start[1]), end(0).min(end(1)));
    // A point on the end of the other map is inside it, whatever rounding says.
    let first = ((low - start[fine]) / pixel - 1e-6).ceil().max(0.0);
    let last = ((high - start[fine]) / pixel + 1e-6).floor().min((n[fine] - 1) as f64);
    let count = last - first + 1.0;
    if count < 2.0 {
        return too_little(count.max(0.0));
    }
    let step = pixel / d[coarse];
    let own = (count - 1.0) * step + 1.0;
    if own < FEWEST {
        return Err(StatsError::TooCoarse { which: coarse, own, pixels: d });
    }
    let at = ((start[fine] + first * pixel - start[coarse]) / d[coarse]).max(0.0);
    let mut along = [AxisPoints { first, step: 1.0, count: count as usize }; 2];
    along[coarse] = AxisPoints { first: at, step, count: count as usize };
    Ok(Overlap { pixel, shift, along })
}

/// Points along one axis, in units of the points of a map: `first`, `first + step`, … .
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct AxisPoints {
    pub(super) first: f64,
    pub(super) step: f64,
    pub(super) count: usize,
}

/// Heights at points inside a map of at least 4 x 4 points; those at its own points are its own.
pub(super) fn interpolated(
    [ny, nx]: [usize; 2],
    heights: &[f64],
    along: [AxisPoints; 2],
) -> Vec<f64> {
    let (rows, columns) = (stencils(ny, along[0]), stencils(nx, along[1]));
    let mut new = Vec::with_capacity(rows.len() * columns.len());
    for (y, wy) in &rows {
        for (x, wx) in &columns {
            let along = |row: usize| {
                let z = &heights[row * nx + x..row * nx + x + 4];
                (0..4).map(|k| wx[k] * z[k]).sum::<f64>()
            };
            new.push((0..4).map(|k| wy[k] * along(y + k)).sum());
        }
    }
    new
}

/// First of four neighbours and their weights for every new point along one axis. Next to an edge
/// the stencil is shifted inwards and the cubic through its four points is used.
fn stencils(n: usize, AxisPoints { first, step, count }: AxisPoints) -> Vec<(usize, [f64; 4])> {
    let stencil = |i: usize| {
        let position = first + i as f64 * step;
        let cell = (position.floor() as usize).min(n - 2);
        let t = position - cell as f64;
        if cell > 0 && cell + 2 < n {
            return (cell - 1, keys(t));
        }
        let start = if cell == 0 { 0 } else { n - 4 };
        (start, lagrange(position - start as f64))
    };
    (0..count).map(stencil).collect()
}

/// Weights of the points -1, 0, 1, 2 at t in 0..1 (Keys 1981, doi:10.1109/TASSP.1981.1163711).
fn keys(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        -0.5 * t3 + t2 - 0.5 * t,
        1.5 * t3 - 2.5 * t2 + 1.0,
        -1.5 * t3 + 2.0 * t2 + 0.5 * t,
        0.5 * t3 - 0.5 * t2,
    ]
}

/// Weights of the points 0, 1, 2, 3 at t: the cubic through all four.
fn lagrange(t: f64) -> [f64; 4] {
    let (a, b, c) = (t - 1.0, t - 2.0, t - 3.0);
    [-a * b * c / 6.0, t * b * c / 2.0, -t * a * c / 2.0, t * a * b / 6.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quadratics exactly, also at the edges, and the map itself at its own points.
    #[test]
    fn cubic_interpolation_of_a_quadratic() {
        let z =
            |y: f64, x: f64| 1.0 + 0.2 * x - 0.1 * y + 0.05 * x * x - 0.02 * x * y + 0.01 * y * y;
        let heights: Vec<f64> = (0..108).map(|i| z(f64::from(i / 12), f64::from(i % 12))).collect();
        for (step, [ny, nx]) in [(0.25, [33, 45]), (1.0, [9, 12])] {
            let axis = |count| AxisPoints { first: 0.0, step, count };
            let found = interpolated([9, 12], &heights, [axis(ny), axis(nx)]);
            for (i, height) in found.iter().enumerate() {
                let expected = z(step * (i / nx) as f64, step * (i % nx) as f64);
                assert!((height - expected).abs() < 1e-13, "{height} {expected}");
            }
        }
    }

    /// Points and spacings of both, the shift asked for: first points of each, their number, who is interpolated.
    #[test]
    fn what_lies_on_each_other() {
        for (n, d, shift, first, count, between) in [
            // Equal points are taken whole.
            ([8, 8], [1.0, 1.0], 2.4, [2.0, 0.0], 6, None),
            ([8, 8], [1.0, 1.0], -2.6, [0.0, 3.0], 5, None),
            // Centres on each other: two points stand over on each side.
            ([8, 4], [1.0, 1.0], 0.0, [2.0, 0.0], 4, None),
            // A pixel that is off by a thousandth drifts by 0.1 points over 100, by one over 1000.
            ([100, 100], [1.0, 1.001], 0.0, [0.0, 0.0], 100, None),
            // Nine points at −4…4 and seven at −6, −4 … 6: the second's places 1, 1.5 … 5.
            ([9, 7], [1.0, 2.0], 0.0, [0.0, 1.0], 9, Some(1)),
            // Moved to −3…9, and the coarser first.
            ([9, 7], [1.0, 2.0], 3.0, [1.0, 0.0], 8, Some(1)),
            ([7, 9], [2.0, 1.0], -3.0, [0.0, 1.0], 8, Some(0)),
        ] {
            let found = common(n, d, shift).unwrap();
            assert_eq!(found.along.map(|a| a.count), [count; 2]);
            for (axis, first) in found.along.iter().zip(first) {
                assert!((axis.first - first).abs() < 1e-12, "{found:?}");
            }
            assert!((found.shift - shift.round()).abs() < 1e-15, "{found:?}");
            for (which, axis) in found.along.iter().enumerate() {
                let step = if between == Some(which) { 0.5 } else { 1.0 };
                assert!((axis.step - step).abs() < 1e-15, "{found:?}");
            }
        }
        assert!(common([1000; 2], [1.0, 1.001], 0.0).unwrap().along[1].step < 1.0);
    }

    #[test]
    fn too_little_in_common_is_refused() {
        for shift in [7.0, -7.0, 8.0, 1e6] {
            assert!(matches!(common([8, 8], [1.0, 1.0], shift), Err(StatsError::TooLittle { .. })));
        }
        let coarse = common([50, 50], [1.0, 100.0], 0.0);
        assert!(matches!(coarse, Err(StatsError::TooCoarse { which: 1, .. })));
    }
}
