//! Everything a change must pass, in the order in which failures are cheap; among the steps is the
//! test command of the README. All steps run even if one fails.

use crate::shell::{self, TaskResult, cargo, shown};
use std::process::Command;
use std::time::Instant;

/// Tasks whose pages are compared with what they would be, which takes seconds.
const PAGES: [&str; 5] =
    ["validate", "study tables", "study costs", "study coverage", "study tradeoff"];

/// `--slow` adds tests that take minutes, and the solver in Node; `--all` what needs more than the Rust toolchain: Python
/// and the package index, Chromium and Node.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut steps = vec![
        step(&["fmt", "--all", "--check"]),
        step(&["xtask", "check", "tidy"]),
        clippy()?,
        documentation(),
        step(&["xtask", "check", "strangers"]),
        step(&["test", "--workspace", "--locked"]),
    ];
    steps.extend(PAGES.map(check));
    let script = |name: &str| Command::new(shell::root().join(".ci").join(name));
    match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => {}
        ["--all"] => steps.extend(["workflows", "python", "web"].map(script)),
        ["--slow"] => steps.extend([
            step(&["xtask", "check", "features"]),
            check("study extremes"),
            step(&["xtask", "figures", "--check"]),
            step(&["xtask", "bench", "--check"]),
            step(&["test", "--workspace", "--locked", "--", "--ignored"]),
            script("wasm"),
        ]),
        ref other => {
            return Err(format!("unknown arguments {other:?}; there are --slow and --all"));
        }
    }
    let mut failed = Vec::new();
    for step in &mut steps {
        println!("\n== {}", shown(step));
        let start = Instant::now();
        match shell::run(step) {
            Ok(()) => println!("== passed in {:.0} s", start.elapsed().as_secs_f64()),
            Err(message) => {
                println!("== FAILED: {message}");
                failed.push(shown(step));
            }
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(format!("failed: {}", failed.join("; "))) }
}

/// Verifies that what a task writes is current, with the programs that the tests have built.
fn check(task: &str) -> Command {
    let mut command = step(&["xtask"]);
    command.args(task.split(' ')).arg("--check");
    command.env(shell::BUILT, "1");
    command
}

fn step(args: &[&str]) -> Command {
    let mut command = cargo();
    command.args(args);
    command
}

/// The compiler whose lints are denied. A newer one may bring lints that nobody has looked at yet:
/// they are shown and break nothing.
const LINTS: &str = "1.95";

fn clippy() -> Result<Command, String> {
    let mut command = step(&["clippy", "--workspace", "--all-targets", "--locked"]);
    let version = shell::output(cargo().arg("--version"))?;
    if version.split(' ').nth(1).is_some_and(|v| v.starts_with(&format!("{LINTS}."))) {
        command.args(["--", "-D", "warnings"]);
    } else {
        println!("lints are denied with Rust {LINTS} only, this is {}", version.trim());
    }
    Ok(command)
}

fn documentation() -> Command {
    let mut command = step(&["doc", "--workspace", "--no-deps", "--locked"]);
    // The flags of .cargo/config.toml would be replaced, so they are repeated.
    command.env("RUSTDOCFLAGS", "-D warnings");
    command
}
