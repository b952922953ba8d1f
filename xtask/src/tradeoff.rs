//! Time against true error: every closed form, and the solver over methods, grids, precisions and
//! tolerances. Measures, then draws the figures and the page from the table.

use crate::bench::machine;
use crate::generated::{CHECK, Check, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/tradeoff.csv";
const PAGE: &str = "docs/src/tradeoff.md";

/// Measures and writes table, figures and page. `--figures-only` draws the committed table again; `--check` verifies
/// that figures and page follow from it.
pub(crate) fn run(args: &[String]) -> TaskResult {
    match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => {
            keep(TABLE, &measure()?, None)?;
            redraw(None)
        }
        ["--figures-only"] => redraw(None),
        ["--check"] => redraw(CHECK),
        ref other => {
            Err(format!("unknown arguments {other:?}; one of --figures-only, --check, or none"))
        }
    }
}

/// Figures and page from the committed table, or whether they are what they would be.
fn redraw(check: Check) -> TaskResult {
    let folder = root().join("target/tradeoff-page");
    shell::run(example("studies", "tradeoff").args(["--page", TABLE]).arg(&folder))?;
    for name in ["tradeoff-area.svg", "tradeoff-pressure.svg"] {
        keep(&format!("docs/src/figures/{name}"), &read(&folder.join(name))?, check)?;
    }
    keep_section(PAGE, "tradeoff", &read(&folder.join("tradeoff.md"))?, check)
}

/// The table with the machine it was measured on, and how busy that was.
fn measure() -> Result<String, String> {
    let machine = machine()?;
    let before = load_average();
    let table = output(&mut example("studies", "tradeoff"))?;
    let load = before.zip(load_average()).map_or(String::new(), |(before, after)| {
        format!("# Load average of the machine: {before} before, {after} at the end, this run included.\n")
    });
    Ok(format!("# Made by 'cargo xtask study tradeoff'.\n# {}\n{load}{table}", machine.trim()))
}

/// Load average over the last minute, where the system tells.
fn load_average() -> Option<String> {
    let text = std::fs::read_to_string("/proc/loadavg").ok()?;
    text.split_whitespace().next().map(str::to_owned)
}
