//! Numbers with their uncertainty, to the digits that it supports.

use contact_types::Grid;
pub use surface_stats::numbers::{
    METRES, SPACE, Unit, counted, fixed, percent, plain, power_of_ten, quantity, significant,
    unit_for,
};
use surface_stats::numbers::{exponent, fixed_significant};

/// Decimals to which a value with this uncertainty is printed, negative for tens, hundreds…:
/// one significant digit of the uncertainty, two if it starts with 1.
fn decimals_of(uncertainty: f64) -> i32 {
    let e = exponent(uncertainty, 2);
    let leading = uncertainty / 10f64.powi(e);
    // 1.2 and, since it rounds to 10, 9.6 start with 1.
    if leading < 1.95 { 1 - e } else { -e }
}

/// "1.96 ± 0.12": both to the place the uncertainty supports; without one, three digits.
pub(crate) fn plus_minus(value: f64, uncertainty: f64) -> String {
    if !(uncertainty > 0.0 && uncertainty.is_finite()) {
        return significant(value, 3);
    }
    let decimals = decimals_of(uncertainty);
    if decimals >= 0 {
        let d = decimals as usize;
        return format!("{} ± {}", fixed(value, d), fixed(uncertainty, d));
    }
    let place = 10f64.powi(-decimals);
    let round = |x: f64| fixed((x / place).round() * place, 0);
    format!("{} ± {}", round(value), round(uncertainty))
}

/// A number that cannot be negative and the ends between which it lies: "1.96 ± 0.12"; "20 to 166" where one side is
/// longer than the other, as of a quotient; "at most 0.80" or "at least 31" where one end is not known, 0 or
/// infinite. Ends are rounded outwards, so that what is known is inside.
pub(crate) fn with_interval(value: f64, [low, high]: [f64; 2]) -> String {
    let sides = [value - low, high - value];
    let half = sides[0].max(sides[1]);
    match (low > 0.0, high.is_finite()) {
        _ if half.is_nan() || half <= 1e-12 * value => significant(value, 3), // none, or rounding
        (false, false) => significant(value, 3),
        (false, true) => format!("at most {}", end(high, f64::ceil, 1 - exponent(high, 2))),
        (true, false) => format!("at least {}", end(low, f64::floor, 1 - exponent(low, 2))),
        _ if is_even(sides) => plus_minus(value, half),
        _ => {
            let decimals = |x: f64| (decimals_of(x) + 1).max(decimals_of(0.5 * (high - low)));
            let [from, to] = [low, high].map(decimals);
            format!("{} to {}", end(low, f64::floor, from), end(high, f64::ceil, to))
        }
    }
}

/// Whether one half width stands for both sides.
fn is_even([below, above]: [f64; 2]) -> bool {
    below.max(above) <= 1.25 * below.min(above)
}

/// An end of an interval with these decimals, negative for tens, hundreds….
fn end(value: f64, round: fn(f64) -> f64, decimals: i32) -> String {
    let place = 10f64.powi(-decimals);
    // A number that has these digits already stays what it is.
    let nudge = if round(0.5) > 0.5 { -1e-9 } else { 1e-9 };
    let rounded = round(value / place + nudge) * place;
    let e = exponent(rounded, 1);
    if (-3..6).contains(&e) {
        fixed(rounded, usize::try_from(decimals).unwrap_or(0))
    } else {
        significant(rounded, decimals + e + 1)
    }
}

/// "1.96 ± 0.12 %" of a fraction, its interval where there is one; "1.96 %" without.
pub fn percent_within(fraction: f64, interval: Option<[f64; 2]>) -> String {
    let ends = interval.map_or([100.0 * fraction; 2], |ends| ends.map(|end| 100.0 * end));
    format!("{}{SPACE}%", with_interval(100.0 * fraction, ends))
}

/// The ends of an interval as shares of its number: "±12 %", "−14 to +27 %", "at most +133 %", "at least −57 %".
pub fn relative_interval(value: f64, [low, high]: [f64; 2]) -> String {
    let [below, above] = [low, high].map(|end| end / value - 1.0);
    match (low > 0.0, high.is_finite()) {
        (false, false) => "–".into(),
        (false, true) => format!("at most +{}", percent(above)),
        (true, false) => format!("at least \u{2212}{}", percent(below)),
        _ if is_even([-below, above]) => {
            let shown = percent(above.max(-below));
            shown.strip_prefix('<').map_or_else(
                || format!("±{shown}"),
                |rest| format!("<{SPACE}±{}", rest.trim_start()),
            )
        }
        _ => signed_range(below, above),
    }
}

/// "+399 %", "−4.3 %": whole per cent from 10, one decimal below, three digits from 1000.
pub(crate) fn signed_percent(error: f64) -> String {
    format!("{}{SPACE}%", signed(100.0 * error))
}

/// "−26 to −4.4 %": a range of signed relative errors.
pub fn signed_range(low: f64, high: f64) -> String {
    let (a, b) = (signed(100.0 * low), signed(100.0 * high));
    if a == b { format!("{a}{SPACE}%") } else { format!("{a} to {b}{SPACE}%") }
}

/// The number of [`signed_percent`] without its unit.
pub(crate) fn signed(percent: f64) -> String {
    let text = match percent.abs() {
        size if size >= 999.5 => fixed_significant(percent, 3),
        size => fixed(percent, usize::from(size < 9.95)),
    };
    if percent > 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) {
        format!("+{text}")
    } else {
        text
    }
}

/// "58 µs": a duration with two significant digits.
pub fn duration(seconds: f64) -> String {
    const UNITS: [(f64, &str); 4] = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    if seconds >= 119.5 {
        return format!("{}{SPACE}min", significant(seconds / 60.0, 2));
    }
    let (scale, unit) =
        UNITS.into_iter().find(|(scale, _)| seconds >= 0.995 * scale).unwrap_or(UNITS[3]);
    format!("{}{SPACE}{unit}", significant(seconds / scale, 2))
}

/// "20 000" or "21": how many times; two digits below 100, one above.
pub(crate) fn times(ratio: f64) -> String {
    fixed_significant(ratio, if ratio < 99.5 { 2 } else { 1 })
}

const fn unit(scale: f64, name: &'static str) -> Unit {
    Unit { scale, name }
}

/// Multiples of the pascal.
pub const PASCALS: &[Unit] = &[
    unit(1e-3, "mPa"),
    unit(1.0, "Pa"),
    unit(1e3, "kPa"),
    unit(1e6, "MPa"),
    unit(1e9, "GPa"),
    unit(1e12, "TPa"),
];

/// Multiples of the square metre.
pub const AREAS: &[Unit] =
    &[unit(1e-18, "nm²"), unit(1e-12, "µm²"), unit(1e-6, "mm²"), unit(1.0, "m²")];

/// Multiples of the ohm.
pub(crate) const OHMS: &[Unit] =
    &[unit(1e-9, "nΩ"), unit(1e-6, "µΩ"), unit(1e-3, "mΩ"), unit(1.0, "Ω"), unit(1e3, "kΩ")];

/// Multiples of the unit of thermal resistance.
pub(crate) const KELVINS_PER_WATT: &[Unit] =
    &[unit(1e-6, "µK/W"), unit(1e-3, "mK/W"), unit(1.0, "K/W")];

/// Multiples of the newton.
pub const NEWTONS: &[Unit] = &[
    unit(1e-9, "nN"),
    unit(1e-6, "µN"),
    unit(1e-3, "mN"),
    unit(1.0, "N"),
    unit(1e3, "kN"),
    unit(1e6, "MN"),
];

/// "96 × 128 points of 1 µm × 3 µm", rows and columns, dy and dx; of square pixels one side.
pub(crate) fn points_of(grid: Grid) -> String {
    let ([ny, nx], [dy, dx]) = (grid.shape(), grid.pixel().map(|d| chosen(d, METRES)));
    let pixel = if dy == dx { dx } else { format!("{dy} × {dx}") };
    format!("{ny} × {nx} points of {pixel}")
}

/// "10 MPa", "2.5 kPa": a value that was chosen, with as many digits as it needs up to four.
pub fn chosen(value: f64, units: &[Unit]) -> String {
    let unit = unit_for(value, units);
    let number = value / unit.scale;
    let digits = (1..4)
        .find(|&d: &i32| {
            let rounded: f64 = format!("{number:.*e}", (d - 1) as usize).parse().unwrap_or(number);
            (rounded - number).abs() <= 1e-9 * number.abs()
        })
        .unwrap_or(4);
    format!("{}{SPACE}{}", fixed_significant(number, digits), unit.name)
}

/// "510 ± 30 MPa", "20 to 166 GPa", "at most 42 MPa": the multiple follows the value alone, so that the same number
/// with another uncertainty has the same unit; that of an end that stands alone follows it.
pub fn quantity_within(value: f64, interval: Option<[f64; 2]>, units: &[Unit]) -> String {
    let Some([low, high]) = interval else { return quantity(value, units, 3) };
    let leading = match (low > 0.0, high.is_finite()) {
        (false, true) => high,
        (true, false) => low,
        _ => value,
    };
    let unit = unit_for(leading, units);
    let text = with_interval(value / unit.scale, [low, high].map(|end| end / unit.scale));
    format!("{text}{SPACE}{}", unit.name)
}

/// A length as the report writes it, "28 µm".
pub(crate) fn length(metres: f64) -> String {
    quantity(metres, METRES, 2)
}

/// "10 ns", "1 µs", "0.1 ms", "1 s", "100 s".
pub(crate) fn time_tick(seconds: f64) -> String {
    let (scale, unit) = match seconds {
        s if s < 0.5e-6 => (1e-9, "ns"),
        s if s < 0.5e-4 => (1e-6, "µs"),
        s if s < 0.5 => (1e-3, "ms"),
        _ => (1.0, "s"),
    };
    format!("{}{SPACE}{unit}", significant(seconds / scale, 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uncertainty_sets_the_digits() {
        for (value, uncertainty, text) in [
            (1.9612, 0.1188, "1.96 ± 0.12"),
            (0.5101, 0.0311, "0.51 ± 0.03"),
            (12345.0, 320.0, "12\u{202F}300 ± 300"),
            (5.0, 0.0961, "5.00 ± 0.10"),
            (5.0, 0.099_9, "5.00 ± 0.10"),
            (5.0, f64::NAN, "5.00"),
        ] {
            assert_eq!(plus_minus(value, uncertainty), text);
        }
    }

    #[test]
    fn signs_and_groups() {
        let errors = [3.987, -0.0434, -0.0001, 2302.33].map(signed_percent);
        let texts = ["+399 %", "\u{2212}4.3 %", "0.0 %", "+230 000 %"];
        assert_eq!(errors, texts.map(|text| text.replace(' ', "\u{202F}")));
        assert_eq!(signed_range(-0.262, -0.0442), "\u{2212}26 to \u{2212}4.4\u{202F}%");
        assert_eq!(signed_range(4.568, 4.572), "+457\u{202F}%");
        assert_eq!([20_312.0, 21.4].map(times), ["20\u{202F}000", "21"]);
    }

    /// A load of 630 MPa on 1.8 ± 1.4 % of the area: 630/0.032 to 630/0.004 MPa, in one unit.
    #[test]
    fn an_interval_is_said_as_it_is() {
        for (value, ends, text) in [
            (1.2, [-0.4, 2.8], "at most 2.8"),
            (1.2, [0.1, 2.3], "1.2 ± 1.1"),
            (0.5, [0.219, 0.781], "0.5 ± 0.3"),
            (1.96, [1.96, 1.96], "1.96"),
            (0.0, [0.0, 0.0], "0"),
            (35.0, [19.7, 157.5], "19 to 158"),
            (1.59, [1.585, 1.6056], "1.585 to 1.606"),
            (1.35, [0.1, f64::INFINITY], "at least 0.10"),
            // Never rounded below what is known.
            (0.4, [0.0, 0.8012], "at most 0.81"),
            (0.4, [0.0, 0.8], "at most 0.80"),
        ] {
            assert_eq!(with_interval(value, ends), text);
        }
        assert_eq!(percent_within(0.6, Some([0.0, 1.0])), "at most 100\u{202F}%");
        assert_eq!(percent_within(0.0196, None), "1.96\u{202F}%");
        let around = |value: f64, half| Some([value - half, value + half]);
        for (value, ends, text) in [
            (510.2e6, around(510.2e6, 31e6), "510 ± 30\u{202F}MPa"),
            (510.2e6, around(510.2e6, 12e6), "510 ± 12\u{202F}MPa"),
            (33e6, around(33e6, 9e6), "33 ± 9\u{202F}MPa"),
            (33e6, around(33e6, 21e6), "30 ± 20\u{202F}MPa"),
            (33e6, None, "33.0\u{202F}MPa"),
            (35e9, Some([630e6 / 0.032, 630e6 / 0.004]), "19 to 158\u{202F}GPa"),
            (1.35e9, Some([98e6, f64::INFINITY]), "at least 98\u{202F}MPa"),
        ] {
            assert_eq!(quantity_within(value, ends, PASCALS), text);
        }
        for (ends, text) in [
            ([0.88, 1.12], "±12 %"),
            ([1.0, 1.0], "±0 %"),
            ([1.0 - 1e-6, 1.0 + 1e-6], "< ±0.01 %"),
            ([0.56, 4.6], "\u{2212}44 to +360 %"),
            ([0.0, 13.2], "at most +1220 %"),
            ([0.076, f64::INFINITY], "at least \u{2212}92 %"),
        ] {
            assert_eq!(relative_interval(1.0, ends).replace(SPACE, " "), text);
        }
    }

    #[test]
    fn units_follow_the_value() {
        let durations = [5.8e-5, 0.9996e-3, 1.3].map(duration);
        assert_eq!(durations, ["58\u{202F}µs", "1.0\u{202F}ms", "1.3\u{202F}s"]);
        let pressures = [1e7, 2.5e3, 115.384_615e9].map(|p| chosen(p, PASCALS));
        assert_eq!(pressures, ["10\u{202F}MPa", "2.5\u{202F}kPa", "115.4\u{202F}GPa"]);
        let ticks = [1e-8, 1e-6, 1e-4, 1e-2, 1.0].map(time_tick);
        let texts = ["10 ns", "1 µs", "0.1 ms", "10 ms", "1 s"];
        assert_eq!(ticks, texts.map(|text| text.replace(' ', "\u{202F}")));
    }
}
