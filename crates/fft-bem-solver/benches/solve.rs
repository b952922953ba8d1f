//! Time of whole solves by method, precision and size, and of a load curve; and of the transforms
//! whose number a solve is counted in. The surface is self-affine (H = 0.8, roll-off an eighth of
//! the side, shortest wave 4 pixels, seed 1), the modulus 1.
#![allow(missing_docs, reason = "criterion's macros make undocumented functions")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::{curve, self_affine, unit_grid, unit_modulus};
use contact_types::HeightMap;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fft_bem_solver::{Load, Method, Precision, Solver};
use grid_fft::GridFft;
use std::hint::black_box;

fn surface(n: usize) -> HeightMap {
    self_affine(unit_grid(n, n), 0.8, n as f64 / 8.0, 4.0, 1)
}

fn solver(map: &HeightMap, method: Method, precision: Precision) -> Solver {
    Solver::builder()
        .method(method)
        .precision(precision)
        .tolerance(1e-4)
        .build(map.grid(), unit_modulus())
        .expect("sound settings")
}

fn transforms(c: &mut Criterion) {
    let mut group = c.benchmark_group("kernels/transform-pair-one-thread");
    group.sample_size(10);
    for n in [256, 1001, 1024] {
        let mut field: Vec<f64> = (0..n * n).map(|i| (0.37 * i as f64).sin()).collect();
        let mut fft = GridFft::new([n, n]);
        let mut spectrum = fft.new_spectrum();
        group.throughput(Throughput::Elements((n * n) as u64));
        group.bench_function(BenchmarkId::from_parameter(n), |b| {
            b.iter(|| {
                fft.forward(black_box(&field), &mut spectrum);
                fft.inverse(&mut spectrum, &mut field);
            });
        });
    }
    group.finish();
}

fn solves(c: &mut Criterion) {
    for (method, sizes) in [
        (Method::Chord, &[64, 256, 1001, 1024][..]),
        (Method::PolonskyKeer, &[64, 256]),
        (Method::StanleyKato, &[64, 256]),
    ] {
        for (precision, name) in [(Precision::Double, "f64"), (Precision::Single, "f32")] {
            let mut group = c.benchmark_group(format!("solve/{method}/{name}"));
            group.sample_size(10);
            for &n in sizes {
                let map = surface(n);
                for load in [0.02, 0.2] {
                    let mut solver = solver(&map, method, precision);
                    let id = BenchmarkId::new(format!("p={load},tolerance=1e-4"), n);
                    group.throughput(Throughput::Elements((n * n) as u64));
                    group.bench_function(id, |b| {
                        b.iter(|| {
                            solver.forget();
                            solver.solve(black_box(&map), Load::MeanPressure(load))
                        });
                    });
                }
            }
            group.finish();
        }
    }
}

fn load_curve(c: &mut Criterion) {
    let mut group = c.benchmark_group("curve/16-loads");
    group.sample_size(10);
    let loads: Vec<f64> = (0..16).map(|i| 0.002 * 200f64.powf(f64::from(i) / 15.0)).collect();
    for n in [256, 1001] {
        let map = surface(n);
        let mut solver = solver(&map, Method::Auto, Precision::Double);
        group.throughput(Throughput::Elements((16 * n * n) as u64));
        group.bench_function(BenchmarkId::new("tolerance=1e-4", n), |b| {
            b.iter(|| {
                solver.forget();
                black_box(curve(&mut solver, black_box(&map), &loads));
            });
        });
    }
    group.finish();
}

/// Bodies that yield beside elastic ones, and the stiffness of the contact set, which is its conductance. The rms
/// gradient is 1.
fn yields(c: &mut Criterion) {
    let mut group = c.benchmark_group("yield/f64");
    group.sample_size(10);
    let (n, load) = (256, 0.05);
    let map = surface(n);
    group.throughput(Throughput::Elements((n * n) as u64));
    for hardness in [f64::INFINITY, 1.0, 0.5, 0.25] {
        let builder = Solver::builder().tolerance(1e-4).hardness(hardness);
        let mut solver = builder.build(map.grid(), unit_modulus()).expect("sound settings");
        group.bench_function(BenchmarkId::new(format!("solve,H={hardness}"), n), |b| {
            b.iter(|| {
                solver.forget();
                solver.solve(black_box(&map), Load::MeanPressure(load)).expect("converges")
            });
        });
        let found = solver.solve(&map, Load::MeanPressure(load)).expect("converges");
        group.bench_function(BenchmarkId::new(format!("stiffness,H={hardness}"), n), |b| {
            b.iter(|| black_box(solver.contact_stiffness(|i| found.pressure[i] > 0.0)));
        });
    }
    group.finish();
}

criterion_group!(benches, transforms, solves, load_curve, yields);
criterion_main!(benches);
