//! What an answer costs beside what it is worth: every evaluation is
//! compared with 20-digit values before it is timed, and its worst relative error printed.
#![allow(clippy::print_stderr, reason = "the errors belong beside the times")]

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

/// Times one evaluation at one argument and prints its worst error over `exact`.
fn point(c: &mut Criterion, group: &str, name: &str, exact: &[(f64, f64)], f: impl Fn(f64) -> f64) {
    // Not f64::max, which would pass over a NaN.
    let larger = |worst: f64, error: f64| if error <= worst { worst } else { error };
    let worst = exact.iter().map(|&(x, y)| (f(x) / y - 1.0).abs()).fold(0.0, larger);
    eprintln!("{group}/{name}: worst relative error {worst:.1e}");
    let x = exact[exact.len() / 2].0;
    c.benchmark_group(group).bench_function(name, |b| b.iter(|| f(black_box(x))));
}

/// erf by Abramowitz & Stegun 7.1.26.
fn erf_fit(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.3275911 * x);
    let c = [0.254829592, -0.284496736, 1.421413741, -1.453152027, 1.061405429];
    1.0 - t * c.iter().rev().fold(0.0, |sum, c| sum * t + c) * (-x * x).exp()
}

fn persson_area(c: &mut Criterion) {
    // A at p/(E* g_rms) with g_rms = 1: 20 digits, mpmath.
    let exact = [
        (1e-4, 1.595769110967269965e-4),
        (0.01, 0.015956627433803962053),
        (0.1, 0.15851941887820604608),
        (0.5, 0.6826894921370858972),
        (1.0, 0.95449973610364158560),
    ];
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let model = Persson::from_moments(moments, unit()).expect("moments");
    let group = "Persson area";
    point(c, group, "model", &exact, |p| model.at_pressure(p).map_or(0.0, |s| s.area_fraction));
    point(c, group, "literal erf", &exact, |p| erf(2.0_f64.sqrt() * p));
    point(c, group, "fit of erf", &exact, |p| erf_fit(2.0_f64.sqrt() * p));
}

fn persson_gap(c: &mut Criterion) {
    // H = 0.8, q from 1 to 100, m0 = 1, E* = 1: 18 digits, mpmath.
    let exact = [
        (0.004609956908378556555884, 4.45685408288577318),
        (0.04609956908378556555884, 2.11170149755047092),
        (0.2304978454189278277942, 0.736639519083376392),
        (0.9219913816757113111767, 0.104490403242578407),
        (4.609956908378556555884, 0.000202307265049106644),
    ];
    let half = [
        (0.04609956908378556555884, 1.58571428602125967),
        (0.2304978454189278277942, 0.750846683589249057),
        (0.9219913816757113111767, 0.152605356093539627),
    ];
    let spectrum =
        SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).expect("a spectrum");
    let model = Persson::from_self_affine(spectrum, unit()).expect("a model");
    let model = model.with_gamma(1.0).expect("published gamma");
    let gap = |p: f64| model.mean_gap(p).unwrap_or(0.0);
    let group = "Persson mean gap";
    point(c, group, "model", &exact, gap);
    let with_gamma = model.clone().with_gamma(0.45).expect("published gamma");
    point(c, group, "model, gamma 0.45", &half, |p| with_gamma.mean_gap(p).unwrap_or(0.0));
    let [u0, b] = model.light_load().expect("a rough surface");
    point(c, group, "light-load logarithm", &exact, |p| u0 * (b / p).ln());

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
    // Real area of one bi-sinusoid: FFT solution, accurate to 5e-5.
    let exact =
        [(0.01, 0.036405), (0.1, 0.1906), (0.25, 0.443669), (0.5, 0.704252), (0.85, 0.924671)];
    let group = "sinusoid";
    point(c, group, "published fit", &exact, |x| SinusoidLaw::PublishedFit.area_fraction(x));
    point(c, group, "numerical table", &exact, |x| SinusoidLaw::NumericalTable.area_fraction(x));
}

fn fractals(c: &mut Criterion) {
    // Load at A = 0.1 over D, G = 1e-5, a_c = 1e-16: 20 digits, mpmath.
    let exact = [
        (1.499999999999, 1.4621852391454398235e-2),
        (1.5, 1.4621852391534747741e-2),
        (1.500000000001, 1.4621852391615097247e-2),
    ];
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
    point(c, group, "literal bracket", &exact, literal);
    point(c, group, "expm1", &exact, stable);
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .warm_up_time(std::time::Duration::from_millis(300))
        .measurement_time(std::time::Duration::from_secs(1));
    targets = persson_area, persson_gap, sinusoids, fractals
}
criterion_main!(benches);
