//! The leak through the gap, as it is asked for.

use crate::settings::names;
use contact_accuracy::Axis;
use serde::{Deserialize, Serialize};

names! {
    /// Directions of the pressure drop.
    Along {
        /// From the first column to the last.
        X = "x",
        /// From the first row to the last.
        Y = "y",
        /// Each of the two.
        Both = "both",
    }
}

impl Along {
    /// The axes.
    pub fn axes(self) -> &'static [Axis] {
        match self {
            Self::X => &[Axis::X],
            Self::Y => &[Axis::Y],
            Self::Both => &Axis::BOTH,
        }
    }
}

/// What is asked of the leak.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Leak {
    /// Directions of the pressure drop.
    pub along: Along,
    /// The seal and its fluid, for a rate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seal: Option<Seal>,
}

/// A seal and its fluid.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seal {
    /// Viscosity η (Pa s).
    pub viscosity: f64,
    /// Pressure drop Δp (Pa).
    pub pressure_drop: f64,
    /// Length L of the way through the seal (m).
    pub length: f64,
    /// Width W across the flow (m).
    pub width: f64,
}

impl Seal {
    /// Leak rate Q = K W Δp/(12 η L) (m³/s) of a permeability (m³).
    pub fn rate(&self, permeability: f64) -> f64 {
        permeability * self.width * self.pressure_drop / (12.0 * self.viscosity * self.length)
    }
}
