//! How sharply a surface bends where it touches: from one point to the next, and from one to the second next.
//!
//! A smooth surface bends four times as much over twice the distance, a crease twice as much. Peaks stand beside
//! the points by up to half a pixel, by a height that is part of the bend.

use crate::monotone::inside;
use contact_types::HeightMap;
use fft_bem_solver::BOUNDARY_CORRECTION;

/// [Growth](Bend::growth) below which creases carry the load. Where waves do that pass the gate it is 2.7 or more, mostly
/// above 3.5.
const LEAST_GROWTH: f64 = 3.0;

/// Bend of the heights at the contact of one solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Bend {
    /// Rms second difference of the heights to both neighbours, along x and along y, where something touches (m).
    pub height: f64,
    /// The same to the second neighbours, over that (-): 4 where the surface is smooth, 2 on a crease, 1 where every
    /// point stands for itself.
    pub growth: f64,
    /// Correction for the contact line over the corrected area (-), 0 without a line.
    pub share: f64,
}

impl Bend {
    /// Whether creases or single points carry the load. What touches there is one or two points wide on any grid that does
    /// not resolve them: the finer the grid, the less of it.
    pub fn is_creased(&self) -> bool {
        self.growth < LEAST_GROWTH
    }
}

/// Sums for it, over the points that touch.
#[derive(Default)]
pub(super) struct Sum {
    points: f64,
    near: f64,
    far: f64,
}

impl Sum {
    /// Adds point `i` of a `surface`. Beyond its edges stands itself if it `repeats`, its mirror image otherwise.
    pub(super) fn add(&mut self, surface: &HeightMap, i: usize, repeats: bool) {
        let [ny, nx] = surface.grid().shape();
        let (y, x) = (i / nx, i % nx);
        let inside = |i, k, n| inside(i, k, n, repeats);
        let bend = |k: isize| {
            let twice = 2.0 * surface.at(y, x);
            let along_y = surface.at(inside(y, k, ny), x) + surface.at(inside(y, -k, ny), x);
            let along_x = surface.at(y, inside(x, k, nx)) + surface.at(y, inside(x, -k, nx));
            (along_y - twice).powi(2) + (along_x - twice).powi(2)
        };
        self.points += 1.0;
        self.near += bend(1);
        self.far += bend(2);
    }

    /// Whether the points are creased, as [`Bend::is_creased`] says; no points are not.
    pub(super) fn is_creased(&self) -> bool {
        self.bend(0.0).is_some_and(|bend| bend.is_creased())
    }

    /// The bend, with so many edges of the contact line; `None` of no points.
    pub(super) fn bend(&self, edges: f64) -> Option<Bend> {
        let correction = BOUNDARY_CORRECTION * edges;
        (self.points > 0.0).then(|| Bend {
            height: (0.5 * self.near / self.points).sqrt(),
            growth: if self.near > 0.0 { (self.far / self.near).sqrt() } else { f64::INFINITY },
            share: correction / (self.points - correction),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    fn of(height: impl Fn(f64, f64) -> f64) -> Bend {
        let grid = Grid::new([20, 20], [1.0, 1.0]).unwrap();
        let map = HeightMap::from_fn(grid, height).unwrap();
        let mut sum = Sum::default();
        (4..16).for_each(|y| sum.add(&map, 20 * y + 10, true));
        sum.bend(0.0).unwrap()
    }

    #[test]
    fn bend_of_a_parabola_a_crease_and_noise() {
        let parabola = of(|y, x| -0.5 * (y * y + x * x));
        assert!((parabola.height - 1.0).abs() < 1e-12 && (parabola.growth - 4.0).abs() < 1e-12);
        assert!(!parabola.is_creased());
        let crease = of(|_, x| -(x - 10.0).abs());
        assert!((crease.growth - 2.0).abs() < 1e-12 && crease.is_creased());
        let noise = of(|y, x| (97.0 * y * y + 41.0 * x * x + 13.0 * x * y).sin());
        assert!((0.5..1.6).contains(&noise.growth), "{noise:?}");
        assert!(of(|y, x| y + x).growth.is_infinite());
        assert!(Sum::default().bend(1.0).is_none());
    }
}
