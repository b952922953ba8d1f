//! How pressure and spots are distributed where it touches, and the gap where it does not.

use crate::figures::distributions::Kind;
use crate::numbers::{AREAS, quantity};
use crate::page::contact_map;
use crate::page::context::Page;
use crate::page::phrases::attribute;
use crate::page::sections::figure;
use crate::page::spread::{
    APART, EXPONENT, HALF, LEAST, MEAN_GAP, MOST_GAP, SPOTS, Say, TOUCHES, at,
};
use compare::SurfaceComparison;

/// Three figures; nothing where few points touch.
pub(crate) fn section(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let Some(found) = at(surface, surface.headline) else { return String::new() };
    let moves = contact_map::moving(page, surface).is_some();
    let say = |(key, words): Say| {
        let words = words(found).unwrap_or_default();
        if moves { format!("<span data-k=\"{key}\">{words}</span>") } else { words }
    };
    let begins = found.pressure.exponent_at_zero.map_or(String::new(), |_| {
        format!(
            " Here it begins as <i>p</i><sup><i>s</i></sup>, <i>s</i> = {}, by the shares of the contact below \
             0.1 and 0.3 of the mean: points on contact lines hold what the grid does not resolve there, \
             and <i>s</i> rises towards 1 with more points.",
            say(EXPONENT)
        )
    });
    let captions = [
        (
            Kind::Pressure,
            format!(
                "Distribution of the pressure</b> over the contact; {} of the nominal area has \
                 none. Dashed: Persson’s theory at a light load, whose density rises linearly from zero.{begins}",
                say(APART)
            ),
        ),
        (
            Kind::Spots,
            format!(
                "Contact spots by size</b>: share of the contact area, and of the {} spots, in spots \
                 at least as large. Half of the area is in spots of {} and more. One point of the map is {}.",
                say(SPOTS),
                say(HALF),
                quantity(found.spots.areas[0], AREAS, 2)
            ),
        ),
        (
            Kind::Gap,
            format!(
                "Distribution of the gap</b>: share of the nominal area where the bodies stand closer \
                 than that, the {} that touch included. Elsewhere the gap is {} in the mean, {} at most.",
                say(TOUCHES),
                say(MEAN_GAP),
                say(MOST_GAP)
            ),
        ),
    ];
    let loads: Vec<_> = (0..surface.deterministic.len()).map(|i| at(surface, i)).collect();
    let why = format!("Fewer than {LEAST} points touch at this load.");
    let mut figures = String::new();
    for (kind, caption) in captions {
        let Some(still) = kind.figure(found, &format!("{id}-f{}", page.figures + 1)) else {
            continue;
        };
        let n = page.next_figure();
        let facts = kind.moving(&loads, &why).filter(|_| moves).map(|facts| {
            format!("<span class=\"spread\" hidden data-facts='{}'></span>", attribute(&facts))
        });
        let follows = if moves {
            "<span class=\"moves\"> It follows the slider; the axes are those of all loads.</span>"
        } else {
            ""
        };
        figures.push_str(&figure(
            &(still.inline() + &facts.unwrap_or_default()),
            &format!("<b>Fig. {n}. {caption}{follows}"),
        ));
    }
    format!("<div class=\"two\">\n{figures}</div>\n")
}
