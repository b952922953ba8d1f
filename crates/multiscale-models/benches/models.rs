//! What an answer costs.

use contact_types::{ContactModel, ContactModulus, RoughnessSpectrum, Shell, SpectralMoments};
use criterion::{Criterion, criterion_group, criterion_main};
use multiscale_models::{Persson, SelfAffineSpectrum};
use std::hint::black_box;

fn unit() -> ContactModulus {
    ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus")
}

fn point(c: &mut Criterion, group: &str, name: &str, x: f64, f: impl Fn(f64) -> f64) {
    c.benchmark_group(group).bench_function(name, |b| b.iter(|| f(black_box(x))));
}

fn persson_area(c: &mut Criterion) {
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let model = Persson::from_moments(moments, unit()).expect("moments");
    let group = "Persson area";
    point(c, group, "model", 0.1, |p| model.at_pressure(p).map_or(0.0, |s| s.area_fraction));
}

fn gap(model: &Persson, pressure: f64) -> f64 {
    model.at_pressure(pressure).ok().and_then(|state| state.mean_gap).unwrap_or(0.0)
}

fn persson_gap(c: &mut Criterion) {
    let spectrum =
        SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).expect("a spectrum");
    let model = Persson::from_self_affine(spectrum, unit());
    let model = model.with_gamma(1.0).expect("published gamma");
    let group = "Persson mean gap";
    point(c, group, "model", 0.23, |p| gap(&model, p));
    let with_gamma = model.clone().with_gamma(0.45).expect("published gamma");
    point(c, group, "model, gamma 0.45", 0.23, |p| gap(&with_gamma, p));
    for shells in [64, 512, 8192] {
        let shell = |i: i32| {
            let wavenumber = (4.6 * f64::from(i) / f64::from(shells)).exp();
            Shell { wavenumber, variance: wavenumber.powf(-1.6) / f64::from(shells) }
        };
        let spectrum = RoughnessSpectrum::new((0..shells).map(shell).collect()).expect("shells");
        let model = Persson::from_spectrum(spectrum, unit()).expect("a model");
        let name = format!("model, {shells} shells");
        c.benchmark_group(group).bench_function(name, |b| b.iter(|| gap(&model, black_box(0.2))));
    }
}

criterion_group!(benches, persson_area, persson_gap);
criterion_main!(benches);
