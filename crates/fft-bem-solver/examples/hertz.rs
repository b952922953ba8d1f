//! A ball pressed on a flat: the solver with a free boundary against Hertz's formulas.
#![allow(clippy::print_stdout, reason = "an example shows its results")]

use contact_types::{ContactModulus, Grid, HeightMap};
use fft_bem_solver::reference::Hertz;
use fft_bem_solver::{Boundary, Load, Solver};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let modulus = ContactModulus::from_pascals(115e9)?; // steel on steel
    let exact = Hertz::at_force([10e-3; 2], modulus, 100.0)?; // radius 10 mm, 100 N

    println!("   grid convolutions    approach (um)    error   max pressure (MPa)    error");
    for n in [32, 64, 128, 256] {
        let side = 3.0 * exact.semi_axes[0];
        let grid = Grid::new([n, n], [side / n as f64; 2])?;
        let centre = 0.5 * side;
        let map = HeightMap::from_fn(grid, |y, x| exact.height(y - centre, x - centre))?;

        let mut solver =
            Solver::builder().boundary(Boundary::Free).tolerance(1e-6).build(grid, modulus)?;
        let found = solver.solve(&map, Load::MeanPressure(100.0 / grid.area()))?;

        let (approach, highest) = (found.approach, found.diagnostics.max_pressure);
        println!(
            "{n:4}^2 {:13.2} {:16.5} {:+8.1e} {:20.2} {:+8.1e}",
            found.diagnostics.transforms,
            approach * 1e6,
            approach / exact.approach - 1.0,
            highest / 1e6,
            highest / exact.max_pressure - 1.0,
        );
    }
    println!(" exact {:30.5} {:29.2}", exact.approach * 1e6, exact.max_pressure / 1e6);
    Ok(())
}
