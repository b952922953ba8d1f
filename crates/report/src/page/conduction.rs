//! "What it conducts": where resistivities or conductivities were given.

use crate::draw::svg::escape;
use crate::figures::conduction::{self as figures, Line};
use crate::looks::look;
use crate::numbers::{relative_interval, significant};
use crate::page::context::Page;
use crate::page::sections::figure;
use crate::sources::CONDUCTANCE;
use crate::words::conduction::{conductance, joint_words, kinds, octaves, resistances, scientific};
use compare::{SurfaceComparison, TheoryStiffness};

/// Numbers at the headline, conductance over the load, and what the shortest waves do to it.
pub(crate) fn section(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let Some(found) = &surface.conduction else { return String::new() };
    let h = page.heading();
    let barber = page.source(CONDUCTANCE);
    let p = crate::words::headline_load(surface);
    let estimate = surface.headline_answer().and_then(|a| a.budget.stiffness);
    let stated = estimate.and_then(|k| k.stated());
    let mut rows = String::new();
    let mut row = |name: &str, value: String, why: &str| {
        rows.push_str(&format!(
            "<tr><th scope=\"row\">{name}</th><td class=\"n\">{value}</td><td class=\"why\">{why}</td></tr>\n"
        ));
    };
    let conducted = surface.conducted(surface.headline);
    if let Some(all) = &conducted {
        for r in resistances(all) {
            let beside = r.beside().unwrap_or_default();
            row(r.name, r.value, &beside);
        }
        let each = [
            ("Electrical conductance", all.electrical, "S/m²", "of the contact, per nominal area"),
            ("Thermal conductance", all.thermal, "W/m²/K", "of the contact, per nominal area"),
            (
                "Conductance of the gas",
                all.gas,
                "W/m²/K",
                "parallel plates locally, ⟨<i>k</i>/(gap + <i>M</i>)⟩",
            ),
            ("Conductance of the joint", all.joint, "W/m²/K", "contact and gas"),
        ];
        for (name, found, unit, why) in each {
            let Some(found) = found else { continue };
            let spread = found.estimate.and_then(|e| Some(relative_interval(e.value, e.stated()?)));
            let spread = spread.map_or_else(String::new, |text| format!(" {}", escape(&text)));
            row(name, format!("{}{spread}", scientific(found.value, unit)), why);
        }
        let gas = found.joint.gas.map(|gas| gas.conductivity());
        for (theory, k) in found.theories.iter().zip(gas.into_iter().cycle()) {
            let Some(at) = theory.gas.get(surface.headline).copied().flatten() else { continue };
            let name = format!("Gas by {}", theory.label);
            row(
                &name,
                scientific(at * k, "W/m²/K"),
                "Gaussian heights at the separation of the theory",
            );
        }
    }
    let covers = match (stated, estimate.and_then(|k| k.sampling)) {
        (None, _) => "",
        (Some(_), Some(_)) => "± of the surface. ",
        (Some(_), None) => "± of this map. ",
    };
    let gap = surface.headline_answer().and_then(|a| a.mean_gap);
    let gap = joint_words(&found.joint, gap.as_slice());
    let lead = octaves(found).map_or_else(String::new, |text| format!("<p>{text}</p>\n"));
    let mut out = format!(
        "<{h}>What it conducts at {p}</{h}>\n{lead}<table class=\"key\"><tbody>\n{rows}</tbody></table>\n\
         <p class=\"why\">{covers}{gap} From the stiffness of the contact set [<a href=\"#r{barber}\">{barber}</a>], beyond the column of bulk material; clean bodies, spots much larger than the free path of what \
         carries the current; no film, plating or fritting, both bodies half spaces on the scale of the \
         contact.</p>\n<div class=\"two\">\n",
    );
    let drawn = kinds(found).into_iter().find(|k| k.factor > 0.0 && k.factor.is_finite());
    if let Some(kind) = drawn {
        let n = page.next_figure();
        let of = |values: &[Option<f64>]| -> Vec<Option<f64>> {
            values.iter().map(|k| k.map(|k| conductance(kind, k))).collect()
        };
        // Correlations are no models of the study: no other figure has their series.
        let theory = |theory: &'_ TheoryStiffness| {
            let (name, values) = (theory.name.clone(), of(&theory.stiffness));
            let is_correlation = ["mikic", "cmy"].contains(&name.as_str());
            let series = if is_correlation { String::new() } else { name.clone() };
            Line { label: theory.label.clone(), series, look: look(&name, 0), values }
        };
        let lines: Vec<Line> = found.theories.iter().map(theory).collect();
        let gamma = found.theories.iter().find_map(|theory| theory.gamma);
        let gamma = gamma.map_or_else(String::new, |g| {
            format!(" Persson’s gap with γ = {}.", significant(g, 3))
        });
        let yields = found.yields();
        let pressures: Vec<f64> = surface.deterministic.iter().map(|p| p.mean_pressure).collect();
        let deterministic = of(&found.stiffness);
        let svg = figures::over_load(
            (&pressures, surface.load_area),
            &deterministic,
            &lines,
            kind.per_area,
            &format!("{id}-f{n}"),
        );
        out.push_str(&figure(
            &svg.inline(),
            &format!(
                "<b>Fig. {n}. {} conductance of the contact</b> per nominal area. Dots: of the contact set of \
                 each solution. Coloured: stiffness of theories of elastic contact, by the same factor. Grey: Mikic’s correlation \
                 for elastic bodies{}, with the rms height σ of the map and the mean absolute slope <i>g</i>/√π of a \
                 Gaussian one; Mikic’s ends where half the surface is cut.{gamma}",
                capital(kind.name),
                if yields { " and Cooper, Mikic and Yovanovich’s (CMY) for bodies that yield" } else { "" }
            ),
        ));
    }
    if found.octaves.len() > 1 {
        let n = page.next_figure();
        out.push_str(&figure(
            &figures::octaves(&found.octaves, &format!("{id}-f{n}")).inline(),
            &format!(
                "<b>Fig. {n}. Without the shortest waves</b>: area and conductance at {p} on the map without its \
                 shortest octave, the next, and so on, over those of the whole map. Same points, same load."
            ),
        ));
    }
    out.push_str("</div>\n");
    out
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().collect::<String>() + letters.as_str()
    })
}
