//! What most readers need.

#[cfg(feature = "zip")]
pub(super) use super::archive::Archive;
pub(super) use crate::binary::{ByteOrder, Bytes, Cursor, Sample, find, text};
pub(super) use crate::entries::Entries;
pub(super) use crate::measurement::{Channel, Contents, Pixel};
#[cfg(feature = "zip")]
pub(super) use crate::xml;
pub(super) use crate::{ReadError, metres_per, text};
pub(super) use std::collections::BTreeMap;
