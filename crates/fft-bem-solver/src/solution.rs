//! The answer and what is known about it.

use crate::{Boundary, Method, Precision};
use contact_types::{ContactState, Grid};

/// A contact at one load.
#[derive(Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Solution {
    /// The grid it was found on.
    pub grid: Grid,
    /// Mean pressure, area fraction, mean gap. The area is the pixels that carry pressure less those that the contact
    /// line cuts, `A - 0.1013 S_d` ([`PERIMETER_CORRECTION`](crate::PERIMETER_CORRECTION)), at least load over
    /// hardness; edges of pixels at the hardness do not count. The gap is 0 in contact with a free boundary, and at the
    /// hardness with any.
    pub state: ContactState,
    /// How far the flat has moved since it touched the highest point (m): periodic towards the mean plane of the
    /// deformed surface, free towards points far away.
    pub approach: f64,
    /// Pressure (Pa), row-major, `ny * nx`; 0 outside the contact. Empty if [`Maps`](crate::Maps) says so.
    pub pressure: Vec<f64>,
    /// Gap (m), likewise, its pressure-weighted mean 0. In contact it is the residual of the iteration; where the
    /// pressure is the [hardness](crate::SolverBuilder::hardness), minus the depth by which the surface was flattened.
    pub gap: Vec<f64>,
    /// Mean gap (m) of blocks, at most 32 along each side, row-major behind their shape; in contact it counts as 0.
    pub coarse_gap: ([usize; 2], Vec<f64>),
    /// How the answer was found and how accurate it is.
    pub diagnostics: Diagnostics,
}

impl Solution {
    /// Pixels that carry pressure over all pixels: more than the area, by what the contact line cuts.
    pub fn touching_fraction(&self) -> f64 {
        self.diagnostics.contact_pixels as f64 / self.grid.len() as f64
    }

    /// The gap (m) where nothing touches, 0 elsewhere: its mean is the mean gap. Empty without both maps.
    pub fn open_gap(&self) -> Vec<f64> {
        let points = self.gap.iter().zip(&self.pressure);
        points.map(|(gap, pressure)| if *pressure > 0.0 { 0.0 } else { gap.max(0.0) }).collect()
    }
}

impl std::fmt::Debug for Solution {
    /// Everything but the maps.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Solution")
            .field("grid", &self.grid)
            .field("state", &self.state)
            .field("approach", &self.approach)
            .field("diagnostics", &self.diagnostics)
            .finish_non_exhaustive()
    }
}

/// How far an iterate is from solving the problem; all are 0 for an exact solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Residuals {
    /// Estimate of the relative rms error of the pressure: what the tolerance is compared with.
    pub preconditioned: f64,
    /// `sum p |g|` over `sum p` times the range of the heights.
    pub complementarity: f64,
    /// Deepest overlap (most negative gap) over the range of the heights.
    pub penetration: f64,
}

/// What has yielded, where a [hardness](crate::SolverBuilder::hardness) was given.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Yielded {
    /// Highest pressure the surface bears anywhere (Pa).
    pub hardness: f64,
    /// Fraction of all pixels whose pressure is the hardness, not corrected for the contact line.
    pub area_fraction: f64,
    /// Part of the load that they carry.
    pub load_share: f64,
}

/// How an iteration ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum End {
    /// The estimated error is within the tolerance.
    Converged,
    /// Rounding keeps it from falling to the tolerance.
    Rounding,
    /// The iteration limit was reached first.
    Exhausted,
    /// The observer stopped it.
    Stopped,
}

/// How an answer was found and how accurate it is.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Diagnostics {
    /// The method that found it; never [`Method::Auto`].
    pub method: Method,
    /// What lay beyond the edges.
    pub boundary: Boundary,
    /// Floating-point type of the iteration.
    pub precision: Precision,
    /// `Some` if the answer is exact without iterating, and why.
    pub exact: Option<&'static str>,
    /// Whether the tolerance was reached, and if not, why.
    pub end: End,
    /// Iterations done.
    pub iterations: usize,
    /// FFT convolutions (a forward and an inverse transform) of the whole map, coarser ones in proportion.
    pub transforms: f64,
    /// What is left of the conditions of contact.
    pub residuals: Residuals,
    /// Upper bound of the energy error per nominal area, `mean p (g - min g)` (J/m²), and with a hardness H
    /// `mean (p max(g, 0) + (H - p) max(-g, 0))`. Rigorous but loose.
    pub duality_gap: f64,
    /// Rigorous and tight bound of the relative error in the energy norm, if [asked](crate::SolverBuilder::certified)
    /// for.
    pub energy_bound: Option<f64>,
    /// Wall-clock time (s).
    pub seconds: f64,
    /// Pixels that carry pressure.
    pub contact_pixels: usize,
    /// Edges between contact and gap (4-neighbour) per pixel, S_d (-); the edge of a free map is none.
    pub contact_perimeter: f64,
    /// If a hardness was given.
    pub yielded: Option<Yielded>,
    /// Highest pressure of a pixel (Pa): a grid quantity.
    pub max_pressure: f64,
    /// Elastic energy per nominal area, `mean p u / 2` (J/m²); periodic: without the uniform compression.
    pub elastic_energy: f64,
}
