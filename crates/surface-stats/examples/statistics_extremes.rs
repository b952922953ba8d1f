//! The statistics at the ends of their inputs: each case with its largest relative error.
#![allow(clippy::print_stdout, reason = "the lines are the purpose")]

#[path = "../tests/common/extremes.rs"]
mod cases;

fn main() {
    for case in cases::cases() {
        println!("{}: {:.1e}", case.what, case.error);
    }
}
