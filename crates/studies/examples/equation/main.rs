//! A closed form for the real area: its surfaces and their deterministic solutions.
//!
//! `equation FOLDER` solves what is missing of the surfaces that the constants are fitted on,
//! `equation --judge FOLDER` those that they are judged on; one file of a row per map in FOLDER,
//! and all rows as CSV. Each may be stopped and started again.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod families;
mod measure;

use clap::Parser;
use families::Part;
use std::error::Error;
use std::fs;
use std::path::PathBuf;

/// A closed form for the real area: solves what is missing of its surfaces and prints all rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per map
    folder: PathBuf,
    /// The surfaces that the constants are judged on
    #[arg(long)]
    judge: bool,
    /// Only so many maps from the start of the list
    #[arg(long, default_value_t = usize::MAX)]
    first: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, judge, first } = Options::parse();
    fs::create_dir_all(&folder)?;
    let cases = families::cases(if judge { Part::Judge } else { Part::Fit });
    println!("{}", measure::header());
    for case in cases.iter().take(first) {
        let file = folder.join(format!("{}-{}.csv", case.family.name, case.draw.seed));
        if !file.exists() {
            let text = measure::row(case)? + "\n";
            // Written whole or not at all, so that a stopped run never leaves half a row.
            let part = file.with_extension("part");
            fs::write(&part, text)?;
            fs::rename(&part, &file)?;
        }
        print!("{}", fs::read_to_string(&file)?);
    }
    Ok(())
}
