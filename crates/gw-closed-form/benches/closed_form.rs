//! What an answer costs and what it is worth: the load integral J_3/2 by every route. The largest
//! relative error over the arguments timed is part of each name.
//!
//! ```console
//! $ cargo bench -p gw-closed-form
//! ```
#![allow(missing_docs, reason = "criterion's macros make undocumented items")]

use contact_types::{ContactModel, ContactModulus, SeparationModel, SpectralMoments};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use gw_closed_form::partial_moments::{Order, value};
use gw_closed_form::{GreenwoodWilliamson, inverse};
use std::hint::black_box;

#[path = "../tests/literal.rs"]
mod literal;

fn load_integral(c: &mut Criterion) {
    // Separations of practical contacts, α = -1 to 4.
    let arguments: Vec<f64> = (0..100).map(|k| -1.0 + 0.05 * f64::from(k) + 1e-3).collect();
    let stable: fn(f64) -> f64 = |alpha| value(Order::ThreeHalves, alpha);
    let routes = [("closed form, stable", stable), ("closed form, literal (A1)", literal::load_a1)];
    let mut group = c.benchmark_group("J_3div2 per point, alpha -1 to 4");
    group.throughput(Throughput::Elements(arguments.len() as u64));
    for (name, route) in routes {
        let error = arguments.iter().map(|&a| (route(a) / stable(a) - 1.0).abs());
        let error = error.fold(f64::EPSILON, f64::max); // the yardstick itself
        group.bench_function(BenchmarkId::new(name, format!("error {error:.0e}")), |b| {
            b.iter(|| arguments.iter().map(|&a| route(black_box(a))).sum::<f64>());
        });
    }
    group.finish();
    c.bench_function("inverse from load 1e-3, error 4e-15", |b| {
        b.iter(|| inverse::from_value(black_box(1e-3)));
    });
}

fn model(c: &mut Criterion) {
    let moments = SpectralMoments { m0: 1e-12, m2: 1e-2, m4: 1e9 };
    let modulus = ContactModulus::from_pascals(110e9).expect("positive");
    let model = GreenwoodWilliamson::from_moments(moments, modulus).expect("bandwidth 10");
    c.bench_function("model/at_separation, error 2e-15", |b| {
        b.iter(|| model.at_separation(black_box(2e-6)));
    });
    c.bench_function("model/at_pressure, error 2e-15", |b| {
        b.iter(|| model.at_pressure(black_box(1e8)));
    });
}

criterion_group!(benches, load_integral, model);
criterion_main!(benches);
