//! Against 60-digit values. Every figure printed here is quoted in the documentation.

mod common;
use common::{Worst, number, relative_error, rows};
use contact_types::{AsperityStatistics, ContactModel, ContactModulus, SeparationModel};
use gw_closed_form::partial_moments::{Order, derivative, ln, ln_derivative, scaled, value};
use gw_closed_form::{GreenwoodWilliamson, integrals, inverse};

const MOMENTS: &str = include_str!("../../../fixtures/reference/gw_partial_moments.csv");
const INVERSE: &str = include_str!("../../../fixtures/reference/gw_inverse.csv");
const UNITS: &str = include_str!("../../../fixtures/reference/gw_units.csv");

#[test]
fn partial_moments() {
    let names = ["value", "scaled", "ln", "derivative", "ln_derivative"];
    let mut worst: [Worst; 5] = Default::default();
    for row in rows(MOMENTS) {
        let order = Order::ALL.into_iter().find(|o| (o.exponent() - number(row[0])).abs() < 0.1);
        let (order, alpha) = (order.unwrap(), number(row[1]));
        let answers = [
            value(order, alpha),
            scaled(order, alpha),
            ln(order, alpha),
            derivative(order, alpha),
            ln_derivative(order, alpha),
        ];
        for (k, answer) in answers.into_iter().enumerate() {
            assert!(answer.is_finite(), "{} of {order:?} at {alpha:e}", names[k]);
            let error = relative_error(answer, number(row[k + 2]));
            worst[k].see(error, || format!("n = {}, alpha = {alpha:e}", row[0]));
        }
    }
    for (name, worst) in names.iter().zip(&worst) {
        worst.check(name, 1e-15);
    }
}

#[test]
fn integrals_are_scaled_partial_moments() {
    let mut worst = Worst::default();
    for row in rows(MOMENTS) {
        let alpha = number(row[1]);
        // A power of two scales α exactly.
        let a = 4.0 * alpha;
        let answer = match row[0] {
            "1.5" => integrals::load(a, 4.0) / 8.0,
            "1.0" => integrals::area(a, 4.0) / 4.0,
            "0.5" => integrals::load_slope(a, 4.0) / 3.0,
            "0.0" => integrals::contact_fraction(a, 4.0),
            _ => continue,
        };
        worst.see(relative_error(answer, number(row[2])), || format!("alpha = {alpha:e}"));
    }
    worst.check("integrals", 1.5e-15);
}

#[test]
fn inverse_problem() {
    let mut worst: [Worst; 3] = Default::default();
    for row in rows(INVERSE) {
        let (given, alpha) = (number(row[1]), number(row[2]));
        let (k, found) = match row[0] {
            "load" => (0, inverse::from_load(given)),
            "area" => (1, inverse::from_area(given)),
            _ => (2, inverse::from_ln_load(given)),
        };
        let mut error = (found.unwrap() - alpha).abs() / alpha.abs().max(1.0);
        if k == 2 && given > 0.0 {
            error /= given.max(100.0) / 100.0; // the rounding of the logarithm itself
        }
        worst[k].see(error, || format!("{} = {given:e}", row[0]));
    }
    worst[0].check("alpha from load", 1e-14);
    worst[1].check("alpha from area", 1e-14);
    worst[2].check("alpha from ln load", 1e-14);
}

#[test]
fn model_in_si_units() {
    let mut worst: [Worst; 5] = Default::default();
    for row in rows(UNITS) {
        let cell: Vec<f64> = row.iter().map(|c| number(c)).collect();
        let asperities = AsperityStatistics {
            density: cell[0],
            radius: cell[1],
            height_std: cell[2],
            mean_offset: cell[3],
        };
        let modulus = ContactModulus::from_pascals(cell[4]).unwrap();
        let model = GreenwoodWilliamson::new(asperities, modulus).unwrap();
        let separation = cell[5];
        let at_separation = model.at_separation(separation).unwrap();
        let [pressure, area, stiffness, contacts] = [cell[6], cell[7], cell[8], cell[9]];
        // a = d - y_s and α = a/σ_s are rounded; one unit in α moves the answer by α²/2 units.
        let alpha = (separation - cell[3]) / cell[2];
        let condition = 1.0 + 0.02 * alpha * alpha;
        let place = || format!("alpha = {alpha:.3}");
        let errors = [
            relative_error(at_separation.mean_pressure, pressure),
            relative_error(at_separation.area_fraction, area),
            relative_error(model.stiffness(separation).unwrap(), stiffness),
            relative_error(model.contact_density(separation).unwrap(), contacts),
        ];
        for (k, error) in errors.into_iter().enumerate() {
            worst[k].see(error / condition, place);
        }
        // The area at a given pressure is well conditioned: no allowance.
        let at_pressure = model.at_pressure(pressure).unwrap();
        worst[4].see(relative_error(at_pressure.area_fraction, area), place);
        let back = (at_pressure.separation.unwrap() - separation).abs();
        assert!(back <= 1e-14 * (separation.abs() + 40.0 * cell[2]), "{back:e}");
    }
    for (name, worst) in
        ["pressure", "area", "stiffness", "contacts", "area at pressure"].iter().zip(&worst)
    {
        worst.check(name, 1e-14);
    }
}
