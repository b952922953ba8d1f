//! GWY of Gwyddion. All numbers little endian.
//!
//! | what | content |
//! |---|---|
//! | file | `GWYP`, then one object, `GwyContainer` |
//! | object | name, NUL; u32 length of its items; the items |
//! | item | name, NUL; one character for the type; the value |
//! | types | `b` u8, `c` u8, `i` i32, `q` i64, `d` f64, `s` text NUL, `o` object; in capitals: u32 count, then as many (`C I Q D S O`) |
//! | `/0/data` | object `GwyDataField`: `xres`, `yres` (i), `xreal`, `yreal` (d, total size: N pixels), `si_unit_xy`, `si_unit_z` (objects with `unitstr`, base units), `data` (D) |
//! | `/0/data/title` | name of channel 0; further channels have other numbers |
//! | `/0/mask` | `GwyDataField` of the same size: points above 0 are masked |
//!
//! NaN is a missing point. A mask marks points for whatever its maker had in mind; masked points
//! are read as missing, which is what importers use it for, and the metadata say how many.
//!
//! Source: <https://gwyddion.net/documentation/user-guide-en/gwyfile-format.html>.

use super::prelude::*;

/// A value in a container; arrays of numbers stay where they are in the file.
enum Component<'a> {
    Number(f64),
    Text(String),
    Object(String, Items<'a>),
    Doubles(Bytes<'a>),
    Other,
}

type Items<'a> = BTreeMap<String, Component<'a>>;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut reader = ObjectReader { file: Cursor { b, at: 4 }, count: 0 };
    let (name, items) = reader.object(0)?;
    if name != "GwyContainer" {
        return Err(b.fault(4, format!("the object is {name:?}, not \"GwyContainer\"")));
    }
    let mut contents = Contents::default();
    let mut numbers: Vec<u64> = items
        .keys()
        .filter_map(|key| key.strip_prefix('/')?.strip_suffix("/data")?.parse().ok())
        .collect();
    numbers.sort_unstable();
    for number in numbers {
        let item = |name: &str| items.get(&format!("/{number}/{name}"));
        let Some(Component::Object(kind, field)) = item("data") else { continue };
        if kind != "GwyDataField" {
            continue;
        }
        let title = match item("data/title") {
            Some(Component::Text(title)) => title.clone(),
            _ => format!("channel {number}"),
        };
        let mut channel = channel(b, title, field)?;
        if let Some(Component::Object(_, mask)) = item("mask")
            && let Some(&Component::Doubles(mask)) = mask.get("data")
        {
            let marks = move || Sample::F64.decode(mask.data, mask.order);
            let marked = marks().iter().filter(|mark| **mark > 0.0).count();
            let note = format!("{marked} points, read as missing");
            contents.metadata.insert(format!("mask of channel {number}"), note);
            if mask.data.len() == 8 * channel.info.shape[0] * channel.info.shape[1] {
                channel = channel.masked(move || Ok(marks()));
            }
        }
        contents.channels.push(channel);
        if let Some(Component::Object(_, meta)) = item("meta") {
            for (key, value) in meta {
                if let Component::Text(value) = value {
                    contents.metadata.entry(key.clone()).or_insert_with(|| value.clone());
                }
            }
        }
    }
    Ok(contents)
}

fn channel<'a>(b: Bytes<'a>, title: String, field: &Items<'a>) -> Result<Channel<'a>, ReadError> {
    let number = |key: &'static str| match field.get(key) {
        Some(Component::Number(value)) => Ok(*value),
        _ => Err(b.field(key, "is missing in a data field")),
    };
    let side = |key: &'static str| {
        let value = number(key)?;
        if value >= 1.0 { Ok(value as usize) } else { Err(b.field(key, format!("is {value}"))) }
    };
    let unit = |key: &str| {
        let Some(Component::Object(_, unit)) = field.get(key) else { return "" };
        if let Some(Component::Text(unit)) = unit.get("unitstr") { unit.as_str() } else { "" }
    };
    let (ny, nx) = (side("yres")?, side("xres")?);
    b.check_points([ny, nx])?;
    let size = [number("yreal")? / ny as f64, number("xreal")? / nx as f64];
    let pixel = Pixel::scaled(size, [metres_per(unit("si_unit_xy")); 2]);
    let Some(&Component::Doubles(data)) = field.get("data") else {
        return Err(b.field("data", "is missing in a data field"));
    };
    if data.data.len() != 8 * ny * nx {
        let what = format!("{} heights for {ny} x {nx} points", data.data.len() / 8);
        return Err(b.field("data", what));
    }
    let decode = move || Ok(Sample::F64.decode(data.data, data.order));
    Ok(Channel::new(title, Some(unit("si_unit_z")), [ny, nx], pixel, decode))
}

/// Walks through the items of an object, which end with its bytes.
struct ObjectReader<'a> {
    file: Cursor<'a>,
    count: u64,
}

impl<'a> ObjectReader<'a> {
    fn text(&mut self) -> Result<String, ReadError> {
        let Cursor { b, at } = self.file;
        let end = b.from(at)?.data.iter().position(|&byte| byte == 0);
        let length = end.ok_or_else(|| b.fault(at, "a text has no end"))?;
        Ok(text(self.file.take(length + 1)?))
    }

    fn object(&mut self, depth: usize) -> Result<(String, Items<'a>), ReadError> {
        let name = self.text()?;
        let length = self.file.word()?;
        let Cursor { b, at } = self.file;
        if depth > 16 {
            return Err(b.fault(at, "objects nested deeper than 16"));
        }
        if self.file.take(length).is_err() {
            return Err(b.fault(at, format!("object {name:?} reaches beyond its parent")));
        }
        let own = Cursor { b: b.with(&b.data[..at + length]), at };
        let mut reader = ObjectReader { file: own, count: self.count };
        let mut items = BTreeMap::new();
        while reader.file.at < at + length {
            reader.step()?;
            let key = reader.text()?;
            items.insert(key, reader.value(depth)?);
        }
        self.count = reader.count;
        Ok((name, items))
    }

    /// Counts the items, of all objects together.
    fn step(&mut self) -> Result<(), ReadError> {
        self.count += 1;
        self.file.b.check_items(self.count)
    }

    fn value(&mut self, depth: usize) -> Result<Component<'a>, ReadError> {
        let Cursor { b, at } = self.file;
        let kind = self.file.take(1)?[0];
        Ok(match kind {
            b'b' | b'c' => Component::Number(self.file.number(Sample::U8)?),
            b'i' => Component::Number(self.file.number(Sample::I32)?),
            b'q' => Component::Number(self.file.number(Sample::I64)?),
            b'd' => Component::Number(self.file.number(Sample::F64)?),
            b's' => Component::Text(self.text()?),
            b'o' => {
                let (name, items) = self.object(depth + 1)?;
                Component::Object(name, items)
            }
            b'C' | b'I' | b'Q' | b'D' => {
                let size = match kind {
                    b'C' => 1,
                    b'I' => 4,
                    _ => 8,
                };
                let length = self.file.word()?.saturating_mul(size);
                let data = self.file.take(length)?;
                if kind == b'D' { Component::Doubles(b.with(data)) } else { Component::Other }
            }
            b'S' | b'O' => {
                for _ in 0..self.file.word()? {
                    self.step()?;
                    if kind == b'S' {
                        self.text()?;
                    } else {
                        self.object(depth + 1)?;
                    }
                }
                Component::Other
            }
            other => {
                let what = format!("an item of unknown type {:?}", char::from(other));
                return Err(b.fault(at, what));
            }
        })
    }
}
