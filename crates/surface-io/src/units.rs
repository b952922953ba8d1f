//! Length units as files write them.

/// Metres per unit of length, or `None` if `unit` is not a length.
///
/// Knows SI prefixes from pico to kilo, both micro signs, "micron(s)", "micrometer", the
/// ångström, inch and mil. A lone `A` is an ampere, not an ångström.
pub(crate) fn metres_per(unit: &str) -> Option<f64> {
    let unit = unit.trim().trim_matches(|c| matches!(c, '[' | ']' | '(' | ')' | '"')).trim();
    Some(match unit {
        "m" => 1.0,
        "dm" => 1e-1,
        "cm" => 1e-2,
        "mm" => 1e-3,
        "um" | "\u{b5}m" | "\u{3bc}m" | "\u{b5}" | "\u{3bc}" => 1e-6,
        "nm" => 1e-9,
        "pm" => 1e-12,
        "km" => 1e3,
        "\u{c5}" | "\u{212b}" => 1e-10,
        _ => match unit.to_lowercase().as_str() {
            "metre" | "meter" | "metres" | "meters" => 1.0,
            "millimetre" | "millimeter" | "millimetres" | "millimeters" => 1e-3,
            "micrometre" | "micrometer" | "micrometres" | "micrometers" | "micron" | "microns" => {
                1e-6
            }
            "nanometre" | "nanometer" | "nanometres" | "nanometers" => 1e-9,
            "ang" | "angstrom" | "angstroms" | "angström" | "ångström" => 1e-10,
            "inch" | "inches" => 0.0254,
            "mil" | "mils" => 25.4e-6,
            _ => return None,
        },
    })
}

/// Splits "12.34 µm" into 12.34 and its unit; the number alone has the unit "".
pub(crate) fn quantity(text: &str) -> Option<(f64, &str)> {
    let text = text.trim();
    let end = text
        .char_indices()
        .take_while(|&(i, c)| {
            c.is_ascii_digit()
                || matches!(c, '.' | '+' | '-')
                || (matches!(c, 'e' | 'E')
                    && text[i + 1..].starts_with(|n: char| n.is_ascii_digit() || "+-".contains(n)))
        })
        .last()
        .map_or(0, |(i, c)| i + c.len_utf8());
    let value: f64 = text[..end].parse().ok()?;
    Some((value, text[end..].trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_micro_signs_and_words() {
        for unit in ["um", "\u{b5}m", "\u{3bc}m", "microns", "Micrometer", "[\u{b5}m]"] {
            assert_eq!(metres_per(unit), Some(1e-6), "{unit}");
        }
        for unit in ["", "V", "A", "deg", "Mm", "MM", "px"] {
            assert_eq!(metres_per(unit), None, "{unit}");
        }
    }

    #[test]
    fn quantities_with_and_without_exponent() {
        assert_eq!(quantity("12.34 \u{b5}m"), Some((12.34, "\u{b5}m")));
        assert_eq!(quantity("1.0e-6 m"), Some((1e-6, "m")));
        assert_eq!(quantity("-3"), Some((-3.0, "")));
        assert_eq!(quantity("5em"), Some((5.0, "em")));
        assert_eq!(quantity("wide"), None);
    }
}
