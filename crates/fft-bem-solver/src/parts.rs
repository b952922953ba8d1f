//! Where the time of a solve goes. With the feature `parts` each part is timed; without it nothing is, and a
//! part is its work alone.

#[cfg(feature = "parts")]
use std::sync::{Mutex, PoisonError};

/// Parts with their seconds, in the order in which they ended.
#[cfg(feature = "parts")]
static TIMES: Mutex<Vec<(&'static str, f64)>> = Mutex::new(Vec::new());

/// Does the work of a part. No part holds another.
#[inline(always)]
#[allow(clippy::inline_always, reason = "without the feature it is nothing")]
pub(crate) fn part<R>(name: &'static str, work: impl FnOnce() -> R) -> R {
    #[cfg(not(feature = "parts"))]
    {
        _ = name;
        work()
    }
    #[cfg(feature = "parts")]
    {
        let clock = std::time::Instant::now();
        let done = work();
        let seconds = clock.elapsed().as_secs_f64();
        TIMES.lock().unwrap_or_else(PoisonError::into_inner).push((name, seconds));
        done
    }
}

/// The parts of all solves since this was last called, with their seconds, in order.
#[cfg(feature = "parts")]
pub fn take_parts() -> Vec<(&'static str, f64)> {
    std::mem::take(&mut TIMES.lock().unwrap_or_else(PoisonError::into_inner))
}
