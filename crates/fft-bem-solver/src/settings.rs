//! What can be chosen.

use crate::UnknownName;

/// An enum whose variants have names, as people type them and files keep them.
macro_rules! named {
    ($(#[$doc:meta])* $name:ident, $what:literal {
        $($(#[$variant_doc:meta])* $variant:ident = $text:literal),+ $(,)?
    }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[non_exhaustive]
        pub enum $name {
            $($(#[$variant_doc])* #[cfg_attr(feature = "serde", serde(rename = $text))] $variant),+
        }

        impl $name {
            /// Every choice, in the order in which help texts list them.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The name, as typed.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }

        impl std::str::FromStr for $name {
            type Err = UnknownName;

            /// Reads a [name](Self::name).
            fn from_str(found: &str) -> Result<Self, UnknownName> {
                let known = Self::ALL.iter().copied().find(|choice| choice.name() == found);
                known.ok_or_else(|| UnknownName {
                    what: $what,
                    found: found.to_owned(),
                    known: &[$($text),+],
                })
            }
        }
    };
}

named! {
    /// How the contact problem is solved. All methods find the same answer.
    Method, "method" {
        /// The fastest method available for the problem.
        #[default]
        Auto = "auto",
        /// Extension-preconditioned chord iteration: about one FFT pair per step and one digit per
        /// step.
        Chord = "chord",
        /// Constrained conjugate gradients of Polonsky & Keer (1999),
        /// doi:10.1016/S0043-1648(99)00113-1.
        PolonskyKeer = "polonsky-keer",
        /// Steepest descent with redistribution of load, Stanley & Kato (1997),
        /// doi:10.1115/1.2833523.
        StanleyKato = "stanley-kato",
    }
}

named! {
    /// What lies beyond the edges of the map.
    Boundary, "boundary" {
        /// The map repeats without end.
        #[default]
        Periodic = "periodic",
        /// Nothing touches outside the map, and far away the half space is at rest.
        Free = "free",
    }
}

named! {
    /// Floating-point type of the fields during a solve. Results are always `f64`. How small a
    /// tolerance each can reach: [`SolverBuilder::tolerance`](crate::SolverBuilder::tolerance).
    Precision, "precision" {
        /// `f64`.
        #[default]
        Double = "f64",
        /// `f32`: half the memory.
        Single = "f32",
    }
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
