//! Softgauges of NIST's surface metrology algorithm testing system (SMATS): a profile in XML.
//!
//! | element | content |
//! |---|---|
//! | `DATA/DATAFILE/UNITS` | unit of spacing and heights |
//! | `…/SPACING`, `…/NUMPOINTS` | distance of the points, their number |
//! | `…/DATA_TYPE` | `2D`: a profile |
//! | `…/DATA_POINT_VALUES` | heights, one a line |
//! | `DATA/PART`, `PROCESS`, `MEASUREMENT` | what was measured |
//!
//! Source: the softgauges of <https://physics.nist.gov/VSC/jsp/Database.jsp>.

use super::prelude::*;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(4096)];
    start.starts_with(b"<") && find(start, b"<DATAFILE").is_some() && text::is_text(bytes)
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let fields = xml::fields(b, "the softgauge")?;
    let entries = Entries::new(b, &fields);
    let kind = entries.get("DATAFILE/DATA_TYPE").unwrap_or("2D");
    if kind != "2D" {
        return Err(b.unsupported(format!("a softgauge of type {kind} (profiles 2D are)")));
    }
    let unit = entries.text("DATAFILE/UNITS")?;
    let height = |(i, cell): (usize, &str)| {
        let fault = |_| b.field(format!("point {}", i + 1), format!("{cell:?} is no number"));
        cell.parse::<f64>().map_err(fault)
    };
    let cells = entries.text("DATAFILE/DATA_POINT_VALUES")?.split_whitespace();
    let heights = cells.enumerate().map(height).collect::<Result<Vec<_>, _>>()?;
    let count = entries.number("DATAFILE/NUMPOINTS")?;
    if (heights.len() as f64 - count).abs() > 0.0 {
        return Err(b.field("NUMPOINTS", format!("{count}, but {} heights", heights.len())));
    }
    let shape = [1, heights.len()];
    b.check_points(shape)?;
    let pixel = Pixel::scaled([entries.number("DATAFILE/SPACING")?; 2], [metres_per(unit); 2]);
    let mut contents = Contents::default();
    contents.channels.push(Channel::new("Profile", Some(unit), shape, pixel, || Ok(heights)));
    contents.metadata = fields;
    contents.metadata.retain(|path, _| !path.starts_with("DATAFILE/"));
    Ok(contents)
}
