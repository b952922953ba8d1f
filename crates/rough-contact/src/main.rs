//! The command `rough-contact`. People read its text, scripts its `--json`; both get the same
//! numbers, and exit status 0 (all answers given), 1 (something did not converge or could not
//! be written) or 2 (refused).

mod against;
#[cfg(feature = "app")]
mod app;
mod args;
mod batch;
mod bodies;
mod compare;
mod compare_many;
mod conduction;
mod contact;
mod convert;
mod fields;
mod files;
#[cfg(feature = "app")]
mod http;
mod info;
mod input;
mod leak;
mod loads;
#[cfg(feature = "shell")]
mod manual;
mod model;
mod outcome;
mod profiles;
mod progress;
mod roughness;
mod solve;
mod stats;
mod surfaces;
mod synth;
mod text;
mod validate;

use args::CommonOptions;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};
use outcome::{Failure, Reply};
use rough_contact::front_end::{quantity, units};
use std::process::ExitCode;

/// Real area of contact between rough surfaces: closed-form models beside a deterministic
/// solution.
#[derive(Parser)]
#[command(
    name = "rough-contact",
    version,
    subcommand_required = true,
    arg_required_else_help = true
)]
#[command(after_help = "\
Quantities carry units: 110GPa, 1.5um, 0.2nm^2, 3e12m^-2. A LIST is 1MPa,2MPa or \
1kPa..1GPa:16 (log-spaced, ends included).
Exit status: 0 all answers given; 1 something did not converge or could not be written; \
2 refused.")]
struct Cli {
    #[command(subcommand)]
    command: Command,
    #[command(flatten)]
    common: CommonOptions,
}

#[derive(Subcommand)]
enum Command {
    /// What a surface file holds: size, pixel, missing points, channels, metadata
    Info(info::Info),
    /// Roughness statistics of a surface, each with its unit
    Stats(stats::Stats),
    /// A closed-form model, from a surface or from numbers
    Model(Box<model::Model>),
    /// The deterministic solution for a surface
    Solve(solve::Solve),
    /// The study: every model beside the deterministic solution, as a report
    Compare(compare::Compare),
    /// Make a random self-affine surface
    Synth(synth::Synth),
    /// The heights of a file, cleaned and levelled as asked, in another format
    Convert(convert::Convert),
    /// The table of materials that --material takes names of
    Materials(bodies::Materials),
    /// The page in a browser, computed by this program: drop a measurement, read the report
    #[cfg(feature = "app")]
    App(app::App),
    /// The solver against exact solutions, on this machine
    Validate(validate::Validate),
    /// What a shell needs to complete this command, its options and their values
    #[cfg(feature = "shell")]
    Completions(manual::Completions),
    /// The manual page, of this command or of one below it
    #[cfg(feature = "shell")]
    Man(manual::Man),
}

fn main() -> ExitCode {
    // clap's own errors leave through the same door as ours, so scripts see one contract.
    let words: Vec<String> =
        std::env::args_os().map(|word| word.to_string_lossy().into_owned()).collect();
    let wants_json = words.iter().any(|word| word == "--json");
    let parsed = args::grouped(Cli::command(), &words)
        .try_get_matches()
        .and_then(|mut matches| Cli::from_arg_matches_mut(&mut matches));
    let cli = match parsed {
        Ok(cli) => cli,
        Err(error) if error.use_stderr() => {
            return outcome::finish(Err(outcome::usage(&error)), wants_json);
        }
        Err(help) => {
            outcome::show(&help.to_string());
            return ExitCode::SUCCESS;
        }
    };
    outcome::finish(run(&cli), cli.common.json)
}

fn run(cli: &Cli) -> Result<Reply, Failure> {
    let common = &cli.common;
    #[cfg(feature = "parallel")]
    if let Some(threads) = common.threads {
        // Fails only if a pool exists already, which nothing before this line makes.
        let _ = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
    }
    match &cli.command {
        Command::Info(info) => info.run(common),
        Command::Stats(stats) => stats.run(common),
        Command::Model(model) => model.run(),
        Command::Solve(solve) => solve.run(common),
        Command::Compare(compare) => compare_many::run(compare, common),
        Command::Convert(convert) => convert.run(common),
        Command::Synth(synth) => synth.run(common),
        Command::Materials(materials) => materials.run(),
        #[cfg(feature = "app")]
        Command::App(app) => app.run(common),
        Command::Validate(validate) => validate.run(common),
        #[cfg(feature = "shell")]
        Command::Completions(completions) => completions.run(args::grouped(Cli::command(), &[])),
        #[cfg(feature = "shell")]
        Command::Man(man) => man.run(args::grouped(Cli::command(), &[]), common),
    }
}
