//! Does what one map says of another hold where surfaces are unkind: sparse scratches, few hills, crops
//! that do not repeat and do not hold their longest waves?
//!
//! `sample FOLDER [MAPS]` makes so many maps of each family that was judged first, one file of rows per
//! family in FOLDER, skipping those already there, and prints all rows as CSV; `--tuning` does the same
//! with the families that the constants were fixed on, `--fresh` with those written down last.
//! `sample --page TABLE FOLDER` makes the tables of the book from both kinds of rows.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod families;
mod fresh;
mod judged;
mod measure;
mod page;
mod tuning;

use clap::Parser;
use rayon::prelude::*;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// Do finite-sample intervals hold on unkind surfaces? Prints rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per family; with --page, of the tables
    folder: PathBuf,
    /// Maps of each family
    #[arg(default_value = "30", conflicts_with = "page")]
    maps: usize,
    /// The families that the constants were fixed on
    #[arg(long, conflicts_with = "page")]
    tuning: bool,
    /// The families that were written down last
    #[arg(long, conflicts_with_all = ["page", "tuning"])]
    fresh: bool,
    /// Make the tables of the book from this CSV instead
    #[arg(long, value_name = "TABLE")]
    page: Option<PathBuf>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, maps, tuning, fresh, page } = Options::parse();
    if let Some(table) = page {
        return page::write(&table, &folder);
    }
    let families: &[&str] = match (tuning, fresh) {
        (true, _) => &tuning::TUNING,
        (false, true) => &fresh::FRESH,
        (false, false) => &judged::JUDGED,
    };
    fs::create_dir_all(&folder)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work =
            |family: &&str| kept(&folder, family, maps).map_err(|e| format!("{family}: {e}"));
        families.par_iter().with_max_len(1).map(work).collect()
    });
    println!("{}", measure::HEADER);
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}

/// The rows in the file of this family, made if there is none.
fn kept(folder: &Path, family: &str, maps: usize) -> Result<String, Box<dyn Error>> {
    let plain: String = family.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    let file = folder.join(format!("{plain}.csv"));
    if !file.exists() {
        let rows = measure::family(family, maps)?;
        // Written whole or not at all, so that a stopped run never leaves half a family.
        let part = file.with_extension("part");
        fs::write(&part, rows)?;
        fs::rename(&part, &file)?;
    }
    Ok(fs::read_to_string(&file)?)
}
