//! X3P, ISO 25178-72 (formerly ISO 5436-2): a ZIP archive with `main.xml` and, for large maps,
//! binary data beside it.
//!
//! | member or element | content |
//! |---|---|
//! | `main.xml` | in the top folder, or in one folder below it |
//! | `Record1/FeatureType` | `SUR` map, `PRF` profile, `PCL` point cloud (refused) |
//! | `Record1/Axes/CX`, `CY`, `CZ` | `AxisType` `I` incremental or `A` absolute; `DataType` `I` i16, `L` i32, `F` f32, `D` f64; `Increment`, `Offset` in metres |
//! | `Record2` | instrument, date, creator: metadata |
//! | `Record3/MatrixDimension` | `SizeX` (fastest), `SizeY`, `SizeZ` (layers, slowest) |
//! | `Record3/DataList/Datum` | one z per element as text; an empty element is a missing point |
//! | `Record3/DataLink/PointDataLink` | path of the binary z, little endian, beside `main.xml` |
//! | `Record3/DataLink/ValidPointsLink` | path of the mask: one bit per point, lowest bit first, 1 = valid |
//!
//! Heights are `z * Increment + Offset` for integers; floating point heights are metres already
//! and only the offset applies. NaN and infinity are missing points. `Increment` is the distance of neighbouring
//! points. A document type declaration
//! is refused, so no entity is ever expanded.
//!
//! Source: ISO 25178-72:2017; the schema `ISO5436_2.xsd` and sample files of openGPS,
//! <https://sourceforge.net/p/open-gps>.

use super::archive::{Archive, MAGIC, is_main_xml};
use super::prelude::*;
use crate::xml;
use std::rc::Rc;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    // The name stands uncompressed in the archive, also in a damaged one.
    bytes.starts_with(MAGIC) && crate::binary::find(bytes, b"main.xml").is_some()
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let mut archive = Archive::open(b)?;
    let main = archive
        .names
        .iter()
        .filter(|n| is_main_xml(n))
        .min_by_key(|n| n.matches('/').count())
        .cloned()
        .ok_or_else(|| b.field("archive", "there is no main.xml"))?;
    let folder = &main[..main.len() - "main.xml".len()];
    let xml = archive.unpack(&main)?;
    let mut main = MainXml::parse(b.with(&xml))?;

    let [nx, ny, layers] = main.size()?;
    let points = nx.checked_mul(ny).and_then(|n| n.checked_mul(layers));
    b.check_points([points.unwrap_or(usize::MAX), 1])?;
    b.check_items(layers as u64)?;
    let points = points.ok_or_else(|| b.field("MatrixDimension", "too many points"))?;

    let pixel = Pixel::Metres(main.pixel(ny)?);
    let mut unpack = |link: &str| match main.fields.get(&format!("Record3/DataLink/{link}")) {
        Some(link) => archive.unpack(&member(&archive, folder, link)?).map(Some),
        None => Ok(None),
    };
    let raw = unpack("PointDataLink")?;
    let mask = if raw.is_some() { unpack("ValidPointsLink")? } else { None };
    let mut z = main.heights(raw.as_deref(), points)?;
    if let Some(mask) = mask {
        if mask.len() < points.div_ceil(8) {
            return Err(b.field("ValidPointsLink", "the mask is shorter than the map"));
        }
        for (i, z) in z.iter_mut().enumerate() {
            if mask[i / 8] >> (i % 8) & 1 == 0 {
                *z = f64::NAN;
            }
        }
    }

    let z = Rc::new(z);
    let channels = (0..layers)
        .map(|layer| {
            let z = Rc::clone(&z);
            let name = match layers {
                1 => "Topography".to_owned(),
                _ => format!("Topography, layer {}", layer + 1),
            };
            Channel::new(name, Some("m"), [ny, nx], pixel, move || {
                // The only layer is given away, one of several is copied.
                let n = nx * ny;
                Ok(Rc::try_unwrap(z).unwrap_or_else(|z| z[layer * n..(layer + 1) * n].to_vec()))
            })
        })
        .collect();
    Ok(Contents { channels, metadata: main.metadata() })
}

/// A link is relative to `main.xml`; some writers start it at the top folder.
fn member(archive: &Archive<'_>, folder: &str, link: &str) -> Result<String, ReadError> {
    let link = link.trim().trim_start_matches("./").replace('\\', "/");
    [format!("{folder}{link}"), link.trim_start_matches('/').to_owned()]
        .into_iter()
        .find(|name| archive.names.contains(name))
        .ok_or_else(|| {
            archive.b.field("PointDataLink", format!("the archive has no member {link:?}"))
        })
}

/// `main.xml`, flattened: the text of every element by its path below the root.
struct MainXml<'a> {
    b: Bytes<'a>,
    fields: BTreeMap<String, String>,
    data: Vec<f64>,
    /// Index and text of the first Datum that is no number.
    bad_datum: Option<(usize, String)>,
}

impl<'a> MainXml<'a> {
    fn parse(b: Bytes<'a>) -> Result<Self, ReadError> {
        let (mut fields, mut data, mut bad_datum) = (BTreeMap::new(), Vec::new(), None);
        xml::walk(b, "main.xml", |element| {
            let [_root, path @ ..] = element.path else { return Ok(()) };
            let text = element.text.trim();
            if path.last().is_some_and(|tag| tag == "Datum") {
                b.check_points([data.len() + 1, 1])?;
                data.push(text.parse().unwrap_or_else(|_| {
                    if !text.is_empty() {
                        bad_datum.get_or_insert_with(|| (data.len() + 1, text.to_owned()));
                    }
                    f64::NAN
                }));
            } else if !text.is_empty() {
                b.check_items(fields.len() as u64 + 1)?;
                fields.insert(path.join("/"), text.to_owned());
            }
            Ok(())
        })?;
        Ok(Self { b, fields, data, bad_datum })
    }

    fn entries(&self) -> Entries<'_> {
        Entries::new(self.b, &self.fields, xml::ABSENT)
    }

    fn number(&self, path: &str, default: f64) -> Result<f64, ReadError> {
        let value = self.entries().number_or(path, default)?;
        if value.is_finite() {
            return Ok(value);
        }
        Err(self.b.field(path.to_owned(), format!("{value} is no number")))
    }

    /// `[SizeX, SizeY, SizeZ]`.
    fn size(&self) -> Result<[usize; 3], ReadError> {
        let entries = self.entries();
        let feature = entries.text("Record1/FeatureType")?;
        if !matches!(feature, "SUR" | "PRF") {
            let feature = format!("feature type {feature} (maps SUR and profiles PRF are)");
            return Err(self.b.unsupported(feature));
        }
        if feature == "PRF" && entries.get("Record3/ListDimension").is_some() {
            return Ok([entries.parsed("Record3/ListDimension", "whole number")?, 1, 1]);
        }
        let side = |name: &str| {
            let path = format!("Record3/MatrixDimension/{name}");
            match entries.parsed(&path, "size")? {
                0 => Err(self.b.field(path, "is 0")),
                side => Ok(side),
            }
        };
        Ok([side("SizeX")?, side("SizeY")?, side("SizeZ")?])
    }

    /// `[dy, dx]` of incremental axes.
    fn pixel(&self, ny: usize) -> Result<[f64; 2], ReadError> {
        let step = |axis: &str| {
            let kind = self.entries().text(&format!("Record1/Axes/{axis}/AxisType"))?;
            if kind != "I" {
                let feature = format!("axis {axis} of type {kind} (evenly spaced axes, I, are)");
                return Err(self.b.unsupported(feature));
            }
            let path = format!("Record1/Axes/{axis}/Increment");
            self.entries().text(&path)?;
            self.number(&path, 0.0)
        };
        let dx = step("CX")?;
        // The y axis of a profile has no steps.
        let dy = if ny == 1 { step("CY").unwrap_or(dx) } else { step("CY")? };
        Ok([dy, dx])
    }

    /// In metres, from the binary data or else from the list.
    fn heights(&mut self, raw: Option<&[u8]>, points: usize) -> Result<Vec<f64>, ReadError> {
        let offset = self.number("Record1/Axes/CZ/Offset", 0.0)?;
        let increment = self.number("Record1/Axes/CZ/Increment", 1.0)?;
        let (sample, factor) = match self.entries().text("Record1/Axes/CZ/DataType")? {
            "I" => (Sample::I16, increment),
            "L" => (Sample::I32, increment),
            "F" => (Sample::F32, 1.0),
            "D" => (Sample::F64, 1.0),
            other => {
                let what = format!("{other:?} is none of I, L, F, D");
                return Err(self.b.field("Record1/Axes/CZ/DataType", what));
            }
        };
        let mut z = match raw {
            Some(raw) => binary_heights(self.b, raw, sample, points)?,
            None => self.listed_heights(points)?,
        };
        for z in &mut z {
            *z = *z * factor + offset;
        }
        Ok(z)
    }

    fn listed_heights(&mut self, points: usize) -> Result<Vec<f64>, ReadError> {
        if self.data.len() != points {
            let what = format!("{} values for {points} points", self.data.len());
            return Err(self.b.field("Record3/DataList", what));
        }
        if let Some((index, text)) = &self.bad_datum {
            let what = if text.contains(';') {
                "several coordinates in one Datum (only z of evenly spaced axes is read)"
            } else {
                "no number"
            };
            return Err(self.b.field(format!("Datum {index}"), format!("{text:?}: {what}")));
        }
        Ok(std::mem::take(&mut self.data))
    }

    fn metadata(&self) -> BTreeMap<String, String> {
        self.fields
            .iter()
            .filter_map(|(path, value)| {
                let key =
                    path.strip_prefix("Record2/").or_else(|| path.strip_prefix("Record1/"))?;
                (!key.starts_with("Axes/")).then(|| (key.to_owned(), value.clone()))
            })
            .collect()
    }
}

fn binary_heights(
    b: Bytes<'_>,
    raw: &[u8],
    sample: Sample,
    points: usize,
) -> Result<Vec<f64>, ReadError> {
    if raw.len() / sample.size() < points {
        let what = format!("{} bytes for {points} points of {} bytes", raw.len(), sample.size());
        return Err(b.field("PointDataLink", what));
    }
    let mut z = sample.decode(&raw[..points * sample.size()], ByteOrder::Little);
    // Some writers mark a missing point by infinity instead of NaN.
    z.iter_mut().filter(|z| z.is_infinite()).for_each(|z| *z = f64::NAN);
    Ok(z)
}
