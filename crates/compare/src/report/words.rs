//! Sentences of the report. They state what was computed, say low and high, and name the number.

use super::coarser;
use super::numbers::{
    PASCALS, SPACE, chosen, duration, percent, plus_minus, quantity, quantity_plus_minus,
    signed_percent, significant, times,
};
use super::svg::escape;
use crate::result::{Applies, DeterministicAnswer, ModelComparison, ModelCurve, SurfaceComparison};
use crate::survey::FEWEST;

/// Error within which a closed form counts as an answer.
pub(super) const WANTED: f64 = 0.10;

/// "1.96 ± 0.12 %", or "1.96 %" where there is no bar.
pub(super) fn area(answer: &DeterministicAnswer) -> String {
    let area = 100.0 * answer.area_fraction_corrected;
    let number = match answer.uncertainty() {
        Some(u) if u > 0.0 => plus_minus(area, 100.0 * u),
        _ => significant(area, 3),
    };
    format!("{number}{SPACE}%")
}

/// Mean real pressure with the uncertainty it inherits from the area.
pub(super) fn real_pressure(mean_pressure: f64, answer: &DeterministicAnswer) -> String {
    let area = answer.area_fraction_corrected;
    if area <= 0.0 {
        return "–".into();
    }
    let value = mean_pressure / area;
    match answer.uncertainty() {
        Some(u) if u > 0.0 => quantity_plus_minus(value, value * u / area, PASCALS),
        _ => quantity(value, PASCALS, 3),
    }
}

/// "1.96 ± 0.25 %": with the finite sample on top, where this map can tell.
pub(super) fn area_prediction(answer: &DeterministicAnswer) -> String {
    let Some(half) = answer.budget.area.prediction_half_width() else { return area(answer) };
    let value = 100.0 * answer.area_fraction_corrected;
    format!("{}{SPACE}%", plus_minus(value, 100.0 * half))
}

/// Mean real pressure with the finite sample on top. Its ± is that of the area, to first order.
pub(super) fn real_pressure_prediction(answer: &DeterministicAnswer) -> String {
    let budget = &answer.budget;
    match (budget.real_pressure(), budget.area.prediction_half_width()) {
        (Some(real), Some(half)) => {
            let spread = real.value() * half / budget.area.value;
            quantity_plus_minus(real.value(), spread, PASCALS)
        }
        _ => real_pressure(budget.mean_pressure.value, answer),
    }
}

/// The upper end of the area where its grid and iteration leave no lower one: all that is known.
fn at_most(answer: &DeterministicAnswer) -> Option<f64> {
    let [low, high] = answer.interval()?;
    (low <= 0.0).then(|| answer.budget.area.prediction().map_or(high, |[_, high]| high))
}

/// The first sentence, as HTML.
pub(super) fn headline(surface: &SurfaceComparison) -> String {
    let p = chosen(surface.headline_pressure(), PASCALS);
    let point = surface.deterministic.get(surface.headline);
    let Some(answer) = surface.headline_answer() else {
        let why = point.and_then(|p| p.trouble.clone()).unwrap_or_default();
        return format!("At {p} there is no deterministic answer: {}", escape(&why));
    };
    if answer.contact_pixels == 0 {
        return format!("At {p} nothing touches.");
    }
    if let Some(most) = at_most(answer) {
        return format!(
            "At {p}, at most <b>{}{SPACE}%</b> of the surface touches, and the mean real pressure is \
             at least <b>{}</b>: this map does not resolve its contacts.",
            significant(100.0 * most, 2),
            quantity(surface.headline_pressure() / most, PASCALS, 2)
        );
    }
    let opening = if answer.converged { "" } else { "Not converged: " };
    let about = if answer.uncertainty().is_some() { "" } else { "about " };
    format!(
        "{opening}{}t {p}, {about}<b>{}</b> of the surface touches; the mean real pressure is \
         {about}<b>{}</b>.",
        if opening.is_empty() { 'A' } else { 'a' },
        area_prediction(answer),
        real_pressure_prediction(answer)
    )
}

/// A closed form with its error at the headline load.
pub(super) struct Ranked<'a> {
    /// The model.
    pub model: &'a ModelComparison,
    /// Signed relative error at the headline load.
    pub error: f64,
    /// Seconds per load.
    pub seconds: f64,
}

/// The closed forms that answer at the headline load, nearest first.
pub(super) fn ranked(surface: &SurfaceComparison) -> Vec<Ranked<'_>> {
    let mut list: Vec<Ranked<'_>> = surface
        .models
        .iter()
        .filter_map(|model| {
            let curve = model.outcome.as_ref().ok()?;
            let error = (*curve.errors.get(surface.headline)?)?;
            Some(Ranked { model, error, seconds: curve.seconds })
        })
        .collect();
    list.sort_by(|a, b| a.error.abs().total_cmp(&b.error.abs()));
    list
}

/// The second sentence: which closed form and which coarser grid, how wrong, how much faster.
pub(super) fn recommendation(surface: &SurfaceComparison) -> String {
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
            nearest.model.entry.title,
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
            r.model.entry.title,
            signed_percent(r.error),
            duration(r.seconds),
            faster(r)
        )),
        None => text.push_str(&format!(
            "No closed form comes within 10{SPACE}% at this load. The nearest, {}, reads {} {} and \
             takes {}, {}.",
            nearest.model.entry.title,
            percent(nearest.error),
            if nearest.error < 0.0 { "low" } else { "high" },
            duration(nearest.seconds),
            faster(nearest)
        )),
    }
    if let Some(r) = cheapest
        && nearest.model.entry.name != r.model.entry.name
    {
        text.push_str(&format!(
            " The nearest, {}, is {} off and takes {}.",
            nearest.model.entry.title,
            percent(nearest.error),
            duration(nearest.seconds)
        ));
    }
    let best = cheapest.unwrap_or(nearest);
    if best.model.verdict.answer == Applies::Caution && best.model.verdict.at_every_load {
        text.push_str(&format!(
            " Its domain is strained here: {}.",
            best.model.verdict.reason.trim_end_matches('.')
        ));
    }
    text.push_str(&coarser::sentence(surface, answer.seconds));
    text
}

/// "GW, BGT and Elliptical"
fn list(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).into(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Which models read low, high, or cross, over the loads.
pub(super) fn curves_lead(surface: &SurfaceComparison) -> String {
    let (mut low, mut high, mut cross) = (Vec::new(), Vec::new(), Vec::new());
    for model in &surface.models {
        let Some((lo, hi)) = model.outcome.as_ref().ok().and_then(ModelCurve::range) else {
            continue;
        };
        let label = model.entry.label;
        match (lo < 0.0, hi > 0.0) {
            (true, false) => low.push(label),
            (false, true) => high.push(label),
            _ => cross.push(label),
        }
    }
    let always = if surface.deterministic.len() > 1 { "at every load" } else { "at this load" };
    let verb = |names: &[&str], one: &str, many: &str| {
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
    parts.join(" ")
}

/// "Within 10 % of the deterministic area: Elliptical up to 4 MPa; GW from … to ….".
pub(super) fn within_ten(surface: &SurfaceComparison) -> String {
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
        parts.push(format!("{} {}", model.entry.label, words.join(" and ")));
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
pub(super) fn survey(surface: &SurfaceComparison) -> String {
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

/// Date of a Unix time (s) as "21 November 2026" in UTC: days to civil date after Hinnant.
pub(super) fn date(unix: u64) -> String {
    const MONTHS: [&str; 12] = [
        "January",
        "February",
        "March",
        "April",
        "May",
        "June",
        "July",
        "August",
        "September",
        "October",
        "November",
        "December",
    ];
    let z = unix / 86_400 + 719_468;
    let (era, day_of_era) = (z / 146_097, z % 146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + u64::from(month <= 2);
    format!("{day} {} {year}", MONTHS[(month - 1) as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates() {
        assert_eq!(date(0), "1 January 1970");
        assert_eq!(date(951_782_400), "29 February 2000");
        assert_eq!(date(1_795_219_200), "21 November 2026");
    }

    #[test]
    fn lists_read_as_sentences() {
        assert_eq!(list(&["GW"]), "GW");
        assert_eq!(list(&["GW", "BGT", "Persson"]), "GW, BGT and Persson");
    }
}
