//! A load that was solved for, as a row of the table.

use crate::conduction;
use crate::loads::shown;
use crate::text;
use rough_contact::contact_accuracy::{Prescribed, RealPressure};
use rough_contact::fft_bem_solver::Yielded;
use rough_contact::front_end::Point;

/// The cells of its row; `has_spot` if one spot is among what is conducted.
pub(crate) fn cells(point: &Point, has_spot: bool) -> Vec<String> {
    let (Some(solution), Some(budget)) = (&point.solution, &point.budget) else {
        return vec![shown(point.load), "refused".to_owned()];
    };
    let (state, d) = (&solution.state, &solution.diagnostics);
    let mean = budget.real_pressure().map(RealPressure::value);
    let area = &budget.area;
    let mut cells = vec![text::pressure(state.mean_pressure)];
    if budget.given == Prescribed::Gap {
        let load = budget.mean_pressure;
        cells.push(text::relative(load.value, load.interval().ok(), text::pressure));
    }
    cells.extend([
        text::percent(solution.touching_fraction()),
        text::percent(state.area_fraction),
        text::relative(area.value, area.interval().ok(), text::percent),
        text::relative(area.value, area.prediction(), text::percent),
        text::or_dash(state.mean_gap, text::length),
        text::or_dash(mean, text::pressure),
        text::highest(d.max_pressure, mean),
        text::number(d.transforms),
        format!("{:.1e}", d.residuals.preconditioned),
        text::seconds(d.seconds),
    ]);
    cells.extend(budget.stiffness.map(|k| text::stiffness(k.value)));
    if let Some(Yielded { area_fraction, load_share, .. }) = d.yielded {
        cells.extend([area_fraction, load_share].map(text::percent));
    }
    if let Some(found) = &point.conducted {
        cells.extend(conduction::cells(found));
        cells.splice(0..0, conduction::first_cells(found, has_spot));
    }
    cells
}
