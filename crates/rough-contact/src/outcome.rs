//! How the command ends: standard output, standard error, exit status; and the files it writes, never over an existing one
//! unless --force.

pub(crate) use rough_contact::front_end::Failure;
use serde_json::{Value, json};
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// An answer: the text a person reads and the object a script reads.
pub(crate) struct Reply {
    pub(crate) text: String,
    pub(crate) json: Value,
    /// What went wrong although there is something to print.
    pub(crate) trouble: Option<Failure>,
}

impl Reply {
    pub(crate) fn new(text: String, json: Value) -> Self {
        Self { text, json, trouble: None }
    }
}

/// Bad usage, as clap says it, in one paragraph.
pub(crate) fn usage(error: &clap::Error) -> Failure {
    let text = error.to_string();
    let text = text.trim().trim_start_matches("error: ");
    Failure::refused("usage", text)
}

/// A refusal of what a file is or holds.
pub(crate) fn unfit(path: &Path, kind: &str, why: impl std::fmt::Display) -> Failure {
    Failure::refused(kind, format!("{}: {why}", path.display()))
}

fn exists(path: &Path) -> Failure {
    let message = format!(
        "{} exists and would be overwritten; give --force to replace it, or another name",
        path.display()
    );
    Failure::refused("output_exists", message)
}

fn unwritable(path: &Path, error: &std::io::Error) -> Failure {
    let message = format!(
        "{} cannot be written: {error}; choose a folder that exists and may be written to",
        path.display()
    );
    Failure::incomplete("output", message)
}

/// Writes a line to standard error. Who closed it does not want it.
pub(crate) fn tell(line: &str) {
    let _ = writeln!(std::io::stderr(), "{line}");
}

/// Writes help or version, as far as the reader wants it.
pub(crate) fn show(help: &str) {
    let mut stdout = std::io::stdout().lock();
    let _ = stdout.write_all(help.as_bytes()).and_then(|()| stdout.flush());
}

/// Writes the reply or the failure and chooses the exit status.
pub(crate) fn finish(result: Result<Reply, Failure>, json: bool) -> ExitCode {
    let (text, object, failure) = match result {
        Ok(mut reply) => {
            if let Some(trouble) = &reply.trouble {
                reply.json["error"] = trouble.json();
            }
            (reply.text, reply.json, reply.trouble)
        }
        Err(failure) => (String::new(), json!({ "error": failure.json() }), Some(failure)),
    };
    let out = if json { format!("{object:#}\n") } else { text };
    let mut stdout = std::io::stdout().lock();
    // A reader that closes the pipe early, as `head` does, has seen what it wanted.
    let written = stdout.write_all(out.as_bytes()).and_then(|()| stdout.flush());
    if let Some(failure) = failure {
        tell(&format!("rough-contact: {}", failure.message));
        return ExitCode::from(failure.status);
    }
    match written {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            tell(&format!("rough-contact: standard output cannot be written: {error}"));
            ExitCode::from(1)
        }
        _ => ExitCode::SUCCESS,
    }
}

/// A folder that will receive files of known names.
pub(crate) struct Folder {
    pub(crate) path: PathBuf,
}

impl Folder {
    /// Looks for what is in the way before any work is done. A folder that is not there yet is made with its
    /// first file, so that a run which is stopped leaves none.
    pub(crate) fn prepare(path: &Path, names: &[String], force: bool) -> Result<Self, Failure> {
        if !force {
            for name in names {
                let file = path.join(name);
                if file.symlink_metadata().is_ok() {
                    return Err(exists(&file));
                }
            }
        }
        let there = path.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("."));
        let probe = there.join(format!(".rough-contact-probe.{}", std::process::id()));
        File::create(&probe).map_err(|e| unwritable(path, &e))?;
        // The probe has told what it was for; if it cannot be removed, writing will tell.
        let _ = fs::remove_file(&probe);
        Ok(Self { path: path.to_owned() })
    }

    /// The same for the files of `count` loads or profiles: those of an earlier run with another number of them
    /// are in the way too, and with `force` removed.
    pub(crate) fn numbered(
        path: &Path,
        names: impl Fn(usize) -> Vec<String>,
        count: usize,
        force: bool,
    ) -> Result<Self, Failure> {
        let own = names(count);
        let most = count + path.read_dir().map_or(0, Iterator::count);
        let is_stale = |name: &String| !own.contains(name) && path.join(name).exists();
        let stale: Vec<String> = [1, most].into_iter().flat_map(names).filter(is_stale).collect();
        let folder = Self::prepare(path, &[own, stale.clone()].concat(), force)?;
        for file in stale.iter().map(|name| path.join(name)) {
            fs::remove_file(&file).map_err(|e| unwritable(&file, &e))?;
        }
        Ok(folder)
    }

    pub(crate) fn write_all(
        &self,
        files: impl IntoIterator<Item = (impl AsRef<str>, String)>,
    ) -> Result<(), Failure> {
        files.into_iter().try_for_each(|(name, text)| {
            self.write(name.as_ref(), |out| out.write_all(text.as_bytes()))
        })
    }

    pub(crate) fn write(
        &self,
        name: &str,
        content: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>,
    ) -> Result<(), Failure> {
        fs::create_dir_all(&self.path).map_err(|e| unwritable(&self.path, &e))?;
        write(&self.path.join(name), content)
    }
}

/// Looks whether `path` may be written, before any work is done.
pub(crate) fn check(path: &Path, force: bool) -> Result<(), Failure> {
    match path.symlink_metadata() {
        Ok(there) if there.is_dir() => {
            let error = std::io::Error::new(std::io::ErrorKind::IsADirectory, "it is a directory");
            Err(unwritable(path, &error))
        }
        Ok(_) if !force => Err(exists(path)),
        _ => Ok(()),
    }
}

/// Writes `content` to `path`. A file that could not be finished is removed.
pub(crate) fn write(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let mut partial = path.file_name().unwrap_or_default().to_owned();
    // Two files of the same content have the same answer, which two threads may write at once.
    let thread = std::thread::current().id();
    partial.push(format!(".{}-{thread:?}.partial", std::process::id()));
    let partial = path.with_file_name(partial);
    let result = File::create(&partial).and_then(|file| {
        let mut writer = BufWriter::new(file);
        content(&mut writer)?;
        writer.flush()?;
        fs::rename(&partial, path)
    });
    result.map_err(|error| {
        // It may not exist; the error that matters is the first.
        let _ = fs::remove_file(&partial);
        unwritable(path, &error)
    })
}
