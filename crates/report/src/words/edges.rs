//! What lay beyond the edges of a measured map, and how much it matters on this map.

use crate::numbers::{METRES, percent, quantity, signed_percent, significant};
use compare::{EdgesName, Origin, Seam, SurfaceComparison, seam};
use contact_accuracy::EdgeShare;
use surface_stats::Edges;

/// For "How this was made": the treatment of the edges.
pub(crate) fn treatment(surface: &SurfaceComparison) -> &'static str {
    match (surface.edges, &surface.origin) {
        (EdgesName::Mirrored, _) => "Continued by its mirror images.",
        (EdgesName::Periodic, Origin::Recipe(_)) => "Periodic, as made.",
        (EdgesName::Periodic, Origin::Given(given)) if given.repeats == Some(true) => {
            "Periodic, as given."
        }
        (EdgesName::Periodic, Origin::Pair(_)) if surface.origin.edges() == Edges::Periodic => {
            "Periodic, as both bodies were made."
        }
        (EdgesName::Periodic, Origin::File(_) | Origin::Given(_) | Origin::Pair(_)) => {
            "Repeated periodically as it is."
        }
    }
}

/// For the error budget, the one place with all of it: the treatment, and for a map whose edges
/// were made up its effect.
pub(crate) fn edge_words(surface: &SurfaceComparison) -> String {
    let done = treatment(surface);
    if done.starts_with("Periodic") {
        return done.to_owned();
    }
    seam(surface).map_or(done.to_owned(), |s| format!("{done} {}", seam_words(&s)))
}

/// What the strip along the edges does to the area, in one sentence.
pub(crate) fn seam_effect(seam: &Seam) -> String {
    format!(
        "The strip along the edges moves the area by {}.",
        signed_percent(seam.share.direct_effect())
    )
}

/// What a strip holds of map, contact and load, and how often what its part of the map would.
fn held(share: &EdgeShare) -> String {
    let times = |part: f64| format!("{} times their share", significant(part / share.map, 2));
    format!(
        "{} of the map, {} of the touching points ({}) and {} of the load ({})",
        percent(share.map),
        percent(share.contact),
        times(share.contact),
        percent(share.load),
        times(share.load).replace("their", "its")
    )
}

/// What the strip along the edges holds and does.
fn seam_words(seam: &Seam) -> String {
    let share = &seam.share;
    let [high, wide] = seam.strip.map(|d| quantity(d, METRES, 2));
    let strip = if high == wide { wide } else { format!("{wide} × {high}") };
    format!(
        "Its outer {strip} hold {}. By itself that moves the area by {}.",
        held(share),
        signed_percent(share.direct_effect()),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;

    /// A strip of 32 of 80 points with three of four contacts: no sentence calls that its share.
    #[test]
    fn shares_are_said_as_counted() {
        let grid = Grid::new([8, 10], [1e-6; 2]).unwrap();
        let mut pressure = [0.0; 80];
        (pressure[0], pressure[3], pressure[39], pressure[45]) = (1.0, 1.0, 1.0, 9.0);
        let share = EdgeShare::of(&pressure, grid).unwrap();
        let said = held(&share).replace('\u{202F}', " ");
        let counted = "40 % of the map, 75 % of the touching points (1.9 times their share) and 25 % of the load (0.62 times its share)";
        assert!(said.contains(counted), "{said}");
    }
}
