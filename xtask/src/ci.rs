//! Everything a change must pass, in the order in which failures are cheap; among the steps is the
//! test command of the README. All steps run even if one fails.

use crate::shell::{self, TaskResult, cargo, shown};
use std::process::Command;
use std::time::Instant;

/// What runs, besides what every change must pass.
#[derive(Clone, Copy, PartialEq)]
enum Also {
    Nothing,
    /// Tests that take minutes, and the solver in Node.
    Slow,
    /// What needs more than the Rust toolchain: Python and the package index; Chromium and Node.
    All,
}

/// Studies whose pages are compared with what they would be, which takes seconds.
const PAGES: [&str; 4] = ["tables", "costs", "coverage", "tradeoff"];

fn run_all(also: Also) -> TaskResult {
    let mut steps = vec![
        step(&["fmt", "--all", "--check"]),
        step(&["xtask", "check", "tidy"]),
        clippy()?,
        documentation(),
        step(&["xtask", "check", "strangers"]),
        step(&["test", "--workspace", "--locked"]),
    ];
    steps.extend(PAGES.map(check));
    if also == Also::All {
        for script in ["workflows", "python", "web"] {
            steps.push(Command::new(shell::root().join(".ci").join(script)));
        }
    }
    if also == Also::Slow {
        steps.push(step(&["xtask", "check", "features"]));
        steps.push(check("extremes"));
        steps.push(step(&["xtask", "figures", "--check"]));
        steps.push(step(&["xtask", "bench", "--check"]));
        steps.push(step(&["test", "--workspace", "--locked", "--", "--ignored"]));
        steps.push(Command::new(shell::root().join(".ci/wasm")));
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

/// Verifies that what a study writes is current, with the programs that the tests have built.
fn check(study: &str) -> Command {
    let mut command = step(&["xtask", "study", study, "--check"]);
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

pub(crate) fn run(args: &[String]) -> TaskResult {
    match args {
        [] => run_all(Also::Nothing),
        [flag] if flag == "--slow" => run_all(Also::Slow),
        [flag] if flag == "--all" => run_all(Also::All),
        other => Err(format!("unknown arguments {other:?}; there are --slow and --all")),
    }
}
