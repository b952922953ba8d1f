//! The sections of one surface, in the order of the report.

use crate::draw::svg::escape;
use crate::error::ReportError;
use crate::figures::cost::{self, CostRoute};
use crate::figures::curves::{self, Use};
use crate::figures::heights::{HeightPicture, height_figure};
use crate::figures::surface as surface_figures;
use crate::figures::surface::{Histogram, histogram};
use crate::lines::{LoadLines, YIELDING};
use crate::messages::edges::edge_words;
use crate::messages::finding::finding;
use crate::messages::{self, coarser};
use crate::numbers::{SPACE, fixed};
use crate::page::budget;
use crate::page::context::{ReportPage, figure};
use crate::page::pair;
use crate::page::slider::dial;
use crate::page::{statistics, tables};
use crate::plot_styles::plot_style;
use crate::sources::AREA_CORRECTION;
use contact_compare::{Finding, SurfaceComparison, Weight, findings};

/// Findings shown: the worst.
const MOST: usize = 3;

/// What the answer holds for beside what speaks against it.
pub(crate) fn key_and_notes(
    page: &ReportPage<'_>,
    surface: &SurfaceComparison,
    id: &str,
) -> String {
    let (key, notes) = (tables::key_numbers(page, surface), notes(&findings(surface), id));
    format!("<div class=\"two\">\n{key}{notes}</div>\n")
}

/// The worst findings, a sentence each; effect and remedy unfold.
pub(crate) fn notes(found: &[Finding], id: &str) -> String {
    let open: Vec<&Finding> = found.iter().filter(|f| f.weight != Weight::Passed).collect();
    let item = |found: &&Finding| {
        let check = found.weight == Weight::Check;
        let (class, word) = if check { ("check", "Check") } else { ("note", "Note") };
        let [claim, text] = finding(found);
        format!(
            "<li><span class=\"tag {class}\">{word}</span><details><summary>{}</summary>{}</details></li>\n",
            escape(&claim),
            escape(&text)
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
pub(crate) fn over_load(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    id: &str,
) -> String {
    let h = page.heading();
    let p = messages::headline_load(surface);
    let mut out = format!("<{h}>Area and pressure against load</{h}>\n{}", dial(surface, id));
    let panels = LoadLines::panels(surface);
    for (k, lines) in panels.iter().enumerate() {
        let break_after = if k == 0 { " page1" } else { "" };
        out.push_str(&format!(
            "<div class=\"two{break_after}\">\n{}</div>\n",
            panel(page, lines, id)
        ));
    }
    let errors: String = panels.iter().map(|lines| errors(page, lines, id)).collect();
    out.push_str(&format!("<div class=\"two\">\n{errors}"));
    if let Some(routes) = cost_routes(surface) {
        let (floor, time) = (relative_uncertainty(surface), "Time to the first answer");
        out.push_str(&page.numbers.figure(
            id,
            |key| cost::figure(&routes, floor, ("area", &p), time, key),
            &format!(
                "Error against time</b> at {p}, from the levelled map; bars: from typed numbers. Dashed: Pareto front."
            ),
        ));
    }
    out.push_str("</div>\n");
    out
}

/// ", elastic contact"
fn of(lines: &LoadLines) -> String {
    if lines.of.is_empty() { String::new() } else { format!(", {}", lines.of) }
}

/// Area and pressure of the same bodies.
fn panel(page: &mut ReportPage<'_>, lines: &LoadLines, id: &str) -> String {
    let of = of(lines);
    let band =
        if lines.interval.iter().flatten().count() > 1 { "; grey: ± of this map" } else { "" };
    let elastic = if lines.of == YIELDING { "; rings: elastic contact" } else { "" };
    let area = page.numbers.figure(
        id,
        |key| curves::area(lines, key, Use::Page),
        &format!("Real contact area{of}.</b> Dots: solver{elastic}{band}."),
    );
    let pressure = page.numbers.figure(
        id,
        |key| curves::pressure(lines, key, Use::Page),
        &format!("Mean real pressure{of}</b>, load over real area."),
    );
    area + &pressure
}

/// The error of each closed form; nothing where no theory of these bodies answers.
fn errors(page: &mut ReportPage<'_>, lines: &LoadLines, id: &str) -> String {
    if lines.models.iter().all(|m| m.name == "elastic") {
        return String::new();
    }
    let has_band = lines.interval.iter().flatten().count() > 1;
    let dark = if has_band { "; dark: ± of the solver" } else { "" };
    page.numbers.figure(
        id,
        |key| curves::error(lines, key),
        &format!(
            "Error of each closed form{}</b> against the solver. Light band: 10{SPACE}%{dark}.",
            of(lines)
        ),
    )
}

fn relative_uncertainty(surface: &SurfaceComparison) -> Option<f64> {
    let answer = surface.headline_answer()?;
    let u = answer.budget.area.half_width().ok()? / answer.area_fraction;
    (u > 0.0 && u.is_finite()).then_some(u)
}

fn cost_routes(surface: &SurfaceComparison) -> Option<Vec<CostRoute>> {
    let answer = surface.headline_answer()?;
    let mut routes: Vec<CostRoute> = messages::ranked(surface)
        .into_iter()
        .map(|r| {
            let (card, look) = (&r.model.card, plot_style(&r.model.card.name, r.place));
            let route = CostRoute::new(card.label.as_ref(), look, r.seconds, r.error);
            CostRoute { series: card.name.to_string(), typed: r.typed, ..route }
        })
        .collect();
    routes.extend(coarser::routes(surface));
    if routes.is_empty() {
        return None;
    }
    routes.push(CostRoute::deterministic(answer.diagnostics.seconds));
    Some(routes)
}

/// The model table, with the formulas that fit on a line.
pub(crate) fn models(page: &mut ReportPage<'_>, surface: &SurfaceComparison) -> String {
    let h = page.heading();
    let table = tables::models(page, surface);
    let formulas = formulas(surface);
    format!("<{h}>Which model to use</{h}>\n{table}<p class=\"why\">{formulas}</p>\n")
}

/// The formula of each model in the table that has one of a line.
fn formulas(surface: &SurfaceComparison) -> String {
    let with = surface.models.iter().filter(|m| m.outcome.is_ok() && !m.card.formula.is_empty());
    with.map(|m| format!(" {}: {}.", escape(&m.card.label), escape(&m.card.formula))).collect()
}

/// What takes time in [`the_surface`].
pub(crate) struct HeightFigures {
    /// `None` of a single profile.
    picture: Option<HeightPicture>,
    /// `None` of a flat map.
    histogram: Option<Histogram>,
}

impl HeightFigures {
    pub(crate) fn of(surface: &SurfaceComparison, limit: usize) -> Result<Self, ReportError> {
        let grid = surface.surface.grid();
        let is_map = !grid.shape().contains(&1);
        let picture = is_map.then(|| HeightPicture::of(surface.surface.heights(), grid, limit));
        let histogram = histogram(surface.solved_map().heights(), &surface.pressure);
        Ok(Self { picture: picture.transpose()?, histogram })
    }
}

/// Height map, statistics, distribution, spectrum.
pub(crate) fn the_surface(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    heights: &HeightFigures,
    id: &str,
) -> String {
    let h = page.heading();
    let grid = surface.surface.grid();
    let p = messages::headline_load(surface);
    let (title, first) = match surface.origin.pair() {
        Some(both) => ("Composite surface", pair::opening(both)),
        None => ("The surface", String::new()),
    };
    let mut out = format!("<{h}>{title}</{h}>\n{first}<div class=\"two maps\">\n");
    if let Some(picture) = &heights.picture {
        let draw = |key: &str| height_figure(picture, grid, key);
        out.push_str(&page.numbers.figure(id, draw, "Height.</b>"));
    } else {
        out.push_str("<p>A single profile: no map is drawn.</p>\n");
    }
    out.push_str(&statistics::table(surface));
    out.push_str("</div>\n<div class=\"two\">\n");
    if let Some(histogram) = &heights.histogram {
        let lowest = histogram.touching.iter().position(|v| *v > 0.0);
        let words = lowest.map_or(String::new(), |k| {
            let height = fixed(histogram.start + histogram.step * k as f64, 1);
            format!(" At {p} heights above {height}{SPACE}Sq touch.")
        });
        out.push_str(&page.numbers.figure(
            id,
            |key| surface_figures::heights(histogram, &p, key),
            &format!("Height distribution.</b> Line: normal.{words}"),
        ));
    }
    let fit = surface.statistics.hurst.zip(surface.statistics.fractal_range);
    let spectrum =
        surface_figures::Spectrum { points: surface.spectral.psd.clone(), fit, is_profile: false };
    let n = page.numbers.next_figure();
    if let Some(svg) = surface_figures::spectrum(&spectrum, &format!("{id}-f{n}")) {
        let fitted = if fit.is_some() {
            " Dashed: power law fitted over the grey band, raised 2.2×."
        } else {
            ""
        };
        out.push_str(&figure(
            &svg.inline(),
            &format!(
                "<b>Fig. {n}. Radial power spectrum</b>, {}.{fitted}",
                if surface.spectral.windowed { "Hann window" } else { "periodic" }
            ),
        ));
    }
    out.push_str("</div>\n");
    out
}

/// Error budget of the deterministic area, and what it does not cover.
pub(crate) fn accuracy(page: &mut ReportPage<'_>, surface: &SurfaceComparison) -> String {
    let Some(answer) = surface.headline_answer() else { return String::new() };
    let h = page.heading();
    let p = messages::headline_load(surface);
    let correction = page.numbers.source(AREA_CORRECTION);
    let budget = match answer.budget.area.half_width() {
        Ok(_) => budget::table(answer, surface, &p, correction),
        Err(reason) => format!(
            "<p class=\"keep\"><b>The area is without uncertainty estimate:</b> {}. Edges: {}</p>\n",
            escape(&reason.to_string()),
            edge_words(surface)
        ),
    };
    format!(
        "<{h}>Accuracy</{h}>\n{budget}{}<p class=\"why\">Not covered: {}, \
         friction, adhesion, waves longer than the map, instrument calibration.</p>\n",
        budget::choices(surface),
        if surface.inputs.hardness.is_some() {
            "hardening, pile-up, yield in the volume, unloading"
        } else {
            "plastic flow"
        }
    )
}
