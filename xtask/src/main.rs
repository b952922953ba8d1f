//! Developer tasks: `cargo xtask <task>`.
#![allow(clippy::print_stdout, reason = "a command-line tool prints")]

fn main() {
    println!("tasks: (being added)");
}
