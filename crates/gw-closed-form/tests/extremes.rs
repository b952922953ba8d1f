//! The closed form at the ends of its inputs, against `fixtures/reference/extremes_gw.csv`.

mod common;

use common::{Case, ReferenceRow, reference_rows};
use gw_closed_form::inverse;
use gw_closed_form::partial_moments::{Order, ln, scaled, value};

fn cases() -> Vec<Case> {
    let case = |row: &ReferenceRow| {
        let (quantity, x) = (row.text("quantity"), row.number("argument"));
        let answer = match quantity {
            "load" => value(Order::ThreeHalves, x),
            "area" => value(Order::One, x),
            "ln load" => ln(Order::ThreeHalves, x),
            "scaled load" => scaled(Order::ThreeHalves, x),
            "alpha from load" => inverse::from_value(x).expect("positive"),
            "alpha from ln load" => inverse::from_ln(x).expect("in range"),
            other => unreachable!("{other} in the table"),
        };
        let place = format!("{quantity} at {}", row.text("argument"));
        let least = if quantity.starts_with("alpha") { 1.0 } else { 0.0 };
        Case { place, answer: Some(answer), reference: Some(row.number("reference")), least }
    };
    reference_rows("extremes_gw.csv").iter().map(case).collect()
}

#[test]
fn answers_at_the_extremes() {
    // α = ln-load 1000 is exp(667): its digits are those of the logarithm.
    let is_of_logarithm = |place: &str| place == "alpha from ln load at 1000";
    let limit = |place: &str| if is_of_logarithm(place) { 1e-13 } else { 4e-15 };
    common::assert_answered("gw-closed-form", cases(), limit);
}
