//! NPZ: a ZIP archive of NPY arrays, as `numpy.savez` writes it. Every array of one or two axes
//! is a channel; none has a unit or a pixel size. Single numbers called like one are named where
//! they are asked for, and not used: their unit is nowhere.
//!
//! Source: <https://numpy.org/doc/stable/reference/generated/numpy.savez.html>.

use super::archive::{Archive, MAGIC, is_npy};
use super::npy::Array;
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError};

const FORMAT: Format = Format::Npz;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC) && crate::binary::find(bytes, b".npy").is_some()
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let mut archive = Archive::open(bytes, FORMAT, limits)?;
    let mut contents = Contents::default();
    let mut first_error = None;
    let mut total = 0;
    for name in archive.names.clone() {
        if !is_npy(&name) {
            continue;
        }
        let member = archive.unpack(&name, limits)?;
        total += member.len() as u64;
        limits.check_unpacked(FORMAT, total)?;
        let name = &name[..name.len() - ".npy".len()];
        match Array::parse(&member, FORMAT, limits) {
            Ok(number) if number.shape == [1, 1] => {
                if let Some(value) = number.values(&member)?.first() {
                    contents.not_used(name, &value.to_string());
                }
            }
            Ok(array) => {
                let decode = move || array.values(&member);
                let channel = Channel::new(name, None, array.shape, Pixel::Unknown, decode);
                contents.channels.push(channel);
            }
            // Texts beside a map are no reason to refuse it.
            Err(e @ ReadError::Unsupported { .. }) => {
                first_error.get_or_insert(e);
            }
            Err(e) => return Err(e),
        }
    }
    match first_error {
        Some(e) if contents.channels.is_empty() => Err(e),
        _ => Ok(contents),
    }
}
