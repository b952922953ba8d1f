//! How the command ends: standard output, standard error, exit status.

pub(crate) use rough_contact::front_end::Failure;
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;

/// An answer: the text a person reads and the object a script reads.
pub(crate) struct Reply {
    pub(crate) text: String,
    pub(crate) json: Value,
    /// What went wrong although there is something to print.
    pub(crate) trouble: Option<Failure>,
}

impl Reply {
    pub(crate) fn new(text: String, json: Value) -> Self {
        Self { text, json, trouble: None }
    }
}

/// Bad usage, as clap says it, in one paragraph.
pub(crate) fn usage(error: &clap::Error) -> Failure {
    let text = error.to_string();
    let text = text.trim().trim_start_matches("error: ");
    Failure::refused("usage", text)
}

/// A refusal of what a file is or holds.
pub(crate) fn unfit(path: &Path, kind: &str, why: impl std::fmt::Display) -> Failure {
    Failure::refused(kind, format!("{}: {why}", path.display()))
}

pub(crate) fn exists(path: &Path) -> Failure {
    let message = format!(
        "{} exists and would be overwritten; give --force to replace it, or another name",
        path.display()
    );
    Failure::refused("output_exists", message)
}

pub(crate) fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    let message = format!(
        "{} cannot be written: {error}; choose a folder that exists and may be written to",
        path.display()
    );
    Failure::incomplete("output", message)
}

/// Writes a line to standard error. Who closed it does not want it.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Writes help or version, as far as the reader wants it.
pub(crate) fn show(help: &str) {
    let mut stdout = std::io::stdout().lock();
    let _ = stdout.write_all(help.as_bytes()).and_then(|()| stdout.flush());
}

/// Writes the reply or the failure and chooses the exit status.
pub(crate) fn finish(result: Result<Reply, Failure>, json: bool) -> ExitCode {
    let (text, object, failure) = match result {
        Ok(mut reply) => {
            if let Some(trouble) = &reply.trouble {
                reply.json["error"] = trouble.json();
            }
            (reply.text, reply.json, reply.trouble)
        }
        Err(failure) => (String::new(), json!({ "error": failure.json() }), Some(failure)),
    };
    let out = if json { format!("{object:#}\n") } else { text };
    let mut stdout = std::io::stdout().lock();
    // A reader that closes the pipe early, as `head` does, has seen what it wanted.
    let written = stdout.write_all(out.as_bytes()).and_then(|()| stdout.flush());
    if let Some(failure) = failure {
        tell(&format!("rough-contact: {}", failure.message));
        return ExitCode::from(failure.status);
    }
    match written {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            tell(&format!("rough-contact: standard output cannot be written: {error}"));
            ExitCode::from(1)
        }
        _ => ExitCode::SUCCESS,
    }
}
