//! One surface: its features, the deterministic area with its own error bar, every model's error.

use crate::ensemble::{PIXEL, Recipe, make};
use compare::survey::{Family, Row, peak_slope};
use compare::{Card, Comparison, Level, Origin, Registry, Settings, Surface, Theory, built_in};
use contact_types::{ContactModulus, HeightMap};
use fft_bem_solver::{BOUNDARY_CORRECTION, Load, Solution, Solver};
use std::error::Error;
use std::ops::ControlFlow;

/// Contact modulus \[Pa\]; every ratio below is free of it.
const MODULUS: f64 = 1e11;

/// Mean pressure over E* h'_rms.
const LOADS: [f64; 7] = [0.003, 0.01, 0.03, 0.06, 0.1, 0.2, 0.4];

/// Models whose errors are kept, in the order of the list of models.
pub(crate) fn models() -> Vec<&'static Card> {
    built_in().of_maps().map(Theory::card).collect()
}

/// Everything the survey keeps of one surface, one row per load.
pub(crate) fn surface(index: usize, recipe: &Recipe) -> Result<Vec<Row>, Box<dyn Error>> {
    let [map, fine] = make(recipe)?;
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    // The gradient that scales the loads is that of the map the models see.
    let probe = study(index, &map, vec![1e-3 * MODULUS])?;
    let gradient = probe.surfaces[0].inputs.rms_gradient();
    let pressures: Vec<f64> = LOADS.iter().map(|x| x * MODULUS * gradient).collect();
    let study = study(index, &map, pressures.clone())?;
    let result = &study.surfaces[0];
    let statistics = &result.statistics;

    let mut solver = Solver::builder().tolerance(1e-5).build(fine.grid(), modulus)?;
    let mut rows = Vec::with_capacity(LOADS.len());
    for (k, &pressure) in pressures.iter().enumerate() {
        let truth = solver.solve(&fine, Load::MeanPressure(pressure))?;
        let area = truth.diagnostics.area_fraction_corrected;
        let given =
            result.deterministic[k].answer.as_ref().ok_or("no solution on the given grid")?;
        let errors = models()
            .iter()
            .map(|card| {
                let model = result.models.iter().find(|m| m.card.name == card.name)?;
                let state = model.outcome.as_ref().ok()?.points[k].as_ref().ok()?;
                Some(state.area_fraction / area - 1.0)
            })
            .collect();
        rows.push(Row {
            surface: index,
            family: recipe.family,
            bandwidth: result.inputs.moments.ok_or("no moments")?.bandwidth(),
            resolved: statistics.rms_gradient / statistics.moments_spectral().rms_gradient(),
            anisotropy: statistics.anisotropy.unwrap_or(1.0),
            skewness: statistics.skewness.unwrap_or(0.0),
            kurtosis: statistics.kurtosis.unwrap_or(3.0),
            step: statistics.height_step.map_or(0.0, |q| q / (PIXEL * gradient)),
            peak_slope: peak_slope(&map, given.area_fraction_corrected),
            load: LOADS[k],
            area,
            bar: bar(recipe.family, &truth, given.area_fraction_corrected),
            errors,
        });
    }
    Ok(rows)
}

fn study(index: usize, map: &HeightMap, pressures: Vec<f64>) -> Result<Comparison, Box<dyn Error>> {
    let surface = Surface {
        name: format!("survey {index}"),
        origin: Origin::Recipe(compare::built_in_recipes()?.remove(0)),
        heights: map.clone(),
    };
    let settings = Settings {
        modulus: MODULUS,
        pressures: Some(pressures),
        level: Level::Mean,
        tolerance: 1e-5,
        ..Settings::default()
    };
    Ok(Comparison::run(vec![surface], settings, &Registry::built_in(), &mut |_| {
        ControlFlow::Continue(())
    })?)
}

/// Relative half width of the reference: 0.3 of the correction on the fine grid, or what refining
/// changed, whichever is larger. A stepped map has no finer truth of its own; what refining
/// changed is then the effect of the steps, not an error of the reference.
fn bar(family: Family, truth: &Solution, given: f64) -> f64 {
    let area = truth.diagnostics.area_fraction_corrected;
    let grid = 0.3 * BOUNDARY_CORRECTION * truth.diagnostics.contact_perimeter;
    let refined = if family == Family::Stepped { 0.0 } else { (area - given).abs() };
    grid.max(refined) / area
}
