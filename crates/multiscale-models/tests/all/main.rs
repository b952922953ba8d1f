//! Theories against tables, identities and the ends of their inputs. One program, linked once.

#[path = "../../../gw-closed-form/tests/common/mod.rs"]
mod common;

mod archard_and_fractals;
mod equation;
mod extremes;
mod persson_gap;
mod properties;
mod quadrature;
mod refusals;
mod tables;

use contact_types::ContactModulus;

fn pascals(e: f64) -> ContactModulus {
    ContactModulus::from_pascals(e).expect("a modulus")
}

#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    // By default the macro also has an absolute tolerance of 2e-16, which any two small numbers pass.
    approx::assert_relative_eq!(found, exact, max_relative = tolerance, epsilon = 0.0);
}
