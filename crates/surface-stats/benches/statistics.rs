//! Time of statistics by number of points. The surface is the same at every size: a self-affine one in
//! steps of 1 nm, 8 roll-off wavelengths wide.
#![allow(missing_docs, reason = "criterion's macros make undocumented functions")]

use contact_types::{Grid, HeightMap, Named};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, StatsOptions, SurfaceStatistics};

fn surface(n: usize) -> HeightMap {
    let recipe = SelfAffine {
        grid: Grid::new([n, n], [1e-6, 1e-6]).expect("a grid of positive pixels"),
        hurst: 0.8,
        rolloff: n as f64 / 8.0 * 1e-6,
        cutoff: 4e-6,
        scale: Scale::RmsHeight(0.5e-6),
        seed: 1,
        quantise: Some(1e-9),
    };
    recipe.generate().expect("a sound recipe")
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

criterion_group!(benches, whole);
criterion_main!(benches);
