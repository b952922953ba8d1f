//! One command over many files: every file by itself, nothing aborted, answers kept as they come, and the table of them.

use crate::args::CommonOptions;
use crate::files::{Files, expand};
use crate::outcome::{Failure, Folder, Reply, unfit};
use crate::progress::ProgressDisplay;
use crate::text::{self, Columns};
use rough_contact::compare::sha256_hex;
use rough_contact::report;
use serde_json::{Value, json};
use std::fmt::{Debug, Write as _};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Files up to this size are answered side by side, one thread each; larger ones after them, with all threads.
const SMALL: u64 = 4 << 20;

/// A command that answers for one file at a time.
pub(crate) trait PerFile: Debug + Sync {
    const NAME: &'static str;
    const SHOWN: &'static [Shown];

    fn answer(&self, file: &Path, common: &CommonOptions) -> Result<Reply, Failure>;

    /// Everything that is asked, whatever the files.
    fn settings(&self) -> String {
        format!("{self:?}")
    }

    /// Content of other files that an answer depends on, as a hash.
    fn beside(&self) -> String {
        String::new()
    }

    /// What is said of all files below their table.
    fn about(&self) -> String {
        String::new()
    }

    /// True if everything that belongs to the answer beside its numbers is there.
    fn is_complete(&self, _file: &Path) -> bool {
        true
    }

    /// What a table over files shows of an answer; everything else is on the disk.
    fn digest(answer: Value) -> Value {
        answer
    }
}

/// Answers for the one file that was named as ever, for several in one table.
pub(crate) fn run<C: PerFile>(
    command: &C,
    files: &Files,
    common: &CommonOptions,
) -> Result<Reply, Failure> {
    if files.paths.is_empty() {
        let message = format!(
            "no FILE is named; give one, several or a folder, as in `rough-contact {} map.x3p`",
            C::NAME
        );
        return Err(Failure::refused("usage", message));
    }
    if let Some(file) = files.only() {
        return command.answer(file, common);
    }
    let names = ["table.csv", "results.json"];
    let open = |out: &PathBuf| Store::at(command, out, &names, [files.resume, common.force]);
    let store = files.out.as_ref().map(open).transpose()?;
    let outcomes = outcomes(command, &files.paths, store.as_ref(), common)?;
    let mut reply = Reply::new(table(&outcomes, C::SHOWN), json!({ "files": objects(&outcomes) }));
    reply.text += &command.about();
    reply.trouble = trouble(&outcomes);
    if let Some(store) = &store {
        store.folder.write("table.csv", |out| csv(&outcomes, out))?;
        store.folder.write("results.json", |out| writeln!(out, "{:#}", reply.json))?;
        let _ = writeln!(reply.text, "table: {}", store.folder.path.join("table.csv").display());
    }
    Ok(reply)
}

pub(crate) fn objects(outcomes: &[FileOutcome]) -> Vec<Value> {
    let one = |outcome: &FileOutcome| {
        let (mut object, trouble) = match &outcome.result {
            Ok((answer, trouble)) => (answer.clone(), trouble.as_ref()),
            Err(failure) => (json!({}), Some(failure)),
        };
        if let Some(trouble) = trouble {
            object["error"] = trouble.json();
        }
        object["file"] = json!(outcome.file.display().to_string());
        object
    };
    outcomes.iter().map(one).collect()
}

pub(crate) fn trouble(outcomes: &[FileOutcome]) -> Option<Failure> {
    let failed = outcomes.iter().filter(|o| o.why().is_some()).count();
    let message = format!("{failed} of {} files without a complete answer", outcomes.len());
    (failed > 0).then(|| Failure::incomplete("files_failed", message))
}

/// Every file answered, in the order of the files.
///
/// # Errors
/// Before any work: nothing was found. After it: all files were refused for one and the same reason,
/// which is then no matter of the files.
pub(crate) fn outcomes<C: PerFile>(
    command: &C,
    paths: &[PathBuf],
    store: Option<&Store>,
    common: &CommonOptions,
) -> Result<Vec<FileOutcome>, Failure> {
    let files = expand(paths)?;
    let threads = common.threads();
    let done: Vec<Mutex<Option<FileOutcome>>> = files.iter().map(|_| Mutex::new(None)).collect();
    let progress = Mutex::new(ProgressDisplay::new(common.quiet, files.len()));
    let answer = |index: usize, threads: usize| {
        let common = CommonOptions {
            quiet: true,
            threads: Some(threads),
            // What an interrupted run has written of this file is replaced.
            force: common.force || store.is_some_and(|s| s.resume),
            ..*common
        };
        let outcome = one(command, &files[index], store, &common);
        let said = said(&outcome);
        *done[index].lock().unwrap_or_else(PoisonError::into_inner) = Some(outcome);
        progress.lock().unwrap_or_else(PoisonError::into_inner).step(&said);
    };
    let is_small = |index: &usize| files[*index].metadata().map_or(0, |facts| facts.len()) <= SMALL;
    let (small, large): (Vec<usize>, Vec<usize>) =
        (0..files.len()).partition(|index| threads == 1 || is_small(index));
    let small = Mutex::new(small.into_iter());
    let next = || small.lock().unwrap_or_else(PoisonError::into_inner).next();
    std::thread::scope(|scope| {
        for _ in 0..threads.min(files.len()) {
            scope.spawn(|| {
                while let Some(index) = next() {
                    answer(index, 1);
                }
            });
        }
    });
    for index in large {
        answer(index, threads);
    }
    let all = done.into_iter().filter_map(|slot| slot.into_inner().ok().flatten());
    alike(all.collect())
}

/// A refusal that is the same for all files is one of the command.
fn alike(outcomes: Vec<FileOutcome>) -> Result<Vec<FileOutcome>, Failure> {
    let failure = |o: &FileOutcome| o.result.as_ref().err().cloned();
    let Some(first) = outcomes.first().and_then(failure) else { return Ok(outcomes) };
    let same = |o: &FileOutcome| failure(o).is_some_and(|other| other.message == first.message);
    let is_one = outcomes.len() > 1 && outcomes.iter().all(same);
    if is_one { Err(first) } else { Ok(outcomes) }
}

fn said(outcome: &FileOutcome) -> String {
    let how = match (&outcome.result, outcome.is_kept) {
        (Ok((_, None)), false) => "",
        (Ok((_, None)), true) => ", kept",
        (Ok((_, Some(_))), _) => ", incomplete",
        (Err(_), _) => ", failed",
    };
    format!("{}{how}", outcome.file.display())
}

fn one<C: PerFile>(
    command: &C,
    file: &Path,
    store: Option<&Store>,
    common: &CommonOptions,
) -> FileOutcome {
    let outcome =
        |result, kept_as| FileOutcome { file: file.to_owned(), result, is_kept: false, kept_as };
    let digest = |reply: Reply| (C::digest(reply.json), reply.trouble);
    let Some(store) = store else {
        return outcome(command.answer(file, common).map(digest), None);
    };
    let content = match std::fs::read(file) {
        Ok(content) => sha256_hex(&content) + &store.beside,
        Err(e) => return outcome(Err(unfit(file, "io", e)), None),
    };
    let name = store.name(file, &content);
    if let Some((answer, trouble)) = store.kept(&name)
        && command.is_complete(file)
    {
        let kept = outcome(Ok((C::digest(answer), trouble)), Some(name));
        return FileOutcome { is_kept: true, ..kept };
    }
    let result = command.answer(file, common).and_then(|reply| {
        store.keep(&name, &reply)?;
        Ok(digest(reply))
    });
    outcome(result, Some(name))
}

/// The folder of a run: its results, and under `answers` what each file gave.
pub(crate) struct Store {
    pub(crate) folder: Folder,
    answers: Folder,
    resume: bool,
    /// How the names of answers to these options end.
    ending: String,
    /// Content of other files that all answers depend on, as a hash.
    beside: String,
}

impl Store {
    /// Prepares the folder. Results that are there are replaced by a run that goes on with answers to the same options.
    pub(crate) fn at<C: PerFile>(
        command: &C,
        out: &Path,
        names: &[&str],
        [resume, force]: [bool; 2],
    ) -> Result<Self, Failure> {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        let asked = format!("{} {} {}", env!("CARGO_PKG_VERSION"), C::NAME, command.settings());
        let ending = format!("-{}.json", &sha256_hex(asked.as_bytes())[..12]);
        let answers = out.join("answers");
        let mut there = answers.read_dir().into_iter().flatten().flatten();
        let is_known = there.any(|one| one.file_name().to_string_lossy().ends_with(&ending));
        let folder = Folder::prepare(out, &names, force || (resume && is_known));
        let why = "--resume goes on with answers to the same options, and here are none: give another --out";
        let folder = folder.map_err(|e| e.adding(if resume { why } else { "" }))?;
        let (answers, beside) = (Folder::prepare(&answers, &[], true)?, command.beside());
        Ok(Self { folder, answers, resume, ending, beside })
    }

    pub(crate) fn whole(&self, outcome: &FileOutcome) -> std::io::Result<Value> {
        Ok(self.read(outcome.kept_as.as_deref().unwrap_or_default())?["answer"].take())
    }

    fn read(&self, name: &str) -> std::io::Result<Value> {
        let text = std::fs::read_to_string(self.answers.path.join(name))?;
        serde_json::from_str(&text).map_err(std::io::Error::other)
    }

    /// The name of an answer: that of the file, a hash of its path and of all content, and one of everything that was asked.
    fn name(&self, file: &Path, content: &str) -> String {
        let key = sha256_hex(format!("{}\n{content}", file.display()).as_bytes());
        let stem = file.file_name().unwrap_or_default().to_string_lossy();
        let plain = |c: char| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '_' };
        let stem: String = stem.chars().map(plain).take(60).collect();
        format!("{stem}-{}{}", &key[..12], self.ending)
    }

    /// The answer of this name, if it is to be kept, is there and whole.
    fn kept(&self, name: &str) -> Option<(Value, Option<Failure>)> {
        if !self.resume {
            return None;
        }
        let mut kept = self.read(name).ok()?;
        let answer = kept.get_mut("answer")?.take();
        let trouble = serde_json::from_value(kept["trouble"].take()).ok()?;
        answer.is_object().then_some((answer, trouble))
    }

    /// Puts an answer there. It has its name only when it is whole.
    fn keep(&self, name: &str, reply: &Reply) -> Result<(), Failure> {
        let kept = json!({ "answer": reply.json, "trouble": reply.trouble });
        self.answers.write(name, |out| {
            serde_json::to_writer(&mut *out, &kept).map_err(std::io::Error::other)?;
            writeln!(out)
        })
    }
}

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
    /// A number in this unit.
    In(&'static str),
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
            Self::In(unit) => value.as_f64().map(|x| format!("{x:.3e} {unit}")),
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
