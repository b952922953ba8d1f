//! What a channel is, by its name. Units do not tell: a cantilever's deflection in metres is no
//! topography.

/// Words in names of channels that hold the shape of the surface.
const TOPOGRAPHY: [&str; 6] = ["height", "topograph", "z-axis", "z axis", "zsensor", "z sensor"];

/// Words in names of channels that are lengths and yet no shape: of the cantilever, of its
/// oscillation, of the surface under load, of the measurement's uncertainty.
const OTHER: [&str; 13] = [
    "deflection",
    "amplitude",
    "error",
    "deformation",
    "indentation",
    "friction",
    "adhesion",
    "lateral",
    "separation",
    "uncertainty",
    "noise",
    "confidence",
    "intensity",
];

/// Ordered: a topography is preferred.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Meaning {
    Topography,
    Unknown,
    Other,
}

impl Meaning {
    pub(crate) fn of(name: &str) -> Self {
        let name = name.to_lowercase();
        let has = |words: &[&str]| words.iter().any(|word| name.contains(word));
        if has(&OTHER) {
            Self::Other
        } else if has(&TOPOGRAPHY) {
            Self::Topography
        } else {
            Self::Unknown
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_real_files() {
        for name in
            ["Z-Axis (Scan forward)", "ZSensor", "Height Sensor", "Topography", "height (retrace)"]
        {
            assert_eq!(Meaning::of(name), Meaning::Topography, "{name}");
        }
        for name in ["Deflection (Scan forward)", "Height Error", "Peak Force Error", "Deformation"]
        {
            assert_eq!(Meaning::of(name), Meaning::Other, "{name}");
        }
        assert_eq!(Meaning::of("Layer 1"), Meaning::Unknown);
    }
}
