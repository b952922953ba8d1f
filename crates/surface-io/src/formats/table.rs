//! Text with numbers: a matrix of heights, a list of x y z, or a profile x z.
//!
//! | what | recognised by |
//! |---|---|
//! | separators | semicolon, tab, comma, blanks; none inside quotation marks |
//! | missing points | empty cells, `NaN`, `1.#QNAN`, `No Data`, `---`, 3.402823e38, and marks that are given |
//! | decimal mark, thousands | by their pattern; what can be either is refused |
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
//! | a header between rows | begins another table, of channels of its own |
//! | three columns and more | x y z on a grid in any order (row 0 = smallest y), by titles or numbers; further columns are channels |
//! | a first row and a first column of coordinates or running numbers around an empty corner | no heights: left out |
//! | two columns | a profile, if x only rises or only falls |
//! | three columns or more called x, z1, z2, … (or height, trace, profile) | traces of one surface at the same positions |
//!
//! Coordinates fix the pixel size: (last − first) / (N − 1). Coordinates that are evenly spaced
//! as far as their printed digits can tell count as evenly spaced.
//!
//! A matrix without a stated size needs the pixel size, columns without units need theirs.

mod columns;

use self::columns::{INDEX, two_readings};
use super::scattered::{self, GriddedMap, Line};
use crate::binary::Bytes;
use crate::error::TEXT;
use crate::header::{HEIGHTS, Header};
use crate::meaning::Meaning;
use crate::measurement::{Channel, Contents, Pixel};
use crate::text::{self, NumberTable, NumberedLines, Title, is_monotone};
use crate::units::metres_per;
use crate::{Ambiguity, Layout, Need, ReadError, ReadOptions};

/// Reads in the layout asked for, or in the one that header and columns say.
pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let (text, options) = (text::decode(b.data), b.options);
    let begins = |lines: &NumberedLines<'_>| {
        Header::parse(&NumberTable::empty(lines.clone())).says_channel()
    };
    let tables = NumberTable::all(&text, options, &begins)?;
    let several = tables.len() > 1;
    let mut contents = Contents::default();
    for (number, table) in tables.into_iter().enumerate() {
        b.check_points([table.values.len(), 1])?;
        b.check_items(table.header.len() as u64)?;
        if table.rows() == 0 {
            let start: String = text.trim_start().chars().take(24).collect();
            let obstacle = table.obstacle(options);
            return Err(obstacle.unwrap_or(ReadError::UnknownFormat(start)));
        }
        let mut header = Header::parse(&table);
        if several && header.channel.is_none() {
            header.channel = Some(format!("table {}", number + 1));
        }
        let channels = channels(table, &mut header, options)?;
        // With a factor the mark is of the numbers before it.
        let mark = header.missing_value.filter(|_| header.value_line.is_none());
        contents.channels.extend(channels.into_iter().map(|channel| channel.without(mark)));
        for (key, value) in header.metadata {
            contents.metadata.entry(key).or_insert(value);
        }
    }
    Ok(contents)
}

const MATRIX: Need = Need::Layout(Layout::Matrix);
const COLUMN: Ambiguity =
    Ambiguity { what: "one column, read as the heights of a profile", needs: &[MATRIX] };
const PROFILE: Ambiguity = Ambiguity {
    what: "two columns, read as a profile x z; they could as well be heights",
    needs: &[MATRIX],
};
const LIST: Ambiguity = Ambiguity {
    what: "three columns, read as a list x y z; they could as well be heights",
    needs: &[MATRIX],
};
const LIST_OR_TRACES: Ambiguity = Ambiguity {
    what: "three columns, read as a list x y z; they could as well be positions and the heights of two traces, or heights",
    needs: &[Need::Layout(Layout::Traces), MATRIX],
};

fn channels(
    mut table: NumberTable<'_>,
    header: &mut Header,
    options: &ReadOptions,
) -> Result<Vec<Channel<'static>>, ReadError> {
    let layout = options.layout;
    table.name_columns(std::mem::take(&mut header.columns));
    table.leave_out_invalid()?;
    let are_traces =
        layout == Some(Layout::Traces) || layout.is_none() && are_traces(&table.titles);
    let has_index = table.columns > 2 && table.is_called(0, &INDEX)
        || !matches!(layout, Some(Layout::Matrix | Layout::Traces))
            && table.has_index(&options.limits);
    if has_index {
        let others: Vec<usize> = (1..table.columns).collect();
        table = table.pick(&others);
        header.metadata.insert("left out".into(), "running numbers of the points".into());
    }
    let order = table.order().filter(|_| !are_traces && layout != Some(Layout::Matrix));
    // A size or a spacing says that these are heights, unless the columns are coordinates.
    let is_sized = header.size.is_some() || header.pixel.is_some() && table.columns > 1;
    let says_map = is_sized
        && order.is_none()
        && !table.is_called(0, &POSITIONS)
        && !(table.columns == 3 && table.grid(&options.limits).is_ok_and(|map| map.is_plain()));
    let is_list = layout == Some(Layout::List) || layout.is_none() && !are_traces && !says_map;
    if let Some(order) = &order {
        table = table.pick(order);
    }
    // Coordinates have units, or are called so; other columns may be heights.
    let is_told = layout.is_some()
        || table.unit(0).is_some()
        || header.lateral_unit.is_some()
        || order.is_some();
    let map = match table.columns {
        _ if are_traces => return traces(&table, header),
        1 if is_sized && table.rows() > 1 && layout.is_none() => {
            let what = "one column, and the header states the size of a map, not its rows: save it in rows";
            return Err(two_readings(what.into(), &[]));
        }
        _ if !is_list => None,
        1 if layout.is_some() => {
            return Err(bad_layout(Layout::List, "it has one column (a list has x y z or x z)"));
        }
        1 => return column(table, header),
        2 => {
            let is_told = is_told || table.is_called(0, &POSITIONS);
            let mut channel = positions(&table)
                .map(|line| profile(&table, header, line, 1))
                .map_err(|e| if is_told { e } else { or_matrix(e, PROFILE) })?;
            channel.ambiguity = (!is_told).then_some(PROFILE);
            return Ok(vec![channel]);
        }
        3 => Some(table.grid(&options.limits).map_err(|error| {
            let others = match (order.is_some(), is_monotone(&table.column(0))) {
                (false, true) if layout.is_none() => Some(LIST_OR_TRACES),
                _ => (!is_told).then_some(LIST),
            };
            others.into_iter().fold(error, or_matrix)
        })?),
        _ if order.is_some() || layout.is_some() => Some(table.grid(&options.limits)?),
        _ => {
            // All points, or many of them.
            let is_sure = |map: &GriddedMap| map.is_plain() || map.is_wide() && table.rows() > 19;
            table.grid(&options.limits).ok().filter(is_sure)
        }
    };
    if let Some(map) = map {
        check_rows(header, map.shape)?;
        let is_plain = is_told || map.is_plain();
        return Ok(list(map, &table, header, (!is_plain).then_some(LIST)));
    }
    check_rows(header, [table.rows(), table.columns])?;
    table.leave_out_axes(header, layout)?;
    table.apply_mask(header);
    if layout.is_none() {
        table.refuse_positions()?;
    }
    maps(table, header, options)
}

/// Refuses a map that has not the rows that the header says.
fn check_rows(header: &Header, [found, across]: [usize; 2]) -> Result<(), ReadError> {
    let [Some(rows), Some(columns)] = header.counts() else { return Ok(()) };
    if across == columns && found < rows {
        let what = format!(
            "the header says {rows} rows of {columns} numbers, {found} are there: the file was cut off. To read \
             these, change the number of rows in the header to {found}"
        );
        return Err(ReadError::at(TEXT, "rows", what));
    }
    if across != columns && found.checked_mul(across) == rows.checked_mul(columns) {
        let what = format!(
            "{found} rows of {across} numbers, and the header says {rows} rows of {columns}: whether rows or columns \
             follow each other is not said; save it in {rows} rows, or mend the header"
        );
        return Err(two_readings(what, &[]));
    }
    Ok(())
}

/// The heights of a profile.
fn column(table: NumberTable<'_>, header: &Header) -> Result<Vec<Channel<'static>>, ReadError> {
    check_rows(header, [table.rows(), 1])?;
    let pixel = header.pixel.map_or(Pixel::Unknown, Pixel::Metres);
    let unit = header.value_unit.clone().or(table.unit(0));
    let shape = [1, table.rows()];
    let decode = move || Ok(table.values);
    let mut channel = Channel::new(header.name(), unit.as_deref(), shape, pixel, decode);
    channel.ambiguity = Some(COLUMN);
    Ok(vec![channel])
}

fn bad_layout(layout: Layout, reason: &'static str) -> ReadError {
    ReadError::BadLayout { format: TEXT, layout, reason }
}

/// A refusal of columns that may be something else.
fn or_matrix(error: ReadError, ambiguity: Ambiguity) -> ReadError {
    let what = match error {
        ReadError::Unsupported { feature, .. } => format!("{feature} is not supported"),
        ReadError::Malformed { place, what, .. } => format!("{place}: {what}"),
        other => return other,
    };
    let what = format!("{what} ({})", ambiguity.what);
    ReadError::Ambiguous { what, needs: ambiguity.needs.to_vec() }
}

/// Titles of columns with positions along a line.
const POSITIONS: [&str; 7] = ["x", "position", "pos", "pos.", "distance", "length", "weg"];

/// True if the titles say that traces stand beside one column of positions.
fn are_traces(titles: &[Title]) -> bool {
    let name = |i: usize| titles[i].name.to_lowercase();
    titles.len() > 2
        && POSITIONS.contains(&name(0).as_str())
        && (1..titles.len()).all(|i| HEIGHTS.iter().any(|height| name(i).starts_with(height)))
}

/// One channel for every column behind the first, which has the positions.
fn traces(table: &NumberTable<'_>, header: &Header) -> Result<Vec<Channel<'static>>, ReadError> {
    let columns = table.columns;
    if columns < 2 {
        let reason = "it has one column (traces need positions before the heights)";
        return Err(bad_layout(Layout::Traces, reason));
    }
    let name = |i: usize| table.titles[i].name.as_str();
    let are_named = (1..columns).all(|i| !name(i).is_empty() && (1..i).all(|j| name(i) != name(j)));
    let line = positions(table)?;
    let trace = |i: usize| {
        let mut channel = profile(table, header, line.clone(), i);
        channel.info.name = if are_named { name(i).to_owned() } else { format!("trace {i}") };
        channel.info.is_trace = columns > 2;
        channel
    };
    Ok((1..columns).map(trace).collect())
}

/// One channel for z, and one for every column behind it.
fn list(
    map: GriddedMap,
    table: &NumberTable<'_>,
    header: &Header,
    ambiguity: Option<Ambiguity>,
) -> Vec<Channel<'static>> {
    let unit = table.unit(0).or(header.lateral_unit.clone());
    let scale = unit.as_deref().and_then(metres_per);
    let scale_y = table.unit(1).as_deref().and_then(metres_per).or(scale);
    let pixel = Pixel::scaled(map.step, [scale_y, scale]);
    let shape = map.shape;
    let channel = |(i, heights): (usize, Vec<f64>)| {
        let title = &table.titles[i + 2];
        let (name, unit) = match (i, title.name.is_empty()) {
            (0, _) => (header.name(), header.value_unit.as_ref().or(title.unit.as_ref())),
            (_, false) => (title.name.clone(), title.unit.as_ref()),
            (_, true) => (format!("column {}", i + 3), title.unit.as_ref()),
        };
        let mut channel =
            Channel::new(name, unit.map(String::as_str), shape, pixel, move || Ok(heights));
        channel.ambiguity = ambiguity.filter(|_| i == 0);
        // Without a unit it is as likely an intensity.
        channel.info.is_height = match Meaning::of(&title.name) {
            Meaning::Other => false,
            _ => i == 0 && channel.info.is_height || channel.scale.is_some(),
        };
        channel
    };
    map.heights.into_iter().enumerate().map(channel).collect()
}

/// A map, or several of equally many rows with blank lines or comments between them.
fn maps(
    mut table: NumberTable<'_>,
    header: &Header,
    options: &ReadOptions,
) -> Result<Vec<Channel<'static>>, ReadError> {
    let (rows, columns, parted) = (table.rows(), table.columns, &table.parted);
    let each = parted.first().copied().unwrap_or(rows);
    let is_even = each > 1
        && columns > 3
        && parted.len() + 1 == rows / each
        && rows.is_multiple_of(each)
        && parted.iter().enumerate().all(|(i, row)| *row == (i + 1) * each);
    if !is_even || parted.is_empty() || options.layout.is_some() {
        let values = std::mem::take(&mut table.values);
        return Ok(vec![matrix(&table, header, values)]);
    }
    if options.channel.is_none() {
        let what = format!(
            "{} tables of {each} x {columns} numbers with blank lines or comments between them: several maps, or \
             one of {rows} rows",
            parted.len() + 1
        );
        return Err(ReadError::Ambiguous { what, needs: vec![Need::Channel, MATRIX] });
    }
    let parts = table.values.chunks_exact(each * columns).enumerate();
    Ok(parts
        .map(|(i, part)| {
            let mut channel = matrix(&table, header, part.to_vec());
            channel.info.name = format!("table {}", i + 1);
            channel
        })
        .collect())
}

fn matrix(table: &NumberTable<'_>, header: &Header, values: Vec<f64>) -> Channel<'static> {
    let shape = [values.len() / table.columns, table.columns];
    let pixel = match (header.pixel, header.size, header.steps) {
        (Some(pixel), ..) => Pixel::Metres(pixel),
        // Gwyddion's Width and Height are N pixels, not N - 1 intervals.
        (None, Some([height, width]), _) => {
            Pixel::Metres([height / shape[0] as f64, width / shape[1] as f64])
        }
        (None, None, Some(steps)) => Pixel::Steps(steps),
        (None, None, None) => Pixel::Unknown,
    };
    let of_cells =
        table.unit(0).filter(|_| (1..table.columns).all(|i| table.unit(i) == table.unit(0)));
    let unit = header.value_unit.clone().or(of_cells);
    let decode = move || Ok(values);
    let mut channel = Channel::new(header.name(), unit.as_deref(), shape, pixel, decode);
    if let Some([factor, offset]) = header.value_line {
        let convert = move |value| value * factor + offset;
        channel = channel.without(header.missing_value).converted(convert);
    }
    if let Some(scale) = header.value_scale.filter(|_| channel.info.unit.is_none()) {
        channel.scale = Some(scale);
        channel.info.unit = Some(format!("{scale:e} m"));
    }
    channel
}

/// Those in the first column.
fn positions(table: &NumberTable<'_>) -> Result<Line, ReadError> {
    let line = Line::new(&table.column(0), table.digits[0]);
    line.map_err(|what| ReadError::at(TEXT, "column 1", what))
}

/// The heights in a column at these positions.
fn profile(
    table: &NumberTable<'_>,
    header: &Header,
    line: Line,
    column: usize,
) -> Channel<'static> {
    let unit = header.value_unit.clone().or(table.unit(column)).or(table.unit(1));
    let x_unit = table.unit(0).or(header.lateral_unit.clone());
    let (z, positions) = (table.column(column), Some((line, x_unit.as_deref())));
    scattered::profile(header.name(), unit.as_deref(), z.len(), positions, move || Ok(z))
}
