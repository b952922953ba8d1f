//! Quantities as people read them on a terminal: three digits, the prefix that fits.

use contact_compare::Hardness;
use contact_report::numbers::{METRES, PASCALS, plain, quantity};

/// A length in metres, such as `1.50 µm`.
pub fn length(metres: f64) -> String {
    plain(&quantity(metres, METRES, 3))
}

/// "−1.20 µm to 2.30 µm"; where three digits cannot tell the ends apart, what lies between them too.
pub fn length_range(low: f64, high: f64) -> String {
    let (from, to) = (length(low), length(high));
    if from == to && high > low {
        return format!("about {from}, {} from lowest to highest", length(high - low));
    }
    format!("{from} to {to}")
}

/// A pressure in pascals, such as `50.0 MPa`.
pub fn pressure(pascals: f64) -> String {
    plain(&quantity(pascals, PASCALS, 3))
}

/// A fraction in percent with three digits.
pub fn percent(fraction: f64) -> String {
    format!("{} %", significant(100.0 * fraction, 3))
}

/// A pure number with so many significant digits, in one word: columns are parted at spaces.
pub fn significant(value: f64, count: i32) -> String {
    let size = value.abs();
    let text = match size {
        0.0 => return "0".to_owned(),
        _ if (1e-3..1e5).contains(&size) => {
            let places = (count - 1 - size.log10().floor() as i32).max(0);
            format!("{value:.*}", places as usize)
        }
        _ => format!("{value:.*e}", count as usize - 1),
    };
    text.strip_prefix('-').map_or_else(|| text.clone(), |rest| format!("−{rest}"))
}

/// Why the hardness is likely a slip.
pub fn unusual_hardness(given: Hardness) -> Option<String> {
    let [low, high] = given.unusual()?.map(pressure);
    Some(format!(
        "solids with this contact modulus have a hardness of about {low} to {high}: is the unit right?"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_about_a_large_offset_show_their_range() {
        let shown = length_range(0.107, 0.107_003_2);
        assert_eq!(shown, "about 107 mm, 3.20 µm from lowest to highest");
    }
}
