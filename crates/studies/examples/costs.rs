//! What representative calls of every crate allocate, as a Markdown table.
//!
//! ```console
//! $ cargo run --release -p studies --example costs
//! ```
#![allow(clippy::print_stdout, reason = "the table is the purpose")]

#[path = "../tests/allocations/cases.rs"]
mod cases;

use cases::Case;

/// Rows and columns of the map.
const SIDE: usize = 1001;

fn main() {
    println!("| crate | call | allocations | peak |");
    println!("|---|---|---|---|");
    for case in cases::all(SIDE) {
        let (count, peak) = (count(case.found.count_total), peak(&case));
        println!("| `{}` | {} | {count} | {peak} |", case.package, case.call);
    }
}

/// Rounded up to a power of ten: plans of transforms differ with the vector unit of the machine.
fn count(allocations: u64) -> String {
    match allocations {
        0 => "none".to_owned(),
        n => format!("< {}", 10_u64.pow(n.ilog10() + 1)),
    }
}

/// What is held at once beyond what was there.
fn peak(case: &Case) -> String {
    match (case.found.bytes_max, case.arrays()) {
        (0, _) => "0".to_owned(),
        (_, Some(maps)) if maps >= 0.05 => format!("{maps:.1} maps"),
        (_, Some(_)) => "< 0.05 maps".to_owned(),
        (bytes, None) => format!("{bytes} bytes"),
    }
}
