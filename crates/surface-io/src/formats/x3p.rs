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
//! points, so the question of N or N − 1 intervals does not arise. A document type declaration
//! is refused, so no entity is ever expanded.
//!
//! Source: ISO 25178-72:2017; the schema `ISO5436_2.xsd` and sample files of openGPS,
//! <https://sourceforge.net/p/open-gps>.

use super::archive::{Archive, MAGIC, is_main_xml};
use crate::binary::{Bytes, Order, Sample};
use crate::measurement::{Channel, Contents, Pixel};
use crate::{Format, Limits, ReadError, xml};
use std::borrow::Cow;
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
        .ok_or_else(|| fault("archive", "there is no main.xml"))?;
    let folder = &main[..main.len() - "main.xml".len()];
    let xml = archive.unpack(&main, limits)?;
    let mut document = Document::parse(&xml, limits)?;

    let [nx, ny, layers] = document.size()?;
    let points = nx.checked_mul(ny).and_then(|n| n.checked_mul(layers));
    limits.check_points(FORMAT, [points.unwrap_or(usize::MAX), 1])?;
    limits.check_items(FORMAT, layers as u64)?;
    let points = points.ok_or_else(|| fault("MatrixDimension", "too many points"))?;

    let pixel = document.pixel([ny, nx])?;
    let z = if let Some(link) = document.fields.get("Record3/DataLink/PointDataLink") {
        let raw = archive.unpack(&member(&archive, folder, link)?, limits)?;
        let mut z = document.binary_heights(&raw, points)?;
        if let Some(link) = document.fields.get("Record3/DataLink/ValidPointsLink") {
            let mask = archive.unpack(&member(&archive, folder, link)?, limits)?;
            if mask.len() < points.div_ceil(8) {
                return Err(fault("ValidPointsLink", "the mask is shorter than the map"));
            }
            for (i, z) in z.iter_mut().enumerate() {
                if mask[i / 8] >> (i % 8) & 1 == 0 {
                    *z = f64::NAN;
                }
            }
        }
        z
    } else {
        document.listed_heights(points)?
    };

    let z = Rc::new(z);
    let channels = (0..layers)
        .map(|layer| {
            let z = Rc::clone(&z);
            let name = match layers {
                1 => "Topography".to_owned(),
                _ => format!("Topography, layer {}", layer + 1),
            };
            Channel::new(name, Some("m"), [ny, nx], Pixel::Metres(pixel), move || {
                // The only layer is given away, one of several is copied.
                let n = nx * ny;
                Ok(Rc::try_unwrap(z).unwrap_or_else(|z| z[layer * n..(layer + 1) * n].to_vec()))
            })
        })
        .collect();
    Ok(Contents { channels, metadata: document.metadata() })
}

/// A link is relative to `main.xml`; some writers start it at the top folder.
fn member(archive: &Archive<'_>, folder: &str, link: &str) -> Result<String, ReadError> {
    let link = link.trim().trim_start_matches("./").replace('\\', "/");
    [format!("{folder}{link}"), link.trim_start_matches('/').to_owned()]
        .into_iter()
        .find(|name| archive.names.contains(name))
        .ok_or_else(|| fault("PointDataLink", format!("the archive has no member {link:?}")))
}

fn fault(field: impl Into<Cow<'static, str>>, what: impl Into<Cow<'static, str>>) -> ReadError {
    Bytes::little(&[], FORMAT).field(field, what)
}

/// `main.xml`, flattened: the text of every element by its path below the root.
#[derive(Default)]
struct Document {
    fields: BTreeMap<String, String>,
    data: Vec<f64>,
    /// Index and text of the first Datum that is no number.
    bad_datum: Option<(usize, String)>,
}

impl Document {
    fn parse(xml: &[u8], limits: &Limits) -> Result<Self, ReadError> {
        let mut document = Self::default();
        xml::walk(xml, FORMAT, "main.xml", |element| {
            document.close(element.path, element.text, limits)
        })?;
        Ok(document)
    }

    fn close(&mut self, path: &[String], value: &str, limits: &Limits) -> Result<(), ReadError> {
        let [_root, path @ ..] = path else { return Ok(()) };
        if path.last().is_some_and(|tag| tag == "Datum") {
            limits.check_points(FORMAT, [self.data.len() + 1, 1])?;
            let value = value.trim();
            self.data.push(match value.parse() {
                Ok(z) => z,
                Err(_) if value.is_empty() => f64::NAN,
                Err(_) => {
                    self.bad_datum.get_or_insert_with(|| (self.data.len() + 1, value.to_owned()));
                    f64::NAN
                }
            });
        } else if !value.trim().is_empty() {
            limits.check_items(FORMAT, self.fields.len() as u64 + 1)?;
            self.fields.insert(path.join("/"), value.trim().to_owned());
        }
        Ok(())
    }

    fn get(&self, path: &str) -> Result<&str, ReadError> {
        self.fields
            .get(path)
            .map(String::as_str)
            .ok_or_else(|| fault(path.to_owned(), "the element is missing or empty"))
    }

    fn number(&self, path: &str, default: f64) -> Result<f64, ReadError> {
        match self.fields.get(path) {
            None => Ok(default),
            Some(text) => text
                .parse::<f64>()
                .ok()
                .filter(|v| v.is_finite())
                .ok_or_else(|| fault(path.to_owned(), format!("{text:?} is no number"))),
        }
    }

    /// `[SizeX, SizeY, SizeZ]`.
    fn size(&self) -> Result<[usize; 3], ReadError> {
        let feature = self.get("Record1/FeatureType")?;
        if !matches!(feature, "SUR" | "PRF") {
            let feature = format!("feature type {feature} (maps SUR and profiles PRF are)");
            return Err(ReadError::Unsupported { format: FORMAT, feature: feature.into() });
        }
        if let (Some(n), "PRF") = (self.fields.get("Record3/ListDimension"), feature) {
            let n = n.parse().map_err(|_| fault("Record3/ListDimension", "no whole number"))?;
            return Ok([n, 1, 1]);
        }
        let side = |name: &str| {
            let path = format!("Record3/MatrixDimension/{name}");
            let text = self.get(&path)?;
            let side: usize =
                text.parse().map_err(|_| fault(path.clone(), format!("{text:?} is no size")))?;
            if side == 0 {
                return Err(fault(path, "is 0"));
            }
            Ok(side)
        };
        Ok([side("SizeX")?, side("SizeY")?, side("SizeZ")?])
    }

    /// `[dy, dx]` of incremental axes.
    fn pixel(&self, [ny, _]: [usize; 2]) -> Result<[f64; 2], ReadError> {
        let step = |axis: &str| {
            let kind = self.get(&format!("Record1/Axes/{axis}/AxisType"))?;
            if kind != "I" {
                let feature = format!("axis {axis} of type {kind} (evenly spaced axes, I, are)");
                return Err(ReadError::Unsupported { format: FORMAT, feature: feature.into() });
            }
            self.get(&format!("Record1/Axes/{axis}/Increment"))?;
            self.number(&format!("Record1/Axes/{axis}/Increment"), 0.0)
        };
        let dx = step("CX")?;
        // The y axis of a profile has no steps.
        let dy = if ny == 1 { step("CY").unwrap_or(dx) } else { step("CY")? };
        Ok([dy, dx])
    }

    /// Type of the stored z with the factor and offset to metres.
    fn encoding(&self) -> Result<(Sample, f64, f64), ReadError> {
        let offset = self.number("Record1/Axes/CZ/Offset", 0.0)?;
        let increment = self.number("Record1/Axes/CZ/Increment", 1.0)?;
        Ok(match self.get("Record1/Axes/CZ/DataType")? {
            "I" => (Sample::I16, increment, offset),
            "L" => (Sample::I32, increment, offset),
            "F" => (Sample::F32, 1.0, offset),
            "D" => (Sample::F64, 1.0, offset),
            other => {
                return Err(fault(
                    "Record1/Axes/CZ/DataType",
                    format!("{other:?} is none of I, L, F, D"),
                ));
            }
        })
    }

    fn binary_heights(&self, raw: &[u8], points: usize) -> Result<Vec<f64>, ReadError> {
        let (sample, factor, offset) = self.encoding()?;
        if raw.len() / sample.size() < points {
            let what =
                format!("{} bytes for {points} points of {} bytes", raw.len(), sample.size());
            return Err(fault("PointDataLink", what));
        }
        let mut z = sample.decode(&raw[..points * sample.size()], Order::Little);
        // Some writers mark a missing point by infinity instead of NaN.
        z.iter_mut().filter(|z| z.is_infinite()).for_each(|z| *z = f64::NAN);
        scale(&mut z, factor, offset);
        Ok(z)
    }

    fn listed_heights(&mut self, points: usize) -> Result<Vec<f64>, ReadError> {
        let (_, factor, offset) = self.encoding()?;
        if self.data.len() != points {
            let what = format!("{} values for {points} points", self.data.len());
            return Err(fault("Record3/DataList", what));
        }
        if let Some((index, text)) = &self.bad_datum {
            let what = if text.contains(';') {
                "several coordinates in one Datum (only z of evenly spaced axes is read)"
            } else {
                "no number"
            };
            return Err(fault(format!("Datum {index}"), format!("{text:?}: {what}")));
        }
        let mut z = std::mem::take(&mut self.data);
        scale(&mut z, factor, offset);
        Ok(z)
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

fn scale(z: &mut [f64], factor: f64, offset: f64) {
    for z in z {
        *z = *z * factor + offset;
    }
}
