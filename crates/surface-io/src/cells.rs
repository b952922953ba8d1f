//! One cell of a table: separators, decimal marks, missing values, printed digits.

/// What stands between two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Separator {
    Tab,
    Semicolon,
    Comma,
    Blank,
}

impl Separator {
    pub(crate) fn char(self) -> char {
        match self {
            Self::Tab => '\t',
            Self::Semicolon => ';',
            Self::Comma => ',',
            Self::Blank => ' ',
        }
    }

    /// The cells of a line, trimmed. Blanks join; any other separator leaves empty cells.
    pub(crate) fn cells<'a>(self, line: &'a str) -> Box<dyn Iterator<Item = &'a str> + 'a> {
        match self {
            Self::Blank => Box::new(line.split_ascii_whitespace()),
            _ => Box::new(line.split(self.char()).map(str::trim)),
        }
    }
}

/// A cell of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Cell {
    Number(f64),
    Missing,
    Other,
}

/// Reads one cell; `decimal_comma` is updated when the cell shows which mark is used.
pub(crate) fn cell(text: &str, separator: Separator, marks: &mut Marks) -> Cell {
    let text = text.strip_prefix('"').and_then(|t| t.strip_suffix('"')).unwrap_or(text);
    if separator != Separator::Comma && text.contains(',') {
        if text.contains('.') || text.matches(',').count() > 1 {
            return Cell::Other;
        }
        if let Ok(value) = text.replacen(',', ".", 1).parse::<f64>() {
            marks.comma = true;
            return Cell::Number(value);
        }
        return Cell::Other;
    }
    match text.parse::<f64>() {
        Ok(value) if value.is_nan() => Cell::Missing,
        Ok(value) => {
            marks.point |= text.contains('.');
            Cell::Number(value)
        }
        Err(_) if is_missing(text) => Cell::Missing,
        Err(_) => Cell::Other,
    }
}

fn is_missing(text: &str) -> bool {
    const WORDS: [&str; 12] =
        ["", "na", "n/a", "#n/a", "null", "bad", "*", "***", "-", "--", "---", "nan(ind)"];
    text.len() <= 10 && WORDS.iter().any(|word| text.eq_ignore_ascii_case(word))
}

/// Decimal marks seen so far.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Marks {
    pub(crate) point: bool,
    pub(crate) comma: bool,
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
        let (mantissa, exponent) = match text.find(['e', 'E']) {
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
