//! Climbing the ladder until the area is known as well as it is asked for: every second point, the map, twice its
//! points.

use crate::coarser::{RungMaps, thinned};
use crate::indicator::LIMIT;
use crate::ladder::{Answered, Ladder, LadderError, MOST};
use crate::regrid;
use crate::request::AccuracyRequest;
use crate::sampling::Map;
use crate::setup::Setup;
use contact_types::{Clock, Grid, HeightMap};
use fft_bem_solver::{Boundary, Iteration, Load, Precision, SolverError};
use std::ops::ControlFlow;
use surface_stats::{StatsError, repeats};

/// How well the area is to be known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Aim {
    /// On the map as it is.
    AsGiven,
    /// As it is at once: every second point of the map.
    Fast,
    /// On the first rung whose uncertainty is within this at every load.
    Within(AccuracyRequest),
}

impl Aim {
    /// Whether a relative half width, or the lack of one, will do.
    fn is_met(self, width: &Result<f64, String>) -> bool {
        match self {
            Self::AsGiven | Self::Fast => true,
            Self::Within(request) => width.as_ref().is_ok_and(|w| *w <= request.relative()),
        }
    }
}

/// What is to be solved.
#[derive(Debug)]
pub struct Task<'a> {
    /// Heights as given.
    pub map: HeightMap,
    /// How to solve; an accuracy chooses tolerance and precision itself.
    pub setup: Setup,
    /// Mean pressures, rising, or mean gaps, falling.
    pub loads: &'a [Load],
    /// How well.
    pub aim: Aim,
    /// As given, the ladder of a call with the same setup on the same grid, or none; and that of this call afterwards.
    pub kept: &'a mut Option<Ladder>,
}

/// Where the solutions go.
pub trait Sink: Send {
    /// A rung is begun. What was taken before was on a rung that is given up.
    fn begin(&mut self, map: &HeightMap, known: &Map);

    /// An iteration of the solver on the load of this index is done. `Break` ends everything.
    fn iterated(&mut self, _index: usize, _now: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// A load, by its index among the loads. `Break` ends everything.
    fn take(&mut self, index: usize, result: Result<Answered, SolverError>) -> ControlFlow<()>;
}

/// What the next rung would give.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Next {
    /// Points `[ny, nx]`.
    pub shape: [usize; 2],
    /// Expected relative half width of the area: half of this one, as of a method of first order.
    pub half_width: Option<f64>,
    /// Expected time (s): in proportion to the points.
    pub seconds: f64,
}

/// Why an accuracy is not met.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Unmet {
    /// The first load that misses it.
    pub first: Load,
    /// How many do.
    pub missed: usize,
    /// Loads in all.
    pub of: usize,
    /// Relative half width there, or why there is none.
    pub here: Result<f64, String>,
    /// Whether the answer depends on what lies between the given points, which no finer rung says.
    pub between_points: bool,
}

/// The rung that was reached.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Reached {
    /// What was asked for; `None` for the fast answer.
    pub request: Option<AccuracyRequest>,
    /// The grid of the given map.
    pub given: Grid,
    /// The grid solved on.
    pub grid: Grid,
    /// Precision of the solver.
    pub precision: Precision,
    /// Tolerance of the solver.
    pub tolerance: f64,
    /// Widest relative half width of the area over the loads; `None` if a load has none.
    pub half_width: Option<f64>,
    /// Wall-clock time on all rungs (s).
    pub seconds: f64,
    /// The next rung; `None` if there is none.
    pub next: Option<Next>,
    /// Why the request is not met at every load, if it is not.
    pub unmet: Option<Unmet>,
}

impl Reached {
    /// Points per side over those of the given map: ½, 1 or 2.
    pub fn factor(&self) -> f64 {
        let longer = usize::from(self.given.shape()[0] <= self.given.shape()[1]);
        self.given.pixel()[longer] / self.grid.pixel()[longer]
    }

    /// With the rung above of so many points per side over those of the map, and the time since `start`.
    fn with_next(self, above: Option<f64>, start: Clock) -> Self {
        let next = above.map(|factor| {
            let shape = self.given.shape().map(|n| (factor * n as f64) as usize);
            let points = (shape[0] * shape[1]) as f64 / self.grid.len() as f64;
            let half_width = self.half_width.map(|w| 0.5 * w);
            Next { shape, half_width, seconds: points * self.seconds }
        });
        Self { next, seconds: start.elapsed().as_secs_f64(), ..self }
    }
}

/// Solves every load on the lowest rung whose uncertainties are all within the request. Every second point is left at
/// the first load that misses it. Twice the points are tried unless an answer depends on what lies between the
/// given points, and given up again where they tell less than the map as it is.
///
/// # Errors
/// [`LadderError`]. A load that is not solved or a request that is not met is a result.
pub fn climb(task: Task<'_>, sink: &mut dyn Sink) -> Result<Reached, LadderError> {
    let Task { map, setup, loads, aim, kept } = task;
    let (start, grid) = (Clock::now(), map.grid());
    let possible = |factor: f64| match factor {
        0.5 => RungMaps::is_possible(grid) && RungMaps::is_possible(half(grid)),
        _ => grid.len() <= MOST && grid.shape().iter().all(|n| *n >= 4),
    };
    let mut attempt =
        |map, factor, kept: &mut _| attempt(map, (grid, factor), (&setup, loads, aim), kept, sink);
    if aim == Aim::AsGiven {
        return Ok(attempt(map, 1.0, kept)?.0.with_next(None, start));
    }
    if possible(0.5) {
        let every_second = thinned(&map, [0, 0]).map_err(StatsError::from)?;
        let (low, _) = attempt(every_second, 0.5, &mut None)?;
        if low.unmet.is_none() {
            return Ok(low.with_next(Some(1.0), start));
        }
    }
    let (given, between_points) = attempt(map.clone(), 1.0, &mut None)?;
    let next = (possible(2.0) && !between_points).then_some(2.0);
    if given.unmet.is_none() || next.is_none() {
        return Ok(given.with_next(next, start));
    }
    let repeats = repeats(&map) && setup.builder.boundary == Boundary::Periodic;
    let twice = regrid(&map, grid.shape().map(|n| 2 * n), repeats)?;
    let (high, _) = attempt(twice, 2.0, &mut None)?;
    let widest = |reached: &Reached| reached.half_width.unwrap_or(f64::INFINITY);
    if high.unmet.is_none() || widest(&high) < widest(&given) {
        return Ok(high.with_next(None, start));
    }
    Ok(attempt(map, 1.0, &mut None)?.0.with_next(None, start))
}

/// The grid of every second point.
fn half(grid: Grid) -> Grid {
    let shape = grid.shape().map(|n| (n / 2).max(1));
    Grid::new(shape, grid.pixel().map(|d| 2.0 * d)).unwrap_or(grid)
}

/// Every load on one rung; of every second point until one misses the request. Returns the result
/// of this rung alone, and whether an answer depends on what lies between the points.
fn attempt(
    map: HeightMap,
    (given, factor): (Grid, f64),
    (setup, loads, aim): (&Setup, &[Load], Aim),
    kept: &mut Option<Ladder>,
    sink: &mut dyn Sink,
) -> Result<(Reached, bool), LadderError> {
    let (begun, grid) = (Clock::now(), map.grid());
    let mut builder = setup.builder.clone();
    if let Aim::Within(request) = aim {
        builder = builder.tolerance(request.tolerance()).precision(request.precision());
    }
    let (precision, tolerance) = (builder.precision, builder.tolerance);
    let finer = setup.finer && grid == given;
    let ladder = match kept.take().filter(|ladder| ladder.map().grid() == grid) {
        Some(mut ladder) => ladder.take_map(map).map(|()| ladder)?,
        None => Ladder::new(map, Setup { builder, finer, ..setup.clone() })?,
    };
    let ladder = kept.insert(ladder);
    sink.begin(ladder.map(), &ladder.known);
    let (mut widest, mut any_between, mut unmet) = (0.0_f64, false, None);
    for (index, &load) in loads.iter().enumerate() {
        let result = ladder.solve(load, |now| sink.iterated(index, now));
        if matches!(result, Err(SolverError::Stopped(_))) {
            return Err(LadderError::Stopped);
        }
        let here = width(&result);
        let indicator = result.as_ref().ok().and_then(|found| found.budget.indicator);
        let between_points = indicator.is_some_and(|i| i > LIMIT);
        any_between |= between_points;
        widest = widest.max(*here.as_ref().unwrap_or(&f64::INFINITY));
        if !aim.is_met(&here) {
            let first = Unmet { first: load, missed: 0, of: loads.len(), here, between_points };
            unmet.get_or_insert(first).missed += 1;
            if factor < 1.0 {
                break;
            }
        }
        if sink.take(index, result).is_break() {
            return Err(LadderError::Stopped);
        }
    }
    let reached = Reached {
        request: if let Aim::Within(request) = aim { Some(request) } else { None },
        given,
        grid,
        precision,
        tolerance,
        half_width: Some(widest).filter(|w| w.is_finite()),
        seconds: begun.elapsed().as_secs_f64(),
        next: None,
        unmet,
    };
    Ok((reached, any_between))
}

/// Relative half width of the area, or why there is none.
fn width(result: &Result<Answered, SolverError>) -> Result<f64, String> {
    let area = result.as_ref().map_err(ToString::to_string)?.budget.area;
    let half = area.half_width().map_err(|why| why.to_string())?;
    Ok(if half > 0.0 { half / area.value } else { 0.0 })
}
