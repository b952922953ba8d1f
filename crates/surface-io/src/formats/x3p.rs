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
use crate::binary::{ByteOrder, Sample};
use crate::entries::Entries;
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError, xml};
use std::collections::BTreeMap;
use std::rc::Rc;

const FORMAT: Format = Format::X3p;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    // The name stands uncompressed in the archive, also in a damaged one.
    bytes.starts_with(MAGIC) && crate::binary::find(bytes, b"main.xml").is_some()
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    let mut archive = Archive::open(bytes, FORMAT, limits)?;
    let main = archive
        .names
        .iter()
        .filter(|n| is_main_xml(n))
        .min_by_key(|n| n.matches('/').count())
        .cloned()
        .ok_or_else(|| FORMAT.field("archive", "there is no main.xml"))?;
    let folder = &main[..main.len() - "main.xml".len()];
    let xml = archive.unpack(&main, limits)?;
    let mut main = MainXml::parse(&xml, limits)?;

    let [nx, ny, layers] = main.size()?;
    let points = nx.checked_mul(ny).and_then(|n| n.checked_mul(layers));
    limits.check_points(FORMAT, [points.unwrap_or(usize::MAX), 1])?;
    limits.check_items(FORMAT, layers as u64)?;
    let points = points.ok_or_else(|| FORMAT.field("MatrixDimension", "too many points"))?;

    let pixel = Pixel::Metres(main.pixel(ny)?);
    let mut unpack = |link: &str| match main.fields.get(&format!("Record3/DataLink/{link}")) {
        Some(link) => archive.unpack(&member(&archive, folder, link)?, limits).map(Some),
        None => Ok(None),
    };
    let raw = unpack("PointDataLink")?;
    let mask = if raw.is_some() { unpack("ValidPointsLink")? } else { None };
    let mut z = main.heights(raw.as_deref(), points)?;
    if let Some(mask) = mask {
        if mask.len() < points.div_ceil(8) {
            return Err(FORMAT.field("ValidPointsLink", "the mask is shorter than the map"));
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
        .ok_or_else(|| FORMAT.field("PointDataLink", format!("the archive has no member {link:?}")))
}

/// `main.xml`, flattened: the text of every element by its path below the root.
#[derive(Default)]
struct MainXml {
    fields: BTreeMap<String, String>,
    data: Vec<f64>,
    /// Index and text of the first Datum that is no number.
    bad_datum: Option<(usize, String)>,
}

impl MainXml {
    fn parse(xml: &[u8], limits: &Limits) -> Result<Self, ReadError> {
        let Self { mut fields, mut data, mut bad_datum } = Self::default();
        xml::walk(xml, FORMAT, "main.xml", |element| {
            let [_root, path @ ..] = element.path else { return Ok(()) };
            let text = element.text.trim();
            if path.last().is_some_and(|tag| tag == "Datum") {
                limits.check_points(FORMAT, [data.len() + 1, 1])?;
                data.push(text.parse().unwrap_or_else(|_| {
                    if !text.is_empty() {
                        bad_datum.get_or_insert_with(|| (data.len() + 1, text.to_owned()));
                    }
                    f64::NAN
                }));
            } else if !text.is_empty() {
                limits.check_items(FORMAT, fields.len() as u64 + 1)?;
                fields.insert(path.join("/"), text.to_owned());
            }
            Ok(())
        })?;
        Ok(Self { fields, data, bad_datum })
    }

    fn entries(&self) -> Entries<'_> {
        Entries::new(FORMAT, &self.fields, crate::xml::ABSENT)
    }

    fn number(&self, path: &str, default: f64) -> Result<f64, ReadError> {
        let value = self.entries().number_or(path, default)?;
        if value.is_finite() {
            return Ok(value);
        }
        Err(FORMAT.field(path.to_owned(), format!("{value} is no number")))
    }

    /// `[SizeX, SizeY, SizeZ]`.
    fn size(&self) -> Result<[usize; 3], ReadError> {
        let entries = self.entries();
        let feature = entries.text("Record1/FeatureType")?;
        if !matches!(feature, "SUR" | "PRF") {
            let feature = format!("feature type {feature} (maps SUR and profiles PRF are)");
            return Err(FORMAT.unsupported(feature));
        }
        if feature == "PRF" && entries.get("Record3/ListDimension").is_some() {
            return Ok([entries.parsed("Record3/ListDimension", "whole number")?, 1, 1]);
        }
        let side = |name: &str| {
            let path = format!("Record3/MatrixDimension/{name}");
            match entries.parsed(&path, "size")? {
                0 => Err(FORMAT.field(path, "is 0")),
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
                return Err(FORMAT.unsupported(feature));
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
                return Err(FORMAT.field("Record1/Axes/CZ/DataType", what));
            }
        };
        let mut z = match raw {
            Some(raw) => binary_heights(raw, sample, points)?,
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
            return Err(FORMAT.field("Record3/DataList", what));
        }
        if let Some((index, text)) = &self.bad_datum {
            let what = if text.contains(';') {
                "several coordinates in one Datum (only z of evenly spaced axes is read)"
            } else {
                "no number"
            };
            return Err(FORMAT.field(format!("Datum {index}"), format!("{text:?}: {what}")));
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

fn binary_heights(raw: &[u8], sample: Sample, points: usize) -> Result<Vec<f64>, ReadError> {
    if raw.len() / sample.size() < points {
        let what = format!("{} bytes for {points} points of {} bytes", raw.len(), sample.size());
        return Err(FORMAT.field("PointDataLink", what));
    }
    let mut z = sample.decode(&raw[..points * sample.size()], ByteOrder::Little);
    // Some writers mark a missing point by infinity instead of NaN.
    z.iter_mut().filter(|z| z.is_infinite()).for_each(|z| *z = f64::NAN);
    Ok(z)
}
