//! The rung that an accuracy asks for.

use crate::failure::Failure;
use crate::loads::rising;
use crate::watch::Watch;
use crate::work::SolvedLoads;
use contact_accuracy::{Aim, Answered, LadderError, Map, Setup, Sink, Task, climb};
use contact_compare::{Joint, Reached};
use contact_report::plan_reason;
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{Iteration, Load, SolverError};
use std::ops::ControlFlow;

/// Solves the map for the loads; what comes goes to `work`. `None` if it was stopped. `part`: what the contact conducts, where
/// its stiffness is asked for; `materials`: relative half widths of modulus and hardness.
pub(crate) fn solve(
    (surface, setup, aim): (&HeightMap, Setup, Aim),
    loads: &[Load],
    (part, materials): (Option<(&Joint, ContactModulus)>, [f64; 2]),
    work: &mut SolvedLoads,
    watch: &mut dyn Watch,
) -> Result<Option<Reached>, Failure> {
    let order = rising(loads);
    let risen: Vec<Load> = order.iter().map(|&i| loads[i]).collect();
    let task = Task { map: surface, setup, loads: &risen, aim };
    let mut to = ToWork { loads, order: &order, work, watch, part, materials, known: None };
    match climb(&task, &mut to) {
        Ok(reached) => Ok(Some(reached)),
        Err(LadderError::Stopped) => Ok(None),
        Err(e) => Err(Failure::from(&e)),
    }
}

/// Puts what comes by rising load into the order asked for.
struct ToWork<'a> {
    loads: &'a [Load],
    order: &'a [usize],
    work: &'a mut SolvedLoads,
    watch: &'a mut dyn Watch,
    part: Option<(&'a Joint, ContactModulus)>,
    materials: [f64; 2],
    known: Option<Map>,
}

impl Sink for ToWork<'_> {
    fn begin(&mut self, map: &HeightMap, known: &Map) {
        self.known = Some(*known);
        self.work.begin(map.grid());
        self.watch.begin(map.grid(), self.loads.len());
    }

    fn iterated(&mut self, index: usize, now: &Iteration<'_>) -> ControlFlow<()> {
        let place = self.order[index];
        self.watch.iterated(place, self.loads[place], now)
    }

    fn take(&mut self, index: usize, result: Result<Answered, SolverError>) -> ControlFlow<()> {
        let place = self.order[index];
        let load = self.loads[place];
        let result = result.map(|found| found.with_materials(self.materials));
        let Some(known) = self.known else { return ControlFlow::Break(()) };
        self.work.take(place, load, result, &known, self.part, self.watch);
        self.watch.done(place, load);
        ControlFlow::Continue(())
    }
}

/// A request that is not met ends with exit status 1.
pub(crate) fn unmet(surface: &str, reached: &Reached) -> Option<Failure> {
    let reason = plan_reason(reached)?;
    let percent = 100.0 * reached.request?.relative();
    let of = if surface.is_empty() { String::new() } else { format!("{surface}: ") };
    let message = format!("{of}an accuracy of {percent} % of the area is not met: {reason}");
    Some(Failure::incomplete("accuracy_not_met", message))
}
