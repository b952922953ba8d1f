//! The one file that a browser opens: markup, style, scripts, and the engine as text.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;

const HTML: &str = include_str!("../page/page.html");
const STYLE: &str = include_str!("../page/page.css");
/// In the order in which they need each other.
const SCRIPT: &str = concat!(
    include_str!("../page/engine.js"),
    include_str!("../page/parts.js"),
    include_str!("../page/surface.js"),
    include_str!("../page/bodies.js"),
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
    Ok(HTML
        .replace("/*style*/", &format!("{}{STYLE}", report::style()))
        .replace("<!--engine-->", &engine)
        .replace("/*script*/", SCRIPT))
}
