//! Against 60-digit values. Every figure printed here is quoted in the documentation.

mod common;
use common::{Worst, reference_rows, relative_error};
use contact_types::{AsperityStatistics, ContactModel, ContactModulus, SeparationModel};
use gw_closed_form::partial_moments::{Order, ln, ln_derivative, scaled, value};
use gw_closed_form::{GreenwoodWilliamson, inverse};

#[test]
fn partial_moments() {
    let names = ["value", "scaled", "ln", "ln_derivative"];
    let mut worst = names.map(Worst::of);
    for row in reference_rows("gw_partial_moments.csv") {
        let [n, alpha] = row.numbers(["n", "alpha"]);
        let orders = [Order::Zero, Order::Half, Order::One, Order::ThreeHalves];
        let order = orders[(2.0 * n) as usize];
        let answers = [
            value(order, alpha),
            scaled(order, alpha),
            ln(order, alpha),
            ln_derivative(order, alpha),
        ];
        for ((answer, name), worst) in answers.into_iter().zip(names).zip(&mut worst) {
            assert!(answer.is_finite(), "{name} of {order:?} at {alpha:e}");
            let error = relative_error(answer, row.number(name));
            worst.see(error, || format!("n = {n}, alpha = {alpha:e}"));
        }
    }
    for worst in worst {
        worst.at_most(1e-15);
    }
}

#[test]
fn inverse_problem() {
    let mut worst = Worst::of("alpha from load or ln load");
    for row in reference_rows("gw_inverse.csv") {
        let ([value, alpha], is_load) =
            (row.numbers(["value", "alpha"]), row.text("kind") == "load");
        let found = if is_load { inverse::from_value(value) } else { inverse::from_ln(value) };
        let mut error = (found.unwrap() - alpha).abs() / alpha.abs().max(1.0);
        if !is_load && value > 0.0 {
            error /= value.max(100.0) / 100.0; // the rounding of the logarithm itself
        }
        worst.see(error, || format!("load {is_load}, {value:e}"));
    }
    worst.at_most(1e-14);
}

#[test]
fn model_in_si_units() {
    let names = ["pressure", "area", "stiffness"];
    let mut worst = names.map(Worst::of);
    let mut area_at_pressure = Worst::of("area at pressure");
    for row in reference_rows("gw_units.csv") {
        let [density, radius, height_std, mean_offset] =
            row.numbers(["density", "radius", "height_std", "mean_offset"]);
        let asperities = AsperityStatistics { density, radius, height_std, mean_offset };
        let [modulus, separation] = row.numbers(["modulus", "separation"]);
        let modulus = ContactModulus::from_pascals(modulus).unwrap();
        let model = GreenwoodWilliamson::new(asperities, modulus).unwrap();
        let at_separation = model.at_separation(separation).unwrap();
        // a = d - y_s and α = a/σ_s are rounded; one unit in α moves the answer by α²/2 units.
        let alpha = (separation - mean_offset) / height_std;
        let condition = 1.0 + 0.02 * alpha * alpha;
        let place = || format!("alpha = {alpha:.3}");
        let found = [
            at_separation.mean_pressure,
            at_separation.area_fraction,
            model.stiffness(separation).unwrap(),
        ];
        for ((found, name), worst) in found.into_iter().zip(names).zip(&mut worst) {
            worst.see(relative_error(found, row.number(name)) / condition, place);
        }
        // The area at a given pressure is well conditioned: no allowance.
        let [pressure, area] = row.numbers(["pressure", "area"]);
        let at_pressure = model.at_pressure(pressure).unwrap();
        area_at_pressure.see(relative_error(at_pressure.area_fraction, area), place);
        let back = (at_pressure.separation.unwrap() - separation).abs();
        assert!(back <= 1e-14 * (separation.abs() + 40.0 * height_std), "{back:e}");
    }
    for worst in worst.iter().chain([&area_at_pressure]) {
        worst.at_most(1e-14);
    }
}
