//! Sentences that rank the closed forms: they say low and high, and name the number.

use crate::draw::svg::escape;
use crate::lines::WANTED;
use crate::numbers::{PASCALS, SPACE, chosen, duration, percent, signed_percent, times};
use crate::words::coarser;
use crate::words::verdict::reason;
use compare::survey::FEWEST;
use compare::{Applies, ModelComparison, ModelCurve, SurfaceComparison};

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

/// The closed forms that answer at the headline load, nearest first.
pub(crate) fn ranked(surface: &SurfaceComparison) -> Vec<Ranked<'_>> {
    let mut list: Vec<Ranked<'_>> = surface
        .models
        .iter()
        .enumerate()
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
        return "No closed form answers at this load.".into();
    };
    let faster = |r: &Ranked<'_>| {
        let ratio = times(answer.seconds / r.seconds);
        format!("{ratio} times faster than this solution ({})", duration(answer.seconds))
    };
    if relative.is_some_and(|u| u > WANTED) {
        return format!(
            "The ± itself exceeds 10{SPACE}%, so the closed forms cannot be ranked at \
             10{SPACE}%. By the numbers alone {} is nearest ({}), {}, {}.",
            escape(&nearest.model.card.title),
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
            escape(&r.model.card.title),
            signed_percent(r.error),
            duration(r.seconds),
            faster(r)
        )),
        None => text.push_str(&format!(
            "No closed form comes within 10{SPACE}% at this load. The nearest, {}, reads {} {} and \
             takes {}, {}.",
            escape(&nearest.model.card.title),
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
            escape(&nearest.model.card.title),
            percent(nearest.error),
            duration(nearest.seconds)
        ));
    }
    let best = cheapest.unwrap_or(nearest);
    if best.model.verdict.answer == Applies::Caution && best.model.verdict.at_every_load {
        text.push_str(&format!(
            " The domain of {} is strained here: {}.",
            escape(&best.model.card.title),
            reason(best.model).trim_end_matches('.')
        ));
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
    Agrees,
}

impl Side {
    /// From the smallest and the largest signed error. What prints as 0.0 % is no difference.
    fn of(lo: f64, hi: f64) -> Self {
        const NONE: f64 = 5e-4;
        match (lo < -NONE, hi > NONE) {
            (true, false) => Self::Low,
            (false, true) => Self::High,
            (true, true) => Self::Crosses,
            (false, false) => Self::Agrees,
        }
    }
}

/// Which models read low, high, or cross, over the loads.
pub(crate) fn curves_lead(surface: &SurfaceComparison) -> String {
    let (mut low, mut high, mut cross) = (Vec::new(), Vec::new(), Vec::new());
    let mut agree = Vec::new();
    for model in &surface.models {
        let Some((lo, hi)) = model.outcome.as_ref().ok().and_then(ModelCurve::range) else {
            continue;
        };
        let label = escape(&model.card.label);
        match Side::of(lo, hi) {
            Side::Low => low.push(label),
            Side::High => high.push(label),
            Side::Crosses => cross.push(label),
            Side::Agrees => agree.push(label),
        }
    }
    let always = if surface.deterministic.len() > 1 { "at every load" } else { "at this load" };
    let verb = |names: &[String], one: &str, many: &str| {
        if names.len() == 1 { one.to_owned() } else { many.to_owned() }
    };
    let mut parts = Vec::new();
    if !low.is_empty() {
        parts.push(format!(
            "{} {} too little contact {always}, so too high a real pressure.",
            list(&low),
            verb(&low, "predicts", "predict")
        ));
    }
    if !high.is_empty() {
        parts.push(format!(
            "{} {} too much {always}.",
            list(&high),
            verb(&high, "predicts", "predict")
        ));
    }
    if !cross.is_empty() {
        parts.push(format!(
            "{} {} the deterministic curve.",
            list(&cross),
            verb(&cross, "crosses", "cross")
        ));
    }
    if !agree.is_empty() {
        parts.push(format!(
            "{} {} with the deterministic area {always}.",
            list(&agree),
            verb(&agree, "agrees", "agree")
        ));
    }
    parts.join(" ")
}

/// "Within 10 % of the deterministic area: Elliptical up to 4 MPa; GW from … to ….".
pub(crate) fn within_ten(surface: &SurfaceComparison) -> String {
    let loads = &surface.deterministic;
    let at = |i: usize| chosen(loads[i].mean_pressure, PASCALS);
    let mut parts = Vec::new();
    for model in &surface.models {
        let Ok(curve) = &model.outcome else { continue };
        let mut spans: Vec<[usize; 2]> = Vec::new();
        for (i, error) in curve.errors.iter().enumerate() {
            if error.is_some_and(|e| e.abs() <= WANTED) {
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
    if parts.is_empty() {
        format!(
            "No closed form is within 10{SPACE}% of the deterministic area at any of these loads."
        )
    } else {
        format!("Within 10{SPACE}% of the deterministic area: {}.", parts.join("; "))
    }
}

/// What "surfaces like this" means below the model table, or that the survey has none.
pub(crate) fn survey(surface: &SurfaceComparison) -> String {
    let load = chosen(surface.headline_pressure(), PASCALS);
    if surface.models.iter().any(|m| m.experience.is_some()) {
        format!(
            "Surfaces like this: those of a survey of 240 with similar bandwidth, resolution, \
             heights and slopes at a load like {load}; their whole range of errors is quoted."
        )
    } else if surface.headline_answer().is_some() {
        format!(
            "A survey of 240 surfaces has fewer than {FEWEST} like this one at a load like {load}."
        )
    } else {
        String::new()
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

    #[test]
    fn a_curve_that_is_nowhere_off_does_not_cross() {
        assert_eq!(Side::of(-1e-5, 2e-5), Side::Agrees);
        assert_eq!(Side::of(0.0, 0.0), Side::Agrees);
        assert_eq!(Side::of(-0.2, 1e-5), Side::Low);
        assert_eq!(Side::of(-1e-5, 0.2), Side::High);
        assert_eq!(Side::of(-0.1, 0.2), Side::Crosses);
    }
}
