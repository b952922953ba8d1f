//! Where it touches: the contact map, an enlargement, a section through both bodies; how pressure and spots are
//! distributed there, and the gap elsewhere.

use crate::figures::distributions::{GAP, PRESSURE, SPOTS};
use crate::figures::maps;
use crate::numbers::{AREAS, METRES, PASCALS, percent, quantity, significant};
use crate::page::shared::{SurfacePart, attribute, figure, reduced_words};
use crate::page::{deformed, moving};
use contact_compare::{Distributions, FirstContact, SurfaceComparison};
use grid_fft::parallel::join;

pub(crate) fn where_it_touches(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, id, h, p, map_limit: limit, .. } = *part;
    let (grid, pressure) = (surface.solved_map().grid(), &surface.pressure);
    if pressure.len() != grid.len() || grid.shape().contains(&1) {
        return String::new();
    }
    let heights = surface.solved_map().heights();
    let window = maps::busiest_window(pressure, grid.shape());
    let n = part.numbers.next_figure();
    let key = format!("{id}-f{n}");
    let cut = deformed::cut(surface);
    let row = cut.as_ref().map(|(_, row)| *row);
    let (contact, surfaces) = (moves(part), part.comparison.surfaces.len());
    let moves = contact.is_some();
    let hidden = |contact: &_| moving::whole(surface, contact, limit, surfaces);
    let (map, hidden) = join(
        || maps::contact(pressure, heights, grid, (window, row), limit).inline(&key),
        || contact.map_or_else(String::new, hidden),
    );
    let load = if moves { format!("<span data-k=\"load\">{p}</span>") } else { p.into() };
    let reduced = reduced_words(grid.shape(), limit);
    let caption =
        format!("<b>Fig. {n}. Contact map.</b> Colour: pressure; grey: no contact.{reduced}");
    let mut shown = figure(&(map + &hidden), &caption);
    if let Some(window) = window {
        let zoom = maps::enlarged(pressure, heights, grid, window, row).inline(&format!("{key}b"));
        let side = window[2].max(window[3]);
        let hidden = if moves { moving::relief(surface, window, side) } else { String::new() };
        let times = significant(grid.shape()[1] as f64 / window[3] as f64, 2);
        let caption = format!("<b>Boxed area</b>, enlarged {times}×.");
        shown += &figure(&(zoom + &hidden), &caption);
    }
    let section = deformed::through(part, cut, moves);
    format!(
        "<{h}>Where it touches at {load}</{h}>\n<div class=\"two maps\">\n{shown}</div>\n{section}"
    )
}

/// What moves with the slider, if the page bears it.
fn moves<'a>(part: &SurfacePart<'a>) -> Option<&'a FirstContact> {
    moving::moves(part.surface).filter(|_| part.comparison.surfaces.len() <= MOST_MOVING)
}

/// Of more surfaces the pictures that move would make the page too large.
const MOST_MOVING: usize = 4;

/// Touching points below which classes say little.
const LEAST: usize = 200;

/// What the captions say of a load: the key of a cell of the slider, and its words; `None` where there are none.
type Say = (&'static str, fn(&Distributions) -> Option<String>);

const SAID: [Say; 6] = [
    ("d-highest", |d| Some(quantity(*d.pressure.edges.last()?, PASCALS, 2))),
    ("d-spots", |d| Some(d.spots.count.to_string())),
    ("d-half", |d| {
        let half = d.spots.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
        Some(quantity(d.spots.areas[half], AREAS, 2))
    }),
    ("d-touches", |d| Some(percent(1.0 - d.pressure.apart))),
    ("d-mean", |d| Some(quantity(d.gap.as_ref()?.mean, METRES, 2))),
    ("d-most", |d| Some(quantity(*d.gap.as_ref()?.gaps.last()?, METRES, 2))),
];

/// Distributions of a load of which enough points touch.
fn at(surface: &SurfaceComparison, load: usize) -> Option<&Distributions> {
    let answer = surface.deterministic.get(load)?.answer.as_ref()?;
    let found = surface.distributions.get(load)?.as_ref()?;
    (answer.diagnostics.contact_pixels >= LEAST).then_some(found)
}

/// What the slider writes into the captions at each load.
pub(crate) fn cells(surface: &SurfaceComparison) -> impl Iterator<Item = (&str, Vec<String>)> {
    SAID.into_iter().map(|(key, words)| {
        let of = |load| at(surface, load).and_then(words).unwrap_or_else(|| "–".into());
        (key, (0..surface.deterministic.len()).map(of).collect())
    })
}

/// Three figures; nothing where few points touch.
pub(crate) fn distributions(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, id, .. } = *part;
    let Some(found) = at(surface, surface.headline) else { return String::new() };
    let moves = moves(part).is_some();
    let say = |(key, words): Say| {
        let words = words(found).unwrap_or_default();
        if moves { format!("<span data-k=\"{key}\">{words}</span>") } else { words }
    };
    let [highest, spots, half, touches, mean, most] = SAID.map(say);
    let captions = [
        format!("Pressure in contact</b>, at most {highest}. Dashed: Persson, light load."),
        format!(
            "Contact spots</b>: {spots}; half of the contact area in spots of at least {half}."
        ),
        format!(
            "Gap</b>: none at {touches} of the points; elsewhere {mean} in the mean, {most} at most."
        ),
    ];
    let loads: Vec<_> = (0..surface.deterministic.len()).map(|i| at(surface, i)).collect();
    let why = format!("Fewer than {LEAST} points touch at this load.");
    let mut figures = String::new();
    let there = [PRESSURE, SPOTS, GAP].into_iter().zip(captions).filter(|(of, _)| of.is_in(found));
    for (of, caption) in there {
        let n = part.numbers.next_figure();
        let Some(still) = of.figure(found) else { continue };
        let facts = of.moving(&loads, &why).filter(|_| moves).map(|facts| {
            format!("<span class=\"spread\" hidden data-facts='{}'></span>", attribute(&facts))
        });
        let shown = still.inline(&format!("{id}-f{n}")) + &facts.unwrap_or_default();
        figures += &figure(&shown, &format!("<b>Fig. {n}. {caption}"));
    }
    format!("<div class=\"two\">\n{figures}</div>\n")
}
