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

use std::error::Error;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::{env, fs, thread};

/// Surfaces worked on at a time; each takes up to half a gigabyte.
const WORKERS: usize = 2;

fn main() -> Result<(), Box<dyn Error>> {
    let mut args = env::args().skip(1);
    let usage = "usage: accuracy FOLDER [EVERY] | accuracy --page TABLE FOLDER";
    let folder = args.next().ok_or(usage)?;
    if folder == "--page" {
        let (table, out) = (args.next().ok_or(usage)?, args.next().ok_or(usage)?);
        return page::write(Path::new(&table), Path::new(&out));
    }
    let recipes = ensemble::recipes();
    let every = args.next().map_or(Ok(1), |n| n.parse::<usize>())?.max(1);
    let chosen: Vec<usize> = (0..recipes.len()).step_by(every).collect();
    fs::create_dir_all(&folder)?;
    let file = |index: usize| Path::new(&folder).join(format!("{index:03}.csv"));
    let work = |index: usize| -> Result<(), String> {
        let recipe = &recipes[index];
        if file(index).exists() {
            return Ok(());
        }
        let rows = measure::surface(index, recipe).map_err(|e| format!("{recipe:?}: {e}"))?;
        // Written whole or not at all, so that a stopped run never leaves half a surface.
        let part = file(index).with_extension("part");
        let written = fs::write(&part, rows).and_then(|()| fs::rename(&part, file(index)));
        eprintln!("{} of {}: {recipe:?}", index + 1, recipes.len());
        written.map_err(|e| e.to_string())
    };
    // Every ninth first, then every third: a run that is stopped has some of every family.
    let mut order = chosen.clone();
    order.sort_by_key(|index| [9, 3, 1].iter().position(|step| index % step == 0));
    let next = AtomicUsize::new(0);
    let worker = || -> Result<(), String> {
        while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            work(index)?;
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
        print!("{}", fs::read_to_string(file(index))?);
    }
    Ok(())
}
