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
    let heights: Vec<f64> = entries
        .text("DATAFILE/DATA_POINT_VALUES")?
        .split_whitespace()
        .enumerate()
        .map(|(i, cell)| {
            let what = || format!("{cell:?} is no number");
            cell.parse().map_err(|_| b.field(format!("point {}", i + 1), what()))
        })
        .collect::<Result<_, _>>()?;
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

#[cfg(test)]
mod tests {
    use crate::{ReadOptions, read_bytes};

    #[test]
    fn a_profile_in_xml() {
        let file = "<?xml version='1.0' encoding='UTF-8'?>\n<?xml-stylesheet type=\"text/xsl\" \
                    href=\"data.xsl\"?>\n<!DOCTYPE DATA SYSTEM \"data.dtd\">\n<DATA><PART><PART_NAME>sine\
                    </PART_NAME></PART><DATAFILE>\n<UNITS>um</UNITS><NUMPOINTS>4</NUMPOINTS>\
                    <SPACING>0.5</SPACING>\n<KCAL>1um/mv</KCAL><DATA_TYPE>2D</DATA_TYPE>\n\
                    <DATA_POINT_VALUES>0.0\n0.0079\n-1.0E-4\n2</DATA_POINT_VALUES></DATAFILE></DATA>\n";
        let options = ReadOptions::default();
        let found = read_bytes(file.as_bytes(), &options).unwrap();
        assert!(found.is_profile());
        assert_eq!(found.metadata["PART/PART_NAME"], "sine");
        assert!((found.grid().pixel()[1] / 0.5e-6 - 1.0).abs() < 1e-12);
        for (i, right) in [(1, 7.9e-9), (2, -1e-10), (3, 2e-6)] {
            assert!((found.heights()[i] / right - 1.0).abs() < 1e-12);
        }
        for (from, to, word) in [
            ("<NUMPOINTS>4", "<NUMPOINTS>5", "4 heights"),
            ("2D", "3D", "type 3D"),
            ("0.0079", "0.oo79", "point 2"),
            ("\"data.dtd\">", "\"data.dtd\" [<!ENTITY e \"1\">]>", "document type"),
        ] {
            let error = read_bytes(file.replace(from, to).as_bytes(), &options).unwrap_err();
            assert!(error.to_string().contains(word), "{error}");
        }
    }
}
