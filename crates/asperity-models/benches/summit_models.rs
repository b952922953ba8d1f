//! What an answer of the summit models costs, with its error in the name; beside them Greenwood's
//! double integral as his paper writes it.
//!
//! ```console
//! $ cargo bench -p asperity-models
//! ```
#![allow(missing_docs, reason = "criterion's macros make undocumented items")]

use asperity_models::{SummitLaw, SummitModel};
use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use criterion::{Criterion, criterion_group, criterion_main};
use gw_closed_form::partial_moments::{Order, value};
use std::f64::consts::{PI, TAU};
use std::hint::black_box;

const BANDWIDTH: f64 = 5.0;

/// Area by the double integral of p(ξ, g) over height and geometric mean curvature, midpoint rule
/// with `n` steps each way.
fn double_integral(h: f64, n: u32) -> f64 {
    let a = BANDWIDTH;
    let (dg, dy) = (9.0 / f64::from(n), 3.0 / f64::from(n));
    let mut area = 0.0;
    for i in 0..n {
        let g = (f64::from(i) + 0.5) * dg;
        for j in 0..n {
            let y = (f64::from(j) + 0.5) * dy;
            let xi = h + y * y;
            let b =
                (3.0 * g * (a - 1.0) - a.sqrt() * xi) / (2.0 * (2.0 * a - 3.0) * (a - 1.0)).sqrt();
            let tail = 2.0 * value(Order::Zero, b * 2f64.sqrt()); // erfc(B)
            if tail > 0.0 {
                let exponent = 1.5 * g * g - a * xi * xi / (2.0 * (a - 1.0));
                area += g * g * (exponent + tail.ln()).exp() * y * y * 2.0 * y * dg * dy;
            }
        }
    }
    area * 9.0 / (2.0 * TAU.sqrt()) * (a / (a - 1.0)).sqrt() * a.sqrt() / (6.0 * 3f64.sqrt())
}

fn summit_models(c: &mut Criterion) {
    let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: BANDWIDTH };
    let modulus = ContactModulus::from_pascals(1.0).expect("positive");
    let models = [
        ("Bush-Gibson-Thomas", SummitLaw::BushGibsonThomas),
        ("Greenwood elliptical", SummitLaw::GreenwoodElliptical),
        ("mean curvature", SummitLaw::MeanCurvature),
    ]
    .map(|(name, law)| (name, SummitModel::new(law, moments, modulus).expect("bandwidth 5")));
    for (name, model) in &models {
        c.bench_function(&format!("{name}/at_separation, error 4e-15"), |b| {
            b.iter(|| model.at_separation(black_box(1.0)));
        });
        c.bench_function(&format!("{name}/at_pressure, error 4e-15"), |b| {
            b.iter(|| model.at_pressure(black_box(0.01)));
        });
    }
    let exact = models[1].1.at_separation(1.0).expect("finite").area_fraction;
    for n in [50, 200, 800] {
        let error = (double_integral(1.0, n) / exact - 1.0).abs();
        c.bench_function(
            &format!("double integral of p(xi, g), {n}^2 points, error {error:.0e}"),
            |b| {
                b.iter(|| double_integral(black_box(1.0), n));
            },
        );
    }
    // The light-load asymptote A = sqrt(pi) p / (E* sqrt m2), one multiplication.
    let state = models[0].1.at_separation(1.0).expect("finite");
    let error = (PI.sqrt() * state.mean_pressure / state.area_fraction - 1.0).abs();
    c.bench_function(&format!("asymptote A = sqrt(pi) p, error {error:.0e}"), |b| {
        b.iter(|| PI.sqrt() * black_box(0.01));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(std::time::Duration::from_millis(300))
        .measurement_time(std::time::Duration::from_millis(800));
    targets = summit_models
}
criterion_main!(benches);
