//! The sections of one surface, in the order of the report.

use crate::draw::svg::escape;
use crate::figures::cost::{self, CostRoute};
use crate::figures::curves;
use crate::figures::heights;
use crate::figures::surface as surface_figures;
use crate::figures::surface::{Histogram, histogram};
use crate::lines::{LoadLines, YIELDING};
use crate::messages::finding::finding;
use crate::messages::pair::{lying, moments};
use crate::messages::{self, edge_words};
use crate::numbers::{METRES, SPACE, fixed, quantity, signed_percent, significant};
use crate::page::budget;
use crate::page::shared::{AREA_CORRECTION, SurfacePart, row, table};
use crate::page::slider::dial;
use crate::page::{statistics, tables};
use crate::plot_styles::plot_style;
use contact_compare::{
    Finding, Independence, ModelComparison, PairOrigin, SurfaceComparison, Weight,
};
use contact_types::SpectralMoments;

const MOST: usize = 3;

/// The worst findings, a sentence each; effect and remedy unfold.
pub(crate) fn notes(found: &[Finding], id: &str) -> String {
    let open: Vec<&Finding> = found.iter().filter(|f| f.weight != Weight::Passed).collect();
    let item = |found: &&Finding| {
        let check = found.weight == Weight::Check;
        let (class, word) = if check { ("check", "Check") } else { ("note", "Note") };
        let [claim, text] = finding(found).map(|text| escape(&text));
        format!(
            "<li><span class=\"tag {class}\">{word}</span><details><summary>{claim}</summary>{text}</details></li>\n"
        )
    };
    let mut items: String = open.iter().take(MOST).map(item).collect();
    if open.is_empty() {
        items.push_str("<li>Nothing to check.</li>\n");
    }
    if open.len() > MOST {
        let more = open.len() - MOST;
        items.push_str(&format!("<li>{more} more in <code>results.json</code></li>\n"));
    }
    format!(
        "<div><p class=\"cap\" id=\"{id}-w\">Read before use</p>\
         <ul class=\"warns\" aria-labelledby=\"{id}-w\">\n{items}</ul></div>\n"
    )
}

/// Figs. 1 to 4: area, real pressure, error, cost; the first three once for each kind of bodies.
pub(crate) fn over_load(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, id, h, p, .. } = *part;
    let mut out = format!("<{h}>Area and pressure against load</{h}>\n{}", dial(surface, id));
    let panels = LoadLines::panels(surface);
    for (k, lines) in panels.iter().enumerate() {
        let break_after = if k == 0 { " page1" } else { "" };
        let panel = panel(part, lines);
        out += &format!("<div class=\"two{break_after}\">\n{panel}</div>\n");
    }
    out += "<div class=\"two\">\n";
    out += &panels.iter().map(|lines| errors(part, lines)).collect::<String>();
    if let Some(routes) = cost_routes(surface) {
        let (floor, time) = (relative_uncertainty(surface), "Time to the first answer");
        let caption = format!(
            "Error against time</b> at {p}, from the levelled map; bars: from typed numbers. Dashed: Pareto front."
        );
        out += &part.figure(cost::figure(&routes, floor, ("area", p), time), &caption);
    }
    out + "</div>\n"
}

fn panel(part: &mut SurfacePart<'_>, lines: &LoadLines) -> String {
    let of = lines.whose();
    let band =
        if lines.interval.iter().flatten().count() > 1 { "; grey: ± of this map" } else { "" };
    let elastic = if lines.of == YIELDING { "; rings: elastic contact" } else { "" };
    let caption = format!("Real contact area{of}.</b> Dots: solver{elastic}{band}.");
    let area = part.figure(curves::area(lines, true), &caption);
    let caption = format!("Mean real pressure{of}</b>, load over real area.");
    area + &part.figure(curves::pressure(lines, true), &caption)
}

/// The error of each closed form; nothing where no theory of these bodies answers.
fn errors(part: &mut SurfacePart<'_>, lines: &LoadLines) -> String {
    if lines.models.iter().all(|m| m.name == "elastic") {
        return String::new();
    }
    let has_band = lines.interval.iter().flatten().count() > 1;
    let dark = if has_band { "; dark: ± of the solver" } else { "" };
    let caption = format!(
        "Error of each closed form{}</b> against the solver. Light band: 10{SPACE}%{dark}.",
        lines.whose()
    );
    part.figure(curves::error(lines), &caption)
}

fn relative_uncertainty(surface: &SurfaceComparison) -> Option<f64> {
    let answer = surface.headline_answer()?;
    let u = answer.budget.area.half_width().ok()? / answer.area_fraction;
    (u > 0.0 && u.is_finite()).then_some(u)
}

fn cost_routes(surface: &SurfaceComparison) -> Option<Vec<CostRoute>> {
    let answer = surface.headline_answer()?;
    let forms = messages::ranked(surface).into_iter().map(|r| {
        let (card, look) = (&r.model.card, plot_style(&r.model.card.name, r.place));
        let route = CostRoute::new(card.label.as_ref(), look, r.seconds, r.error);
        CostRoute { series: card.name.to_string(), typed: r.typed, ..route }
    });
    let mut routes: Vec<CostRoute> = forms.chain(messages::coarser_routes(surface)).collect();
    if routes.is_empty() {
        return None;
    }
    routes.push(CostRoute::deterministic(answer.diagnostics.seconds));
    Some(routes)
}

/// The model table, with the formula of each model in it that has one of a line.
pub(crate) fn models(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, h, .. } = *part;
    let table = tables::models(part);
    let with = surface.models.iter().filter(|m| m.outcome.is_ok() && !m.card.formula.is_empty());
    let formula =
        |m: &ModelComparison| format!(" {}: {}.", escape(&m.card.label), escape(&m.card.formula));
    let formulas: String = with.map(formula).collect();
    format!("<{h}>Which model to use</{h}>\n{table}<p class=\"why\">{formulas}</p>\n")
}

/// What takes time in [`the_surface`]: a picture with its limits (m), if it is no line, and a histogram, if it is rough.
pub(crate) fn height_figures(
    surface: &SurfaceComparison,
    limit: usize,
) -> (Option<(String, [f64; 2])>, Option<Histogram>) {
    let (grid, heights) = (surface.surface.grid(), surface.surface.heights());
    let is_map = !grid.shape().contains(&1);
    let picture = is_map.then(|| heights::height_picture(heights, grid, limit));
    (picture, histogram(surface.solved_map().heights(), &surface.pressure))
}

pub(crate) fn the_surface(
    part: &mut SurfacePart<'_>,
    (picture, histogram): (Option<(String, [f64; 2])>, Option<Histogram>),
) -> String {
    let SurfacePart { surface, h, p, .. } = *part;
    let grid = surface.surface.grid();
    let (title, first) = match surface.origin.pair() {
        Some(both) => ("Composite surface", opening(both)),
        None => ("The surface", String::new()),
    };
    let mut out = format!("<{h}>{title}</{h}>\n{first}<div class=\"two maps\">\n");
    if let Some(picture) = picture {
        out += &part.figure(heights::figure(&picture, grid, &[]), "Height.</b>");
    } else {
        out.push_str("<p>A single profile: no map is drawn.</p>\n");
    }
    out.push_str(&statistics::table(surface));
    out.push_str("</div>\n<div class=\"two\">\n");
    if let Some(histogram) = histogram {
        let words = histogram.lowest_touching().map_or_else(String::new, |lowest| {
            format!(" At {p} heights above {}{SPACE}Sq touch.", fixed(lowest, 1))
        });
        let caption = format!("Height distribution.</b> Line: normal.{words}");
        out += &part.figure(surface_figures::heights(&histogram, p), &caption);
    }
    let fit = surface.statistics.hurst.zip(surface.statistics.fractal_range);
    let spectrum =
        surface_figures::Spectrum { points: surface.spectral.psd.clone(), fit, is_profile: false };
    let band = " Dashed: power law fitted over the grey band, raised 2.2×.";
    let fitted = if fit.is_some() { band } else { "" };
    let window = if surface.spectral.windowed { "Hann window" } else { "periodic" };
    let caption = format!("Radial power spectrum</b>, {window}.{fitted}");
    out + &part.figure(surface_figures::spectrum(&spectrum), &caption) + "</div>\n"
}

pub(crate) fn accuracy(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, h, p, .. } = *part;
    let Some(answer) = surface.headline_answer() else { return String::new() };
    let correction = part.numbers.source(AREA_CORRECTION);
    let budget = match answer.budget.area.half_width() {
        Ok(_) => budget::sources(answer, surface, p, correction),
        Err(reason) => {
            let (reason, edges) = (escape(&reason.to_string()), edge_words(surface));
            format!(
                "<p class=\"keep\"><b>The area is without uncertainty estimate:</b> {reason}. Edges: {edges}</p>\n"
            )
        }
    };
    let (choices, hardness) = (budget::choices(surface), surface.inputs.hardness);
    let plastic =
        hardness.map_or("plastic flow", |_| "hardening, pile-up, yield in the volume, unloading");
    format!(
        "<{h}>Accuracy</{h}>\n{budget}{choices}<p class=\"why\">Not covered: {plastic}, \
         friction, adhesion, waves longer than the map, instrument calibration.</p>\n"
    )
}

/// What the section on the surface opens with: the sum of two bodies is no surface one could see.
fn opening(pair: &PairOrigin) -> String {
    let [first, second] = pair.names.each_ref().map(|name| escape(name));
    let whose =
        moments(pair).map_or_else(String::new, |text| format!(" Moments: {}.", escape(&text)));
    format!(
        "<p>Neither of the two: the heights below are those of {first} and {second} added at each place, the \
         rough surface that touches a smooth flat as the two touch each other. {}.{whose}</p>\n{}",
        escape(&lying(pair)),
        pair.found.as_ref().map_or_else(String::new, |(_, found)| added(pair, found))
    )
}

fn added(pair: &PairOrigin, independence: &Independence) -> String {
    let line = |name: &str, m: &SpectralMoments| {
        let gradient = significant(m.rms_gradient(), 3);
        let [m2, m4] = [m.m2, m.m4].map(|m| significant(m, 3));
        row(name, [quantity(m.rms_height(), METRES, 3), gradient, m2, m4 + " m⁻²"], "")
    };
    let [first, second] = pair.names.each_ref().map(|name| escape(name));
    let [_, m2, m4] = independence.excess.map(signed_percent);
    // The gradient is the root of m2.
    let of_root = |excess: f64| signed_percent((1.0 + excess).max(0.0).sqrt() - 1.0);
    let [height, gradient] = [independence.excess[0], independence.excess[1]].map(of_root);
    let rows = [
        line(&first, &independence.bodies[0]),
        line(&second, &independence.bodies[1]),
        line("if independent: sums of <i>m</i>", &independence.sum()),
        line("both as one, in the models", &independence.composite),
        row("both as one, over that", [height, gradient, m2, m4], ""),
    ];
    let columns = "|#rms height|#rms gradient|#<i>m</i><sub>2</sub>|#<i>m</i><sub>4</sub>";
    table(r#"class="stat""#, "What each body adds", columns, &rows.concat()).replacen(
        r#"<th scope="col"></th>"#,
        "<td></td>",
        1,
    )
}
