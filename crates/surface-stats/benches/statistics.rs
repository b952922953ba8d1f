//! Time of statistics and cleaning by number of points. The surface is the same at every size:
//! a self-affine one in steps of 1 nm, 8 roll-off wavelengths wide.
#![allow(missing_docs, reason = "criterion's macros make undocumented functions")]

use contact_types::{Grid, HeightMap, Named};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use surface_stats::clean::{Form, Step, apply};
use surface_stats::iso25178::Iso;
use surface_stats::spectrum::{amplitudes, radial};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, StatsOptions, SurfaceStatistics, level, moments};

fn recipe(n: usize) -> SelfAffine {
    SelfAffine {
        grid: Grid::new([n, n], [1e-6, 1e-6]).expect("a grid of positive pixels"),
        hurst: 0.8,
        rolloff: n as f64 / 8.0 * 1e-6,
        cutoff: 4e-6,
        scale: Scale::RmsHeight(0.5e-6),
        seed: 1,
        quantise: Some(1e-9),
    }
}

fn surface(n: usize) -> HeightMap {
    recipe(n).generate().expect("a sound recipe")
}

/// Everything a model can ask, at three sizes.
fn whole(c: &mut Criterion) {
    let mut group = c.benchmark_group("statistics/of");
    group.sample_size(10);
    for n in [256, 1024, 4096] {
        let map = surface(n);
        group.throughput(Throughput::Elements((n * n) as u64));
        for edges in [Edges::Open, Edges::Periodic] {
            let options = StatsOptions { level: Level::Plane, edges, ..StatsOptions::default() };
            group.bench_with_input(BenchmarkId::new(edges.name(), n), &map, |b, map| {
                b.iter(|| SurfaceStatistics::of(black_box(map), &options));
            });
        }
    }
    group.finish();
}

/// The parts, and the cleaning steps, at one size.
fn parts(c: &mut Criterion) {
    let n = 1024;
    let map = surface(n);
    let (grid, open) = (map.grid(), Edges::Open);
    let mut group = c.benchmark_group("statistics/parts");
    group.sample_size(10);
    group.throughput(Throughput::Elements((n * n) as u64));
    group.bench_function("level-plane", |b| b.iter(|| level(black_box(&map), Level::Plane)));
    group.bench_function("differences", |b| b.iter(|| moments(black_box(&map), open)));
    group.bench_function("radial-spectrum", |b| b.iter(|| radial(black_box(&map))));
    group.bench_function("amplitudes", |b| b.iter(|| amplitudes(black_box(&map))));
    group.bench_function("iso25178", |b| b.iter(|| Iso::of(black_box(&map), open)));
    for (name, step, edges) in [
        ("outliers", Step::Outliers(8.0), open),
        ("sphere", Step::Form(Form::Sphere), open),
        ("gaussian-open-25-pixels", Step::SFilter(25e-6), open),
        ("gaussian-periodic", Step::SFilter(25e-6), Edges::Periodic),
    ] {
        group.bench_function(name, |b| {
            b.iter(|| apply(grid, &mut black_box(map.heights()).to_vec(), &[step], edges));
        });
    }
    group.bench_function("synthesis", |b| b.iter(|| recipe(black_box(n)).generate()));
    group.finish();
}

criterion_group!(benches, whole, parts);
criterion_main!(benches);
