//! Reading a map of 1024 x 1024 points, per point.
#![allow(missing_docs, reason = "criterion's macros write undocumented functions")]
#![allow(clippy::unwrap_used, reason = "a benchmark that cannot run should say so")]

use contact_types::{Grid, HeightMap};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::fmt::Write as _;
use std::hint::black_box;
use std::io::Cursor;
use surface_io::{HeightUnit, ReadOptions, read_bytes, write};

const N: usize = 1024;

fn map() -> HeightMap {
    let grid = Grid::new([N, N], [1e-6, 1e-6]).unwrap();
    HeightMap::from_fn(grid, |y, x| 1e-6 * (4e4 * x).sin() * (3e4 * y).cos() + 1e-3 * x).unwrap()
}

/// A matrix in nm with the header that gives its scale.
fn matrix(map: &HeightMap) -> String {
    let mut text = format!("# Width: {N} um\n# Height: {N} um\n# Value units: nm\n");
    for iy in 0..N {
        for ix in 0..N {
            let end = if ix + 1 == N { '\n' } else { '\t' };
            write!(text, "{:.3}{end}", 1e9 * map.at(iy, ix)).unwrap();
        }
    }
    text
}

fn list(map: &HeightMap) -> String {
    let mut text = String::from("x [um]\ty [um]\tz [nm]\n");
    for iy in 0..N {
        for ix in 0..N {
            writeln!(text, "{ix}.0\t{iy}.0\t{:.3}", 1e9 * map.at(iy, ix)).unwrap();
        }
    }
    text
}

fn reading(criterion: &mut Criterion) {
    let map = map();
    let mut group = criterion.benchmark_group("read");
    group.throughput(Throughput::Elements((N * N) as u64)).sample_size(10);
    let mut npy = Vec::new();
    write::npy(&mut npy, map.grid().shape(), map.heights()).unwrap();
    let mut sdf = Vec::new();
    write::sdf(&mut sdf, &map).unwrap();
    let mut x3p = Cursor::new(Vec::new());
    write::x3p(&mut x3p, &map, "").unwrap();
    let files = [
        ("npy", npy),
        ("sdf", sdf),
        ("x3p", x3p.into_inner()),
        ("matrix", matrix(&map).into_bytes()),
        ("xyz", list(&map).into_bytes()),
    ];
    let options = ReadOptions {
        pixel: Some([1e-6; 2]),
        height_unit: Some(HeightUnit::IfSilent(1.0)),
        ..ReadOptions::default()
    };
    for (name, bytes) in files {
        group.bench_function(name, |b| b.iter(|| read_bytes(black_box(&bytes), &options).unwrap()));
    }
    group.finish();
}

criterion_group!(benches, reading);
criterion_main!(benches);
