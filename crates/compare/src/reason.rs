//! Whether a theory covers a surface, and why not: as numbers. `report` has the words.

use crate::finding::Fact;
use crate::theory::BuildError;
use contact_types::{Caveat, Named};
use serde::Serialize;

/// Whether a theory covers a surface. This judges the domain, not the error.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Verdict {
    /// Yes, caution or no.
    pub answer: Applies,
    /// Why not simply yes, with the measured numbers.
    pub reasons: Vec<Reason>,
    /// True if the surface itself is the reason, and not the height of some loads.
    pub at_every_load: bool,
}

/// Why a theory covers a surface only with caution, or not at all.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// What the surface is like: steep, with a lay, not Gaussian, or with rows that jump.
    Surface(Fact),
    /// The theory has no meaning for this surface, or something it is made of is absent.
    Refused {
        /// Why.
        error: BuildError,
        /// What a fractal fit gave, if that is what is missing \[-\].
        dimension: Option<f64>,
    },
    /// The input depends on the band that was measured: a dimension on the range that it was fitted over, B_max on how long the
    /// rows of the map are.
    Band {
        /// Dimension of the fit \[-\]; `None` of B_max.
        dimension: Option<f64>,
        /// Shortest wavelength of the fit, or that of B_max (m); `None` if no wave stands out.
        short: Option<f64>,
        /// Longest wavelength of the fit, or length of the rows (m).
        long: f64,
    },
    /// An assumption is strained, or contact is full.
    Strained {
        /// What the model says itself; `None` where summits no longer act alone.
        caveat: Option<Caveat>,
        /// The first mean pressure at which it is (Pa); of summits that at which the area exceeds 5 %.
        from: f64,
    },
    /// The bodies yield, and the theory is of elastic ones.
    Elastic {
        /// The first mean pressure at which its area is more than 2 % too small (Pa).
        from: f64,
        /// By how much at most, relative to the elastic area \[-\].
        most: f64,
        /// True if it is more than 2 % at every load that has both.
        everywhere: bool,
    },
    /// Some loads have no answer.
    NoAnswer {
        /// How many.
        loads: usize,
        /// Of how many.
        of: usize,
    },
}

impl Reason {
    /// True if it depends on the load, and not on the surface alone.
    pub(crate) fn is_by_load(&self) -> bool {
        match self {
            Self::Strained { .. } | Self::NoAnswer { .. } => true,
            Self::Elastic { everywhere, .. } => !everywhere,
            _ => false,
        }
    }
}

/// The answer of a [`Verdict`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Applies {
    /// Within the assumptions.
    Yes,
    /// It answers, but an assumption is strained.
    Caution,
    /// No meaning here.
    No,
}

impl Named for Applies {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Yes, "yes"), (Self::Caution, "caution"), (Self::No, "no")];
}
