//! What is collected while loads are solved: one point each, and what went wrong.

use crate::failure::{Failure, variant};
use crate::loads::{rising, shown};
use contact_accuracy::{Answered, Leaks, Map, Numbers, Sink};
use contact_compare::{
    Conducted, DeterministicAnswer, Distributions, Joint, NoUncertainty, Pressed, Settings, Solved,
    Spikes, contact_spots,
};
use contact_types::{ContactModulus, Grid, HeightMap, Named};
use fft_bem_solver::{Iteration, Load, SetStiffness, Solution, SolverError};
use serde_json::{Value, json};
use std::ops::ControlFlow;

/// What is collected while the loads of a request are solved. Fields go to who watches and are dropped.
pub(crate) struct SolvedLoads<'a> {
    loads: &'a [Load],
    settings: &'a Settings,
    /// Distributions are wanted: whether a spot at one edge goes on at the other.
    distributions: Option<bool>,
    /// Places of the loads, by rising load.
    pub(crate) order: Vec<usize>,
    /// What the contact conducts, if that was asked for.
    part: Option<(Joint, ContactModulus)>,
    pub(crate) watch: &'a mut dyn Watch,
    /// What the map that is solved says before.
    pub(crate) known: Option<Map>,
    pub(crate) trouble: Option<Failure>,
    pub(crate) method: &'static str,
    pub(crate) points: Vec<Option<Point>>,
    pub(crate) grid: Grid,
    /// Spikes of the map as given, and the largest share of the load they carry on it.
    spikes: Spikes,
    spike_share: Option<f64>,
}

impl<'a> SolvedLoads<'a> {
    pub(crate) fn new(
        (loads, settings): (&'a [Load], &'a Settings),
        distributions: Option<bool>,
        part: Option<(Joint, ContactModulus)>,
        (grid, spikes): (Grid, Spikes),
        watch: &'a mut dyn Watch,
    ) -> Self {
        Self {
            loads,
            settings,
            distributions,
            order: rising(loads),
            part,
            watch,
            known: None,
            trouble: None,
            method: settings.method.name(),
            points: loads.iter().map(|_| None).collect(),
            grid,
            spikes,
            spike_share: None,
        }
    }

    fn answers(&self) -> impl Iterator<Item = &DeterministicAnswer> {
        self.points.iter().flatten().filter_map(|point| point.answer.as_ref())
    }

    /// Mean pressure and area fraction of each load that converged.
    pub(crate) fn contacts(&self) -> Vec<[f64; 2]> {
        let converged = self.answers().filter(|a| a.converged);
        converged.map(|a| [a.budget.mean_pressure.value, a.area_fraction]).collect()
    }

    /// Adds what was found of the loads taken.
    pub(crate) fn add_to(&self, solved: &mut Solved<'_>) {
        let of = |a: &DeterministicAnswer| (a.budget.indicator, a.finer.as_ref().map(|n| n.area));
        for point in self.points.iter().flatten() {
            solved.loads.push(point.without_uncertainty);
            solved.indicators.push(point.answer.as_ref().map_or((None, None), of));
        }
        let touching =
            |a: &DeterministicAnswer| [a.touching_fraction, a.diagnostics.contact_perimeter];
        solved.touching = self.answers().map(touching).collect();
        solved.spike_share = self.spike_share;
        // With a hardness no pressure is beyond it: nothing is left to warn of.
        if self.settings.hardness.is_none() {
            let pressed = |a: &DeterministicAnswer| {
                let (load, mean) = (a.budget.mean_pressure.value, a.budget.real_pressure()?.value);
                Some(Pressed::of(load, mean, a.diagnostics.max_pressure))
            };
            let all = &mut solved.scene.pressed;
            all.extend(self.answers().filter(|a| a.converged).filter_map(pressed));
            all.sort_by(|a, b| a.nominal.total_cmp(&b.nominal));
        }
    }

    fn report(&mut self, failure: Failure) {
        self.trouble = self.trouble.take().into_iter().chain([failure]).reduce(Failure::and);
    }
}

impl Sink for SolvedLoads<'_> {
    /// Forgets what was taken: the loads are solved again, on another grid.
    fn begin(&mut self, map: &HeightMap, known: &Map) {
        self.points.iter_mut().for_each(|point| *point = None);
        (self.known, self.trouble, self.grid) = (Some(*known), None, map.grid());
        self.watch.begin(self.grid, self.points.len());
    }

    fn iterated(&mut self, index: usize, now: &Iteration<'_>) -> ControlFlow<()> {
        let place = self.order[index];
        self.watch.iterated(place, self.loads[place], now)
    }

    /// A load by its place among the rising ones; its maps go to who watches.
    fn take(&mut self, index: usize, mut result: Result<Answered, SolverError>) -> ControlFlow<()> {
        let place = self.order[index];
        let (load, settings) = (self.loads[place], self.settings);
        let Some(known) = self.known else { return ControlFlow::Break(()) };
        let (mut set, mut leak, mut error, mut without_uncertainty) = (None, None, None, None);
        match &mut result {
            Ok(answered) => {
                (set, leak) = (answered.set.take(), answered.leak.take());
                leak.iter_mut().for_each(Leaks::drop_maps);
                let share = self.spikes.share(&answered.solution.pressure);
                self.spike_share = share.into_iter().chain(self.spike_share).reduce(f64::max);
            }
            Err(e) => {
                error = Some(json!({ "kind": variant(e), "message": e.to_string() }));
                // Where nothing was solved, that is said of itself.
                let at_rounding = matches!(e, SolverError::Rounding(_));
                without_uncertainty =
                    e.solution().map(|_| NoUncertainty::NotConverged { at_rounding });
                let message = format!("{}: {e}", shown(load));
                self.report(match e {
                    SolverError::NotConverged(_) => Failure::incomplete("not_converged", message),
                    SolverError::Rounding(_) => Failure::incomplete("stopped_at_rounding", message),
                    other => Failure::refused(&variant(other), message),
                });
            }
        }
        let (answer, solution) =
            DeterministicAnswer::of(result, &settings.materials, &known).unzip();
        let mut json = object(load, answer.as_ref(), error.as_ref());
        if let Some(answer) = answer.as_ref().filter(|a| a.converged) {
            without_uncertainty = answer.budget.area.half_width().err();
        }
        let conducted = set.zip(self.part.as_ref()).zip(answer.as_ref());
        let conducted = conducted.map(|((set, (joint, modulus)), answer)| {
            let found = joint.of_budget(set.per_area, &answer.budget, *modulus);
            extend(&mut json, conduction_keys(&set, &found));
            found
        });
        if let Some(asked) = &settings.leak {
            let object = |leaks: &Leaks| contact_report::leak_point_json(asked, leaks);
            json["leak"] = json!(leak.as_ref().map(object));
        }
        if let Some(mut solution) = solution {
            if let Some(repeats) = self.distributions {
                let (spots, _) = contact_spots(&solution.pressure, self.grid, repeats);
                let found = Distributions::of(&solution.pressure, &solution.gap, &spots);
                json["distributions"] = json!(found);
            }
            self.method = solution.diagnostics.method.name();
            if let Err(failure) = self.watch.keep(place, self.grid, &mut solution) {
                self.report(failure);
            }
        }
        let point = Point { load, json, force: None, answer, without_uncertainty, conducted, leak };
        self.points[place] = Some(point);
        self.watch.done(place, load);
        ControlFlow::Continue(())
    }
}

/// What the contact set of a solution conducts.
fn conduction_keys(set: &SetStiffness, found: &Conducted) -> serde_json::Map<String, Value> {
    let of_set = match set.per_area {
        k if k <= 0.0 => "none",
        k if k.is_finite() => "part",
        _ => "everything",
    };
    let mut keys = contact_report::conducted_keys(found);
    keys.insert("stiffness".into(), json!(Some(set.per_area).filter(|k| k.is_finite())));
    keys.insert("contact_set".into(), json!(of_set));
    let solved = json!({
        "residual": set.residual, "transforms": set.transforms, "iterations": set.iterations,
    });
    keys.insert("conduction".into(), solved);
    keys
}

/// A load that was solved for.
#[derive(Debug)]
pub struct Point {
    /// What was prescribed.
    pub load: Load,
    /// The object that scripts see; once all loads are answered it is part of theirs.
    pub(crate) json: Value,
    /// Its mean pressure as a force (N), if forces were asked for.
    pub force: Option<f64>,
    /// Its numbers; none of a load that was refused.
    pub answer: Option<DeterministicAnswer>,
    /// Why its area has no uncertainty, if it has none.
    pub(crate) without_uncertainty: Option<NoUncertainty>,
    /// What it conducts, if that was asked for.
    pub conducted: Option<Conducted>,
    /// What leaks through it, if that was asked for.
    pub leak: Option<Leaks>,
}

/// The numbers of another rung.
fn numbers(found: &Numbers) -> Value {
    json!({
        "area_fraction": found.area,
        "mean_pressure": found.mean_pressure,
        "mean_gap": found.mean_gap,
        "stiffness": found.stiffness,
    })
}

/// A load with its numbers, if it has any, and why it has none or misses its tolerance.
pub(crate) fn object(
    load: Load,
    found: Option<&DeterministicAnswer>,
    error: Option<&Value>,
) -> Value {
    let (pressure, gap) = match (found, load) {
        (Some(a), _) => (Some(a.budget.mean_pressure.value), a.mean_gap),
        (None, Load::MeanPressure(p)) => (Some(p), None),
        (None, Load::MeanGap(g)) => (None, Some(g)),
        _ => (None, None),
    };
    let mut json = json!({
        "mean_pressure": pressure,
        "area_fraction": found.map(|a| a.area_fraction),
        "mean_gap": gap,
        "converged": error.is_none(),
        "error": error,
    });
    let keys = found.map(|a| ([a.touching_fraction, a.approach], &a.diagnostics, &a.budget));
    extend(&mut json, contact_report::solution_keys(keys));
    if let Some(a) = found {
        json["exact"] = json!(a.diagnostics.exact);
        if a.converged {
            json["coarser"] = json!(a.coarser.iter().map(numbers).collect::<Vec<_>>());
            json["finer"] = json!(a.finer.as_ref().map(numbers));
        }
    }
    json
}

/// Adds keys to an object.
pub(crate) fn extend(object: &mut Value, keys: impl IntoIterator<Item = (String, Value)>) {
    if let Value::Object(own) = object {
        own.extend(keys);
    }
}

/// Who is told what happens, takes the maps, and may stop it.
pub trait Watch: Send {
    /// The map that is solved, once its form is off.
    fn levelled(&mut self, _map: &HeightMap) {}

    /// All loads begin, or begin again where a grid is chosen for an accuracy, on this one.
    fn begin(&mut self, _grid: Grid, _loads: usize) {}

    /// An iteration on a load, by its place in the list, is done. It is called on a thread of the solver.
    /// `Break` ends everything: what was solved is kept.
    fn iterated(&mut self, _index: usize, _load: Load, _now: &Iteration<'_>) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }

    /// A load was solved on this grid; the maps may be taken out of the solution.
    ///
    /// # Errors
    /// Why the maps could not be kept: the numbers of the load stay.
    fn keep(
        &mut self,
        _index: usize,
        _grid: Grid,
        _solution: &mut Solution,
    ) -> Result<(), Failure> {
        Ok(())
    }

    /// A load, by its place in the list, is done with, whether it was solved or not.
    fn done(&mut self, _index: usize, _load: Load) {}
}
