//! Rows of a study, kept in files: a study that is stopped goes on where it was.

use clap::Args;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// The rows in `folder/name.csv`, made if there is no such file.
///
/// # Errors
/// What `make` says; a file that cannot be written or read.
pub fn kept(
    folder: &Path,
    name: &str,
    make: impl FnOnce() -> Result<String, Box<dyn Error>>,
) -> Result<String, Box<dyn Error>> {
    let file = folder.join(format!("{name}.csv"));
    if !file.exists() {
        fs::create_dir_all(folder)?;
        let rows = make()?;
        // Written whole or not at all, so that a stopped run never leaves half of them.
        let part = file.with_extension("part");
        fs::write(&part, rows)?;
        fs::rename(&part, &file)?;
    }
    Ok(fs::read_to_string(&file)?)
}

/// What a study of families of maps is asked, and which of them.
#[derive(Args, Debug)]
pub struct Asked {
    /// Folder of the rows; with --page, of the tables
    pub folder: PathBuf,
    /// The families that the constants were fixed on
    #[arg(long, conflicts_with = "page")]
    tuning: bool,
    /// The families that were written down last
    #[arg(long, conflicts_with_all = ["page", "tuning"])]
    fresh: bool,
    /// Make the tables of the book from this CSV instead
    #[arg(long, value_name = "TABLE")]
    pub page: Option<PathBuf>,
}

/// The families of a study, in the order in which they were written down.
#[derive(Clone, Copy, Debug)]
pub struct Families {
    /// Those that constants were fixed on.
    pub tuning: &'static [&'static str],
    /// Those judged first.
    pub judged: &'static [&'static str],
    /// Those judged last, without a change after.
    pub fresh: &'static [&'static str],
}

impl Families {
    /// Those that are asked for; the ones judged first if nothing is said.
    pub fn of(&self, asked: &Asked) -> &'static [&'static str] {
        match (asked.tuning, asked.fresh) {
            (true, _) => self.tuning,
            (false, true) => self.fresh,
            (false, false) => self.judged,
        }
    }

    /// Where a family stands in a page: 0 for those judged last, 1 for those judged first, 2 for tuning.
    pub fn place(&self, family: &str) -> usize {
        if self.fresh.contains(&family) {
            0
        } else {
            1 + usize::from(self.tuning.contains(&family))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_made_once_and_never_by_half() {
        let folder = tempfile::tempdir().unwrap();
        let made = kept(folder.path(), "a", || Ok("1\n".into())).unwrap();
        assert_eq!(made, "1\n");
        assert_eq!(kept(folder.path(), "a", || Err("not again".into())).unwrap(), "1\n");
        assert!(kept(folder.path(), "b", || Err("no".into())).is_err());
        assert!(!folder.path().join("b.csv").exists());
    }
}
