//! The solver at the ends of its inputs: each case with its largest error, of pressure, area and gap.
#![allow(clippy::print_stdout, reason = "the lines are the purpose")]

#[path = "../tests/common/extremes.rs"]
mod cases;
#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/common/dense.rs"]
mod dense;

fn main() {
    for case in cases::cases() {
        let worst = case.errors.into_iter().fold(0.0, f64::max);
        println!("{}: {worst:.1e}", case.what);
    }
}
