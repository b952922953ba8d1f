//! Where it touches: the contact map, an enlargement, and a section through both bodies.

use crate::error::ReportError;
use crate::figures::maps;
use crate::numbers::significant;
use crate::page::context::{ReportPage, figure};
use crate::page::deformed;
use crate::page::moving::Moving;
use crate::page::phrases::reduced_words;
use contact_compare::SurfaceComparison;
use grid_fft::parallel::join;

/// The contact map and an enlargement.
pub(crate) fn where_it_touches(
    page: &mut ReportPage<'_>,
    surface: &SurfaceComparison,
    id: &str,
) -> Result<String, ReportError> {
    let grid = surface.solved_map().grid();
    if surface.pressure.len() != grid.len() || grid.shape().contains(&1) {
        return Ok(String::new());
    }
    let h = page.heading();
    let p = crate::messages::headline_load(surface);
    let heights = surface.solved_map().heights();
    let window = maps::busiest_window(&surface.pressure, grid.shape());
    let n = page.numbers.next_figure();
    let key = format!("{id}-f{n}");
    let row = deformed::cut(surface).and(surface.sections.as_ref()).map(|s| s.row);
    let marks = maps::MapMarks { window, row };
    let moving = moving(page, surface);
    let (limit, surfaces) = (page.map_limit, page.comparison.surfaces.len());
    let (map, hidden) = join(
        || maps::contact(&surface.pressure, heights, grid, &marks, limit, &key),
        || moving.as_ref().map(|moving| moving.whole(limit, surfaces)).transpose(),
    );
    let map = map?;
    let hidden = hidden?.unwrap_or_default();
    let mut out = format!(
        "<{h}>Where it touches at {}</{h}>\n<div class=\"two maps\">\n{}",
        if moving.is_some() { format!("<span data-k=\"load\">{p}</span>") } else { p },
        figure(
            &(map.inline() + &hidden),
            &format!(
                "<b>Fig. {n}. Contact map.</b> Colour: pressure; grey: no contact.{}",
                reduced_words(grid.shape(), page.map_limit)
            )
        )
    );
    if let Some(window) = window {
        let key = format!("{key}b");
        let zoom = maps::enlarged(&surface.pressure, heights, grid, window, row, &key)?;
        let [ny, nx] = grid.shape();
        let hidden = match &moving {
            Some(moving) => moving.relief(window, [0, 0, ny, nx], window[2].max(window[3]))?,
            None => String::new(),
        };
        out.push_str(&figure(
            &(zoom.inline() + &hidden),
            &format!(
                "<b>Boxed area</b>, enlarged {}×.",
                significant(grid.shape()[1] as f64 / window[3] as f64, 2)
            ),
        ));
    }
    out.push_str("</div>\n");
    out.push_str(&deformed::through(page, surface, moving.is_some(), id));
    Ok(out)
}

/// What moves with the slider, if the page bears it.
pub(crate) fn moving<'a>(
    page: &ReportPage<'_>,
    surface: &'a SurfaceComparison,
) -> Option<Moving<'a>> {
    Moving::of(surface).filter(|_| page.comparison.surfaces.len() <= MOST_MOVING)
}

/// Of more surfaces the pictures that move would make the page too large.
const MOST_MOVING: usize = 4;
