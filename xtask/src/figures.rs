//! The figures that README and book show: the paper's Figs. 1 and 2 for one built-in surface.

use crate::TaskResult;
use crate::generated::{check_flag, keep};
use crate::shell::{self, read, root, rough_contact};

/// Writes the figures, or checks that the committed ones are current.
pub(crate) fn run(args: &[String]) -> TaskResult {
    let check = check_flag(args)?;
    let folder = root().join("target/figures");
    let out = folder.display().to_string();
    let line = ["compare", "--quiet", "--force", "--out", &out].map(str::to_owned);
    shell::run(&mut rough_contact(&line))?;
    for name in ["area.svg", "pressure.svg"] {
        keep(&format!("docs/src/figures/{name}"), &read(&folder.join(name))?, check)?;
    }
    Ok(())
}
