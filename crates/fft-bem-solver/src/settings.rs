//! What can be chosen.

/// How the contact problem is solved. All methods find the same answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Method {
    /// The fastest method available for the problem.
    #[default]
    Auto,
    /// Extension-preconditioned chord iteration: about one FFT pair per step and one digit per
    /// step.
    Chord,
    /// Constrained conjugate gradients of Polonsky & Keer (1999), doi:10.1016/S0043-1648(99)00113-1.
    PolonskyKeer,
    /// Steepest descent with redistribution of load, Stanley & Kato (1997),
    /// doi:10.1115/1.2833523.
    StanleyKato,
}

impl std::fmt::Display for Method {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Auto => "auto",
            Self::Chord => "chord",
            Self::PolonskyKeer => "polonsky-keer",
            Self::StanleyKato => "stanley-kato",
        })
    }
}

/// What lies beyond the edges of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Boundary {
    /// The map repeats without end.
    #[default]
    Periodic,
    /// Nothing touches outside the map, and far away the half space is at rest.
    Free,
}

/// Floating-point type of the fields during a solve. Results are always `f64`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// `f64`: any tolerance down to rounding, about 1e-12.
    #[default]
    Double,
    /// `f32`: half the memory; tolerances down to about 1e-5.
    Single,
}

/// Which maps a solution carries, at 8 bytes per pixel each. The numbers of a solution do not need
/// them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
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
pub enum Load {
    /// Force over nominal area (Pa), at least 0.
    MeanPressure(f64),
    /// Mean gap after deformation (m), at least 0; periodic boundary only. A gap wider than that
    /// at first touch leaves the surfaces apart.
    MeanGap(f64),
    /// How far the flat has moved towards the body since it touched the highest point (m). In a
    /// periodic problem the distance is measured to the mean plane of the deformed surface, in a
    /// free one to points far away.
    Approach(f64),
}
