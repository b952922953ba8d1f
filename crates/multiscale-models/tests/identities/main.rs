//! Identities of the theories, each against quadrature done here and not by the crate.

mod archard_and_fractals;
mod jackson_streator;
mod persson_area;
mod persson_gap;
mod persson_stiffness;
mod quadrature;
mod spectrum;

use contact_types::ContactModulus;

fn pascals(e: f64) -> ContactModulus {
    ContactModulus::from_pascals(e).expect("a modulus")
}
