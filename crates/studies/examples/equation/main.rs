//! A closed form for the real area: its surfaces and their deterministic solutions.
//!
//! `equation FOLDER` solves what is missing of the surfaces that the constants are fitted on,
//! `equation --judge FOLDER` those that they are judged on; one file of a row per map in FOLDER,
//! and all rows as CSV. Each may be stopped and started again.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod brought;
mod chance;
mod families;
mod fields;
mod fit;
mod further;
mod instrument;
mod measure;
mod met;
mod page;
mod table;
mod unkind;
mod unseen;

use clap::Parser;
use families::{Case, Part};
use rayon::prelude::*;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// A closed form for the real area: solves what is missing of its surfaces and prints all rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per map
    folder: PathBuf,
    /// The surfaces that the constants are judged on
    #[arg(long)]
    judge: bool,
    /// Fit the constants to this table and print them
    #[arg(long, value_name = "TABLE")]
    fit: Option<PathBuf>,
    /// Solve maps of one spectrum that differ by chance alone instead, and print them
    #[arg(long)]
    chance: bool,
    /// Make the tables of the book from the fitted and the judged table and that of chance instead, into FOLDER
    #[arg(long, num_args = 3, value_names = ["FITTED", "JUDGED", "CHANCE"])]
    page: Option<Vec<PathBuf>>,
    /// Only so many maps from the start of the list
    #[arg(long, default_value_t = usize::MAX)]
    first: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, judge, fit, chance, page, first } = Options::parse();
    if chance {
        print!("{}", chance::rows()?);
        return Ok(());
    }
    if let Some(table) = fit {
        return constants(&table);
    }
    if let Some([fitted, judged, chance]) = page.as_deref() {
        return page::write([fitted, judged, chance], &folder);
    }
    fs::create_dir_all(&folder)?;
    let part = if judge { Part::Judge } else { Part::Fit };
    let cases: Vec<Case> = families::cases(part).into_iter().take(first).collect();
    println!("{}", measure::header());
    let rows: Vec<Result<String, String>> =
        cases.par_iter().map(|case| kept(&folder, case).map_err(|e| e.to_string())).collect();
    for row in rows {
        print!("{}", row?);
    }
    Ok(())
}

/// The row of this map. Its solutions are kept in a file of its own, made if there is none; what the map
/// tells is found anew, so that the law may ask for more without another solution.
fn kept(folder: &Path, case: &Case) -> Result<String, Box<dyn Error>> {
    let file = folder.join(format!("{}-{}.csv", case.family.name, case.draw.seed));
    if !file.exists() {
        let text = measure::solutions(case)?;
        // Written whole or not at all, so that a stopped run never leaves half a row.
        let part = file.with_extension("part");
        fs::write(&part, text)?;
        fs::rename(&part, &file)?;
    }
    Ok(measure::tells(case)? + &fs::read_to_string(&file)? + "\n")
}

/// Fits everything and prints it as the constants of the crate.
fn constants(table: &Path) -> Result<(), Box<dyn Error>> {
    let rows = table::read(table)?;
    let (numbers, map) = (fit::numbers(&rows), fit::map(&rows));
    let half = fit::spread(&fit::number_misses(&rows, &numbers), 0.95);
    let own = fit::spread(&fit::left_out(&rows)?, fit::SHARE);
    println!("numbers {numbers:?}");
    println!("map {map:?}");
    println!("half width of numbers {half:.3?}");
    for (name, share) in fit::held(&fit::left_out(&rows)?, &own) {
        println!("  {name}: {:.1} % held when left out", 100.0 * share);
    }
    println!("half width of maps {own:.3?}");
    Ok(())
}
