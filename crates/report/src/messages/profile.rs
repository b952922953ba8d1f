//! What is said of profiles.

use crate::numbers::{METRES, PASCALS, SPACE, chosen, percent, quantity, significant};
use contact_compare::{ProfileComparison, Unevenness};

pub(crate) fn coarser_class([ra, cutoff, length]: [f64; 3]) -> [String; 2] {
    let [ra, length] = [ra, length].map(|metres| quantity(metres, METRES, 3));
    [
        format!("Ra = {ra} asks for a longer cut-off than {}.", chosen(cutoff, METRES)),
        format!(
            "ISO 21920-3 measures such a surface over more than the {length} that were traced: the \
             roughness parameters are those of a part of its waves."
        ),
    ]
}

pub(crate) fn no_short([short, spacing]: [f64; 2]) -> [String; 2] {
    let (short, spacing) = (chosen(short, METRES), quantity(spacing, METRES, 3));
    [
        format!("λs = {short} was not applied."),
        format!(
            "ISO 21920-3 asks for points five times closer than that; these are {spacing} apart."
        ),
    ]
}

pub(crate) fn sample(
    traces: usize,
    length: f64,
    factors: [Option<f64>; 3],
    between: Option<[f64; 3]>,
) -> [String; 2] {
    let what = if traces == 1 { "One trace".to_owned() } else { format!("{traces} traces") };
    let each = |[m0, m2, m4]: [String; 3]| format!("m₀ {m0}, m₂ {m2}, m₄ {m4}.");
    let between = between.map_or_else(String::new, |between| {
        format!(" Standard deviation from trace to trace: {}", each(between.map(percent)))
    });
    [
        format!("{what} of {}: {}", quantity(length, METRES, 3), each(factors.map(spread))),
        format!(
            "Moments of other traces of this surface, equally long, scatter this far (95 %). \
             Waves longer than the trace are not in it.{between} The surface is taken to be isotropic: with a lay the \
             moments are those along the trace, and every model here is wrong by as much as the other direction \
             differs. Measure a second trace across the first, or a map."
        ),
    ]
}

/// "±12 %", "within a factor of 1.8", "not known".
pub(crate) fn spread(factor: Option<f64>) -> String {
    match factor {
        Some(factor) if factor < 1.3 => {
            format!("±{}{SPACE}%", significant(100.0 * (factor - 1.0), 2))
        }
        Some(factor) if factor < 100.0 => format!("within a factor of {}", significant(factor, 2)),
        _ => "not known".into(),
    }
}

pub(crate) fn unevenly(uneven: Unevenness) -> [String; 2] {
    let [short, long] = uneven.steps.map(|step| quantity(step, METRES, 3));
    let spacing = quantity(uneven.spacing, METRES, 3);
    [
        format!("The points are not evenly spaced: {short} to {long} apart."),
        format!(
            "They were put {spacing} apart on the straight lines between neighbours, as many over the same \
             length; slopes and curvatures of waves shorter than a few of the longest steps are lost."
        ),
    ]
}

/// "1.8", "0.62 to 0.91" as percentages.
pub(crate) fn area_range([low, high]: [f64; 2]) -> String {
    let [a, b] = [low, high].map(|x| significant(100.0 * x, 2));
    if a == b { format!("{a}{SPACE}%") } else { format!("{a} to {b}{SPACE}%") }
}

/// What the models say together, in a sentence: plain text.
pub fn profile_headline(study: &ProfileComparison) -> String {
    let p = chosen(study.pressures[study.headline], PASCALS);
    match study.span(study.headline) {
        Some((span, count)) => format!(
            "At {p}, {} of the surface touches, if it is isotropic: the span of {count} models with \
             what the length of the {} leaves open.",
            area_range(span),
            if study.statistics.traces == 1 { "trace" } else { "traces" }
        ),
        None => format!(
            "At {p} no model that follows from the moments has an interval: these traces hold too few \
             waves, or the theories refuse them."
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spreads_are_percentages_until_they_are_factors() {
        let plain = |f| spread(f).replace(SPACE, " ");
        assert_eq!(plain(Some(1.084)), "±8.4 %");
        assert_eq!(plain(Some(1.8)), "within a factor of 1.8");
        assert_eq!(plain(None), "not known");
        assert_eq!(area_range([0.0123, 0.0171]).replace(SPACE, " "), "1.2 to 1.7 %");
    }
}
