//! Files of instruments, and files made like them, against their expected values.

use crate::shell::{TaskResult, released, run as start};

/// Checks every file of `--dir DIR` against `--expected FILE`, one line each. The work is done
/// by an example of `surface-io`, built in release; relative paths are the caller's.
pub(crate) fn run(args: &[String]) -> TaskResult {
    start(released("surface-io", &[], ["--example", "check_surfaces"]).args(args))
}
