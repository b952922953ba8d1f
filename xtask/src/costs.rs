//! The page "what each part costs": dependencies and allocations.

use crate::counters::public_names;
use crate::dependencies::{LAYERS, brought_along};
use crate::generated::{check_flag, keep_section};
use crate::shell::{TaskResult, example, files, output, root};
use std::collections::BTreeSet;
use std::fmt::Write;

const PAGE: &str = "docs/src/costs.md";

/// By how much, relatively, a peak may differ from the page: transforms have other plans, and
/// scratch of other sizes, on machines with other vector units.
const PEAK: f64 = 0.05;

/// Writes the tables of dependencies and allocations, or checks that they are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    keep_section(PAGE, "dependencies", &dependencies()?, check)?;
    let allocations = output(&mut example("studies", "costs"))?;
    keep_section(PAGE, "allocations", &allocations, check.map(|_| PEAK))
}

fn dependencies() -> Result<String, String> {
    let mut table =
        String::from("| crate | of ours | from the registry (limit) | public names |\n");
    table.push_str("|---|---:|---:|---:|\n");
    for &(package, _, limit, _) in LAYERS.iter().filter(|row| row.0 != "xtask") {
        let [own, others] = brought_along(package)?.map(|crates| crates.len());
        let names: usize = sources(package).iter().map(|text| public_names(text)).sum();
        let _ = writeln!(table, "| `{package}` | {own} | {others} ({limit}) | {names} |");
    }
    Ok(table)
}

/// The sources of a crate, whose folder may lack the beginning of its name.
fn sources(package: &str) -> Vec<String> {
    let short = package.strip_prefix("contact-").unwrap_or(package);
    let folders = [package, short].map(|name| root().join("crates").join(name).join("src"));
    let paths = folders.iter().flat_map(|folder| files(folder, "rs")).collect::<BTreeSet<_>>();
    paths.iter().filter_map(|path| std::fs::read_to_string(path).ok()).collect()
}
