//! Tables: key numbers, models, statistics, error budget.

use crate::draw::palette::{DETERMINISTIC_STYLE, Stroke, Style};
use crate::draw::svg::{Canvas, escape};
use crate::lines::{ELASTIC, Reference, references};
use crate::messages::{self, reason_of};
use crate::numbers::{
    AREAS, METRES, NEWTONS, PASCALS, SPACE, chosen, duration, points_of, quantity, signed_percent,
    signed_range, significant, unit_for,
};
use crate::page::how_made::modulus_in_head;
use crate::page::shared::{DETERMINISTIC, Numbering, SurfacePart, key_table, table};
use crate::plot_styles::{inputs_html, plot_style};
use contact_compare::{Applies, Card, ModelComparison, elastic_limit, is_steep};
use contact_types::{Citation, ContactState, ModelError, Named};

pub(crate) fn key_numbers(part: &SurfacePart<'_>) -> String {
    let (surface, settings) = (part.surface, &part.comparison.settings);
    let mut rows: Vec<[String; 3]> = Vec::new();
    let conducted = surface.conducted(surface.headline);
    for (name, value, spot) in conducted.iter().flat_map(messages::conduction::resistances) {
        let area = surface.conduction.as_ref().and_then(|c| c.joint.area);
        let of = area.map_or_else(String::new, |area| format!("of {}", quantity(area, AREAS, 3)));
        let beside = spot.map_or_else(String::new, |spot| format!("; one spot (Holm) {spot}"));
        rows.push([name.into(), value, of + &beside]);
    }
    rows.extend(settings.leak.iter().flat_map(|asked| messages::leak::key_rows(asked, surface)));
    let (p, nominal) = (surface.headline_pressure(), surface.nominal_area());
    let side = unit_for(nominal.sqrt(), METRES);
    let area = significant(nominal / side.scale.powi(2), 3);
    let product = format!("{} × {area}{SPACE}{}²", chosen(p, PASCALS), side.name);
    rows.push(["Load".into(), quantity(p * nominal, NEWTONS, 3), product]);
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
    let wave = |l: f64| format!("shortest wavelength {}", quantity(l, METRES, 2));
    rows.push([
        "Resolution".into(),
        points_of(surface.surface.grid()),
        surface.statistics.cutoff.map_or(String::new(), wave),
    ]);
    let area = surface.headline_answer().map(|a| &a.budget.area);
    if let Some(area) = area.filter(|area| area.half_width().is_ok()) {
        let of = if area.sampling.is_some() { "map and sampling" } else { "this map alone" };
        let materials = if area.materials > 0.0 { "and materials" } else { "" };
        rows.push([format!("± of the area covers, 95{SPACE}%"), of.into(), materials.into()]);
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
    let area = |s: &ContactState| format!("{}{SPACE}%", significant(100.0 * s.area_fraction, 3));
    point.as_ref().map_or("–".into(), area)
}

/// The mean pressure on what a model says touches, "3.2 GPa".
pub(crate) fn model_pressure(point: &Result<ContactState, ModelError>) -> String {
    let real = point.as_ref().ok().and_then(ContactState::real_pressure);
    real.map_or("–".into(), |p| quantity(p, PASCALS, 3))
}

pub(crate) fn swatch(look: Style) -> String {
    let mut canvas = Canvas::default();
    canvas.line([1.0, 6.0], [33.0, 6.0], Stroke { width: 1.2 * look.width, ..look.stroke() });
    canvas.marker([17.0, 6.0], 3.0, look);
    let line = canvas.body;
    format!(r#"<svg viewBox="0 0 34 12" width="34" height="12" aria-hidden="true">{line}</svg>"#)
}

/// The head of a row: a line as it is drawn, a name (HTML) and what stands below it.
pub(crate) fn head(look: Style, name: &str, below: &str) -> String {
    let line = swatch(look);
    format!("<th scope=\"row\"><div>{line}<span>{name}<small>{below}</small></span></div></th>")
}

pub(crate) fn model_head(card: &Card, place: usize) -> String {
    head(plot_style(&card.name, place), &escape(&card.title), &inputs_html(card))
}

/// Cells of numbers (HTML), each with the name of its column, which a narrow screen shows, and further attributes.
pub(crate) fn cells<const N: usize>(all: [(&str, &str, String); N]) -> String {
    let cell =
        |(column, more, text)| format!("<td data-l=\"{column}\" class=\"n\"{more}>{text}</td>");
    all.map(cell).concat()
}

/// A cell: whether something holds on the surface, and why not.
pub(crate) fn applies(answer: Applies, reason: &str) -> String {
    let (answer, reason) = (answer.name(), escape(reason).replace(" %", &format!("{SPACE}%")));
    format!("<td data-l=\"Applies\" class=\"dom\"><b class=\"{answer}\">{answer}</b> {reason}</td>")
}

pub(crate) fn models(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, p, .. } = *part;
    let loads = &surface.deterministic;
    let [lightest, heaviest] = [&loads[0], &loads[loads.len() - 1]]
        .map(|point| messages::load(point.mean_pressure, surface.load_area));
    // Each theory stands below the solution for the bodies it is about.
    let mut rows = String::new();
    for mut reference in references(surface) {
        rows.push_str(&deterministic_row(part, &reference));
        let size = |(_, m): &(usize, &ModelComparison)| {
            let error = m.outcome.as_ref().ok().and_then(|c| c.errors[surface.headline]);
            error.map_or(f64::INFINITY, f64::abs)
        };
        reference.models.sort_by(|a, b| size(a).total_cmp(&size(b)));
        for (place, model) in reference.models {
            rows.push_str(&model_row(part, model, place));
        }
    }
    let k = if loads.len() > 1 { " data-k=\"load\"" } else { "" };
    let columns = format!(
        "Model|#Area at <span{k}>{p}</span>|#Error|#Error,<br>{lightest} to {heaviest}|#Time, once<br>+ per load|Applies?|#Ref."
    );
    table(r#"class="models""#, "", &columns, &rows)
}

pub(crate) fn cited(numbers: &mut Numbering, citation: Citation) -> String {
    let n = numbers.source(citation);
    format!("<td data-l=\"Ref.\" class=\"n src\"><a href=\"#r{n}\">{n}</a></td>")
}

fn deterministic_row(part: &mut SurfacePart<'_>, reference: &Reference<'_>) -> String {
    let surface = part.surface;
    let (points, of_elastic) = (reference.points, reference.of == ELASTIC);
    let answer = points.get(surface.headline).and_then(|p| p.answer.as_ref());
    let source = cited(part.numbers, DETERMINISTIC);
    let k = match (points.len() > 1, of_elastic) {
        (false, _) => "",
        (true, false) => " data-k=\"a-det\"",
        (true, true) => " data-k=\"a-elastic\"",
    };
    let yields = surface.inputs.hardness.is_some() && !of_elastic;
    let of = if reference.of.is_empty() { "" } else { &format!(", {}", reference.of) };
    let method = answer.map_or(String::new(), |a| format!(", {}", a.diagnostics.method.name()));
    let made_of = format!("height map{of}{method}");
    let head = head(DETERMINISTIC_STYLE, "Deterministic, FFT-BEM", &made_of);
    let cells = cells([
        ("Area", k, answer.map_or("–".into(), messages::area)),
        ("Error at load", "", "reference".into()),
        ("Error, all loads", "", "–".into()),
        ("Time", "", answer.map_or("–".into(), |a| duration(a.diagnostics.seconds))),
    ]);
    let applies = match (answer, answer.and_then(|a| a.budget.area.half_width().err())) {
        (None, _) => applies(Applies::No, "no solution at this load"),
        (Some(a), _) if !a.converged => applies(Applies::Caution, "not converged at this load"),
        (_, Some(reason)) => applies(Applies::Caution, &reason.to_string()),
        _ if is_steep(surface.statistics.rms_gradient) => {
            applies(Applies::Caution, messages::SMALL_SLOPES)
        }
        _ if yields => applies(Applies::Yes, "yields at the hardness"),
        _ => applies(Applies::Yes, "elastic"),
    };
    format!("<tr class=\"ref\">{head}{cells}{applies}{source}</tr>\n")
}

fn model_row(part: &mut SurfacePart<'_>, model: &ModelComparison, place: usize) -> String {
    let (surface, card) = (part.surface, &model.card);
    let source = cited(part.numbers, card.citation.clone());
    let several = surface.deterministic.len() > 1;
    let (series, name) = (escape(&card.name), model_head(card, place));
    let applies = applies(model.verdict.answer, &reason_of(card, &model.verdict));
    let dash = || "–".to_owned();
    let Ok(curve) = &model.outcome else {
        let dashes = ["Area", "Error at load", "Error, all loads", "Time"].map(|c| (c, "", dash()));
        let dashes = cells(dashes);
        return format!(
            "<tr class=\"na\" data-m=\"{series}\">{name}{dashes}{applies}{source}</tr>\n"
        );
    };
    let key = |prefix: &str| {
        if several { format!(" data-k=\"{prefix}-{}\"", card.name) } else { String::new() }
    };
    let error = curve.errors[surface.headline].map_or_else(dash, signed_percent);
    let cells = cells([
        ("Area", &key("a"), model_area(&curve.points[surface.headline])),
        ("Error at load", "", format!("<span{}>{error}</span>", key("e"))),
        ("Error, all loads", "", curve.range().map_or_else(dash, |(lo, hi)| signed_range(lo, hi))),
        ("Time", "", [curve.preparation, curve.seconds].map(duration).join(" + ")),
    ]);
    format!("<tr data-m=\"{series}\">{name}{cells}{applies}{source}</tr>\n")
}
