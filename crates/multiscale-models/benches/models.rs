//! What an answer costs, beside the literal formulas and fits that others use.

use contact_types::{
    ContactModel, ContactModulus, FractalParameters, RoughnessSpectrum, Shell, SpectralMoments,
};
use criterion::{Criterion, criterion_group, criterion_main};
use libm::erf;
use multiscale_models::{MajumdarBhushan, Persson, SelfAffineSpectrum, SinusoidLaw};
use std::f64::consts::PI;
use std::hint::black_box;

fn unit() -> ContactModulus {
    ContactModulus::from_pascals(1.0).expect("1 Pa is a modulus")
}

fn point(c: &mut Criterion, group: &str, name: &str, x: f64, f: impl Fn(f64) -> f64) {
    c.benchmark_group(group).bench_function(name, |b| b.iter(|| f(black_box(x))));
}

/// erf by Abramowitz & Stegun 7.1.26.
fn erf_fit(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.3275911 * x);
    let c = [0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429];
    1.0 - t * c.iter().rev().fold(0.0, |sum, c| sum * t + c) * (-x * x).exp()
}

fn persson_area(c: &mut Criterion) {
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let model = Persson::from_moments(moments, unit()).expect("moments");
    let group = "Persson area";
    point(c, group, "model", 0.1, |p| model.at_pressure(p).map_or(0.0, |s| s.area_fraction));
    point(c, group, "literal erf", 0.1, |p| erf(2.0_f64.sqrt() * p));
    point(c, group, "fit of erf", 0.1, |p| erf_fit(2.0_f64.sqrt() * p));
}

fn persson_gap(c: &mut Criterion) {
    let spectrum =
        SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).expect("a spectrum");
    let model = Persson::from_self_affine(spectrum, unit()).expect("a model");
    let model = model.with_gamma(1.0).expect("published gamma");
    let gap = |p: f64| model.mean_gap(p).unwrap_or(0.0);
    let group = "Persson mean gap";
    point(c, group, "model", 0.23, gap);
    let with_gamma = model.clone().with_gamma(0.45).expect("published gamma");
    point(c, group, "model, gamma 0.45", 0.23, |p| with_gamma.mean_gap(p).unwrap_or(0.0));
    let [u0, b] = model.light_load().expect("a rough surface");
    point(c, group, "light-load logarithm", 0.23, |p| u0 * (b / p).ln());

    for shells in [64, 512, 8192] {
        let shell = |i: i32| {
            let wavenumber = (4.6 * f64::from(i) / f64::from(shells)).exp();
            Shell { wavenumber, variance: wavenumber.powf(-1.6) / f64::from(shells) }
        };
        let spectrum = RoughnessSpectrum::new((0..shells).map(shell).collect()).expect("shells");
        let model = Persson::from_spectrum(spectrum, unit()).expect("a model");
        let name = format!("model, {shells} shells");
        c.benchmark_group(group)
            .bench_function(name, |b| b.iter(|| model.mean_gap(black_box(0.2)).unwrap_or(0.0)));
    }
}

fn sinusoids(c: &mut Criterion) {
    let group = "sinusoid";
    point(c, group, "published fit", 0.25, |x| SinusoidLaw::PublishedFit.area_fraction(x));
    point(c, group, "numerical table", 0.25, |x| SinusoidLaw::NumericalTable.area_fraction(x));
}

fn fractals(c: &mut Criterion) {
    let (g, area, critical) = (1e-5_f64, 0.1, 1e-16_f64);
    let literal = |d: f64| {
        let largest = (2.0 - d) / d * area;
        let epsilon = (3.0 - 2.0 * d) / 2.0;
        4.0 * PI.sqrt() / 3.0 * g.powf(d - 1.0) * d / 2.0
            * largest.powf(d / 2.0)
            * (largest.powf(epsilon) - critical.powf(epsilon))
            / epsilon
    };
    let stable = |d: f64| {
        let surface = FractalParameters { dimension: d, roughness: g };
        MajumdarBhushan::new(surface, 1.0, unit())
            .and_then(|m| m.with_critical_area(critical))
            .and_then(|m| m.pressure_at_area(area))
            .unwrap_or(0.0)
    };
    let group = "Majumdar-Bhushan load";
    point(c, group, "literal bracket", 1.5 - 1e-12, literal);
    point(c, group, "expm1", 1.5 - 1e-12, stable);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(std::time::Duration::from_millis(300))
        .measurement_time(std::time::Duration::from_secs(1));
    targets = persson_area, persson_gap, sinusoids, fractals
}
criterion_main!(benches);
