//! Real area against load from light load to full contact, on random surfaces of many breadths
//! of spectrum.
//!
//! `kappa FOLDER` solves what is missing, one file of rows per map in FOLDER, and prints all rows
//! as CSV. It may be stopped and started again; the result is the same on any number of threads.
//!
//! `kappa --page TABLE FOLDER` makes the figures and tables of the book from that CSV.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod measure;
mod page;

use clap::Parser;
use std::error::Error;
use std::path::PathBuf;
use studies::light_load::{HEADER, Row};
use studies::rows::kept;

/// Real area against load from light load to full contact: solves what is missing and prints all
/// rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per map; with --page, of figures and tables
    folder: PathBuf,
    /// Make figures and tables of the book from this CSV instead
    #[arg(long, value_name = "TABLE")]
    page: Option<PathBuf>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, page } = Options::parse();
    if let Some(table) = page {
        return page::write(&table, &folder);
    }
    println!("{HEADER}");
    let cases = measure::cases();
    for (index, case) in cases.iter().enumerate() {
        let rows = kept(&folder, &format!("{index:03}"), || {
            eprintln!("{} of {}: {case:?}", index + 1, cases.len());
            Ok(case.solve()?.iter().map(|row: &Row| row.line() + "\n").collect())
        })?;
        print!("{rows}");
    }
    Ok(())
}
