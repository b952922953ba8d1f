//! Separate contact spots of a solution.

use contact_types::Grid;
use serde::Serialize;

/// One contact spot.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Spot {
    /// Area by counted points (m²).
    pub area: f64,
    /// Force it carries (N).
    pub load: f64,
    /// Mean position `[y, x]` of its points, from the centre of the first point (m). Of a spot that runs
    /// around a periodic map it has no meaning.
    pub centroid: [f64; 2],
    /// Load over area (Pa).
    pub mean_pressure: f64,
    /// Highest pressure of a point (Pa).
    pub max_pressure: f64,
    /// Its points.
    pub points: usize,
}

/// Every contact spot of a pressure field (Pa), largest first, and of each point the number of its spot in the order of
/// their first points, from 1; 0 where nothing touches. Spots are sets of touching points connected over edges or
/// corners; across the seam of the map too where it `repeats`: a spot at the edge of mirror images joins its own image, not
/// what lies at the other edge, and counts by its part on the map. Empty if nothing touches or the field is
/// not of this grid.
pub fn contact_spots(pressure: &[f64], grid: Grid, repeats: bool) -> (Vec<Spot>, Vec<i32>) {
    let [ny, nx] = grid.shape();
    if pressure.len() != grid.len() {
        return (Vec::new(), Vec::new());
    }
    let [dy, dx] = grid.pixel();
    let mut labels = vec![0; pressure.len()];
    let (mut spots, mut label): (Vec<Spot>, _) = (Vec::new(), 0);
    // Points with the way to them from the first one, which does not jump at the seam.
    let mut front: Vec<(usize, [isize; 2])> = Vec::new();
    for start in 0..pressure.len() {
        let is_new = |labels: &[i32], i: usize| labels[i] == 0 && pressure[i] > 0.0;
        if !is_new(&labels, start) {
            continue;
        }
        label += 1;
        labels[start] = label;
        front.push((start, [0, 0]));
        let (mut points, mut sum, mut highest, mut way) = (0_usize, 0.0, 0.0_f64, [0.0; 2]);
        while let Some((i, [wy, wx])) = front.pop() {
            points += 1;
            sum += pressure[i];
            highest = highest.max(pressure[i]);
            way = [way[0] + wy as f64, way[1] + wx as f64];
            let (iy, ix) = (i / nx, i % nx);
            let columns = beside(ix, nx);
            for (y, ay) in beside(iy, ny) {
                for (x, ax) in columns {
                    let crosses = y.abs_diff(iy) > 1 || x.abs_diff(ix) > 1;
                    if crosses && !repeats {
                        continue;
                    }
                    let j = y * nx + x;
                    if is_new(&labels, j) {
                        labels[j] = label;
                        front.push((j, [wy + ay, wx + ax]));
                    }
                }
            }
        }
        let place = |first: usize, way: f64, n: usize, pixel: f64| {
            (first as f64 + way / points as f64).rem_euclid(n as f64) * pixel
        };
        spots.push(Spot {
            area: points as f64 * dy * dx,
            load: sum * dy * dx,
            centroid: [place(start / nx, way[0], ny, dy), place(start % nx, way[1], nx, dx)],
            mean_pressure: sum / points as f64,
            max_pressure: highest,
            points,
        });
    }
    spots.sort_by_key(|spot| std::cmp::Reverse(spot.points));
    (spots, labels)
}

/// Before, here and after on a ring of `n`, with the way there.
fn beside(i: usize, n: usize) -> [(usize, isize); 3] {
    let before = if i == 0 { n - 1 } else { i - 1 };
    let after = if i + 1 == n { 0 } else { i + 1 };
    [(before, -1), (i, 0), (after, 1)]
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
        let of = |pressure: &[f64], repeats| contact_spots(pressure, grid, repeats).0;
        let points = |list: &[Spot]| list.iter().map(|s| s.points).collect::<Vec<_>>();
        assert_eq!(points(&of(&pressure, true)), [3, 2]);
        assert_eq!(points(&of(&pressure, false)), [2, 1, 1, 1]);
        let (list, labels) = contact_spots(&pressure, grid, true);
        assert_eq!([0, 1, 5, 14, 21, 35].map(|i| labels[i]), [1, 0, 1, 2, 2, 1]);
        let sorted = list.windows(2).all(|w| w[0].points >= w[1].points);
        assert!(sorted && list.iter().all(|s| (s.load / s.area - 1.0).abs() < 1e-12));
        // Three points around the corner of the map: (0, 0), (0, 5), (5, 5) in rows and columns.
        let corner = list.iter().find(|s| s.centroid[1] > 3.0).unwrap();
        for (found, exact) in corner.centroid.iter().zip([12.0 - 2.0 / 3.0, 6.0 - 2.0 / 3.0]) {
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
        assert!(of(&[0.0; 36], true).is_empty() && of(&[1.0; 35], true).is_empty());
    }
}
