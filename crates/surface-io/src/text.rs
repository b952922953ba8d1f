//! Text files: encodings, line ends, separators, decimal marks, and the one table of numbers in
//! them.

use crate::cells::{BLANK, Cell, Digits, Marks, cell, cells};
pub(crate) use crate::encoding::{decode, is_text, latin1, lines};
use crate::error::TEXT;
use crate::units::metres_per;
use crate::{DecimalMark, ReadError, ReadOptions};

/// Title of a column: "X [mm]" is x in mm.
#[derive(Debug, Clone, Default)]
pub(crate) struct Title {
    pub(crate) name: String,
    pub(crate) unit: Option<String>,
}

/// The numbers of a text file and the lines before them.
pub(crate) struct NumberTable<'a> {
    pub(crate) header: NumberedLines<'a>,
    pub(crate) separator: char,
    pub(crate) columns: usize,
    /// Row-major, NaN where a cell is missing.
    pub(crate) values: Vec<f64>,
    pub(crate) decimal: Option<DecimalMark>,
    /// Columns up to the last cell that is not empty.
    pub(crate) filled: usize,
    /// How precisely the numbers of the first four columns are printed.
    pub(crate) digits: [Digits; 4],
    /// The same of the first row behind its first cell.
    pub(crate) first_row: Digits,
    /// At first with the units of length behind the numbers only.
    pub(crate) titles: Vec<Title>,
    /// Rows before which a blank line or a comment stands.
    pub(crate) parted: Vec<usize>,
}

pub(crate) type NumberedLines<'a> = Vec<(usize, &'a str)>;

impl<'a> NumberTable<'a> {
    pub(crate) fn empty(header: NumberedLines<'a>) -> Self {
        Self {
            header,
            separator: BLANK,
            columns: 0,
            values: Vec::new(),
            decimal: None,
            filled: 0,
            digits: [Digits::NONE; 4],
            first_row: Digits::NONE,
            titles: Vec::new(),
            parted: Vec::new(),
        }
    }

    pub(crate) fn rows(&self) -> usize {
        self.values.len() / self.columns.max(1)
    }

    /// True if `text` is how many rows or columns there are.
    pub(crate) fn counts(&self, text: &str) -> bool {
        text.parse::<usize>().is_ok_and(|n| n == self.rows() || n == self.columns)
    }

    /// Finds the tables in `text` and reads them, in one pass over the numbers; in two, if only their end
    /// shows how they are written. A table ends where a header `begins` another one. There is always one table,
    /// which may be without rows.
    pub(crate) fn all(
        text: &'a str,
        options: &ReadOptions,
        begins: &dyn Fn(&NumberedLines<'a>) -> bool,
    ) -> Result<Vec<Self>, ReadError> {
        let (mut tables, marks) = scan(text, options, begins)?;
        let mut decimal = options.decimal;
        if decimal.is_none() {
            let is_in_pairs = |t: &Self| t.separator == ',' && t.columns.is_multiple_of(2);
            if marks.are_torn() && tables.iter().all(is_in_pairs) {
                return Err(ReadError::at(
                    TEXT,
                    "numbers",
                    "decimal commas stand between cells that are parted by commas, as in 0,034,1,855: save it with \
                     semicolons between the cells, or with decimal points",
                ));
            }
            let decided = marks.decide()?;
            decimal = decided.map(|(decimal, _)| decimal);
            if let Some((_, true)) = decided {
                tables = scan(text, &ReadOptions { decimal, ..options.clone() }, begins)?.0;
            }
        }
        for table in &mut tables {
            table.decimal = decimal;
            table.mind_rows_in_header(options)?;
            table.drop_trailing_separator();
        }
        Ok(tables)
    }

    /// A row with a bad character before the first two sound rows looks like a line of the header:
    /// it, and the rows before it, would vanish without a word. A row of coordinates behind a word in the corner
    /// is the first row.
    fn mind_rows_in_header(&mut self, options: &ReadOptions) -> Result<(), ReadError> {
        let (columns, separator) = (self.columns, self.separator);
        let last = self.header.last().map(|(number, _)| *number);
        let mut whole = None;
        for &(number, line) in self.header.iter().filter(|(_, line)| !is_comment(line, options)) {
            let line = options.joined(line);
            let cells: Vec<&str> = cells(separator, &line).collect();
            let read = |text| cell(text, separator, options);
            let numbers: Vec<f64> = cells
                .iter()
                .filter_map(|text| match read(text) {
                    Cell::Number(value) | Cell::Length(value, _) => Some(value),
                    _ => None,
                })
                .collect();
            let starts_a_number = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.');
            let are_most =
                numbers.len() + 1 == columns || columns > 8 && 2 * numbers.len() >= columns;
            let bad = cells.iter().position(|text| read(text) == Cell::Other);
            match bad {
                Some(0)
                    if columns > 3
                        && numbers.len() + 1 == columns
                        && Some(number) == last
                        && !cells[0].starts_with(starts_a_number)
                        && is_monotone(&numbers) =>
                {
                    for text in &cells[1..] {
                        self.first_row.add(text);
                    }
                    self.values.splice(0..0, std::iter::once(f64::NAN).chain(numbers));
                    self.parted.iter_mut().for_each(|row| *row += 1);
                    return Ok(());
                }
                // "Points 5 7" and "12 um" are words of a header, "1.2x 5 7" is none.
                Some(bad)
                    if cells.len() == columns
                        && columns > 1
                        && are_most
                        && (columns > 3 || cells[0].starts_with(starts_a_number))
                        && metres_per(cells[bad]).is_none() =>
                {
                    return Err(not_a_number(number, bad, cells[bad]));
                }
                None if numbers.len() > 3 && columns > 3 => {
                    whole.get_or_insert((number, numbers.len()));
                }
                _ => {}
            }
        }
        whole.map_or(Ok(()), |(number, numbers)| {
            let what = format!("a row of {numbers} numbers stands before lines that are no rows");
            Err(malformed(number, what))
        })
    }

    /// The first cell that is no number in a text without any row, if some of its lines look like rows.
    pub(crate) fn obstacle(&self, options: &ReadOptions) -> Option<ReadError> {
        let starts_a_number = |text: &&&str| {
            let text = text.trim_matches('"').trim_start_matches(['+', '-', '.', ',']);
            text.starts_with(|c: char| c.is_ascii_digit())
        };
        let obstacles = self.header.iter().filter_map(|&(number, line)| {
            let separator = separators(line)[0];
            let cells: Vec<&str> = cells(separator, line).collect();
            let alike = cells.iter().filter(starts_a_number).count();
            let bad =
                cells.iter().position(|text| cell(text, separator, options) == Cell::Other)?;
            (2 * alike >= cells.len()).then(|| (cells.len(), not_a_number(number, bad, cells[bad])))
        });
        // Two lines in a row: one may be a date.
        let mut obstacles = obstacles.peekable();
        while let Some((count, error)) = obstacles.next() {
            if obstacles.peek().is_some_and(|(next, _)| *next == count) {
                return Some(error);
            }
        }
        None
    }

    fn push(
        &mut self,
        (number, line): (usize, &str),
        options: &ReadOptions,
        marks: &mut Marks,
    ) -> Result<(), ReadError> {
        let line = options.joined(line);
        let (before, is_first) = (self.values.len(), self.values.is_empty());
        for (column, text) in cells(self.separator, &line).enumerate() {
            let cell = cell(text, self.separator, options);
            if !text.trim_matches('"').is_empty() {
                self.filled = self.filled.max(column + 1);
            }
            if let Cell::Number(_) | Cell::Length(..) = cell {
                if options.decimal.is_none() {
                    marks.see(column, number, text);
                }
                if let Some(digits) = self.digits.get_mut(column) {
                    digits.add(text);
                }
                if is_first && column > 0 {
                    self.first_row.add(text);
                }
            }
            self.values.push(match cell {
                Cell::Number(value) => value,
                Cell::Length(value, unit) => {
                    self.titles.resize(self.titles.len().max(column + 1), Title::default());
                    let known = self.titles[column].unit.get_or_insert_with(|| unit.to_owned());
                    if known != unit {
                        let column = column + 1;
                        let what =
                            format!("cell {column}: {text:?}, the cells above are in {known}");
                        return Err(malformed(number, what));
                    }
                    value
                }
                Cell::Missing => f64::NAN,
                Cell::Other => return Err(not_a_number(number, column, text)),
            });
        }
        let (found, expected) = (self.values.len() - before, self.columns);
        if found == expected {
            return Ok(());
        }
        let what = format!("{found} values, the rows before have {expected}");
        Err(malformed(number, what))
    }

    /// A separator at the end of every row is no column, nor are empty columns behind a list of
    /// coordinates; a border of missing points is.
    fn drop_trailing_separator(&mut self) {
        let (columns, filled) = (self.columns, self.filled);
        if self.separator == BLANK || columns < 2 {
            return;
        }
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

fn malformed(line: usize, what: String) -> ReadError {
    ReadError::at(TEXT, format!("line {line}"), what)
}

fn not_a_number(line: usize, column: usize, text: &str) -> ReadError {
    let text = text.trim_matches('"').chars().take(40).collect();
    ReadError::NotANumber { line, cell: column + 1, text }
}

/// True if the numbers only rise or only fall.
pub(crate) fn is_monotone(numbers: &[f64]) -> bool {
    let all = |rises: fn(f64, f64) -> bool| numbers.windows(2).all(|pair| rises(pair[0], pair[1]));
    numbers.len() > 1 && (all(|a, b| a < b) || all(|a, b| a > b))
}

/// Most single numbers before a table that are taken for counts of its rows and columns.
const MOST_COUNTS: usize = 16;

/// Finds the tables of a text, and what their numbers show of their marks.
fn scan<'a>(
    text: &'a str,
    options: &ReadOptions,
    begins: &dyn Fn(&NumberedLines<'a>) -> bool,
) -> Result<(Vec<NumberTable<'a>>, Marks), ReadError> {
    let (mut tables, mut marks) = (Vec::new(), Marks::default());
    let mut table = NumberTable::empty(Vec::new());
    // The line before, if it may be the first row: the next one decides.
    let mut held = None;
    let mut started = false;
    let mut counts: NumberedLines<'_> = Vec::new();
    // Lines between rows: comments, or the header of the next table. And why the first of them is no row.
    let mut between: NumberedLines<'_> = Vec::new();
    let mut trouble = None;
    let mut is_parted = false;
    for (number, line) in lines(text) {
        let line = line.trim_end_matches(['\u{1a}', '\0']);
        let is_blank = line.trim().is_empty() && !line.contains('\t');
        if is_blank || is_comment(line, options) {
            is_parted = started;
            if started && !is_blank {
                between.push((number, line));
            } else if !is_blank {
                table.header.extend(held.take().map(|(line, _)| line));
                table.header.push((number, line));
            }
            continue;
        }
        // Numbers that stand alone before wider rows are counts in the header.
        if started
            && table.columns == 1
            && table.rows() <= MOST_COUNTS
            && let Some((_, 2..)) = row_shape(line, options)
        {
            let mut header = std::mem::take(&mut table.header);
            header.append(&mut counts);
            (table, started) = (NumberTable::empty(header), false);
        }
        if started
            && (!between.is_empty() || trouble.is_some())
            && row_shape(line, options).is_some()
        {
            if begins(&between) {
                tables.push(std::mem::replace(
                    &mut table,
                    NumberTable::empty(std::mem::take(&mut between)),
                ));
                (started, trouble, is_parted) = (false, None, false);
            } else if let Some(error) = trouble {
                return Err(error);
            } else {
                between.clear();
            }
        }
        if started {
            if counts.len() < MOST_COUNTS {
                counts.push((number, line));
            }
            let length = table.values.len();
            match table.push((number, line), options, &mut marks) {
                Ok(()) if is_parted => table.parted.push(length / table.columns),
                Ok(()) => {}
                Err(error @ ReadError::NotANumber { .. }) => {
                    table.values.truncate(length);
                    between.push((number, line));
                    trouble.get_or_insert(error);
                    continue;
                }
                Err(error) => return Err(error),
            }
            is_parted = false;
            continue;
        }
        let shape = row_shape(line, options);
        let before = held.take();
        match (before, shape) {
            (Some((first, known)), Some(shape)) if known == shape => {
                ((table.separator, table.columns), started) = (shape, true);
                counts = vec![first, (number, line)];
                table.push(first, options, &mut marks)?;
                table.push((number, line), options, &mut marks)?;
            }
            (_, shape) => {
                table.header.extend(before.map(|(line, _)| line));
                match shape {
                    Some(shape) => held = Some(((number, line), shape)),
                    None => table.header.push((number, line)),
                }
            }
        }
    }
    if let Some(error) = trouble {
        return Err(error);
    }
    if let Some((only, shape)) = held {
        (table.separator, table.columns) = shape;
        table.push(only, options, &mut marks)?;
    }
    if tables.is_empty() || table.rows() > 0 {
        tables.push(table);
    }
    Ok((tables, marks))
}

fn is_comment(line: &str, options: &ReadOptions) -> bool {
    let line = line.trim_start();
    if line.starts_with("//") {
        return true;
    }
    let mut words = line.split([' ', '\t', ',', ';']);
    line.starts_with(['#', '%', '!']) && !words.next().is_some_and(|word| options.is_missing(word))
}

/// The separators that a line can have, the likeliest first.
fn separators(line: &str) -> &'static [char] {
    if line.contains(';') {
        &[';']
    } else if line.contains('\t') {
        &['\t', BLANK]
    } else if line.contains(',') {
        &[',', BLANK]
    } else {
        &[BLANK]
    }
}

/// Separator and number of cells of a line that is a row of numbers or missing cells.
fn row_shape(line: &str, options: &ReadOptions) -> Option<(char, usize)> {
    separators(line).iter().copied().find_map(|separator| {
        let line = if separator == BLANK { options.joined(line) } else { line.into() };
        let mut count = 0;
        for text in cells(separator, &line) {
            count += 1;
            if cell(text, separator, options) == Cell::Other {
                return None;
            }
        }
        (count > 0).then_some((separator, count))
    })
}
