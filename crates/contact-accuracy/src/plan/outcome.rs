//! What was chosen, what it reached, and what the next better choice would cost.

use super::Request;
use crate::budget::NoAreaInterval;
use contact_types::Grid;
use fft_bem_solver::{Load, Precision};

/// The next finer grid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Next {
    /// Points `[ny, nx]`.
    pub shape: [usize; 2],
    /// Over those of the given map, per side.
    pub factor: f64,
    /// Expected relative half width at the load that has the widest; `None` if the contacts would
    /// still be too small for a bar.
    pub half_width: Option<f64>,
    /// Expected time (s): that of the grid used, times the ratio of points.
    pub seconds: f64,
}

/// The outcome of a request.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Outcome {
    /// What was asked for.
    pub request: Request,
    /// True if the budget of every load is within the request.
    pub met: bool,
    /// The grid of the given map.
    pub given: Grid,
    /// The grid solved on.
    pub grid: Grid,
    /// Its points per side over those of the given map, about.
    pub factor: f64,
    /// Precision of the solver.
    pub precision: Precision,
    /// Tolerance of the solver.
    pub tolerance: f64,
    /// Widest relative half width over the loads; `None` if a load has no bar.
    pub half_width: Option<f64>,
    /// FFT pairs on the grid used, all loads.
    pub transforms: f64,
    /// Points × FFT pairs × bytes of a number, also on grids that were given up: what choices are
    /// ranked by.
    pub work: f64,
    /// Wall-clock time of all solutions, also those on grids that were given up (s).
    pub seconds: f64,
    /// Shapes of the grids that were tried and given up.
    pub given_up: Vec<[usize; 2]>,
    /// The next better choice; `None` if there is none.
    pub next: Option<Next>,
    /// Why the request is not met, if it is not.
    pub unmet: Option<Unmet>,
}

/// Why a request is not met.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Unmet {
    /// The map allows no bar, whatever the load and the grid.
    Map(NoAreaInterval),
    /// Some loads miss it.
    Loads {
        /// The first of them.
        first: Load,
        /// How many do.
        missed: usize,
        /// Loads in all.
        of: usize,
        /// What happens at the first.
        why: Miss,
    },
}

/// Why a load misses the request.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Miss {
    /// Nothing touches at the gap that is given.
    NoContact {
        /// Mean gap at the first contact of this map (m).
        first_contact: f64,
    },
    /// Its bar is too wide or there is none, on the grid used.
    Bar {
        /// Relative half width, or why there is none.
        here: Result<f64, NoBar>,
        /// What the finest grid considered would do.
        finest: Finest,
    },
}

/// Why a load has no bar.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum NoBar {
    /// The area has none.
    Area(NoAreaInterval),
    /// The solver has no answer; in its own words.
    Unsolved(String),
}

/// What the finest grid considered would do for a load that misses the request.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum Finest {
    /// The grid used is the finest.
    Used,
    /// A finer one was tried and given up: what lies between the given points decides on it.
    BetweenPoints,
    /// A finer one, of so many points `[ny, nx]`.
    Other {
        /// Its points.
        shape: [usize; 2],
        /// Relative half width expected on it; `None` if it would not resolve the contacts.
        half_width: Option<f64>,
    },
}
