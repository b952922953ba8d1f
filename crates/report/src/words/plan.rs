//! A plan for an accuracy in words: what was chosen, what it reached, why it does not suffice.

use crate::numbers::{METRES, PASCALS, chosen};
use contact_accuracy::Load;
use contact_accuracy::plan::{Finest, Miss, NoBar, Outcome, Unmet};

/// All of it in one line.
pub fn explanation(outcome: &Outcome) -> String {
    let grid = if outcome.grid == outcome.given {
        format!("{} points as given", points(outcome.grid.shape()))
    } else if outcome.factor < 1.0 {
        format!("{} of {} points", points(outcome.grid.shape()), points(outcome.given.shape()))
    } else {
        format!("{} points from {}", points(outcome.grid.shape()), points(outcome.given.shape()))
    };
    let reached = outcome.half_width.map_or_else(|| "no error bar".to_owned(), plus_minus);
    let line = format!(
        "{grid}, {}, tolerance {}: {reached}, {}",
        outcome.precision,
        tolerance(outcome.tolerance),
        time(outcome.seconds)
    );
    match (reason(outcome), &outcome.next) {
        (Some(why), _) => {
            format!("{line}; {} not met: {why}", percent(outcome.request.relative()))
        }
        (None, Some(next)) => {
            let better = next.half_width.map_or_else(String::new, |h| plus_minus(h) + ", ");
            format!("{line}; next better: {}, {better}{}", points(next.shape), time(next.seconds))
        }
        (None, None) => format!("{line}; no better grid"),
    }
}

/// Why a request is not met: the first load that misses it; `None` if it is met.
pub fn reason(outcome: &Outcome) -> Option<String> {
    let (first, missed, of, why) = match outcome.unmet.as_ref()? {
        Unmet::Map(why) => return Some(why.to_string()),
        Unmet::Loads { first, missed, of, why } => (first, *missed, *of, why),
    };
    let others = match missed {
        1 => String::new(),
        n => format!(" ({n} of {of} loads miss it)"),
    };
    let at = shown(*first);
    let (here, finest) = match why {
        Miss::NoContact { first_contact } => {
            let touch = chosen(*first_contact, METRES);
            return Some(format!(
                "nothing touches at {at}{others}; the first contact of this map is at {touch}"
            ));
        }
        Miss::Bar { here, finest } => (here, finest),
    };
    let here = match here {
        Ok(width) => format!("{} at {at}{others}", plus_minus(*width)),
        Err(NoBar::Area(why)) => format!("at {at}{others} {why}"),
        Err(NoBar::Unsolved(why)) => format!("at {at}{others} {why}"),
    };
    Some(match finest {
        Finest::Used => format!("{here}, and no finer grid is considered"),
        Finest::BetweenPoints => format!(
            "{here}, and on a finer grid what lies between the points decides: waves through all of \
             them ring"
        ),
        Finest::Other { shape, half_width: Some(width) } => {
            format!("{here}; even {} points would leave {}", points(*shape), plus_minus(*width))
        }
        Finest::Other { shape, half_width: None } => {
            format!("{here}; even {} points would not resolve the contacts", points(*shape))
        }
    })
}

/// "2 MPa", "a mean gap of 30 nm", "an approach of 30 nm".
fn shown(load: Load) -> String {
    match load {
        Load::MeanGap(gap) => format!("a mean gap of {}", chosen(gap, METRES)),
        Load::Approach(depth) => format!("an approach of {}", chosen(depth, METRES)),
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

/// Two significant digits, rounded up so that a bar within a request does not look beyond it only
/// by much, nor one beyond it within.
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

fn tolerance(value: f64) -> String {
    format!("{value:e}").replace("e-", "e−")
}

fn time(seconds: f64) -> String {
    if seconds < 0.01 {
        format!("{} ms", digits(1e3 * seconds))
    } else {
        format!("{} s", digits(seconds))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_accuracy::NoAreaInterval;
    use contact_accuracy::Precision;
    use contact_accuracy::plan::{Next, Request};
    use contact_types::Grid;

    fn outcome() -> Outcome {
        let grid = |n: usize| Grid::new([n, n], [1.0 / n as f64; 2]).unwrap();
        Outcome {
            request: Request::new(0.02).unwrap(),
            met: true,
            given: grid(1024),
            grid: grid(512),
            factor: 0.5,
            precision: Precision::Single,
            tolerance: 1e-3,
            half_width: Some(0.0153),
            transforms: 5.2,
            work: 5.2 * 262_144.0 * 4.0,
            seconds: 0.0494,
            given_up: Vec::new(),
            next: Some(Next {
                shape: [1024, 1024],
                factor: 1.0,
                half_width: Some(0.007),
                seconds: 0.21,
            }),
            unmet: None,
        }
    }

    #[test]
    fn one_line_says_it_all() {
        assert_eq!(
            explanation(&outcome()),
            "512² of 1024² points, f32, tolerance 1e−3: ±1.6 %, 0.05 s; next better: 1024², \
             ±0.7 %, 0.21 s"
        );
        let refused = Outcome {
            unmet: Some(Unmet::Map(NoAreaInterval::Empty)),
            met: false,
            half_width: None,
            ..outcome()
        };
        assert!(
            explanation(&refused).ends_with("no error bar, 0.05 s; 2 % not met: nothing touches")
        );
    }

    #[test]
    fn digits_round_up() {
        let shown = [0.0, 0.0201, 1.0, 1.01, 9.99, 12.3, 123.0].map(digits);
        assert_eq!(shown, ["0", "0.021", "1", "1.1", "10", "13", "130"]);
    }
}
