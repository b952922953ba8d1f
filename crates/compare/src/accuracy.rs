//! How far a deterministic area can be trusted: the bar that costs no further solve, and the
//! gate outside which it does not hold.
//!
//! A pixel counts as touching or not, so the raw count is high by a share of the contact line.
//! Corrected for it (Yastrebov, Anciaux & Molinari 2017, doi:10.1016/j.triboint.2017.04.023) the
//! area is still uncertain by a part of that correction, as long as the map resolves its own
//! shortest waves.

use fft_bem_solver::{BOUNDARY_CORRECTION, Diagnostics};

/// Part of the correction that is left as uncertainty. Chosen so that the bar held in 95 of 100
/// cases or more over shortest wavelengths of 2 to 32 pixels.
const LEFT_OVER: f64 = 0.3;

/// Relative area error per relative rms pressure error: the largest seen, 0.9 % at 1e-3.
const ITERATION: f64 = 9.0;

/// Why a map, or a load on it, has no error bar of this kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NoBar {
    /// Slopes near two pixels: finite differences see too little of the gradient.
    Unresolved {
        /// Rms gradient by finite differences over the one by the spectrum.
        ratio: f64,
    },
    /// The heights come in steps that make a good part of the gradient.
    Stepped {
        /// Height step over pixel and rms gradient.
        ratio: f64,
    },
    /// The contact line is so long that most contacts are a few pixels wide.
    FewPixels {
        /// Correction over raw area.
        ratio: f64,
    },
    /// The map is flat, or nothing touches.
    Empty,
    /// The solver did not converge.
    NotConverged,
}

impl std::fmt::Display for NoBar {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Unresolved { ratio } => write!(
                f,
                "finite differences see {:.0}\u{202F}% of the rms gradient (94\u{202F}% needed): the shortest \
                 waves are not resolved",
                100.0 * ratio
            ),
            Self::Stepped { ratio } => write!(
                f,
                "the height step is {ratio:.2} of pixel × rms gradient (0.5 at most): contacts \
                 follow the steps"
            ),
            Self::FewPixels { ratio } => write!(
                f,
                "the contact line takes {:.0}\u{202F}% of the area (20\u{202F}% at most): contacts are a few \
                 points wide",
                100.0 * ratio
            ),
            Self::Empty => f.write_str("nothing touches"),
            Self::NotConverged => f.write_str("the solver did not converge"),
        }
    }
}

/// Whether the map itself allows the bar.
///
/// `resolved` is the rms gradient by finite differences over the one by the spectrum; `step` the
/// height step in metres if there is one.
///
/// # Errors
/// The reason if it does not.
pub fn map_gate(
    resolved: f64,
    step: Option<f64>,
    pixel: f64,
    rms_gradient: f64,
) -> Result<(), NoBar> {
    if rms_gradient <= 0.0 {
        return Err(NoBar::Empty);
    }
    let steps = step.map_or(0.0, |step| step / (pixel * rms_gradient));
    if steps > 0.5 {
        return Err(NoBar::Stepped { ratio: steps });
    }
    let needed = if step.is_some() { 0.90 } else { 0.94 };
    if resolved < needed {
        return Err(NoBar::Unresolved { ratio: resolved });
    }
    Ok(())
}

/// Relative error of the area left by stopping at this relative rms pressure error.
pub fn iteration_error(residual: f64) -> f64 {
    ITERATION * residual.max(0.0)
}

/// Half width of the interval around the corrected area, from the grid and from the iteration.
///
/// # Errors
/// The reason if this load has none.
pub fn half_width(area_fraction: f64, diagnostics: &Diagnostics) -> Result<[f64; 2], NoBar> {
    if area_fraction <= 0.0 {
        return Err(NoBar::Empty);
    }
    let correction = BOUNDARY_CORRECTION * diagnostics.contact_perimeter;
    let ratio = correction / area_fraction;
    if ratio > 0.2 {
        return Err(NoBar::FewPixels { ratio });
    }
    let residual = diagnostics.residuals.preconditioned;
    let iteration = if diagnostics.exact.is_some() { 0.0 } else { iteration_error(residual) };
    Ok([LEFT_OVER * correction, iteration * diagnostics.area_fraction_corrected])
}

/// Half width around the area of a map that the cheap bar does not hold for, from one more
/// solution on its twice finer Fourier interpolation.
///
/// The refined area was within `max(0.3 c S_d, |refined - given|)` of its limit in 171 of 172
/// cases; the bar here is around the area *given*, so their difference comes on top.
pub fn refined_half_width(area: f64, refined_area: f64, refined_perimeter: f64) -> f64 {
    let moved = (refined_area - area).abs();
    moved + moved.max(LEFT_OVER * BOUNDARY_CORRECTION * refined_perimeter)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refined_bar_covers_both_areas_and_what_is_left() {
        let half = refined_half_width(0.020, 0.023, 0.1);
        assert!((half - (0.003 + 0.3 * BOUNDARY_CORRECTION * 0.1)).abs() < 1e-15);
        assert!(refined_half_width(0.020, 0.030, 0.1) >= 0.020 - 1e-15);
    }

    #[test]
    fn gate_opens_and_closes_where_the_study_says() {
        assert_eq!(map_gate(0.95, None, 1e-6, 0.1), Ok(()));
        assert!(matches!(map_gate(0.93, None, 1e-6, 0.1), Err(NoBar::Unresolved { .. })));
        // Q / (g dx) = 0.1: steps fine enough for the weaker limit.
        assert_eq!(map_gate(0.91, Some(1e-8), 1e-6, 0.1), Ok(()));
        assert!(matches!(map_gate(0.99, Some(1e-7), 1e-6, 0.1), Err(NoBar::Stepped { .. })));
        assert!(map_gate(1.0, None, 1e-6, 0.0).is_err());
    }
}
