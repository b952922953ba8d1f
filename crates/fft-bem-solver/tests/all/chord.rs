//! What must not matter to any method: threads, the shape of the grid, the precision.

use crate::common;

use common::{Uniform, difference, self_affine, unit_grid, unit_modulus};
use contact_types::{Grid, HeightMap};
use fft_bem_solver::{Boundary, Load, Method, Precision, Solution, Solver};

/// Lines and odd sides too.
#[test]
fn agrees_with_polonsky_keer() {
    for (shape, load) in [([64, 64], 0.05), ([61, 90], 0.2), ([1, 257], 0.1), ([257, 1], 0.1)] {
        let surface = self_affine(unit_grid(shape[0], shape[1]), 0.7, 20.0, 3.0, 3);
        let [chord, conjugate] = [Method::Chord, Method::PolonskyKeer].map(|method| {
            common::solve(&surface, Solver::builder().method(method).tolerance(1e-9), load)
        });
        let error = difference(&chord.pressure, &conjugate.pressure);
        assert!(error < 1e-7, "{shape:?}: {error:e}");
        assert!(chord.diagnostics.transforms < 0.5 * conjugate.diagnostics.transforms);
    }
}

/// Sums are taken piece by piece, so the number of threads changes no bit, whatever the method.
#[test]
fn threads_change_no_bit() {
    let surface = self_affine(unit_grid(260, 233), 0.8, 30.0, 2.0, 11);
    let with = |method| Solver::builder().method(method);
    let free = with(Method::Chord).boundary(Boundary::Free);
    for builder in [
        with(Method::Chord),
        with(Method::Chord).precision(Precision::Single),
        free,
        with(Method::PolonskyKeer).tolerance(0.05),
        with(Method::StanleyKato).tolerance(0.05),
    ] {
        let solved = [1, 2, 3].map(|n| common::solve(&surface, builder.clone().threads(n), 0.05));
        let bits = |s: &Solution| -> Vec<u64> {
            let fields = s.pressure.iter().chain(&s.gap).chain([&s.diagnostics.transforms]);
            fields.map(|x| x.to_bits()).collect()
        };
        let [one, two, three] = solved.each_ref().map(bits);
        assert!(one == two && one == three, "{builder:?}");
        assert!(
            solved.iter().all(|s| s.diagnostics.iterations == solved[0].diagnostics.iterations)
        );
    }
}

/// From 1 x N to pixels of 1:1000, from a single spike to a plateau, all loads.
#[test]
fn odd_grids_and_surfaces_converge() {
    let mut random = Uniform(7);
    let maps: [([usize; 2], [f64; 2]); 8] = [
        ([1, 1], [1.0, 1.0]),
        ([1, 2], [1.0, 1.0]),
        ([3, 2], [1.0, 5.0]),
        ([1, 1009], [1.0, 1.0]),
        ([1009, 1], [1.0, 1.0]),
        ([5, 331], [1.0, 1.0]),
        ([127, 131], [1.0, 1.0]),
        ([64, 96], [1.0, 1000.0]),
    ];
    for (shape, pixel) in maps {
        let grid = Grid::new(shape, pixel).unwrap();
        let noise: Vec<f64> = (0..grid.len()).map(|_| random.normal()).collect();
        let mut spike = vec![0.0; grid.len()];
        spike[grid.len() / 2] = 1.0;
        let plateau: Vec<f64> = noise.iter().map(|h| h.min(0.0)).collect();
        let offset: Vec<f64> = noise.iter().map(|h| 1e6 + h).collect();
        for (kind, heights) in
            [("noise", noise), ("spike", spike), ("plateau", plateau), ("offset", offset)]
        {
            let surface = HeightMap::new(grid, heights).unwrap();
            for load in [1e-9, 1e-3, 0.1, 100.0] {
                let builder = Solver::builder().method(Method::Chord).tolerance(1e-8);
                let mut solver = builder.build(grid, unit_modulus()).unwrap();
                let found = solver.solve(&surface, Load::MeanPressure(load));
                let found = found.unwrap_or_else(|e| {
                    panic!("{kind} on {shape:?} of {pixel:?} at {load:e}: {e}")
                });
                let mean = found.pressure.iter().sum::<f64>() / grid.len() as f64;
                assert!((mean / load - 1.0).abs() < 1e-9, "{shape:?}: {mean} for {load}");
                assert!(found.pressure.iter().all(|p| *p >= 0.0));
            }
        }
    }
}

#[test]
fn single_precision_reaches_what_it_states() {
    let surface = self_affine(unit_grid(128, 150), 0.8, 20.0, 2.0, 2);
    let with = |precision| Solver::builder().precision(precision);
    let exact = common::solve(&surface, with(Precision::Double).tolerance(1e-10), 0.05);
    let found = common::solve(&surface, with(Precision::Single).tolerance(2e-5), 0.05);
    let error = difference(&found.pressure, &exact.pressure);
    assert!(error < 2e-5, "{error:e}");
}
