//! Sentences on the deterministic answer. They state what was computed and name the number.

use crate::draw::svg::escape;
use crate::numbers::{
    PASCALS, SPACE, chosen, plus_minus, quantity, quantity_plus_minus, significant,
};
use compare::{DeterministicAnswer, SurfaceComparison};

/// "1.96 ± 0.12 %", or "1.96 %" where there is no bar.
pub(crate) fn area(answer: &DeterministicAnswer) -> String {
    let area = 100.0 * answer.area_fraction_corrected;
    let number = match answer.uncertainty() {
        Some(u) if u > 0.0 => plus_minus(area, 100.0 * u),
        _ => significant(area, 3),
    };
    format!("{number}{SPACE}%")
}

/// Mean real pressure with the uncertainty it inherits from the area.
pub(crate) fn real_pressure(mean_pressure: f64, answer: &DeterministicAnswer) -> String {
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
pub(crate) fn area_prediction(answer: &DeterministicAnswer) -> String {
    let Some(half) = answer.budget.area.prediction_half_width() else { return area(answer) };
    let value = 100.0 * answer.area_fraction_corrected;
    format!("{}{SPACE}%", plus_minus(value, 100.0 * half))
}

/// Mean real pressure with the finite sample on top. Its ± is that of the area, to first order.
pub(crate) fn real_pressure_prediction(answer: &DeterministicAnswer) -> String {
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
