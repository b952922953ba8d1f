//! Coordinates to a grid: lists of x y z and profiles x z.

use crate::cells::Digits;
use crate::error::TEXT;
use crate::measurement::{Channel, Pixel};
use crate::{Limits, ReadError, metres_per};

/// Evenly spaced positions found in a column of coordinates.
#[derive(Clone)]
pub(crate) struct Line {
    /// (last - first) / (N - 1).
    pub(crate) step: f64,
    pub(crate) is_falling: bool,
    /// Largest deviation in steps, if more than the printed digits explain, and distances of the points from the lowest
    /// one in steps, rising.
    pub(crate) uneven: Option<(f64, Vec<f64>)>,
}

impl Line {
    /// Positions of a profile in the order of the file; `digits` is how precisely they are printed.
    pub(crate) fn new(x: &[f64], digits: Digits) -> Result<Self, String> {
        if let Some(i) = x.iter().position(|x| !x.is_finite()) {
            return Err(format!("position {} is {}", i + 1, x[i]));
        }
        let (Some(&first), Some(&last)) = (x.first(), x.last()) else {
            return Err("there are no positions".into());
        };
        if x.len() < 2 {
            return Err("one point is no profile".into());
        }
        let is_falling = last < first;
        let turn = x.windows(2).position(|p| if is_falling { p[1] >= p[0] } else { p[1] <= p[0] });
        if let Some(i) = turn {
            return Err(format!(
                "position {} ({}) does not continue in the direction of the points before ({})",
                i + 2,
                x[i + 1],
                x[i]
            ));
        }
        let step = (last - first) / (x.len() - 1) as f64;
        let deviation = x
            .iter()
            .enumerate()
            .map(|(i, x)| (x - first - i as f64 * step).abs())
            .fold(0.0, f64::max);
        let step = step.abs();
        let is_uneven = deviation > tolerance(step, digits, last.abs().max(first.abs()));
        let uneven = is_uneven.then(|| {
            let mut places: Vec<f64> = x.iter().map(|x| (x - first.min(last)) / step).collect();
            if is_falling {
                places.reverse();
            }
            (deviation / step, places)
        });
        Ok(Self { step, is_falling, uneven })
    }
}

/// The profile of `count` heights, at positions in a unit if it has some.
pub(crate) fn profile<'a>(
    name: impl Into<String>,
    unit: Option<&str>,
    count: usize,
    positions: Option<(Line, Option<&str>)>,
    decode: impl FnOnce() -> Result<Vec<f64>, ReadError> + 'a,
) -> Channel<'a> {
    let Some((line, x_unit)) = positions else {
        return Channel::new(name, unit, [1, count], Pixel::Unknown, decode);
    };
    let pixel = Pixel::scaled([line.step; 2], [x_unit.and_then(metres_per); 2]);
    let channel = Channel::new(name, unit, [1, count], pixel, decode);
    let channel = if line.is_falling { channel.mirrored() } else { channel };
    Channel { uneven: line.uneven, ..channel }
}

/// How far a coordinate may be from its place: one printed digit (half for the point, half for
/// the ends of the line) if a step has clearly more than one, and rounding of f64. Whole numbers
/// 0, 1, 2, 4 are not steps of 4/3 that were rounded.
fn tolerance(step: f64, digits: Digits, largest: f64) -> f64 {
    let quantum = digits.quantum(largest);
    let printed = if quantum <= 0.7 * step { 1.001 * quantum } else { 0.0 };
    printed.max(1e-6 * step).max(8.0 * f64::EPSILON * largest)
}

/// A map gridded from a list.
pub(crate) struct GriddedMap {
    pub(crate) shape: [usize; 2],
    pub(crate) step: [f64; 2],
    /// Of every column behind x and y.
    pub(crate) heights: Vec<Vec<f64>>,
    /// Every point of the grid is in the list.
    pub(crate) is_complete: bool,
}

impl GriddedMap {
    pub(crate) fn is_wide(&self) -> bool {
        self.shape.iter().all(|n| *n > 2)
    }

    /// Three points a side, all there: not by chance.
    pub(crate) fn is_plain(&self) -> bool {
        self.is_wide() && self.is_complete
    }
}

/// Puts a list of x y z and more (row-major) on the grid its coordinates form. Points of the grid
/// that are not in the list are missing.
pub(crate) fn grid(
    values: &[f64],
    columns: usize,
    digits: [Digits; 2],
    limits: &Limits,
) -> Result<GriddedMap, ReadError> {
    let x = GridLines::new(values, columns, 0, digits[0])?;
    let y = GridLines::new(values, columns, 1, digits[1])?;
    let (nx, ny, n) = (x.count, y.count, values.len() / columns);
    limits.check_points(TEXT, [ny, nx])?;
    if nx.saturating_mul(ny) > n.saturating_mul(2) {
        let feature = format!(
            "a list x y z of {n} points that fill less than half of their {ny} x {nx} grid and are \
             to be put on a grid first"
        );
        return Err(ReadError::unsupported(TEXT, feature));
    }
    let mut heights = vec![vec![f64::NAN; nx * ny]; columns - 2];
    let mut seen = vec![false; nx * ny];
    for (i, row) in values.chunks_exact(columns).enumerate() {
        let at = y.index(row[1]) * nx + x.index(row[0]);
        if std::mem::replace(&mut seen[at], true) {
            let what = format!("x = {}, y = {} is already in the list", row[0], row[1]);
            return Err(ReadError::at(TEXT, format!("point {}", i + 1), what));
        }
        for (heights, height) in heights.iter_mut().zip(&row[2..]) {
            heights[at] = *height;
        }
    }
    let (Some(dy), Some(dx)) = (y.step.or(x.step), x.step.or(y.step)) else {
        return Err(ReadError::unsupported(TEXT, "a single point"));
    };
    Ok(GriddedMap { shape: [ny, nx], step: [dy, dx], heights, is_complete: n == nx * ny })
}

/// One coordinate of a list.
struct GridLines {
    first: f64,
    /// Distance of neighbouring grid lines; `None` if there is one line.
    step: Option<f64>,
    count: usize,
}

impl GridLines {
    fn new(
        values: &[f64],
        columns: usize,
        column: usize,
        digits: Digits,
    ) -> Result<Self, ReadError> {
        let name = if column == 0 { "x" } else { "y" };
        let column = values.iter().skip(column).step_by(columns);
        let mut positions: Vec<f64> = column.map(|x| x + 0.0).collect(); // -0 becomes 0
        if let Some(i) = positions.iter().position(|x| !x.is_finite()) {
            let (place, what) = (format!("point {}", i + 1), format!("{name} is {}", positions[i]));
            return Err(ReadError::at(TEXT, place, what));
        }
        positions.sort_unstable_by(f64::total_cmp);
        positions.dedup();
        let (first, end) = (positions[0], positions[positions.len() - 1]);
        let range = end - first;
        // Values closer than a hundredth of the widest gap are one grid line.
        let widest = positions.windows(2).map(|p| p[1] - p[0]).fold(0.0, f64::max);
        positions.dedup_by(|b, a| *b - *a < 0.01 * widest);
        if positions.len() == 1 {
            return Ok(Self { first, step: None, count: 1 });
        }
        let smallest = positions.windows(2).map(|p| p[1] - p[0]).fold(f64::INFINITY, f64::min);
        let all = positions.len();
        let sparse = (range / smallest).round() + 1.0;
        let largest = first.abs().max(end.abs());
        // Either every grid line occurs in the list, or the smallest gap is one step.
        for count in [all as f64, sparse] {
            let step = range / (count - 1.0);
            let deviation = positions
                .iter()
                .map(|p| {
                    let at = (p - first) / step;
                    (at - at.round()).abs() * step
                })
                .fold(0.0, f64::max);
            let is_even = deviation <= tolerance(step, digits, largest).max(0.02 * step);
            if is_even && count < 1e9 {
                return Ok(Self { first, step: Some(step), count: count as usize });
            }
        }
        let feature = format!(
            "a list x y z whose {all} different {name} are not evenly spaced and are to be \
             interpolated to a grid first"
        );
        Err(ReadError::unsupported(TEXT, feature))
    }

    fn index(&self, value: f64) -> usize {
        match self.step {
            Some(step) => (((value - self.first) / step).round() as usize).min(self.count - 1),
            None => 0,
        }
    }
}
