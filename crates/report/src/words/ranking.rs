//! Sentences that rank the closed forms: they say low and high, and name the number.

use crate::draw::svg::escape;
use crate::lines::WANTED;
use crate::numbers::{PASCALS, SPACE, chosen, duration, percent, signed_percent, times};
use crate::words::coarser;
use crate::words::verdict::reason;
use compare::{Applies, ModelComparison, ModelCurve, SurfaceComparison, elastic_holds};

/// A model within a sentence, its article small; escaped.
pub(crate) fn named(model: &ModelComparison) -> String {
    let title = &model.card.title;
    match title.strip_prefix("The ") {
        Some(rest) => format!("the {}", escape(rest)),
        None => escape(title),
    }
}

/// Said where the contact yields.
pub(crate) const NOT_RANKED: &str = " Theories of elastic bodies are not ranked: where the contact yields they agree by accident at most.";

/// A closed form with its error at the headline load.
pub(crate) struct Ranked<'a> {
    /// The model.
    pub model: &'a ModelComparison,
    /// Its place among the models of the study.
    pub place: usize,
    /// Signed relative error at the headline load.
    pub error: f64,
    /// Seconds per load.
    pub seconds: f64,
}

/// The closed forms that answer at the headline load, nearest first; where the contact yields, those of
/// bodies that yield.
pub(crate) fn ranked(surface: &SurfaceComparison) -> Vec<Ranked<'_>> {
    let elastic = elastic_holds(surface);
    let mut list: Vec<Ranked<'_>> = surface
        .models
        .iter()
        .enumerate()
        .filter(|(_, model)| model.card.yields || elastic)
        .filter_map(|(place, model)| {
            let curve = model.outcome.as_ref().ok()?;
            let error = (*curve.errors.get(surface.headline)?)?;
            Some(Ranked { model, place, error, seconds: curve.seconds })
        })
        .collect();
    list.sort_by(|a, b| a.error.abs().total_cmp(&b.error.abs()));
    list
}

/// The second sentence: which closed form and which coarser grid, how wrong, how much faster.
pub(crate) fn recommendation(surface: &SurfaceComparison) -> String {
    let Some(answer) = surface.headline_answer() else { return String::new() };
    let relative = answer.uncertainty().map(|u| u / answer.area_fraction_corrected);
    let ranked = ranked(surface);
    let Some(nearest) = ranked.first() else {
        return if elastic_holds(surface) {
            "No closed form answers at this load.".into()
        } else {
            "No closed form of bodies that yield answers at this load.".into()
        };
    };
    let faster = |r: &Ranked<'_>| {
        let ratio = times(answer.seconds / r.seconds);
        format!("{ratio} times faster than this solution ({})", duration(answer.seconds))
    };
    if relative.is_none_or(|u| u > WANTED) {
        let why = match relative {
            Some(_) => format!("The ± itself exceeds 10{SPACE}%"),
            None => "The area of the solution carries no ±".into(),
        };
        return format!(
            "{why}, so the closed forms cannot be ranked at \
             10{SPACE}%. By the numbers alone {} is nearest ({}), {}, {}.",
            named(nearest.model),
            signed_percent(nearest.error),
            duration(nearest.seconds),
            faster(nearest)
        );
    }
    let mut text = String::new();
    let cheapest = ranked
        .iter()
        .filter(|r| r.error.abs() <= WANTED)
        .min_by(|a, b| a.seconds.total_cmp(&b.seconds));
    match cheapest {
        Some(r) => text.push_str(&format!(
            "Cheapest closed form within 10{SPACE}%: {} ({}), {}, {}.",
            named(r.model),
            signed_percent(r.error),
            duration(r.seconds),
            faster(r)
        )),
        None => text.push_str(&format!(
            "No closed form comes within 10{SPACE}% at this load. The nearest, {}, reads {} {} and \
             takes {}, {}.",
            named(nearest.model),
            percent(nearest.error),
            if nearest.error < 0.0 { "low" } else { "high" },
            duration(nearest.seconds),
            faster(nearest)
        )),
    }
    if let Some(r) = cheapest
        && nearest.model.card.name != r.model.card.name
    {
        text.push_str(&format!(
            " The nearest, {}, is {} off and takes {}.",
            named(nearest.model),
            percent(nearest.error),
            duration(nearest.seconds)
        ));
    }
    let best = cheapest.unwrap_or(nearest);
    if best.model.verdict.answer == Applies::Caution && best.model.verdict.at_every_load {
        text.push_str(&format!(
            " The domain of {} is strained here: {}.",
            named(best.model),
            reason(best.model).trim_end_matches('.')
        ));
    }
    if !elastic_holds(surface) {
        text.push_str(NOT_RANKED);
    }
    text.push_str(&coarser::sentence(surface, answer.seconds));
    text
}

/// "GW, BGT and Elliptical"
fn list(names: &[impl AsRef<str>]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => String::new(),
        [one] => (*one).into(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// Where a curve lies against the deterministic one.
#[derive(Debug, PartialEq, Eq)]
enum Side {
    Low,
    High,
    Crosses,
    /// Not told apart from it at any load.
    Agrees,
}

/// A curve against the deterministic one and its ± of this map.
struct Against {
    side: Side,
    /// Whether it lies outside the ± at every load.
    told: bool,
    /// Whether it is the same to what is printed, and not only within the ±.
    same: bool,
}

/// From the errors of a model and half the width of the reference's own ±, both relative to the
/// reference: an error within the ± tells nothing, nor does what prints as 0.0 %.
fn against(loads: impl Iterator<Item = (f64, f64)>) -> Against {
    const NONE: f64 = 5e-4;
    let (mut low, mut high, mut told, mut same) = (false, false, true, true);
    for (error, uncertainty) in loads {
        same &= error.abs() <= NONE;
        let is_outside = error.abs() > NONE.max(uncertainty);
        told &= is_outside;
        low |= is_outside && error < 0.0;
        high |= is_outside && error > 0.0;
    }
    let side = match (low, high) {
        (true, false) => Side::Low,
        (false, true) => Side::High,
        (true, true) => Side::Crosses,
        (false, false) => Side::Agrees,
    };
    Against { side, told, same }
}

/// The errors of a model at the loads that have a reference, with half the width of its ± there,
/// relative to it: at the loads that have one, or, if `bare`, at all, without it.
fn told(
    surface: &SurfaceComparison,
    curve: &ModelCurve,
    bare: bool,
) -> impl Iterator<Item = (f64, f64)> {
    surface.deterministic.iter().zip(&curve.errors).filter_map(move |(point, error)| {
        let answer = point.answer.as_ref()?;
        let uncertainty = if bare { 0.0 } else { answer.uncertainty()? };
        Some(((*error)?, uncertainty / answer.area_fraction_corrected))
    })
}

/// Which models read low, high, or cross, over the loads.
pub(crate) fn curves_lead(surface: &SurfaceComparison) -> String {
    let answers = || surface.deterministic.iter().filter_map(|p| p.answer.as_ref());
    let known = answers().filter(|a| a.uncertainty().is_some()).count();
    let bare = known == 0;
    let always = match surface.deterministic.len() {
        1 => "at this load",
        _ if !bare && known < answers().count() => "at every load that has a ±",
        _ => "at every load",
    };
    let tells = "where the ± of the solution tells them apart";
    // Each group with its sentence for one and for many.
    let mut groups = [
        (
            "predicts",
            "predict",
            format!("too little contact {always}, so too high a real pressure"),
        ),
        ("predicts", "predict", format!("too little contact {tells}, so too high a real pressure")),
        ("predicts", "predict", format!("too much {always}")),
        ("predicts", "predict", format!("too much {tells}")),
        ("crosses", "cross", "the deterministic curve".to_owned()),
        ("agrees", "agree", format!("with the deterministic area {always}")),
        ("lies", "lie", format!("within the ± of the deterministic area {always}")),
    ]
    .map(|sentence| (sentence, Vec::new()));
    for model in &surface.models {
        let Ok(curve) = &model.outcome else { continue };
        if told(surface, curve, bare).next().is_none() {
            continue;
        }
        let found = against(told(surface, curve, bare));
        let group = match found.side {
            Side::Low => usize::from(!found.told),
            Side::High => 2 + usize::from(!found.told),
            Side::Crosses => 4,
            Side::Agrees => 5 + usize::from(!found.same),
        };
        groups[group].1.push(escape(&model.card.label));
    }
    let sentences: Vec<String> = groups
        .iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|((one, many, rest), names)| {
            format!("{} {} {rest}.", list(names), if names.len() == 1 { one } else { many })
        })
        .collect();
    if bare && !sentences.is_empty() {
        return format!(
            "By the numbers alone, for the solution carries no ±: {}",
            sentences.join(" ")
        );
    }
    sentences.join(" ")
}

/// "Within 10 % of the deterministic area: Elliptical up to 4 MPa; GW from … to ….". Loads at which the
/// reference itself is not known to 10 % tell nothing and are said.
pub(crate) fn within_ten(surface: &SurfaceComparison) -> String {
    let loads = &surface.deterministic;
    let at = |i: usize| chosen(loads[i].mean_pressure, PASCALS);
    let is_known = |i: usize| {
        loads[i].answer.as_ref().is_some_and(|answer| {
            let uncertainty = answer.uncertainty().unwrap_or(f64::INFINITY);
            uncertainty <= WANTED * answer.area_fraction_corrected
        })
    };
    let known = (0..loads.len()).filter(|i| is_known(*i)).count();
    if known == 0 {
        return format!(
            "The area of the solution itself is not known to 10{SPACE}% at any of these loads: which \
             closed form is within that cannot be said."
        );
    }
    let mut parts = Vec::new();
    let elastic = elastic_holds(surface);
    for model in surface.models.iter().filter(|m| m.card.yields || elastic) {
        let Ok(curve) = &model.outcome else { continue };
        let mut spans: Vec<[usize; 2]> = Vec::new();
        for (i, error) in curve.errors.iter().enumerate() {
            if is_known(i) && error.is_some_and(|e| e.abs() <= WANTED) {
                match spans.last_mut() {
                    Some(span) if span[1] + 1 == i => span[1] = i,
                    _ => spans.push([i, i]),
                }
            }
        }
        if spans.is_empty() {
            continue;
        }
        let last = loads.len() - 1;
        let words: Vec<String> = spans
            .iter()
            .map(|&[a, b]| match (a, b) {
                (0, b) if b == last => "at every load".into(),
                (0, b) => format!("up to {}", at(b)),
                (a, b) if b == last => format!("from {}", at(a)),
                (a, b) if a == b => format!("at {}", at(a)),
                (a, b) => format!("{} to {}", at(a), at(b)),
            })
            .collect();
        parts.push(format!("{} {}", escape(&model.card.label), words.join(" and ")));
    }
    let these = if known == loads.len() {
        "these loads".to_owned()
    } else {
        format!("the {known} of {} loads at which it is known to that", loads.len())
    };
    if parts.is_empty() {
        format!("No closed form is within 10{SPACE}% of the deterministic area at any of {these}.")
    } else if known == loads.len() {
        format!("Within 10{SPACE}% of the deterministic area: {}.", parts.join("; "))
    } else {
        format!("Within 10{SPACE}% of the deterministic area, at {these}: {}.", parts.join("; "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_read_as_sentences() {
        assert_eq!(list(&["GW"]), "GW");
        assert_eq!(list(&["GW", "BGT", "Persson"]), "GW, BGT and Persson");
    }

    fn side(loads: &[(f64, f64)]) -> Side {
        against(loads.iter().copied()).side
    }

    #[test]
    fn a_curve_that_is_nowhere_off_does_not_cross() {
        assert_eq!(side(&[(-1e-5, 0.0), (2e-5, 0.0)]), Side::Agrees);
        assert_eq!(side(&[(0.0, 0.0)]), Side::Agrees);
        assert_eq!(side(&[(-0.2, 0.0), (1e-5, 0.0)]), Side::Low);
        assert_eq!(side(&[(-1e-5, 0.0), (0.2, 0.0)]), Side::High);
        assert_eq!(side(&[(-0.1, 0.0), (0.2, 0.0)]), Side::Crosses);
    }

    #[test]
    fn within_the_bar_of_the_reference_nothing_is_told() {
        let faint = against([(-0.99, 1.5), (-0.8, 0.9)].into_iter());
        assert!(faint.side == Side::Agrees && !faint.told && !faint.same);
        let partly = against([(-0.99, 1.5), (-0.8, 0.1)].into_iter());
        assert!(partly.side == Side::Low && !partly.told);
        let clearly = against([(-0.3, 0.1), (-0.2, 0.1)].into_iter());
        assert!(clearly.side == Side::Low && clearly.told);
        let unknown = against([(-0.3, f64::INFINITY)].into_iter());
        assert!(unknown.side == Side::Agrees && !unknown.same);
    }
}
