//! Against 34-digit values.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
use asperity_models::{SummitLaw, SummitModel};
use common::{ReferenceRow, ReferenceTable, Worst, relative_error};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use std::f64::consts::PI;

/// m0 = m2 = E* = 1, so that h is the separation and p the pressure.
fn check(law: SummitLaw, row: &ReferenceRow<'_>, name: &str, worst: &mut [Worst; 6]) {
    let [bandwidth, h, contact_fraction] = row.numbers(["bandwidth", "h", "contact_fraction"]);
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let model = SummitModel::new(law, moments, modulus).unwrap();
    let [area, pressure, stiffness] =
        ["area", "pressure", "stiffness"].map(|quantity| row.number(&format!("{name}_{quantity}")));
    let place = || format!("bandwidth {bandwidth}, h = {h}");
    let state = model.at_separation(h).unwrap();
    worst[0].see(relative_error(state.area_fraction, area), place);
    worst[1].see(relative_error(state.mean_pressure, pressure), place);
    worst[2].see(relative_error(model.stiffness(h).unwrap(), stiffness), place);
    let density = bandwidth / (6.0 * PI * 3f64.sqrt());
    let contacts = model.contact_density(h).unwrap();
    worst[3].see(relative_error(contacts / density, contact_fraction), place);
    if pressure.is_normal() {
        let inverse = model.at_pressure(pressure).unwrap();
        worst[4].see((inverse.separation.unwrap() - h).abs() / h.abs().max(1.0), place);
        worst[5].see(relative_error(inverse.area_fraction, area), place);
    }
}

fn all_models(table: &str, limit: f64) {
    let names = ["area", "pressure", "stiffness", "contacts", "separation back", "area back"];
    let laws = [
        (SummitLaw::BushGibsonThomas, "bgt"),
        (SummitLaw::GreenwoodElliptical, "geometric"),
        (SummitLaw::MeanCurvature, "mean"),
    ];
    let mut worst =
        laws.map(|(_, model)| names.map(|name| Worst::of(format!("{table}, {model}, {name}"))));
    for row in ReferenceTable::read(table).rows() {
        for ((law, model), worst) in laws.into_iter().zip(&mut worst) {
            check(law, &row, model, worst);
        }
    }
    for worst in worst.iter().flatten() {
        worst.at_most(limit);
    }
}

#[test]
fn ordinary_arguments() {
    all_models("summit_models_ordinary.csv", 2e-14);
}

/// Bandwidth 3/2 exactly to 1e8, -6 to 40 rms heights.
#[test]
fn wide_arguments() {
    all_models("summit_models.csv", 1e-14);
}
