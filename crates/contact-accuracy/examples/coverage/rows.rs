//! Rows of the tables.

use crate::cases::Coverage;

pub(crate) const HEADER: &str = "| surfaces | answers | coverage of the area, worst family, median ± | gap (at a gap: pressure) | stiffness | error of the area, median |\n|---|---:|---|---|---|---:|";

/// Held, worst family, median half width of a number.
fn cell(found: &Coverage, k: usize) -> String {
    let held = &found.held[k];
    let worst = found.worst.map_or(String::new(), |w| format!(", {:.0} %", 100.0 * w[k]));
    format!("{:.1} %{worst}, ±{:.2} %", 100.0 * held.share(), 100.0 * held.medians()[1])
}

pub(crate) fn row(name: &str, found: &Coverage) -> String {
    let cell = |k: usize| cell(found, k);
    let answers = found.held[0].0.len();
    let error = 100.0 * found.held[0].medians()[0];
    format!("| {name} | {answers} | {} | {} | {} | {error:.2} % |", cell(0), cell(1), cell(2))
}

pub(crate) fn gaps(found: &Coverage) -> String {
    let row = |(k, name): (usize, &str)| {
        let held = &found.held[k];
        let error = 100.0 * held.medians()[0];
        format!("| {name} | {} | {} | {error:.2} % |\n", held.0.len(), cell(found, k))
    };
    let rows: String =
        [(3, "conductance of the gas"), (4, "permeability along x")].map(row).concat();
    let bounds = &found.held[5];
    format!(
        "| of the gap, all | answers | coverage, worst family, median ± | error, median |\n|---|---:|---|---:|\n{rows}\n\
         Of {} upper bounds of the permeability {} hold.",
        bounds.0.len(),
        bounds.count()
    )
}

/// What a rung costs and gives.
pub(crate) fn ladder(fast: &Coverage, given: &Coverage) -> String {
    let time = |c: &Coverage| c.seconds.iter().sum::<f64>();
    let all = time(given) - given.seconds[2];
    let row = |name: &str, c: &Coverage, seconds: f64| {
        format!(
            "| {name} | {:.2} | {:.1} % | ±{:.1} % |\n",
            seconds / all,
            100.0 * c.held[0].share(),
            100.0 * c.held[0].medians()[1]
        )
    };
    let mut text =
        "| grid | time | coverage of the area | median ± |\n|---|---:|---:|---:|\n".to_owned();
    text += &row("every second point (`--fast`)", fast, time(fast));
    text += &row("the map (default), with twice the points where needed", given, time(given));
    text + &format!(
        "| of it: twice the points | {:.2} | | |\n| of it: every second point | {:.2} | | |",
        given.seconds[2] / all,
        given.seconds[1] / all
    )
}
