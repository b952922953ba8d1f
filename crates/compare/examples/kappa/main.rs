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

use compare::light_load::{HEADER, Row};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = env::args().skip(1);
    let usage = "usage: kappa FOLDER | kappa --page TABLE FOLDER";
    let folder = args.next().ok_or(usage)?;
    if folder == "--page" {
        let (table, out) = (args.next().ok_or(usage)?, args.next().ok_or(usage)?);
        return page::write(Path::new(&table), Path::new(&out));
    }
    fs::create_dir_all(&folder)?;
    println!("{HEADER}");
    let cases = measure::cases();
    for (index, case) in cases.iter().enumerate() {
        let file = Path::new(&folder).join(format!("{index:03}.csv"));
        if !file.exists() {
            let text: String = case.solve()?.iter().map(|row: &Row| row.line() + "\n").collect();
            // Written whole or not at all, so that a stopped run never leaves half a map.
            let part = file.with_extension("part");
            fs::write(&part, text)?;
            fs::rename(&part, &file)?;
            eprintln!("{} of {}: {case:?}", index + 1, cases.len());
        }
        print!("{}", fs::read_to_string(&file)?);
    }
    Ok(())
}
