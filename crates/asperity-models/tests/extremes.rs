//! Bush-Gibson-Thomas at the ends of its inputs, against `fixtures/reference/extremes_summit_models.csv`:
//! bandwidth 3/2 exactly, 3/2 (1 + 1e-12) and 1e8, separations from -6 to 40 rms heights, pressures from the
//! smallest normal double to 1e3 E*. `examples/summit_extremes.rs` prints the same cases.

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;

use asperity_models::{SummitLaw, SummitModel};
use common::{ReferenceRow, ReferenceTable};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};

/// One input at the end of its range.
pub(crate) struct Case {
    pub(crate) place: String,
    answer: f64,
    reference: f64,
}

impl Case {
    /// Relative error, for separations in units of max(1, |h|); `None` where the reference is no
    /// normal double.
    pub(crate) fn error(&self) -> Option<f64> {
        let Self { place, answer, reference } = self;
        let least = if place.starts_with("separation") { 1.0 } else { 0.0 };
        let is_normal = reference.is_normal();
        is_normal.then(|| ((answer - reference) / reference.abs().max(least)).abs())
    }
}

pub(crate) fn cases() -> Vec<Case> {
    ReferenceTable::read("extremes_summit_models.csv").rows().map(|row| case(&row)).collect()
}

fn case(row: &ReferenceRow<'_>) -> Case {
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
        "stiffness" => model.stiffness(x).expect("finite"),
        "ln pressure" => model.ln_mean_pressure(x).expect("finite"),
        "separation at pressure" => at_pressure().separation.expect("pressure above 0"),
        "area at pressure" => at_pressure().area_fraction,
        other => unreachable!("{other} in the table"),
    };
    let place =
        format!("{quantity}, bandwidth {}, at {}", row.text("bandwidth"), row.text("argument"));
    Case { place, answer, reference: row.number("reference") }
}

#[test]
fn every_extreme_has_an_answer() {
    let cases = cases();
    assert!(cases.len() > 100);
    for case in cases {
        assert!(case.answer.is_finite(), "{}", case.place);
        match case.error() {
            Some(error) => assert!(error < 1e-14, "{}: {error:e}", case.place),
            None => assert!(case.answer.abs() < f64::MIN_POSITIVE, "{}", case.place),
        }
    }
}
