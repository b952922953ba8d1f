//! `report.html`: one file, no network, readable without scripts.

use crate::draw::palette::{Colour, ROLES, SERIES};
use crate::draw::svg::escape;
use crate::messages;
use crate::page::shared::{Numbering, SurfacePart, date};
use crate::page::{conduction, contact_map, how_made, leak, overview, sections, slider, tables};
use crate::provenance::Provenance;
use contact_compare::{Comparison, findings};
use contact_types::Citation;
use grid_fft::parallel::join;

const STYLE: &str = include_str!("style.css");
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

pub(crate) fn report(comparison: &Comparison, provenance: &Provenance) -> String {
    let count = comparison.surfaces.len();
    let several = count > 1;
    // Pictures take a byte and a half per pixel and colour noise does not compress: this
    // keeps those that stand still under 3 MB for up to ten surfaces. What moves adds 0.5 MB for each of up to four.
    let map_limit = ((640.0 / (count.max(1) as f64).sqrt()) as usize).max(160);
    let mut numbers = Numbering::default();
    let mut body = String::new();
    if several {
        body += &overview::section(comparison, provenance, &mut numbers);
    }
    for (index, surface) in comparison.surfaces.iter().enumerate() {
        let (id, p) = (&*format!("s{index}"), &*messages::headline_load(surface));
        let (h, numbers) = (if several { "h3" } else { "h2" }, &mut numbers);
        let part = SurfacePart { comparison, surface, id, h, p, numbers, map_limit };
        body += &surface_sections(part, provenance);
    }
    body += &how_made::section(comparison, provenance);
    body += &references(&numbers.sources);
    document(&title(comparison), several, &body, &format!("<script>{SCRIPT}</script>"))
}

/// The frame of a page: style, policy, body and, behind it, a script.
pub(crate) fn document(title: &str, several: bool, body: &str, script: &str) -> String {
    let (title, style) = (escape(title), style());
    let class = if several { " class=\"several\"" } else { "" };
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\
         <meta name=\"color-scheme\" content=\"light dark\"><title>{title}</title>\n<style>\n{style}</style>\
         </head>\n<body><main{class}>\n{body}</main>\n{script}</body></html>\n"
    )
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
fn surface_sections(mut part: SurfacePart<'_>, made: &Provenance) -> String {
    let (surface, limit) = (part.surface, part.map_limit);
    let loads = surface.deterministic.len();
    let heading = format!("<h2>{}</h2>", escape(&surface.name));
    let (element, title) = match part.comparison.surfaces.len() {
        1 => ("div", String::new()),
        2 => ("div", heading),
        _ => ("details", format!("<summary>{heading}</summary>")),
    };
    let part = &mut part;
    let mut out = format!("<{element} class=\"surface\" data-loads=\"{loads}\">\n{title}");
    out += &opening(part, made);
    let (key, notes) = (tables::key_numbers(part), sections::notes(&findings(surface), part.id));
    out += &format!("<div class=\"two\">\n{key}{notes}</div>\n");
    out += &sections::over_load(part);
    out += &sections::models(part);
    let (touches, heights) =
        join(|| contact_map::where_it_touches(part), || sections::height_figures(surface, limit));
    out += &touches;
    out += &contact_map::distributions(part);
    out += &conduction::section(part);
    out += &leak::section(part);
    out += &sections::the_surface(part, heights);
    out += &sections::accuracy(part);
    out += &slider::data(surface);
    out + &format!("</{element}>\n")
}

fn opening(part: &SurfacePart<'_>, made: &Provenance) -> String {
    let say = messages::headline(part.surface);
    if part.comparison.surfaces.len() > 1 {
        return format!("<header><p class=\"say\">{say}</p></header>\n");
    }
    let (name, date) = (escape(&part.surface.name), date(made.unix_time));
    format!(
        "<header><p class=\"file\">rough-contact report · <b>{name}</b> · {date}</p>\n<h1>{say}</h1></header>\n"
    )
}

pub(crate) fn references(sources: &[Citation]) -> String {
    let item = |(i, c): (usize, &Citation)| {
        let [title, doi] = match escape(&c.doi) {
            none if none.is_empty() => [format!("{}, ", escape(&c.title)), none],
            doi => [String::new(), format!(", doi:{doi}")],
        };
        // A model of a user's own may have none.
        let year = if c.year > 0 { format!(" ({})", c.year) } else { String::new() };
        let (authors, journal) = (escape(&c.authors), escape(&c.journal));
        format!("<li id=\"r{}\">{authors}, {title}{journal}{year}{doi}.</li>\n", i + 1)
    };
    let items: String = sources.iter().enumerate().map(item).collect();
    format!("<h2>References</h2>\n<ol class=\"refs\">{items}</ol>\n")
}

/// Colours by role: light, dark by preference or on request, and always light in print.
fn palette_css() -> String {
    let all = || ROLES.iter().chain(&SERIES);
    let variables = |of: fn(&Colour) -> &'static str| -> String {
        all().map(|c| format!("--{}:{};", c.class, of(c))).collect()
    };
    let (light, dark) = (variables(|c| c.light), variables(|c| c.dark));
    let class = |Colour { class, .. }: &Colour| {
        format!(".s-{class}{{stroke:var(--{class})}}.f-{class}{{fill:var(--{class})}}")
    };
    let classes: String = all().map(class).collect();
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
