//! Loads as they were asked for: which are refused, in which order they are solved, how they are
//! called.

use crate::outcome::Failure;
use crate::text;
use fft_bem_solver::Load;

/// Refuses a load that is not greater than 0.
pub(crate) fn positive(what: &str, value: f64, unit: &str, hint: &str) -> Result<(), Failure> {
    if value > 0.0 {
        return Ok(());
    }
    let message = format!("{what} {value} {unit} must be greater than 0; give a {what} {hint}");
    Err(Failure::refused("bad_load", message))
}

/// Indices from the lightest load to the heaviest.
pub(crate) fn rising(loads: &[Load]) -> Vec<usize> {
    let weight = |load: &Load| match *load {
        Load::MeanGap(gap) => -gap,
        Load::MeanPressure(load) | Load::Approach(load) => load,
        _ => 0.0,
    };
    let mut order: Vec<usize> = (0..loads.len()).collect();
    order.sort_by(|&i, &j| weight(&loads[i]).total_cmp(&weight(&loads[j])));
    order
}

/// "2 MPa", "gap 30 nm".
pub(crate) fn shown(load: Load) -> String {
    match load {
        Load::MeanPressure(p) => text::pressure(p),
        Load::MeanGap(g) => format!("gap {}", text::length(g)),
        other => format!("{other:?}"),
    }
}
