//! Against 34-digit values.
#![allow(clippy::unwrap_used, reason = "tests: a panic is the report")]

#[path = "../../gw-closed-form/tests/common/mod.rs"]
mod common;
use asperity_models::{
    BushGibsonThomas, GreenwoodElliptical, MeanCurvature, SummitLaw, SummitModel, nayak,
};
use common::{Worst, number, relative_error, rows};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use std::f64::consts::PI;

const ORDINARY: &str = include_str!("../../../fixtures/reference/summit_models_ordinary.csv");
const WIDE: &str = include_str!("../../../fixtures/reference/summit_models.csv");
const NAYAK: &str = include_str!("../../../fixtures/reference/nayak_summit_heights.csv");

/// m0 = m2 = E* = 1, so that h is the separation and p the pressure.
fn check<L: SummitLaw>(row: &[f64], columns: [usize; 3], worst: &mut [Worst; 6]) {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: row[0] };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let model = SummitModel::<L>::new(moments, modulus).unwrap();
    let h = row[1];
    let [area, pressure, stiffness] = columns.map(|k| row[k]);
    let place = || format!("bandwidth {}, h = {h}", row[0]);
    let state = model.at_separation(h).unwrap();
    worst[0].see(relative_error(state.area_fraction, area), place);
    worst[1].see(relative_error(state.mean_pressure, pressure), place);
    worst[2].see(relative_error(model.stiffness(h).unwrap(), stiffness), place);
    let density = row[0] / (6.0 * PI * 3f64.sqrt());
    worst[3].see(relative_error(model.contact_density(h).unwrap() / density, row[11]), place);
    if pressure.is_normal() {
        let inverse = model.at_pressure(pressure).unwrap();
        worst[4].see((inverse.separation.unwrap() - h).abs() / h.abs().max(1.0), place);
        worst[5].see(relative_error(inverse.area_fraction, area), place);
    }
}

fn all_models(table: &str, limit: f64) {
    let mut worst: [[Worst; 6]; 3] = Default::default();
    for row in rows(table) {
        let row: Vec<f64> = row.iter().map(|cell| number(cell)).collect();
        check::<asperity_models::EllipticHertz>(&row, [2, 3, 4], &mut worst[0]);
        check::<asperity_models::GeometricMeanSphere>(&row, [5, 6, 7], &mut worst[1]);
        check::<asperity_models::ArithmeticMeanSphere>(&row, [8, 9, 10], &mut worst[2]);
    }
    let names = ["area", "pressure", "stiffness", "contacts", "separation back", "area back"];
    for (model, worst) in ["BGT", "elliptical", "mean curvature"].iter().zip(&worst) {
        for (name, worst) in names.iter().zip(worst) {
            worst.check(&format!("{model}, {name}"), limit);
        }
    }
}

#[test]
fn ordinary_arguments() {
    all_models(ORDINARY, 2e-14);
}

/// Bandwidth 3/2 exactly to 1e8, -6 to 40 rms heights.
#[test]
fn wide_arguments() {
    all_models(WIDE, 1e-14);
}

#[test]
fn nayak_summit_heights() {
    let mut worst = Worst::default();
    for row in rows(NAYAK) {
        let [bandwidth, xi, exact] = [number(row[0]), number(row[1]), number(row[2])];
        let density = nayak::summit_height_density(bandwidth, xi).unwrap();
        worst.see(relative_error(density, exact), || format!("bandwidth {bandwidth}, {xi}"));
    }
    worst.check("Nayak", 1e-13);
}

#[test]
fn the_three_names_are_three_models() {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: 2.0 };
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    let at = |model: &dyn SeparationModel| model.at_separation(0.0).unwrap().area_fraction;
    let full = at(&BushGibsonThomas::new(moments, modulus).unwrap());
    let elliptical = at(&GreenwoodElliptical::new(moments, modulus).unwrap());
    let mean = at(&MeanCurvature::new(moments, modulus).unwrap());
    // Greenwood (2006): the simplification adds about 2 % of area.
    assert!((elliptical / full - 1.018).abs() < 1e-3 && mean < 0.95 * full);
}
