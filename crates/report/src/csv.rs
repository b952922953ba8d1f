//! `curves.csv`: every number the figures over the load draw, units in the header.

use crate::lines::LoadLines;
use crate::messages::conduction::{conductance, kinds};
use contact_compare::{
    Comparison, ModelComparison, ProfileComparison, Settings, SurfaceComparison,
};
use contact_types::{ContactState, Named};

/// One row per surface and load. SI units; a missing number is an empty cell. Columns of
/// a model are `area_fraction_NAME` and `real_pressure_NAME [Pa]`, with its signed relative error.
pub(crate) fn of_surfaces(comparison: &Comparison) -> String {
    let models = comparison.surfaces.first().map_or(&[][..], |s| &s.models);
    let mut out = String::new();
    for surface in &comparison.surfaces {
        let panels = LoadLines::panels(surface);
        for load in 0..surface.deterministic.len() {
            let cells = cells(surface, &panels, load, models, &comparison.settings);
            let (heads, values): (Vec<String>, Vec<String>) =
                cells.into_iter().map(|(head, value)| (head, cell(value))).unzip();
            if out.is_empty() {
                out += &format!("surface,{}\n", heads.join(","));
            }
            out += &format!("{},{}\n", quoted(&surface.name), values.join(","));
        }
    }
    out
}

/// The columns of a surface at a load, each with its unit, and its numbers there.
fn cells(
    surface: &SurfaceComparison,
    panels: &[LoadLines],
    i: usize,
    models: &[ModelComparison],
    settings: &Settings,
) -> Vec<(String, Option<f64>)> {
    let lines = &panels[0];
    let (p, area, interval) = (lines.pressures[i], lines.area[i], lines.interval[i]);
    let answer = surface.deterministic[i].answer.as_ref();
    let real = |a: Option<f64>| a.filter(|a| *a > 0.0).map(|a| p / a);
    let [low, high] = [0, 1].map(|k| interval.map(|b| b[k]));
    let prediction = answer.and_then(|a| a.budget.area.prediction());
    let gap = answer.and_then(|a| a.budget.mean_gap?.interval().ok());
    let mut cells: Vec<(String, Option<f64>)> = Vec::new();
    let mut add = |head: &str, value| cells.push((head.to_owned(), value));
    add("mean_pressure [Pa]", Some(p));
    add("load [N]", Some(p * surface.nominal_area()));
    add("area_fraction_deterministic [-]", area);
    add("area_fraction_low [-]", low);
    add("area_fraction_high [-]", high);
    add("touching_fraction [-]", answer.map(|a| a.touching_fraction));
    add("real_pressure_deterministic [Pa]", real(area));
    add("real_pressure_low [Pa]", real(high));
    add("real_pressure_high [Pa]", real(low));
    add("mean_gap_deterministic [m]", answer.and_then(|a| a.mean_gap));
    add("area_fraction_prediction_low [-]", prediction.map(|r| r[0]));
    add("area_fraction_prediction_high [-]", prediction.map(|r| r[1]));
    add("mean_gap_low [m]", gap.map(|r| r[0]));
    add("mean_gap_high [m]", gap.map(|r| r[1]));
    if settings.hardness.is_some() {
        let yielded = answer.and_then(|a| a.diagnostics.yielded);
        let elastic = surface.elastic.get(i).and_then(|p| Some(p.answer.as_ref()?.area_fraction));
        add("area_fraction_at_hardness [-]", yielded.map(|y| y.area_fraction));
        add("load_share_at_hardness [-]", yielded.map(|y| y.load_share));
        add("area_fraction_elastic [-]", elastic);
        add("real_pressure_elastic [Pa]", real(elastic));
    }
    if let Some(found) = &surface.conduction {
        let stiffness = found.stiffness[i];
        add("stiffness [Pa/m]", stiffness);
        for kind in kinds(found) {
            let head = format!("{}_conductance [{}]", kind.name, kind.plain_unit);
            add(&head, stiffness.map(|k| conductance(kind, k)));
        }
        if found.joint.gas.is_some() {
            let of = surface.conducted(i);
            add("gas_conductance [W/m^2/K]", of.and_then(|c| Some(c.gas?.value)));
            add("joint_conductance [W/m^2/K]", of.and_then(|c| Some(c.joint?.value)));
        }
    }
    if let Some(asked) = settings.leak {
        let leaks = surface.leaks.get(i).and_then(Option::as_ref);
        for (k, axis) in asked.along.axes().iter().enumerate() {
            let along = leaks.and_then(|l| l.along.get(k)?.1.as_ref().ok()?.permeability());
            add(&format!("permeability_{} [m^3]", axis.name()), along);
        }
        let [plates, bruggeman] = [0, 1].map(|k| leaks.map(|l| l.closed_forms()[k].1));
        add("permeability_mean_gap_cubed [m^3]", plates);
        add("permeability_bruggeman [m^3]", bruggeman);
    }
    for model in models {
        let mut all = panels.iter().flat_map(|p| p.models.iter().map(move |line| (p, line)));
        let found = all.find(|(_, line)| line.name == model.card.name);
        let area = found.and_then(|(_, line)| line.values[i]);
        let error = found.and_then(|(panel, line)| panel.errors(line)[i]);
        let name = model.card.name.replace('-', "_");
        add(&format!("area_fraction_{name} [-]"), area);
        add(&format!("real_pressure_{name} [Pa]"), real(area));
        add(&format!("area_error_{name} [-]"), error);
    }
    cells
}

/// One row per profile and load. SI units; a missing number is an empty cell. Columns of a
/// model are its area fraction with the ends of its interval, and its real pressure.
pub(crate) fn of_profiles(studies: &[ProfileComparison]) -> String {
    let models = studies.first().map_or(&[][..], |study| &study.models);
    let columns = |model: &ModelComparison| {
        let name = model.card.name.replace('-', "_");
        format!(
            ",area_fraction_{name} [-],area_fraction_low_{name} [-],area_fraction_high_{name} [-],\
             real_pressure_{name} [Pa]"
        )
    };
    let heads: String = models.iter().map(columns).collect();
    let mut out = format!("surface,mean_pressure [Pa]{heads}\n");
    for study in studies {
        for (i, p) in study.pressures.iter().enumerate() {
            out += &format!("{},{p:e}", quoted(&study.surface.name));
            for model in &study.models {
                let curve = model.outcome.as_ref().ok();
                let state = curve.and_then(|c| c.points[i].as_ref().ok());
                let ends = curve.and_then(|c| c.intervals[i]);
                let [low, high] = [0, 1].map(|k| ends.map(|ends| ends[k]));
                let area = state.map(|s| s.area_fraction);
                for value in [area, low, high, state.and_then(ContactState::real_pressure)] {
                    out += &value.map_or(",".into(), |v| format!(",{v:e}"));
                }
            }
            out.push('\n');
        }
    }
    out
}

/// The shortest decimal that reads back as the same number.
pub(crate) fn cell(value: Option<f64>) -> String {
    value.filter(|v| v.is_finite()).map_or(String::new(), |v| {
        if v != 0.0 && !(1e-4..1e7).contains(&v.abs()) { format!("{v:e}") } else { format!("{v}") }
    })
}

/// A text cell, quoted where RFC 4180 asks for it, harmless to spreadsheets.
pub(crate) fn quoted(text: &str) -> String {
    // A leading =, +, - or @ would be taken for a formula.
    let text =
        if text.starts_with(['=', '+', '-', '@']) { format!("'{text}") } else { text.into() };
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_read_back_and_names_are_quoted() {
        for v in [1.0 / 3.0, 1e-9 / 3.0, 2.5e11, 0.0, -0.25] {
            assert_eq!(cell(Some(v)).parse::<f64>().unwrap().to_bits(), v.to_bits());
        }
        assert_eq!(cell(Some(f64::NAN)), "");
        assert_eq!(quoted("a,\"b\""), "\"a,\"\"b\"\"\"");
        assert_eq!(quoted("=1+1"), "'=1+1");
    }
}
