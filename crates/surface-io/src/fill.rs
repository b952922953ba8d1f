//! From a measurement with missing points to a complete height map.

use crate::harmonic;
use crate::{FillError, Measurement};
use contact_types::{Grid, HeightMap, Named};

/// What to do about missing points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Fill {
    /// Nothing: missing points are an error that says where they are.
    #[default]
    Refuse,
    /// The smoothest continuation of the points around each hole: the heights inside satisfy
    /// Laplace's equation with the measured rim as boundary values, and no slope across the edge
    /// of the map. It never exceeds the heights on the rim and adds no texture, so large holes
    /// lower roughness and gradients.
    Harmonic,
    /// The height of the nearest measured point, in metres (not in pixels).
    Nearest,
}

impl Named for Fill {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Refuse, "refuse"), (Self::Harmonic, "harmonic"), (Self::Nearest, "nearest")];
}

impl Measurement {
    /// Makes a complete height map, the only thing models and solvers take.
    ///
    /// # Errors
    /// [`FillError::Missing`] for [`Fill::Refuse`] if points are missing,
    /// [`FillError::NothingValid`] if all are, [`FillError::Uneven`] for a profile whose points
    /// are not evenly spaced.
    pub fn fill(self, fill: Fill) -> Result<HeightMap, FillError> {
        if let Some(deviation) = self.uneven {
            return Err(FillError::Uneven(deviation));
        }
        let (missing, grid, mut heights) = (self.missing(), self.grid, self.heights);
        let points = heights.len();
        if missing == points {
            return Err(FillError::NothingValid(points));
        }
        if let Some(first) = heights.iter().position(|h| h.is_nan()) {
            let [_, nx] = grid.shape();
            let first = [first / nx, first % nx];
            match fill {
                Fill::Refuse => return Err(FillError::Missing { missing, points, first }),
                Fill::Harmonic => harmonic::fill(grid, &mut heights)?,
                Fill::Nearest => nearest(grid, &mut heights),
            }
        }
        // Every missing point was filled and none is infinite; were it not so, this says so.
        HeightMap::new(grid, heights).map_err(FillError::Surface)
    }
}

/// Gives every missing point the height of the nearest valid one, by the exact distance
/// transform of Felzenszwalb & Huttenlocher (2012), doi:10.4086/toc.2012.v008a019: first along
/// columns, then along rows as the lower envelope of parabolas. Linear in the number of points.
fn nearest(grid: Grid, heights: &mut [f64]) {
    const NONE: u32 = u32::MAX;
    let [ny, nx] = grid.shape();
    let [dy, dx] = grid.pixel();
    // Row of the nearest valid point in the same column.
    let mut row_of = vec![NONE; ny * nx];
    for ix in 0..nx {
        let mut last = NONE;
        for iy in 0..ny {
            if !heights[iy * nx + ix].is_nan() {
                last = iy as u32;
            }
            row_of[iy * nx + ix] = last;
        }
        let mut next = NONE;
        for iy in (0..ny).rev() {
            let here = &mut row_of[iy * nx + ix];
            if *here as usize == iy {
                next = *here;
            } else if next != NONE && (*here == NONE || next as usize - iy < iy - *here as usize) {
                *here = next;
            }
        }
    }
    // Columns whose parabola is the lowest somewhere in the row, and where that begins.
    let mut sites = Vec::<(usize, f64)>::new();
    for iy in 0..ny {
        let row = iy * nx;
        if heights[row..row + nx].iter().all(|h| !h.is_nan()) {
            continue;
        }
        // Squared distance to the valid point of column ix, in units of dx^2.
        let depth = |ix: usize| {
            let distance = (f64::from(row_of[row + ix]) - iy as f64) * (dy / dx);
            distance * distance
        };
        sites.clear();
        for ix in (0..nx).filter(|&ix| row_of[row + ix] != NONE) {
            let mut start = f64::NEG_INFINITY;
            while let Some(&(site, begin)) = sites.last() {
                let (a, b) = (site as f64, ix as f64);
                // Where the parabola of ix dips below that of site.
                start = (a + b + (depth(ix) - depth(site)) / (b - a)) / 2.0;
                if start > begin {
                    break;
                }
                sites.pop();
                start = f64::NEG_INFINITY;
            }
            sites.push((ix, start));
        }
        let mut k = 0;
        for ix in 0..nx {
            while k + 1 < sites.len() && sites[k + 1].1 < ix as f64 {
                k += 1;
            }
            if heights[row + ix].is_nan() {
                // `row_of` points at valid points only, which are never overwritten.
                let site = sites[k].0;
                heights[row + ix] = heights[row_of[row + site] as usize * nx + site];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Against the definition, on random masks with pixels of any shape.
        #[test]
        fn nearest_is_nearest(
            ny in 1usize..10, nx in 2usize..9, first in 0usize..72,
            dx in prop_oneof![Just(1.0), 0.3..2.5f64],
            valid in prop::collection::vec(prop::bool::weighted(0.33), 72),
        ) {
            let grid = Grid::new([ny, nx], [1.0, dx]).unwrap();
            let height = |i: usize| if valid[i] || i == first % (ny * nx) { i as f64 } else { f64::NAN };
            let given: Vec<f64> = (0..ny * nx).map(height).collect();
            let mut heights = given.clone();
            nearest(grid, &mut heights);
            for (i, found) in heights.iter().enumerate() {
                let distance = |j: usize| {
                    let [rows, columns] = [i / nx, i % nx].map(|k| k as f64);
                    (rows - (j / nx) as f64).hypot((columns - (j % nx) as f64) * dx)
                };
                let there = (0..ny * nx).filter(|j| !given[*j].is_nan());
                let least = there.map(distance).fold(f64::INFINITY, f64::min);
                // A height is the number of its point.
                let is_near = distance(*found as usize) <= least * (1.0 + 1e-12);
                prop_assert!(given.contains(found) && is_near, "point {i}: {found}");
            }
        }
    }
}
