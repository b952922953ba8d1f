//! The study, as `rough-contact compare` runs it: of the built-in surfaces in the profile `first`, of others in release.

use crate::shell::{self, TaskResult, root, rough_contact};

/// Without arguments: the built-in surfaces into `target/compare/`, replacing an earlier run.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut line = vec!["compare".to_owned()];
    line.extend_from_slice(args);
    if !args.iter().any(|a| a == "--out" || a.starts_with("--out=")) {
        let folder = root().join("target/compare");
        line.extend(["--out".to_owned(), folder.display().to_string(), "--force".to_owned()]);
    }
    shell::run(&mut rough_contact(&line, !args.is_empty()))
}
