//! Sentences on the deterministic answer. They state what was computed and name the number.

use crate::draw::svg::escape;
use crate::messages::conduction::resistance_lines;
use crate::messages::yielding;
use crate::numbers::{PASCALS, SPACE, percent_within, quantity_within};
use contact_compare::{DeterministicAnswer, End, SurfaceComparison};

/// "1.96 ± 0.25 %", "at most 2.1 %" where the interval begins at zero, or "1.96 %" without one: of grid, iteration
/// and, where this map can tell, sampling variability.
pub(crate) fn area(answer: &DeterministicAnswer) -> String {
    percent_within(answer.area_fraction, answer.budget.area.stated())
}

/// Mean real pressure, load over area, between the ends of that.
pub(crate) fn real_pressure(answer: &DeterministicAnswer) -> String {
    answer.budget.real_pressure().map_or("–".into(), |real| {
        quantity_within(real.value, real.prediction.or(real.interval), PASCALS)
    })
}

/// What the ± of [`area`] covers; empty if there is none.
pub(crate) fn covers(answer: &DeterministicAnswer) -> &'static str {
    let area = &answer.budget.area;
    match (area.half_width().ok(), area.sampling, area.materials > 0.0) {
        (None, ..) => "",
        (Some(_), Some(_), true) => "± with sampling variability and materials",
        (Some(_), Some(_), false) => "± with sampling variability",
        (Some(_), None, true) => "± with materials",
        (Some(_), None, false) => "± of this map",
    }
}

/// The headline of a surface in plain text, for the terminal: the numbers of the page.
pub fn headline_line(surface: &SurfaceComparison) -> Option<String> {
    let answer = surface.headline_answer()?;
    let label = match covers(answer) {
        "" => String::new(),
        covers => format!(" ({covers})"),
    };
    let p = super::headline_load(surface);
    let share = yielding::share(surface) + &yielding::or_yielded(surface);
    let share = share.replace("<b>", "").replace("</b>", "");
    let line = format!("at {p} {} of the area touches{share}{label}", area(answer));
    Some(line.replace(SPACE, " "))
}

/// The lines of a terminal on a surface: resistances, its size and headline, for which bodies an elastic area holds.
pub fn surface_lines(surface: &SurfaceComparison) -> Vec<String> {
    let [ny, nx] = surface.surface.grid().shape();
    let headline = headline_line(surface).map_or_else(String::new, |line| format!(": {line}"));
    let mut lines = resistance_lines(surface);
    lines.push(format!("{}, {ny} × {nx} points{headline}", surface.name));
    lines.extend(yielding::elastic_line(surface));
    lines
}

/// The first sentence, as HTML.
pub(crate) fn headline(surface: &SurfaceComparison) -> String {
    let p = super::headline_load(surface);
    let point = surface.deterministic.get(surface.headline);
    let Some(answer) = surface.headline_answer() else {
        let why = point.and_then(|p| p.trouble.clone()).unwrap_or_default();
        return format!("At {p} there is no deterministic answer: {}", escape(&why));
    };
    if answer.diagnostics.contact_pixels == 0 {
        return format!("At {p} nothing touches.");
    }
    let (opening, at) = match (answer.converged, answer.diagnostics.end == End::Rounding) {
        (true, _) => ("", "At"),
        (false, true) => ("Stopped at rounding: ", "at"),
        (false, false) => ("Not converged: ", "at"),
    };
    let about = if answer.budget.area.half_width().is_ok() { "" } else { "about " };
    let unresolved = if answer.budget.area.interval().is_ok_and(|[low, _]| low <= 0.0) {
        ": this map does not resolve its contacts"
    } else {
        ""
    };
    let whole = if surface.origin.pair().is_some() { "the area in common" } else { "the surface" };
    let (area, pressure) = (area(answer), real_pressure(answer));
    let (share, yielded) = (yielding::share(surface), yielding::or_yielded(surface));
    format!(
        "{opening}{at} {p}, {about}<b>{area}</b> of {whole} touches{share}{yielded}; the mean real pressure is \
         {about}<b>{pressure}</b>{unresolved}."
    )
}
