//! Which grids a map can be solved on, and what is known of each before solving.

use crate::budget::{AreaAccuracy, Map};
use crate::continuation::{regrid, window_for};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::Boundary;
use std::borrow::Cow;
use std::f64::consts::{PI, TAU};
use surface_stats::StatsError;
use surface_stats::spectrum::PowerSpectrum;

/// Points along a side over those of the given map.
const FACTORS: [f64; 11] = [0.125, 0.1875, 0.25, 0.375, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0];
/// Fewest points along a side of a coarsened map, and of a map that is refined.
const FEWEST: [usize; 2] = [48, 8];
/// Most points a refined map may have: 4096 x 4096.
pub const MOST_POINTS: usize = 1 << 24;
/// Longest pixels over their width that the bars were studied for.
const LONGEST_PIXEL: f64 = 2.0;

/// A grid the map can be solved on.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Candidate {
    /// Points along a side over those of the given map, about.
    pub factor: f64,
    /// The grid.
    pub grid: Grid,
    /// Part of the rms gradient that this grid cannot hold (-).
    pub lost: f64,
    /// Whether this grid resolves the waves it holds, and what a contact line on it leaves.
    pub accuracy: AreaAccuracy,
}

/// What can be said of a map before solving.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidates {
    /// From coarse to fine; the given grid is one of them.
    pub list: Vec<Candidate>,
    /// Index of the given grid.
    pub given: usize,
    /// Whether a map put on another grid is continued by itself; by its mirror images if opposite
    /// edges do not meet, or if the contact is isolated.
    continued: bool,
}

impl Candidates {
    /// One transform of the map, of which `known` tells the rest.
    ///
    /// # Errors
    /// [`StatsError`].
    pub fn of(map: &HeightMap, known: &Map, boundary: Boundary) -> Result<Self, StatsError> {
        let grid = map.grid();
        let power = PowerSpectrum::of(map, window_for(known.repeats))?;
        let mut list: Vec<Held> =
            FACTORS.iter().filter_map(|&factor| Held::new(grid, factor)).collect();
        let all = add_up(&power, grid, &mut list);
        if all <= 0.0 {
            list.retain(|held| held.grid == grid); // a flat map is the same on any grid
        }
        let on_given = known.accuracy.with_boundary(boundary);
        let candidates = list.iter().map(|held| held.candidate(all, &on_given)).collect();
        let given = list.iter().position(|h| h.grid == grid).unwrap_or(0);
        let continued = known.repeats && boundary == Boundary::Periodic;
        Ok(Self { list: candidates, given, continued })
    }

    /// The given grid.
    pub fn as_given(&self) -> &Candidate {
        &self.list[self.given]
    }

    /// Whether a map put on another grid is continued by itself.
    pub(super) fn is_continued(&self) -> bool {
        self.continued
    }

    /// The map on one of the grids.
    ///
    /// # Errors
    /// [`StatsError`].
    pub fn map<'a>(
        &self,
        map: &'a HeightMap,
        on: &Candidate,
    ) -> Result<Cow<'a, HeightMap>, StatsError> {
        let shape = on.grid.shape();
        Ok(if on.grid == map.grid() {
            Cow::Borrowed(map)
        } else {
            Cow::Owned(regrid(map, shape, self.continued)?)
        })
    }
}

/// A grid while the waves it can hold are added up.
struct Held {
    factor: f64,
    grid: Grid,
    /// Highest wavenumber it can hold along y and x (rad/m); infinite if it holds all.
    limit: [f64; 2],
    /// Mean square gradient: of the waves it holds, and of what forward differences see of them.
    all: f64,
    seen: f64,
}

impl Held {
    fn new(given: Grid, factor: f64) -> Option<Self> {
        let is_given = (factor - 1.0).abs() < 1e-12;
        let [ny, nx] = given.shape();
        let [dy, dx] = given.pixel();
        let shape = if is_given { [ny, nx] } else { [ny, nx].map(|n| fast(factor * n as f64)) };
        let [coarsened, refined] = FEWEST;
        let studied = ny.min(nx) >= refined && dy.max(dx) <= LONGEST_PIXEL * dy.min(dx);
        let fits = if factor < 1.0 {
            shape[0].min(shape[1]) >= coarsened && shape[0] < ny && shape[1] < nx
        } else {
            shape[0].saturating_mul(shape[1]) <= MOST_POINTS && shape[0] > ny && shape[1] > nx
        };
        if !(is_given || studied && fits) {
            return None;
        }
        let [ly, lx] = given.size();
        let pixel = if is_given { [dy, dx] } else { [ly / shape[0] as f64, lx / shape[1] as f64] };
        let grid = Grid::new(shape, pixel).ok()?;
        // A coarser grid cannot hold the wave of two of its pixels.
        let limit = if factor < 1.0 { pixel.map(|d| PI / d * (1.0 - 1e-9)) } else { [f64::MAX; 2] };
        Some(Self { factor, grid, limit, all: 0.0, seen: 0.0 })
    }

    /// Adds the waves with this component along an axis.
    fn add(&mut self, axis: usize, q: f64, variance: f64) {
        let pixel = self.grid.pixel()[axis];
        let difference = 2.0 * (0.5 * q * pixel).sin() / pixel;
        self.all += variance * q * q;
        self.seen += variance * difference * difference;
    }

    /// `all` is the mean square gradient of the map. A step of its heights counts against the pixels
    /// it was measured on, those of the given grid.
    fn candidate(&self, all: f64, given: &AreaAccuracy) -> Candidate {
        let ratio = |a: f64, b: f64| if b > 0.0 { (a / b).sqrt() } else { 1.0 };
        let mut accuracy = given.on(self.grid);
        accuracy.resolution = ratio(self.seen, self.all);
        let lost = (1.0 - ratio(self.all, all)).max(0.0);
        Candidate { factor: self.factor, grid: self.grid, lost, accuracy }
    }
}

/// Adds the waves of a map up for every grid; answers with the mean square gradient.
///
/// A wave belongs to the coarsest grid that can hold it, and all finer ones hold it too; what
/// counts of it on each are its components along the axes. So variances are summed over those
/// first, and the sine of each component is taken once per grid and not once per wave.
fn add_up(power: &PowerSpectrum, grid: Grid, list: &mut [Held]) -> f64 {
    let limits: Vec<[f64; 2]> = list.iter().filter(|h| h.factor < 1.0).map(|h| h.limit).collect();
    let step = grid.size().map(|length| TAU / length);
    let none = grid.shape().map(|n| vec![0.0; n / 2 + 1]);
    let mut sums = vec![none; limits.len() + 1];
    power.for_each(|q, weight, variance| {
        let holds = |limit: &[f64; 2]| q[0].abs() < limit[0] && q[1].abs() < limit[1];
        let class = limits.iter().position(holds).unwrap_or(limits.len());
        for axis in 0..2 {
            let component = (q[axis].abs() / step[axis]).round() as usize;
            sums[class][axis][component] += weight * variance;
        }
    });
    let mut all = 0.0;
    for (class, sums) in sums.iter().enumerate() {
        for axis in 0..2 {
            for (component, variance) in sums[axis].iter().enumerate() {
                let q = component as f64 * step[axis];
                all += variance * q * q;
                for held in &mut list[class..] {
                    held.add(axis, q, *variance);
                }
            }
        }
    }
    all
}

/// The smallest even number not below `n` with no prime factor above 7: its transforms are fast.
fn fast(n: f64) -> usize {
    let smooth = |mut m: usize| {
        for p in [2, 3, 5, 7] {
            while m.is_multiple_of(p) {
                m /= p;
            }
        }
        m == 1
    };
    let mut m = (n - 1e-9).ceil().max(2.0) as usize;
    while m % 2 == 1 || !smooth(m) {
        m += 1;
    }
    m
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two waves of 32 and 8 points on 256: a coarser grid holds the second down to more than two
    /// of its points, and loses its part of the gradient below.
    #[test]
    fn what_a_coarser_grid_loses_is_known() {
        let grid = Grid::new([256, 256], [1e-6, 1e-6]).unwrap();
        let wave = |_: f64, x: f64| (TAU * x / 32e-6).sin() + 0.1 * (TAU * x / 8e-6).sin();
        let map = HeightMap::from_fn(grid, wave).unwrap();
        let known = Map::with_step(&map, None).unwrap();
        assert!(known.repeats);
        let found = Candidates::of(&map, &known, Boundary::Periodic).unwrap();
        let kept = (1.0f64 / (1.0 + 0.01 * 16.0)).sqrt();
        for c in &found.list {
            let expected = if c.factor > 0.25 { 0.0 } else { 1.0 - kept };
            assert!((c.lost - expected).abs() < 1e-9, "{c:?}");
            assert!((c.grid.area() / grid.area() - 1.0).abs() < 1e-12);
        }
        assert_eq!(found.as_given().grid, grid);
        assert_eq!(found.list.last().map(|c| c.grid.shape()), Some([1024, 1024]));
    }

    #[test]
    fn a_ramp_does_not_repeat_and_profiles_stay_as_they_are() {
        let grid = Grid::new([64, 96], [1.0, 1.0]).unwrap();
        let tilted = HeightMap::from_fn(grid, |y, x| 0.1 * x + (0.3 * y).sin()).unwrap();
        assert!(!Map::of(&tilted).unwrap().repeats);
        for (shape, pixel) in [([1, 500], [1.0, 1.0]), ([500, 500], [3.0, 1.0])] {
            let grid = Grid::new(shape, pixel).unwrap();
            let map = HeightMap::from_fn(grid, |_, x| (0.2 * x).sin()).unwrap();
            let known = Map::of(&map).unwrap();
            let found = Candidates::of(&map, &known, Boundary::Periodic).unwrap();
            assert_eq!(found.list.len(), 1);
        }
    }

    #[test]
    fn fast_sides_are_even_and_smooth() {
        assert_eq!([500.5, 501.0, 2.2, 1001.0, 512.0].map(fast), [504, 504, 4, 1008, 512]);
    }
}
