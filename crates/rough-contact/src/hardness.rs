//! `--hardness`: what is said of a contact that yields, beside its numbers.

use crate::outcome::Failure;
use crate::text;
use compare::typical_hardness;
use fft_bem_solver::{Solution, Yielded};
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Keys of a point.
const KEYS: [&str; 3] = ["saturated_fraction", "plastic_load_fraction", "elastic_area_fraction"];

/// Headings of the table.
pub(crate) const HEADINGS: [&str; 2] = ["area at H", "load at H"];

/// By how much a hardness may leave the range of solids before it is called a mistake.
const NONSENSE: f64 = 10.0;

/// Mean pressure over hardness beyond which a ceiling of the pressure is no model of a metal.
const BULK: f64 = 0.3;

/// A hardness, and what it is pressed with.
#[derive(Clone, Copy)]
pub(crate) struct Given {
    pub(crate) hardness: f64,
    pub(crate) modulus: f64,
    /// Rms gradient of the map.
    pub(crate) gradient: Option<f64>,
}

/// A hardness that no pressure is held to is refused before anything is read.
pub(crate) fn check(hardness: Option<f64>) -> Result<(), Failure> {
    match hardness {
        Some(h) if !(h > 0.0 && h.is_finite()) => {
            let message = format!(
                "--hardness {h} Pa: a hardness is a pressure above 0 Pa, for example 2GPa; leave it \
                 out for elastic contact"
            );
            Err(Failure::refused("hardness", message))
        }
        _ => Ok(()),
    }
}

impl Given {
    /// E* g/H.
    fn over_elastic(&self) -> Option<f64> {
        self.gradient.map(|g| self.modulus * g / self.hardness)
    }

    /// Why the hardness is likely a slip.
    fn doubt(&self) -> Option<String> {
        let [low, high] = typical_hardness(self.modulus)?;
        let beyond = self.hardness < low / NONSENSE || self.hardness > high * NONSENSE;
        beyond.then(|| {
            format!(
                "solids with this contact modulus have a hardness of about {} to {}: is the unit \
                 right?",
                text::pressure(low),
                text::pressure(high)
            )
        })
    }

    /// What stands beside the points.
    pub(crate) fn json(&self) -> Value {
        json!({
            "pascals": self.hardness,
            "modulus_gradient_over_hardness": self.over_elastic(),
            "warning": self.doubt(),
        })
    }

    /// What stands below the table; `highest` is the largest mean pressure that was solved for (Pa).
    pub(crate) fn lines(&self, highest: f64) -> String {
        let mut out = format!("hardness {}", text::pressure(self.hardness));
        // Writing to a String cannot fail.
        if let Some(ratio) = self.over_elastic() {
            let _ = write!(
                out,
                ": E* g/H = {}; the area of elastic contact holds while that is below about 1",
                text::number(ratio)
            );
        }
        out.push('\n');
        if let Some(doubt) = self.doubt() {
            let _ = writeln!(out, "check the hardness: {doubt}");
        }
        if highest > BULK * self.hardness {
            let _ = writeln!(
                out,
                "beyond {} of the hardness the body yields in its volume, which is not modelled",
                text::percent(BULK)
            );
        }
        out + "one hardness at every scale; nothing hardens or piles up; loading only, no friction\n"
    }
}

/// Adds what has yielded to a point and its row.
pub(crate) fn add(point: &mut Value, cells: &mut Vec<String>, solution: &Solution) {
    let Some(Yielded { area_fraction, load_share, .. }) = solution.diagnostics.yielded else {
        return;
    };
    // Rounded sums: no area is below 0.
    let elastic = (solution.state.area_fraction - area_fraction).max(0.0);
    for (key, value) in KEYS.into_iter().zip([area_fraction, load_share, elastic]) {
        point[key] = json!(value);
    }
    cells.extend([area_fraction, load_share].map(text::percent));
}

/// The same keys, absent, in a point that was refused.
pub(crate) fn complete(point: &mut Value) {
    for key in KEYS {
        if point.get(key).is_none() {
            point[key] = Value::Null;
        }
    }
}
