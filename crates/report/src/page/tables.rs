//! Tables: key numbers, models, statistics, error budget.

use crate::draw::palette::{DETERMINISTIC_LOOK, Look};
use crate::draw::svg::{Canvas, Stroke, escape};
use crate::lines::{ELASTIC, Reference, references};
use crate::looks::{inputs_html, look};
use crate::numbers::{
    AREAS, METRES, PASCALS, SPACE, duration, fixed, percent, percent_within, quantity,
    quantity_within, signed_percent, signed_range, significant, unit_for,
};
use crate::page::context::Page;
use crate::page::phrases::{load_words, spread_words};
use crate::sources::DETERMINISTIC;
use crate::words;
use compare::{
    Applies, DeterministicAnswer, ModelComparison, SurfaceComparison, elastic_limit, hardness_of,
    is_steep,
};
use contact_types::{ContactState, ModelError};

/// Value, and what its ± covers, of the numbers people came for.
pub(crate) fn key_numbers(surface: &SurfaceComparison) -> String {
    let p = words::headline_load(surface);
    let mut rows: Vec<(String, String, String)> = Vec::new();
    for r in surface.conducted(surface.headline).iter().flat_map(words::conduction::resistances) {
        let area = surface.conduction.as_ref().and_then(|c| c.joint.area);
        let of = area.map_or_else(String::new, |area| format!("of {}", quantity(area, AREAS, 3)));
        let beside = r.beside().map_or_else(String::new, |words| format!("; {words}"));
        rows.push((r.name.into(), r.value, of + &beside));
    }
    if let Some(a) = surface.headline_answer() {
        let covers = match (a.budget.area.interval(), a.budget.area.sampling) {
            (Ok(alone), Some(_)) => format!(
                "of this map and of its sampling variability (95{SPACE}%); of this map alone {}",
                percent_within(a.area_fraction_corrected, Some(alone))
            ),
            (Ok(_), None) => "of this map; not of another map of the same surface".to_owned(),
            (Err(reason), _) => {
                format!("without uncertainty estimate: {}", escape(&reason.to_string()))
            }
        };
        rows.push((
            "Real contact area <i>A</i><sub>r</sub>/<i>A</i><sub>n</sub>".into(),
            words::area(a),
            covers,
        ));
        rows.push((
            "Mean real pressure".into(),
            words::real_pressure(a),
            if a.uncertainty().is_some() {
                "load over that area, between its ends"
            } else {
                "load over that area"
            }
            .into(),
        ));
        rows.extend(yield_rows(surface, a));
        if let Some(gap) = a.mean_gap {
            let sq = surface.statistics.rms_height;
            let relative = if sq > 0.0 {
                format!(", {}{SPACE}Sq", significant(gap / sq, 3))
            } else {
                String::new()
            };
            let stated = a.budget.mean_gap.and_then(|gap| gap.stated());
            let value = quantity_within(gap, stated, METRES);
            rows.push((
                "Mean gap".into(),
                value,
                format!(
                    "average over the whole map{relative}; {}",
                    if stated.is_none() && a.uncertainty().is_some() {
                        "no ±"
                    } else {
                        "± as above"
                    }
                ),
            ));
        }
        if let Some(k) = a.budget.stiffness {
            let micro = 1e-6; // Pa per metre -> Pa per micrometre
            let stated = k.stated().map(|ends| ends.map(|end| end * micro));
            let value = quantity_within(k.value * micro, stated, PASCALS);
            rows.push((
                "Contact stiffness".into(),
                format!("{value}/µm"),
                if surface.inputs.hardness.is_some() {
                    "of the contact set, as it would unload; not the slope of the loading curve"
                } else {
                    "−d<i>p</i>/d(mean gap), of the contact set"
                }
                .into(),
            ));
        }
        if let Some(spots) = surface.spots {
            let square = |area: f64| {
                let side = unit_for(area.sqrt(), METRES);
                format!("{}{SPACE}{}²", significant(area / side.scale.powi(2), 2), side.name)
            };
            rows.push((
                "Contact spots".into(),
                fixed(spots.count as f64, 0),
                format!(
                    "median {}, largest {}; joined over edges and corners",
                    square(spots.median_area),
                    square(spots.largest_area)
                ),
            ));
        }
        rows.push((
            "Touching points".into(),
            fixed(a.contact_pixels as f64, 0),
            format!("of {}", fixed(surface.solved_map().grid().len() as f64, 0)),
        ));
    }
    rows.extend(elastic_limit(surface).map(|limit| {
        (
            "Hardness that stays elastic".into(),
            format!("{} or more", quantity(limit, PASCALS, 2)),
            "<i>E</i>* <i>g</i>: then this area is right to 2\u{202F}%; softer bodies need their hardness"
                .into(),
        )
    }));
    let (force, product) = load_words(surface);
    rows.push(("Load on this area".into(), force, product));
    let body: String = rows
        .iter()
        .map(|(name, value, why)| {
            format!(
                "<tr><th scope=\"row\">{name}</th><td class=\"n\">{value}</td>\
                 <td class=\"why\">{why}</td></tr>\n"
            )
        })
        .collect();
    format!(
        "<table class=\"key\"><caption>Key numbers at {p}</caption><tbody>\n{body}</tbody></table>\n"
    )
}

/// The highest pressure; with a hardness what has yielded, and what elastic bodies would do.
fn yield_rows(
    surface: &SurfaceComparison,
    a: &DeterministicAnswer,
) -> Vec<(String, String, String)> {
    let load = a.budget.mean_pressure.value;
    let (highest, why) = words::highest_pressure(a.max_pressure, load, a.area_fraction_corrected);
    let Some(yielded) = a.yielded.filter(|y| y.area_fraction > 0.0) else {
        return vec![("Highest local pressure".into(), highest, why.into())];
    };
    let mut rows = vec![(
        "Contact at the hardness".into(),
        percent((yielded.area_fraction / a.area_fraction).min(1.0)),
        format!(
            "carries {} of the load; flattened there, {} over the whole map",
            percent(yielded.load_share),
            quantity(yielded.mean_flattening, METRES, 2)
        ),
    )];
    let indices = hardness_of(surface).map(|h| h.indices(surface.inputs.asperities()));
    rows.extend(indices.and_then(|found| {
        let two = |value: Option<f64>| value.map_or("–".into(), |v| significant(v, 2));
        Some((
            "<i>E</i>* <i>g</i> / <i>H</i>".into(),
            significant(found.modulus_gradient_over_hardness?, 2),
            format!(
                "elastic up to 1; plasticity indices of Greenwood–Williamson {} (summits elastic below 0.6, \
                 plastic above 1), Mikic {}",
                two(found.greenwood_williamson),
                two(found.mikic)
            ),
        ))
    }));
    let elastic = surface.elastic.get(surface.headline).and_then(|p| p.answer.as_ref());
    rows.extend(elastic.map(|elastic| {
        (
            "Area of elastic bodies".into(),
            words::area(elastic),
            format!(
                "the same map without yield; highest pressure {}",
                quantity(elastic.max_pressure, PASCALS, 2)
            ),
        )
    }));
    rows
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
pub(crate) fn swatch(look: Look) -> String {
    let mut canvas = Canvas::default();
    let stroke = Stroke { colour: look.colour, width: 1.2 * look.width, dash: look.dash };
    canvas.line([1.0, 6.0], [33.0, 6.0], stroke);
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
pub(crate) fn models(page: &mut Page<'_>, surface: &SurfaceComparison) -> String {
    let p = words::headline_load(surface);
    let loads = &surface.deterministic;
    let range = format!(
        "{} to {}",
        words::load(loads[0].mean_pressure, surface.load_area),
        words::load(loads[loads.len() - 1].mean_pressure, surface.load_area)
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
         <th scope=\"col\" class=\"n\">Error,<br>{range}</th><th scope=\"col\" class=\"n\">Mean \
         |error|</th><th scope=\"col\" class=\"n\">Time<br>per load</th><th scope=\"col\">Applies \
         to this surface?</th><th scope=\"col\" class=\"n\">Ref.</th></tr></thead><tbody>\n{rows}\
         </tbody></table>\n"
    )
}

fn cited(page: &mut Page<'_>, citation: contact_types::Citation) -> String {
    let n = page.source(citation);
    format!("<td data-l=\"Ref.\" class=\"n src\"><a href=\"#r{n}\">{n}</a></td>")
}

fn deterministic_row(
    page: &mut Page<'_>,
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
        "<tr class=\"ref\"><th scope=\"row\"><div>{}<span>Deterministic, <span style=\"white-space:nowrap\">FFT-BEM</span><small>height \
         map{of}</small></span></div></th><td data-l=\"Area\" class=\"n\"{k}>{}</td>\
         <td data-l=\"Error at load\" class=\"n\">reference</td><td data-l=\"Error, all loads\" \
         class=\"n\">{}</td><td data-l=\"Mean |error|\" class=\"n\">–</td><td data-l=\"Time per \
         load\" class=\"n\">{}</td><td data-l=\"Applies\" class=\"dom\">{}</td>{source}</tr>\n",
        swatch(DETERMINISTIC_LOOK),
        answer.map_or("–".into(), words::area),
        spread_words(points),
        answer.map_or("–".into(), |a| duration(a.seconds)),
        match (answer, answer.and_then(|a| a.budget.area.half_width().err())) {
            (None, _) => applies(Applies::No, "no solution at this load"),
            (Some(a), _) if !a.converged => applies(Applies::Caution, "not converged at this load"),
            (_, Some(reason)) => applies(Applies::Caution, &reason.to_string()),
            _ if is_steep(surface.statistics.rms_gradient) => {
                applies(Applies::Caution, words::SMALL_SLOPES)
            }
            _ if yields => {
                applies(Applies::Yes, "full map, yields at the hardness, periodic cell")
            }
            _ => applies(Applies::Yes, "full map, elastic, periodic cell"),
        }
    )
}

fn model_row(
    page: &mut Page<'_>,
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
        swatch(look(&card.name, place)),
        escape(&card.title),
        inputs_html(card)
    );
    let domain = format!(
        "<td data-l=\"Applies\" class=\"dom\">{}</td>",
        applies(model.verdict.answer, &words::reason(model))
    );
    let Ok(curve) = &model.outcome else {
        let dash = |l: &str| format!("<td data-l=\"{l}\" class=\"n\">–</td>");
        return format!(
            "<tr class=\"na\" data-m=\"{series}\">{name}{}{}{}{}{}{domain}{source}</tr>\n",
            dash("Area"),
            dash("Error at load"),
            dash("Error, all loads"),
            dash("Mean |error|"),
            dash("Time per load")
        );
    };
    let key = |prefix: &str| {
        if several { format!(" data-k=\"{prefix}-{}\"", card.name) } else { String::new() }
    };
    let error = curve.errors[surface.headline].map_or("–".into(), signed_percent);
    let range = curve.range().map_or("–".into(), |(lo, hi)| signed_range(lo, hi));
    let mean = curve.worst_and_mean().map_or("–".into(), |(_, mean)| percent(mean));
    format!(
        "<tr data-m=\"{series}\">{name}<td data-l=\"Area\" class=\"n\"{}>{}</td><td data-l=\"Error at load\" \
         class=\"n\"><span{}>{error}</span></td><td data-l=\"Error, all loads\" class=\"n\">{range}</td>\
         <td data-l=\"Mean |error|\" class=\"n\">{mean}</td><td data-l=\"Time per load\" \
         class=\"n\">{}</td>{domain}{source}</tr>\n",
        key("a"),
        model_area(&curve.points[surface.headline]),
        key("e"),
        duration(curve.seconds)
    )
}
