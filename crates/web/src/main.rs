//! The engine of the page: a question and its request as arguments, the file on standard input, one JSON object per
//! line on standard output. Built for `wasm32-wasip1` it runs in a browser; built for this machine it answers the same,
//! and `contact-web page ENGINE.wasm` puts the page together.

use contact_web::{Host, Messages, answer, page};
use std::io::{Read, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["page", engine] => std::fs::read(engine)
            .and_then(|engine| page(&engine))
            .and_then(|page| std::io::stdout().write_all(page.as_bytes())),
        [question, request] => answered(question, request),
        _ => Err(std::io::Error::other("give a question and a request, or: page ENGINE.wasm")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("contact-web: {error}");
            ExitCode::FAILURE
        }
    }
}

fn answered(question: &str, request: &str) -> std::io::Result<()> {
    let mut file = Vec::new();
    std::io::stdin().read_to_end(&mut file)?;
    let mut out = std::io::stdout();
    let mut messages = Messages::new(&mut out);
    answer(question, request, &file, Host::BROWSER, &mut messages);
    messages.end()
}
