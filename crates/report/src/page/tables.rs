//! Tables: key numbers, models, statistics, error budget.

use crate::draw::palette::{DETERMINISTIC_STYLE, Stroke, Style};
use crate::draw::svg::{Canvas, escape};
use crate::lines::{ELASTIC, Reference, references};
use crate::messages;
use crate::numbers::{
    AREAS, METRES, PASCALS, SPACE, chosen, duration, quantity, signed_percent, signed_range,
    significant,
};
use crate::page::context::ReportPage;
use crate::page::how_made::modulus_in_head;
use crate::page::phrases::{key_table, load_words};
use crate::plot_styles::{inputs_html, plot_style};
use crate::sources::DETERMINISTIC;
use contact_compare::{Applies, ModelComparison, SurfaceComparison, elastic_limit, is_steep};
use contact_types::{ContactState, ModelError};

/// What the answer holds for, and the ways to it: terms with a value and a note.
pub(crate) fn key_numbers(page: &ReportPage<'_>, surface: &SurfaceComparison) -> String {
    let mut rows: Vec<[String; 3]> = Vec::new();
    for r in surface.conducted(surface.headline).iter().flat_map(messages::conduction::resistances)
    {
        let area = surface.conduction.as_ref().and_then(|c| c.joint.area);
        let of = area.map_or_else(String::new, |area| format!("of {}", quantity(area, AREAS, 3)));
        let beside = r.beside().map_or_else(String::new, |words| format!("; {words}"));
        rows.push([r.name.into(), r.value, of + &beside]);
    }
    let settings = &page.comparison.settings;
    rows.extend(settings.leak.iter().flat_map(|asked| messages::leak::key_rows(asked, surface)));
    let (force, product) = load_words(surface);
    rows.push(["Load".into(), force, product]);
    let hardness = surface.inputs.hardness.map(|h| format!("<i>H</i> = {}", chosen(h, PASCALS)));
    let limit = elastic_limit(surface).map(|limit| {
        format!("elastic; within 2{SPACE}% for <i>H</i> ≥ {}", quantity(limit, PASCALS, 2))
    });
    let names: Vec<&str> = settings.materials.iter().map(|m| m.name.as_str()).collect();
    let names = if names.is_empty() { String::new() } else { names.join(" against ") + ": " };
    rows.push([
        "Materials".into(),
        escape(&names) + &modulus_in_head(settings),
        hardness.or(limit).unwrap_or_default(),
    ]);
    let grid = surface.surface.grid();
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel());
    let cutoff = surface.statistics.cutoff;
    rows.push([
        "Resolution".into(),
        format!("{nx} × {ny} points of {}", chosen(dx.max(dy), METRES)),
        cutoff.map_or(String::new(), |l| format!("shortest wavelength {}", quantity(l, METRES, 2))),
    ]);
    let area = surface.headline_answer().map(|a| &a.budget.area);
    if let Some(area) = area.filter(|area| area.half_width().is_ok()) {
        let of = if area.sampling.is_some() { "map and sampling" } else { "this map alone" };
        let materials = if area.materials > 0.0 { "and materials" } else { "" };
        rows.push([format!("± covers, 95{SPACE}%"), of.into(), materials.into()]);
    }
    let [name, how] = messages::published(surface);
    rows.push(["Best published closed form".into(), name, how]);
    if let Some([name, how]) = messages::cheapest(surface) {
        rows.push([format!("Cheapest within 10{SPACE}%"), name, how]);
    }
    key_table("", &rows)
}

/// A model's area at one load, "1.67 %".
pub(crate) fn model_area(point: &Result<ContactState, ModelError>) -> String {
    point
        .as_ref()
        .map_or("–".into(), |s| format!("{}{SPACE}%", significant(100.0 * s.area_fraction, 3)))
}

/// The mean pressure on what a model says touches, "3.2 GPa".
pub(crate) fn model_pressure(point: &Result<ContactState, ModelError>) -> String {
    let real = point.as_ref().ok().map(|s| s.mean_pressure / s.area_fraction);
    real.filter(|p| p.is_finite()).map_or("–".into(), |p| quantity(p, PASCALS, 3))
}

/// A short piece of a series' line with its marker.
pub(crate) fn swatch(look: Style) -> String {
    let mut canvas = Canvas::default();
    canvas.line([1.0, 6.0], [33.0, 6.0], Stroke { width: 1.2 * look.width, ..look.stroke() });
    canvas.marker([17.0, 6.0], 3.0, look);
    format!(
        "<svg viewBox=\"0 0 34 12\" width=\"34\" height=\"12\" aria-hidden=\"true\">{}</svg>",
        canvas.body()
    )
}

pub(crate) fn applies(answer: Applies, reason: &str) -> String {
    format!("<b class=\"{0}\">{0}</b> {1}", answer.word(), escape(reason))
}

/// Every model: number, error, cost, domain with its reason, source.
pub(crate) fn models(page: &mut ReportPage<'_>, surface: &SurfaceComparison) -> String {
    let p = messages::headline_load(surface);
    let loads = &surface.deterministic;
    let range = format!(
        "{} to {}",
        messages::load(loads[0].mean_pressure, surface.load_area),
        messages::load(loads[loads.len() - 1].mean_pressure, surface.load_area)
    );
    // Each theory stands below the solution for the bodies it is about.
    let mut rows = String::new();
    for mut reference in references(surface) {
        rows.push_str(&deterministic_row(page, surface, &reference));
        let size = |(_, m): &(usize, &ModelComparison)| {
            let error = m.outcome.as_ref().ok().and_then(|c| c.errors[surface.headline]);
            error.map_or(f64::INFINITY, f64::abs)
        };
        reference.models.sort_by(|a, b| size(a).total_cmp(&size(b)));
        for (place, model) in reference.models {
            rows.push_str(&model_row(page, surface, model, place));
        }
    }
    let k = if loads.len() > 1 { " data-k=\"load\"" } else { "" };
    format!(
        "<table class=\"models\"><thead><tr><th scope=\"col\">Model</th><th scope=\"col\" \
         class=\"n\">Area at <span{k}>{p}</span></th><th scope=\"col\" class=\"n\">Error</th>\
         <th scope=\"col\" class=\"n\">Error,<br>{range}</th><th scope=\"col\" class=\"n\">Time, once<br>+ per load</th><th scope=\"col\">Applies?</th><th scope=\"col\" class=\"n\">Ref.</th></tr></thead><tbody>\n{rows}\
         </tbody></table>\n"
    )
}

fn cited(page: &mut ReportPage<'_>, citation: contact_types::Citation) -> String {
    let n = page.numbers.source(citation);
    format!("<td data-l=\"Ref.\" class=\"n src\"><a href=\"#r{n}\">{n}</a></td>")
}

fn deterministic_row(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    reference: &Reference<'_>,
) -> String {
    let (points, of_elastic) = (reference.points, reference.of == ELASTIC);
    let answer = points.get(surface.headline).and_then(|p| p.answer.as_ref());
    let source = cited(page, DETERMINISTIC);
    let k = match (points.len() > 1, of_elastic) {
        (false, _) => "",
        (true, false) => " data-k=\"a-det\"",
        (true, true) => " data-k=\"a-elastic\"",
    };
    let yields = surface.inputs.hardness.is_some() && !of_elastic;
    let of = if reference.of.is_empty() { "" } else { &format!(", {}", reference.of) };
    format!(
        "<tr class=\"ref\"><th scope=\"row\"><div>{}<span>Deterministic, FFT-BEM<small>height map{of}</small></span></div></th><td data-l=\"Area\" class=\"n\"{k}>{}</td>\
         <td data-l=\"Error at load\" class=\"n\">reference</td><td data-l=\"Error, all loads\" \
         class=\"n\">–</td><td data-l=\"Time\" class=\"n\">{}</td><td data-l=\"Applies\" class=\"dom\">{}</td>{source}</tr>\n",
        swatch(DETERMINISTIC_STYLE),
        answer.map_or("–".into(), messages::area),
        answer.map_or("–".into(), |a| duration(a.diagnostics.seconds)),
        match (answer, answer.and_then(|a| a.budget.area.half_width().err())) {
            (None, _) => applies(Applies::No, "no solution at this load"),
            (Some(a), _) if !a.converged => applies(Applies::Caution, "not converged at this load"),
            (_, Some(reason)) => applies(Applies::Caution, &reason.to_string()),
            _ if is_steep(surface.statistics.rms_gradient) => {
                applies(Applies::Caution, messages::SMALL_SLOPES)
            }
            _ if yields => applies(Applies::Yes, "yields at the hardness"),
            _ => applies(Applies::Yes, "elastic"),
        }
    )
}

fn model_row(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    model: &ModelComparison,
    place: usize,
) -> String {
    let card = &model.card;
    let source = cited(page, card.citation.clone());
    let several = surface.deterministic.len() > 1;
    let series = escape(&card.name);
    let name = format!(
        "<th scope=\"row\"><div>{}<span>{}<small>{}</small></span></div></th>",
        swatch(plot_style(&card.name, place)),
        escape(&card.title),
        inputs_html(card)
    );
    let domain = format!(
        "<td data-l=\"Applies\" class=\"dom\">{}</td>",
        applies(model.verdict.answer, &messages::reason(model))
    );
    let Ok(curve) = &model.outcome else {
        let dash = |l: &str| format!("<td data-l=\"{l}\" class=\"n\">–</td>");
        return format!(
            "<tr class=\"na\" data-m=\"{series}\">{name}{}{}{}{}{domain}{source}</tr>\n",
            dash("Area"),
            dash("Error at load"),
            dash("Error, all loads"),
            dash("Time")
        );
    };
    let key = |prefix: &str| {
        if several { format!(" data-k=\"{prefix}-{}\"", card.name) } else { String::new() }
    };
    let error = curve.errors[surface.headline].map_or("–".into(), signed_percent);
    let range = curve.range().map_or("–".into(), |(lo, hi)| signed_range(lo, hi));
    format!(
        "<tr data-m=\"{series}\">{name}<td data-l=\"Area\" class=\"n\"{}>{}</td><td data-l=\"Error at load\" \
         class=\"n\"><span{}>{error}</span></td><td data-l=\"Error, all loads\" class=\"n\">{range}</td>\
         <td data-l=\"Time\" class=\"n\">{}</td>{domain}{source}</tr>\n",
        key("a"),
        model_area(&curve.points[surface.headline]),
        key("e"),
        [curve.preparation, curve.seconds].map(duration).join(" + ")
    )
}
