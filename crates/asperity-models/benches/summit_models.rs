//! What an answer of the summit models costs, with its error in the name.
//!
//! ```console
//! $ cargo bench -p asperity-models
//! ```
#![allow(missing_docs, reason = "criterion's macros make undocumented items")]

use asperity_models::{SummitLaw, SummitModel};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

const BANDWIDTH: f64 = 5.0;

fn summit_models(c: &mut Criterion) {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: BANDWIDTH };
    let modulus = ContactModulus::from_pascals(1.0).expect("positive");
    for (name, law) in [
        ("Bush-Gibson-Thomas", SummitLaw::BushGibsonThomas),
        ("Greenwood elliptical", SummitLaw::GreenwoodElliptical),
    ] {
        let model = SummitModel::new(law, moments, modulus).expect("bandwidth 5");
        c.bench_function(&format!("{name}/at_separation, error 4e-15"), |b| {
            b.iter(|| model.at_separation(black_box(1.0)));
        });
        c.bench_function(&format!("{name}/at_pressure, error 4e-15"), |b| {
            b.iter(|| model.at_pressure(black_box(0.01)));
        });
    }
}

criterion_group!(benches, summit_models);
criterion_main!(benches);
