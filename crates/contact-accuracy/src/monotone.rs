//! A surface through the points of a map that does not overshoot them: another answer to what lies
//! between.

use contact_types::{Grid, HeightMap, SurfaceError};

/// The map on twice as many points along each side, by cubics that are monotone between neighbours
/// (Fritsch & Carlson 1980, doi:10.1137/0717021), along x and then along y: a flat top stays flat and
/// a step does not ring. The points stand as those of [`regrid`](crate::regrid): every second on one
/// of the map if it `repeats`, a quarter of a pixel to both sides of each otherwise.
///
/// # Errors
/// [`SurfaceError`] if that are too many points.
pub(crate) fn twice_as_fine(map: &HeightMap, repeats: bool) -> Result<HeightMap, SurfaceError> {
    let [ny, nx] = map.grid().shape();
    let [dy, dx] = map.grid().pixel();
    let grid = Grid::new([2 * ny, 2 * nx], [0.5 * dy, 0.5 * dx])?;
    let mut wide = vec![0.0; ny * 2 * nx];
    for iy in 0..ny {
        for ix in 0..nx {
            let [a, b] = pair(|k| map.at(iy, inside(ix, k, nx, repeats)), repeats);
            wide[iy * 2 * nx + 2 * ix] = a;
            wide[iy * 2 * nx + 2 * ix + 1] = b;
        }
    }
    let mut heights = vec![0.0; grid.len()];
    for iy in 0..ny {
        for ix in 0..2 * nx {
            let [a, b] = pair(|k| wide[inside(iy, k, ny, repeats) * 2 * nx + ix], repeats);
            heights[2 * iy * 2 * nx + ix] = a;
            heights[(2 * iy + 1) * 2 * nx + ix] = b;
        }
    }
    HeightMap::new(grid, heights)
}

/// The point `k` away from `i` of `n` in line: around the edge if the map `repeats`, mirrored at it
/// otherwise.
pub(crate) fn inside(i: usize, k: isize, n: usize, repeats: bool) -> usize {
    let (i, n) = (i.cast_signed() + k, n.cast_signed());
    if (0..n).contains(&i) {
        return i.cast_unsigned(); // most are, and a division takes longer than all else here
    }
    let j = if repeats { i.rem_euclid(n) } else { i.rem_euclid(2 * n) };
    (if j < n { j } else { 2 * n - 1 - j }).cast_unsigned()
}

/// The two new points that stand for point 0 of a line.
fn pair(at: impl Fn(isize) -> f64, repeats: bool) -> [f64; 2] {
    let from =
        |first: isize, t: f64| hermite([at(first - 1), at(first), at(first + 1), at(first + 2)], t);
    if repeats { [at(0), from(0, 0.5)] } else { [from(-1, 0.75), from(0, 0.25)] }
}

/// The monotone cubic at `t` between the second and the third of four points.
fn hermite([a, b, c, d]: [f64; 4], t: f64) -> f64 {
    let (left, right) = (slope(b - a, c - b), slope(c - b, d - c));
    let (t2, t3) = (t * t, t * t * t);
    let rise = 3.0 * t2 - 2.0 * t3;
    b + (c - b) * rise + left * (t - 2.0 * t2 + t3) + right * (t3 - t2)
}

/// Slope at a point between two steps: their mean, at most three times the smaller, and none at a
/// turning point.
fn slope(before: f64, after: f64) -> f64 {
    if before * after <= 0.0 {
        return 0.0;
    }
    let most = 3.0 * before.abs().min(after.abs());
    let mean = 0.5 * (before + after);
    mean.clamp(-most, most)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(height: impl Fn(f64, f64) -> f64) -> HeightMap {
        HeightMap::from_fn(Grid::new([16, 16], [1.0, 1.0]).unwrap(), height).unwrap()
    }

    /// On a plane the new points lie on it, but next to the edges, where it is mirrored.
    #[test]
    fn a_plane_stays_a_plane() {
        let map = square(|y, x| 0.3 * y - 0.2 * x);
        let (repeated, mirrored) =
            (twice_as_fine(&map, true).unwrap(), twice_as_fine(&map, false).unwrap());
        for (iy, ix) in [(8, 8), (9, 14), (13, 11)] {
            let at = |shift: f64| {
                let [y, x] = [iy, ix].map(|i| 0.5 * i as f64 - shift);
                0.3 * y - 0.2 * x
            };
            assert!((repeated.at(iy, ix) - at(0.0)).abs() < 1e-12);
            assert!((mirrored.at(iy, ix) - at(0.25)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_step_does_not_overshoot_and_smooth_waves_are_followed() {
        let step = square(|y, x| if y > 5.0 && x > 7.0 { 1.0 } else { 0.0 });
        for repeats in [true, false] {
            let (low, high) = twice_as_fine(&step, repeats).unwrap().range();
            assert!(low.abs() < 1e-12 && (high - 1.0).abs() < 1e-12, "{low} {high}");
        }
        let q = std::f64::consts::TAU / 16.0;
        let fine = twice_as_fine(&square(|y, x| (q * (x - 2.0 * y)).sin()), true).unwrap();
        let error = |i: usize| {
            let (y, x) = ((i / 32) as f64 / 2.0, (i % 32) as f64 / 2.0);
            (fine.heights()[i] - (q * (x - 2.0 * y)).sin()).abs()
        };
        let worst = (0..fine.grid().len()).map(error).fold(0.0, f64::max);
        assert!(worst < 0.08, "{worst}");
    }
}
