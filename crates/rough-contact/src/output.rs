//! Files the command writes: never over an existing one unless --force.

use crate::outcome::{self, Failure};
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// A folder that will receive files of known names.
pub(crate) struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Looks for what is in the way before any work is done. A folder that is not there yet is made with its
    /// first file, so that a run which is stopped leaves none.
    pub(crate) fn prepare(path: &Path, names: &[String], force: bool) -> Result<Self, Failure> {
        if !force {
            for name in names {
                let file = path.join(name);
                if file.symlink_metadata().is_ok() {
                    return Err(outcome::exists(&file));
                }
            }
        }
        let there = path.ancestors().find(|folder| folder.exists()).unwrap_or(Path::new("."));
        let probe = there.join(format!(".rough-contact-probe.{}", std::process::id()));
        File::create(&probe).map_err(|e| outcome::unwritable(path, &e))?;
        // The probe has told what it was for; if it cannot be removed, writing will tell.
        let _ = fs::remove_file(&probe);
        Ok(Self { path: path.to_owned() })
    }

    pub(crate) fn path(&self) -> &Path {
        &self.path
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
        fs::create_dir_all(&self.path).map_err(|e| outcome::unwritable(&self.path, &e))?;
        write(&self.path.join(name), content)
    }
}

/// Looks whether `path` may be written, before any work is done.
pub(crate) fn check(path: &Path, force: bool) -> Result<(), Failure> {
    match path.symlink_metadata() {
        Ok(there) if there.is_dir() => {
            let error = std::io::Error::new(std::io::ErrorKind::IsADirectory, "it is a directory");
            Err(outcome::unwritable(path, &error))
        }
        Ok(_) if !force => Err(outcome::exists(path)),
        _ => Ok(()),
    }
}

/// Writes `content` to `path`. A file that could not be finished is removed.
pub(crate) fn write(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>,
) -> Result<(), Failure> {
    let mut partial = path.file_name().unwrap_or_default().to_owned();
    partial.push(format!(".{}.partial", std::process::id()));
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
        outcome::unwritable(path, &error)
    })
}
