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

pub(crate) const MAGIC: &[u8] = b"VCA DATA\x01\0\0\x55";
const ARRAY_HEAD: usize = 5;

/// Types of numbers.
const NUMBERS: &str = "- u1 - - i2 u2 i4 u4 - - i8 u8 f4 f8";

enum ItemValue {
    Number(f64),
    Text(String),
    /// Of so much, in a unit.
    Quantity(f64, String),
    /// An array of f64 as one row, or a matrix of f32.
    Numbers(usize, [usize; 2], Sample),
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let file = Cursor { b, at: MAGIC.len() };
    let mut reader = ItemReader { file, count: 0, items: BTreeMap::new() };
    while reader.file.at < b.data.len() && reader.item("", 0)? {}
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
            ItemValue::Quantity(value, symbol) => format!("{value} {symbol}"),
            ItemValue::Numbers(..) => continue,
        };
        contents.metadata.insert(key.to_owned(), shown);
    }
    Ok(contents)
}

type Items = BTreeMap<String, ItemValue>;

/// Metres of a quantity; `None` if it is not there or no length.
fn metres(items: &Items, path: &str) -> Option<f64> {
    let ItemValue::Quantity(value, symbol) = items.get(path)? else { return None };
    Some(value * metres_per(symbol)?)
}

/// The map or profile of a path, if it is one.
fn channel<'a>(
    b: Bytes<'a>,
    items: &Items,
    path: &str,
    (at, shape, sample): (usize, [usize; 2], Sample),
) -> Result<Option<Channel<'a>>, ReadError> {
    let named =
        |start: &str, end: &str| path.strip_suffix(end).filter(|path| path.starts_with(start));
    let (map, profile) = (named("/2D_Data/", "/Matrix"), named("/1D_Data/", "/Array"));
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
        Some(ItemValue::Quantity(value, symbol)) => (*value, symbol.as_str()),
        _ => (1.0, ""),
    };
    let name = match items.get(&format!("{folder}/DataKind")) {
        Some(ItemValue::Text(kind)) if !kind.is_empty() => kind,
        _ => folder.rsplit('/').next().unwrap_or_default(),
    };
    let convert = move |raw: f64| if raw.abs() < 1e30 { raw * factor } else { f64::NAN };
    Ok(Some(Channel::raster(name, unit, pixel, raster, convert)))
}

struct ItemReader<'a> {
    file: Cursor<'a>,
    count: u64,
    items: Items,
}

impl ItemReader<'_> {
    /// The end of content behind a length of its own width.
    fn end(&mut self) -> Result<usize, ReadError> {
        let (at, width) = (self.file.at, self.file.take(1)?[0]);
        let Some(sample) = Sample::whole(width.into(), false).filter(|_| width < 8) else {
            let what = format!("a length of {width} bytes, not 1, 2 or 4");
            return Err(self.file.b.fault(at, what));
        };
        let length = self.file.number(sample)? as usize;
        Ok(self.file.at.saturating_add(length))
    }

    /// Reads one item; false at the end of a container.
    fn item(&mut self, folder: &str, depth: usize) -> Result<bool, ReadError> {
        self.count += 1;
        self.file.b.check_items(self.count)?;
        if depth > 32 {
            return Err(self.file.b.fault(self.file.at, "containers nested deeper than 32"));
        }
        let path = format!("{folder}/{}", self.file.text()?);
        let at = self.file.at;
        let kind = self.file.take(1)?[0];
        if let Some(sample) = Sample::of_number(kind.into(), NUMBERS) {
            let value = ItemValue::Number(self.file.number(sample)?);
            self.items.insert(path, value);
            return Ok(true);
        }
        match kind {
            21 => return self.file.take(9).map(|_| true),
            127 => return Ok(false),
            0 => {
                self.file.text()?;
                self.file.word()?;
                self.file.text()?;
            }
            14 | 64 | 66 | 69 | 124 => drop(self.file.text()?),
            18 | 19 | 24 | 70 | 71 | 125 => {}
            _ => return Err(self.file.b.fault(at, format!("an item of unknown type {kind}"))),
        }
        let end = self.end()?;
        let start = self.file.at;
        let value = match kind {
            18 => Some(ItemValue::Text(text(self.file.b.slice(start, end - start)?))),
            19 => {
                let value = self.file.number(Sample::F64)?;
                self.file.text()?;
                Some(ItemValue::Quantity(value, self.file.text()?))
            }
            64 => {
                let shape = [1, (end - start).saturating_sub(ARRAY_HEAD) / 8];
                Some(ItemValue::Numbers(start + ARRAY_HEAD, shape, Sample::F64))
            }
            0 | 69 => {
                let shape = [self.file.word()?, self.file.word()?];
                Some(ItemValue::Numbers(self.file.at, shape, Sample::F32))
            }
            70 | 71 | 125 => {
                while self.item(&path, depth + 1)? {}
                None
            }
            _ => None,
        };
        let Cursor { b, at } = self.file;
        let rest = end.checked_sub(at);
        self.file.take(rest.ok_or_else(|| b.fault(at, "an item reaches beyond its end"))?)?;
        if let Some(value) = value {
            self.items.insert(path, value);
        }
        Ok(true)
    }
}
