//! How pressure and spots are distributed where it touches, and the gap where it does not.

use crate::figures::distributions::{GAP, PRESSURE, SPOTS as SPOT_AREAS};
use crate::page::contact_map;
use crate::page::context::{Page, figure};
use crate::page::phrases::attribute;
use crate::page::spread::{HALF, HIGHEST, LEAST, MEAN_GAP, MOST_GAP, SPOTS, Say, TOUCHES, at};
use contact_compare::SurfaceComparison;

/// Three figures; nothing where few points touch.
pub(crate) fn section(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let Some(found) = at(surface, surface.headline) else { return String::new() };
    let moves = contact_map::moving(page, surface).is_some();
    let say = |(key, words): Say| {
        let words = words(found).unwrap_or_default();
        if moves { format!("<span data-k=\"{key}\">{words}</span>") } else { words }
    };
    let captions = [
        (
            PRESSURE,
            format!(
                "Pressure in contact</b>, at most {}. Dashed: Persson, light load.",
                say(HIGHEST)
            ),
        ),
        (
            SPOT_AREAS,
            format!(
                "Contact spots</b>: {}; half of the contact area in spots of at least {}.",
                say(SPOTS),
                say(HALF)
            ),
        ),
        (
            GAP,
            format!(
                "Gap</b>: none at {} of the points; elsewhere {} in the mean, {} at most.",
                say(TOUCHES),
                say(MEAN_GAP),
                say(MOST_GAP)
            ),
        ),
    ];
    let loads: Vec<_> = (0..surface.deterministic.len()).map(|i| at(surface, i)).collect();
    let why = format!("Fewer than {LEAST} points touch at this load.");
    let mut figures = String::new();
    for (of, caption) in captions {
        if !of.is_in(found) {
            continue;
        }
        let n = page.numbers.next_figure();
        let Some(still) = of.figure(found, &format!("{id}-f{n}")) else { continue };
        let facts = of.moving(&loads, &why).filter(|_| moves).map(|facts| {
            format!("<span class=\"spread\" hidden data-facts='{}'></span>", attribute(&facts))
        });
        figures.push_str(&figure(
            &(still.inline() + &facts.unwrap_or_default()),
            &format!("<b>Fig. {n}. {caption}"),
        ));
    }
    format!("<div class=\"two\">\n{figures}</div>\n")
}
