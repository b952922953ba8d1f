//! Prints the table "each model at the ends of its inputs" as Markdown:
//! `cargo run --release -p multiscale-models --example multiscale_extremes`.
#![allow(clippy::print_stdout, reason = "an example that prints its table")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::extremes::{Case, cases};

fn main() {
    println!("| question | inputs | answer | reference | remark | relative error |");
    println!("|---|---|---|---|---|---|");
    for case in cases() {
        println!("{}", line(&case));
    }
}

fn line(case: &Case) -> String {
    let (answer, remark) = match &case.answer {
        Ok((value, caveat)) => {
            (format!("{value:.15e}"), caveat.as_ref().map(ToString::to_string).unwrap_or_default())
        }
        Err(error) => ("refused".to_owned(), error.to_string()),
    };
    let error = match case.error() {
        Some(error) => format!("{error:.1e}"),
        None if case.reference.is_none() && case.answer.is_err() => "as it should".to_owned(),
        None => "WRONG".to_owned(),
    };
    let inputs = case.inputs.replace('|', " ").replace(';', ", ").replace('=', " = ");
    let (question, reference) = (&case.question, &case.reference_text);
    let row = format!("| {question} | {inputs} | {answer} | {reference} | {remark} | {error} |");
    row.replace("e-", "e−").replace("= -", "= −")
}
