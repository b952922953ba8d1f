//! The rung below: every second row and column of the map, solved at the same load.
//!
//! Points are left out, not averaged: an average takes gradients away, and the area with them. The map is
//! thinned twice, from the first point and from the one diagonally beside it, since one choice alone may agree
//! with the whole map by accident.

use crate::leak::permeability;
use crate::setup::Setup;
use contact_types::{Grid, HeightMap, SurfaceError};
use fft_bem_solver::{
    Iteration, Load, Method, ObserverResult, SetStiffness, Solution, Solver, SolverError,
};
use grid_fft::parallel::join;
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::sync::Mutex;
use surface_stats::clean::{mirrored, resample};
use surface_stats::{Edges, StatsError};

/// First row and column of each thinned map.
const PHASES: [[usize; 2]; 2] = [[0, 0], [1, 1]];
/// Fewest points along a side of a thinned map.
pub(crate) const FEWEST: usize = 8;

/// The numbers of one solution that an uncertainty is known of.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Numbers {
    /// Load over nominal area (Pa).
    pub mean_pressure: f64,
    /// Area fraction with the perimeter correction (-).
    pub area: f64,
    /// Mean gap (m); `None` where the boundary leaves it undefined.
    pub mean_gap: Option<f64>,
    /// Stiffness of the contact set (Pa/m), if it was asked for and there is one.
    pub stiffness: Option<f64>,
    /// Conductance over conductivity of a gas in the gap (1/m): parallel plates locally, `⟨1/(g + M)⟩` over the nominal
    /// area with 0 where it touches, M the length of the temperature jumps at both walls; if it was asked for.
    pub gas: Option<f64>,
    /// Permeability of the gap along x and y (m³), if the leak was asked for.
    pub permeability: [Option<f64>; 2],
}

impl Numbers {
    /// Of a solution, with the stiffness of its contact set if that was asked for, and the gas with temperature jumps of this
    /// length (m) if there is one.
    pub(crate) fn of(solution: &Solution, set: Option<&SetStiffness>, jump: Option<f64>) -> Self {
        let stiffness = set.map(|set| set.per_area).filter(|k| *k > 0.0 && k.is_finite());
        Self {
            mean_pressure: solution.state.mean_pressure,
            area: solution.state.area_fraction,
            mean_gap: solution.state.mean_gap,
            stiffness,
            gas: jump.map(|jump| gas(&solution.pressure, &solution.gap, jump)),
            permeability: [None; 2],
        }
    }
}

/// Mean of `1/(g + M)` over the points, 0 where one carries pressure.
fn gas(pressure: &[f64], gap: &[f64], jump: f64) -> f64 {
    let open = pressure.iter().zip(gap).filter(|(p, _)| **p <= 0.0);
    open.fold(0.0, |sum, (_, gap)| sum + 1.0 / (gap.max(0.0) + jump)) / gap.len().max(1) as f64
}

/// Every second row and column, from the row and column of `first` (0 or 1) on: half of them, so that of an odd number the
/// last stays away. A profile keeps its one row.
///
/// # Errors
/// [`SurfaceError`] if nothing is left.
pub fn thinned(map: &HeightMap, first: [usize; 2]) -> Result<HeightMap, SurfaceError> {
    let (shape, pixel) = (map.grid().shape(), map.grid().pixel());
    let step = shape.map(|n| if n == 1 { 1 } else { 2 });
    let first = [0, 1].map(|k| if step[k] == 1 { 0 } else { first[k] });
    let count = [0, 1].map(|k| shape[k] / step[k]);
    let grid = Grid::new(count, [0, 1].map(|k| step[k] as f64 * pixel[k]))?;
    let at = |k: usize| (0..count[k]).map(move |i| first[k] + step[k] * i);
    let row = |iy: usize| at(1).map(move |ix| map.heights()[iy * shape[1] + ix]);
    HeightMap::new(grid, at(0).flat_map(row).collect())
}

/// The map on `shape` points: by its waves if it repeats, by its cosines otherwise, so that the jump
/// at its edges does not ring.
///
/// # Errors
/// [`StatsError`].
pub fn regrid(map: &HeightMap, shape: [usize; 2], repeats: bool) -> Result<HeightMap, StatsError> {
    resample(map, shape, if repeats { Edges::Periodic } else { Edges::Open })
}

/// The map as the solver gets it, which repeats it: with its mirror images, if those belong to it, which repeat without a
/// jump. The means of an answer are those of the map, for every quarter has the same.
///
/// # Errors
/// [`StatsError::Surface`] if the mirror images make too many points.
pub fn with_images(
    map: Cow<'_, HeightMap>,
    is_mirrored: bool,
) -> Result<Cow<'_, HeightMap>, StatsError> {
    Ok(if is_mirrored { Cow::Owned(mirrored(&map)?) } else { map })
}

/// Both, whole. (Of a map and its images, every second row would be the image of the others: twice the same.)
pub(crate) fn both(map: &HeightMap, is_mirrored: bool) -> Result<Vec<HeightMap>, StatsError> {
    let whole = |first| with_images(Cow::Owned(thinned(map, first)?), is_mirrored);
    PHASES.into_iter().map(|first| Ok(whole(first)?.into_owned())).collect()
}

/// The pressure of a map with `[ny, nx]` points at the pixels, by their index, of one of this `shape`: itself, thinned from `first`
/// or with twice the points, and its mirror images if those belong to it. Each has that of the given point where it lies.
pub(crate) fn pressure_beside(
    pressure: &[f64],
    [ny, nx]: [usize; 2],
    shape: [usize; 2],
    (first, is_mirrored): ([usize; 2], bool),
) -> impl Fn(usize) -> f64 + Sync {
    let at = move |k: usize, n: usize, i: usize| {
        let m = if is_mirrored { shape[k] / 2 } else { shape[k] };
        let i = if i < m { i } else { 2 * m - 1 - i };
        if m < n { first[k] + 2 * i } else { i * n / m }
    };
    move |i| pressure[at(0, ny, i / shape[1]) * nx + at(1, nx, i % shape[1])]
}

/// The maps of a rung beside the given one, ready to be solved.
#[derive(Debug)]
pub(crate) struct RungMaps {
    /// With the shapes of the maps.
    solvers: Vec<(Solver, [usize; 2])>,
    setup: Setup,
}

impl RungMaps {
    /// Whether maps on `grid` can be thinned: [`FEWEST`] points are left along each side (of a profile along its one).
    pub(crate) fn is_possible(grid: Grid) -> bool {
        let enough = |n: usize| n == 1 || n / 2 >= FEWEST;
        grid.shape().iter().all(|n| enough(*n)) && grid.len() > 1
    }

    /// Of these maps, such as [`both`] thinned ones.
    pub(crate) fn of(maps: Vec<HeightMap>, setup: Setup) -> Result<Self, SolverError> {
        let builder = setup.builder.clone().maps(setup.maps());
        let builder = builder.method(Method::Auto).certified(false);
        let solver = |map: &HeightMap| {
            Ok((builder.clone().build(map.grid(), setup.modulus)?, map.grid().shape()))
        };
        let solvers = maps.iter().map(solver).collect::<Result<_, SolverError>>()?;
        let mut made = Self { solvers, setup };
        made.take(maps).map(|()| made)
    }

    /// Others on the same grids.
    pub(crate) fn take(&mut self, maps: Vec<HeightMap>) -> Result<(), SolverError> {
        let mut pairs = self.solvers.iter_mut().zip(maps);
        pairs.try_for_each(|((solver, _), map)| solver.take_surface(&map))
    }

    /// The numbers of each at a load, from the pressure of the given map at it if that was kept, else from where its last load
    /// ended; the given map repeats or does not.
    pub(crate) fn solve<A: ObserverResult>(
        &mut self,
        load: Load,
        (given, repeats): (&Solution, bool),
        observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Vec<Numbers>, SolverError> {
        let Setup { stiffness, jump, leak, mirrored, .. } = &self.setup;
        let is_kept = given.pressure.len() == given.grid.len();
        let observer = Mutex::new(observer);
        let observer = |now: &Iteration<'_>| match observer.lock() {
            Ok(mut observer) => observer(now).flow(),
            Err(_) => ControlFlow::Break(()),
        };
        let one = |((solver, shape), first): (&mut (Solver, [usize; 2]), _)| {
            let (pressure, of) = (&given.pressure, given.grid.shape());
            let start = pressure_beside(pressure, of, *shape, (first, *mirrored));
            let start = is_kept.then_some(&start as &(dyn Fn(usize) -> f64 + Sync));
            let solution = solver.solve_again(load, start, observer)?;
            let touches = |i: usize| solution.pressure[i] > 0.0;
            let set = stiffness.then(|| solver.contact_stiffness(touches)).transpose()?;
            let permeability = permeability(&solution, leak, repeats || *mirrored);
            Ok(Numbers { permeability, ..Numbers::of(&solution, set.as_ref(), *jump) })
        };
        match &mut self.solvers[..] {
            [a, b] => {
                let (a, b) = join(|| one((a, PHASES[0])), || one((b, PHASES[1])));
                Ok(vec![a?, b?])
            }
            solvers => solvers.iter_mut().zip(PHASES).map(one).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plate; a wave of height a over a gap g, whose mean is 1/√((g + M)² − a²); of a wave that touches, by quadrature.
    #[test]
    fn gas_conducts_as_parallel_plates() {
        let jump = 0.37e-6;
        let plate = gas(&[0.0; 9], &[2e-6; 9], jump);
        assert!((plate * 2.37e-6 - 1.0).abs() < 1e-14);
        assert!(gas(&[1.0; 9], &[0.0; 9], jump) <= 0.0);
        let n = 128;
        let wave =
            |i: usize| 1.0 + 0.9 * (std::f64::consts::TAU * (i as f64 + 0.3) / n as f64).cos();
        let gap: Vec<f64> = (0..n * n).map(|i| 1e-6 * wave(i % n)).collect();
        let exact = 1.0 / ((1e-6 + jump).powi(2) - 0.9e-6_f64.powi(2)).sqrt();
        let found = gas(&vec![0.0; n * n], &gap, jump);
        assert!((found / exact - 1.0).abs() < 1e-10, "{found} and {exact}");
        // Half of the points touch: half of the plate.
        let pressure: Vec<f64> = (0..n * n).map(|i| f64::from(u8::from(i % 2 == 0))).collect();
        let half = gas(&pressure, &vec![1e-6; n * n], jump);
        assert!((half * 2.0 * 1.37e-6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn every_second_point_is_kept_with_twice_the_pixel() {
        let grid = Grid::new([5, 4], [1.0, 3.0]).unwrap();
        let map = HeightMap::new(grid, (0..20).map(f64::from).collect()).unwrap();
        let all = thinned(&map, [0, 0]).unwrap();
        assert_eq!(all.grid(), Grid::new([2, 2], [2.0, 6.0]).unwrap());
        assert_eq!(all.heights(), [0.0, 2.0, 8.0, 10.0]);
        assert_eq!(thinned(&map, [1, 1]).unwrap().heights(), [5.0, 7.0, 13.0, 15.0]);
        let beside = |of, shape: [usize; 2], is_mirrored| {
            let at = pressure_beside(map.heights(), [5, 4], shape, (of, is_mirrored));
            (0..shape[0] * shape[1]).map(at).collect::<Vec<_>>()
        };
        for first in PHASES {
            let part = thinned(&map, first).unwrap();
            assert_eq!(beside(first, [2, 2], false), part.heights());
            assert_eq!(beside(first, [4, 4], true), mirrored(&part).unwrap().heights());
        }
        assert_eq!(beside([0; 2], [10, 8], false)[22..26], [7.0, 7.0, 4.0, 4.0]);
        let profile = Grid::new([1, 5], [1.0, 1.0]).unwrap();
        let profile = HeightMap::new(profile, vec![0.0, 1.0, 2.0, 3.0, 4.0]).unwrap();
        assert_eq!(thinned(&profile, [1, 1]).unwrap().heights(), [1.0, 3.0]);
    }
}
