//! Gradient and developed area.

use contact_types::HeightMap;

/// Sdr, area over projected area, minus 1 (-), of an open map (ISO 25178-2:2021, 4.4): mean of the two ways to cut each cell
/// of four pixels into triangles.
pub(super) fn developed_area(map: &HeightMap) -> f64 {
    let ([ny, nx], pixel) = (map.grid().shape(), map.grid().pixel());
    let mut excess = 0.0;
    for iy in 0..ny - 1 {
        let (row, next) = map.heights()[iy * nx..(iy + 2) * nx].split_at(nx);
        let cells = row.windows(2).zip(next.windows(2));
        excess += cells.map(|(a, b)| cell_excess([a[0], a[1], b[0], b[1]], pixel)).sum::<f64>();
    }
    excess / ((ny - 1) as f64 * (nx - 1) as f64)
}

/// Area over projected area, minus 1, of a cell with corners 00, 01, 10, 11 (row, column): mean
/// over the four triangles of the two triangulations.
fn cell_excess([z00, z01, z10, z11]: [f64; 4], [dy, dx]: [f64; 2]) -> f64 {
    let triangle = |along_x: f64, along_y: f64| {
        let square = (along_x / dx).powi(2) + (along_y / dy).powi(2);
        square / (1.0 + (1.0 + square).sqrt()) // sqrt(1 + s) - 1 without cancellation
    };
    let (top, bottom, left, right) = (z01 - z00, z11 - z10, z10 - z00, z11 - z01);
    0.25 * (triangle(top, right)
        + triangle(bottom, left)
        + triangle(top, left)
        + triangle(bottom, right))
}

/// Slope in the middle of seven heights at distances of 1, with an error of the sixth order.
pub(crate) fn seven_point_slope(at: impl Fn(usize) -> f64) -> f64 {
    (45.0 * (at(4) - at(2)) - 9.0 * (at(5) - at(1)) + (at(6) - at(0))) / 60.0
}

/// Sdq by seven-point central differences, error of order dx⁶, over the pixels that are three or more from every edge (-).
/// `None` below 7 x 7 pixels.
pub(super) fn seven_point_gradient(map: &HeightMap) -> Option<f64> {
    let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
    if ny < 7 || nx < 7 {
        return None;
    }
    let mut sum = 0.0;
    for iy in 3..ny - 3 {
        let mut row_sum = 0.0;
        for ix in 3..nx - 3 {
            let along_x = seven_point_slope(|k| map.at(iy, ix + k - 3)) / dx;
            let along_y = seven_point_slope(|k| map.at(iy + k - 3, ix)) / dy;
            row_sum += along_x * along_x + along_y * along_y;
        }
        sum += row_sum;
    }
    Some((sum / ((ny - 6) * (nx - 6)) as f64).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differences::by_differences;
    use crate::{Edges, close};
    use approx::assert_relative_eq;
    use contact_types::Grid;

    /// A plane of slopes a, b: gradient √(a² + b²), area √(1 + a² + b²), whatever the triangles. Slopes of 1e-9 leave an
    /// area excess of 5e-19 that `sqrt(1 + s) - 1` would lose.
    #[test]
    fn a_plane_is_exact() {
        let grid = Grid::new([9, 8], [2e-6, 1e-6]).unwrap();
        for (scale, excess, error) in [(1.0, 1.25f64.sqrt() - 1.0, 1e-13), (2e-9, 5e-19, 1e-9)] {
            let plane = |y: f64, x: f64| scale * (0.3 * x - 0.4 * y);
            let map = HeightMap::from_fn(grid, plane).unwrap();
            let (moments, ..) = by_differences(&map, Edges::Open).unwrap();
            close(moments.rms_gradient(), 0.5 * scale, 1e-13);
            close(seven_point_gradient(&map).unwrap(), 0.5 * scale, 1e-13);
            close(developed_area(&map), excess, error);
        }
    }

    /// Along a wave the seven-point slope converges with the sixth power of the pixel.
    #[test]
    fn seven_point_slope_is_of_sixth_order() {
        let error = |n: usize| {
            let grid = Grid::new([n, n], [1.0 / n as f64; 2]).unwrap();
            let q = std::f64::consts::TAU;
            let map = HeightMap::from_fn(grid, |_, x| (q * x).sin()).unwrap();
            let i = n / 2;
            let slope = seven_point_slope(|k| map.at(8, i + k - 3));
            (slope * n as f64 - q * (q * i as f64 / n as f64).cos()).abs()
        };
        let order = (error(32) / error(64)).log2();
        assert_relative_eq!(order, 6.0, epsilon = 0.1);
    }
}
