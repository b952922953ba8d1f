//! Do the error bars hold? Many surfaces, each answer against the same surface on four times as
//! many points along each side, and against other realisations of it.
//!
//! `budget FOLDER [FIRST]` works through the surfaces (or the FIRST of them) on two threads, one
//! file of rows per surface in FOLDER, skipping those already there, and prints all rows as CSV.
//! The result is the same whenever it is stopped and resumed and on any number of threads.
//!
//! `budget --fresh FOLDER` does the same with maps that took no part in fixing the constants,
//! `budget --realisations FOLDER` with realisations of families of surfaces;
//! `budget --page TABLE FRESH REALISATIONS FOLDER` makes figure and tables of the book from all.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod ensemble;
mod families;
mod fresh;
mod measure;
mod page;
mod realisations;
mod sample_page;
mod table;

use clap::Parser;
use measure::Surface;
use rayon::prelude::*;
use std::error::Error;
use std::path::{Path, PathBuf};
use studies::rows::kept;

/// Do the error bars hold? Works through what is left of an ensemble and prints all rows as CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per surface; with --page, of figure and tables
    folder: PathBuf,
    /// Only so many surfaces from the start of the ensemble
    #[arg(conflicts_with_all = ["realisations", "page"])]
    first: Option<usize>,
    /// Maps that took no part in fixing the constants
    #[arg(long, conflicts_with_all = ["realisations", "page"])]
    fresh: bool,
    /// Realisations of families of surfaces
    #[arg(long, conflicts_with = "page")]
    realisations: bool,
    /// Make figure and tables of the book from the three CSVs instead
    #[arg(long, num_args = 3, value_names = ["TABLE", "FRESH", "REALISATIONS"])]
    page: Option<Vec<PathBuf>>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, first, fresh, realisations, page } = Options::parse();
    let first = first.unwrap_or(usize::MAX);
    if realisations {
        return sample(&folder);
    }
    match page.as_deref() {
        Some([table, fresh, sample]) => page::write([table, fresh, sample], &folder),
        _ if fresh => study(&folder, &fresh::recipes(), first),
        _ => study(&folder, &ensemble::recipes(), first),
    }
}

/// The rows of the first of these surfaces.
fn study<S: Surface>(folder: &Path, surfaces: &[S], first: usize) -> Result<(), Box<dyn Error>> {
    let surfaces = &surfaces[..first.min(surfaces.len())];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    let rows: Vec<Result<String, String>> = pool.install(|| {
        let work = |(index, surface): (usize, &S)| {
            kept(folder, &format!("{index:03}"), || measure::surface(index, surface))
                .map_err(|e| e.to_string())
        };
        surfaces.par_iter().enumerate().with_max_len(1).map(work).collect()
    });
    println!("{}", measure::header());
    for rows in rows {
        print!("{}", rows?);
    }
    Ok(())
}

/// All realisations of all families, one file per family.
fn sample(folder: &Path) -> Result<(), Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build()?;
    println!("{}", realisations::header());
    for family in 0..families::FAMILIES.len() {
        let rows = kept(folder, &format!("{family:03}"), || {
            let one = |seed| realisations::realisation(family, seed).map_err(|e| e.to_string());
            let all: Result<Vec<String>, String> =
                pool.install(|| (0..realisations::REALISATIONS).into_par_iter().map(one).collect());
            Ok(all?.concat())
        })?;
        print!("{rows}");
    }
    Ok(())
}
