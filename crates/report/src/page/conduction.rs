//! Electrical and thermal contact conductance: where resistivities or conductivities were given.

use crate::draw::svg::escape;
use crate::figures::conduction as figures;
use crate::lines::LoadLine;
use crate::messages::conduction::{conductance, joint_words, kinds, scientific};
use crate::messages::finding::capital;
use crate::numbers::relative_interval;
use crate::page::shared::{CONDUCTANCE, SurfacePart, key_table};
use crate::plot_styles::plot_style;
use contact_compare::TheoryStiffness;

pub(crate) fn section(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, h, p, .. } = *part;
    let Some(found) = &surface.conduction else { return String::new() };
    let barber = part.numbers.source(CONDUCTANCE);
    let estimate = surface.headline_answer().and_then(|a| a.budget.stiffness);
    let stated = estimate.and_then(|k| k.stated());
    let mut rows: Vec<[String; 3]> = Vec::new();
    let conducted = surface.conducted(surface.headline);
    if let Some(all) = &conducted {
        let each = [
            ("Electrical conductance", all.electrical, "S/m²", "contact, per nominal area"),
            ("Thermal conductance", all.thermal, "W/m²/K", "contact, per nominal area"),
            ("Conductance of the gas", all.gas, "W/m²/K", "⟨<i>k</i>/(gap + <i>M</i>)⟩"),
            ("Conductance of the joint", all.joint, "W/m²/K", "contact and gas"),
        ];
        for (name, found, unit, why) in each {
            let Some(found) = found else { continue };
            let spread = found.estimate.and_then(|e| Some(relative_interval(e.value, e.stated()?)));
            let spread = spread.map_or_else(String::new, |text| format!(" {}", escape(&text)));
            let value = format!("{}{spread}", scientific(found.value, unit));
            rows.push([name.into(), value, why.into()]);
        }
        let gas = found.joint.gas.map(|gas| gas.conductivity());
        for (theory, k) in found.theories.iter().zip(gas.into_iter().cycle()) {
            let Some(at) = theory.gas.get(surface.headline).copied().flatten() else { continue };
            let name = format!("Gas by {}", theory.label);
            rows.push([name, scientific(at * k, "W/m²/K"), String::new()]);
        }
    }
    let covers = match (stated, estimate.and_then(|k| k.sampling)) {
        (None, _) => "",
        (Some(_), Some(_)) => "± of the surface. ",
        (Some(_), None) => "± of this map. ",
    };
    let gap = surface.headline_answer().and_then(|a| a.mean_gap);
    let gap = joint_words(&found.joint, gap.as_slice());
    let mut out = format!(
        "<{h}>Electrical and thermal contact conductance at {p}</{h}>\n{}\
         <p class=\"why\">{covers}{gap} From the stiffness at fixed contact area [<a href=\"#r{barber}\">{barber}</a>]; clean \
         bodies, no film or plating.</p>\n<div class=\"two\">\n",
        key_table("", &rows)
    );
    let drawn = kinds(found).into_iter().find(|k| k.factor > 0.0 && k.factor.is_finite());
    if let Some(kind) = drawn {
        let area = found.joint.area;
        let of = |values: &[Option<f64>]| -> Vec<Option<f64>> {
            let one = |k: f64| 1.0 / (conductance(kind, k) * area.unwrap_or(1.0));
            values.iter().map(|k| k.map(one)).collect()
        };
        let unit = if area.is_some() { kind.resistance } else { kind.of_area };
        // Correlations are no models of the study: no other figure has their series.
        let theory = |theory: &'_ TheoryStiffness| {
            let (name, values) = (theory.name.as_str(), of(&theory.stiffness));
            let series = if ["mikic", "cmy"].contains(&name) { "" } else { name };
            LoadLine::new(series, &theory.label, plot_style(name, 0), values)
        };
        let lines: Vec<LoadLine> = found.theories.iter().map(theory).collect();
        let deterministic = of(&found.stiffness);
        let yields = found.theories.iter().any(|theory| theory.name == "cmy");
        let title = format!("{} contact resistance", capital(kind.name));
        let drawn = figures::over_load(surface, &deterministic, &lines, (&title, unit));
        let caption = format!(
            "{title}</b>{}. Dots: solver. Grey: correlations of Mikic{}.",
            if area.is_some() { "" } else { " of unit nominal area" },
            if yields { " and of Cooper, Mikic and Yovanovich (CMY)" } else { "" }
        );
        out += &part.figure(drawn, &caption);
    }
    if found.octaves.len() > 1 {
        let caption = format!(
            "Without the shortest waves</b> at {p}: area and conductance over those of the whole map."
        );
        out += &part.figure(figures::octaves(&found.octaves), &caption);
    }
    out + "</div>\n"
}
