//! The closed form at the ends of its inputs: each case with its relative error.
#![allow(clippy::print_stdout, reason = "the lines are the purpose")]

#[path = "../tests/extremes/cases.rs"]
mod cases;

fn main() {
    for case in cases::all() {
        let error =
            case.error().map_or("beyond the doubles".to_owned(), |error| format!("{error:.1e}"));
        println!("{} at {}: {error}", case.quantity, case.argument);
    }
}
