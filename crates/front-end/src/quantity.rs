//! Quantities as a person types them: `110GPa`, `1.5um`, `0.2nm^2`, `3e12m^-2`, and lists such
//! as `1MPa,2MPa` or `1kPa..1GPa:16`. Everything comes out in SI units.
//!
//! A bare number where a unit is needed is refused: 50 could be pascals or megapascals.

use crate::failure::Failure;
use crate::units::{Dimension, Spelling, plain};
use contact_accuracy::round_to_digits;

/// Most points a range may ask for.
const MAX_POINTS: usize = 100_000;

/// Reads one quantity, in SI units. The decimal number is scaled by its power of ten before it
/// is rounded to a double, so `0.2nm^2` is the double nearest to 2e-19.
///
/// # Errors
/// [`Failure`], whose message says how to write it.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, Failure> {
    let text = text.trim();
    let (number, unit) = text.split_at(number_length(text));
    if number.is_empty() {
        let bare = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
        return Err(if bare.starts_with("nan") || bare.starts_with("inf") {
            not_finite(text, dimension)
        } else {
            let example = dimension.spelling().example;
            let message = format!("'{text}' is not a number; write {example}");
            Failure::refused("not_a_number", message)
        });
    }
    let unit = plain(unit);
    let (factor, exponent) = dimension.scale(&unit).ok_or_else(|| {
        if unit.strip_prefix(',').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
        {
            decimal_comma(text)
        } else if unit.is_empty() {
            missing_unit(number, dimension)
        } else if dimension == Dimension::Number {
            let message = format!("'{text}' has a unit, but this is a pure number; write {number}");
            Failure::refused("unexpected_unit", message)
        } else {
            unknown(&unit, dimension)
        }
    })?;
    let value = in_si(number, factor, exponent);
    if !value.is_finite() {
        return Err(not_finite(text, dimension));
    }
    let mantissa = number.split(['e', 'E']).next().unwrap_or_default();
    if value.abs() < f64::from_bits(1) && mantissa.contains(|c: char| ('1'..='9').contains(&c)) {
        let message =
            format!("'{text}' is smaller than the smallest number a double can hold, 4.9e-324");
        return Err(Failure::refused("too_small", message));
    }
    Ok(value)
}

/// Reads a comma-separated list whose items are quantities or ranges `FIRST..LAST:COUNT`,
/// spaced evenly in the logarithm, ends included. The order is kept.
///
/// # Errors
/// [`Failure`], whose message says how to write it.
pub fn parse_list(text: &str, dimension: Dimension) -> Result<Vec<f64>, Failure> {
    let mut values = Vec::new();
    for item in text.split(',') {
        match item.split_once("..") {
            // "1,5um": the comma was meant to be the decimal mark.
            None => values.push(parse(item, dimension).map_err(|error| {
                let is_comma = error.kind == "missing_unit" && is_decimal_comma(text);
                if is_comma { decimal_comma(text) } else { error }
            })?),
            Some((first, tail)) => values.extend(range(item, first, tail, dimension)?),
        }
    }
    Ok(values)
}

/// Reads a unit of length standing alone, as metres per unit: `um` is 1e-6.
///
/// # Errors
/// [`Failure`] of another unit.
pub fn parse_length_unit(text: &str) -> Result<f64, Failure> {
    let unit = plain(text);
    let dimension = Dimension::Length;
    match dimension.scale(&unit) {
        Some((factor, exponent)) => Ok(in_si("1", factor, exponent)),
        None => Err(unknown(&unit, dimension)),
    }
}

fn range(item: &str, first: &str, tail: &str, dimension: Dimension) -> Result<Vec<f64>, Failure> {
    let fault = |fault| {
        let (text, example) = (item.trim(), dimension.spelling().range);
        let message = format!(
            "'{text}' is no range ({fault}); write FIRST..LAST:COUNT, for example {example}"
        );
        Failure::refused("range", message)
    };
    let (last, count) = tail.split_once(':').ok_or(fault("the number of points is missing"))?;
    let (first, last) = (parse(first, dimension)?, parse(last, dimension)?);
    let count: usize = count.trim().parse().map_err(|_| fault("the count is no whole number"))?;
    if !(2..=MAX_POINTS).contains(&count) {
        return Err(fault("the count must be from 2 to 100000"));
    }
    if first <= 0.0 || last <= 0.0 {
        return Err(fault("both ends of a logarithmic range must be greater than 0"));
    }
    let step = |i: usize| match i {
        0 => first,
        i if i + 1 == count => last,
        i => {
            let t = i as f64 / (count - 1) as f64;
            round_to_digits((first.ln() * (1.0 - t) + last.ln() * t).exp(), 13) // so that the decades of a range are the decades
        }
    };
    Ok((0..count).map(step).collect())
}

/// Length in bytes of the decimal number at the start of `text`; 0 if there is none.
fn number_length(text: &str) -> usize {
    let other = |c: char| !(c.is_ascii_digit() || "+-.eE".contains(c));
    let longest = text.find(other).unwrap_or(text.len());
    let is_number = |end: &usize| {
        let ends_so = text[..*end].ends_with(|c: char| c.is_ascii_digit() || c == '.');
        ends_so && text[..*end].parse::<f64>().is_ok()
    };
    (1..=longest).rev().find(is_number).unwrap_or(0)
}

/// True for two items of which the first has no unit and the second starts with a digit.
fn is_decimal_comma(text: &str) -> bool {
    let Some((whole, rest)) = text.split_once(',') else { return false };
    let whole = whole.trim().trim_start_matches(['+', '-']);
    !rest.contains(',')
        && !whole.is_empty()
        && whole.bytes().all(|b| b.is_ascii_digit())
        && rest.starts_with(|c: char| c.is_ascii_digit())
        && rest.contains(|c: char| c.is_alphabetic())
}

fn not_finite(text: &str, dimension: Dimension) -> Failure {
    let example = dimension.spelling().example;
    Failure::refused("not_finite", format!("'{text}' is not a finite number; write {example}"))
}

fn unknown(unit: &str, dimension: Dimension) -> Failure {
    let Spelling { kind, si, units, .. } = dimension.spelling();
    let meant = match dimension.near(unit)[..] {
        [] => {
            let message = format!("'{unit}' is not a unit of {kind}; write {units}");
            return Failure::refused("unknown_unit", message);
        }
        [only] => only.to_owned(),
        ref several => {
            let sized = |name: &&str| {
                let (factor, exponent) = dimension.scale(name).unwrap_or((1.0, 0));
                let size = in_si("1", factor, exponent);
                format!("{name} ({size:e} {si})")
            };
            several.iter().map(sized).collect::<Vec<_>>().join(" or ")
        }
    };
    let message = format!("'{unit}' is not a unit of {kind}; did you mean {meant}?");
    Failure::refused("misspelt", message)
}

/// The decimal mark is the point; the comma separates the items of a list.
fn decimal_comma(text: &str) -> Failure {
    let meant = text.replacen(',', ".", 1);
    Failure::refused("decimal_comma", format!("'{text}' has a decimal comma; write {meant}"))
}

/// `number` in a unit of `factor` times ten to the `exponent`: rounded once if the factor is 1, and
/// as rarely as can be otherwise.
fn in_si(number: &str, factor: f64, exponent: i32) -> f64 {
    if factor.to_bits() == 1.0f64.to_bits() {
        scaled(number, exponent)
    } else if exponent < 0 {
        // A whole factor and a power of ten are exact: 1 inch is the double nearest to 0.0254.
        scaled(number, 0) * factor / 10f64.powi(-exponent)
    } else {
        scaled(number, exponent) * factor
    }
}

/// `number` times ten to the `exponent`, rounded once.
fn scaled(number: &str, exponent: i32) -> f64 {
    let (mantissa, own) = match number.split_once(['e', 'E']) {
        // An exponent too long for an integer is beyond every double, up or down.
        Some((mantissa, own)) => {
            let limit = if own.starts_with('-') { -99_999 } else { 99_999 };
            (mantissa, own.parse().unwrap_or(limit).clamp(-99_999, 99_999))
        }
        None => (number, 0),
    };
    format!("{mantissa}e{}", own + exponent).parse().unwrap_or(f64::NAN)
}

fn missing_unit(number: &str, dimension: Dimension) -> Failure {
    let units = dimension.spelling().suggested.split(' ');
    let suggestion = units.map(|unit| format!("{number}{unit}")).collect::<Vec<_>>().join(" or ");
    let message = format!("'{number}' has no unit; write for example {suggestion}");
    Failure::refused("missing_unit", message)
}

#[cfg(test)]
mod tests {
    use super::*;
    use Dimension::{Area, Force, Length, Number, PerArea, Pressure};

    /// The doubles on the right are what the compiler makes of the decimal: correctly rounded.
    #[test]
    #[allow(clippy::float_cmp, reason = "parsing must be exact")]
    fn resistivities_and_conductivities() {
        for text in ["22nohm.m", "22 nΩ m", "22nΩ·m", "2.2uohm.cm", "22nohm*m", "2.2e-8 Ω·m"] {
            assert_eq!(parse(text, Dimension::Resistivity), Ok(2.2e-8), "{text}");
        }
        for text in ["50W/m/K", "50 W/(m·K)", "50 W/mK", "50W/(m K)"] {
            assert_eq!(parse(text, Dimension::Conductivity), Ok(50.0), "{text}");
        }
        for text in ["22ohm", "22ohm/m", "5W/K", "5"] {
            assert!(parse(text, Dimension::Resistivity).is_err(), "{text}");
            assert!(parse(text, Dimension::Conductivity).is_err(), "{text}");
        }
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "parsing must be exact")]
    fn quantities_are_the_nearest_doubles() {
        for (text, dimension, expected) in [
            ("110GPa", Pressure, 110e9),
            ("1.5um", Length, 1.5e-6),
            ("1.5 µm", Length, 1.5e-6),
            ("0.2nm^2", Area, 2e-19),
            ("0.3um²", Area, 0.3e-12),
            ("3e12m^-2", PerArea, 3e12),
            ("3/um^2", PerArea, 3e12),
            ("2.5mm⁻²", PerArea, 2.5e6),
            ("-0.7e-3nm", Length, -0.7e-12),
            ("7e2N/mm^2", Pressure, 7e8),
            ("3bar", Pressure, 3e5),
            ("4.9e-324Pa", Pressure, 4.9e-324),
            ("0.8", Number, 0.8),
            ("2%", Number, 0.02),
            (".5", Number, 0.5),
            ("0Pa", Pressure, 0.0),
            ("0e-999Pa", Pressure, 0.0),
            ("1e-3m", Length, 1e-3),
            ("5A", Length, 5e-10),
            ("5 \u{c5}", Length, 5e-10),
            ("3microns", Length, 3e-6),
            ("1inch", Length, 0.0254),
            ("2mil", Length, 50.8e-6),
            ("7um2", Area, 7e-12),
            ("3e12m-2", PerArea, 3e12),
            ("210N/mm2", Pressure, 2.1e8),
            ("1kgf/mm2", Pressure, 9_806_650.0),
            ("2inches", Length, 0.0508),
            ("5mils", Length, 127e-6),
            ("3angstrom", Length, 3e-10),
            ("10N", Force, 10.0),
            ("2.5 kN", Force, 2500.0),
            ("3µN", Force, 3e-6),
            ("1kgf", Force, 9.80665),
        ] {
            assert_eq!(parse(text, dimension).unwrap(), expected, "{text}");
        }
    }

    /// NIST SP 811 (2008), appendix B.8: 1 psi = 6.894 757 kPa, 1 ksi = 6.894 757 MPa.
    #[test]
    fn pounds_on_square_inches() {
        assert!((parse("1psi", Pressure).unwrap() / 6894.757 - 1.0).abs() < 1e-7);
        assert!((parse("30ksi", Pressure).unwrap() / 30.0 / 6_894_757.0 - 1.0).abs() < 1e-7);
        // 1 lbf = 4.448 222 N.
        assert!((parse("1lbf", Force).unwrap() / 4.448_222 - 1.0).abs() < 1e-7);
        assert!((parse("1in^2", Area).unwrap() / 6.4516e-4 - 1.0).abs() < 1e-15);
        assert!((parse("1in^-2", PerArea).unwrap() * 6.4516e-4 - 1.0).abs() < 1e-15);
    }

    #[test]
    fn slips_of_the_finger_are_named() {
        for (text, dimension, part) in [
            ("110Gpa", Pressure, "did you mean GPa?"),
            ("5Mpa", Pressure, "did you mean MPa?"),
            // A factor of 10⁹ lies between the two: the hint says so.
            ("5mn", Force, "did you mean MN (1e6 N) or mN (1e-3 N)?"),
            ("5Mn", Force, "did you mean MN?"),
            ("5KSI", Pressure, "did you mean ksi?"),
            ("3MM", Length, "did you mean mm?"),
            ("1,5um", Length, "write 1.5um"),
            ("10Lb", Force, "did you mean lbf?"),
            ("10n", Force, "did you mean N?"),
            ("300kg/mm2", Pressure, "did you mean kgf/mm^2?"),
            ("10kPsi", Pressure, "did you mean ksi?"),
            ("110", Pressure, "110MPa or 110GPa"),
            ("1.5", Length, "1.5um or 1.5nm"),
            ("3um", Pressure, "Pa, kPa, MPa"),
            ("3um", Area, "um^2"),
            ("10MPa", Force, "N, kN, mN"),
            ("3furlong", Length, "m, mm, um"),
            ("0.8m", Number, "write 0.8"),
            ("infPa", Pressure, "not a finite number"),
            ("1e400Pa", Pressure, "not a finite number"),
            ("1e99999999999999999999Pa", Pressure, "not a finite number"),
            ("1e-400Pa", Pressure, "smaller than the smallest"),
            ("", Length, "1.5um"),
            ("um", Length, "1.5um"),
            ("--json", Pressure, "50MPa"),
        ] {
            let message = parse(text, dimension).unwrap_err().to_string();
            assert!(message.contains(part), "{text}: {message}");
        }
        let message = parse_list("1,5MPa", Pressure).unwrap_err().to_string();
        assert!(message.contains("decimal comma") && message.contains("1.5MPa"), "{message}");
        assert!(parse_list("1,5MPa,6MPa", Pressure).unwrap_err().to_string().contains("no unit"));
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "the decades of a range are meant to be exact")]
    fn lists_and_ranges() {
        assert_eq!(parse_list("1MPa,2MPa", Pressure).unwrap(), [1e6, 2e6]);
        let decades = parse_list("1kPa..1GPa:7", Pressure).unwrap();
        assert_eq!(decades, [1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9]);
        assert_eq!(parse_list("1um..1nm:2,5nm", Length).unwrap(), [1e-6, 1e-9, 5e-9]);
        let sixteen = parse_list("1kPa..1GPa:16", Pressure).unwrap();
        assert_eq!(sixteen.len(), 16);
        for w in sixteen.windows(2) {
            assert!((w[1] / w[0] / 10f64.powf(0.4) - 1.0).abs() < 1e-12);
        }
        for bad in
            ["1kPa..1GPa", "1kPa..1GPa:1", "1kPa..1GPa:x", "0Pa..1GPa:3", "1..2MPa:3", "1MPa,", ""]
        {
            assert!(parse_list(bad, Pressure).is_err(), "{bad}");
        }
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "parsing must be exact")]
    fn a_unit_alone() {
        assert_eq!(parse_length_unit("um").unwrap(), 1e-6);
        assert_eq!(parse_length_unit("Å").unwrap(), 1e-10);
        assert!(parse_length_unit("parsec").is_err());
    }
}
