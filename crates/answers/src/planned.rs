//! Grid, precision and tolerance chosen for an accuracy.

use crate::failure::Failure;
use crate::loads::rising;
use crate::watch::Watch;
use crate::work::Work;
use compare::Method;
use compare::budget::{Budget, Map};
use compare::plan::{self, Outcome, PlanError, Request, Sink, Task};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Boundary, Iteration, Load, Maps, Solution, SolverError};
use report::plan_reason;
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
    pub(crate) maps: Maps,
    pub(crate) threads: usize,
}

impl Asked<'_> {
    /// Solves for the loads; what comes goes to `work`. `None` if it was stopped.
    pub(crate) fn solve(
        &self,
        loads: &[Load],
        work: &mut Work,
        watch: &mut dyn Watch,
    ) -> Result<Option<Outcome>, Failure> {
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
            maps: self.maps,
            section: None,
            threads: self.threads,
        };
        let mut to = ToWork { loads, order: &order, work, watch };
        match plan::run(&task, &mut to) {
            Ok(outcome) => Ok(Some(outcome)),
            Err(PlanError::Stopped) => Ok(None),
            Err(PlanError::Statistics(e)) => Err(Failure::from_error(&e)),
            Err(PlanError::Solver(e)) => Err(Failure::from_error(&e)),
        }
    }
}

/// Puts what comes by rising load into the order asked for.
struct ToWork<'a> {
    loads: &'a [Load],
    order: &'a [usize],
    work: &'a mut Work,
    watch: &'a mut dyn Watch,
}

impl Sink for ToWork<'_> {
    fn begin(&mut self, map: &HeightMap) {
        self.work.begin(map.grid());
        self.watch.begin(map.grid(), self.loads.len());
    }

    fn iterated(&mut self, index: usize, now: &Iteration<'_>) -> ControlFlow<()> {
        let place = self.order[index];
        self.watch.iterated(place, self.loads[place], now)
    }

    fn take(
        &mut self,
        index: usize,
        result: Result<Solution, SolverError>,
        budget: Option<Budget>,
    ) -> ControlFlow<()> {
        let place = self.order[index];
        let load = self.loads[place];
        self.work.take(place, load, result, budget.as_ref(), None, self.watch);
        self.watch.done(load);
        ControlFlow::Continue(())
    }
}

/// A request that is not met ends with exit status 1; `way_out` stands behind it.
pub fn unmet(surface: &str, outcome: &Outcome, way_out: &str) -> Option<Failure> {
    let reason = plan_reason(outcome)?;
    let percent = 100.0 * outcome.request.relative();
    let of = if surface.is_empty() { String::new() } else { format!("{surface}: ") };
    let message =
        format!("{of}an accuracy of {percent} % of the area is not met: {reason}{way_out}");
    Some(Failure::incomplete("accuracy_not_met", message))
}
