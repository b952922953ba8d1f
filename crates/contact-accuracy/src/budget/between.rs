//! What lies between the points: how far ways to interpolate differ where the surface touches.
//!
//! A map fixes a surface at its points. Where it is smooth from point to point, every sensible way to
//! go from one to the next leads over the same heights. On the rim of a worn or clipped top, at a
//! crease or a spike, it does not: a trigonometric interpolant rings, a cubic one rounds, and the
//! light load is carried by what they differ in. Halfway between two neighbours the polynomial
//! through eight points in line and that through four tell the two apart (no transform, and only
//! where something touches). Their difference is a length; against it stands how far a pixel's worth
//! of load deforms the surface, `(mean real pressure / E*) x pixel`. The ratio is the *doubt*.
//!
//! A share of the whole map, such as the gradient that differences see, does not find flat tops: they
//! are a few per cent of it.

use super::bend::{self, Bend};
use crate::monotone::inside;
use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::Solution;
use std::f64::consts::PI;

/// Doubt above which the bar of the grid is not known to hold.
pub const MOST_DOUBT: f64 = 0.05;

/// Share of the points from which on it matters how sharp what does not touch is.
const MOST_TOUCHES: f64 = 0.6;
/// Part of the mean pressure that is little.
const LITTLE: f64 = 0.3;

/// How much the interpolants differ at the contact of one solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Between {
    /// Rms difference halfway between neighbours, of which at least one touches (m).
    pub height: f64,
    /// The same where only one of the two touches, along the contact line (m).
    pub at_line: f64,
    /// Mean over the map of the signed difference halfway between neighbours that do not both touch (m):
    /// what creases in the valleys do to the gap.
    pub open: f64,
    /// What a pixel's worth of load deforms, (mean real pressure / E*) x pixel (m).
    pub deformed: f64,
    /// In full contact, the largest share of the pressure that the difference may take off: as a wave
    /// of two points it carries E* (pi/2) / pixel times its height (Johnson 1985, section 13.2). 0
    /// where something is open.
    pub lifted: f64,
    /// Share of the map that touches so lightly that such a wave would take it off (-).
    pub light: f64,
    /// How sharply the heights bend there.
    pub bend: Bend,
    /// Where most touches and what does not is creased: share of the map that touches under little of the mean pressure (-).
    /// Slits may stay open there that the points do not show. Else 0.
    pub slits: f64,
}

/// Difference of the polynomials through eight and through four points, halfway: weights of the
/// pairs of points from the inner to the outer one.
const WEIGHTS: [f64; 4] =
    [1225.0 / 2048.0 - 9.0 / 16.0, 1.0 / 16.0 - 245.0 / 2048.0, 49.0 / 2048.0, -5.0 / 2048.0];

impl Between {
    /// Of a `surface` under `pressure` (Pa, of its grid). Beyond its edges stands itself if it
    /// `repeats`, its mirror image otherwise. `None` if nothing touches, the pressure is not of this
    /// grid, or a side has fewer than eight points.
    pub fn of(
        surface: &HeightMap,
        repeats: bool,
        pressure: &[f64],
        modulus: ContactModulus,
    ) -> Option<Self> {
        let [ny, nx] = surface.grid().shape();
        if pressure.len() != surface.grid().len() || ny.min(nx) < 8 {
            return None;
        }
        let [dy, dx] = surface.grid().pixel();
        let (mut touching, mut load) = (0.0, 0.0);
        // Squares and their number, at the contact and at its line.
        let (mut all, mut line) = ([0.0; 2], [0.0; 2]);
        // The largest share of the pressure that a difference may take off where both touch.
        let (mut lifted, mut light) = (0.0f64, 0.0);
        // Of the whole map, less what lies between two points that touch.
        let mut open = sum_over(surface, repeats);
        let lift = 0.5 * PI * modulus.pascals() / dy.min(dx);
        let mut add = |difference: f64, pressures: [f64; 2]| {
            let least = pressures[0].min(pressures[1]);
            let square = difference * difference;
            all = [all[0] + square, all[1] + 1.0];
            if least > 0.0 {
                open -= difference;
                let share = lift * difference.abs() / least;
                lifted = lifted.max(share);
                light += f64::from(u8::from(share > 1.0));
            } else {
                line = [line[0] + square, line[1] + 1.0];
            }
        };
        let heights = surface.heights();
        let mut bends = bend::Sum::default();
        // Halfway to both neighbours along x, then along y; between two that touch only once.
        for (i, &p) in pressure.iter().enumerate().filter(|(_, p)| **p > 0.0) {
            touching += 1.0;
            load += p;
            let (iy, ix) = (i / nx, i % nx);
            bends.add(surface, i, repeats);
            for step in [0, -1] {
                let along = |k| heights[iy * nx + inside(ix, k + step, nx, repeats)];
                let next = pressure[iy * nx + inside(ix, 1 + 2 * step, nx, repeats)];
                if step == 0 || (next <= 0.0 && (repeats || ix > 0)) {
                    add(difference(along), [p, next]);
                }
                let along = |k| heights[inside(iy, k + step, ny, repeats) * nx + ix];
                let next = pressure[inside(iy, 1 + 2 * step, ny, repeats) * nx + ix];
                if step == 0 || (next <= 0.0 && (repeats || iy > 0)) {
                    add(difference(along), [p, next]);
                }
            }
        }
        if load <= 0.0 {
            return None;
        }
        let [height, at_line] = [all, line].map(|[sum, count]| (sum / f64::max(count, 1.0)).sqrt());
        let deformed = load / touching / modulus.pascals() * dy.min(dx);
        let lifted = if line[1] > 0.0 { 0.0 } else { lifted };
        let midpoints = 2.0 * surface.grid().len() as f64;
        let (open, light) = (open / midpoints, light / midpoints);
        let bend = bends.bend(line[1])?;
        let slits = slits(surface, repeats, pressure, [touching, load]);
        Some(Self { height, at_line, open, deformed, lifted, light, bend, slits })
    }

    /// The same of a `solution` on another `grid` of the same area: what the given points say at its
    /// contact.
    pub fn on_points_of(
        surface: &HeightMap,
        repeats: bool,
        solution: &Solution,
        grid: Grid,
        modulus: ContactModulus,
    ) -> Option<Self> {
        if grid == surface.grid() {
            return Self::of(surface, repeats, &solution.pressure, modulus);
        }
        if solution.pressure.len() != grid.len() {
            return None;
        }
        let there = |i: usize| solution.pressure[same_place(i, surface.grid(), grid)];
        let pressure: Vec<f64> = (0..surface.grid().len()).map(there).collect();
        Self::of(surface, repeats, &pressure, modulus)
    }

    /// Doublings of the points until the doubt is small, if each halves it.
    pub fn doublings(&self) -> f64 {
        (self.doubt() / MOST_DOUBT).log2().max(0.0)
    }

    /// Whether the bar of the grid is known to hold.
    pub fn is_small(&self) -> bool {
        self.doubt() <= MOST_DOUBT
    }

    /// The difference over what a pixel's worth of load deforms: at the contact or along its line,
    /// whichever is larger (-). In a large contact the line alone is open, and its part of all is
    /// small. Full contact is in doubt where the difference may lift it off.
    pub fn doubt(&self) -> f64 {
        (self.height.max(self.at_line) / self.deformed).max(MOST_DOUBT * self.lifted)
    }
}

/// Index of the point of `on`, a grid of the same area, that stands for point `i` of `given`.
pub(crate) fn same_place(i: usize, given: Grid, on: Grid) -> usize {
    let ([ny, nx], [my, mx]) = (given.shape(), on.shape());
    i / nx * my / ny * mx + i % nx * mx / nx
}

/// [`Between::slits`], of so many points that touch and the sum of their pressures.
fn slits(surface: &HeightMap, repeats: bool, pressure: &[f64], [touching, load]: [f64; 2]) -> f64 {
    let points = surface.grid().len() as f64;
    if touching < MOST_TOUCHES * points {
        return 0.0;
    }
    let little = LITTLE * load / points;
    let (mut bends, mut pressed) = (bend::Sum::default(), 0.0);
    for (i, &p) in pressure.iter().enumerate().filter(|(_, p)| **p < little) {
        bends.add(surface, i, repeats);
        pressed += f64::from(u8::from(p > 0.0));
    }
    if bends.is_creased() { pressed / points } else { 0.0 }
}

/// Difference of the interpolants between the points 0 and 1 of a line.
fn difference(at: impl Fn(isize) -> f64) -> f64 {
    let pairs = WEIGHTS.iter().enumerate();
    pairs.map(|(k, weight)| weight * (at(-k.cast_signed()) + at(k.cast_signed() + 1))).sum()
}

/// Sum of the differences halfway to the next point along x and along y, over the whole map. The weights
/// of a point add up to nothing but near an edge that mirrors.
fn sum_over(surface: &HeightMap, repeats: bool) -> f64 {
    let [ny, nx] = surface.grid().shape();
    let column = |(ix, w): (usize, f64)| w * (0..ny).map(|iy| surface.at(iy, ix)).sum::<f64>();
    let row = |(iy, w): (usize, f64)| w * (0..nx).map(|ix| surface.at(iy, ix)).sum::<f64>();
    let x: f64 = weights_of_line(nx, repeats).into_iter().map(column).sum();
    let y: f64 = weights_of_line(ny, repeats).into_iter().map(row).sum();
    x + y
}

/// How often the sum of all differences along a line counts each of its `n` points, those left out that it
/// counts as nothing.
fn weights_of_line(n: usize, repeats: bool) -> Vec<(usize, f64)> {
    if repeats {
        return Vec::new();
    }
    let reach = WEIGHTS.len();
    let mut weights = vec![0.0; n];
    // All differences, but those that see no edge, whose weights cancel once all are added.
    for i in 0..n {
        for (k, weight) in WEIGHTS.iter().enumerate() {
            weights[inside(i, -k.cast_signed(), n, false)] += weight;
            weights[inside(i, k.cast_signed() + 1, n, false)] += weight;
        }
    }
    let near = |i: &usize| *i < 2 * reach || *i + 2 * reach >= n;
    (0..n).filter(near).map(|i| (i, weights[i])).collect()
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
        assert!(
            difference(|k| {
                let x = k as f64;
                3.0 - x + 2.0 * x * x - x * x * x
            })
            .abs()
                < 1e-12
        );
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
    fn doubt_is_the_difference_over_a_pixel_of_deformation() {
        let grid = Grid::new([16, 16], [2e-6, 2e-6]).unwrap();
        let q = TAU / (4.0 * 2e-6);
        let map = HeightMap::from_fn(grid, |_, x| 1e-7 * (q * x).cos()).unwrap();
        let mut pressure = vec![0.0; 256];
        pressure[8 * 16 + 4] = 0.05;
        let found = Between::of(&map, true, &pressure, modulus()).unwrap();
        assert!((found.height - found.at_line).abs() < 1e-20);
        // To both sides of a crest 1, 0, -1, 0, 1 the difference is that of the sums of pairs.
        let [a, b, c, d] = WEIGHTS;
        let one = 1e-7 * (a - b - c + d);
        assert!((found.height / (one.abs() / 2f64.sqrt()) - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.doubt() / (found.height / (0.05 * 2e-6)) - 1.0).abs() < 1e-12);
        assert_eq!(Between::of(&map, true, &vec![0.0; 256], modulus()), None);
        assert_eq!(Between::of(&map, true, &[], modulus()), None);
    }

    /// The sums over the points that touch are those over all pairs of neighbours.
    #[test]
    fn open_gap_is_that_of_a_walk_over_all_pairs() {
        let grid = Grid::new([19, 24], [1.0, 1.0]).unwrap();
        let rough = |y: f64, x: f64| (7.3 * y * y + 3.1 * x).sin() + 0.01 * x * y;
        let map = HeightMap::from_fn(grid, rough).unwrap();
        for (repeats, lowest) in [(true, 0.0), (false, 0.0), (false, 0.9), (false, -3.0)] {
            let pressure: Vec<f64> = map.heights().iter().map(|z| (z - lowest).max(0.0)).collect();
            let (mut open, mut squares, mut count, mut light) = (0.0, 0.0, 0.0, 0.0);
            for (i, &p) in pressure.iter().enumerate() {
                let (iy, ix) = (i / 24, i % 24);
                let right = difference(|k| map.at(iy, inside(ix, k, 24, repeats)));
                let below = difference(|k| map.at(inside(iy, k, 19, repeats), ix));
                let there = [
                    (right, pressure[iy * 24 + inside(ix, 1, 24, repeats)]),
                    (below, pressure[inside(iy, 1, 19, repeats) * 24 + ix]),
                ];
                for (difference, other) in there {
                    open += if p.min(other) > 0.0 { 0.0 } else { difference };
                    let lifts = 0.5 * PI * difference.abs() > p.min(other) && p.min(other) > 0.0;
                    light += if lifts { 1.0 } else { 0.0 };
                    if p.max(other) > 0.0 {
                        (squares, count) = (squares + difference * difference, count + 1.0);
                    }
                }
            }
            let found = Between::of(&map, repeats, &pressure, modulus()).unwrap();
            assert!((found.open - open / (2.0 * 19.0 * 24.0)).abs() < 1e-14, "{found:?}");
            assert!((found.height - f64::sqrt(squares / count)).abs() < 1e-13, "{found:?}");
            assert!((found.light - light / (2.0 * 19.0 * 24.0)).abs() < 1e-12, "{found:?} {light}");
            assert!(light > 0.0 || lowest.abs() > 0.5);
        }
    }

    /// A map that does not repeat is continued by its mirror image: its seam is no crease.
    #[test]
    fn the_seam_of_a_tilted_map_is_no_doubt_unless_it_repeats() {
        let grid = Grid::new([16, 16], [1.0, 1.0]).unwrap();
        let map = HeightMap::from_fn(grid, |_, x| 0.01 * x).unwrap();
        let all = vec![0.1; 256];
        let repeated = Between::of(&map, true, &all, modulus()).unwrap();
        let mirrored = Between::of(&map, false, &all, modulus()).unwrap();
        assert!(mirrored.height < 0.1 * repeated.height, "{mirrored:?} {repeated:?}");
    }
}
