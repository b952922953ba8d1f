//! The one table of formats.

use crate::ReadError;
use crate::formats;
use crate::limits::Limits;
use crate::measurement::Contents;

macro_rules! formats {
    ($($(#[$cfg:meta])? $variant:ident, $name:literal, $extensions:expr, $sniff:path, $parse:path;)*) => {
        /// A file format.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Format {
            $(#[doc = $name] $variant,)*
            /// ZIP archive holding one of the others.
            Zip,
        }

        impl Format {
            /// Its name for people.
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name,)* Self::Zip => "ZIP" }
            }
        }

        /// Every format this build reads, in the order in which they are tried.
        pub const FORMATS: &[FormatSpec] = &[
            $($(#[$cfg])? FormatSpec {
                format: Format::$variant,
                extensions: $extensions,
                sniff: $sniff,
                parse: $parse,
            },)*
        ];
    };
}

formats! {
    #[cfg(feature = "zip")]
    X3p, "X3P (ISO 25178-72)", &["x3p"], formats::x3p::sniff, formats::x3p::parse;
    Npy, "NPY", &["npy"], formats::npy::sniff, formats::npy::parse;
    Text, "text", &["csv", "asc", "tsv", "txt", "xyz", "dat"],
        formats::table::sniff, formats::table::parse;
}

impl std::fmt::Display for Format {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

pub(crate) type Parse = for<'a> fn(&'a [u8], &Limits) -> Result<Contents<'a>, ReadError>;

/// One row of [`FORMATS`].
#[derive(Debug, Clone, Copy)]
pub struct FormatSpec {
    /// Which format.
    pub format: Format,
    /// Usual file name extensions; information only, files are recognised by content.
    pub extensions: &'static [&'static str],
    pub(crate) sniff: fn(&[u8]) -> bool,
    pub(crate) parse: Parse,
}

/// The format of `bytes`, by content.
pub(crate) fn sniff(bytes: &[u8]) -> Option<&'static FormatSpec> {
    FORMATS.iter().find(|spec| (spec.sniff)(bytes))
}
