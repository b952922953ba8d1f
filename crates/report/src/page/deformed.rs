//! The section through the contact: its figure at the headline, and what the script needs for the other loads.

use crate::draw::palette::{OkLab, PRESSURE_RAMP, ramp_table};
use crate::figures::deformed::{PressedRow, SectionCut, section};
use crate::figures::maps::{FEWEST_STEPS, combined};
use crate::lines::min_max;
use crate::numbers::{METRES, fixed, quantity, significant};
use crate::page::moving::LARGEST;
use crate::page::shared::{SurfacePart, attribute, figure, touching, wide};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use contact_compare::{DeterministicPoint, Section, SurfaceComparison};
use serde_json::json;

/// What lies along the row of a surface, and which row it is; `None` if not every load has an answer or nothing is rough.
pub(crate) fn cut(surface: &SurfaceComparison) -> Option<(SectionCut, usize)> {
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
    let loads: Option<Vec<PressedRow>> = pressed
        .map(|(point, (Section { gap, pressure, .. }, top))| {
            let open = |(p, g): (&f64, &f64)| if *p > 0.0 { 0.0 } else { g.max(0.0) };
            let open: Vec<f64> = pressure.iter().zip(gap).map(open).collect();
            let share: Vec<f64> = pressure.iter().map(|p| (p / top).min(1.0)).collect();
            Some(PressedRow {
                flat: point.answer.as_ref()?.mean_gap?,
                gap: parts(&open, f64::min),
                pressure: parts(&share, f64::max),
            })
        })
        .collect();
    let loads = loads.filter(|loads| loads.len() == surface.deterministic.len())?;
    let heights = parts(&along.collect::<Vec<_>>(), f64::max);
    let cut = SectionCut { length: map.grid().size()[1], heights, loads };
    Some((cut, row))
}

/// The figure with its caption; with what the script moves, if the page `moves`.
pub(crate) fn through(
    part: &mut SurfacePart<'_>,
    cut: Option<(SectionCut, usize)>,
    moves: bool,
) -> String {
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
fn facts(cut: &SectionCut, row: usize, rows: usize, titles: &[String]) -> serde_json::Value {
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
