//! Developer tasks: `cargo xtask <task>`. One `match`, one file per task.
#![allow(clippy::print_stdout, reason = "a command-line tool prints")]

mod bench;
mod ci;
mod circles;
mod compare;
mod costs;
mod counters;
mod coverage;
mod dependencies;
mod extremes;
mod features;
mod figures;
mod generated;
mod licences;
mod release;
mod shell;
mod strangers;
mod tables;
mod tidy;
mod tradeoff;
mod validate;
mod web;

use shell::{TaskResult, released};
use std::process::ExitCode;

const USAGE: &str = "
  compare [FILE.. OPTIONS]    every model on surfaces; without arguments the built-in ones, into target/compare
  figures [--check]           the figures of README and book
  bench [--check | ARGS]      the benchmarks, their table into the book
  study costs                 what each crate brings along and allocates
  study coverage              how often the intervals cover the error (ten minutes)
  study extremes              models, statistics and solver at extreme inputs
  study tables                the tables of models and of file formats
  study tradeoff [--figures-only]
                              time against true error (ten minutes, idle machine)
  surfaces --dir DIR --expected FILE
                              files of instruments against expected values, one line each
  validate [--check]          the solver against exact solutions, into the book
  check                       tidy, features and strangers
  check tidy                  layers, circles of files, pages, file lengths, limits of xtask/counters.toml
  check features              every crate builds without and with each of its features
  check strangers             every published crate can be packaged, and used from outside
  web                         the page for a browser: target/page/rough-contact.html
  release [TAG | --notes]     the version agrees everywhere and with TAG; its part of the changelog
  release --licences PACKAGE TARGET
                              licences of what a program is linked with
  ci [--slow | --all]         everything a change must pass

--check, also of each study, compares with what is committed instead of writing it.";

fn run(args: &[String]) -> TaskResult {
    match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] | [.., "help" | "--help" | "-h"] => {
            println!("cargo xtask{USAGE}");
            Ok(())
        }
        ["compare", ..] => compare::run(&args[1..]),
        ["figures", ..] => figures::run(&args[1..]),
        ["bench", ..] => bench::run(&args[1..]),
        ["study", "costs", ..] => costs::run(&args[2..]),
        ["study", "coverage", ..] => coverage::run(&args[2..]),
        ["study", "extremes", ..] => extremes::run(&args[2..]),
        ["study", "tables", ..] => tables::run(&args[2..]),
        ["study", "tradeoff", ..] => tradeoff::run(&args[2..]),
        ["surfaces", ..] => {
            // An example of the crate: relative paths are the caller's.
            let mut check =
                released("surface-io", &shell::RELEASE, ["--example", "check_surfaces"]);
            shell::run(check.args(&args[1..]))
        }
        ["validate", ..] => validate::run(&args[1..]),
        ["check"] => tidy::run().and_then(|()| features::run()).and_then(|()| strangers::run()),
        ["check", "tidy"] => tidy::run(),
        ["check", "features"] => features::run(),
        ["check", "strangers"] => strangers::run(),
        ["web"] => web::run(),
        ["release", "--licences", package, target] => licences::run(package, target),
        ["release", "--notes"] => release::print_notes(),
        ["release", ..] => release::run(&args[1..]),
        ["ci", ..] => ci::run(&args[1..]),
        _ => Err(format!("there is no task '{}'\n{USAGE}", args.join(" "))),
    }
}

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match run(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
