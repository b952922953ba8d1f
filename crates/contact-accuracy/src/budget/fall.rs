//! By how much the mean gap falls and the area rises with the load, from one solution.

use fft_bem_solver::Solution;

/// Fall of the gap per e-fold load over `W/p`, while most of the surface is out of contact.
const FALL: f64 = 1.06;
/// Near full contact it goes as `sqrt(1 - exp(-this gap/fall))`.
const LEVELLING: f64 = 1.2;
/// By how much smaller than this it may be; the load is uncertain by that much more.
pub(super) const CAUTION: f64 = 1.5;

/// The least by which the mean gap falls when the load grows e-fold (m), from a solution with a
/// mean gap; 0 if nothing touches.
pub fn least_fall(solution: &Solution) -> f64 {
    let (state, energy) = (&solution.state, solution.diagnostics.elastic_energy);
    let (Some(gap), true) = (state.mean_gap, state.mean_pressure > 0.0) else { return 0.0 };
    let fall = FALL * energy / state.mean_pressure;
    if fall <= 0.0 {
        return 0.0;
    }
    fall * (1.0 - (-LEVELLING * gap.max(0.0) / fall).exp()).sqrt() / CAUTION
}

/// Fall of the mean gap when the load grows e-fold, over the gap \[-\]; 0 without a gap.
pub(super) fn fall_over_gap(solution: &Solution) -> f64 {
    let gap = solution.state.mean_gap.filter(|gap| *gap > 0.0);
    gap.map_or(0.0, |gap| CAUTION * least_fall(solution) / gap)
}

/// Relative change of the area over that of the load, at most: 1 at light load, 0 at full contact.
/// Persson's (2001, doi:10.1063/1.1388626) area, `erf(c p)`, has 0.3 % to half of it less than this.
pub fn area_per_load(area: f64) -> f64 {
    (1.0 - area * area).max(0.0).sqrt()
}
