//! Igor binary wave, version 5. The byte order is that of the machine that wrote it.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | i16 | version 5; read in the wrong order it is 1280 |
//! | 2 | i16 | checksum: the sum of all i16 of the first 384 bytes is 0 |
//! | 8, 12 | i32 | sizes of formula, note |
//! | 16 | i32 | size of the extended data unit |
//! | 20–35 | 4 × i32 | sizes of the extended units of the dimensions |
//! | 36–51 | 4 × i32 | sizes of the labels of the dimensions |
//! | 80 | i16 | type: 2 f32, 4 f64, 8 i8, 16 i16, 32 i32, +64 unsigned, +1 complex (refused) |
//! | 92 | 32 | name |
//! | 132–147 | 4 × i32 | points along x (fastest), y, layers |
//! | 148–179 | 4 × f64 | spacing along each |
//! | 212 | 4 | unit of the data |
//! | 216–231 | 4 × 4 | units of the dimensions |
//! | 384 | | data, then formula, note, extended units, labels (32 bytes each, the first for the dimension) |
//!
//! Every layer is a channel, named by its label. The first row is the bottom one.
//!
//! Waves of versions 1 to 3, whose checksum is over 134, 142 and 146 bytes, are refused.
//!
//! Source: WaveMetrics, *Technical note 003, Igor binary format* (PTN003).

use super::prelude::*;

const DATA: usize = 384;

fn version(bytes: &[u8]) -> Option<(u8, ByteOrder)> {
    match *bytes {
        [version @ (1..=3 | 5), 0, ..] => Some((version, ByteOrder::Little)),
        [0, version @ (1..=3 | 5), ..] => Some((version, ByteOrder::Big)),
        _ => None,
    }
}

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let Some((version, order)) = version(bytes) else { return false };
    let size = [134, 142, 146, 0, DATA][usize::from(version) - 1];
    bytes.get(..size).is_some_and(|header| {
        let sum = Sample::I16.decode(header, order).iter().sum::<f64>() as i64;
        sum % 65536 == 0
    })
}

pub(crate) fn parse(mut b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let (version, order) = version(b.data).unwrap_or((5, ByteOrder::Little));
    if version != 5 {
        return Err(b.unsupported(format!(
            "a wave of version {version} (load it in Igor Pro and save a copy, which is version 5, \
             or save it as text)"
        )));
    }
    b.order = order;
    let size = |at: usize| {
        let n = b.i32(at)?;
        usize::try_from(n).map_err(|_| b.fault(at, format!("a size of {n}")))
    };
    let [nx, ny, layers, more] = [size(132)?, size(136)?, size(140)?, size(144)?];
    // Dimensions that are not used have 0 points.
    let (ny, layers) = (ny.max(1), layers.max(1));
    if nx == 0 || more > 1 {
        return Err(b.unsupported("a wave without points or with four dimensions"));
    }
    b.check_points([ny, nx])?;
    b.check_items(layers as u64)?;
    let kind = b.i16(80)?;
    let sample = match kind {
        2 => Some(Sample::F32),
        4 => Some(Sample::F64),
        _ => Sample::of_bits(usize::from(kind.cast_unsigned() & !64), kind & 64 == 0),
    };
    let sample = sample.ok_or_else(|| b.unsupported(format!("data of type {kind}")))?;
    let layer_size = b.map_length(DATA, [ny, nx], sample)?;
    let behind = b.map_length(DATA, [layers, layer_size], Sample::U8)?;

    // What follows the data, in this order.
    let formula = size(8)?;
    let (note, data_unit) = (size(12)?, size(16)?);
    let units = [size(20)?, size(24)?, size(28)?, size(32)?];
    let labels = [size(36)?, size(40)?, size(44)?, size(48)?];
    let mut at = DATA + behind + formula;
    let mut next = |length: usize| {
        let start = at;
        at = at.saturating_add(length);
        b.slice(start, length)
    };
    let note = String::from_utf8_lossy(next(note)?).into_owned();
    let mut unit = |length: usize, at: usize| match text(next(length)?) {
        none if none.is_empty() => b.text(at, 4),
        extended => Ok(extended),
    };
    let (unit, step_units) = (unit(data_unit, 212)?, [unit(units[0], 216)?, unit(units[1], 220)?]);
    for length in [units[2], units[3], labels[0], labels[1]] {
        next(length)?;
    }
    let labels = next(labels[2])?;

    let steps = [b.f64(156)?, b.f64(148)?];
    let [x, y] = step_units.each_ref().map(|unit| metres_per(unit));
    let pixel = Pixel::scaled(steps, [y.or((ny == 1).then_some(1.0)), x]); // a profile has no y
    let mut contents = Contents::default();
    let wave = b.text(92, 32)?;
    for layer in 0..layers {
        let label = labels.get(32 * (layer + 1)..32 * (layer + 2)).map(text);
        let name =
            label.filter(|l| !l.is_empty()).unwrap_or_else(|| format!("layer {}", layer + 1));
        let raster = b.raster(DATA + layer * layer_size, [ny, nx], sample)?;
        let unit = layer_unit(&name, &unit);
        contents.channels.push(Channel::raster(name, unit, pixel, raster, |raw| raw).flipped());
    }
    contents.metadata.insert("wave".into(), wave);
    for (_, line) in text::lines(&note).take(1024) {
        if let Some((key, value)) = line.split_once(':') {
            contents.metadata.insert(key.trim().to_owned(), value.trim().to_owned());
        }
    }
    Ok(contents)
}

/// A wave has one unit for all layers. Asylum puts phases and voltages beside heights under the unit m; its labels, which
/// end with the direction, tell.
fn layer_unit<'a>(name: &str, unit: &'a str) -> &'a str {
    let name = name.to_lowercase();
    let is_length =
        ["height", "zsensor", "deflection", "amplitude"].iter().any(|l| name.starts_with(l));
    match name.ends_with("trace") && !is_length {
        true if name.contains("phase") => "deg",
        true => "V",
        false => unit,
    }
}
