//! NPY, the array format of NumPy. Little is known about the surface: no unit, no pixel size.
//!
//! | bytes | content |
//! |---|---|
//! | 0–5 | `\x93NUMPY` |
//! | 6, 7 | version: 1, 2 or 3; 0 |
//! | 8–9 (version 1), 8–11 (2, 3) | u16 or u32 LE: length of the header |
//! | then | Python dict: `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }` |
//! | then | the numbers, C order (rows) or Fortran order (columns) |
//!
//! Source: numpy.lib.format, <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>.

use super::prelude::*;

pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let array = Array::parse(b)?;
    let end = array.start + array.shape[0] * array.shape[1] * array.sample.size();
    if b.data.len() > end {
        let what =
            format!("{} bytes follow the array: one array a file is read", b.data.len() - end);
        return Err(b.fault(end, what));
    }
    let channel = Channel::new("array", None, array.shape, Pixel::Unknown, move || array.values(b));
    Ok(Contents { channels: vec![channel], ..Contents::default() })
}

/// What the header of one array says. Also used for the members of NPZ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Array {
    pub(crate) shape: [usize; 2],
    start: usize,
    sample: Sample,
    order: ByteOrder,
    is_fortran: bool,
}

impl Array {
    pub(crate) fn parse(b: Bytes<'_>) -> Result<Self, ReadError> {
        if b.slice(0, 6)? != MAGIC {
            return Err(b.fault(0, "not the start of an NPY array"));
        }
        let (at, length) = match b.u8(6)? {
            1 => (10, usize::from(b.u16(8)?)),
            2 | 3 => (12, b.u32(8)? as usize),
            other => return Err(b.fault(6, format!("version {other}, known are 1, 2 and 3"))),
        };
        let header = std::str::from_utf8(b.slice(at, length)?)
            .map_err(|e| b.fault(at + e.valid_up_to(), "the header is not text"))?;
        let entry = |key: &'static str| {
            let quoted = [format!("'{key}':"), format!("\"{key}\":")];
            let found = quoted.iter().find_map(|quoted| header.split_once(quoted.as_str()));
            let (_, value) = found.ok_or_else(|| b.field(key, "not in the header"))?;
            Ok::<_, ReadError>(value.trim_start())
        };
        let descr = entry("descr")?;
        let (sample, order) = sample(descr).ok_or_else(|| {
            let descr: String = descr.chars().take(24).collect();
            let feature = format!("descr {descr} (real numbers and integers of 1 to 8 bytes are)");
            b.unsupported(feature)
        })?;
        let is_fortran = match entry("fortran_order")? {
            s if s.starts_with("True") => true,
            s if s.starts_with("False") => false,
            _ => return Err(b.field("fortran_order", "neither True nor False")),
        };
        let tuple = entry("shape")?.strip_prefix('(').and_then(|s| s.split_once(')'));
        let (tuple, _) = tuple.ok_or_else(|| b.field("shape", "not a tuple"))?;
        let size = |side: &str| {
            // Python 2 wrote long integers as "3L".
            let size = side.trim_end_matches('L').parse::<usize>();
            size.map_err(|_| b.field("shape", format!("{side:?} is no size")))
        };
        let sides = tuple.split(',').map(str::trim).filter(|side| !side.is_empty()).map(size);
        let sides = sides.collect::<Result<Vec<_>, _>>()?;
        let shape = match sides[..] {
            [] => [1, 1],
            [nx] => [1, nx],
            [ny, nx] => [ny, nx],
            _ => {
                let axes = sides.len();
                return Err(b.unsupported(format!("an array with {axes} axes (a map has 2)")));
            }
        };
        b.check_points(shape)?;
        Ok(Self { shape, start: at + length, sample, order, is_fortran })
    }

    pub(crate) fn values(&self, b: Bytes<'_>) -> Result<Vec<f64>, ReadError> {
        let b = Bytes { order: self.order, ..b };
        let [ny, nx] = self.shape;
        // The product was checked against the limits.
        let values = b.samples(self.start, ny * nx, self.sample)?;
        Ok(if self.is_fortran { transpose(&values, [nx, ny]) } else { values })
    }
}

/// Rows become columns; `shape` is `[ny, nx]` of the input.
pub(crate) fn transpose(values: &[f64], [ny, nx]: [usize; 2]) -> Vec<f64> {
    let mut turned = vec![0.0; values.len()];
    // By strips of eight rows: so many numbers of a column are a line of the cache.
    for top in (0..ny).step_by(8) {
        for ix in 0..nx {
            for iy in top..ny.min(top + 8) {
                turned[ix * ny + iy] = values[iy * nx + ix];
            }
        }
    }
    turned
}

/// `'<f8'` and its like.
fn sample(descr: &str) -> Option<(Sample, ByteOrder)> {
    let quote = descr.chars().next().filter(|c| matches!(c, '\'' | '"'))?;
    let code = descr[1..].split(quote).next()?;
    let (order, kind) = match code.as_bytes().first()? {
        b'>' => (ByteOrder::Big, &code[1..]),
        b'<' | b'|' | b'=' => (ByteOrder::Little, &code[1..]),
        _ => (ByteOrder::Little, code),
    };
    Some((Sample::called(kind)?, order))
}
