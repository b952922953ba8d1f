//! The study, as `rough-contact compare` runs it: the same code, built in release.

use crate::shell::{self, TaskResult, root, rough_contact};

/// Where the study goes when nothing else is asked for.
pub(crate) const FOLDER: &str = "target/compare";

/// Without arguments: the built-in surfaces into `target/compare/`, replacing an earlier run.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut line = vec!["compare".to_owned()];
    line.extend_from_slice(args);
    if !args.iter().any(|a| a == "--out" || a.starts_with("--out=")) {
        let folder = root().join(FOLDER);
        line.extend(["--out".to_owned(), folder.display().to_string(), "--force".to_owned()]);
    }
    shell::run(&mut rough_contact(&line))
}
