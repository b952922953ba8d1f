//! Several surfaces at once: does the ranking of the models hold on all of them?

use crate::draw::svg::escape;
use crate::figures::multiples;
use crate::lines::WANTED;
use crate::messages;
use crate::numbers::{METRES, SPACE, counted, duration, quantity, signed_percent, significant};
use crate::page::how_made::modulus_in_head;
use crate::page::shared::{Numbering, date, row, table, wide};
use crate::provenance::Provenance;
use contact_compare::{Comparison, ModelComparison, SurfaceComparison, elastic_holds};

pub(crate) fn section(
    comparison: &Comparison,
    made: &Provenance,
    numbers: &mut Numbering,
) -> String {
    let surfaces = &comparison.surfaces;
    let (count, modulus) = (surfaces.len(), modulus_in_head(&comparison.settings));
    let (date, headline, listed) = (date(made.unix_time), headline(surfaces), listed(surfaces));
    let mut out = format!(
        "<header><p class=\"file\">rough-contact report · {count} surfaces · {modulus} · {date}</p>\n\
         <h1>{headline}</h1></header>\n{listed}"
    );
    let names: Vec<&str> = surfaces.iter().map(|s| s.name.as_str()).collect();
    let of_area = ("Real contact area on each surface", "Real contact area</b>. Dots: solver.");
    let caption = format!("Error of each closed form</b>. Grey: within 10{SPACE}%.");
    let of_errors = ("Error of the closed forms on each surface", caption.as_str());
    for (is_error, (title, caption)) in [(false, of_area), (true, of_errors)] {
        let description = format!("{title}: {}.", names.join(", "));
        let drawn = multiples::figure(surfaces, is_error, title, description);
        out += &wide(&numbers.figure("o", drawn, caption));
    }
    out.push_str("<div class=\"page1\"></div>\n");
    out
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
    let elastic = surfaces.iter().all(elastic_holds);
    // Over all loads; none of a theory that is not ranked.
    let mean_error = |m: &ModelComparison| {
        let curve = m.outcome.as_ref().ok().filter(|_| m.card.yields || elastic)?;
        curve.worst_and_mean().map(|(_, mean)| mean)
    };
    let worst = |k: usize| -> Option<f64> {
        surfaces.iter().try_fold(0.0, |w, s| Some(f64::max(w, mean_error(&s.models[k])?)))
    };
    let models = 0..surfaces.first().map_or(0, |s| s.models.len());
    let best = models.filter_map(|k| Some((k, worst(k)?))).min_by(|a, b| a.1.total_cmp(&b.1));
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

fn listed(surfaces: &[SurfaceComparison]) -> String {
    let line = |(i, s): (usize, &SurfaceComparison)| {
        let answer = s.headline_answer();
        let nearest = messages::nearest(s).map_or("–".into(), |r| {
            let (error, time) = (signed_percent(r.error), duration(r.seconds));
            format!("{} ({error}), {time}", r.model.card.label)
        });
        let numbers = [
            quantity(s.statistics.rms_height, METRES, 3),
            significant(s.inputs.rms_gradient(), 2),
            messages::headline_load(s),
            answer.map_or("–".into(), messages::area),
            answer.map_or("–".into(), messages::real_pressure),
        ];
        let seconds = answer.map_or("–".into(), |a| duration(a.diagnostics.seconds));
        let link = format!("<a href=\"#s{i}-w\">{}</a>", escape(&s.name));
        row(&link, numbers, &format!("<td>{nearest}</td><td class=\"n\">{seconds}</td>"))
    };
    let rows: String = surfaces.iter().enumerate().map(line).collect();
    let columns = "Surface|#<i>Sq</i>|#<i>Sdq</i>|#Load|#Area|#Real pressure|Nearest closed form|#Solver, per load";
    table(r#"class="over" tabindex="0""#, "Each surface at one load", columns, &rows)
}
