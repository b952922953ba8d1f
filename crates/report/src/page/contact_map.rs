//! Where it touches: the contact map, an enlargement, and a section through both bodies.

use crate::error::ReportError;
use crate::figures::maps;
use crate::numbers::{METRES, chosen, significant};
use crate::page::context::Page;
use crate::page::deformed;
use crate::page::moving::{LARGEST, Moving, Pressures};
use crate::page::sections::{figure, reduced_words};
use compare::SurfaceComparison;
use rayon::join;

/// The contact map and an enlargement.
pub(crate) fn where_it_touches(
    page: &mut Page<'_>,
    surface: &SurfaceComparison,
    id: &str,
) -> Result<String, ReportError> {
    let grid = surface.solved_map().grid();
    if surface.pressure.len() != grid.len() || grid.shape().contains(&1) {
        return Ok(String::new());
    }
    let h = page.heading();
    let p = crate::words::headline_load(surface);
    let heights = surface.solved_map().heights();
    let window = maps::busiest_window(&surface.pressure, grid.shape());
    let n = page.next_figure();
    let key = format!("{id}-f{n}");
    let row = deformed::cut(surface).and(surface.sections.as_ref()).map(|s| s.row);
    let marks = maps::Marks { window, row };
    let moving = moving(page, surface);
    let (limit, surfaces) = (page.map_limit, page.comparison.surfaces.len());
    let (map, hidden) = join(
        || maps::contact(&surface.pressure, heights, grid, &marks, limit, &key),
        || moving.as_ref().map(|moving| moving.whole(limit, surfaces)).transpose(),
    );
    let map = map?;
    let (hidden, moves) = hidden?.map_or_else(Default::default, |(hidden, pressures)| {
        (hidden, moves_words(surface, &pressures, &p))
    });
    let mut out = format!(
        "<{h}>Where it touches at {}</{h}>\n<div class=\"two maps\">\n{}",
        if moving.is_some() { format!("<span data-k=\"load\">{p}</span>") } else { p },
        figure(
            &(map.inline() + &hidden),
            &format!(
                "<b>Fig. {n}. Contact map.</b> Colour: pressure. Grey relief: the surface under \
                 it.{}{moves}",
                reduced_words(grid.shape(), page.map_limit, "the highest pressure")
            )
        )
    );
    if let Some(window) = window {
        let key = format!("{key}b");
        let zoom = maps::enlarged(&surface.pressure, heights, grid, window, row, &key)?;
        let [dy, dx] = grid.pixel();
        let sides = [chosen(dx, METRES), chosen(dy, METRES)];
        let spacing = if sides[0] == sides[1] { sides[0].clone() } else { sides.join(" × ") };
        let [ny, nx] = grid.shape();
        let hidden = match &moving {
            Some(moving) => moving.relief(window, [0, 0, ny, nx], window[2].max(window[3]))?,
            None => String::new(),
        };
        out.push_str(&figure(
            &(zoom.inline() + &hidden),
            &format!(
                "<b>Boxed area</b>, enlarged {} times. One square is one point of the {}, \
                 {spacing}.",
                significant(grid.shape()[1] as f64 / window[3] as f64, 2),
                if surface.solved.is_some() { "grid solved on" } else { "map" }
            ),
        ));
    }
    out.push_str("</div>\n");
    out.push_str(&deformed::through(page, surface, moving.is_some(), id));
    Ok(out)
}

/// What moves with the slider, if the page bears it.
pub(crate) fn moving<'a>(page: &Page<'_>, surface: &'a SurfaceComparison) -> Option<Moving<'a>> {
    Moving::of(surface).filter(|_| page.comparison.surfaces.len() <= MOST_MOVING)
}

/// Of more surfaces the pictures that move would make the page too large.
const MOST_MOVING: usize = 4;

/// What the slider does to the contact map, for pages on which it moves.
fn moves_words(surface: &SurfaceComparison, pressures: &Pressures, headline: &str) -> String {
    let [ny, nx] = surface.solved_map().grid().shape();
    let dots = if ny.max(nx) > LARGEST {
        format!(", with {LARGEST} dots along the longer side, each in contact if a point of it is")
    } else {
        String::new()
    };
    let block = pressures.block;
    let mut coarse = String::new();
    if pressures.steps < u8::MAX {
        coarse.push_str(&format!(" in {} steps", pressures.steps));
    }
    if block > 1 {
        coarse.push_str(&format!(", of {block} × {block} points the highest"));
    }
    let loads = surface.deterministic.len();
    let which = match pressures.count {
        0 | 1 => format!("in one colour; the pressure is that at {headline}"),
        n if n < loads => format!(
            "at {n} of the {loads} loads in colours of its pressure{coarse}, at the others in one colour"
        ),
        _ => format!("in colours of its pressure there{coarse}"),
    };
    let bar = if pressures.count > 1 { "; the bar’s end follows" } else { "" };
    format!(
        "<span class=\"moves\"> At another load of the slider: what touches there{dots}, {which}{bar}. Nearer, down to \
         single points: the buttons, the wheel with Ctrl, two fingers, or with the focus on the map \
         + and −, arrows to move, 0 for the whole.</span>"
    )
}
