//! Drives the criterion benchmarks and writes their table into the book.

use crate::generated::keep_section;
use crate::shell::{self, TaskResult, cargo, files, output, read, root};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// The benchmarks that the book shows; the others are for who changes the code.
const SHOWN: [&str; 4] = ["curve/", "kernels/transform", "read/", "solve/"];

const PAGE: &str = "docs/src/benchmarks.md";

/// Runs `cargo bench ARGS` (by default every benchmark of the workspace), then collects the
/// results that lie in `target/criterion`. `--check` compares the names on the page with those of the benchmarks.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let mut bench = cargo();
    bench.args(["bench", "--locked"]);
    if args == ["--check"] {
        return check(&output(bench.args(["--workspace", "--benches", "--", "--list"]))?);
    }
    if args.is_empty() {
        bench.arg("--workspace");
    }
    shell::run(bench.args(args))?;

    let mut rows = Vec::new();
    for path in files(&root().join("target/criterion"), "json") {
        let folder = path.parent().unwrap_or(Path::new("."));
        if path.ends_with("new/estimates.json") {
            rows.push(row(folder)?);
        }
    }
    rows.retain(|(id, _)| is_shown(id));
    rows.sort_by(|a, b| a.0.cmp(&b.0));
    let mut text = machine()?;
    text.push_str("\n| benchmark | time | spread | per pixel |\n|---|---:|---:|---:|\n");
    for (_, line) in rows {
        text.push_str(&line);
    }
    keep_section(PAGE, "benchmarks", &text, None)
}

fn is_shown(id: &str) -> bool {
    SHOWN.iter().any(|group| id.starts_with(group))
}

/// The page has the benchmarks that criterion lists, and no others.
fn check(list: &str) -> TaskResult {
    let listed = list.lines().filter_map(|line| line.strip_suffix(": benchmark"));
    let listed: BTreeSet<&str> = listed.filter(|id| is_shown(id)).collect();
    let page = read(&root().join(PAGE))?;
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let differ: Vec<&str> =
        rows.collect::<BTreeSet<_>>().symmetric_difference(&listed).copied().collect();
    if differ.is_empty() {
        Ok(())
    } else {
        Err(format!("only in {PAGE} or only in the benchmarks: {}", differ.join(", ")))
    }
}

/// The id of one benchmark and its line of the table.
fn row(folder: &Path) -> Result<(String, String), String> {
    let json = |name: &str| -> Result<Value, String> {
        let text = read(&folder.join(name))?;
        serde_json::from_str(&text).map_err(|e| format!("{name} is not JSON: {e}"))
    };
    let (id, estimates) = (json("benchmark.json")?, json("estimates.json")?);
    let name = id["full_id"].as_str().unwrap_or("?").to_owned();
    let median = estimates["median"]["point_estimate"].as_f64().unwrap_or(f64::NAN);
    let spread = estimates["median_abs_dev"]["point_estimate"].as_f64().unwrap_or(f64::NAN);
    let per_pixel = match id["throughput"]["Elements"].as_f64() {
        Some(elements) if elements > 0.0 => duration(median / elements),
        _ => "–".to_owned(),
    };
    let percent = 100.0 * spread / median;
    let line = format!("| `{name}` | {} | {percent:.1} % | {per_pixel} |\n", duration(median));
    Ok((name, line))
}

/// Nanoseconds, in a unit that needs no powers.
fn duration(ns: f64) -> String {
    match ns {
        ns if ns < 1e3 => format!("{ns:.2} ns"),
        ns if ns < 1e6 => format!("{:.2} µs", ns / 1e3),
        ns if ns < 1e9 => format!("{:.2} ms", ns / 1e6),
        ns => format!("{:.2} s", ns / 1e9),
    }
}

/// Where the numbers come from.
pub(crate) fn machine() -> Result<String, String> {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| {
        let line = text.lines().find(|l| l.starts_with("model name"))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let rustc = output(Command::new("rustc").arg("--version"))?;
    let commit = output(Command::new("git").args(["rev-parse", "--short", "HEAD"]))?;
    let mut text = String::new();
    let _ = writeln!(
        text,
        "Machine: {}, {cores} hardware threads, {}; {}; commit {}.",
        cpu.as_deref().unwrap_or("unknown processor"),
        std::env::consts::OS,
        rustc.trim(),
        commit.trim()
    );
    Ok(text)
}
