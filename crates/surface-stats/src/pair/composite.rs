//! The sum of the heights of two maps that face each other.

use super::independence::Independence;
use super::overlay::{Overlap, Placed, common, interpolated};
use super::placing::{Flip, PairError, Placing};
use crate::clean::resample;
use crate::{Edges, Level, StatsError, repeats};
use contact_types::{Grid, HeightMap};

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
    /// The shift is made in whole points of the finer map: no height is interpolated for it. Where both
    /// maps [repeat](repeats) and are equally large, what moves out on one side comes in on the
    /// other. Otherwise their centres lie on each other before the shift, and only the part in common is
    /// kept. Of maps with different point spacings, the coarser is interpolated at the points of the
    /// finer: exactly for its waves if both repeat, else by cubic convolution, which is exact for
    /// quadratics. That adds no wave that was not measured.
    ///
    /// # Errors
    /// [`PairError`].
    pub fn of(first: &HeightMap, second: &HeightMap, placing: &Placing) -> Result<Self, PairError> {
        let second = turned_over(second, placing.flip)?;
        let grids = [first.grid(), second.grid()];
        let (parts, placed) = if are_one_cell(grids) && repeats(first) && repeats(&second) {
            rolled(first, &second, placing.shift)?
        } else {
            cut(first, &second, placing.shift)?
        };
        let [a, b] = &parts;
        let sum = a.heights().iter().zip(b.heights()).map(|(a, b)| a + b).collect();
        let map = HeightMap::new(a.grid(), sum).map_err(StatsError::from)?;
        Ok(Self { map, parts, placed })
    }

    /// How far the moments of the two, each without its `form` and with these edges, are from adding up.
    ///
    /// # Errors
    /// [`StatsError::TooSmall`] below 3 x 3 points, [`StatsError::OutOfRange`].
    pub fn independence(&self, form: Level, edges: Edges) -> Result<Independence, StatsError> {
        Independence::of([&self.parts[0], &self.parts[1]], &self.map, form, edges)
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

type Laid = ([HeightMap; 2], Placed);

fn rolled(first: &HeightMap, second: &HeightMap, shift: [f64; 2]) -> Result<Laid, PairError> {
    let grids = [first.grid(), second.grid()];
    let shape = [0, 1].map(|k| grids[0].shape()[k].max(grids[1].shape()[k]));
    let resampled = grids.map(|grid| grid.shape() != shape);
    let on_grid = |map: &HeightMap, is_new: bool| {
        if is_new { resample(map, shape) } else { Ok(map.clone()) }
    };
    let (a, b) = (on_grid(first, resampled[0])?, on_grid(second, resampled[1])?);
    let common = a.grid();
    let points = [0, 1].map(|k| (shift[k] / common.pixel()[k]).round());
    if let Some(k) = points.iter().position(|n| !n.is_finite()) {
        return Err(PairError::TooLittle { shift: shift[k], found: 0.0 });
    }
    let shift = [0, 1].map(|k| points[k] * common.pixel()[k]);
    // Whole turns change nothing; a remainder is exact.
    let turned = |k: usize| points[k].rem_euclid(shape[k] as f64) as usize % shape[k];
    let mut heights = b.into_heights();
    heights.rotate_right(turned(0) * shape[1]);
    heights.chunks_exact_mut(shape[1]).for_each(|row| row.rotate_right(turned(1)));
    let b = HeightMap::new(common, heights).map_err(StatsError::from)?;
    Ok(([a, b], Placed { shift, is_rolled: true, grids, common, resampled }))
}

fn cut(first: &HeightMap, second: &HeightMap, shift: [f64; 2]) -> Result<Laid, PairError> {
    let grids = [first.grid(), second.grid()];
    let [y, x] =
        [0, 1].map(|k| common(grids.map(|g| g.shape()[k]), grids.map(|g| g.pixel()[k]), shift[k]));
    let axes: [Overlap; 2] = [y?, x?];
    let grid = Grid::new(axes.map(|a| a.along[0].count), axes.map(|a| a.pixel))
        .map_err(StatsError::from)?;
    let resampled = [0, 1].map(|which| axes.iter().any(|a| a.between == Some(which)));
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
        HeightMap::new(grid, heights).map_err(StatsError::from)
    };
    let parts = [part(0, first)?, part(1, second)?];
    let shift = axes.map(|a| a.shift);
    Ok((parts, Placed { shift, is_rolled: false, grids, common: grid, resampled }))
}
