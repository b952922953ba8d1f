//! What tables of many runs need: middle values and round numbers.

/// The middle value, or the mean of the two; `None` of nothing.
pub fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let [below, above] = [sorted[last / 2], sorted[last.div_ceil(2)]];
    Some(below + 0.5 * (above - below))
}

/// The nearest number of `digits` significant decimal digits; what is not finite stays.
pub fn round_to_digits(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_keeps_the_leading_digits() {
        let text = |value, digits| round_to_digits(value, digits).to_string();
        assert_eq!(text(0.123_456, 4), "0.1235");
        assert_eq!(text(-98_765.4, 2), "-99000");
        assert_eq!(text(9.9996e-7, 4), "0.000001");
        assert_eq!(text(0.0, 6), "0");
        assert_eq!(text(f64::INFINITY, 3), "inf");
        assert!(round_to_digits(f64::NAN, 3).is_nan());
    }
}
