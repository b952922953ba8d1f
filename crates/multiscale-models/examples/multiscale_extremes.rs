//! Each model at the ends of its inputs: each case with its relative error.
#![allow(clippy::print_stdout, reason = "the lines are the purpose")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
#[path = "../tests/all/extremes.rs"]
mod extremes;

fn main() {
    for case in extremes::cases() {
        let error = case.error().map_or("refused".to_owned(), |error| format!("{error:.1e}"));
        println!("{}: {error}", case.place);
    }
}
