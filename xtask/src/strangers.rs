//! What a stranger meets who takes one crate of ours: it can be packaged with all files it needs, and it can be used from
//! outside.

use crate::shell::{self, TaskResult, cargo, packages, read, root};
use serde_json::Value;
use std::path::Path;

/// Files of which every published crate has a copy, and of what.
const COPIES: [(&str, &str); 3] = [
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("LICENSE-APACHE", "LICENSE-APACHE"),
    ("katex-header.html", "docs/katex-header.html"), // what lets docs.rs show formulas
];

pub(crate) fn run() -> TaskResult {
    package()?;
    run_external()
}

/// Programs under `fixtures/external`, each a workspace of its own, as somebody else would write them.
fn run_external() -> TaskResult {
    let folder = root().join("fixtures/external");
    let entries =
        std::fs::read_dir(&folder).map_err(|e| format!("no {}: {e}", folder.display()))?;
    let folders = entries.flatten().map(|entry| entry.path());
    // Beside them lie results of other programs.
    let mut programs: Vec<_> = folders.filter(|f| f.join("Cargo.toml").is_file()).collect();
    programs.sort();
    for program in &programs {
        // The versions of the workspace above; a lock file of its own would be one more to keep.
        std::fs::copy(root().join("Cargo.lock"), program.join("Cargo.lock"))
            .map_err(|e| format!("cannot copy Cargo.lock: {e}"))?;
        // The folder that it writes to, and the examples in its documentation.
        for (what, args) in [("run", &["--", "target/external"][..]), ("test", &["--doc"])] {
            let mut run = cargo();
            // The flags of .cargo/config.toml name a file by its path from here.
            run.env("RUSTDOCFLAGS", "");
            run.args([what, "--quiet", "--offline", "--target-dir", "target"]);
            run.arg("--manifest-path").arg(program.join("Cargo.toml"));
            shell::run(run.args(args))?;
        }
    }
    println!("external programs: {} built and run", programs.len());
    Ok(())
}

/// `cargo package` of all published crates at once, so that they find each other; each has its licence and a page of its own.
fn package() -> TaskResult {
    let mut package = cargo();
    package.args(["package", "--quiet", "--locked", "--no-verify", "--allow-dirty"]);
    let mut count = 0;
    let is_published = |p: &Value| p["publish"].as_array().is_none_or(|r| !r.is_empty());
    for krate in packages(&["--no-deps"])?.iter().filter(|krate| is_published(krate)) {
        let text = |key: &str| krate[key].as_str().unwrap_or_default();
        let folder = Path::new(text("manifest_path")).parent().unwrap_or(Path::new(""));
        read(&folder.join("README.md"))?;
        for (copy, of) in COPIES {
            if read(&folder.join(copy))? != read(&root().join(of))? {
                return Err(format!("{}/{copy} is not {of}", folder.display()));
            }
        }
        package.args(["-p", text("name")]);
        count += 1;
    }
    shell::run(&mut package)?;
    println!("packages: {count}");
    Ok(())
}
