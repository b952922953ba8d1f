//! What the lines before the numbers of a text file say: sizes, units, titles of the columns.

use crate::cells::Separator;
use crate::text::Table;
use crate::units::{length, metres_per, quantity};
use std::collections::BTreeMap;

/// Title of a column: "X [mm]" is x in mm.
#[derive(Debug, Clone)]
pub(crate) struct Title {
    pub(crate) name: String,
    pub(crate) unit: Option<String>,
}

/// What the lines before the numbers say.
#[derive(Debug, Default)]
pub(crate) struct Header {
    pub(crate) channel: Option<String>,
    /// `[height, width]` in metres.
    pub(crate) size: Option<[f64; 2]>,
    /// `[dy, dx]` in metres.
    pub(crate) pixel: Option<[f64; 2]>,
    pub(crate) value_unit: Option<String>,
    /// Metres per stored number, as SPIP writes it.
    pub(crate) value_scale: Option<f64>,
    pub(crate) missing_value: Option<f64>,
    pub(crate) columns: Vec<Title>,
    pub(crate) metadata: BTreeMap<String, String>,
}

impl Header {
    pub(crate) fn name(&self) -> String {
        self.channel.clone().unwrap_or_else(|| "default".into())
    }

    pub(crate) fn parse(table: &Table<'_>) -> Self {
        let mut header = Self::default();
        // Lengths as written; a unit may stand in another line.
        let [mut width, mut height, mut dx, mut dy] = [const { None::<String> }; 4];
        let [mut x_unit, mut y_unit] = [const { None::<String> }; 2];
        for (_, line) in &table.header {
            let line = line.trim().trim_start_matches(['#', '%', '!', '/', ' ', '\t']).trim();
            let Some((key, value)) = key_value(line) else { continue };
            let text = || Some(value.to_owned());
            match key.to_lowercase().as_str() {
                "channel" | "title" | "kanal" | "canal" => header.channel = text(),
                "width" | "breite" | "largeur" | "x-length" | "x length" | "xlength" | "x size" => {
                    width = text();
                }
                "height" | "höhe" | "hauteur" | "y-length" | "y length" | "ylength" | "y size" => {
                    height = text();
                }
                "pixel size" | "pixel" | "spacing" => (dx, dy) = (text(), text()),
                "dx" | "x step" | "x spacing" | "x pixel size" | "pixel size x" => dx = text(),
                "dy" | "y step" | "y spacing" | "y pixel size" | "pixel size y" => dy = text(),
                "x-unit" | "x unit" | "xunit" => x_unit = text(),
                "y-unit" | "y unit" | "yunit" => y_unit = text(),
                "value units" | "value unit" | "z unit" | "z units" | "z-unit" | "zunit"
                | "height unit" | "height units" | "unit z" | "werteinheiten"
                | "werteeinheiten" | "unités de valeur" => header.value_unit = text(),
                "nodata_value" | "nodata" | "missing value" | "missing" => {
                    header.missing_value = value.parse().ok();
                }
                key if key.contains("conversion factor")
                    && key.replace(' ', "").ends_with("(->m)") =>
                {
                    header.value_scale = value.parse().ok();
                }
                _ => {}
            }
            header.metadata.insert(key.to_owned(), value.to_owned());
        }
        let metres = |text: Option<String>, unit: &Option<String>| {
            let text = text?.replace(',', ".");
            length(&text).or_else(|| {
                let (value, written) = quantity(&text)?;
                (written.is_empty()).then_some(value * metres_per(unit.as_deref()?)?)
            })
        };
        header.size = metres(height, &y_unit).zip(metres(width, &x_unit)).map(|(h, w)| [h, w]);
        header.pixel = metres(dy, &y_unit).zip(metres(dx, &x_unit)).map(|(y, x)| [y, x]);
        header.titles(table);
        header
    }

    /// Titles and units of the columns from the last two lines before the numbers.
    fn titles(&mut self, table: &Table<'_>) {
        let last = table.header.len().saturating_sub(2);
        for (_, line) in &table.header[last..] {
            let line = line.trim().trim_start_matches(['#', '%', '!', '/', ' ']);
            // A unit in brackets belongs to the name before it, also behind a blank.
            let line = line.replace(" [", "[").replace(" (", "(");
            let cells = [table.separator, Separator::Semicolon, Separator::Blank]
                .into_iter()
                .map(|separator| {
                    let mut cells: Vec<&str> = separator.cells(&line).collect();
                    while cells.len() > table.columns && cells.last().is_some_and(|c| c.is_empty())
                    {
                        cells.pop();
                    }
                    cells
                })
                .find(|cells| cells.len() == table.columns || cells.len() == table.columns.min(2));
            let Some(cells) = cells else { continue };
            for (i, cell) in cells.into_iter().enumerate() {
                let (name, unit) = title(cell);
                if self.columns.len() <= i {
                    self.columns.push(Title { name: String::new(), unit: None });
                }
                let title = &mut self.columns[i];
                if title.name.is_empty() {
                    title.name = name;
                }
                title.unit = unit.or(title.unit.take());
            }
        }
    }
}

/// "key: value", "key = value", or "key value" for the two words of a grid file.
fn key_value(line: &str) -> Option<(&str, &str)> {
    let at = line.find([':', '=']);
    let (key, value) = match at {
        Some(at) => (&line[..at], &line[at + 1..]),
        None => line.split_once([',', ' ', '\t'])?,
    };
    let (key, value) = (key.trim(), value.trim());
    (!key.is_empty() && !value.is_empty() && key.len() <= 64).then_some((key, value))
}

/// Name and unit in a column title.
fn title(cell: &str) -> (String, Option<String>) {
    let cell = cell.trim().trim_matches('"');
    let word = |c: char| c.is_whitespace() || matches!(c, '_' | '[' | ']' | '(' | ')' | '/');
    let words: Vec<&str> = cell.split(word).filter(|w| !w.is_empty()).collect();
    let unit = words.last().filter(|w| metres_per(w).is_some()).map(|w| (*w).to_owned());
    let name = match (&unit, words.len()) {
        (Some(_), 1) => String::new(),
        _ => words.first().map(|w| (*w).to_owned()).unwrap_or_default(),
    };
    (name, unit)
}
