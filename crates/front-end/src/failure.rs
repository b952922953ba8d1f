//! Why there is no complete answer.

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::path::Path;

/// Why there is no complete answer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// One word for the kind of trouble.
    pub kind: String,
    /// What, the value, the limit, the way out.
    pub message: String,
    /// Exit status of the command: 1, something was not finished; 2, refused.
    pub status: u8,
}

impl Failure {
    /// Input that cannot be answered: exit status 2 of the command.
    pub fn refused(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.to_owned(), message: message.into(), status: 2 }
    }

    /// Work that was started but not finished: exit status 1.
    pub fn incomplete(kind: &str, message: impl Into<String>) -> Self {
        Self { kind: kind.to_owned(), message: message.into(), status: 1 }
    }

    /// A refusal by one of the libraries, the name of the file in front; an empty path is no file.
    pub fn in_file<E: std::error::Error>(path: &Path, error: &E) -> Self {
        let message = error.to_string();
        let shown = path.display().to_string();
        let message =
            if message.contains(&shown) { message } else { format!("{shown}: {message}") };
        Self::refused(&variant(error), message)
    }

    /// The same with the way out behind it; nothing if there is none.
    #[must_use]
    pub fn adding(mut self, way_out: &str) -> Self {
        if !way_out.is_empty() {
            self.message = format!("{}; {way_out}", self.message);
        }
        self
    }

    /// Both: the messages one after the other, the graver exit status.
    #[must_use]
    pub(crate) fn and(self, other: Self) -> Self {
        let kind = if other.status > self.status { other.kind } else { self.kind };
        let message = format!("{}\n{}", self.message, other.message);
        Self { kind, message, status: self.status.max(other.status) }
    }

    /// For scripts.
    pub fn json(&self) -> Value {
        json!({ "kind": self.kind, "message": self.message })
    }
}

impl<E: std::error::Error> From<&E> for Failure {
    /// A refusal by one of the libraries. Its kind is the name of the error's variant.
    fn from(error: &E) -> Self {
        Self::refused(&variant(error), error.to_string())
    }
}

/// The name of an enum's variant in snake case, from its `Debug` form.
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
