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
mod later;
mod measure;
mod page;
mod tuning;

use clap::Parser;
use rayon::prelude::*;
use std::error::Error;
use studies::rows::{Asked, Families, kept};

/// Do finite-sample intervals hold on unkind surfaces? Prints rows as CSV
#[derive(Parser)]
struct Options {
    #[command(flatten)]
    asked: Asked,
    /// Maps of each family
    #[arg(default_value = "30", conflicts_with = "page")]
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
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work = |family: &&str| {
            let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
            let name: String = family.chars().map(plain).collect();
            kept(folder, &name, || measure::family(family, maps))
                .map_err(|e| format!("{family}: {e}"))
        };
        families.par_iter().with_max_len(1).map(work).collect()
    });
    println!("{}", measure::HEADER);
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}
