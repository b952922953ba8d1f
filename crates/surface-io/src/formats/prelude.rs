//! What most readers need.

pub(super) use crate::binary::{ByteOrder, Bytes, Cursor, Sample};
pub(super) use crate::entries::Entries;
pub(super) use crate::measurement::{Channel, Contents, Pixel};
pub(super) use crate::{ReadError, metres_per};
pub(super) use std::collections::BTreeMap;
