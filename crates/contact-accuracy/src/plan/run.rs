//! Solving with a request: from the coarsest grid that may do to the one that does.

use super::outcome::{Finest, Miss, Next, NoBar, Outcome, Unmet};
use super::{Candidate, Candidates, Line, Request, budget};
use crate::budget::iteration::area_error;
use crate::budget::{Between, Budget, Map, NoAreaInterval};
use crate::ringing::Ringing;
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{
    Boundary, Iteration, Load, Maps, Method, Precision, Solution, Solver, SolverError,
};
use std::ops::ControlFlow;
use std::time::Instant;
use surface_stats::StatsError;

/// What is to be solved.
#[derive(Debug, Clone, Copy)]
pub struct Task<'a> {
    /// Heights as given.
    pub map: &'a HeightMap,
    /// What is known of it.
    pub known: &'a Map,
    /// Contact modulus.
    pub modulus: ContactModulus,
    /// Mean pressures, rising, or mean gaps, falling.
    pub loads: &'a [Load],
    /// What lies beyond the edges.
    pub boundary: Boundary,
    /// What is asked for.
    pub request: Request,
    /// Method of the solver.
    pub method: Method,
    /// Whether each solution comes with a rigorous bound of its pressure error.
    pub certified: bool,
    /// Which maps the solutions carry.
    pub maps: Maps,
    /// Row of the map along which they carry pressure and gap, if one; on another grid the row at its place.
    pub section: Option<usize>,
    /// Threads of the solver.
    pub threads: usize,
}

/// Where the solutions go.
pub trait Sink: Send {
    /// A grid is begun. What was taken before was on a grid that is given up.
    fn begin(&mut self, map: &HeightMap);

    /// An iteration of the solver on the load of this index is done. `Break` ends everything.
    fn iterated(&mut self, _index: usize, _now: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// A load, by its index among the loads, with its error budget on this grid if it was solved.
    /// `Break` ends everything.
    fn take(
        &mut self,
        index: usize,
        result: Result<Solution, SolverError>,
        budget: Option<Budget>,
    ) -> ControlFlow<()>;
}

/// Why nothing was solved to the end.
#[derive(Debug, Clone, thiserror::Error)]
pub enum PlanError {
    /// Another grid could not be made.
    #[error(transparent)]
    Statistics(#[from] StatsError),
    /// The solver refuses the settings.
    #[error(transparent)]
    Solver(#[from] SolverError),
    /// The sink broke off.
    #[error("stopped")]
    Stopped,
}

/// One load on the grid tried last.
struct Reached {
    load: Load,
    /// Relative half width, or why none.
    width: Result<f64, NoBar>,
    /// The part of it that is the iteration's.
    iteration: f64,
    line: Option<Line>,
}

/// Solves every load on the cheapest grid whose budget meets the request at every load that any
/// grid can meet it at. Grids are tried from coarse to fine; each is left at the first load that
/// fails and that a finer one is expected to meet, for the coarsest of those. Where no grid is
/// expected to meet it, the grid as given is as far as it goes.
///
/// # Errors
/// [`PlanError`]. A load that is not solved or a request that is not met is a result.
pub fn run(task: &Task<'_>, sink: &mut dyn Sink) -> Result<Outcome, PlanError> {
    let start = Instant::now();
    let candidates = Candidates::of(task.map, task.known, task.boundary)?;
    let mut current = first(task, &candidates);
    let (mut given_up, mut work) = (Vec::new(), 0.0);
    // Whether a finer grid was given up for the one as given.
    let mut is_back = false;
    loop {
        let begun = Instant::now();
        let attempt = attempt(task, &candidates, current, is_back, sink)?;
        work += attempt.transforms * candidates.list[current].grid.len() as f64 * bytes(task);
        if let Some(other) = attempt.leave_for {
            given_up.push(candidates.list[current].grid.shape());
            is_back = other < current;
            current = other;
            continue;
        }
        let last = begun.elapsed().as_secs_f64();
        let mut outcome = conclude(task, &candidates, current, is_back, attempt, last);
        outcome.seconds = start.elapsed().as_secs_f64();
        outcome.given_up = given_up;
        outcome.work = work;
        return Ok(outcome);
    }
}

/// Bytes of a number of the iteration.
fn bytes(task: &Task<'_>) -> f64 {
    match task.request.precision() {
        Precision::Double => 8.0,
        Precision::Single => 4.0,
    }
}

/// The coarsest grid that resolves what it holds and loses too little to break the request by
/// itself. Where the given map has no bar, no other grid can give it one.
fn first(task: &Task<'_>, candidates: &Candidates) -> usize {
    if candidates.as_given().accuracy.gate().is_err() {
        return candidates.given;
    }
    let room = task.request.relative() - area_error(task.request.tolerance());
    let line = Line { area: 1.0, edges: 0.0, fall: None };
    let may_do = |c: &Candidate| {
        c.accuracy.gate().is_ok() && line.half_width(c, task.known).is_ok_and(|lost| lost < room)
    };
    candidates.list.iter().position(may_do).unwrap_or(candidates.given).min(candidates.given)
}

struct Attempt {
    loads: Vec<Reached>,
    transforms: f64,
    /// The finer grid that is expected to do, if this one does not; or the given one, if no finer one will.
    leave_for: Option<usize>,
}

/// Every load on one grid, until one fails that a finer grid is expected to meet, unless that was tried (`is_back`).
fn attempt(
    task: &Task<'_>,
    candidates: &Candidates,
    current: usize,
    is_back: bool,
    sink: &mut dyn Sink,
) -> Result<Attempt, PlanError> {
    let candidate = &candidates.list[current];
    let map = candidates.map(task.map, candidate)?;
    let is_finer = current > candidates.given;
    let ringing = is_finer.then(|| Ringing::of(task.map, candidates.is_continued())).transpose()?;
    let rows = [task.map, &*map].map(|m| m.grid().shape()[0]);
    let section = task.section.map(|row| (row * rows[1] / rows[0]).min(rows[1] - 1));
    let mut solver = Solver::builder()
        .method(task.method)
        .boundary(task.boundary)
        .precision(task.request.precision())
        .tolerance(task.request.tolerance())
        .certified(task.certified)
        .maps(task.maps)
        .section(section)
        .threads(task.threads.max(1))
        .build(map.grid(), task.modulus)?;
    solver.follow_curve(task.loads.len());
    sink.begin(&map);
    let mut attempt = Attempt { loads: Vec::new(), transforms: 0.0, leave_for: None };
    for (index, &load) in task.loads.iter().enumerate() {
        let mut watch = |now: &Iteration<'_>| sink.iterated(index, now);
        let result = solver.solve_observed(&map, load, &mut watch);
        if matches!(result, Err(SolverError::Stopped(_))) {
            return Err(PlanError::Stopped);
        }
        let budget = result.as_ref().ok().map(|s| {
            let mut found =
                Between::on_points_of(task.map, task.known.repeats, s, map.grid(), task.modulus);
            if let (Some(found), Some(ringing)) = (&mut found, &ringing) {
                found.height = found.height.max(ringing.at(&s.pressure, map.grid()));
            }
            budget(s, load, candidate, task.known, found.as_ref())
        });
        let reached = Reached::of(load, &result, budget.as_ref());
        attempt.transforms += result.as_ref().map_or(0.0, |s| s.diagnostics.transforms);
        if !reached.meets(task.request) && !is_back {
            attempt.leave_for = if reached.is_between_points() {
                // No finer grid says what the given points do not; a coarser one is no place to end, nor a finer one
                // whose waves ring.
                (current != candidates.given).then_some(candidates.given)
            } else {
                better(task, candidates, current, &reached)
            };
        }
        attempt.loads.push(reached);
        if attempt.leave_for.is_some() {
            return Ok(attempt);
        }
        if sink.take(index, result, budget).is_break() {
            return Err(PlanError::Stopped);
        }
    }
    Ok(attempt)
}

impl Reached {
    fn of(load: Load, result: &Result<Solution, SolverError>, budget: Option<&Budget>) -> Self {
        let line = result.as_ref().ok().map(|solution| Line::of(solution, load));
        let Some(area) = budget.map(|b| b.area) else {
            let why = result.as_ref().err().map_or_else(String::new, ToString::to_string);
            return Self { load, width: Err(NoBar::Unsolved(why)), iteration: 0.0, line };
        };
        let share = |half: f64| if half > 0.0 { half / area.value } else { 0.0 };
        let width = area.comparison_half_width().map(share).map_err(NoBar::Area);
        Self { load, width, iteration: area.iteration.map_or(0.0, share), line }
    }

    /// Whether what lies between the given points decides.
    fn is_between_points(&self) -> bool {
        matches!(self.width, Err(NoBar::Area(NoAreaInterval::BetweenPoints { .. })))
    }

    fn meets(&self, request: Request) -> bool {
        self.width.as_ref().is_ok_and(|width| *width <= request.relative())
    }
}

/// The coarsest finer grid on which the line found here is expected to have a bar within the
/// request; if none has, not less than the grid that was given.
fn better(
    task: &Task<'_>,
    candidates: &Candidates,
    current: usize,
    reached: &Reached,
) -> Option<usize> {
    let will_do = |finer: &usize| {
        expected(task, candidates, [current, *finer], reached)
            .is_some_and(|width| width <= task.request.relative())
    };
    let fallback = (current < candidates.given).then_some(candidates.given);
    (current + 1..candidates.list.len()).find(will_do).or(fallback)
}

/// Expected relative half width on another grid.
fn expected(
    task: &Task<'_>,
    candidates: &Candidates,
    [from, to]: [usize; 2],
    reached: &Reached,
) -> Option<f64> {
    let (from, to) = (&candidates.list[from], &candidates.list[to]);
    if to.accuracy.gate().is_err() || candidates.as_given().accuracy.gate().is_err() {
        return None;
    }
    let scale = (from.grid.len() as f64 / to.grid.len() as f64).sqrt();
    let line = reached.line?.on_pixels(scale);
    let grid = line.half_width(to, task.known).ok()?;
    (line.area > 0.0).then(|| grid / line.area + reached.iteration)
}

fn conclude(
    task: &Task<'_>,
    candidates: &Candidates,
    current: usize,
    is_back: bool,
    attempt: Attempt,
    seconds: f64,
) -> Outcome {
    let Attempt { loads, transforms, .. } = attempt;
    let candidate = &candidates.list[current];
    let all: Option<Vec<f64>> = loads.iter().map(|l| l.width.clone().ok()).collect();
    let half_width = all.map(|widths| widths.iter().copied().fold(0.0, f64::max));
    let unmet: Vec<&Reached> = loads.iter().filter(|l| !l.meets(task.request)).collect();
    let is_open = !is_back
        && candidates.as_given().accuracy.gate().is_ok()
        && !loads.iter().any(Reached::is_between_points);
    let next = candidates.list.get(current + 1).filter(|_| is_open);
    let next = next.map(|finer| {
        let width = |l: &Reached| expected(task, candidates, [current, current + 1], l);
        let widths: Option<Vec<f64>> = loads.iter().map(width).collect();
        Next {
            shape: finer.grid.shape(),
            factor: finer.factor,
            half_width: widths.map(|w| w.iter().copied().fold(0.0, f64::max)),
            seconds: seconds * finer.grid.len() as f64 / candidate.grid.len() as f64,
        }
    });
    Outcome {
        request: task.request,
        met: unmet.is_empty(),
        given: task.map.grid(),
        grid: candidate.grid,
        factor: candidate.factor,
        precision: task.request.precision(),
        tolerance: task.request.tolerance(),
        half_width,
        transforms,
        work: 0.0,
        seconds,
        given_up: Vec::new(),
        next: next.filter(|next| half_width.is_none_or(|h| h > 0.0) || next.half_width.is_none()),
        unmet: reason(task, candidates, current, is_back, &unmet),
    }
}

/// Why some loads miss the request: the first of them.
fn reason(
    task: &Task<'_>,
    candidates: &Candidates,
    current: usize,
    is_back: bool,
    unmet: &[&Reached],
) -> Option<Unmet> {
    let reached = unmet.first()?;
    if let (Err(why), Err(_)) = (candidates.as_given().accuracy.gate(), &reached.width) {
        return Some(Unmet::Map(why));
    }
    let why = if let (Load::MeanGap(_), Some(line)) = (reached.load, reached.line)
        && line.area <= 0.0
        && line.edges <= 0.0
    {
        Miss::NoContact { first_contact: task.map.range().1 - task.map.mean() }
    } else {
        let last = candidates.list.len() - 1;
        let finest = if is_back {
            Finest::BetweenPoints
        } else if last == current || reached.is_between_points() {
            Finest::Used
        } else {
            Finest::Other {
                shape: candidates.list[last].grid.shape(),
                half_width: expected(task, candidates, [current, last], reached),
            }
        };
        Miss::Bar { here: reached.width.clone(), finest }
    };
    Some(Unmet::Loads { first: reached.load, missed: unmet.len(), of: task.loads.len(), why })
}
