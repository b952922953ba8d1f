//! Quantities as people read them: three digits, the prefix that fits.

/// SI prefixes that people use for these quantities.
const PREFIXES: &[(f64, &str)] = &[
    (1e12, "T"),
    (1e9, "G"),
    (1e6, "M"),
    (1e3, "k"),
    (1.0, ""),
    (1e-3, "m"),
    (1e-6, "µ"),
    (1e-9, "n"),
    (1e-12, "p"),
];

/// A length in metres, such as `1.50 µm`.
pub fn length(metres: f64) -> String {
    with_prefix(metres, "m", 1e3)
}

/// "−1.20 µm to 2.30 µm"; where three digits cannot tell the ends apart, what lies between them too.
pub fn length_range(low: f64, high: f64) -> String {
    let (from, to) = (length(low), length(high));
    if from == to && high > low {
        return format!("about {from}, {} from lowest to highest", length(high - low));
    }
    format!("{from} to {to}")
}

/// An area in square metres, such as `2.00 mm²`.
pub fn area(square_metres: f64) -> String {
    let side = square_metres.sqrt();
    let (scale, prefix) = PREFIXES
        .iter()
        .copied()
        .find(|(scale, _)| side >= *scale && *scale <= 1.0)
        .unwrap_or((1e-12, "p"));
    format!("{} {prefix}m²", number(square_metres / (scale * scale)))
}

/// A force in newtons, such as `10.0 N`.
pub fn force(newtons: f64) -> String {
    with_prefix(newtons, "N", 1e13)
}

/// A pressure in pascals, such as `50.0 MPa`.
pub fn pressure(pascals: f64) -> String {
    with_prefix(pascals, "Pa", 1e13)
}

/// Seconds, such as `1.20 ms`.
pub fn seconds(seconds: f64) -> String {
    with_prefix(seconds, "s", 1e3)
}

/// A fraction in percent with three digits.
pub fn percent(fraction: f64) -> String {
    format!("{} %", digits(100.0 * fraction))
}

/// A stiffness per area, such as `1.23e13 Pa/m`.
pub fn stiffness(pascals_per_metre: f64) -> String {
    format!("{pascals_per_metre:.2e} Pa/m")
}

/// The ends between which a number lies, as a share of it where they are even, such as `±2.1 %`; a dash where there
/// are none, and what is known where one of them is not.
pub fn relative(value: f64, ends: Option<[f64; 2]>, shown: impl Fn(f64) -> String) -> String {
    let Some([low, high]) = ends.filter(|_| value > 0.0) else { return "–".to_owned() };
    match (low > 0.0, high.is_finite()) {
        (false, false) => "–".to_owned(),
        (false, true) => format!("at most {}", shown(high)),
        (true, false) => format!("at least {}", shown(low)),
        (true, true) => plain(&contact_report::numbers::relative_interval(value, [low, high])),
    }
}

/// With the spaces of a terminal.
fn plain(text: &str) -> String {
    text.replace(contact_report::numbers::SPACE, " ")
}

/// The highest pressure of a point. The mean over the contact cannot exceed it: where it seems to,
/// the contacts are smaller than the points.
pub fn highest(highest: f64, mean: Option<f64>) -> String {
    match mean {
        Some(mean) if mean > highest => format!("above {}", pressure(mean)),
        _ => pressure(highest),
    }
}

/// A pure number with four significant digits.
pub fn number(value: f64) -> String {
    significant(value, 4)
}

fn with_prefix(value: f64, unit: &str, largest: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return format!("0 {unit}");
    }
    let prefix = PREFIXES.iter().find(|(scale, _)| *scale <= largest && size >= 0.9999 * scale);
    match prefix {
        Some((scale, prefix)) if size < 1e4 * scale => {
            format!("{} {prefix}{unit}", digits(value / scale))
        }
        _ => minus(format!("{value:.2e} {unit}")),
    }
}

/// Three significant digits without a power of ten between 0.001 and 10 000.
pub fn digits(value: f64) -> String {
    significant(value, 3)
}

fn significant(value: f64, count: i32) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".to_owned();
    }
    if !(1e-3..1e5).contains(&size) {
        return minus(format!("{value:.*e}", count as usize - 1));
    }
    let places = (count - 1 - size.log10().floor() as i32).max(0);
    minus(format!("{value:.*}", places as usize))
}

/// The true minus sign in text for people.
fn minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_as_people_write_them() {
        assert_eq!(length(1.5e-6), "1.50 µm");
        assert_eq!(length(-3.21e-8), "−32.1 nm");
        assert_eq!(length(0.0), "0 m");
        assert_eq!(length(1e-3), "1.00 mm");
        assert_eq!(length(2e-15), "2.00e-15 m");
        assert_eq!(pressure(5e7), "50.0 MPa");
        assert_eq!(pressure(1.1e11), "110 GPa");
        assert_eq!(percent(0.0196), "1.96 %");
        assert_eq!(number(2.50663), "2.507");
        assert_eq!(length_range(-1.2e-6, 2.3e-6), "−1.20 µm to 2.30 µm");
    }

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

    #[test]
    fn the_highest_pressure_is_never_below_the_mean() {
        assert_eq!(highest(100e6, Some(190e6)), "above 190 MPa");
        assert_eq!(highest(300e6, Some(190e6)), "300 MPa");
        assert_eq!(highest(300e6, None), "300 MPa");
    }
}
