//! Steepest descent with redistribution of the load, after Stanley & Kato.
//!
//! Each iteration (1) transforms the pressure to the displacement, (2) forms the gap, which is the
//! gradient of the energy, (3) steps down the gradient, (4) drops tension and shifts the whole
//! field until the load is carried again. One FFT convolution per iteration. The step is the one that
//! minimises the energy along the way from the old pressure to the redistributed one: the energy
//! never rises, and the iteration can be run to any tolerance.
//!
//! The number of iterations grows with the longest over the shortest wavelength in contact: this is
//! a baseline, not a method to prefer.
//!
//! # Source
//! Stanley & Kato (1997), *J. Tribol.* 119, 481–485, doi:10.1115/1.2833523.

use super::baseline::BaselineStep;
use super::compliance::Compliance;
use super::contract::State;
use crate::{Real, fields, projection};

/// Length of the next step down the gradient, pressure per gap.
pub(crate) struct StanleyKato(f64);

impl<T: Real> BaselineStep<T> for StanleyKato {
    const START: Self = Self(1.0);

    fn step(
        &mut self,
        load: f64,
        state: &mut State<T>,
        gap: &[T],
        trial: &mut [T],
        response: &mut [T],
        operator: &mut dyn Compliance<T>,
    ) -> Option<f64> {
        // Down the gradient, then redistribute.
        let (State { pressure: p, displacement: u, .. }, n) = (&mut *state, gap.len());
        let length = T::of(self.0);
        fields::write(trial, |i, _| p[i] - length * gap[i]);
        projection::onto_admissible(trial, load);
        operator.apply(trial, response);

        // The best point on the way: theta = -<g, s> / <s, K s>.
        let s = |i: usize| trial[i].wide() - p[i].wide();
        let descent = -fields::sum_of(n, |i| gap[i].wide() * s(i));
        let curvature = fields::sum_of(n, |i| s(i) * (response[i].wide() - u[i].wide()));
        if descent <= 0.0 || curvature <= 0.0 || (descent / curvature).is_nan() {
            return None;
        }
        let theta = descent / curvature;
        self.0 *= theta.clamp(0.2, 5.0);
        // Beyond the end of the way only as far as no pressure turns negative, and little, since
        // the error of u grows by the factor 1 - part; the next step will be longer.
        let mut part = theta.min(1.5);
        if theta > 1.0 {
            let reach = fields::least_of(n, |i| {
                if trial[i] < p[i] { p[i].wide() / -s(i) } else { f64::INFINITY }
            });
            part = part.min(reach.max(1.0));
        }
        let part = T::of(part);
        fields::write(p, |i, p| (p + part * (trial[i] - p)).larger(T::zero()));
        fields::write(u, |i, u| u + part * (response[i] - u));
        // Beyond the end of the way rounding of the load would grow; K is linear.
        state.scale(load * n as f64 / fields::sum(&state.pressure));
        Some(1.0)
    }
}
