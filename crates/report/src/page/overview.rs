//! Several surfaces at once: does the ranking of the models hold on all of them?

use crate::draw::svg::escape;
use crate::figures::multiples::{self, PanelQuantity};
use crate::lines::WANTED;
use crate::messages;
use crate::numbers::{METRES, SPACE, counted, duration, quantity, signed_percent, significant};
use crate::page::context::{ReportPage, wide};
use crate::page::how_made::modulus_in_head;
use contact_compare::{ModelComparison, SurfaceComparison, elastic_holds};

/// The opening of a report on several surfaces.
pub(crate) fn section(page: &mut ReportPage<'_>) -> String {
    let surfaces = &page.comparison.surfaces;
    let line = format!(
        "<p class=\"file\">rough-contact report · {} surfaces · {} · {}</p>\n",
        surfaces.len(),
        modulus_in_head(&page.comparison.settings),
        messages::date(page.provenance.unix_time)
    );
    let mut out =
        format!("<header>{line}<h1>{}</h1></header>\n{}", headline(surfaces), table(surfaces));
    let surfaces = &page.comparison.surfaces;
    let names: Vec<&str> = surfaces.iter().map(|s| s.name.as_str()).collect();
    for (quantity, title, caption) in [
        (
            PanelQuantity::Area,
            "Real contact area on each surface",
            "Real contact area</b>. Dots: solver.".to_owned(),
        ),
        (
            PanelQuantity::Error,
            "Error of the closed forms on each surface",
            format!("Error of each closed form</b>. Grey: within 10{SPACE}%."),
        ),
    ] {
        let description = format!("{title}: {}.", names.join(", "));
        let draw = |key: &str| multiples::figure(surfaces, quantity, title, description, key);
        out.push_str(&wide(&page.numbers.figure("o", draw, &caption)));
    }
    out.push_str("<div class=\"page1\"></div>\n");
    out
}

/// Whether theories of elastic bodies are ranked.
fn ranks_elastic(surfaces: &[SurfaceComparison]) -> bool {
    surfaces.iter().all(elastic_holds)
}

/// Mean size of the error of each model over all loads of each surface, by the order of the list; none
/// of a theory that is not ranked.
fn mean_errors(surfaces: &[SurfaceComparison]) -> Vec<Vec<Option<f64>>> {
    let elastic = ranks_elastic(surfaces);
    let mean = |m: &ModelComparison| {
        let curve = m.outcome.as_ref().ok().filter(|_| m.card.yields || elastic)?;
        curve.worst_and_mean().map(|(_, mean)| mean)
    };
    surfaces.iter().map(|s| s.models.iter().map(mean).collect()).collect()
}

/// Which closed form has the smallest largest mean error over the surfaces.
fn headline(surfaces: &[SurfaceComparison]) -> String {
    let unknown = surfaces.iter().filter(|s| !messages::is_known(s)).count();
    if unknown > 0 {
        return format!(
            "The area is not known to 10{SPACE}% on {unknown} of {}: the closed forms are not ranked.",
            counted(surfaces.len(), "surface")
        );
    }
    let all = mean_errors(surfaces);
    let models = all.first().map_or(0, Vec::len);
    let worst = |k: usize| -> Option<f64> {
        all.iter().map(|errors| errors[k]).try_fold(0.0_f64, |w, e| Some(w.max(e?)))
    };
    let best = (0..models).filter_map(|k| Some((k, worst(k)?))).min_by(|a, b| a.1.total_cmp(&b.1));
    let count = surfaces.len();
    match best {
        Some((k, error)) => {
            let name = messages::named(&surfaces[0].models[k]);
            let percent = crate::numbers::percent(error);
            if error <= WANTED {
                format!(
                    "On {count} surfaces {name} stays nearest: on average within <b>{percent}</b> of the deterministic area."
                )
            } else {
                format!(
                    "No closed form is within 10{SPACE}% on all {count} surfaces; the nearest, {name}, is off by up to <b>{percent}</b> on average over the loads."
                )
            }
        }
        None => format!("No closed form answers on all {count} surfaces."),
    }
}

fn table(surfaces: &[SurfaceComparison]) -> String {
    let rows: String = surfaces
        .iter()
        .enumerate()
        .map(|(i, s)| {
            let answer = s.headline_answer();
            let nearest = messages::nearest(s);
            format!(
                "<tr><th scope=\"row\"><a href=\"#s{i}-w\">{}</a></th><td class=\"n\">{}</td>\
                 <td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
                 <td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n",
                escape(&s.name),
                quantity(s.statistics.rms_height, METRES, 3),
                significant(s.inputs.rms_gradient(), 2),
                messages::headline_load(s),
                answer.map_or("–".into(), messages::area),
                answer.map_or("–".into(), messages::real_pressure),
                nearest.as_ref().map_or("–".into(), |r| format!(
                    "{} ({}), {}",
                    r.model.card.label,
                    signed_percent(r.error),
                    duration(r.seconds)
                )),
                answer.map_or("–".into(), |a| duration(a.diagnostics.seconds)),
            )
        })
        .collect();
    format!(
        "<table class=\"over\" tabindex=\"0\"><caption>Each surface at one load</caption><thead><tr><th \
         scope=\"col\">Surface</th><th scope=\"col\" class=\"n\"><i>Sq</i></th><th scope=\"col\" \
         class=\"n\"><i>Sdq</i></th><th scope=\"col\" class=\"n\">Load</th><th scope=\"col\" \
         class=\"n\">Area</th><th scope=\"col\" class=\"n\">Real pressure</th><th \
         scope=\"col\">Nearest closed form</th><th scope=\"col\" class=\"n\">Solver, per \
         load</th></tr></thead><tbody>\n{rows}</tbody></table>\n"
    )
}
