//! Interpolation-sensitivity indicator: how far two ways to interpolate differ where the surface touches.
//!
//! Halfway between neighbours the polynomials through eight and through four points in line are compared. Their
//! rms difference, at the contact or along its line, is divided by how far a pixel's worth of load deforms the
//! surface, `(mean real pressure / E*) × pixel`.
//!
//! In full contact a difference matters where it may lift the surface off: as a wave of two points it carries
//! `E* (π/2) / pixel` times its height (Johnson 1985, *Contact Mechanics*, section 13.2).

use contact_types::{ContactModulus, HeightMap};
use std::f64::consts::PI;

/// The indicator above which the answer depends on what lies between the points.
pub const LIMIT: f64 = 0.05;

/// Difference of the polynomials through eight and through four points, halfway: weights of the pairs of points
/// from the inner to the outer one, in 2048ths.
const WEIGHTS: [i16; 4] = [1225 - 1152, -245 + 128, 49, -5];

/// The indicator of a `surface` under `pressure` (Pa, of its grid). Beyond its edges stands itself if it
/// `repeats`, its mirror image otherwise. `None` if nothing touches, the pressure is not of this grid, or a side
/// has fewer than eight points.
pub(crate) fn indicator(
    surface: &HeightMap,
    repeats: bool,
    pressure: &[f64],
    modulus: ContactModulus,
) -> Option<f64> {
    let [ny, nx] = surface.grid().shape();
    if pressure.len() != surface.grid().len() || ny.min(nx) < 8 {
        return None;
    }
    let [dy, dx] = surface.grid().pixel();
    let lift = 0.5 * PI * modulus.pascals() / dy.min(dx);
    let heights = surface.heights();
    let (mut touching, mut load) = (0.0, 0.0);
    // Sums of squares and their number, at the contact and at its line.
    let (mut all, mut line) = ([0.0; 2], [0.0; 2]);
    let mut lifted = 0.0f64; // the largest share of the pressure that a difference may take off
    let mut add = |difference: f64, least: f64| {
        let square = difference * difference;
        all = [all[0] + square, all[1] + 1.0];
        if least > 0.0 {
            lifted = lifted.max(lift * difference.abs() / least);
        } else {
            line = [line[0] + square, line[1] + 1.0];
        }
    };
    // Halfway to both neighbours along x, then along y; between two that touch only once.
    for (i, &p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
        touching += 1.0;
        load += p;
        let (iy, ix) = (i / nx, i % nx);
        for step in [0, -1] {
            let along = |k| heights[iy * nx + inside(ix, k + step, nx, repeats)];
            let next = pressure[iy * nx + inside(ix, 1 + 2 * step, nx, repeats)];
            if step == 0 || (next <= 0.0 && (repeats || ix > 0)) {
                add(difference(along), p.min(next));
            }
            let along = |k| heights[inside(iy, k + step, ny, repeats) * nx + ix];
            let next = pressure[inside(iy, 1 + 2 * step, ny, repeats) * nx + ix];
            if step == 0 || (next <= 0.0 && (repeats || iy > 0)) {
                add(difference(along), p.min(next));
            }
        }
    }
    if load <= 0.0 {
        return None;
    }
    let rms = |[sum, count]: [f64; 2]| (sum / f64::max(count, 1.0)).sqrt();
    let deformed = load / touching / modulus.pascals() * dy.min(dx);
    let lifted = if line[1] > 0.0 { 0.0 } else { lifted };
    Some((rms(all).max(rms(line)) / deformed).max(LIMIT * lifted))
}

/// Difference of the interpolants between the points 0 and 1 of a line.
fn difference(at: impl Fn(isize) -> f64) -> f64 {
    let pairs = WEIGHTS.iter().enumerate();
    let pair = |k: isize| at(-k) + at(k + 1);
    let sum: f64 = pairs.map(|(k, weight)| f64::from(*weight) * pair(k.cast_signed())).sum();
    sum / f64::from(2048_i16)
}

/// The point `k` away from `i` of `n` in line: around the edge if the map `repeats`, mirrored at it otherwise.
fn inside(i: usize, k: isize, n: usize, repeats: bool) -> usize {
    let (i, n) = (i.cast_signed() + k, n.cast_signed());
    if (0..n).contains(&i) {
        return i.cast_unsigned(); // most are, and a division takes longer than all else here
    }
    let j = if repeats { i.rem_euclid(n) } else { i.rem_euclid(2 * n) };
    (if j < n { j } else { 2 * n - 1 - j }).cast_unsigned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    fn modulus() -> ContactModulus {
        ContactModulus::from_pascals(1.0).unwrap()
    }

    /// Both interpolants are exact for cubics; of a wave they differ by what their symbols say.
    #[test]
    fn difference_of_the_interpolants_of_a_cubic_and_of_a_wave() {
        let cubic = |k: isize| {
            let x = k as f64;
            3.0 - x + 2.0 * x * x - x * x * x
        };
        assert!(difference(cubic).abs() < 1e-12);
        for pixels in [3.0, 5.0, 12.0] {
            let q = TAU / pixels;
            let halfway = |k: f64| (q * (k - 0.5)).cos();
            let four = (9.0 * 2.0 * (0.5 * q).cos() - 2.0 * (1.5 * q).cos()) / 16.0;
            let eight = (1225.0 * (0.5 * q).cos() - 245.0 * (1.5 * q).cos()
                + 49.0 * (2.5 * q).cos()
                - 5.0 * (3.5 * q).cos())
                / 1024.0;
            let found = difference(|k| halfway(k as f64));
            assert!((found - (eight - four)).abs() < 1e-12, "{pixels}: {found}");
        }
    }

    /// One point of pressure p touches, on a wave along x: four midpoints, two of them along x.
    #[test]
    fn indicator_is_the_difference_over_a_pixel_of_deformation() {
        let grid = Grid::new([16, 16], [2e-6, 2e-6]).unwrap();
        let q = TAU / (4.0 * 2e-6);
        let map = HeightMap::from_fn(grid, |_, x| 1e-7 * (q * x).cos()).unwrap();
        let mut pressure = vec![0.0; 256];
        pressure[8 * 16 + 4] = 0.05;
        // To both sides of a crest 1, 0, -1, 0, 1 the difference is that of the sums of pairs.
        let [a, b, c, d] = WEIGHTS.map(|weight| f64::from(weight) / 2048.0);
        let rms = (1e-7 * (a - b - c + d)).abs() / 2f64.sqrt();
        let found = indicator(&map, true, &pressure, modulus()).unwrap();
        assert!((found / (rms / (0.05 * 2e-6)) - 1.0).abs() < 1e-9, "{found}");
        assert_eq!(indicator(&map, true, &vec![0.0; 256], modulus()), None);
        assert_eq!(indicator(&map, true, &[], modulus()), None);
    }

    /// A map that does not repeat is continued by its mirror image: its edges are no crease.
    #[test]
    fn the_edges_of_a_tilted_map_count_only_if_it_repeats() {
        let grid = Grid::new([16, 16], [1.0, 1.0]).unwrap();
        let map = HeightMap::from_fn(grid, |_, x| 0.01 * x).unwrap();
        let all = vec![0.1; 256];
        let of = |repeats| indicator(&map, repeats, &all, modulus()).unwrap();
        assert!(of(false) < 0.1 * of(true), "{} {}", of(false), of(true));
    }
}
