//! `curves.csv`: every number the figures over the load draw, units in the header.

use crate::lines::Lines;
use crate::messages::conduction::{conductance, kinds};
use contact_compare::{Comparison, Conductance, Settings, SurfaceComparison};
use contact_types::Named;
use std::fmt::Write as _;
use std::io::{self, Write};

/// Columns of bodies that yield, and of elastic ones beside them.
const YIELDING: &str = ",area_fraction_at_hardness [-],load_share_at_hardness [-],area_fraction_elastic [-],\
                        real_pressure_elastic [Pa]";

/// Columns of a gas in the gap.
const GAS: &str = ",gas_conductance [W/m^2/K],joint_conductance [W/m^2/K]";

/// Columns of closed forms of the leak.
const LEAK: &str = ",permeability_mean_gap_cubed [m^3],permeability_bruggeman [m^3]";

/// Writes one row per surface and load. SI units; a missing number is an empty cell. Columns of
/// a model are `area_fraction_NAME` and `real_pressure_NAME [Pa]`, with its signed relative error.
///
/// # Errors
/// Whatever the writer reports.
pub fn write(comparison: &Comparison, out: &mut impl Write) -> io::Result<()> {
    let mut header = String::from(
        "surface,mean_pressure [Pa],load [N],area_fraction_deterministic [-],area_fraction_low [-],\
         area_fraction_high [-],touching_fraction [-],real_pressure_deterministic [Pa],\
         real_pressure_low [Pa],real_pressure_high [Pa],mean_gap_deterministic [m],\
         area_fraction_prediction_low [-],area_fraction_prediction_high [-],mean_gap_low [m],\
         mean_gap_high [m]",
    );
    let yields = comparison.settings.hardness.is_some();
    if yields {
        header.push_str(YIELDING);
    }
    let conducts = comparison.surfaces.iter().find_map(|s| s.conduction.as_ref());
    if let Some(found) = conducts {
        header.push_str(",stiffness [Pa/m]");
        for kind in kinds(found) {
            let _ = write!(header, ",{}_conductance [{}]", kind.name, kind.plain_unit);
        }
        header.push_str(if found.joint.gas.is_some() { GAS } else { "" });
    }
    let axes = comparison.settings.leak.map_or(&[][..], |leak| leak.along.axes());
    for axis in axes {
        let _ = write!(header, ",permeability_{} [m^3]", axis.name());
    }
    header.push_str(if axes.is_empty() { "" } else { LEAK });
    let asked = comparison.surfaces.first().map_or(&[][..], |s| &s.models);
    let models: Vec<&str> = asked.iter().map(|m| m.card.name.as_ref()).collect();
    for model in &models {
        let name = model.replace('-', "_");
        let _ = write!(
            header,
            ",area_fraction_{name} [-],real_pressure_{name} [Pa],area_error_{name} [-]"
        );
    }
    writeln!(out, "{header}")?;
    for surface in &comparison.surfaces {
        write_surface(surface, &models, &comparison.settings, out)?;
    }
    Ok(())
}

fn write_surface(
    surface: &SurfaceComparison,
    models: &[&str],
    settings: &Settings,
    out: &mut impl Write,
) -> io::Result<()> {
    let (yields, leak) = (settings.hardness.is_some(), settings.leak);
    let panels = Lines::panels(surface);
    let lines = &panels[0];
    let name = quoted(&surface.name);
    let nominal_area = surface.nominal_area();
    for (i, &p) in lines.pressures.iter().enumerate() {
        let area = lines.area[i];
        let interval = lines.interval[i];
        let answer = surface.deterministic[i].answer.as_ref();
        let real = |a: Option<f64>| a.filter(|a| *a > 0.0).map(|a| p / a);
        let mut cells = vec![
            Some(p),
            Some(p * nominal_area),
            area,
            interval.map(|b| b[0]),
            interval.map(|b| b[1]),
            answer.map(|a| a.touching_fraction),
            real(area),
            real(interval.map(|b| b[1])),
            real(interval.map(|b| b[0])),
            answer.and_then(|a| a.mean_gap),
        ];
        let prediction = answer.and_then(|a| a.budget.area.prediction());
        let gap = answer.and_then(|a| a.budget.mean_gap?.interval().ok());
        for range in [prediction, gap] {
            cells.extend([range.map(|r| r[0]), range.map(|r| r[1])]);
        }
        if yields {
            let yielded = answer.and_then(|a| a.yielded);
            let elastic = surface.elastic.get(i).and_then(|p| p.answer.as_ref());
            let elastic = elastic.map(|a| a.area_fraction);
            cells.extend([
                yielded.map(|y| y.area_fraction),
                yielded.map(|y| y.load_share),
                elastic,
                real(elastic),
            ]);
        }
        if let Some(found) = &surface.conduction {
            let stiffness = found.stiffness[i];
            cells.push(stiffness);
            cells.extend(kinds(found).into_iter().map(|kind| Some(conductance(kind, stiffness?))));
            if found.joint.gas.is_some() {
                let of = surface.conducted(i);
                let value = |h: Option<Conductance>| h.map(|h| h.value);
                cells.extend([of.and_then(|c| value(c.gas)), of.and_then(|c| value(c.joint))]);
            }
        }
        if let Some(asked) = leak {
            let leaks = surface.leaks.get(i).and_then(Option::as_ref);
            let along = |k: usize| leaks?.along.get(k)?.1.as_ref().ok()?.permeability();
            cells.extend((0..asked.along.axes().len()).map(along));
            cells.extend([0, 1].map(|k| Some(leaks?.closed_forms()[k].1)));
        }
        for model in models {
            let mut all = panels.iter().flat_map(|p| p.models.iter().map(move |line| (p, line)));
            let found = all.find(|(_, line)| line.name == *model);
            let area = found.and_then(|(_, line)| line.area[i]);
            let error = found.and_then(|(panel, line)| panel.errors(line)[i]);
            cells.extend([area, real(area), error]);
        }
        let row: Vec<String> = cells.into_iter().map(cell).collect();
        writeln!(out, "{name},{}", row.join(","))?;
    }
    Ok(())
}

/// Writes contact spots as a table, one row each.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_spots(spots: &[contact_compare::Spot], out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "area (m^2),load (N),x (m),y (m),mean_pressure (Pa),max_pressure (Pa),points")?;
    for spot in spots {
        let [y, x] = spot.centroid;
        let row = [spot.area, spot.load, x, y, spot.mean_pressure, spot.max_pressure];
        let row: Vec<String> = row.into_iter().map(|v| cell(Some(v))).collect();
        writeln!(out, "{},{}", row.join(","), spot.points)?;
    }
    Ok(())
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
