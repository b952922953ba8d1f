//! Files one below the other: the table of a terminal, and the same as CSV.

use crate::outcome::Failure;
use crate::text::{self, Columns};
use rough_contact::report;
use serde_json::Value;
use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

pub(crate) struct FileOutcome {
    pub(crate) file: PathBuf,
    /// The digest of its answer, and what is incomplete in it.
    pub(crate) result: Result<(Value, Option<Failure>), Failure>,
    pub(crate) is_kept: bool,
    /// The file name of its answer, where answers are kept.
    pub(crate) kept_as: Option<String>,
}

impl FileOutcome {
    pub(crate) fn name_in(&self, folder: &Path) -> String {
        self.file.strip_prefix(folder).unwrap_or(&self.file).display().to_string()
    }

    /// Why there is no answer, or no complete one, without the name of the file.
    pub(crate) fn why(&self) -> Option<String> {
        let failure = match &self.result {
            Ok((_, trouble)) => trouble.as_ref()?,
            Err(failure) => failure,
        };
        let message = &failure.message;
        let name = format!("{}: ", self.file.display());
        Some(message.strip_prefix(&name).unwrap_or(message).to_owned())
    }
}

/// A column of a table on a terminal.
pub(crate) struct Shown {
    pub(crate) head: &'static str,
    /// Where the number is: the first of these that there is. A `*` stands for every load.
    pub(crate) at: &'static [&'static str],
    pub(crate) how: How,
}

#[derive(Clone, Copy)]
pub(crate) enum How {
    /// `ny × nx`.
    Shape,
    Word,
    Count,
    Number,
    Length,
    Pressure,
    Force,
    Percent,
    Seconds,
    /// How many findings are to be checked.
    Checks,
}

impl How {
    fn write(self, value: &Value) -> Option<String> {
        let number = |write: fn(f64) -> String| value.as_f64().map(write);
        match self {
            Self::Shape => {
                let list: Vec<String> = value.as_array()?.iter().map(Value::to_string).collect();
                Some(list.join(" × "))
            }
            Self::Word => value.as_str().map(str::to_owned),
            Self::Count => value.as_u64().map(|n| n.to_string()),
            Self::Number => number(text::number),
            Self::Length => number(text::length),
            Self::Pressure => number(text::pressure),
            Self::Force => number(text::force),
            Self::Percent => number(text::percent),
            Self::Seconds => number(text::seconds),
            Self::Checks => {
                let open = |f: &&Value| f.get("weight").is_some_and(|w| w == "check");
                Some(value.as_array()?.iter().filter(open).count().to_string())
            }
        }
    }
}

fn cell(answer: &Value, shown: &Shown, load: usize) -> Option<String> {
    let value = |at: &&str| answer.pointer(&at.replace('*', &load.to_string()));
    shown.at.iter().filter_map(value).find_map(|value| shown.how.write(value))
}

/// A row for every file with an answer, a line for every one without; no column that no file fills.
pub(crate) fn table(outcomes: &[FileOutcome], shown: &[Shown]) -> String {
    let folder = common_folder(outcomes);
    let answers = || outcomes.iter().filter_map(|o| Some((o, &o.result.as_ref().ok()?.0)));
    let mut columns = Columns::default();
    columns.column("file", answers().map(|(o, _)| o.name_in(&folder)));
    let loads = |answer: &Value| answer["points"].as_array().map_or(1, Vec::len);
    let most = answers().map(|(_, answer)| loads(answer)).max().unwrap_or(1);
    for load in 0..most {
        for column in shown {
            let is_of_load = column.at.iter().any(|at| at.contains('*'));
            if !is_of_load && load > 0 {
                continue;
            }
            let values: Vec<_> = answers().map(|(_, answer)| cell(answer, column, load)).collect();
            if values.iter().any(Option::is_some) {
                let cells = values.into_iter().map(|value| text::or_dash(value, |cell| cell));
                columns.column(column.head, cells);
            }
        }
    }
    let any = answers().next().is_some();
    let mut out = if any { columns.to_string() } else { String::new() };
    if !folder.as_os_str().is_empty() {
        out = format!("in {}:\n{out}", folder.display());
    }
    for outcome in outcomes {
        let Some(why) = outcome.why() else { continue };
        let kind = if outcome.result.is_ok() { "incomplete" } else { "no answer" };
        let why = why.replace('\n', "; ");
        let _ = writeln!(out, "{kind}: {}: {why}", outcome.name_in(&folder));
    }
    let kept = outcomes.iter().filter(|o| o.is_kept).count();
    if kept > 0 {
        let _ = writeln!(out, "{kept} of {} answers were there already", outcomes.len());
    }
    out
}

/// The folder that all files are in.
pub(crate) fn common_folder(outcomes: &[FileOutcome]) -> PathBuf {
    let folders = outcomes.iter().map(|o| o.file.parent().unwrap_or(Path::new("")).to_owned());
    let both = |a: PathBuf, b: PathBuf| {
        let shared = a.components().zip(b.components()).take_while(|(x, y)| x == y);
        shared.map(|(x, _)| x).collect()
    };
    folders.reduce(both).unwrap_or_default()
}

/// The same with everything the digests hold.
pub(crate) fn csv(outcomes: &[FileOutcome], out: &mut impl Write) -> io::Result<()> {
    let row = |o: &'_ FileOutcome| o.file.display().to_string();
    let rows = outcomes.iter().map(|o| (row(o), o.result.as_ref().ok().map(|r| &r.0), o.why()));
    report::write_table_csv(rows, out)
}
