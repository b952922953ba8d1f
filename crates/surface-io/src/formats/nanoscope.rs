//! Nanoscope of Digital Instruments, Veeco, Bruker (.spm, .001, .di): a text header, then data.
//!
//! | what | content |
//! |---|---|
//! | header | Latin-1, lines `\key: value`, sections `\*Name`, until `\*File list end` or byte 0x1A |
//! | `\*Ciao image list` | one section per channel |
//! | `\Data offset`, `\Bytes/pixel` | where the data are; 2 (i16) or 4 (i32), little endian |
//! | `\Samps/line`, `\Number of lines` | points along x, along y |
//! | `\Scan Size: 10 5 ~m` | total size along x, along y: N pixels; `~m` is µm |
//! | `\@2:Image Data: S [ZSensor] "Height Sensor"` | name |
//! | `\@2:Z scale: V [Sens. Zsens] (0.006 V/LSB) 24.5 V` | hard scale H: range of all stored values |
//! | `\@Sens. Zsens: V 33.1 nm/V` | soft scale S of that name, in any other section |
//!
//! Height = value × S × H / 2^16 for 2 bytes, / 2^32 for 4 bytes. Rows are stored from the
//! bottom upwards. The number of bytes decides, not the number in parentheses, which is rounded.
//!
//! Source: Veeco, *Nanoscope software 5.12 file formats*, and files of versions 4.3 to 9 and 10.

use crate::binary::{Bytes, Sample};
use crate::measurement::{Channel, Contents, Pixel, Raster};
use crate::text;
use crate::{Format, Limits, ReadError, metres_per};
use std::collections::BTreeMap;

const FORMAT: Format = Format::Nanoscope;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\\*File list") || bytes.starts_with(b"?*File list")
}

type Section = BTreeMap<String, String>;

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let b = Bytes::little(bytes, FORMAT);
    let (sections, ended) = sections(bytes, limits)?;
    if !ended {
        return Err(b.fault(bytes.len(), "the header has no end"));
    }
    let mut contents = Contents::default();
    let mut soft_scales = Section::new();
    for (name, section) in &sections {
        if name != "ciao image list" {
            let scales = section.iter().filter(|(key, _)| key.starts_with('@'));
            soft_scales.extend(scales.map(|(key, value)| (key.clone(), value.clone())));
            for key in ["date", "version", "microscope", "description", "serial number"] {
                if let Some(value) = section.get(key) {
                    contents.metadata.entry(key.into()).or_insert_with(|| value.clone());
                }
            }
        }
    }
    for (name, section) in &sections {
        if name == "ciao image list" {
            limits.check_items(FORMAT, contents.channels.len() as u64 + 1)?;
            // An auxiliary channel that cannot be read must not cost the others.
            let found = channel(b, section, &soft_scales, limits)
                .unwrap_or_else(|fault| Channel::unreadable(channel_name(section), fault));
            contents.channels.push(found);
        }
    }
    Ok(contents)
}

/// The sections of the header in order, keys in lower case; and whether its end was found.
fn sections(bytes: &[u8], limits: &Limits) -> Result<(Vec<(String, Section)>, bool), ReadError> {
    let end = bytes.iter().position(|&byte| byte == 0x1a);
    let list_end = crate::binary::find(bytes, b"*File list end");
    let header = &bytes[..end.into_iter().chain(list_end).min().unwrap_or(bytes.len())];
    let header: String = header.iter().map(|&byte| char::from(byte)).collect();
    let mut sections: Vec<(String, Section)> = Vec::new();
    let mut count = 0;
    for (_, line) in text::lines(&header) {
        count += 1;
        limits.check_items(FORMAT, count)?;
        let Some(line) = line.trim().strip_prefix(['\\', '?']) else { continue };
        if let Some(name) = line.strip_prefix('*') {
            sections.push((name.trim().to_lowercase(), Section::new()));
        } else if let Some((_, section)) = sections.last_mut() {
            // "@2:Z scale: V ..." has a colon in its key, followed by no blank.
            let (key, value) = line.split_once(": ").unwrap_or((line.trim_end_matches(':'), ""));
            section.insert(key.trim().to_lowercase(), value.trim().to_owned());
        }
    }
    Ok((sections, end.is_some() || list_end.is_some()))
}

fn channel<'a>(
    b: Bytes<'a>,
    section: &Section,
    soft_scales: &Section,
    limits: &Limits,
) -> Result<Channel<'a>, ReadError> {
    let get = |key: &'static str| {
        section.get(key).ok_or_else(|| b.field(key, "is missing in an image list"))
    };
    let whole = |key: &'static str| {
        let text = get(key)?;
        let first = text.split_whitespace().next().unwrap_or_default();
        first.parse::<usize>().map_err(|_| b.field(key, format!("{text:?} is no whole number")))
    };
    let shape = [whole("number of lines")?, whole("samps/line")?];
    limits.check_points(FORMAT, shape)?;
    let (sample, levels) = match whole("bytes/pixel")? {
        2 => (Sample::I16, 65536.0),
        4 => (Sample::I32, 65536.0 * 65536.0),
        size => return Err(b.field("bytes/pixel", format!("{size}, not 2 or 4"))),
    };
    let pixel = scan_size(get("scan size")?)
        .map(|[sx, sy]| Pixel::Metres([sy / shape[0] as f64, sx / shape[1] as f64]))
        .ok_or_else(|| b.field("scan size", format!("{:?}", get("scan size").ok())))?;
    let name = channel_name(section);
    let scale = get("@2:z scale")?;
    let (step, unit) = height_scale(scale, soft_scales)
        .ok_or_else(|| b.field("@2:z scale", format!("{scale:?} cannot be read")))?;
    let step = step / levels;
    let raster = Raster { bytes: b, at: whole("data offset")?, shape, sample };
    let channel = Channel::raster(name, Some(&unit), pixel, raster, move |raw| raw * step)?;
    Ok(channel.flipped())
}

/// `ZSensor` of `V [ZSensor] "Height Sensor"`.
fn channel_name(section: &Section) -> String {
    let text = section.get("@2:image data").map_or("", String::as_str);
    between(text, '[', ']').unwrap_or(text).to_owned()
}

fn between(text: &str, open: char, close: char) -> Option<&str> {
    let (_, rest) = text.split_once(open)?;
    rest.split_once(close).map(|(inner, _)| inner)
}

/// Length of a unit; a tilde stands for the micro sign.
fn metres(unit: &str) -> Option<f64> {
    metres_per(if unit == "~m" { "um" } else { unit })
}

/// Sizes along x, along y in metres from "10 5 ~m" or "500 nm".
fn scan_size(text: &str) -> Option<[f64; 2]> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let (unit, numbers) = words.split_last()?;
    let scale = metres(unit)?;
    let size = |word: &&str| word.parse::<f64>().ok().map(|size| size * scale);
    match numbers {
        [both] => size(both).map(|size| [size, size]),
        [x, y] => size(x).zip(size(y)).map(|(x, y)| [x, y]),
        _ => None,
    }
}

/// Range of all stored values and its unit.
fn height_scale(scale: &str, soft_scales: &Section) -> Option<(f64, String)> {
    let range = scale.rsplit_once(')').map_or(scale.trim_start_matches("V "), |(_, range)| range);
    let mut words = range.split_whitespace();
    let hard: f64 = words.next()?.parse().ok()?;
    let hard_unit = words.next().unwrap_or_default();
    let Some(name) = between(scale, '[', ']') else {
        return Some((hard, hard_unit.to_owned()));
    };
    // "V 33.15 nm/V"; without a unit the quantity keeps that of the hard scale.
    let soft = soft_scales.get(&format!("@{}", name.to_lowercase()))?;
    let mut words = soft.split_whitespace().skip(1);
    let factor: f64 = words.next()?.parse().ok()?;
    let Some((unit, per)) = words.next().and_then(|unit| unit.split_once('/')) else {
        return Some((hard * factor, hard_unit.to_owned()));
    };
    let per_hard = match (hard_unit, per) {
        (a, b) if a == b => 1.0,
        ("mV", "V") => 1e-3,
        ("V", "mV") => 1e3,
        ("\u{b5}V" | "uV" | "~V", "V") => 1e-6,
        _ => return Some((hard * factor, format!("{hard_unit} {unit}/{per}"))),
    };
    let unit = if unit == "~m" { "\u{b5}m" } else { unit };
    Some((hard * factor * per_hard, unit.to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_with_and_without_soft_part() {
        let soft: Section = [
            ("@sens. zsens".into(), "V 33.15306 nm/V".into()),
            ("@sens. phase".into(), "V 1.000000 ".into()),
        ]
        .into();
        let scale = |text: &str| height_scale(text, &soft).unwrap();
        let (range, unit) = scale("V [Sens. Zsens] (0.005035400 V/LSB) 2.0 V");
        assert!((range - 66.30612).abs() < 1e-12 && unit == "nm");
        let (range, _) = scale("V [Sens. Zsens] (0.06103516 mV/LSB) 2000 mV");
        assert!((range - 66.30612).abs() < 1e-12);
        assert_eq!(scale("V [Sens. Phase] (0.0055 \u{ba}/LSB) 360 \u{ba}").1, "\u{ba}");
        assert_eq!(scale("V (0.1 nm/LSB) 123 nm"), (123.0, "nm".to_owned()));
        let [sx, sy] = scan_size("10 5 ~m").unwrap();
        assert!((sx - 1e-5).abs() < 1e-20 && (sy - 5e-6).abs() < 1e-20);
        assert_eq!(scan_size("10 V"), None);
    }
}
