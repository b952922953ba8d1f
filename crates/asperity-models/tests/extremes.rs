//! Bush-Gibson-Thomas at the ends of its inputs, against `fixtures/reference/extremes_summit_models.csv`:
//! bandwidth 3/2 exactly, 3/2 (1 + 1e-12) and 1e8, separations from -6 to 40 rms heights, pressures from the
//! smallest normal double to 1e3 E*.

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;

use asperity_models::{SummitLaw, SummitModel};
use common::{Case, ReferenceRow, reference_rows};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};

fn case(row: &ReferenceRow) -> Case {
    // m0 = m2 = E* = 1: separation and pressure are dimensionless.
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: row.number("bandwidth") };
    let modulus = ContactModulus::from_pascals(1.0).expect("positive");
    let law = SummitLaw::BushGibsonThomas;
    let model = SummitModel::new(law, moments, modulus).expect("bandwidth from 3/2");
    let (quantity, x) = (row.text("quantity"), row.number("argument"));
    let at_separation = || model.at_separation(x).expect("finite");
    let at_pressure = || model.at_pressure(x).expect("positive");
    let answer = match quantity {
        "area" => at_separation().area_fraction,
        "pressure" => at_separation().mean_pressure,
        "separation at pressure" => at_pressure().separation.expect("pressure above 0"),
        "area at pressure" => at_pressure().area_fraction,
        other => unreachable!("{other} in the table"),
    };
    let place =
        format!("{quantity}, bandwidth {}, at {}", row.text("bandwidth"), row.text("argument"));
    let least = if quantity.starts_with("separation") { 1.0 } else { 0.0 };
    Case { place, answer: Some(answer), reference: Some(row.number("reference")), least }
}

#[test]
fn answers_at_the_extremes() {
    let cases = reference_rows("extremes_summit_models.csv").iter().map(case).collect();
    common::assert_answered("asperity-models", cases, |_| 1e-14);
}
