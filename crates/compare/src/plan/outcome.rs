//! What was chosen, what it reached, and what the next better choice would cost.

use super::Request;
use crate::PrecisionName;
use contact_types::Grid;

/// The next finer grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Next {
    /// Points `[ny, nx]`.
    pub shape: [usize; 2],
    /// Over those of the given map, per side.
    pub factor: f64,
    /// Expected relative half width at the load that has the widest; `None` if the contacts would
    /// still be too small for a bar.
    pub half_width: Option<f64>,
    /// Expected time (s): that of the grid used, times the ratio of points.
    pub seconds: f64,
}

/// The outcome of a request.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// What was asked for.
    pub request: Request,
    /// True if the budget of every load is within the request.
    pub met: bool,
    /// The grid of the given map.
    pub given: Grid,
    /// The grid solved on.
    pub grid: Grid,
    /// Its points per side over those of the given map, about.
    pub factor: f64,
    /// Precision of the solver.
    pub precision: PrecisionName,
    /// Tolerance of the solver.
    pub tolerance: f64,
    /// Widest relative half width over the loads; `None` if a load has no bar.
    pub half_width: Option<f64>,
    /// FFT pairs on the grid used, all loads.
    pub transforms: f64,
    /// Points × FFT pairs × bytes of a number, also on grids that were given up: what choices are
    /// ranked by.
    pub work: f64,
    /// Wall-clock time of all solutions, also those on grids that were given up (s).
    pub seconds: f64,
    /// Shapes of the grids that were tried and given up.
    pub given_up: Vec<[usize; 2]>,
    /// The next better choice; `None` if there is none.
    pub next: Option<Next>,
    /// Why the request is not met.
    pub reason: Option<String>,
}

impl Outcome {
    /// All of it in one line.
    pub fn explanation(&self) -> String {
        let grid = if self.grid == self.given {
            format!("{} points as given", points(self.grid.shape()))
        } else if self.factor < 1.0 {
            format!("{} of {} points", points(self.grid.shape()), points(self.given.shape()))
        } else {
            format!("{} points from {}", points(self.grid.shape()), points(self.given.shape()))
        };
        let reached = self.half_width.map_or_else(|| "no error bar".to_owned(), plus_minus);
        let line = format!(
            "{grid}, {}, tolerance {}: {reached}, {}",
            self.precision,
            tolerance(self.tolerance),
            time(self.seconds)
        );
        match (&self.reason, &self.next) {
            (Some(why), _) => {
                format!("{line}; {} not met: {why}", percent(self.request.relative()))
            }
            (None, Some(next)) => {
                let better = next.half_width.map_or_else(String::new, |h| plus_minus(h) + ", ");
                format!(
                    "{line}; next better: {}, {better}{}",
                    points(next.shape),
                    time(next.seconds)
                )
            }
            (None, None) => format!("{line}; no better grid"),
        }
    }
}

/// `1024²` or `512 × 600`.
pub(super) fn points([ny, nx]: [usize; 2]) -> String {
    if ny == nx { format!("{ny}²") } else { format!("{ny} × {nx}") }
}

pub(super) fn percent(relative: f64) -> String {
    format!("{} %", digits(100.0 * relative))
}

pub(super) fn plus_minus(half_width: f64) -> String {
    format!("±{}", percent(half_width))
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

    fn outcome() -> Outcome {
        let grid = |n: usize| Grid::new([n, n], [1.0 / n as f64; 2]).unwrap();
        Outcome {
            request: Request::new(0.02).unwrap(),
            met: true,
            given: grid(1024),
            grid: grid(512),
            factor: 0.5,
            precision: PrecisionName::F32,
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
            reason: None,
        }
    }

    #[test]
    fn one_line_says_it_all() {
        assert_eq!(
            outcome().explanation(),
            "512² of 1024² points, f32, tolerance 1e−3: ±1.6 %, 0.05 s; next better: 1024², \
             ±0.7 %, 0.21 s"
        );
        let refused = Outcome {
            reason: Some("nothing is resolved".into()),
            met: false,
            half_width: None,
            ..outcome()
        };
        assert!(
            refused
                .explanation()
                .ends_with("no error bar, 0.05 s; 2 % not met: nothing is resolved")
        );
    }

    #[test]
    fn digits_round_up() {
        let shown = [0.0, 0.0201, 1.0, 1.01, 9.99, 12.3, 123.0].map(digits);
        assert_eq!(shown, ["0", "0.021", "1", "1.1", "10", "13", "130"]);
    }
}
