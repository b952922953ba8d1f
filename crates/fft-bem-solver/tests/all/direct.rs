//! Every method against the solution of small problems by dense linear algebra.

use crate::common;
use crate::dense;

use common::{Uniform, to};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::Method;

#[test]
fn every_method_finds_the_dense_solution() {
    let shapes = [
        ([8, 8], [1.0, 1.0]),
        ([7, 5], [0.3, 1.0]),
        ([1, 16], [5.0, 1.0]),
        ([11, 1], [1.0, 2.0]),
        ([6, 7], [1e3, 1.0]),
    ];
    for (seed, (shape, pixel)) in shapes.into_iter().enumerate() {
        let grid = Grid::new(shape, pixel).unwrap();
        let mut random = Uniform(seed as u64);
        let heights = (0..grid.len()).map(|_| random.normal()).collect();
        let map = HeightMap::new(grid, heights).unwrap();
        for load in [1e-3, 0.03, 0.2, 0.6, 3.0] {
            let known = dense::solution(&map, load);
            // Steepest descent takes as many steps as the stiffest wave is stiffer than the softest.
            let methods = [Method::Auto, Method::PolonskyKeer, Method::StanleyKato];
            for &method in &methods[..if pixel[0] > 100.0 { 2 } else { 3 }] {
                let found = common::solve(&map, to(1e-11).method(method), load);
                let off = (found.approach / known.approach - 1.0).abs();
                assert!(off < 1e-9, "{method:?} {shape:?} {load}: approach off by {off:e}");
                let scale = found.diagnostics.max_pressure;
                for (p, q) in found.pressure.iter().zip(&known.pressure) {
                    assert!((p - q).abs() < 1e-9 * scale, "{method:?} {shape:?} {load}: {p} {q}");
                }
                let (bottom, top) = map.range();
                for (g, known) in found.gap.iter().zip(&known.gap) {
                    assert!(
                        (g - known).abs() < 1e-9 * (top - bottom),
                        "{method:?} {shape:?} {load}"
                    );
                }
            }
        }
    }
}
