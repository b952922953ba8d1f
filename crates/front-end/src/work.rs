//! What is collected while loads are solved: one point each, and what went wrong.

use crate::failure::{Failure, variant};
use crate::loads::shown;
use crate::point::Point;
use crate::watch::Watch;
use contact_accuracy::{Answered, Leaks, Map};
use contact_compare::{
    Budget, Conducted, Distributions, Joint, LeakRequest, NoUncertainty, Pressed, Spikes,
    contact_spots,
};
use contact_types::{ContactModulus, Grid};
use fft_bem_solver::{Load, SetStiffness, Solution, SolverError};
use serde_json::{Value, json};
use surface_stats::Level;

/// What is collected while the loads are solved. Fields go to who watches and are dropped.
pub(crate) struct SolvedLoads {
    /// Distributions are wanted: whether a spot at one edge goes on at the other.
    pub(crate) distributions: Option<bool>,
    pub(crate) leak: Option<LeakRequest>,
    pub(crate) trouble: Option<Failure>,
    pub(crate) method: String,
    pub(crate) level: Level,
    pub(crate) points: Vec<Option<Point>>,
    pub(crate) grid: Grid,
    /// The grid of the map as given.
    pub(crate) given: Grid,
    /// Spikes of the map as given, and the largest share of the load they carry on it.
    pub(crate) spikes: Spikes,
    pub(crate) spike_share: Option<f64>,
}

impl SolvedLoads {
    /// Of each load taken: why its area has no uncertainty, if it has none.
    pub(crate) fn without_uncertainty(&self) -> Vec<Option<NoUncertainty>> {
        self.points.iter().flatten().map(|point| point.without_uncertainty).collect()
    }

    /// The solutions of the loads that converged, with their budgets.
    fn converged(&self) -> impl Iterator<Item = (&Solution, &Budget)> {
        let converged = self.points.iter().flatten().filter(|point| point.converged);
        converged.filter_map(|point| Some((point.solution.as_ref()?, point.budget.as_ref()?)))
    }

    /// Touching fraction and contact perimeter of each load that was solved.
    pub(crate) fn touching(&self) -> Vec<[f64; 2]> {
        let solved = self.points.iter().flatten().filter_map(|point| point.solution.as_ref());
        solved.map(|s| [s.touching_fraction(), s.diagnostics.contact_perimeter]).collect()
    }

    /// Mean pressure and area fraction of each load that converged.
    pub(crate) fn contacts(&self) -> Vec<[f64; 2]> {
        let states = self.converged().map(|(solution, _)| &solution.state);
        states.map(|state| [state.mean_pressure, state.area_fraction]).collect()
    }

    /// What presses at each load that converged, by rising load.
    pub(crate) fn pressed(&self) -> Vec<Pressed> {
        let pressed = |(solution, budget): (&Solution, &Budget)| {
            let mean = budget.real_pressure()?.value;
            Some(Pressed::of(solution.state.mean_pressure, mean, solution.diagnostics.max_pressure))
        };
        let mut all: Vec<Pressed> = self.converged().filter_map(pressed).collect();
        all.sort_by(|a, b| a.nominal.total_cmp(&b.nominal));
        all
    }

    /// Forgets what was taken: the loads are solved again, on `grid`.
    pub(crate) fn begin(&mut self, grid: Grid) {
        self.points.iter_mut().for_each(|point| *point = None);
        self.trouble = None;
        self.grid = grid;
    }

    /// Of each load taken: its indicator, and its area on twice the points.
    pub(crate) fn indicators(&self) -> Vec<(Option<f64>, Option<f64>)> {
        let of = |p: &Point| (p.budget.and_then(|b| b.indicator), p.finer.map(|n| n.area));
        self.points.iter().flatten().map(of).collect()
    }

    /// A load by its place in the list; its maps go to `watch`. What it conducts, if that was asked for.
    pub(crate) fn take(
        &mut self,
        index: usize,
        load: Load,
        result: Result<Answered, SolverError>,
        known: &Map,
        part: Option<(&Joint, ContactModulus)>,
        watch: &mut dyn Watch,
    ) {
        let mut point = match &result {
            Ok(answered) => Point::of(load, answered),
            Err(error) => Point::of_error(load, error, known),
        };
        let solution = match result {
            Ok(mut answered) => {
                if let (Some(set), Some(part)) = (&answered.set, part) {
                    point.conducted = conducted(part, &mut point.json, set, &answered.budget);
                }
                point.leak = answered.leak.take().filter(|_| self.leak.is_some());
                point.leak.iter_mut().for_each(Leaks::drop_maps);
                point.without_uncertainty = answered.budget.area.half_width().err();
                let share = self.spikes.share(self.given.len(), &answered.solution.pressure);
                self.spike_share = share.into_iter().chain(self.spike_share).reduce(f64::max);
                Some(answered.solution)
            }
            Err(error) => {
                let message = format!("{}: {error}", shown(load));
                // Above the hardness nothing was solved, which is said of itself.
                let is_solved = !matches!(error, SolverError::AboveHardness { .. });
                let at_rounding = matches!(error, SolverError::Rounding(_));
                point.without_uncertainty =
                    is_solved.then_some(NoUncertainty::NotConverged { at_rounding });
                self.report(match &error {
                    SolverError::NotConverged(_) => Failure::incomplete("not_converged", message),
                    SolverError::Rounding(_) => Failure::incomplete("stopped_at_rounding", message),
                    other => Failure::refused(&variant(other), message),
                });
                iterate(error)
            }
        };
        if let Some(asked) = &self.leak {
            let object = |leaks: &Leaks| contact_report::leak_point_json(asked, leaks);
            point.json["leak"] = json!(point.leak.as_ref().map(object));
        }
        if let Some(mut solution) = solution {
            if let Some(repeats) = self.distributions {
                let (spots, _) = contact_spots(&solution.pressure, self.grid, repeats);
                let found = Distributions::of(&solution.pressure, &solution.gap, &spots);
                point.json["distributions"] = json!(found);
            }
            self.method = solution.diagnostics.method.to_string();
            if let Err(failure) = watch.keep(index, self.grid, &mut solution) {
                self.report(failure);
            }
            (solution.pressure, solution.gap) = (Vec::new(), Vec::new());
            point.solution = Some(solution);
        }
        self.points[index] = Some(point);
    }

    fn report(&mut self, failure: Failure) {
        self.trouble = self.trouble.take().into_iter().chain([failure]).reduce(Failure::and);
    }
}

/// Adds what the contact of a solution conducts to its point, if that was asked for.
fn conducted(
    (joint, modulus): (&Joint, ContactModulus),
    point: &mut Value,
    set: &SetStiffness,
    budget: &Budget,
) -> Option<Conducted> {
    if !joint.is_asked() {
        return None;
    }
    let found = joint.of_budget(set.per_area, budget, modulus);
    if let Value::Object(keys) = point {
        let of_set = match set.per_area {
            k if k <= 0.0 => "none",
            k if k.is_finite() => "part",
            _ => "everything",
        };
        let conduction = json!({
            "residual": set.residual, "transforms": set.transforms, "iterations": set.iterations,
        });
        let stiffness = Some(set.per_area).filter(|k| k.is_finite());
        keys.extend(contact_report::conducted_keys(&found));
        keys.insert("stiffness".into(), json!(stiffness));
        keys.insert("contact_set".into(), json!(of_set));
        keys.insert("conduction".into(), conduction);
    }
    Some(found)
}

fn iterate(error: SolverError) -> Option<Solution> {
    match error {
        SolverError::NotConverged(reached)
        | SolverError::Rounding(reached)
        | SolverError::Stopped(reached) => Some(*reached),
        _ => None,
    }
}
