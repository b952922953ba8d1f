//! What a header says, key by key.

use crate::binary::Bytes;
use crate::encoding::lines;
use crate::error::ReadError;
use std::collections::BTreeMap;
use std::str::FromStr;

/// The entries of a header, by key.
#[derive(Clone, Copy)]
pub(crate) struct Entries<'e> {
    format: &'static str,
    map: &'e BTreeMap<String, String>,
}

impl<'e> Entries<'e> {
    pub(crate) fn new(b: Bytes<'_>, map: &'e BTreeMap<String, String>) -> Self {
        Self { format: b.format, map }
    }

    pub(crate) fn get(self, key: &str) -> Option<&'e str> {
        self.map.get(key).map(String::as_str)
    }

    pub(crate) fn text(self, key: &str) -> Result<&'e str, ReadError> {
        self.get(key)
            .ok_or_else(|| ReadError::at(self.format, key.to_owned(), "is missing or empty"))
    }

    pub(crate) fn number(self, key: &str) -> Result<f64, ReadError> {
        let number = self.parsed::<f64>(key, "number")?;
        let fault = || ReadError::at(self.format, key.to_owned(), format!("{number} is no number"));
        Some(number).filter(|number| number.is_finite()).ok_or_else(fault)
    }

    pub(crate) fn number_or(self, key: &str, default: f64) -> Result<f64, ReadError> {
        if self.map.contains_key(key) { self.number(key) } else { Ok(default) }
    }

    /// The text as what it is called in the refusal of another one.
    pub(crate) fn parsed<T: FromStr>(self, key: &str, what: &str) -> Result<T, ReadError> {
        let text = self.text(key)?;
        let fault =
            |_| ReadError::at(self.format, key.to_owned(), format!("{text:?} is no {what}"));
        text.parse().map_err(fault)
    }
}

/// The entries of a header in sections: `[section]` and `key BETWEEN value`, each on a line.
pub(crate) fn sections(
    b: Bytes<'_>,
    header: &str,
    between: &str,
) -> Result<BTreeMap<String, BTreeMap<String, String>>, ReadError> {
    let mut sections = BTreeMap::<String, BTreeMap<String, String>>::new();
    let mut name = "";
    for (number, line) in lines(header) {
        b.check_items(number as u64)?;
        let line = line.trim();
        if let Some(section) = line.strip_prefix('[').and_then(|line| line.strip_suffix(']')) {
            name = section;
        } else if let Some((key, value)) = line.split_once(between) {
            let section = sections.entry(name.to_owned()).or_default();
            section.insert(key.trim().to_owned(), value.trim().to_owned());
        }
    }
    Ok(sections)
}
