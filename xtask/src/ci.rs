//! Everything a change must pass, in the order in which failures are cheap. The last step is
//! the test command of the README. All steps run even if one fails.

use crate::TaskResult;
use crate::shell::{self, cargo, shown};
use std::process::Command;
use std::time::Instant;

fn run_all(slow: bool) -> TaskResult {
    let mut steps = vec![
        step(&["fmt", "--all", "--check"]),
        step(&["xtask", "tidy"]),
        step(&["clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"]),
        documentation(),
        step(&["xtask", "docs", "--check"]),
        step(&["xtask", "costs", "--check"]),
        step(&["test", "--workspace", "--locked"]),
    ];
    if slow {
        steps.insert(5, step(&["test", "--workspace", "--locked", "--", "--ignored"]));
        steps.insert(5, step(&["xtask", "figures", "--check"]));
        steps.insert(5, step(&["xtask", "extremes", "--check"]));
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

fn step(args: &[&str]) -> Command {
    let mut command = cargo();
    command.args(args);
    command
}

fn documentation() -> Command {
    let mut command = step(&["doc", "--workspace", "--no-deps", "--locked"]);
    // The flags of .cargo/config.toml would be replaced, so they are repeated.
    command.env("RUSTDOCFLAGS", "-D warnings");
    command
}

pub(crate) fn run(args: &[String]) -> TaskResult {
    match args {
        [] => run_all(false),
        [flag] if flag == "--slow" => run_all(true),
        other => Err(format!("unknown arguments {other:?}; the only one is --slow")),
    }
}
