//! How pressure and spots are distributed where it touches, and the gap where it does not.

use crate::figures::distributions::{GAP, PRESSURE, SPOTS as SPOT_AREAS};
use crate::numbers::{AREAS, METRES, PASCALS, percent, quantity};
use crate::page::contact_map;
use crate::page::context::{ReportPage, figure};
use crate::page::phrases::attribute;
use contact_compare::{Distributions, SurfaceComparison};

/// Touching points below which classes say little.
const LEAST: usize = 200;

/// What the captions say of a load: the key of a cell of the slider, and its words; `None` where there are none.
type Say = (&'static str, fn(&Distributions) -> Option<String>);

const HIGHEST: Say = ("d-highest", |d| Some(quantity(*d.pressure.edges.last()?, PASCALS, 2)));
const SPOTS: Say = ("d-spots", |d| Some(d.spots.count.to_string()));
const HALF: Say = ("d-half", |d| {
    let half = d.spots.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
    Some(quantity(d.spots.areas[half], AREAS, 2))
});
const TOUCHES: Say = ("d-touches", |d| Some(percent(1.0 - d.pressure.apart)));
const MEAN_GAP: Say = ("d-mean", |d| Some(quantity(d.gap.as_ref()?.mean, METRES, 2)));
const MOST_GAP: Say = ("d-most", |d| Some(quantity(*d.gap.as_ref()?.gaps.last()?, METRES, 2)));

/// Distributions of a load of which enough points touch.
fn at(surface: &SurfaceComparison, load: usize) -> Option<&Distributions> {
    let answer = surface.deterministic.get(load)?.answer.as_ref()?;
    let found = surface.distributions.get(load)?.as_ref()?;
    (answer.diagnostics.contact_pixels >= LEAST).then_some(found)
}

/// What the slider writes into the captions at each load.
pub(crate) fn cells(surface: &SurfaceComparison) -> impl Iterator<Item = (&str, Vec<String>)> {
    let all = [HIGHEST, SPOTS, HALF, TOUCHES, MEAN_GAP, MOST_GAP];
    all.into_iter().map(|(key, words)| {
        let of = |load| at(surface, load).and_then(words).unwrap_or_else(|| "–".into());
        (key, (0..surface.deterministic.len()).map(of).collect())
    })
}

/// Three figures; nothing where few points touch.
pub(crate) fn section(page: &mut ReportPage<'_>, surface: &SurfaceComparison, id: &str) -> String {
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
