//! How wrong an iterate can be at most.
//!
//! Let `g = K p - h - c` for any `c` and `p >= 0` of the right mean. For every `mu >= 0`
//!
//! ```math
//! E(p) - E(p^*) \le \langle p, \mu\rangle + \tfrac12 \langle g-\mu, S(g-\mu)\rangle,
//! \qquad \lVert p-p^*\rVert_K^2 \le 2\,(E(p) - E(p^*)),\qquad S = K^{-1}
//! ```
//!
//! because `E(p) - E(q)` for a feasible `q` is `<p - q, g> - |p - q|_K^2 / 2`, and splitting
//! `g = mu + (g - mu)` leaves `<p - q, mu> <= <p, mu>` and, by Young's inequality,
//! `<p - q, g - mu> <= |p - q|_K^2 / 2 + |g - mu|_S^2 / 2`. Here `mu = max(0, g - p/1.2)`, so that
//! `g - mu = min(g, p/1.2)`: the gap in contact, overlap elsewhere, and little where a pixel should
//! have left the contact. The factor 1.2 (pressure over gap, per finer pixel and E*) is free; it
//! decides how tight the bound is, not whether it holds.
//!
//! Under a ceiling H, `p <= H`, the same holds with `g - mu + nu` in place of `g - mu` for every `nu >= 0`, and
//! `<H - p, nu>` added: `<p - q, -nu> <= <H - p, nu>`. Then `g - mu + nu` is what of g lies between
//! `-(H - p)/1.2` and `p/1.2`: what a node lacks to the ceiling counts where it overlaps.
//!
//! The bound says nothing about the contact area.

use crate::methods::{Ceiling, Compliance, NoCeiling, State, level_under, under};
use crate::row_work::{Partial, TASK};
use crate::{End, Real, fields};
use std::f64::consts::FRAC_PI_2;

/// `displacement - heights` in contact, averaged with the pressure as weight; under a ceiling, that of
/// [`level_under`].
pub(crate) fn level<T: Real>(state: &State<T>, heights: &[T], ceiling: f64) -> f64 {
    let (p, u) = (&state.pressure, &state.displacement);
    if ceiling.is_finite() {
        let mut partial = vec![Partial::default(); p.len().div_ceil(TASK)];
        return under!(ceiling, top => level_under(top, [p, u, heights], &mut partial));
    }
    let [sum, weight] = fields::weighted_difference(p, [u, heights]);
    if weight > 0.0 { sum / weight } else { 0.0 }
}

/// `g - mu = min(g, p / 1.2)`: the part of the gap that should not be there. Under a ceiling, no less than
/// `-(H - p) / 1.2` either.
fn violation<T: Real, C: Ceiling<T>>(ceiling: C, pressure: T, gap: T) -> T {
    let most = pressure / T::of(1.2);
    let violation = if gap < most { gap } else { most };
    if C::IS_FINITE {
        return violation.larger((pressure - ceiling.top()) / T::of(1.2));
    }
    violation
}

/// The bound of the module documentation of `|p - p*|_K / |p|_K`; one convolution. `None`, and no convolution, if the
/// operator has no cheap inverse. `gap` is `displacement - heights` less any constant; `scratch` is overwritten.
pub(crate) fn energy_error<T: Real, C: Ceiling<T>>(
    ceiling: C,
    state: &State<T>,
    gap: impl Fn(usize) -> T + Sync,
    scratch: &mut [T],
    operator: &mut dyn Compliance<T>,
) -> Option<f64> {
    let p = &state.pressure;
    fields::write(scratch, |i, _| violation(ceiling, p[i], gap(i)));
    if !operator.invert(scratch) {
        return None;
    }
    let twice_bound = fields::sum_of(p.len(), |i| {
        let r = violation(ceiling, p[i], gap(i));
        let mu = gap(i) - r; // or -nu
        let room = if C::IS_FINITE && mu < T::zero() { p[i] - ceiling.top() } else { p[i] };
        r.wide() * scratch[i].wide() + 2.0 * room.wide() * mu.wide()
    });
    let energy = fields::dot(p, &state.displacement).abs();
    Some(if twice_bound > 0.0 { (twice_bound / energy).sqrt() } else { 0.0 })
}

/// Relative rms pressure error per bound of the relative energy error, on the cautious side: the
/// error a method leaves is short-waved, and the energy norm weighs such errors less. Measured on
/// the surfaces of `tests/certificate.rs`: 0.4 to 3.1.
pub(crate) const CAUTION: f64 = 2.0;

/// When a method without an error estimate of its own pays a convolution for one.
///
/// `|r| / |p|` times the largest stiffness on the grid, pi/2 per finer pixel, exceeds the relative pressure error and is
/// free. Where it could be small enough, or rounding keeps it from falling, the bound is evaluated; how much that lacks
/// sets the wait for the next evaluation.
pub(crate) struct Patience {
    tolerance: f64,
    worthwhile: f64,
    best: f64,
    since: usize,
}

/// Evaluations without halving the bound after which rounding is to blame.
const STALL: usize = 10;

impl Patience {
    pub(crate) fn new(tolerance: f64) -> Self {
        Self { tolerance, worthwhile: 30.0 * tolerance, best: f64::INFINITY, since: 0 }
    }

    /// Judges the state by its `gap`; `scratch` is overwritten. Returns whether it is the last, the
    /// estimate of its relative pressure error if one was made, and the convolutions spent.
    pub(crate) fn judge<T: Real>(
        &mut self,
        state: &State<T>,
        heights: &[T],
        gap: &[T],
        scratch: &mut [T],
        operator: &mut dyn Compliance<T>,
    ) -> (Option<End>, Option<f64>, f64) {
        let p = &state.pressure;
        let square = |i: usize| violation(NoCeiling, p[i], gap[i]).wide().powi(2);
        let plain = FRAC_PI_2 * (fields::sum_of(p.len(), square) / fields::dot(p, p)).sqrt();
        let is_rounding = is_rounding(state, heights, gap);
        if plain > self.worthwhile.max(30.0 * T::ATTAINABLE) && !is_rounding {
            return (None, None, 0.0);
        }
        let bound = energy_error(NoCeiling, state, |i| gap[i], scratch, operator);
        let relative =
            bound.filter(|bound| bound.is_finite()).map_or(plain, |bound| CAUTION * bound);
        self.since += 1;
        if relative <= 0.5 * self.best {
            (self.best, self.since) = (relative, 0);
        }
        let is_stalled = self.since >= STALL && relative <= T::ATTAINABLE;
        let end = if relative <= self.tolerance {
            Some(End::Converged)
        } else {
            (is_rounding || is_stalled).then_some(End::Rounding)
        };
        let aim = self.tolerance.max(T::ATTAINABLE);
        self.worthwhile = plain * (0.7 * aim / relative).clamp(0.01, 0.9);
        if relative <= T::ATTAINABLE {
            self.worthwhile = 2.0 * plain; // near rounding: look every time
        }
        (end, Some(relative), bound.map_or(0.0, |_| 1.0))
    }
}

/// True if what is left of the gap in contact is rounding of the two fields it is made of.
fn is_rounding<T: Real>(state: &State<T>, heights: &[T], gap: &[T]) -> bool {
    let (p, u) = (&state.pressure, &state.displacement);
    let violation = |i: usize| violation(NoCeiling, p[i], gap[i]).wide().abs();
    let worst = fields::largest_of(p.len(), violation);
    let size = fields::largest_of(p.len(), |i| {
        let matters = violation(i) > 0.0 || p[i] > T::zero();
        if matters { heights[i].wide().abs() } else { 0.0 }
    });
    worst <= 2.0 * T::EPSILON * (size + fields::max(u).max(-fields::min(u)))
}
