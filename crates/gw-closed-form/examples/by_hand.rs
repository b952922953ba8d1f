//! Asperity statistics typed in by hand, contact at five pressures.
//!
//! ```console
//! $ cargo run --release -p gw-closed-form --example by_hand
//! ```
#![allow(clippy::print_stdout, reason = "an example shows its result")]

use contact_types::{AsperityStatistics, ContactModel, ContactModulus};
use gw_closed_form::GreenwoodWilliamson;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let asperities = AsperityStatistics {
        density: 3e10,       // summits per m²
        radius: 8e-6,        // m
        height_std: 0.3e-6,  // m
        mean_offset: 0.2e-6, // m above the mean plane of the surface
    };
    let model = GreenwoodWilliamson::new(asperities, ContactModulus::from_pascals(110e9)?)?;

    println!("pressure [MPa]  area [%]  real pressure [GPa]  separation [um]  stiffness [GPa/mm]");
    for megapascals in [1.0, 10.0, 50.0, 100.0, 1000.0] {
        let contact = model.at_pressure(megapascals * 1e6)?;
        let separation = contact.separation.unwrap_or(f64::INFINITY);
        println!(
            "{megapascals:>14}  {:>8.4}  {:>19.3}  {:>15.4}  {:>18.1}",
            100.0 * contact.area_fraction,
            contact.real_pressure().unwrap_or(0.0) * 1e-9,
            separation * 1e6,
            model.stiffness(separation)? * 1e-12,
        );
        if let Some(caveat) = contact.caveat {
            println!("                ({caveat})");
        }
    }
    Ok(())
}
