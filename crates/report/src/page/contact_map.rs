//! Where it touches: the contact map, an enlargement, a section through both bodies; how pressure and spots are
//! distributed there, and the gap elsewhere.

use crate::draw::palette::{OkLab, PRESSURE_RAMP, ramp_table};
use crate::figures::deformed::{PressedRow, SectionCut, section};
use crate::figures::distributions::{GAP, PRESSURE, SPOTS};
use crate::figures::maps::{self, FEWEST_STEPS, combined};
use crate::lines::min_max;
use crate::numbers::{AREAS, METRES, PASCALS, fixed, percent, quantity, significant};
use crate::page::moving::{self, LARGEST};
use crate::page::shared::{SurfacePart, attribute, figure, reduced_words, touching, wide};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use contact_compare::{
    DeterministicPoint, Distributions, FirstContact, Section, SurfaceComparison,
};
use grid_fft::parallel::join;
use serde_json::{Value, json};

pub(crate) fn where_it_touches(part: &mut SurfacePart<'_>) -> String {
    let SurfacePart { surface, id, h, p, map_limit: limit, .. } = *part;
    let (grid, pressure) = (surface.solved_map().grid(), &surface.pressure);
    if pressure.len() != grid.len() || grid.shape().contains(&1) {
        return String::new();
    }
    let window = maps::busiest_window(pressure, grid.shape());
    let n = part.numbers.next_figure();
    let key = format!("{id}-f{n}");
    let cut = cut(surface);
    let row = cut.as_ref().map(|(_, row)| *row);
    let (contact, surfaces) = (moves(part), part.comparison.surfaces.len());
    let moves = contact.is_some();
    let hidden = |contact: &_| moving::whole(surface, contact, limit, surfaces);
    let (map, hidden) = join(
        || maps::contact(surface, (window, row), limit).inline(&key),
        || contact.map_or_else(String::new, hidden),
    );
    let load = if moves { format!("<span data-k=\"load\">{p}</span>") } else { p.into() };
    let reduced = reduced_words(grid.shape(), limit);
    let caption =
        format!("<b>Fig. {n}. Contact map.</b> Colour: pressure; grey: no contact.{reduced}");
    let mut shown = figure(&(map + &hidden), &caption);
    if let Some(window) = window {
        let zoom = maps::enlarged(surface, window, row).inline(&format!("{key}b"));
        let side = window[2].max(window[3]);
        let hidden = if moves { moving::relief(surface, window, side) } else { String::new() };
        let times = significant(grid.shape()[1] as f64 / window[3] as f64, 2);
        let caption = format!("<b>Boxed area</b>, enlarged {times}×.");
        shown += &figure(&(zoom + &hidden), &caption);
    }
    let section = through(part, cut, moves);
    format!(
        "<{h}>Where it touches at {load}</{h}>\n<div class=\"two maps\">\n{shown}</div>\n{section}"
    )
}

/// What lies along the row of a surface, and which row it is; `None` if not every load has an answer or nothing is rough.
fn cut(surface: &SurfaceComparison) -> Option<(SectionCut, usize)> {
    let sections: Vec<&Section> =
        surface.sections.iter().map(Option::as_ref).collect::<Option<_>>()?;
    let row = sections.first()?.row;
    let map = surface.solved_map();
    let [ny, nx] = map.grid().shape();
    let (low, high) = map.range();
    if row >= ny || nx < 2 || high <= low {
        return None;
    }
    let mean = map.mean();
    // Each load has a scale of its own, that of the map.
    let tops: Vec<f64> = surface.pressure_maps.as_ref()?.loads.iter().map(|l| l.top).collect();
    // One value for each point, or of longer rows for the points that one of so many parts covers.
    let parts = |values: &[f64], both: fn(f64, f64) -> f64| {
        combined(values, [1, nx], [1, nx.min(LARGEST)], both)
    };
    let along = map.heights()[row * nx..(row + 1) * nx].iter().map(|z| z - mean);
    let pressed = surface.deterministic.iter().zip(sections.into_iter().zip(&tops));
    let loads = pressed.map(|(point, (Section { gap, pressure, .. }, top))| {
        let open = |(p, g): (&f64, &f64)| if *p > 0.0 { 0.0 } else { g.max(0.0) };
        let open: Vec<f64> = pressure.iter().zip(gap).map(open).collect();
        let share: Vec<f64> = pressure.iter().map(|p| (p / top).min(1.0)).collect();
        Some(PressedRow {
            flat: point.answer.as_ref()?.mean_gap?,
            gap: parts(&open, f64::min),
            pressure: parts(&share, f64::max),
        })
    });
    let loads = loads.collect::<Option<Vec<PressedRow>>>();
    let loads = loads.filter(|loads| loads.len() == surface.deterministic.len())?;
    let heights = parts(&along.collect::<Vec<_>>(), f64::max);
    let cut = SectionCut { length: map.grid().size()[1], heights, loads };
    Some((cut, row))
}

/// The figure with its caption; with what the script moves, if the page `moves`.
fn through(part: &mut SurfacePart<'_>, cut: Option<(SectionCut, usize)>, moves: bool) -> String {
    let SurfacePart { surface, id, .. } = *part;
    let Some((cut, row)) = cut else { return String::new() };
    let n = part.numbers.next_figure();
    let touching = touching(surface);
    let title = |(point, (load, share)): (&DeterministicPoint, (&PressedRow, &String))| {
        let at = crate::messages::load(point.mean_pressure, surface.load_area);
        let flat = quantity(load.flat, METRES, 3);
        format!(
            "At {at} the flat stands {flat} above the mean plane; {share} of this line touches."
        )
    };
    let loads = surface.deterministic.iter().zip(cut.loads.iter().zip(&touching));
    let titles: Vec<String> = loads.map(title).collect();
    let headline = surface.headline;
    let svg = section(&cut, headline, titles[headline].clone()).inline(&format!("{id}-f{n}"));
    let facts = if moves {
        let data = facts(&cut, row, surface.solved_map().grid().shape()[0], &titles);
        format!("<span class=\"cut\" hidden data-facts='{}'></span>", attribute(&data))
    } else {
        String::new()
    };
    let tall = cut.exaggeration();
    let tall = if tall < 9.5 { significant(tall, 2) } else { fixed(tall.round(), 0) };
    let k = if moves { " data-k=\"cut\"" } else { "" };
    let caption = format!(
        "<b>Fig. {n}. Section</b> along the dashed line; <span{k}>{}</span> of it touches. Dotted: before \
         loading. Vertical exaggeration <span class=\"tall\">{tall}</span>×.",
        touching[headline]
    );
    wide(&figure(&(svg + &facts), &caption))
}

/// Heights and gaps in 16 bits of one step, little end first, pressures in classes of the ramp; load after load.
fn facts(cut: &SectionCut, row: usize, rows: usize, titles: &[String]) -> Value {
    let (low, high) = min_max(cut.heights.iter().copied()).unwrap_or_default();
    let gaps = || cut.loads.iter().flat_map(|l| l.gap.iter().copied());
    let step = gaps().fold(high - low, f64::max) / f64::from(u16::MAX);
    let sixteen = |values: &mut dyn Iterator<Item = f64>| {
        let bytes = values.flat_map(|v| ((v / step).round() as u16).to_le_bytes());
        STANDARD.encode(bytes.collect::<Vec<u8>>())
    };
    let class =
        |p: f64| if p > 0.0 { 1 + (f64::from(FEWEST_STEPS - 1) * p).round() as u8 } else { 0 };
    let pressure: Vec<u8> =
        cut.loads.iter().flat_map(|l| l.pressure.iter().map(|p| class(*p))).collect();
    let colours = ramp_table::<{ FEWEST_STEPS as usize }>(&PRESSURE_RAMP).map(OkLab::hex);
    json!({
        "scales": cut.scales(),
        "tall": cut.exaggeration(),
        "row": (row as f64 + 0.5) / rows as f64,
        "step": step,
        "low": low,
        "flats": cut.loads.iter().map(|l| l.flat).collect::<Vec<_>>(),
        "heights": sixteen(&mut cut.heights.iter().map(|z| z - low)),
        "gaps": sixteen(&mut gaps()),
        "pressures": STANDARD.encode(pressure),
        "colours": colours.concat(),
        "titles": titles,
    })
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
