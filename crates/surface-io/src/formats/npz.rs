//! NPZ: a ZIP archive of NPY arrays, as `numpy.savez` writes it. Every array of one or two axes
//! is a channel; none has a unit or a pixel size. Single numbers called like one are named where
//! they are asked for, and not used: their unit is nowhere.
//!
//! Source: <https://numpy.org/doc/stable/reference/generated/numpy.savez.html>.

use super::archive::ends;
use super::npy::Array;
use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut archive = Archive::open(b)?;
    let mut contents = Contents::default();
    let mut first_error = None;
    for name in archive.names.clone().into_iter().filter(|name| ends(name, ".npy")) {
        let member = archive.unpack(&name)?;
        let name = &name[..name.len() - ".npy".len()];
        match Array::parse(b.with(&member)) {
            Ok(number) if number.shape == [1, 1] => {
                if let Some(value) = number.values(b.with(&member))?.first() {
                    contents.not_used(name, &value.to_string());
                }
            }
            Ok(array) => {
                let decode = move || array.values(b.with(&member));
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
