//! What lay beyond the edges of a measured map, and how much it matters on this map.

use crate::numbers::signed_percent;
use contact_compare::{EdgesName, Origin, Seam, SurfaceComparison, seam};
use surface_stats::Edges;

/// The treatment of the edges.
fn treatment(surface: &SurfaceComparison) -> &'static str {
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

/// The treatment, and for a map whose edges were made up its effect.
pub(crate) fn edge_words(surface: &SurfaceComparison) -> String {
    let done = treatment(surface);
    if done.starts_with("Periodic") {
        return done.to_owned();
    }
    seam(surface).map_or(done.to_owned(), |s| format!("{done} {}", seam_effect(&s)))
}

/// What the strip along the edges does to the area, in one sentence.
pub(crate) fn seam_effect(seam: &Seam) -> String {
    format!(
        "The strip along the edges moves the area by {}.",
        signed_percent(seam.share.direct_effect())
    )
}
