//! Summits counted on the map.

use crate::Edges;
use contact_types::HeightMap;
use std::cmp::Ordering;

/// Summits found pixel by pixel.
///
/// A *summit* is a pixel higher than all its eight neighbours. A *plateau* is a connected patch of two or more pixels of
/// exactly equal height with nothing higher and something lower around it; on data stored in steps the flat tops are
/// plateaus. They are counted apart, since their number depends on the step and not on the surface. On an open map the
/// outermost pixels are never summits, and a plateau that reaches them is not counted.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Summits {
    /// Number of summits.
    pub count: usize,
    /// Summits per area of the pixels that could be one (m⁻²).
    pub density: f64,
    /// Mean height of the summits above the mean plane (m); `None` without a summit.
    pub height_mean: Option<f64>,
    /// Standard deviation of the summit heights (of all, not of a sample) (m).
    pub height_std: Option<f64>,
    /// Mean of `-(d²z/dx² + d²z/dy²)/2` at the summits by second differences (m⁻¹).
    pub curvature_mean: Option<f64>,
    /// Number of flat tops, not contained in `count`.
    pub plateaus: usize,
}

impl Summits {
    /// Counts on a map, of 3 x 3 pixels at least, whose heights are distances from its mean plane.
    pub(crate) fn of(map: &HeightMap, edges: Edges) -> Self {
        let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
        let around = Neighbours { map, edges };
        let rim = usize::from(edges == Edges::Open);
        let (rows, columns) = (rim..ny - rim, rim..nx - rim);
        let candidates = rows.len() * columns.len();
        let mut found = Vec::new(); // (height, curvature)
        let mut flat = Vec::new(); // pixels with an equal and no higher neighbour
        for iy in rows {
            for ix in columns.clone() {
                match around.standing(iy, ix) {
                    Ordering::Greater => {
                        let [z, left, right, up, down] = around.cross(iy, ix);
                        let zxx = (right - z - (z - left)) / (dx * dx);
                        let zyy = (down - z - (z - up)) / (dy * dy);
                        found.push((z, -0.5 * (zxx + zyy)));
                    }
                    Ordering::Equal => flat.push(iy * nx + ix),
                    Ordering::Less => {}
                }
            }
        }
        let n = found.len() as f64;
        let mean = |f: &dyn Fn(&(f64, f64)) -> f64| {
            (!found.is_empty()).then(|| found.iter().map(f).sum::<f64>() / n)
        };
        let height_mean = mean(&|s| s.0);
        let height_std = height_mean.and_then(|m| mean(&|s| (s.0 - m) * (s.0 - m)).map(f64::sqrt));
        Self {
            count: found.len(),
            density: n / (candidates as f64 * dy * dx),
            height_mean,
            height_std,
            curvature_mean: mean(&|s| s.1),
            plateaus: around.count_plateaus(&flat),
        }
    }
}

struct Neighbours<'a> {
    map: &'a HeightMap,
    edges: Edges,
}

impl Neighbours<'_> {
    /// Indices of the eight pixels around (iy, ix) of the map as it repeats. On the rim of an open map, where nothing is
    /// counted, they do not matter.
    fn around(&self, iy: usize, ix: usize) -> impl Iterator<Item = usize> {
        let [ny, nx] = self.map.grid().shape();
        let before = |i: usize, n: usize| match i {
            0 => n - 1,
            i if i > n => 0,
            i => i - 1,
        };
        let others = (0..9).filter(|&k| k != 4);
        others.map(move |k| before(iy + k / 3, ny) * nx + before(ix + k % 3, nx))
    }

    /// How the pixel stands to the highest of those around it.
    fn standing(&self, iy: usize, ix: usize) -> Ordering {
        let z = self.map.at(iy, ix);
        let mut equal = false;
        for other in self.around(iy, ix) {
            let h = self.map.heights()[other];
            if h > z {
                return Ordering::Less;
            }
            equal |= h >= z;
        }
        if equal { Ordering::Equal } else { Ordering::Greater }
    }

    /// Heights of the pixel and of its left, right, upper and lower neighbours.
    fn cross(&self, iy: usize, ix: usize) -> [f64; 5] {
        let [ny, nx] = self.map.grid().shape();
        let at = |y: usize, x: usize| self.map.at(y % ny, x % nx);
        [at(iy, ix), at(iy, ix + nx - 1), at(iy, ix + 1), at(iy + ny - 1, ix), at(iy + 1, ix)]
    }

    /// Plateaus among pixels that have an equal and no higher neighbour.
    fn count_plateaus(&self, flat: &[usize]) -> usize {
        if flat.is_empty() || self.map.is_flat() {
            return 0;
        }
        let ([ny, nx], heights) = (self.map.grid().shape(), self.map.heights());
        let mut seen = vec![false; heights.len()];
        let mut pending = Vec::new();
        let mut plateaus = 0;
        for &start in flat {
            if seen[start] {
                continue;
            }
            seen[start] = true;
            pending.push(start);
            let mut is_top = true;
            while let Some(pixel) = pending.pop() {
                let (iy, ix) = (pixel / nx, pixel % nx);
                let on_rim = iy == 0 || ix == 0 || iy + 1 == ny || ix + 1 == nx;
                is_top &= self.edges == Edges::Periodic || !on_rim;
                for other in self.around(iy, ix) {
                    is_top &= heights[other] <= heights[pixel];
                    #[expect(clippy::float_cmp, reason = "a plateau is of exactly equal heights")]
                    let equal = heights[other] == heights[pixel];
                    if equal && !seen[other] {
                        seen[other] = true;
                        pending.push(other);
                    }
                }
            }
            plateaus += usize::from(is_top);
        }
        plateaus
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use contact_types::Grid;

    #[test]
    fn peaks_plateaus_and_shoulders_by_hand() {
        let rows = [
            "90000000", // a rim pixel: no summit on an open map
            "00300220", // a peak; a plateau of two
            "00000000", //
            "04400000", // equal pixels beside a higher one: a shoulder
            "00500011", // a peak; a plateau that reaches the rim
            "00000000",
        ];
        let heights = rows.concat().bytes().map(|b| f64::from(b - b'0')).collect();
        let m = HeightMap::new(Grid::new([6, 8], [2.0, 1.0]).unwrap(), heights).unwrap();
        let open = Summits::of(&m, Edges::Open);
        assert_eq!((open.count, open.plateaus), (2, 1));
        assert_relative_eq!(open.density, 2.0 / (4.0 * 6.0 * 2.0), epsilon = 0.0);
        assert_relative_eq!(open.height_mean.unwrap(), 4.0, epsilon = 0.0);
        assert_relative_eq!(open.height_std.unwrap(), 1.0, epsilon = 0.0);
        // Peak 3: zxx = -6, zyy = -6/4. Peak 5: zxx = -10, zyy = (4 + 0 - 10)/4.
        assert_relative_eq!(open.curvature_mean.unwrap(), 4.75, epsilon = 0.0);
        let periodic = Summits::of(&m, Edges::Periodic);
        assert_eq!((periodic.count, periodic.plateaus), (3, 2));
        assert_relative_eq!(periodic.density, 3.0 / 96.0, epsilon = 0.0);
    }
}
