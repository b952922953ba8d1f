//! What can be chosen.

use contact_types::Named;

/// How the contact problem is solved. All methods find the same answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Method {
    /// [`Chord`](Self::Chord), the fastest.
    #[default]
    Auto,
    /// Extension-preconditioned chord iteration: about one FFT convolution and one digit per step.
    Chord,
    /// Constrained conjugate gradients of Polonsky & Keer (1999),
    /// doi:10.1016/S0043-1648(99)00113-1.
    PolonskyKeer,
    /// Steepest descent with redistribution of load, Stanley & Kato (1997),
    /// doi:10.1115/1.2833523.
    StanleyKato,
}

impl Named for Method {
    const NAMES: &'static [(Self, &'static str)] = &[
        (Self::Auto, "auto"),
        (Self::Chord, "chord"),
        (Self::PolonskyKeer, "polonsky-keer"),
        (Self::StanleyKato, "stanley-kato"),
    ];
}

/// What lies beyond the edges of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Boundary {
    /// The map repeats without end.
    #[default]
    Periodic,
    /// Nothing touches outside the map, and far away the half space is at rest.
    Free,
}

impl Named for Boundary {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Periodic, "periodic"), (Self::Free, "free")];
}

/// Floating-point type of the fields during a solve. Results are always `f64`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Precision {
    /// `f64`.
    #[default]
    #[cfg_attr(feature = "serde", serde(rename = "f64"))]
    Double,
    /// `f32`: half the memory; with the feature `single`.
    #[cfg_attr(feature = "serde", serde(rename = "f32"))]
    Single,
}

impl Named for Precision {
    const NAMES: &'static [(Self, &'static str)] = &[(Self::Double, "f64"), (Self::Single, "f32")];
}

/// Which maps a solution carries, at 8 bytes per pixel each; its numbers do not need them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
#[non_exhaustive]
pub enum Maps {
    /// None: both fields are empty.
    None,
    /// The pressure; the gap is empty.
    Pressure,
    /// Pressure and gap.
    #[default]
    PressureAndGap,
}

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Load {
    /// Force over nominal area (Pa), at least 0.
    MeanPressure(f64),
    /// Mean gap after deformation (m), at least 0; periodic boundary only. A gap wider than that
    /// at first touch leaves the surfaces apart.
    MeanGap(f64),
}
