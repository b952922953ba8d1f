//! SXM of Nanonis (SPECS): a text header, then data.
//!
//! | what | content |
//! |---|---|
//! | header | lines `:KEY:` with the values in the lines below, Latin-1; starts with `:NANONIS_VERSION:`, ends at the bytes 0x1A 0x04 |
//! | `SCANIT_TYPE` | `FLOAT MSBFIRST` (other types are refused), or `LSBFIRST` |
//! | `SCAN_PIXELS` | points along x, along y; in version 1 along y, along x |
//! | `SCAN_RANGE` | total size along x, along y in metres: N pixels |
//! | `SCAN_DIR` | `up`: the first row is the bottom one; `down` |
//! | `DATA_INFO` | a line of titles, then a line a channel: number, name, unit, direction (`both`, `forward`, `backward`), calibration, offset |
//!
//! Channels follow in that order, forward before backward, rows of f32; the backward rows run
//! from right to left. NaN is a point that was not scanned. Values are in the unit already.
//!
//! Sources: SPECS Zurich, *Nanonis file formats*, as read by several open readers; a file of a
//! version 2 and one of a version 3.

use super::prelude::*;

pub(crate) fn parse(mut b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let end = find(b.data, b"\x1a\x04");
    let end = end.ok_or_else(|| b.fault(b.data.len(), "there are no data"))?;
    let fields = header(b, &b.data[..end])?;
    let entries = Entries::new(b, &fields);
    let pair = |key: &'static str| {
        let text = entries.text(key)?;
        let numbers: Vec<f64> = text.split_whitespace().filter_map(|w| w.parse().ok()).collect();
        match numbers[..] {
            [x, y] if x > 0.0 && y > 0.0 => Ok([x, y]),
            _ => Err(b.field(key, format!("{text:?} is not two lengths"))),
        }
    };
    let [mut nx, mut ny] = pair("SCAN_PIXELS")?;
    if entries.get("NANONIS_VERSION") == Some("1") {
        (nx, ny) = (ny, nx);
    }
    let shape = [ny as usize, nx as usize];
    let [width, height] = pair("SCAN_RANGE")?;
    let pixel = Pixel::Metres([height / ny, width / nx]);
    let kind = entries.text("SCANIT_TYPE")?;
    b.order = match kind.split_whitespace().collect::<Vec<_>>()[..] {
        ["FLOAT", "MSBFIRST"] => ByteOrder::Big,
        ["FLOAT", "LSBFIRST"] => ByteOrder::Little,
        _ => return Err(b.unsupported(format!("data of type {kind:?}"))),
    };
    let is_up = entries.text("SCAN_DIR")? != "down";
    let mut contents = Contents::default();
    let mut at = end + 2;
    for line in entries.text("DATA_INFO")?.lines().skip(1) {
        let columns: Vec<&str> = line.split_whitespace().collect();
        let [_, name, unit, direction, ..] = columns[..] else { continue };
        let directions = match direction {
            "both" => &["forward", "backward"][..],
            "backward" => &["backward"],
            _ => &["forward"],
        };
        for direction in directions {
            b.check_items(contents.channels.len() as u64 + 1)?;
            let raster = b.raster(at, shape, Sample::F32)?;
            at = raster.end;
            let name = format!("{name} ({direction})");
            let channel = Channel::raster(name, unit, pixel, raster, |value| value);
            let channel = if *direction == "backward" { channel.mirrored() } else { channel };
            contents.channels.push(if is_up { channel.flipped() } else { channel });
        }
    }
    let keys = ["REC_DATE", "REC_TIME", "BIAS", "COMMENT", "SCAN_ANGLE"];
    contents.note(keys.map(|key| (key, entries.get(key).map(str::to_owned))));
    Ok(contents)
}

/// The values by key; several lines stay several lines.
fn header(b: Bytes<'_>, bytes: &[u8]) -> Result<BTreeMap<String, String>, ReadError> {
    let mut fields = BTreeMap::<String, String>::new();
    let mut key = String::new();
    for (_, line) in text::lines(&text::latin1(bytes)) {
        if let Some(name) =
            line.strip_prefix(':').and_then(|line| line.trim_end().strip_suffix(':'))
        {
            b.check_items(fields.len() as u64 + 1)?;
            name.clone_into(&mut key);
            fields.entry(key.clone()).or_default();
        } else if let Some(value) = fields.get_mut(&key)
            && !line.trim().is_empty()
        {
            if !value.is_empty() {
                value.push('\n');
            }
            value.push_str(line.trim());
        }
    }
    Ok(fields)
}
