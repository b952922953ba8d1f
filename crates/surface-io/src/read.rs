//! From bytes to a [`Measurement`].

use crate::catalogue::{FormatSpec, recognise};
use crate::error::ReadError;
use crate::measurement::Measurement;
use crate::options::{Limits, ReadOptions};
use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::Path;

/// Reads a surface from a file. The format is recognised by content, never by name.
///
/// # Errors
/// [`ReadError`]: see its variants. A missing unit or pixel size is
/// [`ReadError::MissingScale`], which tells what is needed.
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Measurement, ReadError> {
    read_bytes(&load(path, &options.limits)?, options)
}

/// Reads a surface from the bytes of a file.
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
    recognised(bytes, options, FormatSpec::read)
}

/// Reads all traces from the bytes of a file that holds several of one surface: columns of heights beside one
/// column of positions. Any other file, and any file of which a channel is asked for, gives the one
/// measurement that [`read`] gives.
///
/// # Errors
/// As [`read`].
pub fn read_traces_bytes(
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Vec<Measurement>, ReadError> {
    recognised(bytes, options, FormatSpec::read_traces)
}

/// Reads `bytes`, or the file packed in them, as the format that they are.
fn recognised<T>(
    bytes: &[u8],
    options: &ReadOptions,
    read: fn(&FormatSpec, &[u8], &ReadOptions) -> Result<T, ReadError>,
) -> Result<T, ReadError> {
    #[cfg(feature = "zip")]
    let unpacked = crate::formats::archive::unwrap_single(bytes, options)?;
    #[cfg(feature = "zip")]
    let bytes = &*unpacked;
    read(recognise(bytes)?, bytes, options)
}

/// The bytes of a file within the limit.
///
/// # Errors
/// [`ReadError::Io`].
pub fn load(path: impl AsRef<Path>, limits: &Limits) -> Result<Vec<u8>, ReadError> {
    let path = path.as_ref();
    let io = |source| ReadError::Io { path: path.to_owned(), source };
    let file = File::open(path).map_err(io)?;
    let facts = file.metadata().map_err(io)?;
    if facts.is_dir() {
        let what = "this is a directory; name a file in it";
        return Err(io(Error::new(ErrorKind::IsADirectory, what)));
    }
    let too_large = |value| {
        let what = format!("the file has {value} bytes, the limit is {}", limits.file_bytes);
        io(Error::new(ErrorKind::FileTooLarge, what))
    };
    if facts.len() > limits.file_bytes {
        return Err(too_large(facts.len()));
    }
    let mut bytes = Vec::with_capacity(facts.len() as usize);
    // A device or a growing file can deliver more than its metadata promises.
    file.take(limits.file_bytes.saturating_add(1)).read_to_end(&mut bytes).map_err(io)?;
    if bytes.len() as u64 > limits.file_bytes {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}
