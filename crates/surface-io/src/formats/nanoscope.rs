//! Nanoscope of Digital Instruments, Veeco, Bruker (.spm, .001, .di): a text header, then data.
//!
//! | what | content |
//! |---|---|
//! | header | Latin-1, lines `\key: value`, sections `\*Name`, until `\*File list end` or byte 0x1A; starts with `\*File list` or `\*EC File list` |
//! | `\*Ciao image list` | one section per channel; also `AFM`, `STM`, `NCAFM image list` and `Image list` |
//! | `\Data offset`, `\Data length`, `\Bytes/pixel` | where the data are; 2 (i16) or 4 (i32), little endian; from version 9.2 (0x0920….) always i32, and `\Bytes/pixel` only scales |
//! | `\Samps/line`, `\Number of lines` | points along x, along y; fewer lines in `\Data length`: the lines that are there |
//! | `\Scan Size: 10 5 ~m` | total size along x, along y: N pixels; `~m` is µm; where both are equal the next two rows count |
//! | `\Aspect Ratio: 2:1` | size along x over that along y, of this image |
//! | `\Slow Axis Size: 5000 nm` | of `\*Ciao scan list`: size along y of all its `\Lines`; of a scan stopped early the lines there are have their share |
//! | `\@2:Image Data: S [ZSensor] "Height Sensor"` | name |
//! | `\@2:Z scale: V [Sens. Zsens] (0.006 V/LSB) 24.5 V` | hard scale H: range of all stored values; `@4:` goes before `@2:` |
//! | `\@Sens. Zsens: V 33.1 nm/V` | soft scale S of that name, in any other section |
//!
//! Height = value × S × H / 2^16 for `\Bytes/pixel: 2`, / 2^32 for 4. Rows are stored from the
//! bottom upwards. The number of bytes decides, not the number in parentheses, which is rounded.
//! Files with data as text (`?*File list`) and force curves are refused.
//!
//! Sources: Veeco, *Nanoscope software 5.12 file formats*; files of versions 4.3 to 9 and 10; for
//! aspect ratio, slow axis and version 9.2 Gwyddion and SurfaceTopography (both open readers).

use super::prelude::*;

/// What the scan list says of every image.
const COMMON: &str =
    "version|samps/line|lines|slow axis size|aspect ratio|operating mode|start context";
const ABOUT: &str = "date|version|microscope|description|serial number";

/// From this version on every stored point has 4 bytes.
const WIDE: u64 = 0x0920_0000;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let Some(rest) = bytes.strip_prefix(b"\\*").or_else(|| bytes.strip_prefix(b"?*")) else {
        return false;
    };
    // Behind the header of an export as text comes neither 0x1A nor padding.
    let end = find(rest, b"File list end").map_or(rest.len(), |at| at + 13);
    let is_export = rest[end..].trim_ascii_start().first().is_some_and(|byte| *byte >= b' ');
    [&b"File list"[..], b"EC File list", b"Force file list"].iter().any(|s| rest.starts_with(s))
        && (bytes[0] == b'?' || !is_export)
}

type HeaderSection = BTreeMap<String, String>;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if b.data.starts_with(b"?") {
        return Err(b.unsupported("data stored as text (save the image as binary, or export it)"));
    }
    let sections = sections(b)?;
    let mut contents = Contents::default();
    // What the sections that are no images say of all of them.
    let mut common = HeaderSection::new();
    for (_, section) in sections.iter().filter(|(name, _)| !is_image(name)) {
        for (key, value) in section.iter().filter(|(key, _)| key.starts_with('@')) {
            common.insert(key.clone(), value.clone());
        }
        for (kept, keys) in [(&mut common, COMMON), (&mut contents.metadata, ABOUT)] {
            for key in keys.split('|').filter(|key| section.contains_key(*key)) {
                kept.entry(key.into()).or_insert_with(|| section[key].clone());
            }
        }
    }
    let says = |key: &str| common.get(key).map_or("", |value| value.trim());
    if says("operating mode") == "Force" || says("start context") == "FOL" {
        return Err(b.unsupported("a force curve (an image is)"));
    }
    if says("start context").ends_with("VAR") && says("operating mode") != "Force Volume" {
        return Err(b.unsupported("a set of lines of different length (deep trench mode)"));
    }
    for (_, section) in sections.iter().filter(|(name, _)| is_image(name)) {
        b.check_items(contents.channels.len() as u64 + 1)?;
        contents.add(&channel_name(section), channel(b, section, &common));
    }
    Ok(contents)
}

fn is_image(section: &str) -> bool {
    ["ciao image list", "afm image list", "stm image list", "ncafm image list", "image list"]
        .contains(&section)
}

/// The sections of the header in order, keys in lower case.
fn sections(b: Bytes<'_>) -> Result<Vec<(String, HeaderSection)>, ReadError> {
    let bytes = b.data;
    let end = bytes.iter().position(|&byte| byte == 0x1a);
    let list_end = find(bytes, b"File list end");
    let end = end.into_iter().chain(list_end).min();
    let end = end.ok_or_else(|| b.fault(bytes.len(), "the header has no end"))?;
    let header = text::latin1(&bytes[..end]);
    let mut sections: Vec<(String, HeaderSection)> = Vec::new();
    for (number, line) in text::lines(&header) {
        b.check_items(number as u64)?;
        let Some(line) = line.trim().strip_prefix(['\\', '?']) else { continue };
        if let Some(name) = line.strip_prefix('*') {
            sections.push((name.trim().to_lowercase(), HeaderSection::new()));
        } else if let Some((_, section)) = sections.last_mut() {
            // "@2:Z scale: V ..." has a colon in its key, followed by no blank.
            let (key, value) = line.split_once(": ").unwrap_or((line.trim_end_matches(':'), ""));
            section.insert(key.trim().to_lowercase(), value.trim().to_owned());
        }
    }
    Ok(sections)
}

fn channel<'a>(
    b: Bytes<'a>,
    section: &HeaderSection,
    common: &HeaderSection,
) -> Result<Channel<'a>, ReadError> {
    let entries = Entries::new(b, section);
    let whole = |key: &'static str| {
        let text = entries.text(key)?;
        count(section, key).ok_or_else(|| b.field(key, format!("{text:?} is no whole number")))
    };
    let stated = [whole("number of lines")?, whole("samps/line")?];
    b.check_points(stated)?;
    let (stored, levels) = match whole("bytes/pixel")? {
        2 => (Sample::I16, 65536.0),
        4 => (Sample::I32, 65536.0 * 65536.0),
        size => return Err(b.field("bytes/pixel", format!("{size}, not 2 or 4"))),
    };
    let length = count(section, "data length");
    let points = stated[0].saturating_mul(stated[1]);
    let version = common.get("version").map(|text| text.trim_start_matches("0x"));
    let is_wide = version.and_then(|v| u64::from_str_radix(v, 16).ok()).is_some_and(|v| v >= WIDE);
    let sample =
        if is_wide && length != Some(points.saturating_mul(2)) { Sample::I32 } else { stored };
    let shape = there(length.map(|bytes| bytes / sample.size()), stated, common);
    if shape[0] == 0 || shape[1] == 0 {
        return Err(b.field("data length", format!("{length:?} bytes: not a single line")));
    }
    let pixel = pixel(section, common, stated, shape)
        .ok_or_else(|| b.field("scan size", format!("{:?}", section.get("scan size"))))?;
    let name = channel_name(section);
    let scale = entries.get("@4:z scale").map_or_else(|| entries.text("@2:z scale"), Ok)?;
    let (step, unit) = height_scale(scale, common)
        .ok_or_else(|| b.field("@2:z scale", format!("{scale:?} cannot be read")))?;
    let step = step / levels;
    let raster = b.raster(whole("data offset")?, shape, sample)?;
    let pixel = Pixel::Metres(pixel);
    let channel = Channel::raster(name, &unit, pixel, raster, move |raw| raw * step);
    Ok(channel.flipped())
}

fn count(section: &HeaderSection, key: &str) -> Option<usize> {
    section.get(key)?.split_whitespace().next()?.parse().ok()
}

/// Lines, and points in each, that are stored where `points` are: fewer lines than stated if the
/// scan was stopped early; those of the scan list if it is the one that fits.
fn there(points: Option<usize>, stated: [usize; 2], common: &HeaderSection) -> [usize; 2] {
    let Some(points) = points.filter(|&n| n != stated[0].saturating_mul(stated[1])) else {
        return stated;
    };
    match (count(common, "lines"), count(common, "samps/line")) {
        (Some(ny), Some(nx)) if ny.saturating_mul(nx) == points => [ny, nx],
        _ => [stated[0].min(points / stated[1].max(1)), stated[1]],
    }
}

/// `[dy, dx]` in metres of an image of `stated` points of which `shape` are stored.
///
/// The size along y is that of the whole scan where the image holds only a part of its lines.
fn pixel(
    section: &HeaderSection,
    common: &HeaderSection,
    stated: [usize; 2],
    shape: [usize; 2],
) -> Option<[f64; 2]> {
    let ratio = |of: &HeaderSection| of.get("aspect ratio").and_then(|text| aspect(text));
    let [lines, samples] = stated;
    let [fast, second] = scan_size(section.get("scan size")?)?;
    let slow_axis = common.get("slow axis size").and_then(|text| scan_size(text));
    let (all, across) = (count(common, "lines"), count(common, "samps/line"));
    if let (Some([slow, _]), Some(all), Some(across)) = (slow_axis, all, across)
        && shape[1] != samples
    {
        return Some([slow / all as f64, fast / across as f64]); // the scan list is the one that fits
    }
    let dx = fast / samples as f64;
    let image = ratio(section).unwrap_or(1.0);
    let planned = all.filter(|&all| all > lines && across == Some(samples)).map(|all| all as f64);
    let lines = lines as f64;
    let is_near = |a: f64, b: f64| (a / b - 1.0).abs() < 0.02;
    // The ratio of an image may be its own or that of the scan it is a part of.
    let scan = ratio(common).unwrap_or(match planned {
        Some(all) if is_near(image, all / lines) => 1.0,
        _ => image,
    });
    Some(match (slow_axis, planned) {
        (Some([slow, _]), _) => [slow / planned.unwrap_or(lines), dx],
        // Two sizes that differ are meant, unless they are those of the whole scan.
        (None, _) if !is_near(second, fast) && !is_near(second, fast / scan) => {
            [second / lines, dx]
        }
        (None, Some(all)) => [fast / scan / all, dx],
        (None, None) => [fast / image / lines, dx],
    })
}

/// 2 of "2:1".
fn aspect(text: &str) -> Option<f64> {
    let (x, y) = text.split_once(':').unwrap_or((text, "1"));
    let ratio = x.trim().parse::<f64>().ok()? / y.trim().parse::<f64>().ok()?;
    (ratio.is_finite() && ratio > 0.0).then_some(ratio)
}

/// `ZSensor` of `V [ZSensor] "Height Sensor"`.
fn channel_name(section: &HeaderSection) -> String {
    let keys = ["@2:image data", "@3:image data", "@4:image data", "image data"];
    let text = keys.iter().find_map(|key| section.get(*key)).map_or("", String::as_str);
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
fn height_scale(scale: &str, soft_scales: &HeaderSection) -> Option<(f64, String)> {
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
        let soft = [("@sens. zsens", "V 33.15306 nm/V"), ("@sens. phase", "V 1.000000 ")];
        let soft = soft.map(|(key, text)| (key.into(), text.into())).into();
        for (text, range, unit) in [
            ("V [Sens. Zsens] (0.005035400 V/LSB) 2.0 V", 66.30612, "nm"),
            ("V [Sens. Zsens] (0.06103516 mV/LSB) 2000 mV", 66.30612, "nm"),
            ("V [Sens. Phase] (0.0055 \u{ba}/LSB) 360 \u{ba}", 360.0, "\u{ba}"),
            ("V (0.1 nm/LSB) 123 nm", 123.0, "nm"),
        ] {
            let found = height_scale(text, &soft).unwrap();
            assert!((found.0 - range).abs() < 1e-12 && found.1 == unit, "{text}: {found:?}");
        }
    }
}
