//! Time of one application of the half space, the unit in which a solve is counted, and of the
//! transforms it is made of.
#![allow(missing_docs, reason = "criterion's macros make undocumented functions")]

use contact_types::{ContactModulus, Grid};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fft_bem_solver::{Boundary, HalfSpace, Real};
use grid_fft::GridFft;
use std::hint::black_box;

const SIZES: [usize; 3] = [256, 1001, 1024];

fn grid(n: usize) -> Grid {
    Grid::new([n, n], [1e-6, 1e-6]).expect("a grid of positive pixels")
}

fn modulus() -> ContactModulus {
    ContactModulus::from_pascals(1e11).expect("a positive modulus")
}

fn field<T: Real>(n: usize) -> Vec<T> {
    (0..n * n).map(|i| T::of((0.37 * i as f64).sin())).collect()
}

fn transforms(c: &mut Criterion) {
    let mut group = c.benchmark_group("kernels/transform-pair-one-thread");
    group.sample_size(10);
    for n in SIZES {
        let (mut fft, mut field) = (GridFft::new([n, n]), field::<f64>(n));
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

fn displace<T: Real>(c: &mut Criterion, precision: &str) {
    let mut group = c.benchmark_group(format!("kernels/displace/{precision}"));
    group.sample_size(10);
    for n in SIZES {
        let mut values = field::<T>(n);
        group.throughput(Throughput::Elements((n * n) as u64));
        for boundary in [Boundary::Periodic, Boundary::Free] {
            let mut half_space = HalfSpace::<T>::new(grid(n), modulus(), boundary);
            group.bench_function(BenchmarkId::new(boundary.to_string(), n), |b| {
                b.iter(|| half_space.displace(black_box(&mut values)));
            });
        }
    }
    group.finish();
}

fn both_precisions(c: &mut Criterion) {
    displace::<f64>(c, "f64");
    displace::<f32>(c, "f32");
}

criterion_group!(benches, transforms, both_precisions);
criterion_main!(benches);
