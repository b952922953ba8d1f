//! What a channel is, by its name, and what an entry of a header is, by its key and value. Units do
//! not tell: a cantilever's deflection in metres is no topography.

use crate::units::{metres_per, quantity};

/// Entry of the metadata with what looks like a size, a scale or a unit and was not used.
pub(crate) const UNUSED: &str = "sizes, scales and units not used";

/// True if an entry of a header looks like a size, a scale or a unit: a number with a unit of length, or
/// a key that says so beside a number other than 0 or a unit.
pub(crate) fn is_scale(key: &str, value: &str) -> bool {
    const WORDS: &str = "length width size spacing step pixel scale unit resolution calibration \
                         factor pitch increment interval sampling einheit";
    const NAMES: [&str; 6] = ["dx", "dy", "dz", "px", "res", "sx"];
    let key = key.to_lowercase();
    let says = WORDS.split(' ').any(|word| key.contains(word)) || NAMES.contains(&key.as_str());
    let value = value.replace(',', ".");
    match quantity(&value) {
        Some((number, unit)) => {
            let (length, _) = unit.split_once('/').unwrap_or((unit, ""));
            number != 0.0 && (metres_per(length).is_some() || says && unit.is_empty())
        }
        None => says && metres_per(&value).is_some(),
    }
}

/// Words in names of channels that hold the shape of the surface.
const TOPOGRAPHY: &str = "height|topograph|z-axis|z axis|zsensor|z sensor";

/// Words in names of channels that are lengths and yet no shape: of the cantilever, of its
/// oscillation, of the surface under load, of the measurement's uncertainty.
const OTHER: &str = "deflection|amplitude|error|deformation|indentation|friction|adhesion|lateral|\
                     separation|uncertainty|noise|confidence|intensity";

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
        let has = |words: &str| words.split('|').any(|word| name.contains(word));
        if has(OTHER) {
            Self::Other
        } else if has(TOPOGRAPHY) {
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
    fn sizes_scales_and_units() {
        for (key, value) in [
            ("Lateral calibration", "0.5"),
            ("Auflösung", "0,5 µm"),
            ("Sampling", "500 nm/px"),
            ("My unit", "um"),
            ("Z scale factor", "1e-3"),
        ] {
            assert!(is_scale(key, value), "{key} = {value}");
        }
        for (key, value) in [
            ("Date", "2024-01-01"),
            ("voidpixels", "0"),
            ("File size", "12 bytes"),
            ("Speed", "3.5"),
            ("Unit", "serial 12"),
        ] {
            assert!(!is_scale(key, value), "{key} = {value}");
        }
    }

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
