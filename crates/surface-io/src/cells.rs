//! One cell of a table: separators, decimal marks, missing values, printed digits.

use crate::error::{ReadError, TEXT};
use crate::need::{DecimalMark, Need};
use crate::options::ReadOptions;
use crate::units::metres_per;

/// What stands between two numbers where nothing else does.
pub(crate) const BLANK: char = ' ';

/// The cells of a line, trimmed. Blanks join; any other separator leaves empty cells, and does
/// not part what stands in quotation marks.
pub(crate) fn cells(separator: char, line: &str) -> Box<dyn Iterator<Item = &str> + '_> {
    if separator == BLANK {
        return Box::new(line.split_ascii_whitespace());
    }
    if !line.contains('"') {
        return Box::new(line.split(separator).map(str::trim));
    }
    let mut is_quoted = false;
    let has_pairs = line.bytes().filter(|b| *b == b'"').count() % 2 == 0;
    let parts = move |c: char| {
        is_quoted ^= c == '"' && has_pairs;
        c == separator && !is_quoted
    };
    Box::new(line.split(parts).map(str::trim))
}

impl ReadOptions {
    /// Marks that are no numbers: a number is a mark among heights only, not among coordinates.
    fn words(&self) -> impl Iterator<Item = &str> {
        self.missing.iter().map(String::as_str).filter(|mark| mark_value(mark).is_none())
    }

    /// The line with marks of two words as one, where blanks part the cells.
    pub(crate) fn joined<'l>(&self, line: &'l str) -> std::borrow::Cow<'l, str> {
        let two_words = self.words().filter(|mark| mark.contains(' ')).chain(["no data"]);
        let mut joined = std::borrow::Cow::Borrowed(line);
        for mark in two_words {
            let is_mark = |words: &[u8]| words.eq_ignore_ascii_case(mark.as_bytes());
            while let Some(at) = joined.as_bytes().windows(mark.len()).position(is_mark) {
                joined.to_mut().replace_range(at..at + mark.len(), "nan");
            }
        }
        joined
    }

    /// True if a cell of these words marks a missing point.
    pub(crate) fn is_missing(&self, text: &str) -> bool {
        const WORDS: &str = "na|n/a|n.a.|null|none|bad|nodata|no data|no_data|missing|invalid|\
                             undefined|void|masked|nan|#n/a|#nv|#num!|#value!|#wert!|#div/0!";
        let is_drawn = |text: &str| {
            text.len() <= 12
                && text
                    .chars()
                    .all(|c| matches!(c, '-' | '*' | '?' | '\u{2013}' | '\u{2014}' | '\u{2212}'))
        };
        // "1.#QNAN", "-1.#IND00", "-nan(ind)", "NaNQ": what C libraries print for what is no number.
        let is_nan = || {
            let text = text.trim_start_matches(['+', '-']).to_ascii_lowercase();
            let of_c = ["nan(", "nanq", "nans", "qnan", "snan"];
            of_c.iter().any(|start| text.starts_with(start))
                || text.split_once(".#").is_some_and(|(_, what)| {
                    ["qnan", "snan", "ind", "nan"].iter().any(|start| what.starts_with(start))
                })
        };
        is_drawn(text)
            || text.len() <= 24
                && (WORDS.split('|').any(|word| text.eq_ignore_ascii_case(word)) || is_nan())
            || self.words().any(|mark| text.eq_ignore_ascii_case(mark))
    }
}

/// The number that a mark of missing points is, if it is one.
pub(crate) fn mark_value(mark: &str) -> Option<f64> {
    number(mark.trim(), None, false).filter(|value| !value.is_nan())
}

/// True if a number is this mark; in single precision it is that only nearly.
pub(crate) fn is_mark(value: f64, mark: f64) -> bool {
    let is = |mark| value.partial_cmp(&mark).is_some_and(std::cmp::Ordering::is_eq);
    is(mark) || is(f64::from(mark as f32))
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell<'t> {
    Number(f64),
    /// A number and its unit of length.
    Length(f64, &'t str),
    Missing,
    Other,
}

pub(crate) fn cell<'t>(text: &'t str, separator: char, options: &ReadOptions) -> Cell<'t> {
    let inner = text.strip_prefix('"').and_then(|t| t.strip_suffix('"'));
    // Between commas a blank may part two numbers as well as thousands.
    let blanks = inner.is_some() || !matches!(separator, ',' | BLANK);
    let text = inner.map_or(text, str::trim);
    match number(text, options.decimal, blanks) {
        Some(value) if value.is_nan() => return Cell::Missing,
        Some(value) => return Cell::Number(value),
        None if options.is_missing(text) => return Cell::Missing,
        None => {}
    }
    let digits = text.rfind(|c: char| c.is_ascii_digit()).map_or(0, |at| at + 1);
    let (value, unit) = text.split_at(digits);
    match number(value, options.decimal, blanks) {
        Some(value) if metres_per(unit).is_some() => Cell::Length(value, unit.trim()),
        _ => Cell::Other,
    }
}

/// The signs that people and programs write for a minus.
const MINUS: [char; 8] =
    ['-', '\u{2212}', '\u{2010}', '\u{2011}', '\u{2012}', '\u{2013}', '\u{fe63}', '\u{ff0d}'];

/// A number with a decimal point or comma, thousands parted by the other mark, an apostrophe, a hard
/// blank or (`blanks`) a blank, and an exponent behind E or D. Where the mark is not known a single
/// one is the decimal mark, and so is the last of two kinds.
pub(crate) fn number(text: &str, decimal: Option<DecimalMark>, blanks: bool) -> Option<f64> {
    if decimal != Some(DecimalMark::Comma) || !text.contains('.') {
        if let Ok(value) = text.parse::<f64>() {
            return Some(value);
        }
        if !text.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
    }
    let unsigned = text.strip_prefix('+').or_else(|| text.strip_prefix(MINUS));
    let is_negative = unsigned.is_some() && !text.starts_with('+');
    let unsigned = unsigned.unwrap_or(text);
    let (mantissa, exponent) = match unsigned.find(['e', 'E', 'd', 'D']) {
        Some(at) => (&unsigned[..at], &unsigned[at + 1..]),
        None => (unsigned, "0"),
    };
    let exponent: i32 = exponent.replacen(MINUS, "-", 1).parse().ok()?;
    let mark = decimal.map(DecimalMark::char).or_else(|| {
        let last = mantissa.chars().rfind(|c| matches!(c, '.' | ','))?;
        let are_both = mantissa.contains('.') && mantissa.contains(',');
        (are_both || mantissa.matches(last).count() == 1).then_some(last)
    });
    let (whole, fraction) =
        mark.and_then(|mark| mantissa.split_once(mark)).unwrap_or((mantissa, ""));
    let are_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
    let whole = if are_digits(whole) {
        std::borrow::Cow::Borrowed(whole)
    } else {
        // Groups of three behind one to three digits.
        let group = whole.chars().find(|c| !c.is_ascii_digit())?;
        let is_group =
            matches!(group, ',' | '.' | '\'' | '\u{2019}' | '\u{a0}' | '\u{202f}' | '\u{2009}');
        let mut groups = whole.split(group);
        let first = groups.next()?;
        let is_whole = (is_group || blanks && group == ' ')
            && (1..=3).contains(&first.len())
            && !first.starts_with('0')
            && are_digits(first)
            && groups.all(|digits| digits.len() == 3 && are_digits(digits));
        if !is_whole || mantissa.len() != unsigned.len() {
            return None;
        }
        std::borrow::Cow::Owned(whole.replace(group, ""))
    };
    if !are_digits(fraction) || whole.is_empty() && fraction.is_empty() {
        return None;
    }
    let value: f64 = format!("{whole}.{fraction}e{exponent}").parse().ok()?;
    Some(if is_negative { -value } else { value })
}

/// What the numbers of a file show of their marks: is `1,855` a number below two, or thousands?
#[derive(Debug, Default)]
pub(crate) struct Marks {
    /// Point, comma: seen where it can only be the decimal mark.
    decimal: [bool; 2],
    /// Point, comma: seen where it can only part thousands.
    thousands: [bool; 2],
    columns: Vec<Column>,
    /// The first number that can be either.
    example: Option<(usize, String)>,
}

/// The same of one column.
#[derive(Debug, Default, Clone)]
struct Column {
    /// Point, comma: behind one to three digits and before three.
    either: [bool; 2],
    /// Different whole numbers below 1000 without a mark, other than 0; three at most.
    bare: Vec<u64>,
    /// A whole number above, without a mark.
    is_large: bool,
    /// Digits that begin with 0, and no number is written so.
    is_fraction: bool,
}

impl Marks {
    pub(crate) fn see(&mut self, column: usize, line: usize, text: &str) {
        let body = text.trim_matches('"').trim_start_matches('+').trim_start_matches(MINUS);
        let count = |mark: u8| body.bytes().filter(|b| *b == mark).count();
        let counts = [count(b'.'), count(b',')];
        if self.columns.len() <= column {
            self.columns.resize(column + 1, Column::default());
        }
        let seen = &mut self.columns[column];
        match counts {
            [0, 0] => {
                let Ok(whole) = body.parse::<u64>() else { return };
                seen.is_fraction |= body.len() > 1 && body.starts_with('0');
                seen.is_large |= whole > 999;
                if (1..1000).contains(&whole) && seen.bare.len() < 3 && !seen.bare.contains(&whole)
                {
                    seen.bare.push(whole);
                }
            }
            [1, 0] | [0, 1] => {
                let mark = counts[1];
                let (whole, fraction) = body.split_once(['.', ',']).unwrap_or_default();
                let are_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
                if fraction.len() == 3
                    && (1..=3).contains(&whole.len())
                    && !whole.starts_with('0')
                    && are_digits(whole)
                    && are_digits(fraction)
                {
                    seen.either[mark] = true;
                    self.example.get_or_insert_with(|| (line, text.to_owned()));
                } else {
                    self.decimal[mark] = true;
                }
            }
            [_, 0] => self.thousands[0] = true,
            [0, _] => self.thousands[1] = true,
            _ => {
                let last = usize::from(body.rfind(',') > body.rfind('.'));
                (self.decimal[last], self.thousands[1 - last]) = (true, true);
            }
        }
    }

    /// The decimal mark, and whether a number was read otherwise when it was not known yet.
    ///
    /// Whole numbers below 1000 beside others of the same column that all have three digits behind a mark are a
    /// pattern of thousands: of decimals some would have fewer digits.
    pub(crate) fn decide(&self) -> Result<Option<(DecimalMark, bool)>, ReadError> {
        let either = [0, 1].map(|mark| self.columns.iter().any(|column| column.either[mark]));
        let [point, comma] = [0, 1].map(|mark| self.decimal[mark] || self.thousands[1 - mark]);
        let either_way = || {
            let (line, text) = self.example.clone().unwrap_or_default();
            let digits: String = text.chars().filter(|c| !matches!(c, '.' | ',' | '"')).collect();
            let decimal = text.trim_matches('"').replace(',', ".");
            let what = format!(
                "line {line}: {text} can be {decimal}, or {digits} with a mark of thousands"
            );
            ReadError::Ambiguous { what, needs: vec![Need::DecimalMark] }
        };
        let mark = match (point, comma, either) {
            (true, true, _) => {
                let what = "both decimal points and decimal commas occur: which of them is the decimal mark?";
                return Err(ReadError::at(TEXT, "numbers", what));
            }
            (true, false, _) => 0,
            (false, true, _) => 1,
            (false, false, [false, false]) => return Ok(None),
            (false, false, [true, true]) => return Err(either_way()),
            (false, false, [_, comma]) => {
                let mark = usize::from(comma);
                let mixed = || self.columns.iter().filter(|column| column.either[mark]);
                let mut bare: Vec<u64> =
                    mixed().flat_map(|column| column.bare.iter().copied()).collect();
                bare.sort_unstable();
                bare.dedup();
                match (bare.len() > 2, mixed().any(|column| column.is_large)) {
                    (true, false) => 1 - mark,
                    (false, _) if mark == 0 => 0,
                    _ => return Err(either_way()),
                }
            }
        };
        let decimal = [DecimalMark::Point, DecimalMark::Comma][mark];
        Ok(Some((decimal, either[1 - mark])))
    }

    /// True if decimal commas stand between cells that commas part: `0,034,1,855`.
    pub(crate) fn are_torn(&self) -> bool {
        let uses_point = self.decimal[0] || self.columns.iter().any(|column| column.either[0]);
        let has_fraction =
            |from: usize| self.columns.iter().skip(from).step_by(2).any(|c| c.is_fraction);
        !uses_point && has_fraction(1) && !has_fraction(0)
    }
}

/// How precisely a column is printed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Digits {
    /// Power of ten of the finest decimal place, e.g. -2 for 0.01.
    place: i32,
    /// Most significant digits.
    significant: i32,
}

impl Digits {
    pub(crate) const NONE: Self = Self { place: i32::MAX, significant: 0 };

    pub(crate) fn add(&mut self, text: &str) {
        let (mantissa, exponent) = match text.find(['e', 'E', 'd', 'D']) {
            Some(at) => (&text[..at], text[at + 1..].parse().unwrap_or(0)),
            None => (text, 0i32),
        };
        let decimals = mantissa.find(['.', ',']).map_or(0, |at| mantissa.len() - at - 1);
        let decimals = i32::try_from(decimals).unwrap_or(400);
        let place = exponent.saturating_sub(decimals);
        let digits = mantissa.trim_start_matches(['+', '-', '0', '.', ',']);
        let significant = digits.bytes().filter(u8::is_ascii_digit).count();
        let significant = i32::try_from(significant).unwrap_or(400);
        self.place = self.place.min(place);
        self.significant = self.significant.max(significant);
    }

    /// One unit in the last printed place of numbers up to `largest`, also where trailing zeros
    /// are left out or all numbers have equally many significant digits.
    pub(crate) fn quantum(self, largest: f64) -> f64 {
        let leading = largest.log10().floor().clamp(-400.0, 400.0) as i32;
        let last = 10f64.powi(leading + 1 - self.significant.min(400));
        let place = 10f64.powi(self.place.clamp(-400, 400));
        if last.is_finite() { place.max(last) } else { place }
    }
}
