//! `report.html`: one file, no network, readable without scripts.

use crate::draw::palette::{COLOURS, Colour};
use crate::draw::svg::escape;
use crate::error::ReportError;
use crate::messages;
use crate::numbers::{PASCALS, chosen};
use crate::page::context::{Numbering, ReportPage};
use crate::page::{
    conduction, contact_map, distributions, how_made, leak, overview, sections, slider,
};
use crate::provenance::Provenance;
use contact_compare::{Comparison, SurfaceComparison};
use contact_types::Citation;
use grid_fft::parallel::join;
use std::io::Write;

const STYLE: &str = include_str!("style.css");
/// The slider, then what follows it.
const SCRIPT: &str = concat!(
    include_str!("slider.js"),
    include_str!("follow.js"),
    include_str!("moving.js"),
    include_str!("deformed.js"),
    include_str!("distributions.js")
);
/// Nothing may be fetched: pictures are data, style and script are in the page.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; \
                      script-src 'unsafe-inline'";

/// Writes the report.
///
/// # Errors
/// [`ReportError`] if the writer fails or a picture cannot be encoded.
pub fn write(
    comparison: &Comparison,
    provenance: &Provenance,
    out: &mut impl Write,
) -> Result<(), ReportError> {
    let several = comparison.surfaces.len() > 1;
    let mut page = ReportPage {
        comparison,
        provenance,
        numbers: Numbering::default(),
        // Pictures take a byte and a half per pixel and colour noise does not compress: this
        // keeps those that stand still under 3 MB for up to ten surfaces. What moves adds 0.5 MB for each of up to four.
        map_limit: ((640.0 / (comparison.surfaces.len().max(1) as f64).sqrt()) as usize).max(160),
    };
    let mut body = String::new();
    if several {
        body.push_str(&overview::section(&mut page));
    }
    for (index, surface) in comparison.surfaces.iter().enumerate() {
        body.push_str(&surface_sections(&mut page, surface, index)?);
    }
    body.push_str(&how_made::section(&page));
    body.push_str(&references(&page.numbers.sources));

    let title = title(comparison);
    document(&title, several, &body, &format!("<script>{SCRIPT}</script>"), out)
}

/// The frame of a page: style, policy, body and, behind it, a script.
pub(crate) fn document(
    title: &str,
    several: bool,
    body: &str,
    script: &str,
    out: &mut impl Write,
) -> Result<(), ReportError> {
    write!(
        out,
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\
         <meta name=\"color-scheme\" content=\"light dark\"><title>{}</title>\n<style>\n{}</style>\
         </head>\n<body><main{}>\n{body}</main>\n{script}</body></html>\n",
        escape(title),
        style(),
        if several { " class=\"several\"" } else { "" }
    )?;
    Ok(())
}

/// The style sheet of every page: colours, light and dark, and type.
pub fn style() -> String {
    format!("{}{STYLE}", palette_css())
}

fn title(comparison: &Comparison) -> String {
    match comparison.surfaces.as_slice() {
        [one] => {
            let p = messages::headline_load(one);
            one.headline_answer().map_or_else(
                || format!("{} (rough-contact)", one.name),
                |a| format!("At {p} {} touches: {} (rough-contact)", messages::area(a), one.name),
            )
        }
        many => format!("{} surfaces compared (rough-contact)", many.len()),
    }
}

/// All sections of one surface; folded behind the overview where there are three or more.
fn surface_sections(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    index: usize,
) -> Result<String, ReportError> {
    let id = format!("s{index}");
    let loads = surface.deterministic.len();
    let heading = format!("<h2>{}</h2>", escape(&surface.name));
    let (element, title) = match page.comparison.surfaces.len() {
        1 => ("div", String::new()),
        2 => ("div", heading),
        _ => ("details", format!("<summary>{heading}</summary>")),
    };
    let mut out = format!("<{element} class=\"surface\" data-loads=\"{loads}\">\n{title}");
    out.push_str(&opening(page, surface));
    out.push_str(&sections::key_and_notes(page, surface, &id));
    out.push_str(&sections::over_load(page, surface, &id));
    out.push_str(&sections::models(page, surface));
    let limit = page.map_limit;
    let (touches, heights) = join(
        || contact_map::where_it_touches(page, surface, &id),
        || sections::HeightFigures::of(surface, limit),
    );
    out.push_str(&touches?);
    out.push_str(&distributions::section(page, surface, &id));
    out.push_str(&conduction::section(page, surface, &id));
    out.push_str(&leak::section(page, surface, &id)?);
    out.push_str(&sections::the_surface(page, surface, &heights?, &id));
    out.push_str(&sections::accuracy(page, surface));
    out.push_str(&slider::data(surface));
    out.push_str(&format!("</{element}>\n"));
    Ok(out)
}

fn opening(page: &ReportPage<'_>, surface: &SurfaceComparison) -> String {
    let say = messages::headline(surface);
    if page.several() {
        return format!("<header><p class=\"say\">{say}</p></header>\n");
    }
    format!(
        "<header><p class=\"file\">rough-contact report · <b>{}</b> · {}</p>\n<h1>{say}</h1></header>\n",
        escape(&surface.name),
        messages::date(page.provenance.unix_time)
    )
}

/// " · H = 2 GPa"; nothing of elastic bodies.
pub(crate) fn hardness_in_head(hardness: Option<f64>) -> String {
    hardness.map_or_else(String::new, |h| format!(" · <i>H</i> = {}", chosen(h, PASCALS)))
}

/// The list of sources, numbered as cited.
pub(crate) fn references(sources: &[Citation]) -> String {
    let items: String = sources
        .iter()
        .enumerate()
        .map(|(i, c)| {
            let doi =
                if c.doi.is_empty() { String::new() } else { format!(", doi:{}", escape(&c.doi)) };
            // A model of a user's own may have none.
            let year = if c.year > 0 { format!(" ({})", c.year) } else { String::new() };
            let title =
                if doi.is_empty() { format!("{}, ", escape(&c.title)) } else { String::new() };
            let (authors, journal) = (escape(&c.authors), escape(&c.journal));
            format!("<li id=\"r{}\">{authors}, {title}{journal}{year}{doi}.</li>\n", i + 1)
        })
        .collect();
    format!("<h2>References</h2>\n<ol class=\"refs\">{items}</ol>\n")
}

/// Colours by role: light, dark by preference or on request, and always light in print.
fn palette_css() -> String {
    let variables = |dark: bool| -> String {
        COLOURS
            .iter()
            .map(|c| format!("--{}:{};", c.class, if dark { c.dark } else { c.light }))
            .collect()
    };
    let (light, dark) = (variables(false), variables(true));
    let classes: String = COLOURS
        .iter()
        .map(|Colour { class, .. }| {
            format!(".s-{class}{{stroke:var(--{class})}}.f-{class}{{fill:var(--{class})}}")
        })
        .collect();
    format!(
        ":root{{color-scheme:light dark;{light}}}\n\
         @media screen and (prefers-color-scheme:dark){{:root:not([data-theme=light]){{{dark}}}\
         :root:not([data-theme=light]) .px{{filter:brightness(.86)}}}}\n\
         @media screen{{:root[data-theme=dark]{{color-scheme:dark;{dark}}}\
         :root[data-theme=dark] .px{{filter:brightness(.86)}}\
         :root[data-theme=light]{{color-scheme:light}}}}\n\
         @media print{{:root{{color-scheme:light}}}}\n{classes}\n"
    )
}
