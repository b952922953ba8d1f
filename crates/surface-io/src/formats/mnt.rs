//! MNT of Digital Surf (MountainsMap documents) is recognised so that its users learn what to
//! do, and not read: it is an OLE compound document whose content is not published, and what
//! others have found out about it does not fix the pixel size better than to 0.2 %.

use crate::measurement::Contents;
use crate::{Format, Limits, ReadError};

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1")
}

pub(crate) fn parse<'a>(_: &'a [u8], _: &Limits) -> Result<Contents<'a>, ReadError> {
    Err(ReadError::Unsupported {
        format: Format::Mnt,
        feature: "reading an OLE compound document (MountainsMap MNT: save the surface as SUR; a \
                  spreadsheet: save it as CSV)"
            .into(),
    })
}
