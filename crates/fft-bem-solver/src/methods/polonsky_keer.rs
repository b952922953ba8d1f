//! Constrained conjugate gradients of Polonsky & Keer.
//!
//! # Source
//! Polonsky & Keer (1999), *Wear* 231, 206–219, doi:10.1016/S0043-1648(99)00113-1, section 3.

use super::baseline::BaselineStep;
use super::compliance::Compliance;
use super::contract::State;
use crate::{Real, fields};
use std::sync::atomic::{AtomicBool, Ordering};

pub(crate) struct PolonskyKeer {
    /// delta of the paper.
    is_conjugate: bool,
    /// G_old.
    last_norm: f64,
    /// tau, pressure per gap.
    length: f64,
}

impl<T: Real> BaselineStep<T> for PolonskyKeer {
    const START: Self = Self { is_conjugate: false, last_norm: 1.0, length: 1.0 };

    /// The gap is that of eqs. 8 and 9.
    fn step(
        &mut self,
        load: f64,
        state: &mut State<T>,
        gap: &[T],
        t: &mut [T],
        r: &mut [T],
        operator: &mut dyn Compliance<T>,
    ) -> Option<f64> {
        // Conjugate direction on the contact (eqs. 10, 11).
        let (p, n) = (&state.pressure, gap.len());
        let on = |i: usize| p[i] > T::zero();
        let sum_on = |term: &(dyn Fn(usize) -> f64 + Sync)| {
            fields::sum_of(n, |i| if on(i) { term(i) } else { 0.0 })
        };
        let norm = sum_on(&|i| gap[i].wide().powi(2));
        let beta = T::of(if self.is_conjugate { norm / self.last_norm } else { 0.0 });
        self.last_norm = norm;
        fields::write(t, |i, t| if on(i) { gap[i] + beta * t } else { T::zero() });
        // Its response, and the length of the step (eqs. 12-14).
        operator.apply(t, r);
        let mean = sum_on(&|i| r[i].wide()) / fields::contact_count(p) as f64;
        let descent = sum_on(&|i| gap[i].wide() * t[i].wide());
        let curvature = sum_on(&|i| (r[i].wide() - mean) * t[i].wide());
        let overlaps = |i: usize| p[i] <= T::zero() && gap[i] < T::zero();
        if curvature > 0.0 {
            self.length = descent / curvature;
        } else if !(0..n).any(overlaps) {
            return None;
        } // else the contact is at rest, and the last length takes in what overlaps
        let tau = T::of(self.length);

        // Step, truncate, and take in the pixels that overlap (eqs. 15-17).
        let (truncated, taken_in) = (AtomicBool::new(false), AtomicBool::new(false));
        fields::write(&mut state.pressure, |i, p| {
            let trial = p - tau * t[i];
            if trial < T::zero() {
                truncated.store(true, Ordering::Relaxed);
            }
            let p = trial.larger(T::zero());
            if p <= T::zero() && gap[i] < T::zero() {
                taken_in.store(true, Ordering::Relaxed);
                return p - tau * gap[i];
            }
            p
        });
        let [truncated, taken_in] = [truncated, taken_in].map(AtomicBool::into_inner);
        self.is_conjugate = !taken_in;
        // Restore the load (eq. 18). K is linear: unless a pixel changed sides, the response is known
        // without a transform.
        let scale = T::of(load * n as f64 / fields::sum(&state.pressure));
        fields::write(&mut state.pressure, |_, p| p * scale);
        if truncated || taken_in {
            operator.apply(&state.pressure, &mut state.displacement);
            return Some(2.0);
        }
        fields::write(&mut state.displacement, |i, u| (u - tau * r[i]) * scale);
        Some(1.0)
    }
}
