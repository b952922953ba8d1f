//! Separate contact spots of a solution.

use crate::EdgesName;
use contact_types::Grid;
use serde::Serialize;

/// How many spots there are and how large they are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spots {
    /// Sets of touching points connected over edges or corners, across the seam of the map too.
    pub count: usize,
    /// Median area (m²), by counted points.
    pub median_area: f64,
    /// Largest area (m²), by counted points.
    pub largest_area: f64,
}

/// Counts the spots of a pressure field that repeats periodically; `None` if nothing touches or
/// the field is not of this grid.
pub fn contact_spots(pressure: &[f64], grid: Grid) -> Option<Spots> {
    spots_beyond(pressure, grid, EdgesName::Periodic)
}

/// The same with other surroundings: a spot at the edge of mirror images joins its own image, not
/// what lies at the other edge, and counts by its part on the map.
pub(crate) fn spots_beyond(pressure: &[f64], grid: Grid, edges: EdgesName) -> Option<Spots> {
    let [ny, nx] = grid.shape();
    if pressure.len() != grid.len() {
        return None;
    }
    let mut left: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
    let mut sizes: Vec<usize> = Vec::new();
    let mut front: Vec<usize> = Vec::new();
    for start in 0..left.len() {
        if !std::mem::take(&mut left[start]) {
            continue;
        }
        front.push(start);
        let mut size = 0;
        while let Some(i) = front.pop() {
            size += 1;
            for dy in [ny - 1, 0, 1] {
                for dx in [nx - 1, 0, 1] {
                    let (y, x) = ((i / nx + dy) % ny, (i % nx + dx) % nx);
                    let crosses = y.abs_diff(i / nx) > 1 || x.abs_diff(i % nx) > 1;
                    if crosses && edges == EdgesName::Mirrored {
                        continue;
                    }
                    let j = y * nx + x;
                    if std::mem::take(&mut left[j]) {
                        front.push(j);
                    }
                }
            }
        }
        sizes.push(size);
    }
    sizes.sort_unstable();
    let [dy, dx] = grid.pixel();
    let area = |points: usize| points as f64 * dy * dx;
    Some(Spots {
        count: sizes.len(),
        median_area: area(*sizes.get(sizes.len() / 2)?),
        largest_area: area(*sizes.last()?),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_the_seam_connect() {
        let map = [
            "x....x", // joined across the seam
            "......", //
            "..x...", // joined over a corner
            "...x..", //
            "......", //
            ".....x", // joined with the first row, across a corner of the map
        ];
        let pressure: Vec<f64> =
            map.concat().chars().map(|c| f64::from(u8::from(c == 'x'))).collect();
        let grid = Grid::new([6, 6], [2.0, 1.0]).unwrap();
        let spots = contact_spots(&pressure, grid).unwrap();
        assert_eq!(spots, Spots { count: 2, median_area: 6.0, largest_area: 6.0 });
        let inside = spots_beyond(&pressure, grid, EdgesName::Mirrored).unwrap();
        assert_eq!((inside.count, inside.largest_area), (4, 4.0));
        assert!(contact_spots(&[0.0; 36], grid).is_none());
        assert!(contact_spots(&[1.0; 35], grid).is_none());
    }
}
