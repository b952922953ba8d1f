//! What goes out: one JSON object per line, as soon as it is known.

use serde_json::Value;
use std::io::Write;

/// A stream of messages, each a line: `progress`, then one `done` or `error`.
pub struct Messages<'a> {
    out: &'a mut (dyn Write + Send),
    fault: Option<std::io::Error>,
}

impl std::fmt::Debug for Messages<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Messages").field("fault", &self.fault).finish_non_exhaustive()
    }
}

impl<'a> Messages<'a> {
    /// To this writer.
    pub fn new(out: &'a mut (dyn Write + Send)) -> Self {
        Self { out, fault: None }
    }

    /// One message. After the first that could not be written the others are left out.
    pub(crate) fn tell(&mut self, kind: &str, mut message: Value) {
        message["kind"] = kind.into();
        if self.fault.is_none() {
            let written = writeln!(self.out, "{message}").and_then(|()| self.out.flush());
            self.fault = written.err();
        }
    }

    /// Whether nobody listens any more.
    pub(crate) fn is_cut(&self) -> bool {
        self.fault.is_some()
    }

    /// # Errors
    /// What the writer said first.
    pub fn end(self) -> std::io::Result<()> {
        self.fault.map_or(Ok(()), Err)
    }
}
