//! Facts about profiles, as numbers.

use serde::{Deserialize, Serialize};

/// How uneven the points of a file were before they were put at equal distances.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Unevenness {
    /// Shortest and longest distance of neighbouring points (m).
    pub steps: [f64; 2],
    /// Their distance now (m).
    pub spacing: f64,
}

/// What was found of profiles, with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ProfileFact {
    /// One direction was measured; the models are of isotropic surfaces.
    OneDirection,
    /// What the length and number of the traces leave open.
    Sample {
        /// How many traces.
        traces: usize,
        /// Length of each (m).
        length: f64,
        /// Relative 95 % factors of m0, m2, m4: a moment times or divided by it; `None` where the
        /// traces hold too few waves to tell.
        factors: [Option<f64>; 3],
        /// Relative standard deviations from trace to trace, of two or more.
        between: Option<[f64; 3]>,
    },
    /// The points were put at equal distances.
    Uneven(Unevenness),
    /// No parameters of roughness.
    NoRoughness {
        /// Why not, as the statistics refuse it.
        why: String,
    },
    /// The cut-off that Ra asks for is longer than the traces allow.
    CoarserClass {
        /// λc that was used (m).
        cutoff: f64,
        /// Ra with it (m).
        ra: f64,
        /// Length of the traces (m).
        length: f64,
    },
    /// λs was left out.
    NoShort {
        /// λs (m).
        short: f64,
        /// Spacing of the points (m).
        spacing: f64,
    },
    /// The longest waves are not in the traces.
    NoRolloff {
        /// Length of the traces (m).
        length: f64,
    },
}
