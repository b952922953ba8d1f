//! An ensemble of surfaces, every closed-form model against the deterministic answer on each.
//!
//! `survey FOLDER [FIRST]` works through the ensemble (or its FIRST surfaces), one file of rows
//! per surface in FOLDER, skipping those already there, and prints all rows as CSV. The result is
//! the same whenever it is stopped and resumed and on any number of threads.
//!
//! `survey --page TABLE FOLDER` makes the figures and the summary of the book from that CSV.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod ensemble;
mod measure;
mod page;

use clap::Parser;
use compare::survey::{Row, header};
use std::error::Error;
use std::path::PathBuf;
use studies::rows::kept;

/// Every closed form against the deterministic answer on an ensemble of surfaces: works through
/// what is left of it and prints all rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per surface; with --page, of figures and summary
    folder: PathBuf,
    /// Only so many surfaces from the start of the ensemble
    #[arg(conflicts_with = "page")]
    first: Option<usize>,
    /// Make figures and summary of the book from this CSV instead
    #[arg(long, value_name = "TABLE")]
    page: Option<PathBuf>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, first, page } = Options::parse();
    if let Some(table) = page {
        return page::write(&table, &folder);
    }
    let recipes = ensemble::recipes();
    let first = first.unwrap_or(recipes.len());
    let labels: Vec<&str> = measure::models().iter().map(|m| m.name.as_ref()).collect();
    println!("{}", header(&labels));
    for (index, recipe) in recipes.iter().enumerate().take(first) {
        let rows = kept(&folder, &format!("{index:03}"), || {
            eprintln!("{} of {first}: {recipe:?}", index + 1);
            let rows = measure::surface(index, recipe)?;
            Ok(rows.iter().map(|row: &Row| row.line() + "\n").collect())
        })?;
        print!("{rows}");
    }
    Ok(())
}
