//! Error bars where a surface is not smooth between its points: table and page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/flat-tops.csv";
const PAGE: &str = "docs/src/flat-tops.md";

/// Runs what is left of the study and writes its table and page; with `--check`, redoes the page from
/// the committed table and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    if !check {
        let folder = |name: &str| root().join("target").join(name).display().to_string();
        let judged = output(example("studies", "flat_tops").arg(folder("flat-tops")))?;
        let fresh = folder("flat-tops-fresh");
        let fresh = output(example("studies", "flat_tops").args(["--fresh", &fresh]))?;
        let tuning = folder("flat-tops-tuning");
        let tuning = output(example("studies", "flat_tops").args(["--tuning", &tuning]))?;
        let more = fresh.lines().skip(1).chain(tuning.lines().skip(1));
        let rows = more.fold(judged, |all, row| all + row + "\n");
        let origin = "# Intervals on maps that are not smooth between their points; made by 'cargo \
                      xtask flat-tops' from its own seeds, columns in \
                      crates/studies/examples/flat_tops/measure.rs";
        keep(TABLE, &format!("{origin}\n{rows}"), false)?;
    }
    let folder = root().join("target/flat-tops-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "flat_tops").args(["--page", TABLE, &out]))?;
    keep_section(PAGE, "flat-tops", &read(&folder.join("flat-tops.md"))?, check)
}
