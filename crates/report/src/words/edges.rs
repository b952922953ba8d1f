//! What lay beyond the edges of a measured map, and how much it matters on this map.

use crate::numbers::{METRES, percent, quantity, signed_percent, signed_range, significant};
use crate::words::note::{Note, Weight};
use compare::SurfaceComparison;
use compare::{EdgeShare, EdgesName, Origin};
use contact_accuracy::edge_study::EdgeStudy;
use surface_stats::Warning;

/// Error of the area from which the edges may change a conclusion.
const MATTERS: f64 = 0.05;

/// What the edges do to the area at the headline.
struct Finding {
    words: String,
    /// Largest size of the error to expect.
    worst: f64,
}

/// A measured map whose edges do not match: that, what was done, and how much it matters.
pub(crate) fn edge_note(surface: &SurfaceComparison) -> Option<Note> {
    let jump = surface.statistics.warnings.iter().find_map(|w| match w {
        Warning::EdgeJump { ratio } => Some(*ratio),
        _ => None,
    })?;
    let finding = finding(surface);
    let matters = finding.as_ref().is_some_and(|f| f.worst > MATTERS);
    let words = finding.map_or(String::new(), |f| format!(" {}", f.words));
    let done = match surface.edges {
        EdgesName::Periodic => {
            "The map was repeated as it is, jump included; --edges mirrored takes the jump out."
        }
        EdgesName::Mirrored => {
            "The map was continued by its mirror images, which leave a kink and no jump."
        }
    };
    Some(Note {
        weight: if matters { Weight::Check } else { Weight::Note },
        claim: format!(
            "Edges do not match: they jump {} times the inner step.",
            significant(jump, 2)
        ),
        text: format!("{done}{words}"),
    })
}

/// For "How this was made": the treatment of the edges, and for a measured map its effect.
pub(crate) fn edge_words(surface: &SurfaceComparison) -> String {
    let done = match (surface.edges, &surface.origin) {
        (EdgesName::Mirrored, _) => "Continued by its mirror images.",
        (EdgesName::Periodic, Origin::Recipe(_)) => return "Periodic, as made.".to_owned(),
        (EdgesName::Periodic, Origin::Given(given)) if given.repeats == Some(true) => {
            return "Periodic, as given.".to_owned();
        }
        (EdgesName::Periodic, Origin::File(_) | Origin::Given(_)) => {
            "Repeated periodically as it is."
        }
    };
    finding(surface).map_or(done.to_owned(), |f| format!("{done} {}", f.words))
}

fn finding(surface: &SurfaceComparison) -> Option<Finding> {
    let grid = surface.solved_map().grid();
    let share = EdgeShare::of(&surface.pressure, grid)?;
    let direct = share.direct_effect();
    let [dy, dx] = grid.pixel();
    let [high, wide] = [dy, dx].map(|d| quantity(share.width as f64 * d, METRES, 2));
    let strip = if high == wide { wide } else { format!("{wide} × {high}") };
    let verdict = if share.attraction() > 1.25 {
        "more than their share"
    } else {
        "no more than their share: the seam does not attract contact"
    };
    let gradient = surface.inputs.rms_gradient();
    let load = surface.headline_pressure() / (surface.inputs.modulus.pascals() * gradient);
    // The rows of the study are those of crops that were repeated.
    let is_repeated = surface.edges == EdgesName::Periodic;
    let seen = is_repeated.then(|| EdgeStudy::built_in().ask(load, direct)).flatten();
    let experience = match seen {
        Some(e) => format!(
            " On {} crops of larger surfaces with a like strip, the area differed by {} from that \
             in natural surroundings (nine of ten).",
            e.crops,
            signed_range(e.low, e.high)
        ),
        None if is_repeated => {
            " The study of edges has too few maps like it to say what follows.".to_owned()
        }
        None => String::new(),
    };
    let worst = seen.map_or(direct.abs(), |e| e.low.abs().max(e.high.abs()));
    Some(Finding {
        words: format!(
            "Its outer {strip} hold {} of the map, {} of the touching points and {} of the load, \
             {verdict}. By itself that moves the area by {}.{experience}",
            percent(share.map),
            percent(share.contact),
            percent(share.load),
            signed_percent(direct),
        ),
        worst,
    })
}
