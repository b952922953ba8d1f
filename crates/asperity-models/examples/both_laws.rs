//! Both summit models on one surface, and how far each is from the light-load limit.
//!
//! ```console
//! $ cargo run --release -p asperity-models --example both_laws
//! ```
#![allow(clippy::print_stdout, reason = "an example shows its result")]

use asperity_models::{SummitLaw, SummitModel};
use contact_types::{ContactModel, ContactModulus, SpectralMoments};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 0.5 um rms height, rms gradient 0.14, bandwidth 5
    let moments = SpectralMoments { m0: 0.25e-12, m2: 1e-2, m4: 2e9 };
    let modulus = ContactModulus::from_pascals(110e9)?;
    let laws = [
        ("Bush-Gibson-Thomas", SummitLaw::BushGibsonThomas),
        ("Greenwood elliptical", SummitLaw::GreenwoodElliptical),
    ];
    println!("model                 pressure [MPa]   area [%]  separation [um]  A E* g / p");
    for (name, law) in laws {
        let model = SummitModel::new(law, moments, modulus)?;
        for megapascals in [1e-3, 1.0, 100.0] {
            let contact = model.at_pressure(megapascals * 1e6)?;
            let slope = contact.area_fraction * modulus.pascals() * moments.rms_gradient()
                / contact.mean_pressure;
            println!(
                "{name:<20}  {megapascals:>14}  {:>9.2e}  {:>15.4}  {slope:>10.4}",
                100.0 * contact.area_fraction,
                contact.separation.unwrap_or(f64::INFINITY) * 1e6,
            );
        }
    }
    Ok(())
}
