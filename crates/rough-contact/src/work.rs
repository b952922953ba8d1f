//! What is collected while loads are solved: one point each, maps on the disk, what went wrong.

use crate::fields::{Sink, spots};
use crate::hardness;
use crate::intervals::{Intervals, Refined};
use crate::loads::shown;
use crate::outcome::{Failure, variant};
use crate::text;
use compare::budget::{Budget, Given, NoAreaInterval, RealPressure};
use compare::{Distributions, Ended, NotRefined, Pressed, Spikes};
use contact_types::Grid;
use fft_bem_solver::{End, Load, Solution, SolverError};
use serde_json::{Value, json};

/// A load that was solved for.
pub(crate) struct Point {
    pub(crate) json: Value,
    pub(crate) cells: Vec<String>,
}

/// What is collected while the loads are solved. Fields go to the map files and are dropped.
pub(crate) struct Work {
    maps: Option<Sink>,
    /// Distributions are wanted: whether a spot at one edge goes on at the other.
    pub(crate) distributions: Option<bool>,
    pub(crate) trouble: Option<Failure>,
    pub(crate) method: String,
    pub(crate) points: Vec<Option<Point>>,
    pub(crate) intervals: Intervals,
    pub(crate) grid: Grid,
    /// What presses at each load that converged.
    pressed: Vec<Option<Pressed>>,
    /// The grid of the map as given.
    given: Grid,
    /// Spikes of the map as given, and the largest share of the load they carry on it.
    pub(crate) spikes: Spikes,
    pub(crate) spike_share: Option<f64>,
    /// How each load ended, and why its area has no bar.
    found: Vec<Option<(Ended, Option<NoAreaInterval>)>>,
}

impl Work {
    /// Nothing yet, of so many loads.
    pub(crate) fn new(maps: Option<Sink>, loads: usize, method: String, grid: Grid) -> Self {
        Self {
            maps,
            distributions: None,
            trouble: None,
            method,
            points: (0..loads).map(|_| None).collect(),
            intervals: Intervals::default(),
            grid,
            given: grid,
            spikes: Spikes::default(),
            spike_share: None,
            pressed: vec![None; loads],
            found: vec![None; loads],
        }
    }

    /// Of each load taken: how it ended, and why its area has no bar, if it has none.
    pub(crate) fn found(&self) -> Vec<(Ended, Option<NoAreaInterval>)> {
        self.found.iter().copied().flatten().collect()
    }

    /// What presses at each load that converged, by rising load.
    pub(crate) fn pressed(&self) -> Vec<Pressed> {
        let mut all: Vec<Pressed> = self.pressed.iter().copied().flatten().collect();
        all.sort_by(|a, b| a.nominal.total_cmp(&b.nominal));
        all
    }

    /// Forgets what was taken: the loads are solved again, on `grid`.
    pub(crate) fn begin(&mut self, grid: Grid) {
        self.points.iter_mut().for_each(|point| *point = None);
        self.found.iter_mut().for_each(|found| *found = None);
        self.pressed.iter_mut().for_each(|pressed| *pressed = None);
        self.trouble = None;
        self.intervals = Intervals::default();
        self.grid = grid;
    }

    /// A load by its place in the list, with the errors of its numbers.
    pub(crate) fn take(
        &mut self,
        index: usize,
        load: Load,
        result: &Result<Solution, SolverError>,
        budget: Option<&Budget>,
        refined: Option<Result<Refined, NotRefined>>,
    ) {
        let (solution, error) = match result {
            Ok(solution) => (Some(solution), None),
            Err(error) => (error.solution(), Some(error)),
        };
        let refined = match refined {
            Some(Err(why)) => {
                let message = format!("{}: {why}", shown(load));
                self.report(Failure::incomplete("not_refined", message));
                None
            }
            Some(Ok(refined)) => Some(refined),
            None => None,
        };
        let mut point = point(load, solution.zip(budget), error);
        point.json["refined"] = json!(refined.as_ref().map(Refined::json));
        if let (Some(repeats), Some(solution)) = (self.distributions, solution) {
            let spots = spots(solution, self.grid, repeats);
            let found = Distributions::of(&solution.pressure, &solution.gap, &spots);
            point.json["distributions"] = json!(found);
        }
        self.points[index] = Some(point);
        let bare = budget.and_then(|b| b.area.comparison_half_width().err());
        let ended = match error {
            None => Ended::Converged,
            Some(SolverError::Rounding(_)) => Ended::AtRounding,
            Some(_) => Ended::Short,
        };
        self.found[index] = Some((ended, bare));
        if let (Ok(solution), Some(budget)) = (result, budget) {
            self.pressed[index] = pressed(solution, budget);
            let share = self.spikes.share(self.given.len(), &solution.pressure);
            self.spike_share = share.into_iter().chain(self.spike_share).reduce(f64::max);
            self.intervals.take(&shown(load), solution, budget, refined);
        }
        if let Some(error) = error {
            let message = format!("{}: {error}", shown(load));
            self.report(match error {
                SolverError::NotConverged(_) => Failure::incomplete("not_converged", message),
                SolverError::Rounding(_) => Failure::incomplete("stopped_at_rounding", message),
                _ => Failure::refused(&variant(error), message),
            });
        }
        let Some(solution) = solution else { return };
        self.method = solution.diagnostics.method.to_string();
        if let Some(Err(failure)) =
            self.maps.as_ref().map(|maps| maps.write(index, self.grid, solution))
        {
            self.report(failure);
        }
    }

    fn report(&mut self, failure: Failure) {
        self.trouble = Some(match self.trouble.take() {
            None => failure,
            Some(earlier) => earlier.and(failure),
        });
    }
}

/// What presses at a load.
fn pressed(solution: &Solution, budget: &Budget) -> Option<Pressed> {
    let mean = budget.real_pressure()?.value();
    Some(Pressed::of(solution.state.mean_pressure, mean, solution.diagnostics.max_pressure))
}

fn point(load: Load, found: Option<(&Solution, &Budget)>, error: Option<&SolverError>) -> Point {
    let error_json = error.map(|e| json!({ "kind": variant(e), "message": e.to_string() }));
    let Some((solution, budget)) = found else {
        let asked = if let Load::MeanPressure(p) = load { Some(p) } else { None };
        let mut json = json!({
                "mean_pressure": asked, "area_fraction": null, "area_fraction_corrected": null,
                "mean_gap": if let Load::MeanGap(g) = load { Some(g) } else { None },
                "approach": null, "max_pressure": null, "real_pressure": null,
                "converged": false, "stopped_at_rounding": false, "iterations": null,
                "transforms": null, "seconds": null,
                "residuals": null, "duality_gap": null, "error": error_json,
        });
        with_keys(&mut json, None);
        return Point { json, cells: vec![shown(load), "refused".to_owned()] };
    };
    let (state, d) = (&solution.state, &solution.diagnostics);
    let real = state.real_pressure();
    let mut json = json!({
        "mean_pressure": state.mean_pressure,
        "area_fraction": state.area_fraction,
        "area_fraction_corrected": d.area_fraction_corrected,
        "mean_gap": state.mean_gap,
        "approach": solution.approach,
        "max_pressure": d.max_pressure,
        "real_pressure": real,
        "converged": error.is_none(),
        "stopped_at_rounding": d.end == End::Rounding,
        "iterations": d.iterations,
        "transforms": d.transforms,
        "seconds": d.seconds,
        "residuals": {
            "preconditioned": d.residuals.preconditioned,
            "complementarity": d.residuals.complementarity,
            "penetration": d.residuals.penetration,
        },
        "duality_gap": d.duality_gap,
        "energy_bound": d.energy_bound,
        "contact_pixels": d.contact_pixels,
        "contact_perimeter": d.contact_perimeter,
        "exact": d.exact,
        "error": error_json,
    });
    with_keys(&mut json, Some(budget));
    let mean = budget.real_pressure().map(RealPressure::value);
    let area = &budget.area;
    let mut cells = vec![text::pressure(state.mean_pressure)];
    if budget.given == Given::Gap {
        let load = budget.mean_pressure;
        let half = load.comparison_half_width().ok();
        cells.push(text::relative(half, load.value, text::pressure));
    }
    cells.extend([
        text::percent(state.area_fraction),
        text::percent(d.area_fraction_corrected),
        text::relative(area.comparison_half_width().ok(), area.value, |most| {
            text::percent(most.min(1.0))
        }),
        text::relative(area.prediction_half_width(), area.value, |most| {
            text::percent(most.min(1.0))
        }),
        state.mean_gap.map_or_else(|| "–".to_owned(), text::length),
        mean.map_or_else(|| "–".to_owned(), text::pressure),
        text::highest(d.max_pressure, mean),
        text::number(d.transforms),
        format!("{:.1e}", d.residuals.preconditioned),
        text::seconds(d.seconds),
    ]);
    cells.extend(budget.stiffness.map(|k| text::stiffness(k.value)));
    hardness::add(&mut json, &mut cells, solution);
    Point { json, cells }
}

/// Adds the keys of the budget, all `null` without one.
fn with_keys(point: &mut Value, budget: Option<&Budget>) {
    if let Value::Object(keys) = point {
        keys.extend(report::budget_keys(budget));
    }
}
