//! How pressure and spots are distributed where it touches, and the gap where it does not.

use crate::figures::distributions::{gap, pressure, spots};
use crate::numbers::{AREAS, METRES, percent, quantity, significant};
use crate::page::context::Page;
use crate::page::sections::figure;
use compare::SurfaceComparison;

/// Touching points below which classes say little.
const LEAST: usize = 200;

/// Three figures; nothing where few points touch.
pub(crate) fn section(page: &mut Page<'_>, surface: &SurfaceComparison, id: &str) -> String {
    let touching = surface.headline_answer().map_or(0, |a| a.contact_pixels);
    let Some(found) = surface.distributions.as_ref().filter(|_| touching >= LEAST) else {
        return String::new();
    };
    let (one, two) = (page.next_figure(), page.next_figure());
    let begins = found.pressure.exponent_at_zero.map_or(String::new(), |s| {
        format!(
            " Here it begins as <i>p</i><sup><i>s</i></sup>, <i>s</i> = {}, by the shares of the contact below \
             0.1 and 0.3 of the mean: points on contact lines hold what the grid does not resolve there, \
             and <i>s</i> rises towards 1 with more points.",
            significant(s, 2)
        )
    });
    let half = found.spots.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
    let apart = found.gap.as_ref().map_or(String::new(), |between| {
        let n = page.next_figure();
        figure(
            &gap(between, 1.0 - found.pressure.apart, &format!("{id}-f{n}")).inline(),
            &format!(
                "<b>Fig. {n}. Distribution of the gap</b>: share of the nominal area where the bodies stand closer \
                 than that, the {} that touch included. Elsewhere the gap is {} in the mean, {} at most.",
                percent(1.0 - found.pressure.apart),
                quantity(between.mean, METRES, 2),
                quantity(between.gaps[between.gaps.len() - 1], METRES, 2)
            ),
        )
    });
    format!(
        "<div class=\"two\">\n{}{}{apart}</div>\n",
        figure(
            &pressure(&found.pressure, &format!("{id}-f{one}")).inline(),
            &format!(
                "<b>Fig. {one}. Distribution of the pressure</b> over the contact; {} of the nominal area has \
                 none. Dashed: Persson’s theory at a light load, whose density rises linearly from zero.{begins}",
                percent(found.pressure.apart)
            ),
        ),
        figure(
            &spots(&found.spots, &format!("{id}-f{two}")).inline(),
            &format!(
                "<b>Fig. {two}. Contact spots by size</b>: share of the contact area, and of the {} spots, in spots \
                 at least as large. Half of the area is in spots of {} and more. One point of the map is {}.",
                found.spots.count,
                quantity(found.spots.areas[half], AREAS, 2),
                quantity(found.spots.areas[0], AREAS, 2)
            ),
        )
    )
}
