//! Text with numbers: a matrix of heights, a list of x y z, or a profile x z.
//!
//! | what | recognised by |
//! |---|---|
//! | separators | semicolon, tab, comma, blanks; none inside quotation marks |
//! | missing points | empty cells, `NaN`, `1.#QNAN`, `No Data`, `---`, and marks that are given |
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

use super::scattered::{self, Line};
use crate::binary::Bytes;
use crate::cells::{Digits, Written};
use crate::header::{Header, Title};
use crate::measurement::{Channel, Contents, Pixel};
use crate::text::{self, Lines, Table, is_monotone};
use crate::units::metres_per;
use crate::{Ambiguity, Format, Layout, Limits, Need, ReadError, ReadOptions};

const FORMAT: Format = Format::Text;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    text::is_text(bytes)
}

pub(crate) fn parse<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Contents<'a>, ReadError> {
    parse_as(bytes, &ReadOptions::default().with_limits(*limits))
}

/// Reads in the layout asked for, or in the one that header and columns say.
pub(crate) fn parse_as<'a>(
    bytes: &'a [u8],
    options: &ReadOptions,
) -> Result<Contents<'a>, ReadError> {
    let text = text::decode(bytes);
    let written = Written { decimal: options.decimal, missing: &options.missing };
    let begins = |lines: &Lines<'_>| Header::parse(&Table::empty(lines.clone())).says_channel();
    let tables = Table::all(&text, FORMAT, written, &begins)?;
    let several = tables.len() > 1;
    let mut contents = Contents::default();
    for (number, table) in tables.into_iter().enumerate() {
        options.limits.check_points(FORMAT, [table.values.len(), 1])?;
        options.limits.check_items(FORMAT, table.header.len() as u64)?;
        if table.rows() == 0 {
            let start: String = text.trim_start().chars().take(24).collect();
            let obstacle = table.obstacle(FORMAT, written);
            return Err(obstacle.unwrap_or(ReadError::UnknownFormat { start }));
        }
        let mut header = Header::parse(&table);
        if several && header.channel.is_none() {
            header.channel = Some(format!("table {}", number + 1));
        }
        let mut channels = channels(table, &mut header, options)?;
        if let (Some(mark), None) = (header.missing_value, header.value_line) {
            channels = channels.into_iter().map(|channel| without(channel, mark)).collect();
        }
        contents.channels.append(&mut channels);
        for (key, value) in header.metadata {
            contents.metadata.entry(key).or_insert(value);
        }
    }
    Ok(contents)
}

/// The channel with every height of this value missing.
fn without(channel: Channel<'_>, mark: f64) -> Channel<'_> {
    let decode = channel.decode;
    let decode = move || {
        let mut heights = decode()?;
        heights.iter_mut().filter(|z| **z == mark).for_each(|z| *z = f64::NAN);
        Ok(heights)
    };
    Channel { decode: Box::new(decode), ..channel }
}

/// What the columns of a table are taken for.
enum Reading {
    Matrix,
    /// x y z and further columns, put on a grid already.
    List(scattered::Map),
    Profile,
    Traces,
    Column,
}

/// What one table holds.
fn channels(
    mut table: Table<'_>,
    header: &mut Header,
    options: &ReadOptions,
) -> Result<Vec<Channel<'static>>, ReadError> {
    let layout = options.layout;
    let mut sheet = Sheet::of(&mut table, header);
    sheet.leave_out_invalid()?;
    let are_traces =
        layout == Some(Layout::Traces) || layout.is_none() && are_traces(&sheet.titles);
    let says_map = header.size.is_some() || header.pixel.is_some() && sheet.columns > 1;
    let is_list = layout == Some(Layout::List) || layout.is_none() && !are_traces && !says_map;
    let has_index = sheet.columns > 2 && sheet.is_called(0, &INDEX)
        || !matches!(layout, Some(Layout::Matrix | Layout::Traces))
            && !says_map
            && sheet.has_index(&options.limits);
    if has_index {
        let others: Vec<usize> = (1..sheet.columns).collect();
        sheet = sheet.pick(&others);
        header.metadata.insert("left out".into(), "running numbers of the points".into());
    }
    let order = sheet.order().filter(|_| is_list);
    if let Some(order) = &order {
        sheet = sheet.pick(order);
    }
    // Coordinates have units, or are called so; other columns may be heights.
    let is_told = layout.is_some()
        || sheet.unit(0).is_some()
        || header.lateral_unit.is_some()
        || order.is_some();
    let reading = match sheet.columns {
        _ if are_traces => Reading::Traces,
        _ if !is_list => Reading::Matrix,
        1 if layout.is_some() => {
            return Err(bad_layout(Layout::List, "it has one column (a list has x y z or x z)"));
        }
        1 => Reading::Column,
        2 => Reading::Profile,
        3 => Reading::List(sheet.grid(&options.limits).map_err(|error| {
            let others = match (order.is_some(), is_monotone(&sheet.column(0))) {
                (false, true) if layout.is_none() => Some(Ambiguity::ListOrTraces),
                _ => (!is_told).then_some(Ambiguity::List),
            };
            others.into_iter().fold(error, or_matrix)
        })?),
        _ if is_told && (order.is_some() || layout.is_some()) => {
            Reading::List(sheet.grid(&options.limits)?)
        }
        _ => match sheet.grid(&options.limits) {
            // Three points a side, all there, or many of them: not by chance.
            Ok(map) if map.is_wide() && (map.is_complete || sheet.rows() > 19) => {
                Reading::List(map)
            }
            _ => Reading::Matrix,
        },
    };
    refuse_other_counts(&reading, &sheet, header)?;
    match reading {
        Reading::Traces => traces(&sheet, header),
        Reading::List(map) => {
            let is_plain = is_told || map.is_complete && map.is_wide();
            Ok(list(map, &sheet, header, (!is_plain).then_some(Ambiguity::List)))
        }
        Reading::Matrix => {
            sheet.leave_out_axes(header, layout)?;
            sheet.apply_mask(header);
            if layout.is_none() && !says_map {
                sheet.refuse_positions()?;
            }
            maps(sheet, &table.parted, header, options)
        }
        Reading::Profile => {
            let is_told = is_told || sheet.is_called(0, &POSITIONS);
            let (x, z) = (sheet.column(0), sheet.column(1));
            let units = [sheet.unit(0), sheet.unit(1)];
            let mut channel = profile(&x, z, sheet.digits[0], units, header)
                .map_err(|e| if is_told { e } else { or_matrix(e, Ambiguity::Profile) })?;
            channel.ambiguity = (!is_told).then_some(Ambiguity::Profile);
            Ok(vec![channel])
        }
        Reading::Column => {
            let pixel = header.pixel.map_or(Pixel::Unknown, Pixel::Metres);
            let unit = header.value_unit.clone().or(sheet.unit(0));
            let (shape, z) = ([1, sheet.rows()], sheet.values);
            let mut channel =
                Channel::new(header.name(), unit.as_deref(), shape, pixel, move || Ok(z));
            channel.ambiguity = Some(Ambiguity::Column);
            Ok(vec![channel])
        }
    }
}

/// A header that declares other numbers of rows and columns: the file was cut off, or is no map in rows.
fn refuse_other_counts(reading: &Reading, sheet: &Sheet, header: &Header) -> Result<(), ReadError> {
    let [Some(rows), Some(columns)] = header.counts() else { return Ok(()) };
    let (found, wide) = (sheet.rows(), sheet.columns);
    match reading {
        Reading::Column if found == rows.saturating_mul(columns) => {
            let what = format!(
                "one column of {found} numbers, and the header says {rows} rows of {columns}: whether rows or columns \
                 follow each other is not said; save it in {rows} rows"
            );
            Err(two_readings(what, &[]))
        }
        Reading::Matrix if wide == columns && found < rows => {
            let what = format!(
                "the header says {rows} rows of {columns} numbers, {found} are there: the file was cut off. To read \
                 these, change the number of rows in the header to {found}"
            );
            Err(Bytes::little(&[], FORMAT).field("rows", what))
        }
        _ => Ok(()),
    }
}

fn bad_layout(layout: Layout, reason: &'static str) -> ReadError {
    ReadError::BadLayout { format: FORMAT, layout, reason: reason.into() }
}

/// A refusal of columns that may be something else.
fn or_matrix(error: ReadError, ambiguity: Ambiguity) -> ReadError {
    match error {
        ReadError::Unsupported { .. } | ReadError::Malformed { .. } => {
            ReadError::Ambiguous { source: Box::new(error), ambiguity }
        }
        other => other,
    }
}

fn two_readings(what: String, needs: &[Layout]) -> ReadError {
    let needs = needs.iter().copied().map(Need::Layout).collect();
    ReadError::TwoReadings { format: FORMAT, what, needs }
}

/// Titles of columns with running numbers.
const INDEX: [&str; 17] = [
    "index", "idx", "no", "no.", "nr", "nr.", "n", "i", "#", "id", "point", "pt", "number",
    "nummer", "count", "counter", "sample",
];
/// Titles of columns with positions along a line.
const POSITIONS: [&str; 7] = ["x", "position", "pos", "pos.", "distance", "length", "weg"];
/// Titles that begin those of heights.
const HEIGHTS: [&str; 5] = ["z", "height", "trace", "profile", "höhe"];

/// The columns of a table.
struct Sheet {
    /// Row-major, NaN where a cell is missing.
    values: Vec<f64>,
    columns: usize,
    titles: Vec<Title>,
    digits: [Digits; 4],
    /// Precision of the first row behind its first cell.
    first_row: Digits,
}

impl Sheet {
    /// Takes the numbers of `table`; units of its cells are those of its titles.
    fn of(table: &mut Table<'_>, header: &Header) -> Self {
        let mut titles = header.columns.clone();
        titles.resize(table.columns.max(titles.len()), Title { name: String::new(), unit: None });
        for (title, unit) in titles.iter_mut().zip(&table.units) {
            title.unit = title.unit.take().or_else(|| unit.clone());
        }
        Self {
            values: std::mem::take(&mut table.values),
            columns: table.columns,
            titles,
            digits: table.digits,
            first_row: table.first_row,
        }
    }

    /// Half of the rows may say with 0 which points of the other half are missing (SPIP).
    fn apply_mask(&mut self, header: &Header) {
        let rows = self.rows();
        if let Some(half) = header.rows_before_mask.filter(|&half| rows == 2 * half) {
            let mask = self.values.split_off(half * self.columns);
            for (z, _) in self.values.iter_mut().zip(mask).filter(|(_, is_there)| *is_there == 0.0)
            {
                *z = f64::NAN;
            }
        }
    }

    fn rows(&self) -> usize {
        self.values.len() / self.columns
    }

    fn column(&self, column: usize) -> Vec<f64> {
        self.values.iter().skip(column).step_by(self.columns).copied().collect()
    }

    fn unit(&self, column: usize) -> Option<String> {
        self.titles.get(column).and_then(|title| title.unit.clone())
    }

    fn is_called(&self, column: usize, names: &[&str]) -> bool {
        let is_one = |title: &Title| names.iter().any(|name| title.name.eq_ignore_ascii_case(name));
        self.titles.get(column).is_some_and(is_one)
    }

    /// The column of one of these names, if one only has it.
    fn called(&self, names: &[&str]) -> Option<usize> {
        let mut found = (0..self.columns).filter(|&column| self.is_called(column, names));
        found.next().filter(|_| found.next().is_none())
    }

    /// These columns in this order.
    fn pick(self, order: &[usize]) -> Self {
        if order.iter().copied().eq(0..self.columns) {
            return self;
        }
        let digits = |column: usize| self.digits.get(column).copied().unwrap_or(Digits::NONE);
        Self {
            values: self
                .values
                .chunks_exact(self.columns)
                .flat_map(|row| order.iter().map(|&column| row[column]))
                .collect(),
            columns: order.len(),
            titles: order.iter().map(|&column| self.titles[column].clone()).collect(),
            digits: std::array::from_fn(|i| order.get(i).map_or(Digits::NONE, |&c| digits(c))),
            first_row: self.first_row,
        }
    }

    /// x, y, z, then the others, if the titles say which x and y are.
    fn order(&self) -> Option<Vec<usize>> {
        let either = |name: &str, other: &[&str]| {
            self.called(&[name]).or_else(|| self.called(other)).filter(|_| self.columns > 2)
        };
        let x = either("x", &["col", "col.", "column", "spalte"])?;
        let y = either("y", &["row", "line", "zeile"])?;
        let others = || (0..self.columns).filter(move |&column| column != x && column != y);
        let is_height = |column: &usize| {
            let name = self.titles[*column].name.to_lowercase();
            HEIGHTS.iter().any(|height| name.starts_with(height))
        };
        let z = others().find(is_height).or_else(|| others().next())?;
        Some([x, y, z].into_iter().chain(others().filter(|&column| column != z)).collect())
    }

    /// A column that says which points are valid is no height.
    fn leave_out_invalid(&mut self) -> Result<(), ReadError> {
        if self.columns < 3 {
            return Ok(());
        }
        let valid = self.called(&["valid", "isvalid"]);
        let invalid = self.called(&["invalid", "masked", "outlier", "bad"]);
        if let Some(column) = self.called(&["mask"]) {
            let marks = self.column(column);
            if marks.iter().any(|m| *m == 0.0) && marks.iter().any(|m| *m != 0.0) {
                let what = format!(
                    "column {} is a mask, whose 1 may mark points that are valid or that are not: call it \
                     \"valid\" or \"invalid\" in its title",
                    column + 1
                );
                return Err(two_readings(what, &[]));
            }
        }
        let Some(column) = valid.or(invalid) else { return Ok(()) };
        let kept: Vec<usize> = (0..self.columns).filter(|&other| other != column).collect();
        let first = usize::from(self.is_called(kept[0], &INDEX));
        let coordinates = match (self.called(&["x"]), self.called(&["y"])) {
            (Some(x), Some(y)) if kept.len() > first + 2 => vec![x, y],
            _ => vec![kept[first.min(kept.len() - 1)]],
        };
        for row in self.values.chunks_exact_mut(self.columns) {
            if (row[column] == 0.0) == valid.is_some() {
                for &height in kept[first..].iter().filter(|column| !coordinates.contains(column)) {
                    row[height] = f64::NAN;
                }
            }
        }
        let all =
            Self { values: std::mem::take(&mut self.values), titles: self.titles.clone(), ..*self };
        *self = all.pick(&kept);
        Ok(())
    }

    /// True if the first of three columns or more counts the points that the others list.
    fn has_index(&self, limits: &Limits) -> bool {
        if self.columns < 3 || self.rows() < 3 || !runs(&self.column(0)) {
            return false;
        }
        if !self.titles[0].name.is_empty() {
            return false; // it would be called so
        }
        if self.columns == 3 {
            return Line::new(&self.column(1), self.digits[1])
                .is_ok_and(|line| line.uneven.is_none());
        }
        let values: Vec<f64> = self
            .values
            .chunks_exact(self.columns)
            .flat_map(|row| row[1..4].iter().copied())
            .collect();
        scattered::grid(&values, 3, [self.digits[1], self.digits[2]], limits)
            .is_ok_and(|map| map.is_wide() && map.is_complete)
    }

    fn grid(&self, limits: &Limits) -> Result<scattered::Map, ReadError> {
        scattered::grid(&self.values, self.columns, [self.digits[0], self.digits[1]], limits)
    }

    /// Takes away a first row and a first column of coordinates or running numbers: around a corner that is empty or
    /// holds no height, and a first row that counts.
    fn leave_out_axes(
        &mut self,
        header: &mut Header,
        layout: Option<Layout>,
    ) -> Result<(), ReadError> {
        let (rows, columns) = (self.rows(), self.columns);
        if columns < 4 || rows < 3 {
            return Ok(());
        }
        let top = self.values[1..columns].to_vec();
        let side = self.column(0).split_off(1);
        let corner = self.values[0];
        let is_empty = corner.is_nan();
        let lines = (Line::new(&top, self.first_row), Line::new(&side, self.digits[0]));
        // A plane rises everywhere.
        let is_plane = self.is_plane();
        let is_corner = is_empty
            || layout.is_none()
                && !is_plane
                && top.len() > 3
                && side.len() > 3
                && (corner == 0.0 || corner == top.len() as f64);
        if let (true, (Ok(x), Ok(y))) = (is_corner, &lines) {
            if x.uneven.is_some() || y.uneven.is_some() {
                if top.len() < 6 || side.len() < 6 {
                    return Ok(());
                }
                let what = "the first row and the first column rise like coordinates and are not evenly spaced: a map \
                            is to be put on an even grid first; all numbers can as well be heights";
                return Err(two_readings(what.into(), &[Layout::Matrix]));
            }
            let count = runs(&top) && runs(&side);
            if is_plane && !count {
                let what = "the first row and the first column rise evenly, and so do the others: coordinates of an \
                            even slope, to be deleted, or heights";
                return Err(two_readings(what.into(), &[Layout::Matrix]));
            }
            let mut heights: Vec<f64> = self.values[columns..]
                .chunks_exact(columns)
                .flat_map(|row| row[1..].iter().copied())
                .collect();
            if x.is_falling {
                heights.chunks_exact_mut(columns - 1).for_each(<[f64]>::reverse);
            }
            if y.is_falling {
                heights = heights.chunks_exact(columns - 1).rev().flatten().copied().collect();
            }
            self.values = heights;
            self.columns -= 1;
            header.steps = (!count).then_some([y.step, x.step]);
            let what = if count { "running numbers" } else { "coordinates" };
            header.metadata.insert("left out".into(), format!("{what} of rows and columns"));
            return Ok(());
        }
        let first = &self.values[..columns];
        if layout.is_some() || is_plane {
            return Ok(());
        }
        // Who states what a number means writes no row that counts.
        if header.value_unit.is_some() || header.value_scale.is_some() {
            return Ok(());
        }
        let rest = || self.values[columns..].iter().filter(|z| !z.is_nan());
        if runs(first) && (columns > 7 || rest().any(|z| z.fract() != 0.0)) {
            self.values.drain(..columns);
            header.metadata.insert("left out".into(), "running numbers of the columns".into());
            return Ok(());
        }
        if columns > 7 && Line::new(first, self.first_row).is_ok_and(|line| line.uneven.is_none())
            || runs(first)
        {
            let what = format!(
                "the first row rises evenly from {} to {}: coordinates or running numbers, to be deleted, or heights",
                first[0],
                first[columns - 1]
            );
            return Err(two_readings(what, &[Layout::Matrix]));
        }
        Ok(())
    }

    /// True if most rows or most columns rise or fall, without the first.
    fn is_plane(&self) -> bool {
        let rises = |line: &mut dyn Iterator<Item = f64>| {
            let there: Vec<f64> = line.filter(|z| !z.is_nan()).collect();
            there.len() > 2 && is_monotone(&there)
        };
        let rows = self.values.chunks_exact(self.columns).skip(1);
        let most = self.rows() / 2;
        let rising = rows.filter(|row| rises(&mut row[1..].iter().copied())).count();
        let columns = (1..self.columns).filter(|&column| {
            rises(
                &mut self.values.iter().skip(self.columns + column).step_by(self.columns).copied(),
            )
        });
        rising > most || columns.count() > self.columns / 2
    }

    /// A first column that rises or falls from row to row, and no other does, may be positions of traces.
    fn refuse_positions(&self) -> Result<(), ReadError> {
        if self.columns < 4 || self.rows() < 4 {
            return Ok(());
        }
        let x = self.column(0);
        let Ok(line) = Line::new(&x, self.digits[0]) else { return Ok(()) };
        let others = 1..self.columns;
        if line.uneven.is_some() && x.len() < 8
            || others.into_iter().any(|other| is_monotone(&self.column(other)))
        {
            return Ok(());
        }
        let what = format!(
            "the first of {} columns {} from {} to {}: positions or running numbers, and the others heights of \
             traces, or all are heights of a map",
            self.columns,
            if line.is_falling { "falls" } else { "rises" },
            x[0],
            x[x.len() - 1]
        );
        Err(two_readings(what, &[Layout::Traces, Layout::Matrix]))
    }
}

/// True if the numbers count 0, 1, 2, … or 1, 2, 3, …
fn runs(numbers: &[f64]) -> bool {
    let first = numbers.first().copied().unwrap_or(f64::NAN);
    (first == 0.0 || first == 1.0)
        && numbers.len() > 2
        && numbers.iter().enumerate().all(|(i, number)| *number == first + i as f64)
}

/// True if the titles say that traces stand beside one column of positions.
fn are_traces(titles: &[Title]) -> bool {
    let name = |i: usize| titles[i].name.to_lowercase();
    titles.len() > 2
        && POSITIONS.contains(&name(0).as_str())
        && (1..titles.len()).all(|i| HEIGHTS.iter().any(|height| name(i).starts_with(height)))
}

/// One channel for every column behind the first, which has the positions.
fn traces(sheet: &Sheet, header: &Header) -> Result<Vec<Channel<'static>>, ReadError> {
    let columns = sheet.columns;
    if columns < 2 {
        let reason = "it has one column (traces need positions before the heights)";
        return Err(bad_layout(Layout::Traces, reason));
    }
    let name = |i: usize| sheet.titles[i].name.as_str();
    let are_named = (1..columns).all(|i| !name(i).is_empty() && (1..i).all(|j| name(i) != name(j)));
    let x = sheet.column(0);
    let trace = |i: usize| -> Result<Channel<'static>, ReadError> {
        let units = [sheet.unit(0), sheet.unit(i).or(sheet.unit(1))];
        let mut channel = profile(&x, sheet.column(i), sheet.digits[0], units, header)?;
        channel.name = if are_named { name(i).to_owned() } else { format!("trace {i}") };
        channel.is_trace = columns > 2;
        Ok(channel)
    };
    (1..columns).map(trace).collect()
}

/// One channel for z, and one for every column behind it.
fn list(
    map: scattered::Map,
    sheet: &Sheet,
    header: &Header,
    ambiguity: Option<Ambiguity>,
) -> Vec<Channel<'static>> {
    let unit = sheet.unit(0).or(header.lateral_unit.clone());
    let scale = unit.as_deref().and_then(metres_per);
    let scale_y = sheet.unit(1).as_deref().and_then(metres_per).or(scale);
    let pixel = match (scale, scale_y) {
        (Some(x), Some(y)) => Pixel::Metres([map.step[0] * y, map.step[1] * x]),
        _ => Pixel::Steps(map.step),
    };
    let shape = map.shape;
    let channel = |(i, heights): (usize, Vec<f64>)| {
        let title = &sheet.titles[i + 2];
        let (name, unit) = match (i, title.name.is_empty()) {
            (0, _) => (header.name(), header.value_unit.as_ref().or(title.unit.as_ref())),
            (_, false) => (title.name.clone(), title.unit.as_ref()),
            (_, true) => (format!("column {}", i + 3), title.unit.as_ref()),
        };
        let mut channel =
            Channel::new(name, unit.map(String::as_str), shape, pixel, move || Ok(heights));
        channel.ambiguity = ambiguity.filter(|_| i == 0);
        // Without a unit it is as likely an intensity.
        channel.is_height = i == 0 && channel.is_height || channel.scale.is_some();
        channel
    };
    map.heights.into_iter().enumerate().map(channel).collect()
}

/// A map, or several of equally many rows with blank lines or comments between them.
fn maps(
    mut sheet: Sheet,
    parted: &[usize],
    header: &Header,
    options: &ReadOptions,
) -> Result<Vec<Channel<'static>>, ReadError> {
    let (rows, columns) = (sheet.rows(), sheet.columns);
    let each = parted.first().copied().unwrap_or(rows);
    let is_even = each > 1
        && columns > 3
        && parted.len() + 1 == rows / each
        && rows.is_multiple_of(each)
        && parted.iter().enumerate().all(|(i, row)| *row == (i + 1) * each);
    if !is_even || parted.is_empty() || options.layout.is_some() {
        let values = std::mem::take(&mut sheet.values);
        return Ok(vec![matrix(&sheet, header, values)]);
    }
    if options.channel.is_none() {
        let what = format!(
            "{} tables of {each} x {columns} numbers with blank lines or comments between them: several maps, or \
             one of {rows} rows",
            parted.len() + 1
        );
        let needs = vec![Need::Channel, Need::Layout(Layout::Matrix)];
        return Err(ReadError::TwoReadings { format: FORMAT, what, needs });
    }
    let parts = sheet.values.chunks_exact(each * columns).enumerate();
    Ok(parts
        .map(|(i, part)| {
            let mut channel = matrix(&sheet, header, part.to_vec());
            channel.name = format!("table {}", i + 1);
            channel
        })
        .collect())
}

fn matrix(sheet: &Sheet, header: &Header, values: Vec<f64>) -> Channel<'static> {
    let shape = [values.len() / sheet.columns, sheet.columns];
    let pixel = match (header.pixel, header.size, header.steps) {
        (Some(pixel), ..) => Pixel::Metres(pixel),
        // Gwyddion's Width and Height are N pixels, not N - 1 intervals.
        (None, Some([height, width]), _) => {
            Pixel::Metres([height / shape[0] as f64, width / shape[1] as f64])
        }
        (None, None, Some(steps)) => Pixel::Steps(steps),
        (None, None, None) => Pixel::Unknown,
    };
    let missing = header.missing_value;
    let [factor, offset] = header.value_line.unwrap_or([1.0, 0.0]);
    let of_cells =
        sheet.unit(0).filter(|_| (1..sheet.columns).all(|i| sheet.unit(i) == sheet.unit(0)));
    let unit = header.value_unit.clone().or(of_cells);
    let mut channel = Channel::new(header.name(), unit.as_deref(), shape, pixel, move || {
        let mut values = values;
        for value in &mut values {
            let is_missing = missing.is_some_and(|mark| *value == mark);
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
