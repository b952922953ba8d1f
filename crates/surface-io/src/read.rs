//! From bytes to a [`Measurement`].

use crate::format::{self, Format, FormatSpec};
use crate::measurement::{Channel, Contents, Pixel};
use crate::{ChannelInfo, Layout, Limits, Measurement, Place, ReadError};
use contact_types::Grid;
use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// What the file does not say, and which part of it is wanted.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReadOptions {
    /// Channel by name, or `#2` for the second; default is the first height channel.
    pub channel: Option<String>,
    /// `[dy, dx]` in metres: the distance between neighbouring points. Overrides the file, which
    /// is then noted in the metadata.
    pub pixel: Option<[f64; 2]>,
    /// Metres per unit of the heights in the file. Overrides the file, which is then noted in
    /// the metadata.
    pub height_unit: Option<f64>,
    /// What the columns of a text file are; default is what its header and numbers say, and three
    /// columns without a header a list x y z.
    pub layout: Option<Layout>,
    /// What reading may cost.
    pub limits: Limits,
}

/// Reads a surface from a file. The format is recognised by content, never by name.
///
/// # Errors
/// [`ReadError`]: see its variants. A missing unit or pixel size is
/// [`ReadError::MissingScale`], which names the option to give it with.
pub fn read(path: impl AsRef<Path>, options: &ReadOptions) -> Result<Measurement, ReadError> {
    read_bytes(&load(path.as_ref(), &options.limits)?, options)
}

/// Reads a surface from the bytes of a file.
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], options: &ReadOptions) -> Result<Measurement, ReadError> {
    let bytes = unwrap_container(bytes, &options.limits)?;
    recognise(&bytes)?.read(&bytes, options)
}

/// Lists the channels of a file without decoding them.
///
/// # Errors
/// As [`read`], except that nothing is refused for missing units or being no height.
pub fn read_channels(
    path: impl AsRef<Path>,
    limits: &Limits,
) -> Result<Vec<ChannelInfo>, ReadError> {
    read_channels_bytes(&load(path.as_ref(), limits)?, limits)
}

/// Lists the channels in the bytes of a file.
///
/// # Errors
/// As [`read_channels`].
pub fn read_channels_bytes(bytes: &[u8], limits: &Limits) -> Result<Vec<ChannelInfo>, ReadError> {
    let bytes = unwrap_container(bytes, limits)?;
    let spec = recognise(&bytes)?;
    Ok((spec.parse)(&bytes, limits)?.channels.iter().map(Channel::info).collect())
}

fn load(path: &Path, limits: &Limits) -> Result<Vec<u8>, ReadError> {
    let io = |source| ReadError::Io { path: path.to_owned(), source };
    let file = File::open(path).map_err(io)?;
    let facts = file.metadata().map_err(io)?;
    if facts.is_dir() {
        return Err(io(std::io::Error::new(
            std::io::ErrorKind::IsADirectory,
            "this is a directory; name a file in it",
        )));
    }
    let too_large = |value| {
        let what = format!("the file has {value} bytes, the limit is {}", limits.file_bytes);
        io(std::io::Error::new(std::io::ErrorKind::FileTooLarge, what))
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

#[cfg(feature = "zip")]
fn unwrap_container<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Cow<'a, [u8]>, ReadError> {
    crate::formats::archive::unwrap_single(bytes, limits)
}

#[cfg(not(feature = "zip"))]
#[allow(clippy::unnecessary_wraps, reason = "the other build can fail")]
fn unwrap_container<'a>(bytes: &'a [u8], _: &Limits) -> Result<Cow<'a, [u8]>, ReadError> {
    Ok(Cow::Borrowed(bytes))
}

fn recognise(bytes: &[u8]) -> Result<&'static FormatSpec, ReadError> {
    if bytes.is_empty() {
        return Err(ReadError::Empty);
    }
    format::sniff(bytes).ok_or_else(|| {
        let start = bytes[..bytes.len().min(16)].escape_ascii().to_string();
        ReadError::UnknownFormat { start }
    })
}

/// Chooses the channel, decodes it and brings it to metres.
pub(crate) fn finish(
    format: Format,
    mut contents: Contents<'_>,
    options: &ReadOptions,
) -> Result<Measurement, ReadError> {
    let channels: Vec<ChannelInfo> = contents.channels.iter().map(Channel::info).collect();
    let chosen = choose(format, &channels, options.channel.as_deref())?;
    let channel = contents.channels.swap_remove(chosen);
    let mut metadata = contents.metadata;

    if let Some([dy, dx]) = options.pixel {
        for value in [dy, dx] {
            positive("--pixel", value)?;
        }
        if let Pixel::Steps([step_y, step_x]) = channel.pixel
            && channel.shape[0] > 1
            && channel.shape[1] > 1
            && ((dy / dx) / (step_y / step_x) - 1.0).abs() > 1e-3
        {
            return Err(ReadError::PixelContradicts { dx, dy, step_x, step_y });
        }
        if let Pixel::Metres([dy, dx]) = channel.pixel {
            metadata.insert("overridden pixel".into(), format!("{dx:e} m, {dy:e} m"));
        }
    }
    if let Some(unit) = options.height_unit {
        positive("--height-unit", unit)?;
        if let Some(unit) = &channel.unit {
            metadata.insert("overridden height unit".into(), unit.clone());
        }
    }
    let pixel = options.pixel.or(match channel.pixel {
        Pixel::Metres(pixel) => Some(pixel),
        _ => None,
    });
    let scale = options.height_unit.or(channel.scale);
    let (Some(pixel), Some(scale)) = (pixel, scale) else {
        return Err(ReadError::MissingScale {
            format,
            pixel: pixel.is_none(),
            height: scale.is_none(),
        });
    };

    options.limits.check_points(format, channel.shape)?;
    let malformed = |place, what: String| ReadError::Malformed { format, place, what: what.into() };
    let grid = Grid::new(channel.shape, pixel)
        .map_err(|e| malformed(Place::Field("grid".into()), e.to_string()))?;
    let mut heights = (channel.decode)()?;
    if heights.len() != grid.len() {
        let what = format!("{} heights for {} points", heights.len(), grid.len());
        return Err(malformed(Place::Field("data".into()), what));
    }
    let mut missing = 0;
    for (i, height) in heights.iter_mut().enumerate() {
        *height *= scale;
        if height.is_nan() {
            missing += 1;
        } else if height.is_infinite() {
            let [_, nx] = grid.shape();
            let place = Place::Point { iy: i / nx, ix: i % nx };
            return Err(malformed(place, format!("the height is {height}")));
        }
    }
    Ok(Measurement {
        grid,
        heights,
        missing,
        format,
        channel: channel.name,
        channels,
        metadata,
        is_profile: channel.is_profile,
        uneven: channel.uneven,
        ambiguity: channel.ambiguity,
    })
}

fn positive(option: &'static str, value: f64) -> Result<(), ReadError> {
    if value.is_normal() && value > 0.0 {
        Ok(())
    } else {
        Err(ReadError::BadOption { option, value })
    }
}

/// Index of the channel asked for, or of the first one that is a height.
fn choose(
    format: Format,
    channels: &[ChannelInfo],
    asked: Option<&str>,
) -> Result<usize, ReadError> {
    let quoted = |only_heights: bool| {
        let names: Vec<String> = channels
            .iter()
            .enumerate()
            .filter(|(_, c)| c.is_height || !only_heights)
            .map(|(i, c)| format!("{:?} (#{})", c.name, i + 1))
            .collect();
        if names.is_empty() { "(the file has none)".to_owned() } else { names.join(", ") }
    };
    let Some(asked) = asked else {
        // A stated unit of length is better than no unit at all.
        let with_unit = channels.iter().position(|c| c.is_height && c.unit.is_some());
        return match with_unit.or_else(|| channels.iter().position(|c| c.is_height)) {
            Some(index) => Ok(index),
            None => Err(match channels.first() {
                Some(first) => ReadError::NotHeight {
                    format,
                    channel: first.name.clone(),
                    unit: first.unit.clone().unwrap_or_default(),
                    heights: quoted(true),
                },
                None => ReadError::Unsupported {
                    format,
                    feature: "a file without any map or profile".into(),
                },
            }),
        };
    };
    let number = asked.strip_prefix('#').and_then(|n| n.parse::<usize>().ok());
    let index = channels
        .iter()
        .position(|c| c.name == asked)
        .or_else(|| channels.iter().position(|c| c.name.eq_ignore_ascii_case(asked)))
        .or_else(|| number.and_then(|n| n.checked_sub(1)).filter(|&n| n < channels.len()))
        .ok_or_else(|| ReadError::NoSuchChannel {
            format,
            asked: asked.to_owned(),
            available: quoted(false),
        })?;
    let channel = &channels[index];
    if channel.is_height {
        return Ok(index);
    }
    Err(ReadError::NotHeight {
        format,
        channel: channel.name.clone(),
        unit: channel.unit.clone().unwrap_or_default(),
        heights: quoted(true),
    })
}
