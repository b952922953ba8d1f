//! Time against true error: every closed form, and the solver over methods, grids, precisions and
//! tolerances, on the built-in surfaces.
//!
//! `tradeoff` measures and prints a table as CSV; `tradeoff --page TABLE FOLDER` makes the figures and the page from
//! that table.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod measure;
mod page;

use measure::Plan;
use std::error::Error;
use std::path::Path;
use std::thread;
use studies::tradeoff::{HEADER, TradeoffRow};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => {}
        ["--page", table, folder] => return page::write(Path::new(table), Path::new(folder)),
        _ => return Err("tradeoff [--page TABLE FOLDER]".into()),
    }
    let plan = Plan::FULL;
    let threads = thread::available_parallelism().map_or(1, usize::from);
    println!("# Threads: {threads}. Slow methods end at {} FFT convolutions.", plan.most_pairs);
    println!("{HEADER}");
    measure::run(&plan, &mut |row: TradeoffRow| println!("{}", row.line()))
}
