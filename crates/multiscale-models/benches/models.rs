//! What an answer costs.

use contact_types::{ContactModel, ContactModulus, RoughnessSpectrum, Shell, SpectralMoments};
use criterion::{Criterion, criterion_group, criterion_main};
use multiscale_models::{Persson, SelfAffineSpectrum};
use std::hint::black_box;

fn persson(c: &mut Criterion) {
    let unit = ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus");
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let area = Persson::from_moments(moments, unit).expect("moments");
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0);
    let gap = Persson::from_self_affine(spectrum.expect("a spectrum"), unit);
    let weighed = |gamma: f64| gap.clone().with_gamma(gamma).expect("published gamma");
    let measured = |shells: i32| {
        let shell = |i: i32| {
            let wavenumber = (4.6 * f64::from(i) / f64::from(shells)).exp();
            Shell { wavenumber, variance: wavenumber.powf(-1.6) / f64::from(shells) }
        };
        let spectrum = RoughnessSpectrum::new((0..shells).map(shell).collect()).expect("shells");
        Persson::from_spectrum(spectrum, unit).expect("a model")
    };
    for (name, model, pressure) in [
        ("Persson area/model", area, 0.1),
        ("Persson mean gap/model", weighed(1.0), 0.23),
        ("Persson mean gap/model, gamma 0.45", weighed(0.45), 0.23),
        ("Persson mean gap/model, 64 shells", measured(64), 0.2),
        ("Persson mean gap/model, 512 shells", measured(512), 0.2),
        ("Persson mean gap/model, 8192 shells", measured(8192), 0.2),
    ] {
        c.bench_function(name, |b| b.iter(|| model.at_pressure(black_box(pressure))));
    }
}

criterion_group!(benches, persson);
criterion_main!(benches);
