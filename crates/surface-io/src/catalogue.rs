//! How each format is recognised and read.

use crate::binary::Bytes;
use crate::error::ReadError;
use crate::finish::{finish, finish_traces};
use crate::format::{Format, every_format};
use crate::measurement::{Contents, Measurement};
#[cfg(feature = "zip")]
use crate::ole;
use crate::options::ReadOptions;
use crate::{formats, text, tiff};
use std::borrow::Cow;

macro_rules! rows {
    ($($(#[$cfg:meta])? $variant:ident, $module:ident, $sniff:expr, $name:literal, [$($extension:literal),*], $about:literal;)*) => {
        /// Every format this build knows, in the order in which they are tried.
        pub const FORMATS: &[FormatSpec] = &[
            $($(#[$cfg])? FormatSpec {
                format: Format::$variant,
                extensions: &[$($extension),*],
                about: $about,
                sniff: $sniff,
                parse: formats::$module::parse,
            },)*
        ];
    };
}

every_format!(rows);

type Parse = for<'a> fn(Bytes<'a>) -> Result<Contents<'a>, ReadError>;

/// One row of [`FORMATS`].
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct FormatSpec {
    /// Which format.
    pub format: Format,
    /// Usual file name extensions; information only, files are recognised by content.
    pub extensions: &'static [&'static str],
    /// What is read, in a few words.
    pub about: &'static str,
    sniff: fn(&[u8]) -> bool,
    parse: Parse,
}

impl FormatSpec {
    /// Reads `bytes` as this format, whatever they look like.
    ///
    /// # Errors
    /// As [`read_bytes`](crate::read_bytes).
    pub fn read(&self, bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
        finish(self.format, self.contents(bytes, options)?, options)
    }

    /// Every trace in `bytes`, see [`read_traces`](crate::read_traces).
    pub(crate) fn read_traces(
        &self,
        bytes: &[u8],
        options: &ReadOptions,
    ) -> Result<Vec<Measurement>, ReadError> {
        finish_traces(self.format, self.contents(bytes, options)?, options)
    }

    /// What is in `bytes`, with nothing decoded yet.
    fn contents<'a>(
        &self,
        bytes: &'a [u8],
        options: &ReadOptions,
    ) -> Result<Contents<'a>, ReadError> {
        match options.layout {
            _ if self.format == Format::Text => formats::table::parse_as(bytes, options),
            None => (self.parse)(Bytes::little(bytes, self.format, options.limits)),
            Some(layout) => Err(ReadError::BadLayout {
                format: self.format,
                layout,
                reason: Cow::Borrowed("only the columns of a text can be more than one thing"),
            }),
        }
    }
}

/// The format of `bytes`, by content.
pub(crate) fn recognise(bytes: &[u8]) -> Result<&'static FormatSpec, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    if let Some(error) = formats::foreign::recognise(bytes) {
        return Err(error);
    }
    FORMATS.iter().find(|spec| (spec.sniff)(bytes)).ok_or_else(|| {
        if bytes.starts_with(b"PK\x03\x04") {
            let what = "the list of files at its end cannot be read: it was cut off, or is damaged";
            return Format::Zip.field("archive", what);
        }
        let start = bytes[..bytes.len().min(16)].escape_ascii().to_string();
        ReadError::UnknownFormat { start }
    })
}
