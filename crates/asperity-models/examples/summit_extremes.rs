//! Bush-Gibson-Thomas at the ends of its inputs, as a Markdown table: what comes back, the value to
//! twenty digits, and the relative error. m0 = m2 = E* = 1.
//!
//! ```console
//! $ cargo run --release -p asperity-models --example summit_extremes
//! ```
#![allow(clippy::print_stdout, reason = "the table is the purpose")]

#[path = "../tests/extremes/cases.rs"]
mod cases;

fn main() {
    println!("| quantity | bandwidth | argument | answer | reference | error |");
    println!("|---|---|---|---|---|---|");
    for case in cases::all() {
        println!(
            "| {} | {} | {} | {} | {} | {} |",
            case.quantity,
            case.bandwidth,
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
