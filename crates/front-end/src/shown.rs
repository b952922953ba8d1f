//! Quantities as people read them on a terminal: three digits, the prefix that fits.

use contact_compare::Hardness;
use contact_report::numbers::{METRES, PASCALS, plain, quantity, relative_interval};

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

/// The ends between which a number lies, as a share of it where they are even, such as `±2.1 %`; a dash where there
/// are none, and what is known where one of them is not.
pub fn relative(value: f64, ends: Option<[f64; 2]>, shown: impl Fn(f64) -> String) -> String {
    let Some([low, high]) = ends.filter(|_| value > 0.0) else { return "–".to_owned() };
    match (low > 0.0, high.is_finite()) {
        (false, false) => "–".to_owned(),
        (false, true) => format!("at most {}", shown(high)),
        (true, false) => format!("at least {}", shown(low)),
        (true, true) => plain(&relative_interval(value, [low, high])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_about_a_large_offset_show_their_range() {
        let shown = length_range(0.107, 0.107_003_2);
        assert_eq!(shown, "about 107 mm, 3.20 µm from lowest to highest");
    }

    #[test]
    fn a_bar_that_reaches_zero_is_one_sided() {
        assert_eq!(relative(0.012, Some([0.0, 0.028]), percent), "at most 2.80 %");
        assert_eq!(relative(0.01, Some([0.009, 0.011]), percent), "±10 %");
        assert_eq!(relative(0.01, None, percent), "–");
        assert_eq!(relative(35e9, Some([20e9, 166e9]), pressure), "−43 to +374 %");
        assert_eq!(relative(35e9, Some([20e9, f64::INFINITY]), pressure), "at least 20.0 GPa");
    }
}
