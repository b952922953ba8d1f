//! Answers that need no iteration: full contact, and a single pixel in contact.

use crate::methods::{Compliance, State};
use crate::problem::Problem;
use crate::{Real, fields, love};

/// Replaces `field` by the pressure of mean zero that gives the surface the shape of the heights.
/// One convolution; `None` if the operator has no cheap inverse. Returns the least mean pressure that has
/// to be added so that none is negative, which is the load that closes every gap.
///
/// # Source
/// Johnson (1985), *Contact Mechanics*, §13.2.
pub(crate) fn flattening_pressure<T: Real>(
    problem: &Problem<T>,
    operator: &mut dyn Compliance<T>,
    field: &mut Vec<T>,
) -> Option<f64> {
    field.clear();
    field.extend_from_slice(&problem.heights);
    operator.invert(field).then(|| -fields::min(field))
}

/// Full contact under `mean_pressure`, at least the closing load; `state.pressure` holds the
/// flattening pressure.
pub(crate) fn full_contact<T: Real>(
    problem: &Problem<T>,
    mean_pressure: f64,
    state: &mut State<T>,
) {
    for p in &mut state.pressure {
        *p = (*p + T::of(mean_pressure)).larger(T::zero()); // rounding
    }
    state.level = -problem.mean_height;
    for (u, h) in state.displacement.iter_mut().zip(&problem.heights) {
        *u = *h - T::of(problem.mean_height);
    }
}

/// The highest pixel, if it will probably carry `mean_pressure` alone: the dent of one pixel of an
/// infinite half space, 20 % deeper than it is, reaches no other pixel. Only for maps, not for
/// profiles, whose kernel is another.
pub(crate) fn lonely_summit<T: Real>(problem: &Problem<T>, mean_pressure: f64) -> Option<usize> {
    let [ny, nx] = problem.grid.shape();
    let [dy, dx] = problem.grid.pixel();
    if ny == 1 || nx == 1 {
        return None;
    }
    let summit = problem.heights.iter().position(|h| *h >= T::zero())?;
    let force = 1.2 * mean_pressure * (ny * nx) as f64;
    let depth = force * love([0.0, 0.0], [dy, dx]);
    let apart = |i: usize, j: usize, n: usize| {
        let d = i.abs_diff(j);
        d.min(n - d) as f64
    };
    for (i, h) in problem.heights.iter().enumerate() {
        let below = -h.wide();
        if i == summit || below > depth {
            continue;
        }
        let y = apart(i / nx, summit / nx, ny) * dy;
        let x = apart(i % nx, summit % nx, nx) * dx;
        if below <= depth - force * love([y, x], [dy, dx]) {
            return None;
        }
    }
    Some(summit)
}

/// All the load on one pixel: exact if no other pixel is reached, which is checked. One convolution. On
/// false the state is undefined.
pub(crate) fn single_pixel<T: Real>(
    problem: &Problem<T>,
    summit: usize,
    mean_pressure: f64,
    operator: &mut dyn Compliance<T>,
    state: &mut State<T>,
) -> bool {
    state.pressure.fill(T::zero());
    state.pressure[summit] = T::of(mean_pressure * problem.heights.len() as f64);
    operator.apply(&state.pressure, &mut state.displacement);
    state.level = (state.displacement[summit] - problem.heights[summit]).wide();
    let level = T::of(state.level);
    let gaps = state.displacement.iter().zip(&problem.heights).map(|(u, h)| *u - *h - level);
    gaps.enumerate().all(|(i, gap)| i == summit || gap > T::zero())
}
