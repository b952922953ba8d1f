//! Sentences on bodies that yield: claim and text.

use crate::numbers::{PASCALS, SPACE, chosen, percent, quantity, signed_percent};
use contact_compare::{BULK_YIELD, SurfaceComparison, Yielding, elastic_limit, typical_hardness};

/// What a pressure that is held to a hardness leaves out.
pub(crate) const LEFT_OUT: &str =
    "One hardness at every scale; nothing hardens or piles up; loading only.";

/// Of the headline.
pub(crate) fn headline(found: &Yielding, hardness: f64) -> [String; 2] {
    let share = percent(found.share);
    let elastic = found.elastic_area.filter(|a| *a > 0.0).map_or_else(String::new, |elastic| {
        let more = signed_percent(elastic / found.area - 1.0);
        format!(" Elastic bodies would touch on {} ({more}).", percent(elastic))
    });
    let (load, load_share) = (chosen(found.load, PASCALS), percent(found.load_share));
    let hardness = quantity(hardness, PASCALS, 3);
    [
        format!("The contact yields: {share} of it is at the hardness of {hardness}."),
        format!("At {load} that part carries {load_share} of the load.{elastic} {LEFT_OUT}"),
    ]
}

/// Of a hardness that no solid of this modulus has.
pub(crate) fn odd(given: [f64; 3]) -> [String; 2] {
    let [hardness, low, high] = given.map(|p| quantity(p, PASCALS, 2));
    [
        "Is the unit of the hardness right?".into(),
        format!("It is {hardness}; solids with this contact modulus have about {low} to {high}."),
    ]
}

/// Of loads at which the body yields in its volume.
pub(crate) fn bulk(highest: f64, hardness: f64) -> [String; 2] {
    [
        format!("Loads reach {} of the hardness.", percent(highest / hardness)),
        format!(
            "Beyond about {} the body yields in its volume and not only where it touches; that is not \
             modelled.",
            percent(BULK_YIELD)
        ),
    ]
}

/// For which bodies the elastic area holds; `None` where a hardness was given, or has no meaning.
pub(crate) fn elastic_line(surface: &SurfaceComparison) -> Option<String> {
    let limit = quantity(elastic_limit(surface)?, PASCALS, 2).replace(SPACE, " ");
    Some(format!(
        "elastic area right to 2 % for a hardness of {limit} or more (E* h′rms); softer bodies need their hardness"
    ))
}

/// " if it stays elastic, 2.2 % or more if it yields at 460 MPa, as soft solids of this modulus do": no hardness was given,
/// and the elastic pressure is more than some of them bear. Empty where it is not.
pub(crate) fn or_yielded(surface: &SurfaceComparison) -> String {
    let Some(answer) = surface.headline_answer() else { return String::new() };
    let modulus = surface.inputs.modulus.pascals();
    let soft = typical_hardness(modulus).filter(|_| surface.inputs.hardness.is_none());
    // Where all of a contact has yielded, its area is the load over the hardness, and no less where a part has.
    let yielded = soft.map(|[soft, _]| (soft, (surface.headline_pressure() / soft).min(1.0)));
    let yielded = yielded.filter(|(_, area)| *area > answer.area_fraction);
    yielded.map_or_else(String::new, |(soft, area)| {
        let (area, soft) = (percent(area), quantity(soft, PASCALS, 2));
        format!(
            " if it stays elastic, <b>{area}</b> or more if it yields at {soft}, as soft solids of this modulus do"
        )
    })
}

/// ", 43 % of that at the hardness"; empty where nothing is.
pub(crate) fn share(surface: &SurfaceComparison) -> String {
    let share = surface.headline_answer().and_then(|a| {
        let yielded = a.diagnostics.yielded?.area_fraction;
        (yielded > 0.0).then(|| (yielded / a.touching_fraction).min(1.0))
    });
    share.map_or_else(String::new, |share| {
        format!(", <b>{}</b> of that at the hardness", percent(share))
    })
}
