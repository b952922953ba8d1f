//! One command over many files: every file by itself, nothing aborted, answers kept as they come.

use crate::args::CommonOptions;
use crate::files::{Files, expand};
use crate::outcome::{Failure, Reply, unfit};
use crate::output::Folder;
use crate::progress::ProgressDisplay;
use crate::rows::{self, FileOutcome, Shown};
use rough_contact::compare::sha256_hex;
use serde_json::{Value, json};
use std::fmt::{Debug, Write as _};
use std::io::Write as _;
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
    fn asked(&self) -> String {
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
    let open = |out: &PathBuf| Store::at(out, &names, files.resume, common.force);
    let store = files.out.as_ref().map(open).transpose()?;
    let outcomes = outcomes(command, &files.paths, store.as_ref(), common)?;
    let mut reply =
        Reply::new(rows::table(&outcomes, C::SHOWN), json!({ "files": objects(&outcomes) }));
    reply.text += &command.about();
    reply.trouble = trouble(&outcomes);
    if let Some(store) = &store {
        store.folder.write("table.csv", |out| rows::csv(&outcomes, out))?;
        store.folder.write("results.json", |out| writeln!(out, "{:#}", reply.json))?;
        let _ = writeln!(reply.text, "table: {}", store.folder.path().join("table.csv").display());
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
    let settings = format!(
        "{} {} {} {}",
        env!("CARGO_PKG_VERSION"),
        C::NAME,
        command.asked(),
        command.beside()
    );
    let done: Vec<Mutex<Option<FileOutcome>>> = files.iter().map(|_| Mutex::new(None)).collect();
    let progress = Mutex::new(ProgressDisplay::new(common.quiet, files.len()));
    let answer = |index: usize, threads: usize| {
        let common = CommonOptions {
            json: common.json,
            quiet: true,
            threads: Some(threads),
            // What an interrupted run has written of this file is replaced.
            force: common.force || store.is_some_and(|s| s.resume),
        };
        let outcome = one(command, &files[index], &settings, store, &common);
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
    let reason = outcomes.first().and_then(FileOutcome::why);
    let same = |o: &FileOutcome| o.result.is_err() && o.why() == reason;
    let is_one = outcomes.len() > 1 && outcomes.iter().all(same);
    match outcomes.first().and_then(|first| first.result.as_ref().err()) {
        Some(failure) if is_one => Err(failure.clone()),
        _ => Ok(outcomes),
    }
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
    settings: &str,
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
        Ok(content) => sha256_hex(&content),
        Err(e) => return outcome(Err(unfit(file, "io", e)), None),
    };
    let name = Store::name(file, &content, settings);
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
}

impl Store {
    /// Prepares the folder. Results that are there are replaced by a run that goes on with them.
    pub(crate) fn at(
        out: &Path,
        names: &[&str],
        resume: bool,
        force: bool,
    ) -> Result<Self, Failure> {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        let folder = Folder::prepare(out, &names, force || resume)?;
        let answers = Folder::prepare(&out.join("answers"), &[], true)?;
        Ok(Self { folder, answers, resume })
    }

    pub(crate) fn whole(&self, outcome: &FileOutcome) -> std::io::Result<Value> {
        Ok(self.read(outcome.kept_as.as_deref().unwrap_or_default())?["answer"].take())
    }

    fn read(&self, name: &str) -> std::io::Result<Value> {
        let text = std::fs::read_to_string(self.answers.path().join(name))?;
        serde_json::from_str(&text).map_err(std::io::Error::other)
    }

    /// The name of an answer: that of the file, and a hash of its path, its content and everything that was asked.
    fn name(file: &Path, content: &str, settings: &str) -> String {
        let shown = file.display().to_string();
        let key = sha256_hex(format!("{shown}\n{content}\n{settings}").as_bytes());
        let stem = file.file_name().unwrap_or_default().to_string_lossy();
        let plain = |c: char| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '_' };
        let stem: String = stem.chars().map(plain).take(60).collect();
        format!("{stem}-{}.json", &key[..24])
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
