//! `solve --accuracy`: grid, precision and tolerance chosen for a request.

use crate::loads::{rising, shown};
use crate::outcome::{Failure, Reply};
use crate::progress::Progress;
use crate::work::Work;
use compare::Method;
use compare::budget::{Budget, Map};
use compare::plan::{self, Outcome, PlanError, Request, Sink, Task};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Boundary, Load, Maps, Solution, SolverError};
use report::{accuracy_json, plan_explanation, plan_reason};
use std::ops::ControlFlow;

/// What is to be solved, and how well.
pub(crate) struct Asked<'a> {
    pub(crate) surface: &'a HeightMap,
    pub(crate) known: &'a Map,
    pub(crate) boundary: Boundary,
    pub(crate) modulus: ContactModulus,
    pub(crate) request: Request,
    pub(crate) method: Method,
    pub(crate) certified: bool,
    /// Whether pressure and gap are written.
    pub(crate) fields: bool,
    pub(crate) threads: usize,
}

impl Asked<'_> {
    /// Solves for the loads; what comes goes to `work`.
    pub(crate) fn solve(
        &self,
        loads: &[Load],
        work: &mut Work,
        progress: &mut Progress,
    ) -> Result<Outcome, Failure> {
        let order = rising(loads);
        let risen: Vec<Load> = order.iter().map(|&i| loads[i]).collect();
        let task = Task {
            map: self.surface,
            known: self.known,
            modulus: self.modulus,
            loads: &risen,
            boundary: self.boundary,
            request: self.request,
            method: self.method,
            certified: self.certified,
            maps: if self.fields { Maps::PressureAndGap } else { Maps::Pressure },
            threads: self.threads,
        };
        let mut to = ToWork { loads, order: &order, work, progress };
        plan::run(&task, &mut to).map_err(|e| match e {
            PlanError::Statistics(e) => Failure::from_error(&e),
            PlanError::Solver(e) => Failure::from_error(&e),
            stopped @ PlanError::Stopped => Failure::from_error(&stopped),
        })
    }
}

/// Puts what comes by rising load into the order asked for.
struct ToWork<'a> {
    loads: &'a [Load],
    order: &'a [usize],
    work: &'a mut Work,
    progress: &'a mut Progress,
}

impl Sink for ToWork<'_> {
    fn begin(&mut self, map: &HeightMap) {
        self.work.begin(map.grid());
        self.progress.restart(self.loads.len());
        let [ny, nx] = map.grid().shape();
        self.progress.working_on(&format!("{ny} × {nx} points"));
    }

    fn take(
        &mut self,
        index: usize,
        result: Result<Solution, SolverError>,
        budget: Option<Budget>,
    ) -> ControlFlow<()> {
        let place = self.order[index];
        let load = self.loads[place];
        self.work.take(place, load, &result, budget.as_ref(), None);
        self.progress.step(&shown(load));
        ControlFlow::Continue(())
    }
}

/// Puts the plan into the reply: its line, its object, and the exit status if it is not met, with
/// the way out if loads without a bar are `refinable`.
pub(crate) fn state(outcome: &Outcome, refinable: bool, reply: &mut Reply) {
    let line = plan_explanation(outcome);
    reply.text.push_str(&line);
    reply.text.push('\n');
    reply.json["accuracy"] = accuracy_json(outcome);
    reply.json["precision"] = outcome.precision.name().into();
    reply.json["tolerance"] = outcome.tolerance.into();
    let refine =
        "; --refine instead of --accuracy gives the interval that a twice finer grid leaves";
    let way_out = if refinable { refine } else { "" };
    if let Some(failure) = unmet("", outcome, way_out) {
        reply.trouble = Some(match reply.trouble.take() {
            None => failure,
            Some(earlier) => earlier.and(failure),
        });
    }
}

/// A request that is not met ends with exit status 1.
pub(crate) fn unmet(surface: &str, outcome: &Outcome, way_out: &str) -> Option<Failure> {
    let reason = plan_reason(outcome)?;
    let percent = 100.0 * outcome.request.relative();
    let of = if surface.is_empty() { String::new() } else { format!("{surface}: ") };
    let message =
        format!("{of}an accuracy of {percent} % of the area is not met: {reason}{way_out}");
    Some(Failure::incomplete("accuracy_not_met", message))
}
