//! Whether two surfaces know of each other.

use super::Composite;
use crate::differences::by_differences;
use crate::spectrum::PowerSpectrum;
use crate::{Edges, Level, StatsError, repeats};
use contact_types::SpectralMoments;

/// Moments of two bodies and of their sum. Those of independent surfaces add.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Independence {
    /// Of each body on the common part, by finite differences.
    pub bodies: [SpectralMoments; 2],
    /// Of the sum of the heights, measured in the same way: those that models are given.
    pub composite: SpectralMoments,
    /// m0, m2, m4 of the composite over the sums of those of the bodies, less 1 \[-\]: −1 for bodies
    /// that mate, +1 for a body against its own mirror image; 0 for flat bodies.
    pub excess: [f64; 3],
    /// Its standard deviation for independent bodies with these spectra \[-\].
    pub chance: [f64; 3],
}

impl Independence {
    /// Of both bodies and their sum, each without its `form` and with these edges.
    ///
    /// # Errors
    /// [`StatsError::TooSmall`] below 3 x 3 points, [`StatsError::OutOfRange`].
    pub fn of(pair: &Composite, form: Level, edges: Edges) -> Result<Self, StatsError> {
        let (form, sum) = form.taken_off(pair.map.clone())?; // the same for all three: they add
        let [(_, a), (_, b)] =
            [form.taken_off(pair.parts[0].clone())?, form.taken_off(pair.parts[1].clone())?];
        let seam = if repeats(&a) && repeats(&b) { Edges::Periodic } else { Edges::Open };
        let spread = if a.is_flat() || b.is_flat() {
            [0.0; 3]
        } else {
            let powers = [PowerSpectrum::of(&a, seam)?, PowerSpectrum::of(&b, seam)?];
            spread(&powers, a.grid().pixel())
        };
        let bodies = [by_differences(&a, edges)?.0, by_differences(&b, edges)?.0];
        drop([a, b]);
        let composite = by_differences(&sum, edges)?.0;
        let parts = |m: SpectralMoments| [m.m0, m.m2, m.m4];
        let sums = [0, 1, 2].map(|k| parts(bodies[0])[k] + parts(bodies[1])[k]);
        let share = |k: usize, of: f64| if sums[k] > 0.0 { of / sums[k] } else { 0.0 };
        let excess = [0, 1, 2].map(|k| share(k, parts(composite)[k] - sums[k]));
        let chance = [0, 1, 2].map(|k| share(k, spread[k]));
        Ok(Self { bodies, composite, excess, chance })
    }

    /// Sums of the moments of the bodies.
    pub fn sum(&self) -> SpectralMoments {
        let [a, b] = self.bodies;
        SpectralMoments { m0: a.m0 + b.m0, m2: a.m2 + b.m2, m4: a.m4 + b.m4 }
    }

    /// Whether the moments add: each to 5 %, or to three times what chance makes of them, but not worse than a half.
    pub fn holds(&self) -> bool {
        let adds = |(excess, chance): (&f64, &f64)| excess.abs() <= (3.0 * chance).clamp(0.05, 0.5);
        self.excess.iter().zip(&self.chance).all(adds)
    }
}

/// Standard deviation of m0, m2, m4 of a sum whose two parts have waves of random phase. A wave of
/// variances `P1` and `P2` adds `2 √(P1 P2) cos φ`, with `φ` uniform, for itself and its mirror image, and
/// counts in m2 and m4 as forward differences see it.
fn spread([first, second]: &[PowerSpectrum; 2], [dy, dx]: [f64; 2]) -> [f64; 3] {
    let mut other = Vec::new();
    second.for_each(|_, _, variance| other.push(variance));
    let (mut other, mut variances) = (other.into_iter(), [0.0; 3]);
    first.for_each(|q, weight, a| {
        let b = other.next().unwrap_or(0.0);
        let [y, x] = [(q[0], dy), (q[1], dx)].map(|(q, d)| (2.0 * (0.5 * q * d).sin() / d).powi(2));
        let seen = [1.0, f64::midpoint(x, y), f64::midpoint(x * x, y * y)];
        for (variance, seen) in variances.iter_mut().zip(seen) {
            // Products of roots, since squares of small numbers vanish.
            *variance += weight * (2.0 * seen * a.sqrt() * b.sqrt()).powi(2);
        }
    });
    variances.map(f64::sqrt)
}
