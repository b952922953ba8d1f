//! What one map says of another, on unkind surfaces: table and page.

use crate::generated::{check_flag, keep, keep_section};
use crate::shell::{self, TaskResult, example, output, read, root};

const TABLE: &str = "fixtures/sample.csv";
const PAGE: &str = "docs/src/finite-sample.md";

/// Runs what is left of the study and writes its table and page; with `--check`, redoes the page from
/// the committed table and compares.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    if !check {
        let folder = |name: &str| root().join("target").join(name).display().to_string();
        let judged = output(example("studies", "sample").arg(folder("sample")))?;
        let fresh = folder("sample-fresh");
        let fresh = output(example("studies", "sample").args(["--fresh", &fresh]))?;
        let tuning = folder("sample-tuning");
        let tuning = output(example("studies", "sample").args(["--tuning", &tuning]))?;
        let more = fresh.lines().skip(1).chain(tuning.lines().skip(1));
        let rows = more.fold(judged, |all, row| all + row + "\n");
        let origin = "# Maps of families of unkind surfaces with their finite-sample half widths; made by \
                      'cargo xtask sample' from its own seeds, columns in \
                      crates/studies/examples/sample/measure.rs";
        keep(TABLE, &format!("{origin}\n{rows}"), false)?;
    }
    let folder = root().join("target/sample-page");
    let out = folder.display().to_string();
    shell::run(example("studies", "sample").args(["--page", TABLE, &out]))?;
    keep_section(PAGE, "sample", &read(&folder.join("sample.md"))?, check)
}
