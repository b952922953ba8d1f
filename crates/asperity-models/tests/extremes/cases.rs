//! The cases of `fixtures/reference/extremes_summit_models.csv` with the answers of
//! Bush-Gibson-Thomas; shared by the test and by `examples/summit_extremes.rs`.

use asperity_models::BushGibsonThomas;
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};

/// One input at the end of its range.
pub(crate) struct Case {
    pub(crate) quantity: &'static str,
    pub(crate) bandwidth: &'static str,
    pub(crate) argument: &'static str,
    pub(crate) answer: f64,
    pub(crate) reference_text: &'static str,
}

impl Case {
    /// Relative error, for separations in units of max(1, |h|); `None` where the reference is no
    /// normal double.
    pub(crate) fn error(&self) -> Option<f64> {
        let reference: f64 = self.reference_text.parse().expect("the table holds numbers");
        let least = if self.quantity.starts_with("separation") { 1.0 } else { 0.0 };
        reference
            .is_normal()
            .then(|| ((self.answer - reference) / reference.abs().max(least)).abs())
    }
}

pub(crate) fn all() -> Vec<Case> {
    let table = include_str!("../../../../fixtures/reference/extremes_summit_models.csv");
    let number = |cell: &str| -> f64 { cell.parse().expect("the table holds numbers") };
    let mut cases = Vec::new();
    for line in table.lines().skip(2) {
        let mut cells = line.split(',');
        let mut next = || cells.next().expect("four columns");
        let (quantity, bandwidth, argument, reference_text) = (next(), next(), next(), next());
        // m0 = m2 = E* = 1: separation and pressure are dimensionless.
        let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: number(bandwidth) };
        let modulus = ContactModulus::from_pascals(1.0).expect("positive");
        let model = BushGibsonThomas::new(moments, modulus).expect("bandwidth from 3/2");
        let x = number(argument);
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
        cases.push(Case { quantity, bandwidth, argument, answer, reference_text });
    }
    cases
}
