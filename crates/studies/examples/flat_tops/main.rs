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
mod second;
mod third;
mod tuning;

use clap::Parser;
use rayon::prelude::*;
use std::error::Error;
use studies::rows::{Asked, Families, kept};

/// Do the error bars hold on maps that are not smooth between their points? Prints rows as CSV
#[derive(Parser)]
struct Options {
    #[command(flatten)]
    asked: Asked,
    /// Maps of each family
    #[arg(default_value = "2", conflicts_with = "page")]
    maps: usize,
}

/// Its families.
const FAMILIES: Families =
    Families { tuning: &tuning::TUNING, judged: &judged::JUDGED, fresh: &fresh::FRESH };

fn main() -> Result<(), Box<dyn Error>> {
    let Options { asked, maps } = Options::parse();
    let folder = &asked.folder;
    if let Some(table) = &asked.page {
        return page::write(table, folder, FAMILIES);
    }
    let families = FAMILIES.of(&asked);
    let list: Vec<(usize, &str)> =
        (1..=maps).flat_map(|map| families.iter().map(move |family| (map, *family))).collect();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work = |&(map, family): &(usize, &str)| {
            let name = format!("{}-{map:02}", family.replace(' ', "-"));
            kept(folder, &name, || measure::map(family, map))
                .map_err(|e| format!("{family} {map}: {e}"))
        };
        list.par_iter().with_max_len(1).map(work).collect()
    });
    println!("{}", measure::header());
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}
