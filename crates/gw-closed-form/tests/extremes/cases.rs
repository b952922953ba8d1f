//! The cases of `fixtures/reference/extremes_gw.csv` with our answers; shared by the test and by
//! `examples/gw_extremes.rs`.

use gw_closed_form::partial_moments::{Order, ln, scaled};
use gw_closed_form::{integrals, inverse};

/// One input at the end of its range.
pub(crate) struct Case {
    pub(crate) quantity: &'static str,
    pub(crate) argument: &'static str,
    pub(crate) answer: f64,
    pub(crate) reference_text: &'static str,
}

impl Case {
    /// Relative error, for α in units of max(1, |α|);
    /// `None` where no double can hold the reference.
    pub(crate) fn error(&self) -> Option<f64> {
        let reference: f64 = self.reference_text.parse().expect("the table holds numbers");
        let representable =
            reference.is_normal() || self.answer.abs() <= 0.0 && reference.abs() <= 0.0;
        let scale = if self.quantity.starts_with("alpha") {
            reference.abs().max(1.0)
        } else {
            reference.abs().max(f64::MIN_POSITIVE)
        };
        representable.then(|| ((self.answer - reference) / scale).abs())
    }
}

pub(crate) fn all() -> Vec<Case> {
    let table = include_str!("../../../../fixtures/reference/extremes_gw.csv");
    let mut cases = Vec::new();
    for line in table.lines().skip(2) {
        let mut cells = line.split(',');
        let mut next = || cells.next().expect("three columns");
        let (quantity, argument, reference_text) = (next(), next(), next());
        let x: f64 = argument.parse().expect("the table holds numbers");
        let answer = match quantity {
            "load" => integrals::load(x, 1.0),
            "area" => integrals::area(x, 1.0),
            "ln load" => ln(Order::ThreeHalves, x),
            "scaled load" => scaled(Order::ThreeHalves, x),
            "alpha from load" => inverse::from_load(x).expect("positive"),
            "alpha from area" => inverse::from_area(x).expect("positive"),
            "alpha from ln load" => inverse::from_ln_load(x).expect("in range"),
            other => unreachable!("{other} in the table"),
        };
        cases.push(Case { quantity, argument, answer, reference_text });
    }
    cases
}
