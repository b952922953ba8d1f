//! The closed form at the ends of its inputs, against `fixtures/reference/extremes_gw.csv`.
//! `examples/gw_extremes.rs` prints the same cases.

mod common;

use common::{ReferenceRow, ReferenceTable};
use gw_closed_form::inverse;
use gw_closed_form::partial_moments::{Order, ln, scaled, value};

/// One input at the end of its range.
pub(crate) struct Case {
    pub(crate) place: String,
    answer: f64,
    reference: f64,
}

impl Case {
    /// Relative error, for α in units of max(1, |α|); `None` where no double can hold the
    /// reference.
    pub(crate) fn error(&self) -> Option<f64> {
        let Self { place, answer, reference } = self;
        let representable = reference.is_normal() || answer.abs() <= 0.0 && reference.abs() <= 0.0;
        let least = if place.starts_with("alpha") { 1.0 } else { f64::MIN_POSITIVE };
        representable.then(|| ((answer - reference) / reference.abs().max(least)).abs())
    }
}

pub(crate) fn cases() -> Vec<Case> {
    let case = |row: ReferenceRow<'_>| {
        let (quantity, x) = (row.text("quantity"), row.number("argument"));
        let answer = match quantity {
            "load" => value(Order::ThreeHalves, x),
            "area" => value(Order::One, x),
            "ln load" => ln(Order::ThreeHalves, x),
            "scaled load" => scaled(Order::ThreeHalves, x),
            "alpha from load" => inverse::from_value(Order::ThreeHalves, x).expect("positive"),
            "alpha from area" => inverse::from_value(Order::One, x).expect("positive"),
            "alpha from ln load" => inverse::from_ln(Order::ThreeHalves, x).expect("in range"),
            other => unreachable!("{other} in the table"),
        };
        let place = format!("{quantity} at {}", row.text("argument"));
        Case { place, answer, reference: row.number("reference") }
    };
    ReferenceTable::read("extremes_gw.csv").rows().map(case).collect()
}

/// The answer is never NaN or infinity.
#[test]
fn every_extreme_has_an_answer() {
    let cases = cases();
    assert!(cases.len() > 60);
    for case in cases {
        let place = &case.place;
        assert!(case.answer.is_finite(), "{place}");
        // α = ln-load 1000 is exp(667): its digits are those of the logarithm.
        let limit = if place == "alpha from ln load at 1000" { 1e-13 } else { 4e-15 };
        match case.error() {
            Some(error) => assert!(error < limit, "{place}: {error:e}"),
            None => assert!(
                case.answer.abs() >= f64::MAX || case.answer.abs() < f64::MIN_POSITIVE,
                "{place}: {}",
                case.answer
            ),
        }
    }
}
