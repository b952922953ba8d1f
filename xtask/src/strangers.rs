//! What a stranger meets who takes one crate of ours: it can be packaged with all files it needs,
//! and the example on its front page compiles with that crate as the only dependency.

use crate::shell::{self, TaskResult, cargo, output, read, root};
use serde_json::Value;
use std::fmt::Write;
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
    compile_front_pages(&published)?;
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
    let text =
        output(cargo().args(["metadata", "--no-deps", "--locked", "--format-version", "1"]))?;
    let metadata: Value =
        serde_json::from_str(&text).map_err(|e| format!("cargo metadata is not JSON: {e}"))?;
    let packages = metadata["packages"].as_array().ok_or("cargo metadata names no packages")?;
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

/// Writes a workspace with one crate for each of ours, whose program is the front-page example and
/// whose only dependency is ours, and checks it.
fn compile_front_pages(published: &[Published]) -> TaskResult {
    let folder = root().join("target/strangers");
    let write = |path: &Path, text: &str| {
        let parent = path.parent().unwrap_or(&folder);
        std::fs::create_dir_all(parent)
            .and_then(|()| std::fs::write(path, text))
            .map_err(|e| format!("cannot write {}: {e}", path.display()))
    };
    let mut members = String::new();
    let mut compiled = 0;
    for krate in published {
        let Some(library) = &krate.library else { continue };
        let example = front_page_example(&front_page(Path::new(&krate.folder))?)
            .ok_or_else(|| format!("{} has no example on its front page", krate.folder))?;
        let name = format!("stranger-of-{}", krate.package);
        let _ = write!(members, "\"{name}\", ");
        let manifest = format!(
            "[package]\nname = \"{name}\"\nedition = \"2024\"\npublish = false\n\n[dependencies]\n\
             {library} = {{ package = \"{}\", path = '{}' }}\n",
            krate.package, krate.folder
        );
        write(&folder.join(&name).join("Cargo.toml"), &manifest)?;
        write(&folder.join(&name).join("src/main.rs"), &program(&example))?;
        compiled += 1;
    }
    write(
        &folder.join("Cargo.toml"),
        &format!("[workspace]\nresolver = \"3\"\nmembers = [{members}]\n"),
    )?;
    std::fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock"))
        .map_err(|e| format!("cannot copy Cargo.lock: {e}"))?;
    let mut check = cargo();
    check.current_dir(&folder).args(["check", "--quiet", "--workspace", "--offline"]);
    check.arg("--target-dir").arg(root().join("target"));
    shell::run(&mut check)?;
    println!("front pages: {compiled} examples compile with one dependency each");
    Ok(())
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

/// The example as a program.
fn program(example: &str) -> String {
    if example.contains("fn main()") {
        return example.to_owned();
    }
    let end = if example.contains("Ok::<") { "" } else { "Ok(())\n" };
    format!("fn main() -> Result<(), Box<dyn std::error::Error>> {{\n{example}{end}}}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_page_example_is_found() {
        let page = "Title.\n\n```math\na\n```\n\n```\n# use a::B;\nlet b = B;\n```\nText.\n";
        assert_eq!(front_page_example(page).unwrap(), "use a::B;\nlet b = B;\n");
        assert_eq!(front_page_example("```math\na\n```\n"), None);
    }
}
