//! The page that computes in a browser, as one file.

use crate::generated::keep;
use crate::shell::{self, TaskResult, cargo, output, root};
use std::process::Command;

/// The system interface that the engine of the page is built for: arguments, one file in, lines out.
const TARGET: &str = "wasm32-wasip1";

pub(crate) fn run() -> TaskResult {
    let installed = output(Command::new("rustup").args(["target", "list", "--installed"]))?;
    if !installed.lines().any(|line| line == TARGET) {
        return Err(format!("the engine is built for {TARGET}: rustup target add {TARGET}"));
    }
    let mut engine = cargo();
    engine.args(["build", "--locked", "--profile", "web", "--target", TARGET]);
    engine.args(["--package", "contact-web", "--bin", "contact-web"]);
    engine.env("RUSTFLAGS", "-C target-feature=+simd128");
    shell::run(&mut engine)?;
    let module = root().join("target").join(TARGET).join("web/contact-web.wasm");
    let mut page = cargo();
    page.args(["run", "--quiet", "--locked", "--package", "contact-web", "--", "page"]);
    let text = output(page.arg(&module))?;
    keep("target/page/rough-contact.html", &text, None)?;
    println!("{:.2} MB", text.len() as f64 / 1e6);
    Ok(())
}
