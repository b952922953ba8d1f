//! OPDx of Bruker Dektak and Contour (Vision64). All numbers little endian.
//!
//! | what | content |
//! |---|---|
//! | start | `VCA DATA`, bytes 1 0 0 85; then items |
//! | item | u32 length and text: name; u8 type; value |
//! | length L | u8 w (1, 2 or 4), then as many bytes |
//! | type 1, 4–7, 10–13 | u8, i16, u16, i32, u32, i64, u64, f32, f64 |
//! | type 18 text | L, text |
//! | type 19 quantity | L, f64 value, name, symbol (u32 length and text each), more |
//! | type 21 time | 9 bytes |
//! | type 24 units | L, bytes |
//! | type 14, 64, 66 | type name, L, bytes: type id; array (5 bytes, then f64); list of texts |
//! | type 0, 69 matrix | type name (type 0: u32, text); L; u32 rows, u32 columns, f32 data |
//! | type 70, 71, 125 container | L; items inside it; ended by an item of type 127 and two bytes |
//! | type 124 positions | type name, L, bytes |
//!
//! | path | content |
//! |---|---|
//! | `/2D_Data/NAME/` | `Matrix`, `Dimension1Extent` (y), `Dimension2Extent` (x), `DataScale`, `DataKind` |
//! | `/1D_Data/NAME/` | `Array`, `Extent`, `DataScale`, `DataKind` |
//! | `/MetaData/` | instrument, date, settings |
//!
//! An extent is the distance from the first to the last point: N − 1 intervals (the positions
//! stored beside profiles show it). NaN, infinity and anything beyond 10^30 are missing points. The
//! map named by `/MetaData/PrimaryData2D` comes first.
//!
//! Source: the item list of several free readers, checked against files.

use super::prelude::*;
use crate::binary::text;

pub(crate) const MAGIC: &[u8] = b"VCA DATA\x01\0\0\x55";
const ARRAY_HEAD: usize = 5;

enum ItemValue {
    Number(f64),
    Text(String),
    Quantity {
        value: f64,
        symbol: String,
    },
    /// An array of f64 as one row, or a matrix of f32.
    Numbers(usize, [usize; 2], Sample),
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut reader = ItemReader { b, at: MAGIC.len(), count: 0, items: BTreeMap::new() };
    while reader.at < b.data.len() && reader.item("", 0)? {}
    let items = reader.items;

    let mut contents = Contents::default();
    let primary = match items.get("/MetaData/PrimaryData2D") {
        Some(ItemValue::Text(name)) => format!("/2D_Data/{name}/Matrix"),
        _ => String::new(),
    };
    let first = items.get_key_value(&primary);
    for (path, value) in first.into_iter().chain(items.iter().filter(|item| *item.0 != primary)) {
        if let ItemValue::Numbers(at, shape, sample) = *value {
            contents.channels.extend(channel(b, &items, path, (at, shape, sample))?);
        }
        let Some(key) = path.strip_prefix("/MetaData/") else { continue };
        let shown = match value {
            ItemValue::Number(value) => value.to_string(),
            ItemValue::Text(text) => text.clone(),
            ItemValue::Quantity { value, symbol } => format!("{value} {symbol}"),
            ItemValue::Numbers(..) => continue,
        };
        contents.metadata.insert(key.to_owned(), shown);
    }
    Ok(contents)
}

type Items = BTreeMap<String, ItemValue>;

/// Metres of a quantity; `None` if it is not there or no length.
fn metres(items: &Items, path: &str) -> Option<f64> {
    match items.get(path)? {
        ItemValue::Quantity { value, symbol } => Some(value * metres_per(symbol)?),
        _ => None,
    }
}

/// The map or profile of a path, if it is one.
fn channel<'a>(
    b: Bytes<'a>,
    items: &Items,
    path: &str,
    (at, shape, sample): (usize, [usize; 2], Sample),
) -> Result<Option<Channel<'a>>, ReadError> {
    let map = path.strip_suffix("/Matrix").filter(|path| path.starts_with("/2D_Data/"));
    let profile = path.strip_suffix("/Array").filter(|path| path.starts_with("/1D_Data/"));
    let [ny, nx] = shape;
    let (folder, [extent_y, extent_x]) = match (map, profile) {
        (Some(folder), _) => (folder, ["Dimension1Extent", "Dimension2Extent"]),
        (None, Some(folder)) if nx > 1 => (folder, ["", "Extent"]),
        _ => return Ok(None),
    };
    let raster = b.raster(at, shape, sample)?;
    let step = |extent: &str, n: usize| {
        let extent = metres(items, &format!("{folder}/{extent}"))?;
        (n > 1).then(|| extent / (n - 1) as f64)
    };
    let (dy, dx) = (step(extent_y, ny), step(extent_x, nx));
    let pixel = match (dy.or(dx.filter(|_| ny == 1)), dx) {
        (Some(dy), Some(dx)) => Pixel::Metres([dy, dx]),
        _ => Pixel::Unknown,
    };
    let (factor, unit) = match items.get(&format!("{folder}/DataScale")) {
        Some(ItemValue::Quantity { value, symbol }) => (*value, symbol.as_str()),
        _ => (1.0, ""),
    };
    let name = match items.get(&format!("{folder}/DataKind")) {
        Some(ItemValue::Text(kind)) if !kind.is_empty() => kind,
        _ => folder.rsplit('/').next().unwrap_or_default(),
    };
    let convert = move |raw: f64| if raw.abs() < 1e30 { raw * factor } else { f64::NAN };
    Ok(Some(Channel::raster(name, unit, pixel, raster, convert)))
}

/// Walks through the items.
struct ItemReader<'a> {
    b: Bytes<'a>,
    at: usize,
    count: u64,
    items: Items,
}

impl<'a> ItemReader<'a> {
    fn take(&mut self, length: usize) -> Result<&'a [u8], ReadError> {
        let raw = self.b.slice(self.at, length)?;
        self.at += length;
        Ok(raw)
    }

    fn number(&mut self, sample: Sample) -> Result<f64, ReadError> {
        let raw = self.take(sample.size())?;
        Ok(sample.decode(raw, self.b.order)[0])
    }

    fn word(&mut self) -> Result<usize, ReadError> {
        let at = self.at;
        self.take(4)?;
        Ok(self.b.u32(at)? as usize)
    }

    fn name(&mut self) -> Result<String, ReadError> {
        let length = self.word()?;
        Ok(text(self.take(length)?))
    }

    /// A length of its own width.
    fn length(&mut self) -> Result<usize, ReadError> {
        let at = self.at;
        match self.take(1)?[0] {
            1 => Ok(usize::from(self.take(1)?[0])),
            2 => {
                self.take(2)?;
                Ok(usize::from(self.b.u16(at + 1)?))
            }
            4 => self.word(),
            width => Err(self.b.fault(at, format!("a length of {width} bytes, not 1, 2 or 4"))),
        }
    }

    /// Reads one item; false at the end of a container.
    fn item(&mut self, folder: &str, depth: usize) -> Result<bool, ReadError> {
        self.count += 1;
        self.b.check_items(self.count)?;
        if depth > 32 {
            return Err(self.b.fault(self.at, "containers nested deeper than 32"));
        }
        let path = format!("{folder}/{}", self.name()?);
        let at = self.at;
        let value = match self.take(1)?[0] {
            1 => Some(ItemValue::Number(self.number(Sample::U8)?)),
            4 => Some(ItemValue::Number(self.number(Sample::I16)?)),
            5 => Some(ItemValue::Number(self.number(Sample::U16)?)),
            6 => Some(ItemValue::Number(self.number(Sample::I32)?)),
            7 => Some(ItemValue::Number(self.number(Sample::U32)?)),
            10 => Some(ItemValue::Number(self.number(Sample::I64)?)),
            11 => Some(ItemValue::Number(self.number(Sample::U64)?)),
            12 => Some(ItemValue::Number(self.number(Sample::F32)?)),
            13 => Some(ItemValue::Number(self.number(Sample::F64)?)),
            18 => {
                let length = self.length()?;
                Some(ItemValue::Text(text(self.take(length)?)))
            }
            19 => {
                let length = self.length()?;
                let end = self.at.saturating_add(length);
                let value = self.number(Sample::F64)?;
                self.name()?;
                let symbol = self.name()?;
                self.skip_to(end)?;
                Some(ItemValue::Quantity { value, symbol })
            }
            21 => {
                self.take(9)?;
                None
            }
            24 => {
                let length = self.length()?;
                self.take(length)?;
                None
            }
            kind @ (14 | 64 | 66 | 124) => {
                self.name()?;
                let length = self.length()?;
                let at = self.at;
                self.take(length)?;
                let shape = [1, length.saturating_sub(ARRAY_HEAD) / 8];
                let at = at + ARRAY_HEAD;
                (kind == 64).then_some(ItemValue::Numbers(at, shape, Sample::F64))
            }
            kind @ (0 | 69) => {
                self.name()?;
                if kind == 0 {
                    self.word()?;
                    self.name()?;
                }
                let length = self.length()?;
                let end = self.at.saturating_add(length);
                let shape = [self.word()?, self.word()?];
                let at = self.at;
                self.skip_to(end)?;
                Some(ItemValue::Numbers(at, shape, Sample::F32))
            }
            70 | 71 | 125 => {
                let length = self.length()?;
                let end = self.at.saturating_add(length);
                while self.item(&path, depth + 1)? {}
                self.skip_to(end)?;
                None
            }
            127 => return Ok(false),
            kind => return Err(self.b.fault(at, format!("an item of unknown type {kind}"))),
        };
        if let Some(value) = value {
            self.items.insert(path, value);
        }
        Ok(true)
    }

    fn skip_to(&mut self, end: usize) -> Result<(), ReadError> {
        let length = end
            .checked_sub(self.at)
            .ok_or_else(|| self.b.fault(self.at, "an item reaches beyond its end"))?;
        self.take(length).map(|_| ())
    }
}
