//! Numbers as the page says them.

use contact_report::numbers::{METRES, PASCALS, SPACE, chosen, quantity};

/// A length (m), to three digits.
pub(crate) fn length(metres: f64) -> String {
    quantity(metres, METRES, 3)
}

/// A pressure (Pa), as somebody would choose it.
pub(crate) fn pressure(pascals: f64) -> String {
    chosen(pascals, PASCALS)
}

/// How many, in groups of three digits.
pub(crate) fn count(number: usize) -> String {
    let digits = number.to_string();
    if digits.len() < 5 {
        return digits;
    }
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            grouped.push(SPACE);
        }
        grouped.push(digit);
    }
    grouped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_stand_in_groups() {
        assert_eq!(count(4096), "4096");
        assert_eq!(count(307200), format!("307{SPACE}200"));
        assert_eq!(count(16777216), format!("16{SPACE}777{SPACE}216"));
    }
}
