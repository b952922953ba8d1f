//! What the lines before the numbers of a text file say: sizes, units, titles of the columns.

use crate::DecimalMark;
use crate::cells::{self, BLANK};
use crate::meaning::{self, UNUSED};
use crate::text::{NumberTable, Title};
use crate::units::{metres_per, quantity};
use std::collections::BTreeMap;

/// Titles that begin those of heights.
pub(crate) const HEIGHTS: [&str; 5] = ["z", "height", "trace", "profile", "höhe"];

/// What the lines before the numbers say.
#[derive(Debug, Default)]
pub(crate) struct Header {
    pub(crate) channel: Option<String>,
    /// `[height, width]` in metres.
    pub(crate) size: Option<[f64; 2]>,
    /// `[dy, dx]` in metres.
    pub(crate) pixel: Option<[f64; 2]>,
    /// Unit of x and y where the columns do not name theirs.
    pub(crate) lateral_unit: Option<String>,
    pub(crate) value_unit: Option<String>,
    /// Metres per stored number, as SPIP writes it.
    pub(crate) value_scale: Option<f64>,
    /// Factor and offset from stored numbers to the unit.
    pub(crate) value_line: Option<[f64; 2]>,
    pub(crate) missing_value: Option<f64>,
    /// Rows of the map, behind which as many rows say with 0 which points are missing (SPIP).
    pub(crate) rows_before_mask: Option<usize>,
    /// `[dy, dx]` of a row and a column of coordinates, in a unit that is not known.
    pub(crate) steps: Option<[f64; 2]>,
    pub(crate) columns: Vec<Title>,
    pub(crate) metadata: BTreeMap<String, String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Key {
    Channel,
    Width,
    Height,
    Pixel,
    Dx,
    Dy,
    UnitX,
    UnitY,
    UnitLateral,
    UnitValue,
    Missing,
}

/// Keys in lower case as instruments and programs write them: Gwyddion (in its languages, as its
/// translations have them), SPIP, Attocube, Nova, and what people write by hand.
const KEYS: &[(Key, &str)] = &[
    (Key::Channel, "channel|title|kanál|kanal|canal|canale|チャネル|채널|канал"),
    (Key::Width, "width|šířka|breite|anchura|largeur|larghezza|largura|幅|폭|ширина"),
    (Key::Width, "x-length|x length|xlength|x size|x amplitude"),
    (Key::Height, "height|výška|höhe|altura|hauteur|altezza|高さ|높이|высота"),
    (Key::Height, "y-length|y length|ylength|y size|y amplitude"),
    (Key::Pixel, "pixel size|pixel_size|pixel|spacing"),
    (Key::Dx, "dx|x step|x spacing|x pixel size|pixel size x|scale x"),
    (Key::Dy, "dy|y step|y spacing|y pixel size|pixel size y|scale y"),
    (Key::UnitX, "x-unit|x unit|xunit|unit x"),
    (Key::UnitY, "y-unit|y unit|yunit|unit y"),
    (Key::UnitLateral, "lateral units|lateral unit|xy unit|xy units|jednotky rozměrů"),
    (Key::UnitLateral, "laterale einheiten|_laterale einheiten|unités latérales|unità laterali"),
    (Key::UnitLateral, "unidades laterales|unidades laterais|единицы горизонтальных размеров"),
    (Key::UnitValue, "value units|value unit|z unit|z units|z-unit|zunit|height unit"),
    (Key::UnitValue, "height units|unit z|unit data|jednotky hodnot|einheiten|werteinheiten"),
    (Key::UnitValue, "werteeinheiten|unités|unités de valeur|unità valore|unidades de valor"),
    (Key::UnitValue, "値の単位|값 단위|единицы измерения|\\exported image units"),
];

impl Header {
    pub(crate) fn name(&self) -> String {
        self.channel.clone().unwrap_or_else(|| "default".into())
    }

    /// Rows and columns that the header declares.
    pub(crate) fn counts(&self) -> [Option<usize>; 2] {
        const ROWS: &str = "rows|nrows|number of rows|vertical|ny|yres|y pixels|y-pixels";
        const COLUMNS: &str =
            "columns|cols|ncols|number of columns|horizontal|nx|xres|x pixels|x-pixels";
        let bare =
            |text: &str| text.trim_matches(|c: char| c == '"' || c.is_whitespace()).to_lowercase();
        let count = |names: &str| {
            let is_one = |key: &str| {
                let key = bare(key);
                names.split('|').any(|name| name == key)
            };
            let mut said = self.metadata.iter().filter(|(key, _)| is_one(key));
            said.find_map(|(_, value)| bare(value).parse().ok())
        };
        [count(ROWS), count(COLUMNS)]
    }

    /// True if these lines can be the header of a channel.
    pub(crate) fn says_channel(&self) -> bool {
        self.channel.is_some()
            || self.value_unit.is_some()
            || self.value_scale.is_some()
            || self.size.is_some()
            || self.pixel.is_some()
    }

    pub(crate) fn parse(table: &NumberTable<'_>) -> Self {
        let mut header = Self::default();
        let lines: Vec<(String, String)> =
            table.header.iter().filter_map(|(_, line)| key_value(line)).collect();
        let has = |key: &str, value: &str| {
            lines.iter().any(|(k, v)| k.eq_ignore_ascii_case(key) && v.starts_with(value))
        };
        let is_keyence =
            has("data type", "ImageDataCsv") || has("model", "VK-") || has("model", "VR-");
        // Image Metrology's SPIP and what writes its form: lengths are in nm.
        let is_spip = has("file format", "ASCII");
        // Lengths as written; a unit may stand in another line.
        let mut said: Vec<(Key, &str, &str)> = Vec::new();
        let mut unused = Vec::new();
        for (key, value) in &lines {
            let name = key.to_lowercase();
            let number = || number(value.trim_start_matches("value").trim(), table.decimal);
            let own = if is_keyence { keyence_key(&name) } else { None };
            let known = own.or_else(|| {
                let is_one = |names: &str| names.split('|').any(|one| one == name);
                let listed = KEYS.iter().find(|(_, names)| is_one(names)).map(|(key, _)| *key);
                let own =
                    (table.columns == 1 && is_one("unit|data unit")).then_some(Key::UnitValue);
                listed.or(own).or(is_missing_key(&name, value).then_some(Key::Missing))
            });
            match (known, &name[..]) {
                (Some(Key::Channel), _) => header.channel = Some(value.clone()),
                (Some(Key::Missing), _) => header.missing_value = number(),
                (Some(about), _) => said.push((about, key, value)),
                (None, "bit2nm" | "scale data" | "bias data") if number().is_some() => {
                    let line = header.value_line.get_or_insert([1.0, 0.0]);
                    line[usize::from(name == "bias data")] = number().unwrap_or_default();
                }
                (None, name) if is_spip_scale(name) => header.value_scale = number(),
                _ if meaning::is_scale(&name, value) && !table.counts(value) => {
                    unused.push(format!("{key} = {value}"));
                }
                _ => {}
            }
        }
        let last = |key: Key| said.iter().rev().find(|said| said.0 == key).map(|said| said.2);
        header.value_unit = last(Key::UnitValue).map(str::to_owned);
        let x_unit = last(Key::UnitX).or(last(Key::UnitLateral));
        let y_unit = last(Key::UnitY).or(last(Key::UnitLateral)).or(x_unit);
        header.lateral_unit = x_unit.map(str::to_owned);
        let total = is_spip.then_some("nm");
        let metres = |text: Option<&str>, unit: Option<&str>| {
            let text = text?.trim();
            let digits = text.len() - quantity(&text.replace(',', "0"))?.1.len();
            let (digits, written) = text.split_at(digits);
            let value = number(digits.trim(), table.decimal)?;
            if written.is_empty() {
                return Some(value.abs() * metres_per(unit?)?);
            }
            Some(value * metres_per(written)?)
        };
        header.size = metres(last(Key::Height), y_unit.or(total))
            .zip(metres(last(Key::Width), x_unit.or(total)))
            .map(|(h, w)| [h, w]);
        header.pixel = metres(last(Key::Dy).or(last(Key::Pixel)), y_unit)
            .zip(metres(last(Key::Dx).or(last(Key::Pixel)), x_unit))
            .map(|(y, x)| [y, x]);
        if header.size.is_none() && header.pixel.is_none() {
            let sizes = [Key::Width, Key::Height, Key::Pixel, Key::Dx, Key::Dy];
            let silent = said.iter().filter(|said| sizes.contains(&said.0));
            unused.extend(silent.map(|(_, key, text)| format!("{key} = {text}")));
        }
        let find = |key: &str| {
            lines.iter().find(|(k, _)| k.eq_ignore_ascii_case(key)).map(|(_, v)| v.as_str())
        };
        // SPIP's factor counts without a unit of the heights, Nova's if it says so.
        let is_nova = find("DataScaleNeeded").is_some_and(|v| v.eq_ignore_ascii_case("yes"));
        match (header.value_line, find("bit2nm")) {
            (Some(_), Some(_)) if header.value_unit.is_none() => {
                header.value_unit = Some("nm".into());
            }
            (Some([factor, _]), Some(text)) => {
                header.value_line = None;
                unused.extend(
                    (factor.to_bits() != 1f64.to_bits()).then(|| format!("Bit2nm = {text}")),
                );
            }
            _ => header.value_line = header.value_line.filter(|_| is_nova),
        }
        let count = |key: &str| find(key).and_then(|text| text.parse::<usize>().ok());
        header.rows_before_mask =
            count("voidpixels").filter(|&n| n > 0).and_then(|_| count("y-pixels"));
        unused.truncate(8);
        if !unused.is_empty() {
            header.metadata.insert(UNUSED.into(), unused.join("; "));
        }
        header.metadata.extend(lines);
        header.titles(table);
        header
    }

    /// Titles and units of the columns from the last two lines before the numbers.
    fn titles(&mut self, table: &NumberTable<'_>) {
        let last = table.header.len().saturating_sub(2);
        for (_, line) in &table.header[last..] {
            let line = line.trim().trim_start_matches(['#', '%', '!', '/', ' ']);
            // A unit in brackets belongs to the name before it, also behind a blank.
            let line = line.replace(" [", "[").replace(" (", "(");
            let cells = [table.separator, ';', BLANK]
                .into_iter()
                .map(|separator| {
                    let mut cells: Vec<&str> = cells::cells(separator, &line).collect();
                    while cells.len() > table.columns && cells.last().is_some_and(|c| c.is_empty())
                    {
                        cells.pop();
                    }
                    cells
                })
                .find(|cells| cells.len() == table.columns || cells.len() == table.columns.min(2));
            // Words, of which none is a value or the key of one; a single unit may be that of the spacing.
            let is_title = |cell: &&str| {
                let is_heights = || HEIGHTS.iter().any(|z| cell.to_lowercase().starts_with(z));
                !is_value(cell.trim_matches('"'))
                    && (table.columns > 1 || !cell.contains([':', '=']) || is_heights())
            };
            let Some(cells) = cells.filter(|cells| cells.iter().all(is_title)) else {
                continue;
            };
            for (i, cell) in cells.into_iter().enumerate() {
                let Title { name, unit } = title(cell);
                self.columns.resize(self.columns.len().max(i + 1), Title::default());
                let title = &mut self.columns[i];
                if title.name.is_empty() {
                    title.name = name;
                }
                title.unit = unit.or(title.unit.take());
            }
        }
    }
}

/// True if a cell is a key, a number, or ends in one and its unit: "Cutoff 0.8 mm", not "z1 nm" or "trace 2 [nm]".
fn is_value(cell: &str) -> bool {
    let digits = cell.rfind(|c: char| c.is_ascii_digit()).map_or(0, |at| at + 1);
    let (before, unit) = cell.split_at(digits);
    let (key, number) = before.rsplit_once([' ', ':', '=']).unwrap_or(("", before));
    let is_counted = !key.is_empty() && unit.starts_with(['[', '(']) && !cell.contains([':', '=']);
    let is_name =
        number.starts_with(char::is_alphabetic) || is_counted && !number.contains(['.', ',']);
    let is_number =
        !number.is_empty() && (cell.len() == number.len() || metres_per(unit).is_some());
    cell.ends_with([':', '=']) || is_number && !is_name
}

/// True if a key in lower case says which number stands for a missing point; without "value" it may say how many are.
fn is_missing_key(name: &str, value: &str) -> bool {
    let letters: String = name.chars().filter(|c| c.is_alphabetic()).collect();
    let is_of_value = letters.ends_with("value") || value.starts_with('-');
    let what = letters.trim_end_matches("value").trim_end_matches("points");
    matches!(&letters[..], "nodata" | "missing")
        || is_of_value
            && "nodata|missing|missingdata|fill|bad|invalid|void|undefined"
                .split('|')
                .any(|one| one == what)
}

/// The number that a value is; none where a comma may part thousands and the numbers of the table do not tell.
fn number(text: &str, decimal: Option<DecimalMark>) -> Option<f64> {
    let known = cells::number(text, decimal, false);
    let thousands = cells::number(text, Some(DecimalMark::Point), false);
    let is_either = decimal.is_none() && text.contains(',') && thousands.is_some();
    known.or_else(|| cells::number(text, None, false)).filter(|_| !is_either)
}

/// What a key in lower case means in the export of a Keyence microscope and nowhere else: every cell
/// stands between quotation marks, in the language of the program.
fn keyence_key(name: &str) -> Option<Key> {
    const UNIT: [&str; 7] = ["unit", "einheit", "unité", "unità", "unidad", "单位", "単位"];
    match name {
        "output image data" => Some(Key::Channel),
        _ if UNIT.contains(&name) => Some(Key::UnitValue),
        _ if name.starts_with("xy") || name.ends_with("xy") => Some(Key::Pixel),
        _ => None,
    }
}

/// "height conversion factor (-> m)".
fn is_spip_scale(name: &str) -> bool {
    name.contains("conversion factor") && name.replace(' ', "").ends_with("(->m)")
}

/// "key: value", "key = value", cells between quotation marks, or "key value" for the two words of
/// a grid file.
fn key_value(line: &str) -> Option<(String, String)> {
    let line = line.trim().trim_start_matches(['#', '%', '!', '/', ' ', '\t']).trim();
    let quoted = line.strip_prefix('"').and_then(|rest| rest.split_once('"'));
    let (key, value) = if let Some((key, rest)) = quoted {
        let separator = rest.trim_start().chars().next()?;
        let cells = rest.split(separator).map(|cell| cell.trim().trim_matches('"').trim());
        let cells: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
        (key, cells.join(" "))
    } else {
        let pair = line.split_once([':', '=', '：']);
        let (key, value) = pair.or_else(|| line.split_once([',', ' ', '\t']))?;
        (key, value.to_owned())
    };
    let (key, value) = (key.trim(), value.trim());
    (!key.is_empty() && !value.is_empty() && key.len() <= 64)
        .then(|| (key.to_owned(), value.to_owned()))
}

fn title(cell: &str) -> Title {
    let cell = cell.trim().trim_matches('"');
    let word = |c: char| c.is_whitespace() || matches!(c, '_' | '[' | ']' | '(' | ')' | '/');
    let words: Vec<&str> = cell.split(word).filter(|w| !w.is_empty()).collect();
    let in_brackets =
        cell.split_once(['[', '(']).map(|(_, rest)| rest.trim_end_matches([']', ')']));
    let unit = in_brackets.as_ref().or(words.last()).filter(|w| metres_per(w).is_some());
    let unit = unit.map(|w| w.trim().to_owned());
    let name = words.first().filter(|_| unit.is_none() || words.len() > 1);
    Title { name: name.map_or(String::new(), |name| (*name).to_owned()), unit }
}
