//! Text with numbers: a matrix of heights, a list of x y z, or a profile x z.
//!
//! | what | recognised by |
//! |---|---|
//! | separators | semicolon, tab, comma, blanks; empty cells, `NaN`, `NA`, `bad`, `---` are missing points |
//! | decimal comma | where the comma is not the separator; both marks in one file are refused |
//! | encodings | UTF-8, UTF-16 with byte order mark, Latin-1; `\n`, `\r\n`, `\r`, also mixed |
//! | header | the lines before the first two lines with equally many numbers; lines starting with `#`, `%`, `!`, `//` |
//! | `Width`, `Height` with unit | total size of a matrix: the pixel is size / N (Gwyddion's export in its languages; SPIP's `x-length`, `x-unit`, nm if absent) |
//! | `pixel size`, `dx`, `dy` with unit | spacing of a matrix; Nova's `Scale X`, `Unit X`; Keyence's `XY Calibration` |
//! | `Lateral units` | unit of x and y (Gwyddion's XYZ export) |
//! | `Value units`, `z-unit`, `Unit Data` | unit of the heights; in a Keyence export also `Unit` |
//! | `Bit2nm`; `Scale Data`, `Bias Data` if `DataScaleNeeded` | nm per stored number (SPIP); factor and offset (Nova) |
//! | `voidpixels` above 0, twice `y-pixels` rows | the second half is 0 where a point is missing (SPIP) |
//! | `height conversion factor (-> m)` | metres per stored number (SPIP) |
//! | units in column titles | `X [mm]`, `X_(microns)`, `x in µm`, `µm µm` |
//! | three columns | x y z on a grid in any order (row 0 = smallest y); `X;Y;valid` is a profile; unless the layout is given |
//! | a first row and a first column that count 0, 1, 2, … around an empty corner | no heights: left out |
//! | two columns | a profile, if x only rises or only falls |
//! | three columns or more called x, z1, z2, … (or height, trace, profile) | traces of one surface at the same positions |
//!
//! Coordinates fix the pixel size: (last − first) / (N − 1). Coordinates that are evenly spaced
//! as far as their printed digits can tell count as evenly spaced.
//!
//! A matrix without a stated size needs the pixel size, columns without units need theirs.

use super::scattered::{self, Line};
use crate::cells::Digits;
use crate::header::{Header, Title};
use crate::measurement::{Channel, Contents, Pixel};
use crate::text::{self, Table};
use crate::units::metres_per;
use crate::{Ambiguity, Format, Layout, Limits, ReadError};

const FORMAT: Format = Format::Text;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    text::is_text(bytes)
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    parse_as(bytes, limits, None)
}

/// Reads in the layout asked for, or in the one that header and columns say.
pub(crate) fn parse_as<'a>(
    bytes: &'a [u8],
    limits: &Limits,
    layout: Option<Layout>,
) -> Result<Contents<'a>, ReadError> {
    let text = text::decode(bytes);
    let mut table = Table::parse(&text, FORMAT)?;
    limits.check_points(FORMAT, [table.values.len(), 1])?;
    limits.check_items(FORMAT, table.header.len() as u64)?;
    let mut header = Header::parse(&table);
    let (columns, rows) = (table.columns, table.rows());
    if rows == 0 {
        let start: String = text.trim_start().chars().take(24).collect();
        return Err(ReadError::UnknownFormat { start });
    }
    let mut values = std::mem::take(&mut table.values);
    let mut digits = table.digits;
    let mut kept = columns;
    let mut titles = header.columns.clone();
    // A running number in front is no coordinate.
    if columns > 2 && header.columns.first().is_some_and(|c| is_index(&c.name)) {
        let mut index = 0;
        values.retain(|_| {
            index += 1;
            index % columns != 1
        });
        kept -= 1;
        titles.remove(0);
        digits = [digits[1], digits[2], digits[2]];
    }
    let mut rows = rows;
    if drop_running_numbers(&mut values, kept) {
        (rows, kept) = (rows - 1, kept - 1);
        header.metadata.insert("left out".into(), "running numbers of rows and columns".into());
    }
    if let Some(half) = header.rows_before_mask.filter(|&half| rows == 2 * half) {
        let mask = values.split_off(half * kept);
        for (value, _) in values.iter_mut().zip(mask).filter(|(_, is_there)| *is_there == 0.0) {
            *value = f64::NAN;
        }
        rows = half;
    }
    let unit = |column: usize| titles.get(column).and_then(|c| c.unit.clone());
    let named = |column: usize, names: &[&str]| {
        titles.get(column).is_some_and(|c| names.iter().any(|n| c.name.eq_ignore_ascii_case(n)))
    };

    if layout == Some(Layout::Traces) || (layout.is_none() && are_traces(&titles, kept)) {
        let channels = traces(&values, kept, digits[0], &titles, &header)?;
        return Ok(Contents { channels, metadata: header.metadata });
    }
    let says_map = kept > 3 || header.size.is_some() || header.pixel.is_some();
    let is_map = layout.map_or(says_map, |layout| layout == Layout::Matrix);
    if layout == Some(Layout::List) && kept > 3 {
        return Err(ReadError::BadLayout {
            format: FORMAT,
            layout: Layout::List,
            reason: format!("it has {kept} columns (a list has x y z or x z)").into(),
        });
    }
    let channel = if is_map {
        matrix(&header, values, [rows, kept])
    } else if kept == 3 && named(2, &["valid"]) {
        let (x, mut z) = (column(&values, 0, 3), column(&values, 1, 3));
        for (z, row) in z.iter_mut().zip(values.chunks_exact(3)) {
            if row[2] == 0.0 {
                *z = f64::NAN;
            }
        }
        profile(&x, z, digits[0], [unit(0), unit(1)], &header)?
    } else if kept == 3 {
        // Coordinates have units, or are called so; other columns may be heights.
        let is_told = layout.is_some()
            || unit(0).is_some()
            || header.lateral_unit.is_some()
            || ["x", "y"].iter().enumerate().all(|(i, name)| named(i, &[name]));
        let map = scattered::grid(&values, [digits[0], digits[1]], limits)
            .map_err(|error| if is_told { error } else { or_matrix(error, 3) })?;
        let is_plain = map.is_complete && map.shape.iter().all(|&n| n > 2);
        let z_unit = header.value_unit.clone().or_else(|| unit(2));
        let scale = unit(0).or(header.lateral_unit.clone()).as_deref().and_then(metres_per);
        let scale_y = unit(1).as_deref().and_then(metres_per).or(scale);
        let pixel = match (scale, scale_y) {
            (Some(x), Some(y)) => Pixel::Metres([map.step[0] * y, map.step[1] * x]),
            _ => Pixel::Steps(map.step),
        };
        let heights = map.heights;
        let name = header.name();
        let mut channel =
            Channel::new(name, z_unit.as_deref(), map.shape, pixel, move || Ok(heights));
        channel.ambiguity = (!is_told && !is_plain).then_some(Ambiguity { columns: 3 });
        channel
    } else if kept == 2 {
        let (x, z) = (column(&values, 0, 2), column(&values, 1, 2));
        let is_told = layout.is_some() || unit(0).is_some() || named(0, &["x"]);
        let mut channel = profile(&x, z, digits[0], [unit(0), unit(1)], &header)
            .map_err(|error| if is_told { error } else { or_matrix(error, 2) })?;
        channel.ambiguity = (!is_told).then_some(Ambiguity { columns: 2 });
        channel
    } else {
        let feature = "a single column of numbers (a profile needs a column x before the heights, \
                       a map needs rows)";
        return Err(or_matrix(
            ReadError::Unsupported { format: FORMAT, feature: feature.into() },
            1,
        ));
    };
    Ok(Contents { channels: vec![channel], metadata: header.metadata })
}

/// A refusal of columns that may be heights.
fn or_matrix(error: ReadError, columns: usize) -> ReadError {
    match error {
        ReadError::Unsupported { .. } | ReadError::Malformed { .. } => {
            ReadError::Ambiguous { source: Box::new(error), ambiguity: Ambiguity { columns } }
        }
        other => other,
    }
}

/// Takes away a first row and a first column that only count 0, 1, 2, ... around an empty corner,
/// as table programs write them.
fn drop_running_numbers(values: &mut Vec<f64>, columns: usize) -> bool {
    let counts = |numbers: &mut dyn Iterator<Item = &f64>| {
        numbers.enumerate().all(|(i, number)| number.to_bits() == (i as f64).to_bits())
    };
    let is_framed = columns > 3
        && values.len() > 2 * columns
        && values[0].is_nan()
        && counts(&mut values[1..columns].iter())
        && counts(&mut values[columns..].iter().step_by(columns));
    if is_framed {
        let mut index = 0;
        values.retain(|_| {
            index += 1;
            index > columns && (index - 1) % columns != 0
        });
    }
    is_framed
}

/// True if the titles say that traces stand beside one column of positions.
fn are_traces(titles: &[Title], columns: usize) -> bool {
    const POSITIONS: [&str; 7] = ["x", "position", "pos", "pos.", "distance", "length", "weg"];
    const HEIGHTS: [&str; 5] = ["z", "height", "trace", "profile", "höhe"];
    let name = |i: usize| titles.get(i).map(|t| t.name.to_lowercase()).unwrap_or_default();
    columns > 2
        && POSITIONS.contains(&name(0).as_str())
        && (1..columns).all(|i| HEIGHTS.iter().any(|height| name(i).starts_with(height)))
}

/// One channel for every column behind the first, which has the positions.
fn traces(
    values: &[f64],
    columns: usize,
    digits: Digits,
    titles: &[Title],
    header: &Header,
) -> Result<Vec<Channel<'static>>, ReadError> {
    if columns < 2 {
        return Err(ReadError::BadLayout {
            format: FORMAT,
            layout: Layout::Traces,
            reason: "it has one column (traces need positions before the heights)".into(),
        });
    }
    let unit = |i: usize| titles.get(i).and_then(|t| t.unit.clone());
    let name = |i: usize| titles.get(i).map_or("", |t| t.name.as_str());
    let are_named = (1..columns).all(|i| !name(i).is_empty() && (1..i).all(|j| name(i) != name(j)));
    let x = column(values, 0, columns);
    let trace = |i: usize| -> Result<Channel<'static>, ReadError> {
        let z = column(values, i, columns);
        let mut channel = profile(&x, z, digits, [unit(0), unit(i).or(unit(1))], header)?;
        channel.name = if are_named { name(i).to_owned() } else { format!("trace {i}") };
        channel.is_trace = columns > 2;
        Ok(channel)
    };
    (1..columns).map(trace).collect()
}

fn is_index(name: &str) -> bool {
    ["index", "no", "no.", "nr", "n", "i", "point"].iter().any(|n| name.eq_ignore_ascii_case(n))
}

fn column(values: &[f64], column: usize, columns: usize) -> Vec<f64> {
    values.iter().skip(column).step_by(columns).copied().collect()
}

fn matrix(header: &Header, values: Vec<f64>, shape: [usize; 2]) -> Channel<'static> {
    let pixel = match (header.pixel, header.size) {
        (Some(pixel), _) => Pixel::Metres(pixel),
        // Gwyddion's Width and Height are N pixels, not N - 1 intervals.
        (None, Some([height, width])) => {
            Pixel::Metres([height / shape[0] as f64, width / shape[1] as f64])
        }
        (None, None) => Pixel::Unknown,
    };
    let missing = header.missing_value;
    let [factor, offset] = header.value_line.unwrap_or([1.0, 0.0]);
    let unit = header.value_unit.as_deref();
    let mut channel = Channel::new(header.name(), unit, shape, pixel, move || {
        let mut values = values;
        for value in &mut values {
            let is_missing = missing.is_some_and(|mark| value.to_bits() == mark.to_bits());
            *value = if is_missing { f64::NAN } else { *value * factor + offset };
        }
        Ok(values)
    });
    if let Some(scale) = header.value_scale.filter(|_| channel.unit.is_none()) {
        channel.scale = Some(scale);
        channel.unit = Some(format!("{scale:e} m"));
    }
    channel
}

fn profile(
    x: &[f64],
    z: Vec<f64>,
    digits: Digits,
    [x_unit, z_unit]: [Option<String>; 2],
    header: &Header,
) -> Result<Channel<'static>, ReadError> {
    let line = Line::new(x, digits).map_err(|what| ReadError::Malformed {
        format: FORMAT,
        place: crate::Place::Field("column 1".into()),
        what: what.into(),
    })?;
    let z_unit = header.value_unit.clone().or(z_unit);
    let x_unit = x_unit.or(header.lateral_unit.clone());
    Ok(line.profile(header.name(), z_unit.as_deref(), x_unit.as_deref(), move || Ok(z)))
}
