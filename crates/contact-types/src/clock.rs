//! Time, where there is a clock.

use std::time::{Duration, Instant};

/// What measures the time of an answer. `wasm32-unknown-unknown` has no clock: no time passes there.
#[derive(Debug, Clone, Copy)]
pub struct Clock(Option<Instant>);

impl Clock {
    /// Starts.
    pub fn now() -> Self {
        let is_there = !cfg!(all(target_family = "wasm", target_os = "unknown"));
        Self(is_there.then(Instant::now))
    }

    /// Time since the start.
    pub fn elapsed(self) -> Duration {
        self.0.map_or(Duration::ZERO, |start| start.elapsed())
    }
}
