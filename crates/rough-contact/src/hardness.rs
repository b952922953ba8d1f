//! `--hardness`: what is said of a contact that yields, beside its numbers.

use crate::outcome::Failure;
use crate::text;
use answers::hardness_doubt;
use compare::{BULK_YIELD, Hardness};
use std::fmt::Write as _;

/// Headings of the table.
pub(crate) const HEADINGS: [&str; 2] = ["area at H", "load at H"];

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

/// What stands below the table; `highest` is the largest mean pressure that was solved for (Pa).
pub(crate) fn lines(given: Hardness, highest: f64) -> String {
    let mut out = format!("hardness {}", text::pressure(given.pascals));
    // Writing to a String cannot fail.
    if let Some(ratio) = given.over_elastic() {
        let _ = write!(
            out,
            ": E* g/H = {}; the area of elastic contact holds while that is below about 1",
            text::number(ratio)
        );
    }
    out.push('\n');
    if let Some(doubt) = hardness_doubt(given) {
        let _ = writeln!(out, "check the hardness: {doubt}");
    }
    if highest > BULK_YIELD * given.pascals {
        let _ = writeln!(
            out,
            "beyond {} of the hardness the body yields in its volume, which is not modelled",
            text::percent(BULK_YIELD)
        );
    }
    out + "one hardness at every scale; nothing hardens or piles up; loading only, no friction\n"
}
