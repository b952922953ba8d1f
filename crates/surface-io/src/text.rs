//! Text files: encodings, line ends, separators, decimal marks, and the one table of numbers in
//! them.

use crate::binary::Bytes;
use crate::cells::{Cell, Digits, Marks, Separator, cell};
use crate::units::metres_per;
use crate::{Format, ReadError};
use std::borrow::Cow;

/// The text of a file: UTF-8, UTF-16 with a byte order mark, or else Latin-1.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    let wide = |order: fn([u8; 2]) -> u16| {
        let units = bytes[2..].chunks_exact(2).map(|pair| order([pair[0], pair[1]]));
        char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect()
    };
    match bytes {
        [0xff, 0xfe, ..] => Cow::Owned(wide(u16::from_le_bytes)),
        [0xfe, 0xff, ..] => Cow::Owned(wide(u16::from_be_bytes)),
        _ => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            match std::str::from_utf8(bytes) {
                Ok(text) => Cow::Borrowed(text),
                Err(_) => Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect()),
            }
        }
    }
}

/// True if `bytes` can be the start of a text file: no control characters in the first 4 KiB.
pub(crate) fn is_text(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(4096)];
    if start.starts_with(b"\xff\xfe") || start.starts_with(b"\xfe\xff") {
        return true;
    }
    start.iter().all(|&b| b >= 0x20 || matches!(b, b'\t' | b'\n' | b'\r' | 0x0c | 0x1a))
}

/// Lines with their numbers from 1. `\n`, `\r\n` and a lone `\r` end a line, also mixed.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut rest = Some(text);
    let mut number = 0;
    std::iter::from_fn(move || {
        let text = rest?;
        number += 1;
        match text.bytes().position(|b| b == b'\n' || b == b'\r') {
            None => {
                rest = None;
                Some((number, text))
            }
            Some(end) => {
                let after = &text[end..];
                let skip = if after.starts_with("\r\n") { 2 } else { 1 };
                rest = Some(&after[skip..]);
                Some((number, &text[..end]))
            }
        }
    })
}

/// Most single numbers before a table that are taken for counts of its rows and columns.
const MOST_COUNTS: usize = 16;

/// The numbers of a text file and the lines before them.
#[derive(Debug)]
pub(crate) struct Table<'a> {
    pub(crate) header: Vec<(usize, &'a str)>,
    pub(crate) separator: Separator,
    pub(crate) columns: usize,
    /// Row-major, NaN where a cell is missing.
    pub(crate) values: Vec<f64>,
    /// How precisely the numbers of the first three columns are printed.
    pub(crate) digits: [Digits; 3],
}

impl<'a> Table<'a> {
    pub(crate) fn rows(&self) -> usize {
        self.values.len() / self.columns.max(1)
    }

    /// True if `text` is how many rows or columns there are.
    pub(crate) fn counts(&self, text: &str) -> bool {
        text.parse::<usize>().is_ok_and(|n| n == self.rows() || n == self.columns)
    }

    /// Finds the table in `text` and reads it, in one pass over the numbers.
    pub(crate) fn parse(text: &'a str, format: Format) -> Result<Self, ReadError> {
        let mut table = Self {
            header: Vec::new(),
            separator: Separator::Blank,
            columns: 0,
            values: Vec::new(),
            digits: [Digits::NONE; 3],
        };
        let mut marks = Marks::default();
        // The line before, if it may be the first row: the next one decides.
        let mut held: Option<(usize, &str, Separator, usize)> = None;
        let mut started = false;
        let mut counts: Vec<(usize, &str)> = Vec::new();
        for (number, line) in lines(text) {
            let line = line.trim_end_matches(['\u{1a}', '\0']);
            if line.trim().is_empty() && !line.contains('\t') || is_comment(line) {
                if !started && !line.trim().is_empty() {
                    table.header.extend(held.take().map(|(n, l, _, _)| (n, l)));
                    table.header.push((number, line));
                }
                continue;
            }
            // Numbers that stand alone before wider rows are counts in the header.
            if started
                && table.columns == 1
                && table.rows() <= MOST_COUNTS
                && let Some((_, 2..)) = row_shape(line)
            {
                table.header.append(&mut counts);
                (table.columns, started) = (0, false);
                table.values.clear();
                table.digits = [Digits::NONE; 3];
            }
            if started {
                if counts.len() < MOST_COUNTS {
                    counts.push((number, line));
                }
                table.push(number, line, &mut marks, format)?;
                continue;
            }
            let shape = row_shape(line);
            match (held.take(), shape) {
                (Some((n, first, separator, columns)), Some((s, c)))
                    if s == separator && c == columns =>
                {
                    (table.separator, table.columns, started) = (separator, columns, true);
                    counts = vec![(n, first), (number, line)];
                    table.push(n, first, &mut marks, format)?;
                    table.push(number, line, &mut marks, format)?;
                }
                (previous, Some((separator, columns))) => {
                    table.header.extend(previous.map(|(n, l, _, _)| (n, l)));
                    held = Some((number, line, separator, columns));
                }
                (previous, None) => {
                    table.header.extend(previous.map(|(n, l, _, _)| (n, l)));
                    table.header.push((number, line));
                }
            }
        }
        if let Some((n, line, separator, columns)) = held {
            (table.separator, table.columns) = (separator, columns);
            table.push(n, line, &mut marks, format)?;
        }
        if marks.comma && marks.point {
            return Err(Bytes::little(&[], format).field(
                "numbers",
                "both decimal points and decimal commas occur: which of them is the decimal mark?",
            ));
        }
        table.refuse_rows_in_header(format)?;
        table.drop_trailing_separator();
        Ok(table)
    }

    /// A row with a bad character before the first two sound rows looks like a line of the header:
    /// it, and the rows before it, would vanish without a word.
    fn refuse_rows_in_header(&self, format: Format) -> Result<(), ReadError> {
        let columns = self.columns;
        let mut whole = None;
        for &(number, line) in self.header.iter().filter(|(_, line)| !is_comment(line)) {
            let cells: Vec<&str> = self.separator.cells(line).collect();
            let read = |text: &str| cell(text, self.separator, &mut Marks::default());
            let numbers = cells.iter().filter(|c| matches!(read(c), Cell::Number(_))).count();
            let starts_a_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.');
            match cells.iter().find(|text| read(text) == Cell::Other) {
                // "Points 5 7" and "12 um" are words of a header, "1.2x 5 7" is none.
                Some(bad)
                    if cells.len() == columns
                        && columns > 1
                        && numbers + 1 == columns
                        && (columns > 3 || cells[0].starts_with(starts_a_number))
                        && metres_per(bad).is_none() =>
                {
                    let bad: String = bad.chars().take(40).collect();
                    let what = format!("{bad:?} is no number, and all else in this line is a row");
                    let place = crate::Place::Line(number);
                    return Err(ReadError::Malformed { format, place, what: what.into() });
                }
                None if numbers > 3 && columns > 3 => {
                    whole.get_or_insert((number, numbers));
                }
                _ => {}
            }
        }
        whole.map_or(Ok(()), |(number, numbers)| {
            let what = format!("a row of {numbers} numbers stands before lines that are no rows");
            let place = crate::Place::Line(number);
            Err(ReadError::Malformed { format, place, what: what.into() })
        })
    }

    fn push(
        &mut self,
        number: usize,
        line: &str,
        marks: &mut Marks,
        format: Format,
    ) -> Result<(), ReadError> {
        match self.separator {
            Separator::Blank => {
                self.push_cells(number, line.split_ascii_whitespace(), marks, format)
            }
            separator => {
                let cells = line.split(separator.char()).map(str::trim);
                self.push_cells(number, cells, marks, format)
            }
        }
    }

    fn push_cells<'l>(
        &mut self,
        number: usize,
        cells: impl Iterator<Item = &'l str>,
        marks: &mut Marks,
        format: Format,
    ) -> Result<(), ReadError> {
        let fault = |what: String| ReadError::Malformed {
            format,
            place: crate::Place::Line(number),
            what: what.into(),
        };
        let before = self.values.len();
        for (column, text) in cells.enumerate() {
            self.values.push(match cell(text, self.separator, marks) {
                Cell::Number(value) => {
                    if let Some(digits) = self.digits.get_mut(column) {
                        digits.add(text);
                    }
                    value
                }
                Cell::Missing => f64::NAN,
                Cell::Other => {
                    let text: String = text.chars().take(40).collect();
                    return Err(fault(format!("{text:?} is no number")));
                }
            });
        }
        let found = self.values.len() - before;
        if found != self.columns {
            let expected = self.columns;
            return Err(fault(format!("{found} values, the rows before have {expected}")));
        }
        Ok(())
    }

    /// A separator at the end of every row is no column, nor are empty columns behind a list of
    /// coordinates; a border of missing points is.
    fn drop_trailing_separator(&mut self) {
        let columns = self.columns;
        if self.separator == Separator::Blank || columns < 2 {
            return;
        }
        let is_empty = |column: usize| self.values.chunks(columns).all(|row| row[column].is_nan());
        let filled = (0..columns).rev().find(|&column| !is_empty(column)).map_or(0, |c| c + 1);
        if filled + 1 == columns || (2..=3).contains(&filled) {
            let mut index = 0;
            self.values.retain(|_| {
                index += 1;
                (index - 1) % columns < filled
            });
            self.columns = filled;
        }
    }
}

fn is_comment(line: &str) -> bool {
    let line = line.trim_start();
    line.starts_with(['#', '%', '!']) && !line.starts_with("#N/A") || line.starts_with("//")
}

/// Separator and number of cells of a line that is a row of numbers or missing cells.
fn row_shape(line: &str) -> Option<(Separator, usize)> {
    let candidates: &[Separator] = if line.contains(';') {
        &[Separator::Semicolon]
    } else if line.contains('\t') {
        &[Separator::Tab, Separator::Blank]
    } else if line.contains(',') {
        &[Separator::Comma, Separator::Blank]
    } else {
        &[Separator::Blank]
    };
    candidates.iter().copied().find_map(|separator| {
        let (mut cells, mut is_row) = (0, true);
        for text in separator.cells(line) {
            cells += 1;
            is_row &= cell(text, separator, &mut Marks::default()) != Cell::Other;
            if !is_row {
                return None;
            }
        }
        (cells > 0).then_some((separator, cells))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str) -> Table<'_> {
        Table::parse(text, Format::Text).unwrap()
    }

    #[test]
    fn separators_and_decimal_marks() {
        for text in [
            "1.5 2\n3 4.25\n",
            "1.5\t2\r\n3\t4.25",
            "1.5,2\n3,4.25",
            "1,5;2\n3;4,25",
            "1,5 2\n3 4,25",
            "  1.5,   2\n  3,   4.25\n",
            "1.5;2;\n3;4.25;\n",
            "1.5 2\r3 4.25\r\n\r\n",
        ] {
            let t = table(text);
            assert_eq!((t.columns, &t.values[..]), (2, &[1.5, 2.0, 3.0, 4.25][..]), "{text:?}");
        }
    }

    #[test]
    fn missing_cells_keep_their_place() {
        let t = table(";;;\n1;;NaN;\n2;3;4;\n");
        assert_eq!((t.rows(), t.columns), (3, 3)); // the last separator is no column
        assert_eq!(t.values.iter().filter(|v| v.is_nan()).count(), 5);
        assert_eq!(table("1\t\t3\n4\t5\t6\n").values.len(), 6);
    }

    #[test]
    fn a_border_of_missing_points_is_kept() {
        assert_eq!(table("1;;\n2;;\n").columns, 3);
        assert_eq!(table("1;2;;\n2;3;;\n").columns, 2);
    }

    #[test]
    fn header_ends_where_two_rows_agree() {
        let t = table("Title 5\n23\num um\n1 2\n3 4\n");
        assert_eq!(t.header.len(), 3);
        assert_eq!(t.rows(), 2);
    }

    /// Found with a real file: rows before a bad one vanished without a word.
    #[test]
    fn a_bad_row_at_the_start_is_no_header() {
        for (text, line) in [
            ("1 2 x3 4\n5 6 7 8\n9 1 2 3\n", "line 1"),
            ("1 2 3 4\n5 6 7,,1 8\n9 1 2 3\n4 5 6 7\n", "line 2"),
            ("# map\n1 2 3 4\n@ @ @ @\n9 1 2 3\n4 5 6 7\n", "line 2"),
            ("1 2 3 4 5\n5 6 7 8\n9 1 2 3\n", "line 1"),
            ("0 0 1\n0.l 1 2\n1 0 3\n1 1 4\n", "line 2"),
            ("0.1;1.O\n0.2;2\n0.3;3\n", "line 1"),
        ] {
            let error = Table::parse(text, Format::Text).unwrap_err().to_string();
            assert!(error.contains(line), "{text:?}: {error}");
        }
        for text in ["Points 5 7\n1 2 3\n4 5 6\n", "5 7\na b\n1 2\n3 4\n", "1 um\n1 2\n3 4\n"] {
            assert_eq!(table(text).rows(), 2, "{text:?}");
        }
    }

    #[test]
    fn counts_before_the_rows_are_header() {
        let t = table("title\n3\n2\n1 2 3\n4 5 6\n");
        assert_eq!((t.header.len(), t.columns, t.rows()), (3, 3, 2));
        assert_eq!(table("1\n2\n3\n").columns, 1);
    }

    #[test]
    fn wrong_rows_name_their_line() {
        for (text, line) in [("1 2\n3 4\n5\n", "line 3"), ("1 2\n\n3 4\n5 x\n", "line 4")] {
            let e = Table::parse(text, Format::Text).unwrap_err().to_string();
            assert!(e.contains(line), "{e}");
        }
    }

    #[test]
    fn mixed_decimal_marks_are_refused() {
        assert!(Table::parse("1,5;2.5\n1;2\n", Format::Text).is_err());
    }

    #[test]
    fn encodings() {
        let utf16: Vec<u8> =
            "\u{feff}1 \u{b5}m".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert_eq!(decode(&utf16), "1 \u{b5}m");
        assert_eq!(decode(b"1 \xb5m"), "1 \u{b5}m");
        assert_eq!(decode("\u{feff}1 \u{b5}m".as_bytes()), "1 \u{b5}m");
    }

    #[test]
    fn printed_precision() {
        for (texts, largest, quantum) in [
            (&["0.0", "0.2", "1499.8"][..], 1499.8, 0.1),
            (&["4", "4.5", "9"], 9.0, 0.1),
            (&["1.6655563e-08", "4.997e-05"], 4.997e-5, 1e-12),
            (&["12", "7"], 12.0, 1.0),
        ] {
            let mut digits = Digits::NONE;
            for text in texts {
                digits.add(text);
            }
            assert!((digits.quantum(largest) / quantum - 1.0).abs() < 1e-9, "{texts:?}");
        }
    }
}
