//! Where questions are answered, what that place bears, and how the page says it.

use serde_json::{Value, json};
use surface_io::Limits;

/// Where questions are answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Host {
    is_browser: bool,
    pub(crate) threads: usize,
}

/// Most points of a map in a browser: 4096 x 4096.
const BROWSER_POINTS: u64 = 1 << 24;

/// Largest file in a browser, and most that its members may unpack to (bytes).
const BROWSER_BYTES: u64 = 512 << 20;

/// What WebAssembly can address at most (bytes).
const BROWSER_MEMORY_BYTES: f64 = 4e9;

/// Memory of a study: bytes whatever the map is; bytes per point of a map whose grid resolves the contact, of more than
/// [`LARGE`] points, and of a map that is solved once more on a grid of four times the points.
type MemoryUse = (f64, [f64; 3]);

/// Points of a map beyond which a point takes more.
const LARGE: f64 = 2e6;

/// In WebAssembly. Measured in MB on 128², 256², 512², 1024², 1400², 2048² and 4096² points: 9.0, 12.8, 43.3, 153, 280, 932, 3701,
/// and on 128², 256², 512², 800² and 1024² that were refined: 17.6, 62.9, 243, 581, 987.
const BROWSER_MEMORY: MemoryUse = (7e6, [140.0, 221.0, 900.0]);

/// Of `rough-contact app` with two threads on Linux, all of the program counted, on the same maps up to 1024² and 512²: 36, 45, 113,
/// 329, and 51, 104, 330.
const MACHINE_MEMORY: MemoryUse = (30e6, [285.0, 285.0, 1150.0]);

impl Default for Host {
    /// What bears least.
    fn default() -> Self {
        Self::BROWSER
    }
}

impl Host {
    /// The engine of WebAssembly inside the page: one thread, 4 GB of memory.
    pub const BROWSER: Self = Self { is_browser: true, threads: 1 };

    /// A program on this machine, that solves with this many threads.
    #[must_use]
    pub fn machine(threads: usize) -> Self {
        Self { is_browser: false, threads: threads.max(1) }
    }

    /// What a file may ask for.
    pub(crate) fn limits(self) -> Limits {
        let mut limits = Limits::default();
        if self.is_browser {
            limits.points = BROWSER_POINTS;
            limits.file_bytes = BROWSER_BYTES;
            limits.unpacked_bytes = BROWSER_BYTES;
        }
        limits
    }

    /// Largest file (bytes).
    pub fn most_bytes(self) -> u64 {
        self.limits().file_bytes
    }

    /// Memory of a study of so many points (bytes): where the grid resolves the contact, and where it has to be refined.
    pub(crate) fn memory(self, points: f64) -> [f64; 2] {
        let (fixed, [resolved, large, refined]) =
            if self.is_browser { BROWSER_MEMORY } else { MACHINE_MEMORY };
        [if points > LARGE { large } else { resolved }, refined].map(|each| fixed + each * points)
    }

    /// What is to be said of so much memory (bytes), if it may be too much.
    pub(crate) fn too_much(self, most: f64) -> Option<&'static str> {
        (self.is_browser && most > BROWSER_MEMORY_BYTES).then_some(
            "A browser gives 4000 MB: where that may not do, choose the middle half of the map under Part, at its facts.",
        )
    }

    /// The limits, as a part of a sentence.
    pub(crate) fn limits_said(self) -> String {
        let limits = self.limits();
        let side = limits.points.isqrt();
        format!("{side} × {side} points and a file of {}", bytes(limits.file_bytes))
    }

    pub(crate) fn asks_for_more(self) -> &'static str {
        if self.is_browser {
            "This file asks for more than a browser can give."
        } else {
            "This file asks for more than the program takes."
        }
    }

    /// What has no such limit.
    pub(crate) fn way_out(self) -> &'static str {
        if self.is_browser {
            "The command rough-contact takes maps of up to 16384 × 16384 points; `rough-contact app` shows this page and \
             computes with it."
        } else {
            "Cut the middle of the map out first: the command rough-contact convert does that."
        }
    }

    /// Where the measurement goes.
    pub(crate) fn where_said(self) -> String {
        let limits = self.limits_said();
        if self.is_browser {
            return format!(
                "The file is read and computed in this window. No upload, no account, no cookie; unplug the network and it \
                 still works. At most {limits}."
            );
        }
        let threads = match self.threads {
            1 => "one thread".to_owned(),
            n => format!("{n} threads"),
        };
        format!(
            "The file is read by the program that opened this page, on this machine, and computed there with {threads}. It \
             keeps and writes nothing. No account, no cookie; unplug the network and it still works. At most {limits}, and \
             what the memory allows. Ctrl-C in its terminal ends it."
        )
    }

    /// What a page has to know of it.
    pub(crate) fn json(self) -> Value {
        let died = if self.is_browser {
            "Often the memory of the browser was not enough."
        } else {
            "The program was ended, or the memory of this machine was not enough; its terminal says which."
        };
        json!({
            "most_bytes": self.most_bytes(), "died": died,
            "too_big": {
                "heading": self.asks_for_more(),
                "text": format!("Here a file may have {}. It was not read.", bytes(self.most_bytes())),
                "ways": [self.way_out()],
            },
        })
    }
}

/// Of powers of two, as people say them.
fn bytes(count: u64) -> String {
    if count >= 1 << 30 { format!("{} GB", count >> 30) } else { format!("{} MB", count >> 20) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The measurements beside the constants, each within a quarter.
    #[test]
    fn memory_is_said_as_it_was_measured() {
        let sides = [128.0, 256.0, 512.0, 1024.0, 1400.0, 2048.0, 4096.0];
        for (place, k, measured) in [
            (Host::BROWSER, 0, &[9.0, 12.8, 43.3, 153.0, 280.0, 932.0, 3701.0][..]),
            (Host::BROWSER, 1, &[17.6, 62.9, 243.0, 987.0]),
            (Host::machine(2), 0, &[36.0, 45.0, 113.0, 329.0]),
            (Host::machine(2), 1, &[51.0, 104.0, 330.0]),
        ] {
            for (side, measured) in sides.into_iter().zip(measured) {
                let said = place.memory(side * side)[k] / 1e6;
                assert!((said / measured - 1.0).abs() < 0.27, "{side}: {said} and {measured}");
            }
        }
    }

    #[test]
    fn limits_are_said_as_they_are() {
        assert_eq!(Host::BROWSER.limits_said(), "4096 × 4096 points and a file of 512 MB");
        assert_eq!(Host::machine(2).limits_said(), "16384 × 16384 points and a file of 4 GB");
        assert!(Host::BROWSER.way_out().contains(&Host::machine(1).limits_said()[..13]));
    }
}
