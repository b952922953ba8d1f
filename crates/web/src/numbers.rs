//! Numbers as the page says them.

use contact_report::numbers::{METRES, PASCALS, chosen, fixed, quantity};

pub(crate) fn length(metres: f64) -> String {
    quantity(metres, METRES, 3)
}

/// A pressure (Pa), as somebody would choose it.
pub(crate) fn pressure(pascals: f64) -> String {
    chosen(pascals, PASCALS)
}

pub(crate) fn count(number: usize) -> String {
    fixed(number as f64, 0)
}
