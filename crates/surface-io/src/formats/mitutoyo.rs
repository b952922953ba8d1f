//! Workbooks (`.xlsx`) of Mitutoyo SurfTest roughness testers: a ZIP archive of XML.
//!
//! | what | content |
//! |---|---|
//! | `xl/workbook.xml`, `xl/_rels/workbook.xml.rels` | names of the sheets, and their members |
//! | `xl/sharedStrings.xml` | texts by number |
//! | sheet `DATA`, columns E and F | positions and heights of one profile |
//! | sheet `DATA`, column A | parameters: `Ra     3.308  µm`; the unit of the first one is that of the heights |
//! | sheet `Certificate`, E48 | cut-off: `2.5mm`; its unit is that of the positions |
//! | sheet `Certificate`, E2 | date |
//!
//! Positions fix the spacing: (last − first) / (N − 1).
//!
//! Sources: SurfaceTopography (open); ISO/IEC 29500 for the container; three made workbooks of that
//! project, none from an instrument.

use super::prelude::*;
use super::scattered::{Line, profile};
use crate::cells::Digits;
use crate::units::quantity;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut book = Book::open(b)?;
    let mut contents = Contents::default();
    let (mut x, mut z) = (BTreeMap::new(), BTreeMap::new());
    let mut height_unit = None;
    book.sheet("DATA", |row, column, value| {
        match (column, value.parse::<f64>()) {
            ("E", Ok(number)) => drop(x.insert(row, number)),
            ("F", Ok(number)) => drop(z.insert(row, number)),
            ("A", Err(_)) => {
                let words: Vec<&str> = value.split_whitespace().collect();
                if let [name, _, unit, ..] = words[..] {
                    height_unit = height_unit.take().or_else(|| length_unit(unit));
                    contents.metadata.insert(name.to_owned(), words[1..].join(" "));
                }
            }
            _ => {}
        }
        b.check_points([x.len().max(z.len()), 1])
    })?;
    let mut x_unit = None;
    book.sheet("Certificate", |row, column, value| {
        match (column, row) {
            ("E", 48) => x_unit = quantity(value).and_then(|(_, unit)| length_unit(unit)),
            ("E", 2) => drop(contents.metadata.insert("date".into(), value.to_owned())),
            _ => {}
        }
        Ok(())
    })?;
    if x.keys().ne(z.keys()) || x.is_empty() {
        let (x, z) = (x.len(), z.len());
        let what = format!("{x} positions in column E, {z} heights in F: every row must have both");
        return Err(b.field("DATA", what));
    }
    let mut digits = Digits::NONE;
    for x in x.values() {
        digits.add(&x.to_string());
    }
    let x: Vec<f64> = x.into_values().collect();
    let line = Line::new(&x, digits).map_err(|what| b.field("DATA, column E", what))?;
    let heights = move || Ok(z.into_values().collect());
    let positions = Some((line, x_unit.as_deref()));
    contents.channels.push(profile("Profile", height_unit.as_deref(), x.len(), positions, heights));
    Ok(contents)
}

fn length_unit(text: &str) -> Option<String> {
    metres_per(text).map(|_| text.trim().to_owned())
}

/// A workbook: its texts, and the members of its sheets.
struct Book<'a> {
    archive: Archive<'a>,
    texts: Vec<String>,
    sheets: BTreeMap<String, String>,
}

impl<'a> Book<'a> {
    fn open(b: Bytes<'a>) -> Result<Self, ReadError> {
        let mut archive = Archive::open(b)?;
        let mut texts = vec![String::new()];
        if archive.names.iter().any(|name| name == "xl/sharedStrings.xml") {
            let strings = archive.unpack("xl/sharedStrings.xml")?;
            // A text can be in pieces of different looks: <si><r><t>..</t></r>..</si>.
            xml::walk(b.with(&strings), "sharedStrings.xml", |element| {
                match element.name() {
                    "t" => texts.last_mut().expect("there is one").push_str(element.text),
                    "si" => {
                        b.check_points([texts.len(), 1])?;
                        texts.push(String::new());
                    }
                    _ => {}
                }
                Ok(())
            })?;
        }
        let mut targets = BTreeMap::new();
        let relations = archive.unpack("xl/_rels/workbook.xml.rels")?;
        xml::walk(b.with(&relations), "workbook.xml.rels", |element| {
            if let (Some(id), Some(target)) = (element.attribute("Id"), element.attribute("Target"))
            {
                b.check_items(targets.len() as u64 + 1)?;
                let target = target.trim_start_matches("/xl/");
                targets.insert(id.to_owned(), format!("xl/{target}"));
            }
            Ok(())
        })?;
        let mut sheets = BTreeMap::new();
        let workbook = archive.unpack("xl/workbook.xml")?;
        xml::walk(b.with(&workbook), "workbook.xml", |element| {
            if element.name() == "sheet"
                && let (Some(name), Some(id)) = (element.attribute("name"), element.attribute("id"))
                && let Some(member) = targets.get(id)
            {
                sheets.insert(name.to_owned(), member.clone());
            }
            Ok(())
        })?;
        Ok(Self { archive, texts, sheets })
    }

    /// Calls `visit` with row, column and text of every cell of a sheet that is not empty.
    fn sheet(
        &mut self,
        name: &str,
        mut visit: impl FnMut(u32, &str, &str) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        let b = self.archive.b;
        let Some(member) = self.sheets.get(name) else {
            let names: Vec<&str> = self.sheets.keys().map(String::as_str).collect();
            return Err(b.unsupported(format!(
                "a workbook without a sheet {name:?} (a Mitutoyo SurfTest file has one; this has \
                 {}; save a sheet of numbers as CSV)",
                names.join(", ")
            )));
        };
        let sheet = self.archive.unpack(member)?;
        let mut value = String::new();
        let texts = &self.texts;
        xml::walk(b.with(&sheet), name, |element| {
            match element.name() {
                "v" | "t" => element.text.clone_into(&mut value),
                "c" => {
                    let text = std::mem::take(&mut value);
                    let Some(place) = element.attribute("r") else { return Ok(()) };
                    let digit = place.find(|c: char| c.is_ascii_digit()).unwrap_or(place.len());
                    let (column, row) = place.split_at(digit);
                    let is_shared = element.attribute("t") == Some("s");
                    let shared =
                        is_shared.then(|| texts.get(text.parse::<usize>().ok()?)).flatten();
                    let text = shared.map_or(text.as_str(), String::as_str).trim();
                    if let (Ok(row), false) = (row.parse(), text.is_empty()) {
                        visit(row, column, text)?;
                    }
                }
                _ => {}
            }
            Ok(())
        })
    }
}
