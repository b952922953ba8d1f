//! How the command ends: what goes to standard output, what to standard error, and the exit
//! status.

use serde_json::{Value, json};
use std::io::Write;
use std::process::ExitCode;

/// An answer: the text a person reads and the object a script reads.
pub(crate) struct Reply {
    pub(crate) text: String,
    pub(crate) json: Value,
    /// What went wrong although there is something to print: exit status 1, or 2 if it was a
    /// refusal.
    pub(crate) trouble: Option<Failure>,
}

impl Reply {
    pub(crate) fn new(text: String, json: Value) -> Self {
        Self { text, json, trouble: None }
    }
}

/// Why there is no complete answer. The message says what, the value, the limit, the way out.
#[derive(Debug)]
pub(crate) struct Failure {
    kind: String,
    message: String,
    status: u8,
}

impl Failure {
    /// Input that cannot be answered: exit status 2.
    pub(crate) fn refused(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.to_owned(), message: message.into(), status: 2 }
    }

    /// Work that was started but not finished: exit status 1.
    pub(crate) fn incomplete(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.to_owned(), message: message.into(), status: 1 }
    }

    /// A refusal by one of the libraries. Its kind is the name of the error's variant.
    pub(crate) fn from_error<E: std::error::Error>(error: &E) -> Self {
        Self::refused(&variant(error), error.to_string())
    }

    /// The same with the name of the file in front.
    pub(crate) fn in_file<E: std::error::Error>(path: &std::path::Path, error: &E) -> Self {
        let message = error.to_string();
        let shown = path.display().to_string();
        let message =
            if message.contains(&shown) { message } else { format!("{shown}: {message}") };
        Self::refused(&variant(error), message)
    }

    /// The same with the way out behind it; nothing if there is none.
    pub(crate) fn adding(mut self, way_out: &str) -> Self {
        if !way_out.is_empty() {
            self.message = format!("{}; {way_out}", self.message);
        }
        self
    }

    /// Bad usage, as clap says it, in one paragraph.
    pub(crate) fn usage(error: &clap::Error) -> Self {
        let text = error.to_string();
        let text = text.trim().trim_start_matches("error: ");
        Self::refused("usage", text)
    }

    /// The file is not touched because it exists.
    pub(crate) fn exists(path: &std::path::Path) -> Self {
        let message = format!(
            "{} exists and would be overwritten; give --force to replace it, or another name",
            path.display()
        );
        Self::refused("output_exists", message)
    }

    /// A file could not be written.
    pub(crate) fn unwritable(path: &std::path::Path, error: &std::io::Error) -> Self {
        let message = format!(
            "{} cannot be written: {error}; choose a folder that exists and may be written to",
            path.display()
        );
        Self::incomplete("output", message)
    }

    /// Both: the messages one after the other, the graver exit status.
    pub(crate) fn and(self, other: Self) -> Self {
        let kind = if other.status > self.status { other.kind } else { self.kind };
        let message = format!("{}\n{}", self.message, other.message);
        Self { kind, message, status: self.status.max(other.status) }
    }

    /// For scripts.
    pub(crate) fn json(&self) -> Value {
        json!({ "kind": self.kind, "message": self.message })
    }

    /// The whole of it, as [`Failure::of_json`] reads it.
    pub(crate) fn json_with_status(&self) -> Value {
        json!({ "kind": self.kind, "message": self.message, "status": self.status })
    }

    /// What was written by [`Failure::json_with_status`].
    pub(crate) fn of_json(value: &Value) -> Option<Self> {
        Some(Self {
            kind: value.get("kind")?.as_str()?.to_owned(),
            message: value.get("message")?.as_str()?.to_owned(),
            status: value.get("status")?.as_u64()?.try_into().ok()?,
        })
    }

    /// What, the value, the limit, the way out.
    pub(crate) fn message(&self) -> &str {
        &self.message
    }
}

/// The name of an enum's variant in snake case, from its `Debug` form: one word for the kind of
/// trouble, for scripts.
pub(crate) fn variant(error: &impl std::fmt::Debug) -> String {
    let debug = format!("{error:?}");
    let mut name = String::new();
    for c in debug.chars().take_while(|c| c.is_alphanumeric()) {
        if c.is_uppercase() && !name.is_empty() {
            name.push('_');
        }
        name.extend(c.to_lowercase());
    }
    name
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
