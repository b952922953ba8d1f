//! What the tests share: surfaces made in memory from a seed, solves, and what is wrong with a solution.

#![allow(dead_code, reason = "each test file uses some of these")]
#![allow(clippy::unwrap_used, reason = "tests may stop where their input is wrong")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::{Boundary, HalfSpace, Iteration, Load, Solution, Solver, SolverBuilder};
use grid_fft::GridFft;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Independent numbers, uniform in 0..1, from a seed (SplitMix64: the same on every machine).
pub(crate) struct Uniform(pub(crate) u64);

impl Uniform {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Standard normal (Box & Muller).
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.next()).ln()).sqrt();
        radius * (TAU * self.next()).cos()
    }
}

/// 1 Pa.
pub(crate) fn unit_modulus() -> ContactModulus {
    ContactModulus::from_pascals(1.0).unwrap()
}

/// Unit pixels.
pub(crate) fn unit_grid(ny: usize, nx: usize) -> Grid {
    Grid::new([ny, nx], [1.0, 1.0]).unwrap()
}

/// Self-affine periodic heights: Hurst exponent `hurst`, roll-off and shortest wavelength in units
/// of the pixel side, rms gradient (from the spectrum) 1.
pub(crate) fn self_affine(
    grid: Grid,
    hurst: f64,
    rolloff: f64,
    cutoff: f64,
    seed: u64,
) -> HeightMap {
    let mut random = Uniform(seed);
    let white: Vec<f64> = (0..grid.len()).map(|_| random.normal()).collect();
    filtered(grid, &white, |wave| match grid.wavenumber(wave[0], wave[1]) {
        q if q <= 0.0 || q > 1.0001 * TAU / cutoff => 0.0,
        q => (q * rolloff / TAU).max(1.0).powf(-(hurst + 1.0)),
    })
}

/// White noise whose waves `[ky, kx]` are multiplied by an amplitude each; rms gradient (from the spectrum) 1.
pub(crate) fn filtered(
    grid: Grid,
    white: &[f64],
    amplitude: impl Fn([usize; 2]) -> f64,
) -> HeightMap {
    let mut fft = GridFft::new(grid.shape());
    let mut spectrum = fft.new_spectrum();
    fft.forward(white, &mut spectrum);
    let nx = grid.shape()[1];
    let nq = nx / 2 + 1;
    let mut gradient2 = 0.0;
    for (i, wave) in spectrum.iter_mut().enumerate() {
        let q = grid.wavenumber(i / nq, i % nq);
        *wave *= amplitude([i / nq, i % nq]);
        let twice = if i % nq == 0 || 2 * (i % nq) == nx { 1.0 } else { 2.0 };
        gradient2 += twice * q * q * wave.norm_sqr();
    }
    let mut heights = vec![0.0; grid.len()];
    fft.inverse(&mut spectrum, &mut heights);
    let gradient = gradient2.sqrt() / grid.len() as f64;
    HeightMap::new(grid, heights.iter().map(|h| h / gradient).collect()).unwrap()
}

/// Like a measurement: a square crop of a surface twice as wide, hence not periodic, rough down to
/// the pixel and stepped by 1 % of its rms height; rms gradient about 1.
pub(crate) fn measured_like(n: usize, seed: u64) -> HeightMap {
    let large = self_affine(unit_grid(2 * n, 2 * n), 0.8, 8.0 * n as f64, 2.0, seed);
    let crop = |i: usize| large.at(i / n, i % n);
    let mean = (0..n * n).map(crop).sum::<f64>() / (n * n) as f64;
    let rms = ((0..n * n).map(|i| (crop(i) - mean).powi(2)).sum::<f64>() / (n * n) as f64).sqrt();
    let step = 0.01 * rms;
    let heights = (0..n * n).map(|i| (crop(i) / step).round() * step).collect();
    HeightMap::new(unit_grid(n, n), heights).unwrap()
}

pub(crate) fn to(tolerance: f64) -> SolverBuilder {
    Solver::builder().tolerance(tolerance)
}

/// A solver for E* = 1 Pa.
pub(crate) fn solver(grid: Grid, builder: SolverBuilder) -> Solver {
    builder.build(grid, unit_modulus()).unwrap()
}

/// Solves for a mean pressure, E* = 1 Pa.
pub(crate) fn solve(map: &HeightMap, builder: SolverBuilder, load: f64) -> Solution {
    let mut solver = solver(map.grid(), builder);
    solver.solve(map, Load::MeanPressure(load)).unwrap_or_else(|e| panic!("at {load:e}: {e}"))
}

/// The iterate after `count` iterations, if there are so many to 1e-13.
pub(crate) fn iterate(
    map: &HeightMap,
    builder: SolverBuilder,
    load: f64,
    count: usize,
) -> Solution {
    let mut solver = solver(map.grid(), builder.tolerance(1e-13));
    let watch = |now: &Iteration<'_>| {
        if now.number < count { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let found = solver.solve_observed(map, Load::MeanPressure(load), watch);
    found.or_else(|e| e.solution().cloned().ok_or(e)).unwrap()
}

/// Solves for one mean pressure after the other, each from the one before.
pub(crate) fn curve(solver: &mut Solver, map: &HeightMap, loads: &[f64]) -> Vec<Solution> {
    loads.iter().map(|load| solver.solve(map, Load::MeanPressure(*load)).unwrap()).collect()
}

/// Relative rms difference of two pressures.
pub(crate) fn difference(found: &[f64], exact: &[f64]) -> f64 {
    let square: f64 = found.iter().zip(exact).map(|(a, b)| (a - b).powi(2)).sum();
    (square / exact.iter().map(|p| p * p).sum::<f64>()).sqrt()
}

/// The displacement of a pressure, made apart from the solver.
pub(crate) fn displaced(grid: Grid, boundary: Boundary, pressure: &[f64]) -> Vec<f64> {
    let mut u = pressure.to_vec();
    HalfSpace::new(grid, unit_modulus(), boundary).displace(&mut u);
    u
}

/// `|p|_K`, by the half space of the boundary.
pub(crate) fn energy_norm(grid: Grid, boundary: Boundary, p: &[f64]) -> f64 {
    let u = displaced(grid, boundary, p);
    p.iter().zip(&u).map(|(p, u)| p * u).sum::<f64>().max(0.0).sqrt()
}
