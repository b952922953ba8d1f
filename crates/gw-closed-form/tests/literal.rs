//! What the literal formulas lose: the table in the documentation of `appendix`.

mod common;
use common::{Worst, relative_error};
use gw_closed_form::appendix::{area_a2, load_a1};
use gw_closed_form::integrals;

/// Interval of α, documented largest error of (A1) and of (A2).
const LOSS: [(f64, f64, f64, f64); 8] = [
    (-1000.0, 0.0, 8e-16, 4e-16),
    (0.0, 0.5, 2e-15, 6e-16),
    (0.5, 1.0, 8e-15, 1e-15),
    (1.0, 2.0, 4e-14, 6e-15),
    (2.0, 4.0, 3e-13, 7e-14),
    (4.0, 8.0, 2.5e-12, 9e-13),
    (8.0, 20.0, 1e-10, 4e-11),
    (20.0, 37.0, 1e-9, 4e-10),
];

/// The figures are upper bounds, and not lazy ones: the loss is really there.
#[test]
fn loss_of_digits_is_as_documented() {
    for (low, high, a1, a2) in LOSS {
        let mut load = Worst::of(format!("(A1) on {low} to {high}"));
        let mut area = Worst::of(format!("(A2) on {low} to {high}"));
        for k in 1..4000 {
            let alpha = low + (high - low) * f64::from(k) / 4000.0;
            let place = || format!("{alpha}");
            load.see(relative_error(load_a1(alpha, 1.0), integrals::load(alpha, 1.0)), place);
            area.see(relative_error(area_a2(alpha, 1.0), integrals::area(alpha, 1.0)), place);
        }
        load.at_most(a1);
        area.at_most(a2);
        assert!(load.error > 0.4 * a1 && area.error > 0.4 * a2, "{} {}", load.error, area.error);
    }
}

/// The other reading of the root, √(a exp(-θ)), is wrong by exp(θ/2).
#[test]
fn the_damaged_reading_is_wrong_by_a_factor() {
    for (alpha, factor) in [(0.1f64, 1.00125), (1.0, 1.1331), (3.0, 3.080)] {
        let theta = 0.25 * alpha * alpha;
        // sqrt(a exp(-θ)) instead of sqrt(a) exp(-θ)
        let damaged = load_a1(alpha, 1.0) * (0.5 * theta).exp();
        assert!((damaged / integrals::load(alpha, 1.0) - factor).abs() < 1e-4 * factor);
    }
}

/// Both branches meet at a = 0, where the paper gives a value of its own.
#[test]
fn branches_join() {
    let at_zero = load_a1(0.0, 2.0);
    for a in [1e-9, -1e-9] {
        assert!((load_a1(a, 2.0) / at_zero - 1.0).abs() < 3e-9);
    }
}
