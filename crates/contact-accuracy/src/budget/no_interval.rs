//! Where no interval for an area is known, and why.

use super::between::MOST_DOUBT;
use contact_types::Grid;
use fft_bem_solver::End;

/// Coarsest height step over (rms gradient times pixel side).
pub(super) const MOST_STEP: f64 = 0.5;

/// Largest correction over raw area.
pub(super) const MOST_CORRECTION: f64 = 0.2;

/// Why there is no interval for an area.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum NoAreaInterval {
    /// The shortest waves of the map are too short for its pixels.
    #[error(
        "finite differences see {:.0}\u{202F}% of the rms gradient ({:.0}\u{202F}% needed): the \
         shortest waves are not resolved",
        100.0 * resolution, 100.0 * needed
    )]
    Unresolved {
        /// g_FD / g_SP.
        resolution: f64,
        /// What it must reach.
        needed: f64,
    },
    /// The heights are too coarsely stepped.
    #[error(
        "the height step is {ratio:.2} of pixel × rms gradient ({MOST_STEP} at most): contacts \
         follow the steps"
    )]
    Stepped {
        /// Height step over (rms gradient times pixel side).
        ratio: f64,
    },
    /// The contact spots are too small for the pixels.
    #[error(
        "the contact line takes {:.0}\u{202F}% of the area ({:.0}\u{202F}% at most): contacts \
         are a few points wide; solve on a finer map or at a higher load",
        100.0 * ratio, 100.0 * MOST_CORRECTION
    )]
    SpotsTooSmall {
        /// Correction over raw area.
        ratio: f64,
    },
    /// What lies between the points decides what touches, and the points do not fix it.
    #[error(
        "between the points, what touches is not fixed by the map: ways to interpolate differ by \
         {doubt:.2} of what the load deforms over a pixel ({MOST_DOUBT} at most); measure on finer \
         points"
    )]
    BetweenPoints {
        /// [`Between::doubt`](super::Between::doubt).
        doubt: f64,
    },
    /// The iteration stopped too early.
    #[error(
        "the pressure is known to {residual:.1e} only; an interval for the area needs a tolerance \
         of {limit:.0e}"
    )]
    TooLooselySolved {
        /// Estimated relative pressure error.
        residual: f64,
        /// What it must not exceed.
        limit: f64,
    },
    /// The iterations ran out.
    #[error("the solver did not converge")]
    NotConverged,
    /// Rounding kept the iteration from its tolerance.
    #[error("rounding stopped the solver before its tolerance")]
    AtRounding,
    /// The map is flat, or nothing touches.
    #[error("nothing touches")]
    Empty,
    /// The solution is of another grid than the map.
    #[error(
        "the solution is of {} x {} points of {:e} m x {:e} m, but the map was looked at on {} x {} \
         points of {:e} m x {:e} m: look at the map that was solved",
        solution.shape()[0], solution.shape()[1], solution.pixel()[0], solution.pixel()[1],
        map.shape()[0], map.shape()[1], map.pixel()[0], map.pixel()[1]
    )]
    OtherGrid {
        /// Grid of the map.
        map: Grid,
        /// Grid of the solution.
        solution: Grid,
    },
    /// The interval was not studied for this kind of problem.
    #[error("no interval is known for {0}")]
    NotStudied(&'static str),
}

impl NoAreaInterval {
    /// Of a solution that ended before its tolerance.
    pub fn of_end(end: End) -> Self {
        if end == End::Rounding { Self::AtRounding } else { Self::NotConverged }
    }
}
