//! From what a reader found to a [`Measurement`]: chooses the channel, decodes it and brings it
//! to metres.

use crate::cells::{is_mark, mark_value};
use crate::error::ReadError;
use crate::meaning::{Meaning, UNUSED};
use crate::measurement::{ChannelInfo, Contents, Measurement, Pixel};
use crate::need::Need;
use crate::options::{HeightUnit, ReadOptions};
use contact_types::Grid;

/// No surface is higher than this (m).
const HIGHEST: f64 = 1e6;
/// The largest number of single precision, to the digits of a text.
const LARGEST: f64 = 3.402823e38;

/// Chooses the channel, decodes it and brings it to metres.
pub(crate) fn finish(
    format: &'static str,
    mut contents: Contents<'_>,
    options: &ReadOptions,
) -> Result<Measurement, ReadError> {
    let channels: Vec<ChannelInfo> = contents.channels.iter().map(|c| c.info.clone()).collect();
    let chosen = match choose(format, &channels, options) {
        Ok(chosen) => chosen,
        // A file whose only channels cannot be read is refused for the first one's reason.
        Err(error) => {
            let mut faults = contents.channels.into_iter().filter_map(|channel| channel.fault);
            let first = faults.next().filter(|_| options.channel.is_none());
            return Err(first.unwrap_or(error));
        }
    };
    let channel = contents.channels.swap_remove(chosen);
    if let Some(fault) = channel.fault {
        return Err(fault);
    }
    let mut metadata = contents.metadata;

    if let Some(given @ [dy, dx]) = options.pixel {
        positive(Need::PixelSize, dy)?;
        positive(Need::PixelSize, dx)?;
        let is_map = channel.info.shape.iter().all(|side| *side > 1);
        match channel.pixel {
            Pixel::Steps(steps @ [y, x]) if is_map && ((dy / dx) / (y / x) - 1.0).abs() > 1e-3 => {
                return Err(ReadError::PixelContradicts { given, steps });
            }
            Pixel::Metres([y, x]) if [dy / y, dx / x].iter().any(|r| (r - 1.0).abs() > 1e-9) => {
                metadata
                    .insert("overridden pixel".into(), format!("{x:e} m along x, {y:e} m along y"));
            }
            _ => {}
        }
    }
    if let Some(unit) = options.lateral_unit {
        positive(Need::LateralUnit, unit)?;
    }
    let pixel = options.pixel.or(match (channel.pixel, options.lateral_unit) {
        (Pixel::Metres(pixel), _) => Some(pixel),
        (Pixel::Steps(steps), Some(unit)) => Some(steps.map(|step| step * unit)),
        _ => None,
    });
    if let Some(given) = options.height_unit {
        positive(Need::HeightUnit, given.metres())?;
        let note = match (channel.scale, given) {
            (Some(own), HeightUnit::IfSilent(other)) if (own / other - 1.0).abs() <= 1e-9 => None,
            (Some(_), HeightUnit::IfSilent(_)) => Some("height unit of the file, kept"),
            _ => Some("overridden height unit"),
        };
        if let (Some(note), Some(unit)) = (note, &channel.info.unit) {
            metadata.insert(note.into(), unit.clone());
        }
    }
    let scale = match options.height_unit {
        Some(HeightUnit::Always(metres)) => Some(metres),
        given => channel.scale.or(given.map(HeightUnit::metres)),
    };
    let (Some(pixel), Some(scale)) = (pixel, scale) else {
        let lateral = match channel.pixel {
            Pixel::Steps(_) => Need::LateralUnit,
            _ => Need::PixelSize,
        };
        let mut needs = Vec::new();
        needs.extend(pixel.is_none().then_some(lateral));
        needs.extend(scale.is_none().then_some(Need::HeightUnit));
        let unused = metadata.remove(UNUSED);
        return Err(ReadError::MissingScale { format, needs, unused });
    };

    options.limits.check_points(format, channel.info.shape)?;
    let grid = Grid::new(channel.info.shape, pixel)
        .map_err(|e| ReadError::at(format, "grid", e.to_string()))?;
    let mut heights = (channel.decode)()?;
    for mark in options.missing.iter().filter_map(|mark| mark_value(mark)) {
        heights.iter_mut().filter(|z| is_mark(**z, mark)).for_each(|z| *z = f64::NAN);
    }
    if heights.len() != grid.len() {
        let what = format!("{} heights for {} points", heights.len(), grid.len());
        return Err(ReadError::at(format, "data", what));
    }
    // A file that says what its unit is and means this is damaged; numbers whose unit was given
    // may be anything.
    let highest = if options.height_unit.is_none() { HIGHEST } else { f64::MAX };
    for (i, height) in heights.iter_mut().enumerate() {
        // The largest number of single precision is no height: instruments mark missing points with it.
        if height.is_finite() && height.abs() >= LARGEST {
            *height = f64::NAN;
        }
        *height *= scale;
        if height.abs() > highest {
            let [_, nx] = grid.shape();
            let what = format!(
                "the height is {height:e} m; if it marks missing points, give --missing and that number"
            );
            return Err(ReadError::at(format, format!("row {}, column {}", i / nx, i % nx), what));
        }
    }
    let (uneven, places) = channel.uneven.unzip();
    let positions = places.map(|x| x.into_iter().map(|x| x * pixel[1]).collect());
    Ok(Measurement {
        channel: channel.info.name,
        channels,
        metadata,
        uneven,
        positions,
        ambiguity: channel.ambiguity,
        ..Measurement::bare(grid, heights, format)
    })
}

/// Every trace of a file of several; of any other file the one channel that [`finish`] gives.
pub(crate) fn finish_traces(
    format: &'static str,
    contents: Contents<'_>,
    options: &ReadOptions,
) -> Result<Vec<Measurement>, ReadError> {
    if options.channel.is_some() || !contents.channels.iter().any(|channel| channel.info.is_trace) {
        return finish(format, contents, options).map(|one| vec![one]);
    }
    let all: Vec<ChannelInfo> = contents.channels.iter().map(|c| c.info.clone()).collect();
    let Contents { channels, metadata } = contents;
    let traces = channels.into_iter().filter(|channel| channel.info.is_trace);
    traces
        .map(|trace| {
            let one = Contents { channels: vec![trace], metadata: metadata.clone() };
            let mut found = finish(format, one, options)?;
            found.channels.clone_from(&all);
            Ok(found)
        })
        .collect()
}

fn positive(given: Need, value: f64) -> Result<(), ReadError> {
    if value.is_normal() && value > 0.0 {
        Ok(())
    } else {
        Err(ReadError::BadOption { given, value })
    }
}

/// Index of the channel asked for, or of the one that is most likely the topography.
fn choose(
    format: &'static str,
    channels: &[ChannelInfo],
    options: &ReadOptions,
) -> Result<usize, ReadError> {
    let names = |only_heights: bool| {
        let names: Vec<String> = channels
            .iter()
            .enumerate()
            .filter(|(_, c)| c.is_height && c.fault.is_none() || !only_heights)
            .map(|(i, c)| format!("{:?} (#{})", c.name, i + 1))
            .collect();
        if names.is_empty() { "(the file has none)".to_owned() } else { names.join(", ") }
    };
    let not_height = |channel: &ChannelInfo| ReadError::NotHeight {
        format,
        channel: channel.name.clone(),
        unit: channel.unit.clone().unwrap_or_default(),
        heights: names(true),
        is_only: !channels.iter().any(|c| c.is_height && c.fault.is_none()),
    };
    let is_overridden = matches!(options.height_unit, Some(HeightUnit::Always(_)));
    let Some(asked) = options.channel.as_deref() else {
        // A stated unit of length is better than no unit at all, then the meaning of the name
        // counts, then the order in the file.
        // One in another unit is read if there is no other and its unit does not count.
        let heights = channels
            .iter()
            .enumerate()
            .filter(|(_, c)| (c.is_height || is_overridden) && c.fault.is_none());
        let best =
            heights.min_by_key(|(i, c)| (!c.is_height, c.unit.is_none(), Meaning::of(&c.name), *i));
        return match (best, channels.first()) {
            (Some((index, _)), _) => Ok(index),
            (None, Some(first)) => Err(not_height(first)),
            (None, None) => {
                Err(ReadError::unsupported(format, "a file without any map or profile"))
            }
        };
    };
    let number = asked.strip_prefix('#').and_then(|n| n.parse::<usize>().ok());
    let part = |c: &ChannelInfo| c.name.to_lowercase().contains(&asked.to_lowercase());
    let index = channels
        .iter()
        .position(|c| c.name == asked)
        .or_else(|| channels.iter().position(|c| c.name.eq_ignore_ascii_case(asked)))
        .or_else(|| number.and_then(|n| n.checked_sub(1)).filter(|&n| n < channels.len()))
        // A part of a name, if it is in one name only.
        .or_else(|| {
            let mut found = channels.iter().enumerate().filter(|(_, c)| part(c)).map(|(i, _)| i);
            found.next().filter(|_| found.next().is_none())
        })
        .ok_or_else(|| ReadError::NoSuchChannel {
            format,
            asked: asked.to_owned(),
            available: names(false),
        })?;
    if channels[index].is_height || channels[index].fault.is_some() || is_overridden {
        return Ok(index);
    }
    Err(not_height(&channels[index]))
}
