//! The solution of small problems by dense linear algebra, from the definition of the periodic
//! half space and the conditions of contact alone.

use contact_types::{Grid, HeightMap};
use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use std::f64::consts::TAU;

/// `K[i][j]`: displacement of pixel i under unit pressure on pixel j, as the defining sum over
/// waves, `1/(ny nx) sum_q 2/|q| cos q (x_i - x_j)` (E* = 1 Pa).
fn compliance(grid: Grid) -> Mat<f64> {
    let [ny, nx] = grid.shape();
    let signed = |k: usize, n: usize| if 2 * k <= n { k as f64 } else { k as f64 - n as f64 };
    let [ly, lx] = grid.size();
    let kernel = |iy: usize, ix: usize| {
        let mut sum = 0.0;
        for ky in 0..ny {
            for kx in 0..nx {
                if (ky, kx) != (0, 0) {
                    let q = TAU * (signed(ky, ny) / ly).hypot(signed(kx, nx) / lx);
                    let turns = (ky * iy) as f64 / ny as f64 + (kx * ix) as f64 / nx as f64;
                    sum += 2.0 / q * (TAU * turns).cos();
                }
            }
        }
        sum / (ny * nx) as f64
    };
    let table: Vec<f64> = (0..ny * nx).map(|i| kernel(i / nx, i % nx)).collect();
    Mat::from_fn(ny * nx, ny * nx, |i, j| {
        let dy = (i / nx + ny - j / nx) % ny;
        let dx = (i % nx + nx - j % nx) % nx;
        table[dy * nx + dx]
    })
}

/// What a contact of E* = 1 Pa looks like.
pub(crate) struct Dense {
    pub(crate) pressure: Vec<f64>,
    /// 0 in contact.
    pub(crate) gap: Vec<f64>,
    pub(crate) approach: f64,
}

/// By an active set: solve on the contact, drop tension, take in overlap, until neither is left.
/// The conditions are checked at the end, so a wrong set cannot pass.
pub(crate) fn solution(map: &HeightMap, mean_pressure: f64) -> Dense {
    let k = compliance(map.grid());
    let (n, h) = (map.grid().len(), map.heights());
    let (bottom, top) = map.range();
    let rounding = 1e-14 * (top - bottom);
    let mut contact = vec![true; n];
    for _ in 0..200 {
        let on: Vec<usize> = (0..n).filter(|&i| contact[i]).collect();
        let m = on.len();
        // [K -1; -1' 0] [p; level] = [h; -load]
        let system = Mat::from_fn(m + 1, m + 1, |a, b| match (a < m, b < m) {
            (true, true) => k[(on[a], on[b])],
            (false, false) => 0.0,
            _ => -1.0,
        });
        let right = |a: usize| if a < m { h[on[a]] - top } else { -mean_pressure * n as f64 };
        let right = Mat::from_fn(m + 1, 1, |a, _| right(a));
        let x = system.lblt(Side::Lower).solve(&right);
        let level = x[(m, 0)];
        let mut p = vec![0.0; n];
        for (a, &i) in on.iter().enumerate() {
            p[i] = x[(a, 0)];
        }
        let gap = |i: usize| (0..n).map(|j| k[(i, j)] * p[j]).sum::<f64>() - (h[i] - top) - level;
        let tension: Vec<usize> = on.iter().copied().filter(|&i| p[i] < 0.0).collect();
        if tension.is_empty() {
            let gaps: Vec<f64> = (0..n).map(|i| if contact[i] { 0.0 } else { gap(i) }).collect();
            let worst = (0..n).min_by(|&i, &j| gaps[i].total_cmp(&gaps[j]));
            match worst.filter(|&i| gaps[i] < -rounding) {
                None => return Dense { pressure: p, gap: gaps, approach: level },
                Some(i) => contact[i] = true,
            }
        }
        for i in tension {
            contact[i] = false;
        }
    }
    panic!("the active set did not settle");
}
