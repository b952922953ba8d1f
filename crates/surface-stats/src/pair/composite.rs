//! The sum of the heights of two maps that face each other.

use super::overlay::{Placed, common, interpolated};
use crate::clean::resample;
use crate::{Edges, StatsError, repeats};
use contact_types::{Grid, HeightMap, Named};

/// How the second body is turned over to lie face down on the first, which mirrors its map as seen from above.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Flip {
    /// As a book is closed, the maps being its two open pages: the first column meets the last.
    #[default]
    Columns,
    /// As a page of a wall calendar is turned: the first row meets the last.
    Rows,
    /// Not at all: the map already shows the body as it lies on the first.
    None,
}

impl Named for Flip {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Columns, "columns"), (Self::Rows, "rows"), (Self::None, "none")];
}

/// How the second body is laid on the first.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Placing {
    /// How it is turned over.
    pub flip: Flip,
    /// How far it is moved then along `[y, x]` (m), towards higher rows and columns of the first.
    pub shift: [f64; 2],
}

/// Two bodies as one rough surface against a smooth flat.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Composite {
    /// Sum of the heights at each place (m).
    pub map: HeightMap,
    /// Both bodies on the points of their common part, the second as it faces the first.
    pub parts: [HeightMap; 2],
    /// How they lie.
    pub placed: Placed,
}

impl Composite {
    /// The second map turned over, moved and added to the first.
    ///
    /// The shift is made in whole points of the finer map. Where both maps [repeat](repeats) and are equally large, what
    /// moves out on one side comes in on the other. Otherwise their centres lie on each other before the shift, and only the
    /// part in common is kept. The coarser map is interpolated at the points of the finer: exactly for its waves if both
    /// repeat, else by cubic convolution, which is exact for quadratics.
    ///
    /// # Errors
    /// [`StatsError::TooLittle`], [`StatsError::TooCoarse`], [`StatsError::TooSmall`] for a map to be interpolated.
    pub fn of(
        first: &HeightMap,
        second: &HeightMap,
        placing: &Placing,
    ) -> Result<Self, StatsError> {
        let second = turned_over(second, placing.flip)?;
        let grids = [first.grid(), second.grid()];
        let is_rolled = are_one_cell(grids) && repeats(first) && repeats(&second);
        let lay = if is_rolled { rolled } else { cut };
        let (parts, shift, resampled) = lay(first, &second, placing.shift)?;
        let common = parts[0].grid();
        let shares = grids.map(|grid| (common.area() / grid.area()).min(1.0));
        let [p, q] = grids.map(|grid| grid.pixel());
        let pixel_ratio = (0..2).map(|k| p[k].max(q[k]) / p[k].min(q[k])).fold(1.0, f64::max);
        let placed = Placed { shift, is_rolled, grids, common, resampled, shares, pixel_ratio };
        let [a, b] = &parts;
        let sum = a.heights().iter().zip(b.heights()).map(|(a, b)| a + b).collect();
        Ok(Self { map: HeightMap::new(a.grid(), sum)?, parts, placed })
    }
}

/// The map as it lies once it is turned over.
fn turned_over(map: &HeightMap, how: Flip) -> Result<HeightMap, StatsError> {
    let mut heights = map.heights().to_vec();
    if how == Flip::Rows {
        heights.reverse();
    }
    if how != Flip::None {
        heights.chunks_exact_mut(map.grid().shape()[1]).for_each(<[f64]>::reverse);
    }
    Ok(HeightMap::new(map.grid(), heights)?)
}

/// Whether both maps cover the same area to half a point of the finer.
fn are_one_cell([a, b]: [Grid; 2]) -> bool {
    (0..2).all(|k| (a.size()[k] - b.size()[k]).abs() <= 0.5 * a.pixel()[k].min(b.pixel()[k]))
}

/// Both bodies on the points of their common part, how far the second was moved (m), and which were resampled.
type Laid = ([HeightMap; 2], [f64; 2], [bool; 2]);

fn rolled(first: &HeightMap, second: &HeightMap, shift: [f64; 2]) -> Result<Laid, StatsError> {
    let grids = [first.grid(), second.grid()];
    let shape = [0, 1].map(|k| grids[0].shape()[k].max(grids[1].shape()[k]));
    let resampled = grids.map(|grid| grid.shape() != shape);
    let on_grid = |map: &HeightMap, is_new: bool| {
        if is_new { resample(map, shape, Edges::Periodic) } else { Ok(map.clone()) }
    };
    let (a, b) = (on_grid(first, resampled[0])?, on_grid(second, resampled[1])?);
    let common = a.grid();
    let points = [0, 1].map(|k| (shift[k] / common.pixel()[k]).round());
    if let Some(k) = points.iter().position(|n| !n.is_finite()) {
        return Err(StatsError::TooLittle { shift: shift[k], found: 0.0 });
    }
    let shift = [0, 1].map(|k| points[k] * common.pixel()[k]);
    // Whole turns change nothing; a remainder is exact.
    let turned = |k: usize| points[k].rem_euclid(shape[k] as f64) as usize % shape[k];
    let mut heights = b.into_heights();
    heights.rotate_right(turned(0) * shape[1]);
    heights.chunks_exact_mut(shape[1]).for_each(|row| row.rotate_right(turned(1)));
    let b = HeightMap::new(common, heights)?;
    Ok(([a, b], shift, resampled))
}

fn cut(first: &HeightMap, second: &HeightMap, shift: [f64; 2]) -> Result<Laid, StatsError> {
    let grids = [first.grid(), second.grid()];
    let along =
        |k: usize| common(grids.map(|g| g.shape()[k]), grids.map(|g| g.pixel()[k]), shift[k]);
    let axes = [along(0)?, along(1)?];
    let grid = Grid::new(axes.map(|a| a.along[0].count), axes.map(|a| a.pixel))?;
    let resampled = [0, 1].map(|which| axes.iter().any(|a| a.along[which].step < 1.0));
    let part = |which: usize, map: &HeightMap| {
        let along = axes.map(|a| a.along[which]);
        let [ny, nx] = map.grid().shape();
        let heights = if resampled[which] {
            StatsError::require_shape("cubic interpolation", [ny, nx], [4, 4])?;
            interpolated([ny, nx], map.heights(), along)
        } else {
            let [y, x] = along.map(|a| a.first as usize..a.first as usize + a.count);
            y.flat_map(|iy| map.heights()[iy * nx..][x.clone()].iter().copied()).collect()
        };
        Ok::<_, StatsError>(HeightMap::new(grid, heights)?)
    };
    Ok(([part(0, first)?, part(1, second)?], axes.map(|a| a.shift), resampled))
}
