//! WSxM (.stp, .top): a text header, then data, little endian.
//!
//! | what | content |
//! |---|---|
//! | line 1 | `WSxM file copyright ...` |
//! | line 2 | `SxM Image file` |
//! | line 3 | `Image header size: N`, which some programs miscount: the data start behind the line `[Header end]` |
//! | `[Control]` | `X Amplitude`, `Y Amplitude`: total size with unit: N pixels |
//! | `[General Info]` | `Number of columns`, `Number of rows`; `Image Data Type`: `short`, `integer` (i16; also if absent), `float`, `double`; `Z Amplitude` with unit: height of the whole range |
//!
//! The range of the stored values is stretched to `Z Amplitude`. The header prints it with about
//! six digits: values whose range agrees with it to 10^-4 (as `float` and `double` do) are
//! heights already and stay as they are.
//!
//! Source: Horcas et al. (2007), doi:10.1063/1.2432410, and files of WSxM 4 and 5.

use super::prelude::*;
use crate::entries::sections;
use crate::units::quantity;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let start = text::latin1(&b.data[..b.data.len().min(512)]);
    let kind = text::lines(&start).nth(1).map_or("", |(_, line)| line.trim());
    if kind != "SxM Image file" {
        return Err(b.unsupported(format!("{kind:?} (images are)")));
    }
    let end = find(b.data, b"[Header end]");
    let line = |end| Some(end + 1 + find(&b.data[end..], b"\n")?);
    let at = end.and_then(line).ok_or_else(|| b.field("[Header end]", "is missing"))?;

    let header = text::decode(&b.data[..at]);
    let metadata: BTreeMap<String, String> = sections(b, &header, ": ")?
        .into_iter()
        .flat_map(|(section, entries)| {
            entries.into_iter().map(move |(key, value)| (format!("{section}/{key}"), value))
        })
        .collect();
    let entries = Entries::new(b, &metadata);
    let measured = |key: &'static str| {
        let text = entries.text(key)?;
        quantity(text).ok_or_else(|| b.field(key, format!("{text:?} is no quantity")))
    };
    let side = |key: &str| entries.parsed::<usize>(key, "size");
    let [ny, nx] = [side("General Info/Number of rows")?, side("General Info/Number of columns")?];
    let sample = match entries.get("General Info/Image Data Type").unwrap_or("short") {
        "short" | "integer" => Sample::I16,
        "float" => Sample::F32,
        "double" => Sample::F64,
        other => return Err(b.unsupported(format!("data of type {other:?}"))),
    };
    let raster = b.raster(at, [ny, nx], sample)?;
    let ((lx, x_unit), (ly, y_unit)) =
        (measured("Control/X Amplitude")?, measured("Control/Y Amplitude")?);
    let pixel = Pixel::in_units([ly / ny as f64, lx / nx as f64], [y_unit, x_unit]);
    let (amplitude, unit) = measured("General Info/Z Amplitude")?;
    let name = entries.get("General Info/Acquisition channel").unwrap_or("Topography");
    let channel = Channel::new(name, Some(unit), [ny, nx], pixel, move || {
        let mut values = raster.values();
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let range = values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low;
        // A flat map has no range; any factor gives its single height.
        let stretch = if range > 0.0 { amplitude / range } else { 1.0 };
        let step = if (stretch - 1.0).abs() < 1e-4 { 1.0 } else { stretch };
        for value in &mut values {
            *value *= step;
        }
        Ok(values)
    });
    Ok(Contents { channels: vec![channel], metadata })
}
