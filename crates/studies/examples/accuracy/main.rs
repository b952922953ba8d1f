//! Does `--accuracy` keep its word? Every surface of an ensemble that took no part in the
//! calibration, at three loads and five requests, against a tight solution on eight times as many
//! points per side.
//!
//! `accuracy FOLDER [EVERY]` works through the ensemble (or every EVERY-th of it), one file of rows
//! per surface in FOLDER, skipping those already there, and prints all rows as CSV. The result is
//! the same whenever it is stopped and resumed and on any number of threads.
//!
//! `accuracy --page TABLE FOLDER` makes figure and tables of the book from that CSV.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod ensemble;
mod measure;
mod page;

use clap::Parser;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use studies::rows::kept;

/// Surfaces worked on at a time; each takes up to half a gigabyte.
const WORKERS: usize = 2;

/// Does --accuracy keep its word? Works through what is left of an ensemble and prints all rows as
/// CSV
#[derive(Parser)]
struct Options {
    /// Folder of the rows, one file per surface; with --page, of figure and tables
    folder: PathBuf,
    /// Only every so manieth surface
    #[arg(default_value = "1", conflicts_with = "page")]
    every: NonZeroUsize,
    /// Make figure and tables of the book from this CSV instead
    #[arg(long, value_name = "TABLE")]
    page: Option<PathBuf>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let Options { folder, every, page } = Options::parse();
    if let Some(table) = page {
        return page::write(&table, &folder);
    }
    let recipes = ensemble::recipes();
    let chosen: Vec<usize> = (0..recipes.len()).step_by(every.get()).collect();
    let rows = |index: usize| {
        let recipe = &recipes[index];
        kept(&folder, &format!("{index:03}"), || {
            eprintln!("{} of {}: {recipe:?}", index + 1, recipes.len());
            measure::surface(index, recipe)
        })
        .map_err(|e| format!("{recipe:?}: {e}"))
    };
    // Every ninth first, then every third: a run that is stopped has some of every family.
    let mut order = chosen.clone();
    order.sort_by_key(|index| [9, 3, 1].iter().position(|step| index % step == 0));
    let next = AtomicUsize::new(0);
    let worker = || -> Result<(), String> {
        while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            rows(index)?;
        }
        Ok(())
    };
    thread::scope(|scope| {
        let workers: Vec<_> = (0..WORKERS).map(|_| scope.spawn(worker)).collect();
        let joined = workers.into_iter().map(|w| w.join().unwrap_or(Err("a worker fell".into())));
        joined.collect::<Result<(), String>>()
    })?;
    println!("{}", measure::HEADER);
    for index in chosen {
        print!("{}", rows(index)?);
    }
    Ok(())
}
