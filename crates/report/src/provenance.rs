//! When, where and by which command a report was made.

use std::time::{SystemTime, UNIX_EPOCH};

/// Circumstances of a run that are not part of its result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Provenance {
    /// Version of this package.
    pub version: String,
    /// Operating system and processor.
    pub platform: String,
    /// Seconds since 1970 (UTC).
    pub unix_time: u64,
    /// The command that repeats the run.
    pub repeat: String,
}

impl Provenance {
    /// This version on this machine now.
    pub fn here(repeat: impl Into<String>) -> Self {
        let now = SystemTime::now().duration_since(UNIX_EPOCH);
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            platform: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            unix_time: now.map_or(0, |d| d.as_secs()),
            repeat: repeat.into(),
        }
    }
}
