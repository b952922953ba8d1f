//! Moments of a trace by finite differences, and how they depend on the spacing.

use super::Trace;
use crate::HeightStatistics;
use contact_types::SpectralMoments;

/// m0, m2, m4 of a trace by finite differences of neighbouring points:
///
/// ```math
/// m_0 = \langle z^2 \rangle, \qquad
/// m_2 = \Big\langle \Big(\frac{z_{i+1}-z_i}{\Delta}\Big)^2 \Big\rangle, \qquad
/// m_4 = \Big\langle \Big(\frac{z_{i+1}-2z_i+z_{i-1}}{\Delta^2}\Big)^2 \Big\rangle
/// ```
///
/// They are the moments of the surface, in the sense of Nayak (1971), if it is isotropic: there `m2 = <|grad h|²>/2` and
/// `m4 = 3 <(laplace h)²>/8` are the mean squares of slope and second derivative along any line.
/// The trace must be levelled.
pub fn moments(trace: &Trace) -> SpectralMoments {
    at(trace, 1)
}

/// m2 and m4 by differences over 1, 2, 4, 8, ... points, as long as sixteen of them fit: the distance (m) and the moments.
pub(super) fn moments_by_spacing(trace: &Trace) -> Vec<(f64, SpectralMoments)> {
    let doubled = std::iter::successors(Some(1_usize), |every| every.checked_mul(2));
    doubled
        .take_while(|every| *every == 1 || 16 * every <= trace.heights().len())
        .map(|every| (every as f64 * trace.spacing(), at(trace, every)))
        .collect()
}

fn at(trace: &Trace, every: usize) -> SpectralMoments {
    let distance = every as f64 * trace.spacing();
    let (square, z) = (distance * distance, trace.heights());
    let slope = mean_square(z.windows(every + 1).map(|w| w[every] - w[0]));
    let middle = |w: &[f64]| w[2 * every] - w[every] - (w[every] - w[0]);
    let curvature = mean_square(z.windows(2 * every + 1).map(middle));
    SpectralMoments {
        m0: HeightStatistics::of(trace).rms_height.powi(2),
        m2: slope / square,
        m4: curvature / square / square,
    }
}

fn mean_square(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.map(|value| value * value).sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use std::f64::consts::TAU;

    /// A wave over whole periods: A²/2 times the transfer functions [2 sin(q n Δ/2)/(n Δ)]² and
    /// its square; the ends take a part of 1/n.
    #[test]
    fn a_wave_at_every_spacing() {
        let (a, n, periods) = (2e-7, 20_000, 400.0);
        let q = TAU * periods / (f64::from(n) * 1e-6);
        let trace = Trace::new(1e-6, (0..n).map(|i| a * (q * f64::from(i) * 1e-6).cos()).collect())
            .unwrap();
        for (distance, found) in moments_by_spacing(&trace).into_iter().take(6) {
            let factor = (2.0 * (0.5 * q * distance).sin() / distance).powi(2);
            close(found.m0, 0.5 * a * a, 1e-9);
            close(found.m2, 0.5 * a * a * factor, 5e-3);
            close(found.m4, 0.5 * a * a * factor * factor, 5e-3);
        }
    }
}
