//! The closed form at the ends of its inputs: each case with its relative error.
#![allow(clippy::print_stdout, reason = "the lines are the purpose")]

#[path = "../tests/extremes.rs"]
mod extremes;

fn main() {
    for case in extremes::cases() {
        let error = case.error().map_or("beyond the doubles".to_owned(), |e| format!("{e:.1e}"));
        println!("{}: {error}", case.place);
    }
}
