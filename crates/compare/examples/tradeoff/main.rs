//! Time against true error: every closed form, and the solver over methods, grids, precisions and
//! tolerances, on the built-in surfaces.
//!
//! `tradeoff [--quick]` measures and prints a table as CSV; `--quick` does it on 128 x 128 points,
//! in seconds. `tradeoff --page TABLE FOLDER` makes the figures and the page from that table,
//! `tradeoff --repeat TABLE SECOND` prints what the book says of a second table beside the first.
#![allow(clippy::print_stdout, reason = "its output is the table")]

mod measure;
mod page;
mod repeat;

use compare::tradeoff::{HEADER, Row, Table};
use measure::Plan;
use std::error::Error;
use std::path::Path;
use std::{env, fs, thread};

const USAGE: &str =
    "usage: tradeoff [--quick] | tradeoff --page TABLE FOLDER | tradeoff --repeat TABLE SECOND";

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let plan = match args[..] {
        [] => Plan::FULL,
        ["--quick"] => Plan::QUICK,
        ["--page", table, folder] => return page::write(Path::new(table), Path::new(folder)),
        ["--repeat", first, second] => {
            let read = |path: &str| -> Result<Table, Box<dyn Error>> {
                Ok(Table::parse(&fs::read_to_string(path)?)?)
            };
            print!("{}", repeat::compare(&read(first)?, &read(second)?));
            return Ok(());
        }
        _ => return Err(USAGE.into()),
    };
    let threads = thread::available_parallelism().map_or(1, usize::from);
    println!("# Threads: {threads}. Slow methods were stopped at {} FFT pairs.", plan.most_pairs);
    println!("{HEADER}");
    measure::run(&plan, &mut |row: Row| println!("{}", row.line()))
}
