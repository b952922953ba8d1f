//! Time, where there is a clock.

use std::time::Duration;
#[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
use std::time::Instant;

/// What measures the time of an answer. `wasm32-unknown-unknown` has no clock: no time passes there.
#[derive(Debug, Clone, Copy)]
pub struct Clock(#[cfg(not(all(target_family = "wasm", target_os = "unknown")))] Instant);

impl Clock {
    /// Starts.
    pub fn now() -> Self {
        #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
        return Self(Instant::now());
        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        Self()
    }

    /// Time since the start.
    pub fn elapsed(self) -> Duration {
        #[cfg(not(all(target_family = "wasm", target_os = "unknown")))]
        return self.0.elapsed();
        #[cfg(all(target_family = "wasm", target_os = "unknown"))]
        Duration::ZERO
    }
}
