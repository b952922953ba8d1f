//! The page "what each part costs": dependencies, allocations, build times.

use crate::bench::machine;
use crate::counters::public_names;
use crate::dependencies::{LAYERS, brought_along};
use crate::generated::{CHECK, keep_section};
use crate::shell::{self, TaskResult, cargo, example, files, output, read, root};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const PAGE: &str = "docs/src/costs.md";

/// By how much, relatively, a peak may differ from the page: transforms have other plans, and
/// scratch of other sizes, on machines with other vector units.
const PEAK: f64 = 0.05;

/// Writes the tables of dependencies and allocations, or checks that they are current; or
/// measures the builds.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = match args {
        [] => None,
        [flag] if flag == "--check" => CHECK,
        [flag] if flag == "--build" => return keep_section(PAGE, "builds", &builds()?, None),
        other => return Err(format!("unknown arguments {other:?}; there are --check and --build")),
    };
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

/// Programs whose size is shown: package, arguments that build it, where it lies.
const PROGRAMS: [(&str, [&str; 2], &str); 3] = [
    ("gw-closed-form", ["--example", "by_hand"], "examples/by_hand"),
    ("fft-bem-solver", ["--example", "hertz"], "examples/hertz"),
    ("rough-contact", ["--bin", "rough-contact"], "rough-contact"),
];

/// Builds every library from nothing: processor seconds, which do not depend on the number of jobs.
fn builds() -> Result<String, String> {
    let target = root().join("target/costs");
    let mut table = machine()?;
    table.push_str("Optimised builds (`--release`) with all they need; processor seconds.\n\n");
    table.push_str("| crate | from clean |\n|---|---:|\n");
    let is_library = |name: &&str| !["rough-contact", "studies", "xtask"].contains(name);
    for package in LAYERS.iter().map(|row| row.0).filter(is_library) {
        if target.exists() {
            std::fs::remove_dir_all(&target).map_err(|e| format!("cannot clean: {e}"))?;
        }
        let before = processor_seconds()?;
        shell::run(build(&target, package).arg("--lib"))?;
        let spent = processor_seconds()? - before;
        let _ = writeln!(table, "| `{package}` | {spent:.0} s |");
    }
    table.push_str("\n| program, stripped | size |\n|---|---:|\n");
    for (package, args, path) in PROGRAMS {
        shell::run(build(&target, package).args(args))?;
        let file = target.join("release").join(path);
        let size = std::fs::metadata(&file).map_err(|e| format!("no {}: {e}", file.display()))?;
        let (_, name) = path.rsplit_once('/').unwrap_or(("", path));
        let megabytes = size.len() as f64 / 1e6;
        let _ = writeln!(table, "| `{name}` of `{package}` | {megabytes:.2} MB |");
    }
    Ok(table)
}

/// Of the programs that this one has started and seen end (Linux: hundredths in `/proc/self/stat`).
fn processor_seconds() -> Result<f64, String> {
    let text = read(Path::new("/proc/self/stat"))?;
    let fields = text.rsplit(')').next().unwrap_or_default().split_whitespace();
    let spent = fields.skip(13).take(2).map(|ticks| ticks.parse::<f64>().unwrap_or(0.0));
    Ok(spent.sum::<f64>() / 100.0)
}

fn build(target: &Path, package: &str) -> Command {
    let mut build = cargo();
    build.args(["build", "--quiet", "--release", "--locked", "-p", package]);
    build.arg("--target-dir").arg(target).env("CARGO_PROFILE_RELEASE_STRIP", "symbols");
    build
}
