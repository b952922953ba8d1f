//! Sentences that rank the closed forms: they say low and high, and name the number.

use crate::draw::svg::escape;
use crate::lines::{Reference, WANTED, references};
use crate::numbers::{PASCALS, SPACE, chosen, counted, duration, percent, signed_percent, times};
use crate::words::coarser;
use crate::words::finding::capital;
use crate::words::verdict::reason;
use compare::{
    Applies, DeterministicAnswer, DeterministicPoint, ModelComparison, ModelCurve,
    SurfaceComparison, elastic_holds,
};

/// A model within a sentence, its article small; escaped.
pub(crate) fn named(model: &ModelComparison) -> String {
    let title = &model.card.title;
    match title.strip_prefix("The ") {
        Some(rest) => format!("the {}", escape(rest)),
        None => escape(title),
    }
}

/// Said where the contact yields.
pub(crate) const NOT_RANKED: &str = " Theories of elastic bodies are compared with the elastic solution, and not ranked here: where the contact \
     yields they agree by accident at most.";

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
    let Some(ends) = answer.interval() else {
        return "The area of the solution carries no ±, so the closed forms cannot be ranked."
            .into();
    };
    let within = |r: &Ranked<'_>| holds(ends, answer.area_fraction_corrected * (1.0 + r.error));
    if !knows(answer, WANTED) {
        let (inside, outside): (Vec<_>, Vec<_>) = ranked.into_iter().partition(within);
        let told = |these: &[Ranked<'_>], what: &str| {
            let labels: Vec<String> = these.iter().map(|r| escape(&r.model.card.label)).collect();
            if labels.is_empty() { String::new() } else { format!(" {what}: {}.", list(&labels)) }
        };
        return format!(
            "The area is not known to 10{SPACE}%, so closed forms within its interval cannot be ranked.{}{}",
            told(&inside, "Within it"),
            told(&outside, "Outside it")
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
        && !within(r)
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

/// Whether an area is known to this share of it, as that of this map.
fn knows(answer: &DeterministicAnswer, share: f64) -> bool {
    answer.uncertainty().is_some_and(|u| u <= share * answer.area_fraction_corrected)
}

/// Whether a number lies between the ends of an interval.
fn holds([low, high]: [f64; 2], value: f64) -> bool {
    (low..=high).contains(&value)
}

/// The closed form nearest at the headline, where the area is known well enough to tell.
pub(crate) fn nearest(surface: &SurfaceComparison) -> Option<Ranked<'_>> {
    if is_known(surface) { ranked(surface).into_iter().next() } else { None }
}

/// Whether the area at the headline is known well enough to rank closed forms by it.
pub(crate) fn is_known(surface: &SurfaceComparison) -> bool {
    surface.headline_answer().is_some_and(|answer| knows(answer, WANTED))
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

/// From the errors of a model and the ends of the reference's own interval, both relative to the
/// reference: an error between them tells nothing, nor does what prints as 0.0 %.
fn against(loads: impl Iterator<Item = (f64, [f64; 2])>) -> Against {
    const NONE: f64 = 5e-4;
    let (mut low, mut high, mut told, mut same) = (false, false, true, true);
    for (error, ends) in loads {
        same &= error.abs() <= NONE;
        let is_outside = error.abs() > NONE && !holds(ends, error);
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

/// The errors of a model at the loads that have a reference, with the ends of its interval there,
/// relative to it: at the loads that have one, or, if `bare`, at all, without it.
fn told(
    points: &[DeterministicPoint],
    curve: &ModelCurve,
    bare: bool,
) -> impl Iterator<Item = (f64, [f64; 2])> {
    points.iter().zip(&curve.errors).filter_map(move |(point, error)| {
        let answer = point.answer.as_ref()?;
        let ends = if bare { [answer.area_fraction_corrected; 2] } else { answer.interval()? };
        Some(((*error)?, ends.map(|end| end / answer.area_fraction_corrected - 1.0)))
    })
}

/// Which models read low, high, or cross, over the loads, by the bodies they are about.
pub(crate) fn curves_lead(surface: &SurfaceComparison) -> String {
    let lead = |reference: &Reference<'_>| {
        let sentences = sides(reference);
        if reference.of.is_empty() || sentences.is_empty() {
            return sentences;
        }
        format!("<b>{}:</b> {sentences}", capital(reference.of))
    };
    let leads: Vec<String> = references(surface).iter().map(lead).collect();
    leads.iter().filter(|lead| !lead.is_empty()).cloned().collect::<Vec<_>>().join("<br>\n")
}

/// The same of the theories of one kind of bodies.
fn sides(reference: &Reference<'_>) -> String {
    let Reference { points, models, .. } = reference;
    let answers = || points.iter().filter_map(|p| p.answer.as_ref());
    let known = answers().filter(|a| a.uncertainty().is_some()).count();
    let bare = known == 0;
    let always = match points.len() {
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
    for (_, model) in models {
        let Ok(curve) = &model.outcome else { continue };
        if told(points, curve, bare).next().is_none() {
            continue;
        }
        let found = against(told(points, curve, bare));
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
    let is_known = |i: usize| loads[i].answer.as_ref().is_some_and(|a| knows(a, WANTED));
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
        format!("the {known} of {} at which it is known to that", counted(loads.len(), "load"))
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

    /// Errors, each with half the width of an even interval.
    fn of(loads: &[(f64, f64)]) -> Against {
        against(loads.iter().map(|&(error, half)| (error, [-half, half])))
    }

    fn side(loads: &[(f64, f64)]) -> Side {
        of(loads).side
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
        let faint = of(&[(-0.99, 1.5), (-0.8, 0.9)]);
        assert!(faint.side == Side::Agrees && !faint.told && !faint.same);
        let partly = of(&[(-0.99, 1.5), (-0.8, 0.1)]);
        assert!(partly.side == Side::Low && !partly.told);
        let clearly = of(&[(-0.3, 0.1), (-0.2, 0.1)]);
        assert!(clearly.side == Side::Low && clearly.told);
        let unknown = of(&[(-0.3, f64::INFINITY)]);
        assert!(unknown.side == Side::Agrees && !unknown.same);
    }
}
