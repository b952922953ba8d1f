//! What waves make of a map between its points, over what the nearest points say.
//!
//! The waves of a map that has creases, steps or cusps anywhere ring: their sum swings about the surface from point to
//! point, the less the farther away, and more than a light load deforms it where that is on smooth tops. The polynomial through eight points in
//! line knows nothing of what lies farther off. On a map that is band-limited in truth both are the same.

use crate::budget::same_place;
use crate::continuation::regrid;
use crate::monotone::inside;
use contact_types::{Grid, HeightMap};
use surface_stats::StatsError;

/// Points of a polynomial along each axis.
const POINTS: usize = 8;

/// A map and its waves on twice as many points along each side.
pub(crate) struct Ringing<'a> {
    map: &'a HeightMap,
    finer: HeightMap,
    repeats: bool,
}

impl<'a> Ringing<'a> {
    /// One transform, of the map as it is continued: by itself if it `repeats`, by its mirror images otherwise.
    pub(crate) fn of(map: &'a HeightMap, repeats: bool) -> Result<Self, StatsError> {
        let finer = regrid(map, map.grid().shape().map(|n| 2 * n), repeats)?;
        Ok(Self { map, finer, repeats })
    }

    /// Rms difference of both ways to interpolate (m) where something touches under `pressure`, which stands on `grid`, of
    /// the same area; 0 where nothing does.
    pub(crate) fn at(&self, pressure: &[f64], grid: Grid) -> f64 {
        let nx = self.map.grid().shape()[1];
        // The points of the finer map stand beside one of the map, or on it.
        let places = if self.repeats { [0.0, 0.5] } else { [-0.25, 0.25] };
        let weights = places.map(weights);
        let (mut squares, mut count) = (0.0, 0.0);
        for i in 0..self.map.grid().len() {
            let (y, x) = (i / nx, i % nx);
            let there = same_place(i, self.map.grid(), grid);
            if pressure.get(there).is_none_or(|p| *p <= 0.0) {
                continue;
            }
            for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let height = self.polynomial([y, x], [&weights[a], &weights[b]]);
                let difference = self.finer.at(2 * y + a, 2 * x + b) - height;
                squares += difference * difference;
                count += 1.0;
            }
        }
        f64::sqrt(squares / f64::max(count, 1.0))
    }

    /// Through eight points in line along x, and through eight of these along y.
    fn polynomial(&self, [y, x]: [usize; 2], [wy, wx]: [&[f64; POINTS]; 2]) -> f64 {
        let [ny, nx] = self.map.grid().shape();
        let offset = |k: usize| k.cast_signed() - 3;
        let along_x = |y: usize| -> f64 {
            let at = |k: usize| self.map.at(y, inside(x, offset(k), nx, self.repeats));
            wx.iter().enumerate().filter(|(_, w)| **w != 0.0).map(|(k, w)| w * at(k)).sum()
        };
        let row = |k: usize| along_x(inside(y, offset(k), ny, self.repeats));
        wy.iter().enumerate().filter(|(_, w)| **w != 0.0).map(|(k, w)| w * row(k)).sum()
    }
}

/// Weights of the points -3 to 4 at `t`.
fn weights(t: f64) -> [f64; POINTS] {
    let node = |k: usize| k as f64 - 3.0;
    std::array::from_fn(|k| {
        let others = (0..POINTS).filter(|j| *j != k);
        others.map(|j| (t - node(j)) / (node(k) - node(j))).product()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn map(n: usize, height: impl Fn(f64, f64) -> f64) -> HeightMap {
        let pixel = 1.0 / n as f64;
        HeightMap::from_fn(Grid::new([n, n], [pixel, pixel]).unwrap(), height).unwrap()
    }

    /// Waves of ten points and more ring by less than a ten-thousandth of their height; cusps between spheres do.
    #[test]
    fn waves_do_not_ring_and_cusps_between_tops_do() {
        let waves = map(64, |y, x| (TAU * (5.0 * x + 2.0 * y)).cos() + (TAU * 6.0 * y).sin());
        let all = vec![1.0; 64 * 64];
        let found = Ringing::of(&waves, true).unwrap().at(&all, waves.grid());
        assert!(found < 1e-4, "{found:e}");
        let off = |s: f64| 4.0 * s - (4.0 * s).floor() - 0.5;
        let spheres = map(64, |y, x| (1.0 - off(y).powi(2) - off(x).powi(2)).sqrt());
        let top = spheres.range().1 - 1e-3;
        let tops: Vec<f64> = spheres.heights().iter().map(|z| (z - top).max(0.0)).collect();
        for repeats in [true, false] {
            let ringing = Ringing::of(&spheres, repeats).unwrap();
            let found = ringing.at(&tops, spheres.grid());
            assert!(found > 1e-4, "{repeats} {found:e}");
            // The same contact on a finer grid.
            let finer: Vec<f64> =
                (0..128 * 128).map(|i| tops[i / 256 * 64 + i % 128 / 2]).collect();
            let grid = ringing.finer.grid();
            assert!((ringing.at(&finer, grid) - found).abs() < 1e-12);
            assert!(ringing.at(&vec![0.0; 64 * 64], spheres.grid()).abs() < 1e-300);
        }
    }

    /// Points of a cubic surface are found wherever they stand.
    #[test]
    fn polynomial_is_exact_for_cubics() {
        let cubic = |y: f64, x: f64| 1.0 + x - 2.0 * x * x * x + x * y * y;
        let surface = map(32, cubic);
        let ringing = Ringing::of(&surface, false).unwrap();
        for (ty, tx) in [(0.25, -0.25), (0.0, 0.5), (-0.25, 0.25)] {
            let found = ringing.polynomial([15, 17], [&weights(ty), &weights(tx)]);
            let exact = cubic((15.0 + ty) / 32.0, (17.0 + tx) / 32.0);
            assert!((found - exact).abs() < 1e-12, "{found} {exact}");
        }
    }
}
