//! The solver at the ends of its inputs, as a Markdown table: the surface, what is extreme, the
//! solution it is compared with, the FFT pairs of the longest solve, and the largest errors.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example solver_extremes
//! ```
#![allow(clippy::print_stdout, reason = "the table is the purpose")]

#[path = "../tests/common/extremes.rs"]
mod cases;
#[path = "../tests/common/mod.rs"]
mod common;
#[path = "../tests/common/dense.rs"]
mod dense;

fn main() {
    println!("| surface | extreme | compared with | FFT pairs | pressure | area | gap |");
    println!("|---|---|---|---|---|---|---|");
    for case in cases::cases() {
        let (what, extreme, compared_with) = (case.what, case.extreme, case.compared_with);
        let [pressure, area, gap] = [0, 1, 2].map(|i| match (case.errors[i], case.limits[i]) {
            (0.0, 0.0) => "none".to_owned(),
            (error, _) => format!("{error:.1e}"),
        });
        let pairs = case.pairs.ceil();
        println!(
            "| {what} | {extreme} | {compared_with} | {pairs} | {pressure} | {area} | {gap} |"
        );
    }
}
