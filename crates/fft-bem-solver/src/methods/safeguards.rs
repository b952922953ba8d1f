//! Tests that force each safeguard of the chord iteration.

use super::baseline::Baseline;
use super::chord::Chord;
use super::contract::{ContactMethod, ContactTask, Means, Outcome, Start, State, Target};
use super::polonsky_keer::PolonskyKeer;
use super::stanley_kato::StanleyKato;
use crate::problem::{self, Problem};
use crate::simd::IS_PLAIN;
use crate::{Boundary, End, HalfSpace, Real, fields};
use contact_types::{ContactModulus, Grid, HeightMap};
use std::ops::ControlFlow;
use std::sync::atomic::Ordering;

fn surface() -> (Problem<f64>, Grid) {
    surface_of([30, 26])
}

fn surface_of<T: Real>(shape: [usize; 2]) -> (Problem<T>, Grid) {
    let grid = Grid::new(shape, [1.0, 1.0]).unwrap();
    let map = HeightMap::from_fn(grid, |y, x| {
        (0.7 * y).sin() * (0.9 * x + 0.2 * y).cos() + 0.3 * (2.1 * x - 1.3 * y).sin()
    })
    .unwrap();
    let scaled = problem::scaled_grid(grid).unwrap();
    let modulus = ContactModulus::from_pascals(1.0).unwrap();
    (Problem::new(&map, scaled, modulus).unwrap(), scaled)
}

fn run<T: Real>(
    method: &mut dyn ContactMethod<T>,
    problem: &Problem<T>,
    tolerance: f64,
    load: f64,
) -> (Outcome, State<T>) {
    run_up_to(20_000, method, problem, tolerance, load)
}

fn run_up_to<T: Real>(
    max_iterations: usize,
    method: &mut dyn ContactMethod<T>,
    problem: &Problem<T>,
    tolerance: f64,
    load: f64,
) -> (Outcome, State<T>) {
    let mut half_space = HalfSpace::scaled(problem.grid, Boundary::Periodic);
    let mut state = State::new(problem.grid.len());
    let (target, start, ceiling) = (Target::Pressure(load), Start::Cold, f64::INFINITY);
    let ends_on_trial = false;
    let task =
        ContactTask { problem, target, start, ceiling, tolerance, max_iterations, ends_on_trial };
    let mut watch = |_: &super::contract::IterateView<'_, T>| ControlFlow::Continue(());
    let (operator, watch) = (&mut half_space, &mut watch);
    (method.solve(&task, Means { operator, state: &mut state, watch }), state)
}

fn difference(a: &State<f64>, b: &State<f64>) -> f64 {
    let n = a.pressure.len();
    let square = fields::sum_of(n, |i| (a.pressure[i] - b.pressure[i]).powi(2));
    (square / fields::dot(&b.pressure, &b.pressure)).sqrt()
}

/// The pressure that Polonsky & Keer's method finds.
fn exact(problem: &Problem<f64>, load: f64) -> State<f64> {
    let mut method = Baseline::<f64, PolonskyKeer>::new(problem.grid.len());
    run(&mut method, problem, 1e-11, load).1
}

/// With the step before and, as on grids on which memory is what limits, without.
#[test]
fn steps_find_the_solution_with_and_without_the_one_before() {
    let (problem, grid) = surface();
    for load in [0.003, 0.05, 0.2] {
        let exact = exact(&problem, load);
        for has_room in [true, false] {
            let mut chord = Chord::new(grid, false);
            if !has_room {
                chord.work.pairs.before = State::new(0);
            }
            let (outcome, found) = run(&mut chord, &problem, 1e-8, load);
            assert_eq!(outcome.end, End::Converged, "{load}");
            let error = difference(&found, &exact);
            assert!(error < 1e-7, "{load}: {error:e}");
            assert_eq!(chord.work.pairs.has_room(), has_room);
        }
    }
}

/// Out of iterations each method says so, and what it reached carries the load.
#[test]
fn a_run_that_ends_early_hands_over_what_it_reached() {
    let (problem, grid) = surface();
    let n = problem.grid.len();
    let methods: [Box<dyn ContactMethod<f64>>; 3] = [
        Box::new(Chord::new(grid, false)),
        Box::new(Baseline::<f64, PolonskyKeer>::new(n)),
        Box::new(Baseline::<f64, StanleyKato>::new(n)),
    ];
    for mut method in methods {
        let (outcome, found) = run_up_to(3, method.as_mut(), &problem, 1e-12, 0.05);
        assert_eq!((outcome.end, outcome.iterations), (End::Exhausted, 3));
        assert!(outcome.residual.is_finite());
        assert!((fields::mean(&found.pressure) / 0.05 - 1.0).abs() < 1e-12);
    }
}

/// With `S` zero, far too weak, far too strong, or of the wrong sign in parts, chords stay, stall or climb; the fallback
/// still arrives.
#[test]
fn a_bad_preconditioner_costs_time_only() {
    let (problem, grid) = surface();
    let exact = exact(&problem, 0.05);
    for (factor, ripple) in [(0.0, 0.0), (0.02, 0.0), (30.0, 0.0), (-1.0, 0.0), (1.0, 3.0)] {
        let mut chord = Chord::new(grid, false);
        chord.work.stiffness.spoil(factor, ripple);
        let (outcome, found) = run(&mut chord, &problem, 1e-8, 0.05);
        assert_eq!(outcome.end, End::Converged, "{factor} {ripple}");
        let error = difference(&found, &exact);
        // The estimate is made with the same S: weak by the same factor.
        assert!(error < 1e-6, "{factor} {ripple}: {error:e}");
    }
}

/// Answers are the same to the last bit whatever the vectors of the processor.
#[test]
fn vectors_change_no_bit() {
    fn check<T: Real>(shape: [usize; 2], tolerance: f64) {
        let (problem, grid) = surface_of::<T>(shape);
        let solved = |is_plain: bool| {
            IS_PLAIN.store(is_plain, Ordering::Relaxed);
            let (_, found) = run(&mut Chord::new(grid, false), &problem, tolerance, 0.05);
            IS_PLAIN.store(false, Ordering::Relaxed);
            [found.pressure, found.displacement]
                .map(|field| field.iter().map(|x| x.wide().to_bits()).collect::<Vec<_>>())
        };
        assert!(solved(true) == solved(false), "{shape:?} {tolerance}");
    }
    for shape in [[96, 128], [37, 101]] {
        check::<f64>(shape, 1e-8);
        check::<f32>(shape, 1e-3);
    }
}
