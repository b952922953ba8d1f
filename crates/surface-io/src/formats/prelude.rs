//! What most readers need.

pub(super) use crate::binary::{ByteOrder, Bytes, Sample};
pub(super) use crate::entries::Entries;
pub(super) use crate::measurement::{Channel, Contents, Pixel};
pub(super) use crate::{Format, ReadError, metres_per};
pub(super) use std::collections::BTreeMap;
