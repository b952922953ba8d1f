//! The statistics at the ends of their inputs, as a Markdown table: which numbers, what is extreme,
//! what they are compared with, what the test allows, and the largest relative error.
//!
//! ```console
//! $ cargo run --release -p surface-stats --example statistics_extremes
//! ```
#![allow(clippy::print_stdout, reason = "the table is the purpose")]

#[path = "../tests/common/mod.rs"]
mod common;

fn main() {
    println!("| what | extreme | compared with | the test allows | worst relative error |");
    println!("|---|---|---|---|---|");
    for case in common::extremes::cases() {
        let (what, extreme, compared_with) = (case.what, &case.extreme, case.compared_with);
        let limit = match case.limit {
            0.0 => "0".to_owned(),
            1.0 => "1".to_owned(),
            limit => format!("{limit:e}").replace('-', "\u{2212}"),
        };
        let error = match (case.error, case.limit) {
            (0.0, 0.0) => "none".to_owned(),
            (error, _) => format!("{error:.1e}"),
        };
        println!("| {what} | {extreme} | {compared_with} | {limit} | {error} |");
    }
}
