//! The closed form at the ends of its inputs, as a Markdown table: what comes back, the value to
//! twenty digits, and the relative error.
//!
//! ```console
//! $ cargo run --release -p gw-closed-form --example gw_extremes
//! ```
#![allow(clippy::print_stdout, reason = "the table is the purpose")]

#[path = "../tests/extremes/cases.rs"]
mod cases;

fn main() {
    println!("| quantity | argument | answer | reference | error |");
    println!("|---|---|---|---|---|");
    for case in cases::all() {
        println!(
            "| {} | {} | {} | {} | {} |",
            case.quantity,
            minus(case.argument),
            minus(&format!("{:.16e}", case.answer)),
            minus(case.reference_text),
            case.error_text(),
        );
    }
}

/// The true minus sign, for the eye.
fn minus(number: &str) -> String {
    number.replace('-', "\u{2212}")
}
