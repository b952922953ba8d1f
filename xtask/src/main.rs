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
mod docs;
mod extremes;
mod features;
mod figures;
mod generated;
mod licences;
mod release;
mod shell;
mod strangers;
mod surfaces;
mod tidy;
mod tradeoff;
mod validate;
mod web;

use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask <task> [options]

  compare [FILE.. OPTIONS]  the study: measured or built-in surfaces, every model, the
                            deterministic solution; without arguments into target/compare/
  validate [--check]        the solver against exact solutions; table into the book
  figures [--check]         the figures that README and book show
  docs [--check]            the tables of models and formats in the book
  extremes [--check]        models, statistics, solver at their extremes; table into the book
  costs [--check | --build] what each crate brings along and each call allocates; with --build
                            how long each takes to build from clean (minutes)
  coverage [--check]        how often the uncertainties hold; tables into the book (ten minutes)
  bench [ARGS]              the benchmarks; their table into the book
  surfaces --dir DIR --expected FILE
                            files of instruments against expected values, one line each
  tradeoff [--quick | --figures-only | --check]
                            time against true error, models and solver; table, figures, page
                            (under 10 minutes; wants a quiet machine)
  tidy                      layers, circles of files, citations, pages, file lengths, dependency counts,
                            and what the project weighs against xtask/counters.toml
  features                  every crate builds without and with each of its features
  web                       the page that computes in a browser, one file: target/page/rough-contact.html
  licences PACKAGE TARGET   the licences of what a program is linked with, as archives carry them
  release [TAG | --notes]   the version is the same in every file that states it, and that of the tag; with
                            --notes what has changed with it
  strangers                 every published crate can be packaged, and its front-page example
                            compiles with that crate alone
  ci [--slow]               everything a change must pass, as the CI runs it

--check verifies that what is committed is current instead of writing it.";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let (task, rest) = match args.split_first() {
        Some((task, rest)) => (task.as_str(), rest),
        None => ("help", &[][..]),
    };
    let result = match task {
        "compare" => compare::run(rest),
        "validate" => validate::run(rest),
        "figures" => figures::run(rest),
        "costs" => costs::run(rest),
        "coverage" => coverage::run(rest),
        "docs" => docs::run(rest),
        "extremes" => extremes::run(rest),
        "features" => features::run(rest),
        "strangers" => strangers::run(rest),
        "bench" => bench::run(rest),
        "release" if rest == ["--notes"] => release::print_notes(),
        "release" => release::run(rest),
        "surfaces" => surfaces::run(rest),
        "licences" => licences::run(rest),
        "tradeoff" => tradeoff::run(rest),
        "tidy" => tidy::run(rest),
        "web" => web::run(rest),
        "ci" => ci::run(rest),
        "help" | "--help" | "-h" => {
            println!("{USAGE}");
            Ok(())
        }
        other => Err(format!("there is no task '{other}'\n\n{USAGE}")),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask {task}: {message}");
            ExitCode::FAILURE
        }
    }
}
