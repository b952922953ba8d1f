//! The rung of the ladder that was reached, in words: what it is, what it reached, why it does not suffice.

use crate::numbers::{METRES, PASCALS, chosen};
use contact_accuracy::{Load, Reached};
use contact_types::Named;

/// All of it in one line.
pub fn explanation(reached: &Reached) -> String {
    let grid = points(reached.grid.shape());
    let given = points(reached.given.shape());
    let grid = match reached.factor() {
        f if f < 0.75 => format!("{grid} of {given} points"),
        f if f > 1.5 => format!("{grid} points from {given}"),
        _ => format!("{grid} points as given"),
    };
    let width =
        reached.half_width.map_or_else(|| "without uncertainty estimate".to_owned(), plus_minus);
    let tolerance = format!("{:e}", reached.tolerance).replace("e-", "e−");
    let (precision, time) = (reached.precision.name(), duration_rounded_up(reached.seconds));
    let line = format!("{grid}, {precision}, tolerance {tolerance}: {width}, {time}");
    if let (Some(why), Some(request)) = (reason(reached), reached.request) {
        return format!("{line}; {} not met: {why}", percent(request.relative()));
    }
    match &reached.next {
        Some(next) => {
            let better = next.half_width.map_or_else(String::new, |h| plus_minus(h) + ", ");
            let (points, time) = (points(next.shape), duration_rounded_up(next.seconds));
            format!("{line}; next: {points}, about {better}{time}")
        }
        None => line,
    }
}

/// Why a request is not met: the first load that misses it; `None` if it is met.
pub fn reason(reached: &Reached) -> Option<String> {
    let unmet = reached.unmet.as_ref()?;
    let others = match unmet.missed {
        1 => String::new(),
        n => format!(" ({n} of {} loads miss it)", unmet.of),
    };
    let at = shown(unmet.first);
    let here = match &unmet.here {
        Ok(width) => format!("{} at {at}{others}", plus_minus(*width)),
        Err(why) => format!("at {at}{others} {why}"),
    };
    Some(if unmet.between_points {
        format!(
            "{here}; the result depends on interpolation between points: measure on a finer grid"
        )
    } else {
        format!("{here}, and no finer grid is considered")
    })
}

/// "2 MPa", "a mean gap of 30 nm".
fn shown(load: Load) -> String {
    match load {
        Load::MeanGap(gap) => format!("a mean gap of {}", chosen(gap, METRES)),
        Load::MeanPressure(load) => chosen(load, PASCALS),
        _ => format!("{load:?}"),
    }
}

/// `1024²` or `512 × 600`.
fn points([ny, nx]: [usize; 2]) -> String {
    if ny == nx { format!("{ny}²") } else { format!("{ny} × {nx}") }
}

fn percent(relative: f64) -> String {
    format!("{} %", digits(100.0 * relative))
}

/// From all of the number on, where it may be zero, its upper end alone.
fn plus_minus(half_width: f64) -> String {
    let sign = if half_width < 1.0 { "±" } else { "at most +" };
    format!("{sign}{}", percent(half_width))
}

/// Two significant digits, rounded up: what is beyond a request does not look within it.
fn digits(value: f64) -> String {
    if value <= 0.0 {
        return "0".to_owned();
    }
    let decade = value.log10().floor() as i32;
    let unit = 10f64.powi(decade - 1);
    let rounded = (value / unit - 1e-9).ceil() * unit;
    let decimals = usize::try_from(1 - decade).unwrap_or(0);
    let text = format!("{rounded:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// At most so long: [`digits`] rounds up.
fn duration_rounded_up(seconds: f64) -> String {
    let (scale, unit) = if seconds < 0.01 { (1e3, "ms") } else { (1.0, "s") };
    format!("{} {unit}", digits(scale * seconds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_round_up() {
        let shown = [0.0, 0.0201, 1.0, 1.01, 9.99, 12.3, 123.0].map(digits);
        assert_eq!(shown, ["0", "0.021", "1", "1.1", "10", "13", "130"]);
    }
}
