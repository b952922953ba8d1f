//! What a stranger meets who takes one crate of ours: it can be packaged with all files it needs, and the example on
//! its front page takes that crate alone.

use crate::shell::{self, TaskResult, cargo, packages, read, root};
use serde_json::Value;
use std::path::Path;

/// A crate that strangers get.
struct Published {
    package: String,
    /// Name in `use`.
    library: Option<String>,
    folder: String,
}

pub(crate) fn run() -> TaskResult {
    let published = published()?;
    package(&published)?;
    check_front_pages(&published)?;
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

fn published() -> Result<Vec<Published>, String> {
    let packages = packages(&["--no-deps"])?;
    let is_published = |p: &&Value| p["publish"].as_array().is_none_or(|r| !r.is_empty());
    let of = |p: &Value| {
        let targets = p["targets"].as_array().into_iter().flatten();
        let library = targets.filter(|t| t["kind"][0] == "lib").find_map(|t| t["name"].as_str());
        Some(Published {
            package: p["name"].as_str()?.to_owned(),
            library: library.map(|name| name.replace('-', "_")),
            folder: p["manifest_path"].as_str()?.strip_suffix("/Cargo.toml")?.to_owned(),
        })
    };
    Ok(packages.iter().filter(is_published).filter_map(of).collect())
}

/// `cargo package` of all of them at once, so that they find each other; each has its licence and
/// a page of its own.
fn package(published: &[Published]) -> TaskResult {
    let mut header: Option<String> = None; // what lets docs.rs show formulas
    for krate in published {
        let folder = Path::new(&krate.folder);
        read(&folder.join("README.md"))?;
        if krate.library.is_some() {
            let own = read(&folder.join("katex-header.html"))?;
            if header.get_or_insert_with(|| own.clone()) != &own {
                return Err(format!(
                    "{}/katex-header.html is not that of the others",
                    krate.folder
                ));
            }
        }
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            if read(&folder.join(licence))? != read(&root().join(licence))? {
                return Err(format!("{}/{licence} is not that of the workspace", krate.folder));
            }
        }
    }
    let mut package = cargo();
    package.args(["package", "--quiet", "--locked", "--no-verify", "--allow-dirty"]);
    for krate in published {
        package.args(["-p", &krate.package]);
    }
    shell::run(&mut package)?;
    println!("packages: {}", published.len());
    Ok(())
}

/// Every front page has an example, which its tests compile; here it is seen to name no other crate than its own.
fn check_front_pages(published: &[Published]) -> TaskResult {
    let lock = read(&root().join("Cargo.lock"))?;
    let named = lock.lines().filter_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'));
    let crates: Vec<String> = named.map(|name| name.replace('-', "_")).collect();
    for krate in published {
        let Some(library) = &krate.library else { continue };
        let example = front_page_example(&front_page(Path::new(&krate.folder))?)
            .ok_or_else(|| format!("{} has no example on its front page", krate.folder))?;
        let mut others = roots(&example).filter(|root| root != library);
        if let Some(other) = others.find(|root| crates.iter().any(|name| name == root)) {
            return Err(format!("the example of {library} needs another crate, {other}"));
        }
    }
    println!("front pages: each example takes its own crate alone");
    Ok(())
}

/// What paths begin with.
fn roots(example: &str) -> impl Iterator<Item = &str> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    example.match_indices("::").filter_map(move |(end, _)| {
        let before = &example[..end];
        let start = before.rfind(|c| !is_name(c)).map_or(0, |i| i + 1);
        (!before[..start].ends_with("::")).then_some(&before[start..])
    })
}

/// The first page of a crate's documentation: its README where `lib.rs` includes that, else the
/// comment at the top.
fn front_page(folder: &Path) -> Result<String, String> {
    let library = read(&folder.join("src/lib.rs"))?;
    if library.contains("include_str!(\"../README.md\")") {
        return read(&folder.join("README.md"));
    }
    let comment = library.lines().map_while(|line| line.strip_prefix("//!"));
    let lines = comment.map(|line| line.strip_prefix(' ').unwrap_or(line));
    Ok(lines.flat_map(|line| [line, "\n"]).collect())
}

/// The first Rust example of the page, without the marks of hidden lines.
fn front_page_example(page: &str) -> Option<String> {
    let mut lines = page.lines();
    while let Some(opening) = lines.find(|line| line.starts_with("```")) {
        let inside = lines.by_ref().take_while(|line| !line.starts_with("```"));
        let shown = inside
            .map(|line| if line == "#" { "" } else { line.strip_prefix("# ").unwrap_or(line) });
        let text: String = shown.flat_map(|line| [line, "\n"]).collect();
        if matches!(opening, "```" | "```rust" | "```no_run") {
            return Some(text);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_page_example_is_found() {
        let page = "Title.\n\n```math\na\n```\n\n```\n# use a::B;\nlet b = B;\n```\nText.\n";
        assert_eq!(front_page_example(page).unwrap(), "use a::B;\nlet b = B;\n");
        assert_eq!(front_page_example("```math\na\n```\n"), None);
        let found: Vec<_> =
            roots("use a::{b::C, d};\nlet x = d::e() + f64::from(C::new::<u8>());\n").collect();
        assert_eq!(found, ["a", "b", "d", "f64", "C"]);
    }
}
