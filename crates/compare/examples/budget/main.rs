//! Do the error bars hold? Many surfaces, each answer against the same surface on four times as
//! many points along each side, and against other realisations of it.
//!
//! `budget FOLDER [FIRST]` works through the surfaces (or the FIRST of them) on two threads, one
//! file of rows per surface in FOLDER, skipping those already there, and prints all rows as CSV.
//! The result is the same whenever it is stopped and resumed and on any number of threads.
//!
//! `budget --realisations FOLDER` does the same with realisations of families of surfaces;
//! `budget --page TABLE REALISATIONS FOLDER` makes figure and tables of the book from both.
#![allow(clippy::print_stdout, reason = "its output is the table")]

#[path = "../common/drawing.rs"]
mod drawing;
mod ensemble;
mod measure;
mod page;
mod realisations;

use rayon::prelude::*;
use std::error::Error;
use std::path::Path;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = env::args().skip(1);
    let folder = args.next().ok_or("usage: budget FOLDER [FIRST]")?;
    if folder == "--realisations" {
        return sample(Path::new(&args.next().ok_or("usage: budget --realisations FOLDER")?));
    }
    if folder == "--page" {
        let usage = "usage: budget --page TABLE REALISATIONS FOLDER";
        let [table, sample, out] = [args.next(), args.next(), args.next()];
        let (table, sample) = (table.ok_or(usage)?, sample.ok_or(usage)?);
        let out = out.ok_or(usage)?;
        return page::write(Path::new(&table), Path::new(&sample), Path::new(&out));
    }
    let recipes = ensemble::recipes();
    let first = args.next().map_or(Ok(recipes.len()), |n| n.parse())?.min(recipes.len());
    fs::create_dir_all(&folder)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work = |index: usize| {
            kept(Path::new(&folder), index, || measure::surface(index, &recipes[index]))
        };
        (0..first)
            .into_par_iter()
            .with_max_len(1)
            .map(|i| work(i).map_err(|e| e.to_string()))
            .collect()
    });
    println!("{}", measure::header());
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}

/// The rows in the file of this number, made if there is none.
fn kept(
    folder: &Path,
    index: usize,
    make: impl FnOnce() -> Result<String, Box<dyn Error>>,
) -> Result<String, Box<dyn Error>> {
    let file = folder.join(format!("{index:03}.csv"));
    if !file.exists() {
        let rows = make()?;
        // Written whole or not at all, so that a stopped run never leaves half a surface.
        let part = file.with_extension("part");
        fs::write(&part, rows)?;
        fs::rename(&part, &file)?;
    }
    Ok(fs::read_to_string(&file)?)
}

/// All realisations of all families, one file per family.
fn sample(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    println!("{}", realisations::header());
    for family in 0..realisations::FAMILIES.len() {
        let rows = kept(folder, family, || {
            let one = |seed| realisations::realisation(family, seed).map_err(|e| e.to_string());
            let all: Result<Vec<String>, String> =
                pool.install(|| (0..realisations::REALISATIONS).into_par_iter().map(one).collect());
            Ok(all?.concat())
        })?;
        print!("{rows}");
    }
    Ok(())
}
