//! How long a study takes, from a trial on this machine.

use crate::place::Host;
use contact_compare::{Load, Solver};
use contact_front_end::Failure;
use contact_types::{ContactModulus, Grid, HeightMap};
use serde::{Deserialize, Serialize};
use std::error::Error;
use std::f64::consts::TAU;
use std::time::{Duration, Instant};

/// Points along a side of the trial.
const SIDE: usize = 128;

/// The trial is repeated for so long: the engine of a browser becomes faster in the first moments.
const LONG: Duration = Duration::from_millis(400);

/// Seconds of a trial: one load on a map of bumps.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Pace {
    /// With one thread.
    one: f64,
    /// With all threads of the place.
    all: f64,
    /// How often it was measured.
    trials: usize,
}

/// Trials of a place: the engine of a browser becomes faster by them, and what else the machine does makes one slower.
const TRIALS: usize = 4;

/// A study as a clock sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StudyCost {
    /// Points of the map.
    pub(crate) points: f64,
    /// Points that are solved, mirror images among them.
    pub(crate) solved: f64,
    /// Loads, each counted as often as it is solved.
    pub(crate) loads: f64,
}

impl Pace {
    /// Measured now, unless that was done often enough; the fastest counts.
    ///
    /// # Errors
    /// None that a trial can meet, but those of the solver.
    pub(crate) fn after(earlier: Option<Self>, place: Host) -> Result<Self, Failure> {
        let known = earlier.unwrap_or(Self { one: f64::MAX, all: f64::MAX, trials: 0 });
        if known.trials >= TRIALS {
            return Ok(known);
        }
        let trial =
            |threads| trial(threads).map_err(|e| Failure::refused("internal", e.to_string()));
        let one = trial(1)?;
        let all = if place.threads > 1 { trial(place.threads)? } else { one };
        let trials = known.trials + 1;
        Ok(Self { one: known.one.min(one), all: known.all.min(all), trials })
    }

    /// Seconds of a study: where the grid resolves the contact, and where each load is solved again on one of four times
    /// the points.
    pub(crate) fn seconds(self, work: StudyCost) -> [f64; 2] {
        let once = BEGIN * self.one + EACH_POINT * self.one * work.points;
        let solving = EACH_SOLVED * self.all * work.solved * work.loads;
        [once + solving, once + (1.0 + AGAIN) * solving]
    }
}

/// What a study takes whatever its map is, in trials. These are measured, see the tests.
const BEGIN: f64 = 420.0;
/// Reading, statistics, closed forms and report of a point, in trials.
const EACH_POINT: f64 = 8.4e-4;
/// A load on a point, in trials.
const EACH_SOLVED: f64 = 1.25e-4;
/// The finer grid, in times of the given one.
const AGAIN: f64 = 7.5;

/// The shortest of several: what else the machine does in the meantime is no property of it.
fn trial(threads: usize) -> Result<f64, Box<dyn Error>> {
    let grid = Grid::new([SIDE; 2], [1.0; 2])?;
    let wave = |at: f64, across: f64| (TAU * at / 32.0).cos() * (TAU * across / 16.0).cos();
    let map = HeightMap::from_fn(grid, wave)?;
    let modulus = ContactModulus::from_pascals(1.0)?;
    let mut solver = Solver::builder().threads(threads).build(grid, modulus)?;
    let (begun, mut shortest) = (Instant::now(), f64::INFINITY);
    while begun.elapsed() < LONG {
        let now = Instant::now();
        solver.forget();
        solver.solve(&map, Load::MeanPressure(0.01))?;
        shortest = shortest.min(now.elapsed().as_secs_f64());
    }
    Ok(shortest)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Studies of 15 loads in WebAssembly on the machine whose trial took 2.63 ms: points along a side, seconds of processor time where
    /// the grid resolves the contact, and where each load was refined.
    #[test]
    fn time_is_said_as_it_was_measured() {
        let pace = Pace { one: 2.63e-3, all: 2.63e-3, trials: 1 };
        let sides = [256.0, 512.0, 1024.0, 2048.0, 4096.0];
        let measured = [&[1.47, 3.28, 8.51, 32.2, 105.5][..], &[3.69, 13.8, 48.2]];
        for (k, measured) in measured.into_iter().enumerate() {
            for (side, measured) in sides.into_iter().zip(measured) {
                let points = side * side;
                let said = pace.seconds(StudyCost { points, solved: points, loads: 15.0 })[k];
                assert!((said / measured - 1.0).abs() < 0.2, "{side}: {said} and {measured}");
            }
        }
    }

    #[test]
    fn a_trial_takes_time_and_more_threads_do_not_change_what_one_takes() {
        let pace = Pace::after(None, Host::machine(2)).unwrap();
        assert!(pace.one > 0.0 && pace.all > 0.0 && pace.one < 10.0);
        let browser = Pace::after(None, Host::BROWSER).unwrap();
        assert!((browser.one - browser.all).abs() < 1e-12);
        let again = Pace::after(Some(browser), Host::BROWSER).unwrap();
        assert!(again.one <= browser.one && again.trials == 2);
        let known = Pace { trials: TRIALS, ..again };
        assert!((Pace::after(Some(known), Host::BROWSER).unwrap().one - again.one).abs() < 1e-300);
    }
}
