//! "What it conducts": where resistivities or conductivities were given.

use crate::draw::svg::escape;
use crate::figures::conduction::{self as figures, Line};
use crate::looks::look;
use crate::numbers::{PASCALS, chosen, relative_interval, significant};
use crate::page::context::Page;
use crate::page::sections::figure;
use crate::sources::CONDUCTANCE;
use crate::words::conduction::{conductance, kinds, octaves, scientific};
use compare::SurfaceComparison;

/// Numbers at the headline, conductance over the load, and what the shortest waves do to it.
pub(crate) fn section(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let Some(found) = &surface.conduction else { return String::new() };
    let h = page.heading();
    let barber = page.source(CONDUCTANCE);
    let p = chosen(surface.headline_pressure(), PASCALS);
    let at_headline = found.stiffness.get(surface.headline).copied().flatten();
    let area = surface.surface.grid().area();
    let estimate = surface.headline_answer().and_then(|a| a.budget.stiffness);
    let stated = estimate.and_then(|k| Some((k.value, k.stated()?)));
    let mut rows = String::new();
    for kind in kinds(found) {
        let Some(stiffness) = at_headline else { continue };
        let value = conductance(kind, stiffness);
        let spread = match stated {
            Some((k, ends)) if value > 0.0 && value.is_finite() => {
                format!(" {}", escape(&relative_interval(k, ends)))
            }
            _ => String::new(),
        };
        rows.push_str(&format!(
            "<tr><th scope=\"row\">{} conductance</th><td class=\"n\">{}{spread}</td><td class=\"why\">of the \
             contact, per nominal area; {} of this map</td></tr>\n",
            capital(kind.name),
            scientific(value, kind.per_area),
            scientific(value * area, kind.of_part),
        ));
    }
    let covers = match (stated, estimate.and_then(|k| k.sampling)) {
        (None, _) => "",
        (Some(_), Some(_)) => "± of the surface. ",
        (Some(_), None) => "± of this map. ",
    };
    let lead = octaves(found).map_or_else(String::new, |text| format!("<p>{text}</p>\n"));
    let mut out = format!(
        "<{h}>What it conducts at {p}</{h}>\n{lead}<table class=\"key\"><tbody>\n{rows}</tbody></table>\n\
         <p class=\"why\">{covers}From the stiffness of the contact set [<a href=\"#r{barber}\">{barber}</a>], beyond the column of bulk material; clean bodies, spots much larger than the free path of what \
         carries the current; no film, no current through the gap, both bodies half spaces on the scale of the \
         contact.</p>\n<div class=\"two\">\n",
    );
    let drawn = kinds(found).into_iter().find(|k| k.factor > 0.0 && k.factor.is_finite());
    if let Some(kind) = drawn {
        let n = page.next_figure();
        let of = |values: &[Option<f64>]| -> Vec<Option<f64>> {
            values.iter().map(|k| k.map(|k| conductance(kind, k))).collect()
        };
        let theories = found.theories.iter().map(|theory| Line {
            label: &theory.label,
            series: &theory.name,
            look: look(&theory.name, 0),
            values: of(&theory.stiffness),
        });
        let mut lines: Vec<Line<'_>> = theories.collect();
        // Correlations are no models of the study: in the looks of strangers.
        let stranger =
            |label, place, values| Line { label, series: "", look: look("", place), values };
        lines.push(stranger("Mikic", 1, of(&found.mikic)));
        let gamma = found.theories.iter().find_map(|theory| theory.gamma);
        let gamma = gamma.map_or_else(String::new, |g| {
            format!(" Persson’s gap with γ = {}.", significant(g, 3))
        });
        let yields = !found.yovanovich.is_empty();
        if yields {
            lines.push(stranger("CMY", 0, of(&found.yovanovich)));
        }
        let pressures: Vec<f64> = surface.deterministic.iter().map(|p| p.mean_pressure).collect();
        let deterministic = of(&found.stiffness);
        let svg = figures::over_load(
            &pressures,
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
