//! The sections of one surface, in the order of the report.

use crate::draw::svg::escape;
use crate::error::ReportError;
use crate::figures::curves::{self, Use};
use crate::figures::heights::{HeightPicture, height_figure};
use crate::figures::surface::{Histogram, histogram};
use crate::figures::{cost, surface as surface_figures};
use crate::lines::{Lines, YIELDING};
use crate::looks::look;
use crate::numbers::{
    METRES, PASCALS, SPACE, chosen, duration, quantity, signed_percent, significant,
};
use crate::page::budget;
use crate::page::context::Page;
use crate::page::pair;
use crate::page::phrases::levelled;
use crate::page::slider::dial;
use crate::page::{statistics, tables};
use crate::sources::AREA_CORRECTION;
use crate::words::edges::edge_words;
use crate::words::finding::finding;
use crate::words::{self, coarser};
use compare::{Finding, MomentSource, SurfaceComparison, Weight, findings};

/// A figure with its caption; the caption is HTML and opens with a bold subject.
pub(crate) fn figure(svg: &str, caption: &str) -> String {
    format!("<figure>{svg}<figcaption>{caption}</figcaption></figure>\n")
}

/// At most so many findings are shown.
const MOST: usize = 5;

/// The worst, and what was tested and is fine.
fn shown(mut findings: Vec<Finding>) -> Vec<Finding> {
    let passed = findings.pop_if(|f| f.weight == Weight::Passed);
    findings.truncate(MOST - usize::from(passed.is_some()));
    findings.extend(passed);
    findings
}

/// Key numbers beside "Read before use".
pub(crate) fn key_and_notes(surface: &SurfaceComparison, id: &str) -> String {
    let (key, notes) = (tables::key_numbers(surface), notes(&findings(surface), id));
    format!("<div class=\"two\">\n{key}{notes}</div>\n")
}

/// "Read before use".
pub(crate) fn notes(found: &[Finding], id: &str) -> String {
    let items: String = shown(found.to_vec())
        .iter()
        .map(|found| {
            let (class, word) = match found.weight {
                Weight::Check => ("check", "Check"),
                Weight::Note => ("note", "Note"),
                Weight::Passed => ("passed", "Passed"),
            };
            let words = finding(found);
            format!(
                "<li><span class=\"tag {class}\">{word}</span><b>{}</b> {}</li>\n",
                escape(&words.claim),
                escape(&words.text)
            )
        })
        .collect();
    format!(
        "<div><p class=\"cap\" id=\"{id}-w\">Read before use</p>\
         <ul class=\"warns\" aria-labelledby=\"{id}-w\">\n{items}</ul></div>\n"
    )
}

/// Figs. 1 to 4: area, real pressure, error, cost; the first three once for each kind of bodies.
pub(crate) fn over_load(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let h = page.heading();
    let p = words::headline_load(surface);
    let mut out = format!(
        "<{h}>Area and pressure against load</{h}>\n<p>{}</p>\n{}",
        words::curves_lead(surface),
        dial(surface, id)
    );
    let mut errors = String::new();
    for (k, lines) in Lines::panels(surface).iter().enumerate() {
        let drawn = panel(page, lines, id);
        let break_after = if k == 0 { " page1" } else { "" };
        out.push_str(&format!("<div class=\"two{break_after}\">\n{}</div>\n", drawn[0]));
        errors.push_str(&drawn[1]);
    }
    out.push_str(&format!("<div class=\"two\">\n{errors}"));
    if let Some(routes) = cost_routes(surface) {
        let four = page.next_figure();
        let full = surface.headline_answer().map_or(f64::NAN, |a| a.seconds);
        let floor = relative_uncertainty(surface);
        let caption = format!(
            "<b>Fig. {four}. What accuracy costs</b>, at {p}. Dashed: Pareto front; a point above \
             or right of it is beaten on both counts.{}{} Set-up, once per map: statistics and \
             spectra {}.",
            if floor.is_some() {
                ""
            } else {
                " The deterministic solution carries no ± here and is not drawn."
            },
            coarser::caption(surface, full),
            duration(surface.setup_seconds)
        );
        let svg = cost::figure(&routes, floor, &p, &format!("{id}-f{four}")).inline();
        out.push_str(&figure(&svg, &caption));
    }
    out.push_str("</div>\n");
    out
}

/// Area and pressure, and the error of each closed form, of the same bodies.
fn panel(page: &mut Page<'_>, lines: &Lines, id: &str) -> [String; 2] {
    let has_band = lines.interval.iter().flatten().count() > 1;
    let band = if has_band { " Grey band: ± of this map." } else { "" };
    let of = if lines.of.is_empty() { String::new() } else { format!(", {}", lines.of) };
    let one = page.next_figure();
    let area = figure(
        &curves::area(lines, &format!("{id}-f{one}"), Use::Page).inline(),
        &format!(
            "<b>Fig. {one}. Real contact area{of}.</b> Dots: deterministic solutions{}.{band} Dotted \
             vertical: load read off.",
            if lines.of == YIELDING { "; thin with rings: those of elastic bodies" } else { "" }
        ),
    );
    let two = page.next_figure();
    let pressure = figure(
        &curves::pressure(lines, &format!("{id}-f{two}"), Use::Page).inline(),
        &format!(
            "<b>Fig. {two}. Mean real pressure{of}</b>, load divided by real area.{}",
            rise(lines)
        ),
    );
    if lines.models.iter().all(|m| m.name == "elastic") {
        return [format!("{area}{pressure}"), String::new()]; // no theory of these bodies answers
    }
    let three = page.next_figure();
    let error = figure(
        &curves::error(lines, &format!("{id}-f{three}")).inline(),
        &format!(
            "<b>Fig. {three}. Error of each closed form{of}</b>, against the deterministic solution of \
             the same map{}. Light band: within 10{SPACE}%.{} Sampling does not enter: both \
             sides see the same map.",
            if lines.of.is_empty() { "" } else { " and bodies" },
            if has_band { " Dark band: numerical uncertainty of that solution alone." } else { "" }
        ),
    );
    [format!("{area}{pressure}"), error]
}

/// " It rises from 0.49 to 0.61 GPa while load rises 1000 times."
fn rise(lines: &Lines) -> String {
    let real: Vec<f64> = lines
        .pressures
        .iter()
        .zip(&lines.area)
        .filter_map(|(p, area)| Some(p / area.filter(|a| *a > 0.0)?))
        .collect();
    let (Some(lo), Some(hi)) =
        (real.iter().copied().min_by(f64::total_cmp), real.iter().copied().max_by(f64::total_cmp))
    else {
        return String::new();
    };
    let loads = &lines.pressures;
    let unit = crate::numbers::unit_for(hi, PASCALS);
    let spread = loads[loads.len() - 1] / loads[0];
    if spread <= 1.0 {
        return String::new();
    }
    format!(
        " It lies between {} and {}{SPACE}{} while load rises {} times.",
        significant(lo / unit.scale, 2),
        significant(hi / unit.scale, 2),
        unit.name,
        crate::numbers::times(spread)
    )
}

fn relative_uncertainty(surface: &SurfaceComparison) -> Option<f64> {
    let answer = surface.headline_answer()?;
    let u = answer.uncertainty()? / answer.area_fraction_corrected;
    (u > 0.0 && u.is_finite()).then_some(u)
}

fn cost_routes(surface: &SurfaceComparison) -> Option<Vec<cost::Route>> {
    let answer = surface.headline_answer()?;
    let mut routes: Vec<cost::Route> = words::ranked(surface)
        .into_iter()
        .map(|r| cost::Route {
            label: r.model.card.label.to_string(),
            series: r.model.card.name.to_string(),
            look: look(&r.model.card.name, r.place),
            seconds: r.seconds,
            error: r.error.abs(),
            bold: false,
        })
        .collect();
    routes.extend(coarser::routes(surface));
    if routes.is_empty() {
        return None;
    }
    // Without a bar the reference has no error to be drawn at.
    if let Some(u) = relative_uncertainty(surface) {
        routes.push(cost::deterministic(answer.seconds, u));
    }
    Some(routes)
}

/// The model table with its reading aid.
pub(crate) fn models(page: &mut Page<'_>, surface: &SurfaceComparison) -> String {
    let h = page.heading();
    let table = tables::models(page, surface);
    let covers = surface.headline_answer().map_or("", words::covers);
    let covers = if covers.is_empty() { String::new() } else { format!("{covers}. ") };
    format!(
        "<{h}>Which model to use</{h}>\n{table}<p class=\"why\">{covers}{} {}{}{}<span class=\"moves\"> A click on a \
         model follows it through all figures; a second one, or Escape, ends that.</span></p>\n",
        source_sentence(surface.inputs.source),
        words::within_ten(surface),
        formulas(surface),
        if surface.inputs.hardness.is_some() {
            " Errors of theories of elastic bodies are against the solution of elastic bodies, those of theories \
             of yield against that of the contact that yields."
        } else {
            ""
        }
    )
}

/// The formula of each model in the table that has one of a line.
fn formulas(surface: &SurfaceComparison) -> String {
    let with = surface.models.iter().filter(|m| m.outcome.is_ok() && !m.card.formula.is_empty());
    with.map(|m| format!(" {}: {}.", escape(&m.card.label), escape(&m.card.formula))).collect()
}

/// Where the moments come from.
fn source_sentence(source: MomentSource) -> &'static str {
    match source {
        MomentSource::FiniteDifferences => {
            "All moments are by finite differences: the same <i>m</i><sub>0</sub>, \
             <i>m</i><sub>2</sub>, <i>m</i><sub>4</sub> for every model."
        }
        MomentSource::Given => "The same moments for every model.",
    }
}

/// " Drawn at 640 × 640; each dot the … of the points it covers."
pub(crate) fn reduced_words([ny, nx]: [usize; 2], limit: usize, what: &str) -> String {
    if ny.max(nx) <= limit {
        return String::new();
    }
    let factor = ny.max(nx) as f64 / limit as f64;
    let side = |n: usize| (n as f64 / factor).round().max(1.0);
    format!(" Drawn with {} × {} dots, each {what} of the points it covers.", side(nx), side(ny))
}

/// What takes time in [`the_surface`].
pub(crate) struct Heights {
    /// `None` of a single profile.
    picture: Option<HeightPicture>,
    /// `None` of a flat map.
    histogram: Option<Histogram>,
}

impl Heights {
    /// # Errors
    /// If the picture cannot be encoded.
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
    page: &mut Page<'_>,
    surface: &SurfaceComparison,
    heights: &Heights,
    id: &str,
) -> String {
    let h = page.heading();
    let grid = surface.surface.grid();
    let p = words::headline_load(surface);
    let (title, first) = match surface.origin.pair() {
        Some(both) => ("Both surfaces as one", pair::opening(both)),
        None => ("The surface", String::new()),
    };
    let mut out = format!("<{h}>{title}</{h}>\n{first}<div class=\"two maps\">\n");
    if let Some(picture) = &heights.picture {
        let n = page.next_figure();
        let map = height_figure(picture, grid, &format!("{id}-f{n}"));
        out.push_str(&figure(
            &map.inline(),
            &format!(
                "<b>Fig. {n}. Height</b>, {}, lit from the upper left.{}",
                levelled(surface),
                reduced_words(grid.shape(), page.map_limit, "the mean height")
            ),
        ));
    } else {
        out.push_str("<p>A single profile: no map is drawn.</p>\n");
    }
    out.push_str(&statistics::table(surface));
    out.push_str("</div>\n<div class=\"two\">\n");
    if let Some(histogram) = &heights.histogram {
        let n = page.next_figure();
        let svg = surface_figures::heights(histogram, &p, &format!("{id}-f{n}")).inline();
        let lowest = histogram.touching.iter().position(|v| *v > 0.0);
        let words = lowest.map_or(String::new(), |k| {
            format!(
                " At {p} only heights above {}{SPACE}Sq touch.",
                crate::numbers::fixed(histogram.start + histogram.step * k as f64, 1)
            )
        });
        out.push_str(&figure(
            &svg,
            &format!("<b>Fig. {n}. Height distribution.</b> Line: normal distribution.{words}"),
        ));
    }
    let fit = surface.statistics.hurst.zip(surface.statistics.fractal_range);
    let spectrum =
        surface_figures::Spectrum { points: surface.spectral.psd.clone(), fit, is_profile: false };
    let n = page.next_figure();
    if let Some(svg) = surface_figures::spectrum(&spectrum, &format!("{id}-f{n}")) {
        let fitted = if fit.is_some() {
            " Dashed red: power-law fit over the grey band, drawn 2.2 times high to stay visible."
        } else {
            ""
        };
        out.push_str(&figure(
            &svg.inline(),
            &format!(
                "<b>Fig. {n}. Radial power spectrum</b>, {}.{fitted}",
                if surface.spectral.windowed {
                    "under a Hann window"
                } else {
                    "of the map as it repeats"
                }
            ),
        ));
    }
    out.push_str("</div>\n");
    out
}

/// Error budget of the deterministic area, and what it does not cover.
pub(crate) fn accuracy(page: &mut Page<'_>, surface: &SurfaceComparison) -> String {
    let Some(answer) = surface.headline_answer() else { return String::new() };
    let h = page.heading();
    let p = words::headline_load(surface);
    let correction = page.source(AREA_CORRECTION);
    let raw = answer.area_fraction / answer.area_fraction_corrected - 1.0;
    let cutoff = surface
        .statistics
        .cutoff
        .map_or(String::new(), |l| format!(", shortest wavelength {}", quantity(l, METRES, 2)));
    let [dy, dx] = surface.surface.grid().pixel();
    let spacing = chosen(dx.max(dy), METRES);
    let conditions = format!(
        "An area means nothing without its short-wavelength limit: here the point spacing is \
         {spacing}{cutoff}, rms gradient {}.",
        significant(surface.inputs.rms_gradient(), 3)
    );
    let counted = if raw.is_finite() {
        format!(
            "The plain count of touching points would read {} ({}); the area above is corrected \
             for the contact line, {} edges per point [<a href=\"#r{correction}\">{correction}</a>].",
            area_percent(answer.area_fraction),
            signed_percent(raw),
            significant(answer.contact_perimeter, 2)
        )
    } else {
        String::new()
    };
    let budget = match answer.budget.area.half_width() {
        Ok(_) => budget::table(answer, surface, &p),
        Err(reason) => format!(
            "<p class=\"keep\"><b>The area is without uncertainty estimate:</b> {}. Edges: {}</p>\n",
            escape(&reason.to_string()),
            edge_words(surface)
        ),
    };
    format!(
        "<{h}>How accurate the deterministic answer is</{h}>\n{budget}<div class=\"two\">\n\
         <div>{}</div>\n<div><p style=\"margin-top:0\">{conditions}</p><p>{counted}</p></div></div>\n\
         <p class=\"why\">Not covered: {}, friction, adhesion, waves longer than the map, \
         and the instrument’s own calibration and transfer function.</p>\n",
        budget::choices(surface),
        if surface.inputs.hardness.is_some() {
            "hardening, pile-up, a hardness that depends on size, plastic flow in the volume, unloading"
        } else {
            "plastic flow"
        }
    )
}

fn area_percent(fraction: f64) -> String {
    format!("{}{SPACE}%", significant(100.0 * fraction, 3))
}
