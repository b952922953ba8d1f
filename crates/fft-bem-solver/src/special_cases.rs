//! Answers that need no iteration: no load, a flat surface, full contact.

use crate::methods::{Compliance, State};
use crate::problem::Problem;
use crate::{Real, fields};

/// Tries full contact: `p = P + S h` closes every gap if it is nowhere negative. One pair. Leaves
/// the answer in `state` and returns true, or returns false and leaves the state undefined.
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §13.2.
pub(crate) fn full_contact<T: Real>(
    problem: &Problem<T>,
    mean_pressure: f64,
    operator: &mut dyn Compliance<T>,
    state: &mut State<T>,
) -> bool {
    state.pressure.copy_from_slice(&problem.heights);
    if !operator.invert(&mut state.pressure) {
        return false;
    }
    let load = T::of(mean_pressure);
    for p in &mut state.pressure {
        *p += load;
    }
    if fields::min(&state.pressure) < 0.0 {
        return false;
    }
    closed(problem, state);
    true
}

/// The least mean pressure that closes every gap, and the contact under it. One pair; `None` if
/// the operator has no cheap inverse.
pub(crate) fn just_closed<T: Real>(
    problem: &Problem<T>,
    operator: &mut dyn Compliance<T>,
    state: &mut State<T>,
) -> Option<f64> {
    state.pressure.copy_from_slice(&problem.heights);
    if !operator.invert(&mut state.pressure) {
        return None;
    }
    let load = -fields::min(&state.pressure);
    for p in &mut state.pressure {
        *p = (*p + T::of(load)).larger(T::zero());
    }
    closed(problem, state);
    Some(load)
}

/// Displacement and level where no gap is left: `u = h - mean h`.
fn closed<T: Real>(problem: &Problem<T>, state: &mut State<T>) {
    state.level = -problem.mean_height;
    for (u, h) in state.displacement.iter_mut().zip(&problem.heights) {
        *u = *h - T::of(problem.mean_height);
    }
}
