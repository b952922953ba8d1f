//! Against 34-digit values.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
use asperity_models::{SummitLaw, SummitModel, nayak};
use common::{ReferenceRow, ReferenceTable, Worst, relative_error};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use std::f64::consts::PI;

/// m0 = m2 = E* = 1, so that h is the separation and p the pressure.
fn check<L: SummitLaw>(row: &ReferenceRow<'_>, name: &str, worst: &mut [Worst; 6]) {
    let [bandwidth, h, contact_fraction] = row.numbers(["bandwidth", "h", "contact_fraction"]);
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: bandwidth };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let model = SummitModel::<L>::new(moments, modulus).unwrap();
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
    let models = ["bgt", "geometric", "mean"];
    let mut worst =
        models.map(|model| names.map(|name| Worst::of(format!("{table}, {model}, {name}"))));
    for row in ReferenceTable::read(table).rows() {
        check::<asperity_models::EllipticHertz>(&row, models[0], &mut worst[0]);
        check::<asperity_models::GeometricMeanSphere>(&row, models[1], &mut worst[1]);
        check::<asperity_models::ArithmeticMeanSphere>(&row, models[2], &mut worst[2]);
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

#[test]
fn nayak_summit_heights() {
    let mut worst = Worst::of("Nayak");
    for row in ReferenceTable::read("nayak_summit_heights.csv").rows() {
        let [bandwidth, xi, exact] = row.numbers(["bandwidth", "xi", "density"]);
        let density = nayak::summit_height_density(bandwidth, xi).unwrap();
        worst.see(relative_error(density, exact), || format!("bandwidth {bandwidth}, {xi}"));
    }
    worst.at_most(1e-13);
}
