//! Do the error bars hold where a surface is not smooth between its points? Families of maps by
//! formula: worn, clipped, stamped, turned, creased, spiky, textured, dusty, scratched, and smooth
//! ones beside them.
//!
//! `flat_tops FOLDER [MAPS]` works through so many maps of the families that took no part in fixing
//! anything, one file of rows per map in FOLDER, skipping those already there, and prints all rows as
//! CSV; `--tuning` does the same with those that the constants were fixed on, `--fresh` with those written
//! down last.
//! `flat_tops --page TABLE FOLDER` makes the tables of the book from both kinds of rows.
#![allow(clippy::print_stdout, reason = "its output is the table")]

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

/// Do the error bars hold on maps that are not smooth between their points? Prints rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per map; with --page, of the tables
    folder: PathBuf,
    /// Maps of each family
    #[arg(default_value = "2", conflicts_with = "page")]
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
    let list: Vec<(usize, &str)> =
        (1..=maps).flat_map(|map| families.iter().map(move |family| (map, *family))).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work = |&(map, family): &(usize, &str)| {
            kept(&folder, family, map).map_err(|e| format!("{family} {map}: {e}"))
        };
        list.par_iter().with_max_len(1).map(work).collect()
    });
    println!("{}", measure::header());
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}

/// The rows in the file of this map, made if there is none.
fn kept(folder: &Path, family: &str, map: usize) -> Result<String, Box<dyn Error>> {
    let file = folder.join(format!("{}-{map:02}.csv", family.replace(' ', "-")));
    if !file.exists() {
        let rows = measure::map(family, map)?;
        // Written whole or not at all, so that a stopped run never leaves half a map.
        let part = file.with_extension("part");
        fs::write(&part, rows)?;
        fs::rename(&part, &file)?;
    }
    Ok(fs::read_to_string(&file)?)
}
