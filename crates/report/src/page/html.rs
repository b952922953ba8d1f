//! `report.html`: one file, no network, readable without scripts.

use crate::draw::palette::{COLOURS, Colour};
use crate::draw::svg::escape;
use crate::error::ReportError;
use crate::numbers::{METRES, PASCALS, SPACE, chosen, fixed};
use crate::page::context::Page;
use crate::page::how_made::modulus_in_head;
use crate::page::{conduction, contact_map, distributions, how_made, overview, sections, slider};
use crate::provenance::Provenance;
use crate::words;
use compare::{Comparison, SurfaceComparison};
use contact_types::Citation;
use rayon::join;
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
    let mut page = Page {
        comparison,
        provenance,
        figures: 0,
        sources: Vec::new(),
        // Pictures take a byte and a half per pixel and colour noise does not compress: this
        // keeps those that stand still under 3 MB for up to ten surfaces. What moves adds 0.5 MB for each of up to four.
        map_limit: ((640.0 / (comparison.surfaces.len().max(1) as f64).sqrt()) as usize).max(160),
    };
    let mut body = String::new();
    if several {
        body.push_str(&overview::section(&mut page));
        for (index, surface) in comparison.surfaces.iter().enumerate() {
            let title = format!("<h2>{}</h2>", escape(&surface.name));
            body.push_str(&surface_sections(&mut page, surface, index, &title)?);
        }
    } else if let Some(surface) = comparison.surfaces.first() {
        body.push_str(&surface_sections(&mut page, surface, 0, "")?);
    }
    body.push_str(&how_made::section(&page));
    body.push_str(&references(&page.sources));

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
            let p = words::headline_load(one);
            one.headline_answer().map_or_else(
                || format!("{} (rough-contact)", one.name),
                |a| format!("At {p} {} touches: {} (rough-contact)", words::area(a), one.name),
            )
        }
        many => format!("{} surfaces compared (rough-contact)", many.len()),
    }
}

/// All sections of one surface. `title` is its heading where there are several.
fn surface_sections(
    page: &mut Page<'_>,
    surface: &SurfaceComparison,
    index: usize,
    title: &str,
) -> Result<String, ReportError> {
    let id = format!("s{index}");
    let loads = surface.deterministic.len();
    let mut out = format!("<div class=\"surface\" data-loads=\"{loads}\">\n{title}");
    out.push_str(&opening(page, surface));
    out.push_str(&sections::key_and_notes(surface, &id));
    out.push_str(&sections::over_load(page, surface, &id));
    out.push_str(&sections::models(page, surface));
    let limit = page.map_limit;
    let (touches, heights) = join(
        || contact_map::where_it_touches(page, surface, &id),
        || sections::Heights::of(surface, limit),
    );
    out.push_str(&touches?);
    out.push_str(&distributions::section(page, surface, &id));
    out.push_str(&conduction::section(page, surface, &id));
    out.push_str(&sections::the_surface(page, surface, &heights?, &id));
    out.push_str(&sections::accuracy(page, surface));
    out.push_str(&slider::data(surface));
    out.push_str("</div>\n");
    Ok(out)
}

fn opening(page: &Page<'_>, surface: &SurfaceComparison) -> String {
    let grid = surface.surface.grid();
    let ([ly, lx], [ny, nx]) = (grid.size(), grid.shape());
    let unit = crate::numbers::unit_for(lx, METRES);
    let side = |metres: f64| {
        let v = metres / unit.scale;
        fixed(v, if v < 9.995 { 3 } else { 1 })
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    };
    let (before, after) = if page.several() {
        (String::new(), String::new())
    } else {
        (
            format!("rough-contact report · <b>{}</b> · ", escape(&surface.name)),
            format!(" · {}", words::date(page.provenance.unix_time)),
        )
    };
    let hardness = hardness_in_head(surface.inputs.hardness);
    let line = format!(
        "<p class=\"file\">{before}{} × {}{SPACE}{}, {nx} × {ny} points · \
         {}{hardness}{after}</p>\n",
        side(lx),
        side(ly),
        unit.name,
        modulus_in_head(&page.comparison.settings)
    );
    let say = words::headline(surface);
    let first = if page.several() {
        format!("<p class=\"say\">{say}</p>\n")
    } else {
        format!("<h1>{say}</h1>\n")
    };
    format!("<header>{line}{first}<p>{}</p></header>\n", words::recommendation(surface))
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
            format!(
                "<li id=\"r{}\">{}, {}, {}{year}{doi}.</li>\n",
                i + 1,
                escape(&c.authors),
                escape(&c.title),
                escape(&c.journal),
            )
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
