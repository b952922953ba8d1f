//! Against 34-digit values.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
use asperity_models::{SummitLaw, SummitModel};
use common::{ReferenceRow, Worst, reference_rows, relative_error};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};

/// m0 = m2 = E* = 1, so that h is the separation and p the pressure.
fn check(law: SummitLaw, row: &ReferenceRow, name: &str, worst: &mut [Worst; 4]) {
    let [bandwidth, h] = row.numbers(["bandwidth", "h"]);
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let model = SummitModel::new(law, moments, modulus).unwrap();
    let [area, pressure] =
        ["area", "pressure"].map(|quantity| row.number(&format!("{name}_{quantity}")));
    let place = || format!("bandwidth {bandwidth}, h = {h}");
    let state = model.at_separation(h).unwrap();
    worst[0].see(relative_error(state.area_fraction, area), place);
    worst[1].see(relative_error(state.mean_pressure, pressure), place);
    if pressure.is_normal() {
        let inverse = model.at_pressure(pressure).unwrap();
        worst[2].see((inverse.separation.unwrap() - h).abs() / h.abs().max(1.0), place);
        worst[3].see(relative_error(inverse.area_fraction, area), place);
    }
}

fn all_models(table: &str, limit: f64) {
    let names = ["area", "pressure", "separation back", "area back"];
    let laws =
        [(SummitLaw::BushGibsonThomas, "bgt"), (SummitLaw::GreenwoodElliptical, "geometric")];
    let mut worst =
        laws.map(|(_, model)| names.map(|name| Worst::of(format!("{table}, {model}, {name}"))));
    for row in reference_rows(table) {
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
