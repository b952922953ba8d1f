//! Numbers as people read them: true minus signs, narrow no-break spaces before units and in groups of three digits.

/// Narrow no-break space.
pub const SPACE: char = '\u{202F}';
/// Minus sign, as wide as a plus.
const MINUS: char = '\u{2212}';

/// With the spaces of a terminal.
pub fn plain(text: &str) -> String {
    text.replace(SPACE, " ")
}

/// `value` with `decimals` decimals, a true minus, and groups of three digits from 10 000.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", value.abs());
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let mut out = String::new();
    if value < 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        out.push(MINUS);
    }
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && whole.len() > 4 && (whole.len() - i) % 3 == 0 {
            out.push(SPACE);
        }
        out.push(digit);
    }
    if !fraction.is_empty() {
        out.push('.');
        out.push_str(fraction);
    }
    out
}

/// Decimal exponent of the leading digit after rounding to `digits` significant digits.
pub fn exponent(value: f64, digits: i32) -> i32 {
    let text = format!("{:.*e}", (digits - 1).max(0) as usize, value.abs());
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// `value` to `digits` significant digits, without an exponent; beyond 10⁵ and below 10⁻³ as a
/// power of ten. Zero is "0".
pub fn significant(value: f64, digits: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let e = exponent(value, digits);
    if !(-3..6).contains(&e) {
        let mantissa = value / 10f64.powi(e);
        return format!(
            "{}{SPACE}×{SPACE}{}",
            fixed(mantissa, (digits - 1).max(0) as usize),
            power_of_ten(e)
        );
    }
    let place = 10f64.powi(e + 1 - digits);
    let rounded = if place > 1.0 { (value / place).round() * place } else { value };
    fixed(rounded, usize::try_from(digits - 1 - e).unwrap_or(0))
}

/// "10⁻⁶".
pub fn power_of_ten(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let text = exponent.unsigned_abs().to_string();
    let digits: String = text.bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect();
    format!("10{}{digits}", if exponent < 0 { "⁻" } else { "" })
}

/// "1 thread", "3 threads".
pub fn counted(count: usize, one: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{} {one}{ending}", fixed(count as f64, 0))
}

/// "15 %": the size of a relative error or bound.
pub fn percent(fraction: f64) -> String {
    let p = 100.0 * fraction.abs();
    if p > 0.0 && p < 0.01 {
        return format!("<{SPACE}0.01{SPACE}%");
    }
    let digits = fixed_significant(p, if p >= 100.0 { 3 } else { 2 });
    format!("{digits}{SPACE}%")
}

/// `value` to `digits` significant digits, always written out.
pub fn fixed_significant(value: f64, digits: i32) -> String {
    if value == 0.0 {
        return "0".into();
    }
    let e = exponent(value, digits);
    let place = 10f64.powi(e + 1 - digits);
    if place >= 1.0 {
        fixed((value / place).round() * place, 0)
    } else {
        fixed(value, usize::try_from(digits - 1 - e).unwrap_or(0))
    }
}

/// A decimal multiple of an SI unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// How many SI units one of these is.
    pub scale: f64,
    /// How it is written.
    pub name: &'static str,
}

/// Multiples of the metre.
pub const METRES: &[Unit] = &[
    Unit { scale: 1e-15, name: "fm" },
    Unit { scale: 1e-12, name: "pm" },
    Unit { scale: 1e-9, name: "nm" },
    Unit { scale: 1e-6, name: "µm" },
    Unit { scale: 1e-3, name: "mm" },
    Unit { scale: 1.0, name: "m" },
    Unit { scale: 1e3, name: "km" },
];

/// The multiple in which `value` reads as 1 to 999.
pub fn unit_for(value: f64, units: &[Unit]) -> Unit {
    let size = value.abs();
    units
        .iter()
        .rev()
        .find(|unit| size >= 0.9995 * unit.scale)
        .or_else(|| if size > 0.0 { units.first() } else { units.iter().find(|u| u.scale >= 1.0) })
        .copied()
        .unwrap_or(Unit { scale: 1.0, name: "" })
}

/// "62 nm": a value with `digits` significant digits in the multiple that suits it.
pub fn quantity(value: f64, units: &[Unit], digits: i32) -> String {
    let unit = unit_for(value, units);
    format!("{}{SPACE}{}", significant(value / unit.scale, digits), unit.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_and_units_follow_the_value() {
        assert_eq!(significant(10_712.0, 3), "10\u{202F}700");
        assert_eq!(significant(1.6e-5, 2), "1.6\u{202F}×\u{202F}10⁻⁵");
        assert_eq!(significant(9999.7, 3), "10\u{202F}000");
        assert_eq!(counted(1, "thread"), "1 thread");
        assert_eq!(counted(12_000, "thread"), "12\u{202F}000 threads");
        assert_eq!(percent(22_100.0), "2\u{202F}210\u{202F}000\u{202F}%");
        assert_eq!(percent(0.0196), "2.0\u{202F}%");
        assert_eq!(percent(0.0), "0\u{202F}%");
        assert_eq!(quantity(6.2e-8, METRES, 2), "62\u{202F}nm");
        assert_eq!(quantity(0.0, METRES, 2), "0\u{202F}m");
    }
}
