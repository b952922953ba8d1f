//! Time of whole solves by size, and of a load curve; and of the transforms whose number a solve is
//! counted in. The surface is self-affine (H = 0.8, roll-off an eighth of
//! the side, shortest wave 4 pixels, seed 1), the modulus 1.
#![allow(missing_docs, reason = "criterion's macros make undocumented functions")]

#[path = "../tests/common/mod.rs"]
mod common;

use common::{curve, self_affine, solver, to, unit_grid};
use contact_types::HeightMap;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fft_bem_solver::Load;
use grid_fft::GridFft;
use std::hint::black_box;

fn surface(n: usize) -> HeightMap {
    self_affine(unit_grid(n, n), 0.8, n as f64 / 8.0, 4.0, 1)
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
    let mut group = c.benchmark_group("solve/chord/f64");
    group.sample_size(10);
    for n in [64, 256, 1001, 1024] {
        let map = surface(n);
        for load in [0.02, 0.2] {
            let mut solver = solver(map.grid(), to(1e-4));
            group.throughput(Throughput::Elements((n * n) as u64));
            group.bench_function(BenchmarkId::new(format!("p={load},tolerance=1e-4"), n), |b| {
                b.iter(|| {
                    solver.forget();
                    solver.solve(black_box(&map), Load::MeanPressure(load))
                });
            });
        }
    }
    group.finish();
}

fn load_curve(c: &mut Criterion) {
    let mut group = c.benchmark_group("curve/16-loads");
    group.sample_size(10);
    let loads: Vec<f64> = (0..16).map(|i| 0.002 * 200f64.powf(f64::from(i) / 15.0)).collect();
    for n in [256, 1001] {
        let map = surface(n);
        let mut solver = solver(map.grid(), to(1e-4));
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

criterion_group!(benches, transforms, solves, load_curve);
criterion_main!(benches);
