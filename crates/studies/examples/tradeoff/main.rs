//! Time against true error: every closed form, and the solver over methods, grids, precisions and
//! tolerances, on the built-in surfaces.
//!
//! `tradeoff` measures and prints a table as CSV; `tradeoff --page TABLE FOLDER` makes the figures and the page from
//! that table.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod measure;
mod page;

use clap::Parser;
use measure::Plan;
use std::error::Error;
use std::path::PathBuf;
use std::thread;
use studies::tradeoff::{HEADER, TradeoffRow};

/// Time against true error of every way to an answer: measures, and prints a table as CSV
#[derive(Parser)]
struct TradeoffArguments {
    /// Make figures and page of the book from a table instead
    #[arg(long, num_args = 2, value_names = ["TABLE", "FOLDER"])]
    page: Option<Vec<PathBuf>>,
}

fn main() -> Result<(), Box<dyn Error>> {
    if let Some([table, folder]) = TradeoffArguments::parse().page.as_deref() {
        return page::write(table, folder);
    }
    let plan = Plan::FULL;
    let threads = thread::available_parallelism().map_or(1, usize::from);
    println!("# Threads: {threads}. Slow methods end at {} FFT convolutions.", plan.most_pairs);
    println!("{HEADER}");
    measure::run(&plan, &mut |row: TradeoffRow| println!("{}", row.line()))
}
