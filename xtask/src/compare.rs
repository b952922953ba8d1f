//! The study, as `rough-contact compare` runs it: of the built-in surfaces in the profile `first`, of others in release.

use crate::shell::{self, TaskResult, root, rough_contact};

/// Without arguments: the built-in surfaces into `target/compare/`, replacing an earlier run.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut compare = rough_contact(!args.is_empty());
    compare.arg("compare").args(args);
    if !args.iter().any(|a| a == "--out" || a.starts_with("--out=")) {
        compare.arg("--out").arg(root().join("target/compare")).arg("--force");
    }
    shell::run(&mut compare)
}
