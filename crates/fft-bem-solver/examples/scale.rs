//! One large solve: pairs, time and peak memory.
//!
//! ```console
//! $ cargo run --release -p fft-bem-solver --example scale -- 8192 double 1e-10
//! $ cargo run --release -p fft-bem-solver --example scale -- 16384 single 1e-3
//! ```
//! `free` as a fourth argument makes the map an isolated body. The time is that of the solve, after
//! the surface is made and the solver built. Peak memory is that of the process (Linux, `VmHWM`):
//! first of making the surface, then, counted anew, of the solve. The solver takes the surface over
//! and returns no maps. What the process still held from making the surface is stated apart.

#![allow(clippy::print_stdout, reason = "a program that prints what it measured")]

#[path = "common/pair.rs"]
mod pair;
#[path = "common/surface.rs"]
mod surface;

use contact_types::ContactModulus;
use fft_bem_solver::{Boundary, Iteration, Load, Maps, Precision, Solver};
use pair::one_pair;
use std::error::Error;
use std::ops::ControlFlow;
use std::time::Instant;
use surface::{LOAD, surface};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (Some([n, precision, tolerance]), rest) = (arguments.first_chunk(), arguments.get(3..))
    else {
        return Err("usage: scale SIDE double|single TOLERANCE [free]".into());
    };
    let boundary = match rest.unwrap_or_default() {
        [] => Boundary::Periodic,
        [word] if word == "free" => Boundary::Free,
        other => return Err(format!("{other:?} is not `free`").into()),
    };
    let n: usize = n.parse()?;
    let precision = match precision.as_str() {
        "double" => Precision::Double,
        "single" => Precision::Single,
        other => return Err(format!("{other} is neither double nor single").into()),
    };
    let surface = surface(n)?;
    let grid = surface.grid();
    let modulus = ContactModulus::from_pascals(1.0)?;
    println!("{n} x {n}, {precision:?}, {} threads", rayon::current_num_threads());
    println!("surface made, peak memory {:.2} GiB", memory("VmHWM:"));
    let pair = if precision == Precision::Double {
        one_pair::<f64>(grid, modulus, 3)?
    } else {
        one_pair::<f32>(grid, modulus, 3)?
    };
    let gib = |doubles: f64| doubles * (n * n) as f64 / f64::from(1 << 27);
    let held = memory("VmRSS:") - gib(1.0);
    println!("one pair {pair:.3} s, {held:.2} GiB held besides the surface");

    let builder = Solver::builder().precision(precision).tolerance(tolerance.parse()?);
    let mut solver = builder.boundary(boundary).maps(Maps::None).build(grid, modulus)?;
    solver.take_surface(surface)?;
    forget_peak();
    let clock = Instant::now();
    let watch = |it: &Iteration<'_>| {
        let seconds = clock.elapsed().as_secs_f64();
        println!(
            "{:3} iterations {:6.2} pairs {:.1e} {seconds:.1} s",
            it.number, it.transforms, it.residual
        );
        ControlFlow::Continue(())
    };
    let solution = solver.solve_again_observed(Load::MeanPressure(LOAD), watch)?;
    let d = &solution.diagnostics;
    println!(
        "{} iterations, {:.2} pairs, estimate {:.1e}, area {:.6}, {:.1} s, peak memory {:.2} GiB, \
         {:.2} doubles per pixel more than before",
        d.iterations,
        d.transforms,
        d.residuals.preconditioned,
        solution.state.area_fraction,
        d.seconds,
        memory("VmHWM:"),
        (memory("VmHWM:") - held) / gib(1.0),
    );
    Ok(())
}

/// Memory of this process (GiB), now or at most; not a number where the system does not say.
fn memory(which: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix(which));
    let kib = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    kib.map_or(f64::NAN, |kib| kib / 1024.0 / 1024.0)
}

/// From now on the peak is counted anew, where the system can do that (Linux).
fn forget_peak() {
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}
