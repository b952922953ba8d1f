//! An ensemble of surfaces, every closed-form model against the deterministic answer on each.
//!
//! `survey FOLDER [FIRST]` works through the ensemble (or its FIRST surfaces), one file of rows
//! per surface in FOLDER, skipping those already there, and prints all rows as CSV. The result is
//! the same whenever it is stopped and resumed and on any number of threads.
//!
//! `survey --page TABLE FOLDER` makes the figures and the summary of the book from that CSV.
#![allow(clippy::print_stdout, reason = "its output is the table")]

#[path = "../common/drawing.rs"]
mod drawing;
mod ensemble;
mod measure;
mod page;

use compare::survey::{Row, header};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = env::args().skip(1);
    let usage = "usage: survey FOLDER [FIRST] | survey --page TABLE FOLDER";
    let folder = args.next().ok_or(usage)?;
    if folder == "--page" {
        let (table, out) = (args.next().ok_or(usage)?, args.next().ok_or(usage)?);
        return page::write(Path::new(&table), Path::new(&out));
    }
    let recipes = ensemble::recipes();
    let first = args.next().map_or(Ok(recipes.len()), |n| n.parse())?;
    fs::create_dir_all(&folder)?;
    let labels: Vec<&str> = measure::models().iter().map(|m| m.name).collect();
    println!("{}", header(&labels));
    for (index, recipe) in recipes.iter().enumerate().take(first) {
        let file = Path::new(&folder).join(format!("{index:03}.csv"));
        if !file.exists() {
            let rows = measure::surface(index, recipe)?;
            let text: String = rows.iter().map(|row: &Row| row.line() + "\n").collect();
            // Written whole or not at all, so that a stopped run never leaves half a surface.
            let part = file.with_extension("part");
            fs::write(&part, text)?;
            fs::rename(&part, &file)?;
            eprintln!("{} of {first}: {recipe:?}", index + 1);
        }
        print!("{}", fs::read_to_string(&file)?);
    }
    Ok(())
}
