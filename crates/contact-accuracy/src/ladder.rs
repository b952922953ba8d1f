//! The one procedure: a load on a map, on every second point of it, and, where the answer depends on what lies
//! between the points, on twice as many.

use crate::budget::Budget;
use crate::coarser::{Numbers, RungMaps, both, pressure_beside, with_images};
use crate::estimate::NoUncertainty;
use crate::indicator::{LIMIT, indicator};
use crate::leak::Leaks;
use crate::regrid;
use crate::sampling::Map;
use crate::setup::Setup;
use crate::uncertainty::Beside;
use contact_types::{Clock, Grid, HeightMap};
use fft_bem_solver::{
    Boundary, Iteration, Load, ObserverResult, SetStiffness, Solution, Solver, SolverError,
};
use grid_fft::parallel::join;
use std::borrow::Cow;
use surface_stats::StatsError;

/// Relative uncertainty of the area above which twice the points are solved.
const WIDE: f64 = 0.2;
/// Most points of a map that is solved on twice the points along each side without being asked: 1024 × 1024.
const MOST_UNASKED: usize = 1 << 20;
/// Most points of one that an accuracy is asked for: 64 million on the finer grid.
pub(crate) const MOST: usize = 1 << 24;

/// A map with the rungs beside it, to be solved at one load after the other.
#[derive(Debug)]
pub struct Ladder {
    setup: Setup,
    /// What the map says before anything is solved.
    pub known: Map,
    /// The map as it was given.
    given: HeightMap,
    solver: Solver,
    coarser: Result<RungMaps, NoUncertainty>,
    finer: Option<RungMaps>,
}

/// A load that was solved for.
#[derive(Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Answered {
    /// On the map; its seconds are those of all rungs.
    pub solution: Solution,
    /// Its contact set, if that was asked for its stiffness.
    pub set: Option<SetStiffness>,
    /// The numbers with their uncertainties.
    pub budget: Budget,
    /// On the thinned maps.
    pub coarser: Vec<Numbers>,
    /// On twice the points, if that was needed.
    pub finer: Option<Numbers>,
    /// The leak, if it was asked for.
    pub leak: Option<Leaks>,
    /// Of its seconds those on the thinned maps, and on twice the points (s).
    pub seconds: [f64; 2],
}

impl Answered {
    /// The same where contact modulus and hardness are known to these relative half widths only.
    #[must_use]
    pub fn with_materials(self, spreads: [f64; 2]) -> Self {
        Self { budget: self.budget.with_materials(spreads, &self.solution), ..self }
    }
}

impl Ladder {
    /// Makes the rungs of `map`.
    ///
    /// # Errors
    /// [`LadderError`].
    pub fn new(map: HeightMap, setup: Setup) -> Result<Self, LadderError> {
        let known = Map::of(&map);
        let mut builder = setup.builder.clone();
        builder.maps = builder.maps.max(setup.maps());
        let whole = || {
            let surface = with_images(Cow::Borrowed(&map), setup.mirrored)?;
            let mut solver = builder.build(surface.grid(), setup.modulus)?;
            solver.take_surface(&surface).map(|()| solver).map_err(LadderError::from)
        };
        let grid = map.grid();
        let thinned = || -> Result<_, LadderError> {
            if !RungMaps::is_possible(grid) {
                return Ok(Err(NoUncertainty::TooFewPoints { shape: grid.shape() }));
            }
            Ok(Ok(RungMaps::of(both(&map, setup.mirrored)?, setup.clone().loose())?))
        };
        let (solver, coarser) = join(whole, thinned);
        Ok(Self { solver: solver?, coarser: coarser?, setup, known, given: map, finer: None })
    }

    /// The map as it was given.
    pub fn map(&self) -> &HeightMap {
        &self.given
    }

    /// Another map on the same grid, to be solved from where the last one ended.
    ///
    /// # Errors
    /// [`LadderError`].
    pub fn take_map(&mut self, map: HeightMap) -> Result<(), LadderError> {
        self.known = Map::of(&map);
        self.solver.take_surface(&*with_images(Cow::Borrowed(&map), self.setup.mirrored)?)?;
        if let Ok(coarser) = &mut self.coarser {
            coarser.take(both(&map, self.setup.mirrored)?)?;
        }
        (self.given, self.finer) = (map, None);
        Ok(())
    }

    /// Solves for a load from where the last one ended.
    ///
    /// # Errors
    /// [`SolverError`] of the map itself, its iterate on the map as it was given; [`SolverError::Stopped`] with its
    /// solution where the observer stops a map beside it.
    pub fn solve<A: ObserverResult>(
        &mut self,
        load: Load,
        mut observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Answered, SolverError> {
        let found = self.solver.solve_again(load, None, &mut observer);
        let solution = on_given(found, self.given.grid())?;
        self.answer(load, solution, observer)
    }

    /// The answer to a load whose solution on the map is known: solves only what lies beside it. Without its pressure there
    /// is no stiffness.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn answer<A: ObserverResult>(
        &mut self,
        load: Load,
        mut solution: Solution,
        mut observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Result<Answered, SolverError> {
        let (shape, is_mirrored) = (self.given.grid().shape(), self.setup.mirrored);
        let is_kept = solution.pressure.len() == self.given.grid().len();
        let set = (self.setup.stiffness && is_kept).then(|| {
            let whole = shape.map(|n| if is_mirrored { 2 * n } else { n });
            let at = pressure_beside(&solution.pressure, shape, whole, ([0; 2], is_mirrored));
            self.solver.contact_stiffness(|i| at(i) > 0.0)
        });
        let set = set.transpose()?;
        let (clock, repeats) = (Clock::now(), self.repeats());
        let (coarser, indicator) = join(
            || match &mut self.coarser {
                Ok(coarser) => Ok(coarser.solve(load, (&solution, repeats), &mut observer)),
                Err(why) => Err(*why),
            },
            || indicator(&self.given, repeats, &solution.pressure, self.setup.modulus),
        );
        if let Ok(Err(SolverError::Stopped(_))) = coarser {
            return Err(SolverError::Stopped(solution.into()));
        }
        let coarser = coarser.and_then(|numbers| numbers.map_err(|_| NoUncertainty::Undefined));
        let coarse_seconds = clock.elapsed().as_secs_f64();
        let asked = (set.as_ref(), self.setup.jump);
        let beside = Beside { coarser: coarser.as_deref().map_err(|why| *why), finer: None };
        let known = self.known;
        let budget =
            |beside| Budget { indicator, ..Budget::of(load, &solution, asked, &known, beside) };
        let mut found = budget(beside);
        let clock = Clock::now();
        let mut finer = None;
        if self.needs_finer(&found) {
            let numbers = self.on_finer(load, &solution, observer);
            if let Some(Err(SolverError::Stopped(_))) = numbers {
                return Err(SolverError::Stopped(solution.into()));
            }
            finer = numbers.and_then(|numbers| numbers.ok()?.pop());
            found = budget(Beside { finer: finer.as_ref(), ..beside });
        }
        let seconds = [coarse_seconds, clock.elapsed().as_secs_f64()];
        let axes = &self.setup.leak;
        let thinned: Vec<_> = coarser.iter().flatten().map(|n| n.permeability).collect();
        // At the mirror planes of images inlet, outlet and walls change nothing.
        let edges = [repeats && !is_mirrored, !is_mirrored];
        let leak = Leaks::of(&solution, axes, &thinned, edges);
        solution.diagnostics.seconds += seconds[0] + seconds[1];
        let coarser = coarser.unwrap_or_default();
        Ok(Answered { solution, set, budget: found, coarser, finer, leak, seconds })
    }

    fn repeats(&self) -> bool {
        self.known.repeats && self.setup.builder.boundary == Boundary::Periodic
    }

    fn needs_finer(&self, budget: &Budget) -> bool {
        let sensitive = budget.indicator.is_some_and(|indicator| indicator > LIMIT);
        let wide = budget.area.half_width().is_ok_and(|half| half > WIDE * budget.area.value);
        let [ny, nx] = self.given.grid().shape();
        let may = self.setup.finer && ny.min(nx) >= 4 && ny * nx <= MOST_UNASKED;
        may && (sensitive || wide)
    }

    /// The numbers of the map on twice the points along each side: by its Fourier components if it repeats, by its
    /// cosines otherwise. None if they cannot be had: the answer stands without.
    fn on_finer<A: ObserverResult>(
        &mut self,
        load: Load,
        given: &Solution,
        observer: impl FnMut(&Iteration<'_>) -> A + Send,
    ) -> Option<Result<Vec<Numbers>, SolverError>> {
        if self.finer.is_none() {
            let shape = self.given.grid().shape().map(|n| 2 * n);
            let map = regrid(&self.given, shape, self.repeats()).ok()?;
            let map = with_images(Cow::Owned(map), self.setup.mirrored).ok()?.into_owned();
            let setup = Setup { leak: Vec::new(), ..self.setup.clone() };
            self.finer = Some(RungMaps::of(vec![map], setup).ok()?);
        }
        Some(self.finer.as_mut()?.solve(load, (given, self.known.repeats), observer))
    }
}

/// Why a map has no rungs, or was not solved to the end.
#[derive(Debug, Clone, thiserror::Error)]
pub enum LadderError {
    /// Its mirror images are too many points.
    #[error(transparent)]
    Statistics(#[from] StatsError),
    /// The solver refuses the settings.
    #[error(transparent)]
    Solver(#[from] SolverError),
    /// The [`Sink`](crate::Sink) broke off.
    #[error("stopped")]
    Stopped,
}

/// The part of an answer that belongs to the map on `given`, if that is a quarter of what was solved; the answer
/// itself otherwise. Fields are those of the map. Area, contact line, gap, load and residuals are per pixel, means
/// over the map and its images; the edges of the map are no contact lines, for each pixel there faces its own
/// image.
fn on_given(result: Result<Solution, SolverError>, given: Grid) -> Result<Solution, SolverError> {
    let quarter = |mut solution: Solution| {
        if solution.grid.len() != 4 * given.len() {
            return solution;
        }
        solution.grid = given;
        let [ny, nx] = given.shape();
        for field in [&mut solution.pressure, &mut solution.gap] {
            if field.len() == 4 * given.len() {
                let rows = field.chunks_exact(2 * nx).take(ny);
                *field = rows.flat_map(|row| row[..nx].iter().copied()).collect();
            }
        }
        // Rounded: the images may differ by what the iteration left.
        solution.diagnostics.contact_pixels = (solution.diagnostics.contact_pixels + 2) / 4;
        solution
    };
    let boxed = |solution: Box<Solution>| Box::new(quarter(*solution));
    result.map(quarter).map_err(|error| match error {
        SolverError::NotConverged(best) => SolverError::NotConverged(boxed(best)),
        SolverError::Rounding(best) => SolverError::Rounding(boxed(best)),
        SolverError::Stopped(last) => SolverError::Stopped(boxed(last)),
        error => error,
    })
}
