//! Every model at the ends of its inputs, against 20-digit values.
//! `cargo run --release -p multiscale-models --example multiscale_extremes` prints the table.

mod common;

use common::Worst;
use common::extremes::cases;

#[test]
fn answers_at_the_ends_of_the_inputs() {
    let mut worst: Vec<(String, Worst)> = Vec::new();
    for case in cases() {
        let place = || format!("{} {}", case.question, case.inputs);
        let Some(reference) = case.reference else {
            assert!(case.answer.is_err(), "{}: should be refused", place());
            continue;
        };
        let found = match &case.answer {
            Ok((found, _)) => *found,
            Err(error) => panic!("{}: {error}", place()),
        };
        if !worst.iter().any(|(question, _)| *question == case.question) {
            worst.push((case.question.clone(), Worst::of("extremes")));
        }
        let entry = worst.iter_mut().find(|(question, _)| *question == case.question);
        entry.expect("just added").1.compare(found, reference, place);
    }
    assert!(worst.len() >= 13, "only {} questions", worst.len());
    for (question, worst) in worst {
        // The exponential e^{-x^2} of a gap turns one rounding of x into 2 x^2 roundings: 1e-13 at
        // x = 20.
        worst.at_most(if question.contains("gap") { 3e-13 } else { 3e-15 });
    }
}
