//! The one file that a browser opens: markup, style, scripts, and the engine as text.

use crate::place::Host;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;

const HTML: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/page.css");
/// Who answers: the module inside the page, or the program that has served it.
const ENGINE: &str = include_str!("../page/engine.js");
const PROGRAM: &str = include_str!("../page/program.js");
/// The rest, in the order in which they need each other.
const SCRIPT: &str = concat!(
    include_str!("../page/parts.js"),
    include_str!("../page/surface.js"),
    include_str!("../page/bodies.js"),
    include_str!("../page/kept.js"),
    include_str!("../page/running.js"),
    include_str!("../page/page.js"),
);
/// Runs beside the page, where a long computation does not stop it.
const WORKER: &str = concat!(include_str!("../page/wasi.js"), include_str!("../page/worker.js"));

/// The page with this engine, a module for `wasm32-wasip1`: one file that needs no other and no network. The engine is
/// in it compressed.
///
/// # Errors
/// None in practice: it is written to memory.
pub fn page(engine: &[u8]) -> std::io::Result<String> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(engine)?;
    let engine = format!(
        "<script type=\"text/plain\" id=\"worker\">{WORKER}</script>\n\
         <script type=\"text/plain\" id=\"engine\">{}</script>",
        STANDARD.encode(packed.finish()?)
    );
    let policy = "script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; worker-src blob:; frame-src 'self' blob:";
    Ok(joined(policy, Host::BROWSER, &engine, ENGINE))
}

/// The page that asks the program which has served it: `start` and the other questions of [`answer`](crate::answer) at
/// `ask/QUESTION` below its own address, with the request as JSON in the first line of the body and the file behind it.
pub fn page_of_program(place: Host) -> String {
    let policy = "script-src 'unsafe-inline'; connect-src 'self'; frame-src 'self'";
    joined(policy, place, "", PROGRAM)
}

fn joined(policy: &str, place: Host, engine: &str, asking: &str) -> String {
    HTML.replace("<!--policy-->", policy)
        .replace("/*style*/", &format!("{}{STYLE}", contact_report::style()))
        .replace("<!--where-->", &place.where_said())
        .replace("<!--engine-->", engine)
        .replace("/*script*/", &format!("{asking}{SCRIPT}"))
}
