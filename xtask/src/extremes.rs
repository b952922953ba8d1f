//! The page "each model at the ends of its inputs": every model crate prints its own table.

use crate::TaskResult;
use crate::generated::{check_flag, keep_section};
use crate::shell::{cargo, output};

/// Crates with an example `extremes`; each has a section of its name in the page.
const CRATES: [&str; 3] = ["gw-closed-form", "asperity-models", "multiscale-models"];

/// Writes the tables, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    for package in CRATES {
        let mut example = cargo();
        example.args(["run", "--quiet", "--release", "--locked", "-p", package]);
        let table = output(example.args(["--example", "extremes"]))?;
        let table: String = table.lines().map(by_decades).collect();
        keep_section("docs/src/extremes.md", package, &table, check)?;
    }
    Ok(())
}

/// A row with its last cell, a relative error, rounded up to a power of ten: the digits of an
/// error of a few roundings differ between platforms.
fn by_decades(row: &str) -> String {
    let cells: Vec<&str> = row.trim_end().trim_end_matches('|').split('|').collect();
    let (last, rest) = cells.split_last().unwrap_or((&"", &[]));
    let band = match last.trim().replace('\u{2212}', "-").parse::<f64>() {
        Ok(error) if error <= 2.3e-16 => "rounding".to_owned(),
        Ok(error) => format!("< 1e\u{2212}{}", -error.log10().floor() - 1.0),
        Err(_) => return format!("{row}\n"),
    };
    format!("{}| {band} |\n", rest.join("|"))
}
