//! Sentences on the deterministic answer. They state what was computed and name the number.

use crate::draw::svg::escape;
use crate::numbers::{
    PASCALS, SPACE, chosen, quantity, quantity_plus_minus, rounded_down, significant, with_bar,
};
use crate::words::yielding;
use compare::{DeterministicAnswer, SurfaceComparison};

/// "1.96 ± 0.12 %", "at most 2.1 %" where the interval begins at zero, or "1.96 %" without one.
pub(crate) fn area(answer: &DeterministicAnswer) -> String {
    percent_with(answer.area_fraction_corrected, answer.uncertainty())
}

/// "1.96 ± 0.25 %": with the sampling variability, where this map can tell.
pub(crate) fn area_prediction(answer: &DeterministicAnswer) -> String {
    let half = answer.budget.area.prediction_half_width().or_else(|| answer.uncertainty());
    percent_with(answer.area_fraction_corrected, half)
}

fn percent_with(fraction: f64, half: Option<f64>) -> String {
    let number = match half {
        // No more than all of it can touch.
        Some(half) if half >= fraction && fraction + half > 1.0 => {
            return format!("at most 100{SPACE}%");
        }
        Some(half) if half > 0.0 => with_bar(100.0 * fraction, 100.0 * half),
        _ => significant(100.0 * fraction, 3),
    };
    format!("{number}{SPACE}%")
}

/// Mean real pressure with the uncertainty it inherits from the area.
pub(crate) fn real_pressure(mean_pressure: f64, answer: &DeterministicAnswer) -> String {
    real_pressure_of(mean_pressure, answer.area_fraction_corrected, answer.uncertainty())
}

/// Mean real pressure with the sampling variability, where this map can tell.
pub(crate) fn real_pressure_prediction(answer: &DeterministicAnswer) -> String {
    let half = answer.budget.area.prediction_half_width().or_else(|| answer.uncertainty());
    let load = answer.budget.mean_pressure.value;
    real_pressure_of(load, answer.area_fraction_corrected, half)
}

/// Load over area. Its ± is that of the area, to first order; where the area has no lower end, the
/// pressure has no upper one.
fn real_pressure_of(load: f64, area: f64, half: Option<f64>) -> String {
    match half {
        Some(half) if half >= area && area + half > 0.0 => {
            format!("at least {}", quantity(rounded_down(load / (area + half)), PASCALS, 2))
        }
        _ if area <= 0.0 => "–".into(),
        Some(half) if half > 0.0 => {
            quantity_plus_minus(load / area, load / area * half / area, PASCALS)
        }
        _ => quantity(load / area, PASCALS, 3),
    }
}

/// What the ± of [`area_prediction`] covers; empty if there is none.
pub(crate) fn covers(answer: &DeterministicAnswer) -> &'static str {
    let area = &answer.budget.area;
    match (answer.uncertainty(), area.sampling, area.materials > 0.0) {
        (None, ..) => "",
        (Some(_), Some(_), true) => "± with sampling variability and materials",
        (Some(_), Some(_), false) => "± with sampling variability",
        (Some(_), None, true) => "± with materials",
        (Some(_), None, false) => COMPARISON,
    }
}

/// What the ± of an area covers that is compared with models of the same map.
pub(crate) const COMPARISON: &str = "± of this map";

/// The highest pressure of a point, and what it means. A mean over the contact cannot exceed it:
/// where it seems to, the contacts are smaller than the points.
pub(crate) fn highest_pressure(highest: f64, load: f64, area: f64) -> (String, &'static str) {
    if area > 0.0 && load / area > highest {
        return (
            format!("above {}", quantity(load / area, PASCALS, 2)),
            "not below the mean; no point of the map resolves it",
        );
    }
    (quantity(highest, PASCALS, 2), "one point of the map; grows with a finer grid")
}

/// The headline of a surface in plain text, for the terminal: the numbers of the page.
pub fn headline_line(surface: &SurfaceComparison) -> Option<String> {
    let answer = surface.headline_answer()?;
    let label = match covers(answer) {
        "" => String::new(),
        covers => format!(" ({covers})"),
    };
    let p = chosen(surface.headline_pressure(), PASCALS);
    let share = yielding::share(surface).replace("<b>", "").replace("</b>", "");
    let line = format!("at {p} {} of the area touches{share}{label}", area_prediction(answer));
    Some(line.replace(SPACE, " "))
}

/// How a sentence on an answer begins that is not to tolerance.
fn opening(converged: bool, stopped_at_rounding: bool) -> &'static str {
    match (converged, stopped_at_rounding) {
        (true, _) => "",
        (false, true) => "Stopped at rounding: ",
        (false, false) => "Not converged: ",
    }
}

/// The first sentence, as HTML.
pub(crate) fn headline(surface: &SurfaceComparison) -> String {
    let p = chosen(surface.headline_pressure(), PASCALS);
    let point = surface.deterministic.get(surface.headline);
    let Some(answer) = surface.headline_answer() else {
        let why = point.and_then(|p| p.trouble.clone()).unwrap_or_default();
        return format!("At {p} there is no deterministic answer: {}", escape(&why));
    };
    if answer.contact_pixels == 0 {
        return format!("At {p} nothing touches.");
    }
    let opening = opening(answer.converged, answer.stopped_at_rounding);
    let about = if answer.uncertainty().is_some() { "" } else { "about " };
    let unresolved = if answer.interval().is_some_and(|[low, _]| low <= 0.0) {
        ": this map does not resolve its contacts"
    } else {
        ""
    };
    let label = match covers(answer) {
        "" => String::new(),
        covers => format!(" <small>({covers})</small>"),
    };
    let whole = if surface.origin.pair().is_some() { "the area in common" } else { "the surface" };
    format!(
        "{opening}{}t {p}, {about}<b>{}</b> of {whole} touches{}; the mean real pressure is \
         {about}<b>{}</b>{unresolved}.{label}",
        if opening.is_empty() { 'A' } else { 'a' },
        area_prediction(answer),
        yielding::share(surface),
        real_pressure_prediction(answer)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_without_a_lower_end_has_no_bar_on_both_sides() {
        assert_eq!(percent_with(0.0031, Some(0.0048)), "at most 0.79\u{202F}%");
        assert_eq!(percent_with(0.0196, Some(0.0012)), "1.96 ± 0.12\u{202F}%");
        assert_eq!(percent_with(0.0196, None), "1.96\u{202F}%");
        assert_eq!(real_pressure_of(1e6, 0.0031, Some(0.0048)), "at least 120\u{202F}MPa");
        assert_eq!(real_pressure_of(1e6, 0.0, None), "–");
    }

    #[test]
    fn rounding_is_not_convergence() {
        assert_eq!(opening(true, false), "");
        assert_eq!(opening(false, true), "Stopped at rounding: ");
        assert_eq!(opening(false, false), "Not converged: ");
    }

    #[test]
    fn the_highest_pressure_is_never_below_the_mean() {
        assert_eq!(highest_pressure(100e6, 100.0, 100.0 / 190e6).0, "above 190\u{202F}MPa");
        assert_eq!(highest_pressure(400e6, 100.0, 100.0 / 190e6).0, "400\u{202F}MPa");
    }
}
