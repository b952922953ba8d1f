//! The solver against exact solutions, on this machine: what `rough-contact validate` prints.

use crate::reference::{Hertz, TwoHarmonic, Westergaard};
use crate::{Boundary, Load, Method, Solution, Solver, SolverError};
use contact_types::{ContactModulus, Grid, HeightMap, ModelError, SurfaceError};
use std::f64::consts::{PI, SQRT_2};

/// What to run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Method to validate; default [`Method::Auto`].
    pub method: Method,
    /// Pixels per side of the finest square maps, at least 32; the coarser ones are halvings down
    /// to 32. Profiles have 16 times as many. Default 256.
    pub finest: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { method: Method::Auto, finest: 256 }
    }
}

/// One number of one case on one grid.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ValidationRow {
    /// The problem, for example "Hertz sphere, free boundary".
    pub case: &'static str,
    /// Where the exact solution comes from.
    pub source: &'static str,
    /// Which number.
    pub quantity: &'static str,
    /// `[ny, nx]`.
    pub shape: [usize; 2],
    /// What the solver found (SI units); for a field the rms of it.
    pub computed: f64,
    /// The exact value; for a field the rms of it.
    pub exact: f64,
    /// Relative error, signed; for a field the rms of the difference over the rms of the field.
    pub error: f64,
    /// Relative uncertainty of the exact value: 0 for closed forms.
    pub uncertainty: f64,
    /// Order of convergence observed so far: slope of log |error| over log pixel side through this
    /// grid and all coarser ones; `None` on the first grid and where no order is expected.
    pub observed_order: Option<f64>,
    /// Order that theory and experience let expect; `None` where the answer is exact on any grid and
    /// for areas, whose error depends on how pixels happen to lie on the contact line.
    pub expected_order: Option<f64>,
    /// FFT convolutions of the solve.
    pub transforms: f64,
}

/// Why a validation run broke off.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ValidationError {
    /// An option is unusable.
    #[error("finest = {0} is too small: use at least 32 pixels per side")]
    TooCoarse(usize),
    /// A solve failed.
    #[error(transparent)]
    Solver(#[from] SolverError),
    /// An exact solution was asked for something it does not have.
    #[error(transparent)]
    Reference(#[from] ModelError),
    /// A surface could not be made.
    #[error(transparent)]
    Surface(#[from] SurfaceError),
}

/// Runs every case on every grid and hands each row over as it comes.
///
/// # Errors
/// [`ValidationError`].
pub fn run(
    options: &Options,
    mut each: impl FnMut(&ValidationRow),
) -> Result<Vec<ValidationRow>, ValidationError> {
    if options.finest < 32 {
        return Err(ValidationError::TooCoarse(options.finest));
    }
    let mut sizes: Vec<usize> = std::iter::successors(Some(options.finest), |n| Some(n / 2))
        .take_while(|n| *n >= 32)
        .collect();
    sizes.reverse();
    let mut rows: Vec<ValidationRow> = Vec::new();
    for &(case, source, is_profile, solve) in CASES {
        let first = rows.len();
        for &n in &sizes {
            let shape = if is_profile { [1, 16 * n] } else { [n, n] };
            let (solution, found) = solve(options, shape[1])?;
            let transforms = solution.diagnostics.transforms;
            for number in found {
                let mut row = ValidationRow { case, source, shape, transforms, ..number };
                if row.expected_order.is_some() {
                    row.observed_order = observed_order(&rows[first..], &row);
                }
                each(&row);
                rows.push(row);
            }
        }
    }
    Ok(rows)
}

/// Name, source, whether it is a profile, and the solve on so many pixels per side.
type ValidationCase = (&'static str, &'static str, bool, fn(&Options, usize) -> CaseResult);

type CaseResult = Result<(Solution, Vec<ValidationRow>), ValidationError>;

const CASES: &[ValidationCase] = &[
    ("Hertz sphere, free boundary", "Hertz 1882", false, |o, n| hertz(o, n, [0.012, 0.012])),
    ("Hertz ellipse, free boundary", "Hertz 1882", false, |o, n| hertz(o, n, [0.004, 0.012])),
    ("flat punch, free boundary", "Johnson 1985, section 3.4", false, flat_punch),
    ("sinusoid", "Westergaard 1939", true, sinusoid),
    ("two harmonics", "Manners 1998", true, two_harmonics),
    ("bi-sinusoid", JOHNSON, false, bi_sinusoid),
    ("full contact", "Johnson 1985, section 13.2", false, closed),
];

/// Of the solves, well below the discretisation errors.
const TOLERANCE: f64 = 1e-7;
/// Of the sinusoids (m).
const AMPLITUDE: f64 = 1e-6;
const WAVELENGTH: f64 = 1e-4;

const JOHNSON: &str = "converged calculation; Johnson, Greenwood & Higginson 1985";

/// A number with an order of convergence; the case is filled in where it is run.
fn number(quantity: &'static str, computed: f64, exact: f64, order: f64) -> ValidationRow {
    ValidationRow {
        case: "",
        source: "",
        quantity,
        shape: [0, 0],
        computed,
        exact,
        error: computed / exact - 1.0,
        uncertainty: 0.0,
        observed_order: None,
        expected_order: Some(order),
        transforms: 0.0,
    }
}

fn area_number(quantity: &'static str, computed: f64, exact: f64) -> ValidationRow {
    ValidationRow { expected_order: None, ..number(quantity, computed, exact, 0.0) }
}

fn field(quantity: &'static str, computed: &[f64], exact: &[f64], order: f64) -> ValidationRow {
    let rms = |values: &mut dyn Iterator<Item = f64>| {
        (values.map(|v| v * v).sum::<f64>() / exact.len() as f64).sqrt()
    };
    let size = rms(&mut exact.iter().copied());
    let error = rms(&mut exact.iter().zip(computed).map(|(e, c)| e - c)) / size;
    let computed = rms(&mut computed.iter().copied());
    ValidationRow { error, ..number(quantity, computed, size, order) }
}

/// Slope of log |error| over log pixel side by least squares, through `new` and all earlier rows of
/// its quantity.
fn observed_order(earlier: &[ValidationRow], new: &ValidationRow) -> Option<f64> {
    let points: Vec<(f64, f64)> = earlier
        .iter()
        .filter(|row| row.quantity == new.quantity)
        .chain([new])
        .map(|row| (-(row.shape[1] as f64).ln(), row.error.abs().ln()))
        .collect();
    let n = points.len() as f64;
    let mean = |f: fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let order = covariance / variance;
    (points.len() > 1 && order.is_finite()).then_some(order)
}

/// Steel against glass or so.
fn modulus() -> Result<ContactModulus, SurfaceError> {
    ContactModulus::from_pascals(50e9)
}

fn solve(
    options: &Options,
    boundary: Boundary,
    map: &HeightMap,
    load: Load,
) -> Result<Solution, ValidationError> {
    let mut solver = Solver::builder()
        .method(options.method)
        .boundary(boundary)
        .tolerance(TOLERANCE)
        .build(map.grid(), modulus()?)?;
    Ok(solver.solve(map, load)?)
}

/// A paraboloid in the middle of a map of 1 mm, its summit between pixels; contact to about two
/// thirds of the map.
fn hertz(options: &Options, n: usize, radii: [f64; 2]) -> CaseResult {
    let side = 1e-3;
    let contact = Hertz::at_approach(radii, modulus()?, 8e-6)?;
    let d = side / n as f64;
    let (y0, x0) = (0.5 * (side - d) + 0.31 * d, 0.5 * (side - d) + 0.17 * d);
    let grid = Grid::new([n, n], [d, d])?;
    let map = HeightMap::from_fn(grid, |y, x| contact.height(y - y0, x - x0))?;
    let solution =
        solve(options, Boundary::Free, &map, Load::MeanPressure(contact.force / grid.area()))?;
    let exact: Vec<f64> = (0..n * n)
        .map(|i| contact.pressure((i / n) as f64 * d - y0, (i % n) as f64 * d - x0))
        .collect();
    // The approach is counted from the highest pixel, a little below the summit.
    let approach = solution.approach - map.range().1;
    let area = solution.state.area_fraction * grid.area();
    let numbers = vec![
        number("approach", approach, contact.approach, 2.0),
        number("maximum pressure", solution.diagnostics.max_pressure, contact.max_pressure, 2.0),
        field("pressure, rms", &solution.pressure, &exact, 1.0),
        area_number("area, corrected", area, contact.area()),
    ];
    Ok((solution, numbers))
}

/// A flat-ended cylinder: `delta = F / (2 E* a)`.
fn flat_punch(options: &Options, n: usize) -> CaseResult {
    let (side, radius, force) = (1e-3, 0.41e-3, 1.0);
    let d = side / n as f64;
    let centre = 0.5 * (side - d);
    let grid = Grid::new([n, n], [d, d])?;
    let height = |y: f64, x: f64| {
        if (y - centre).hypot(x - centre) <= radius { 0.0 } else { -side }
    };
    let map = HeightMap::from_fn(grid, height)?;
    let solution = solve(options, Boundary::Free, &map, Load::MeanPressure(force / grid.area()))?;
    let exact = force / (2.0 * modulus()?.pascals() * radius); // Johnson (1985), eq. (3.36)
    let numbers = vec![number("approach", solution.approach, exact, 1.0)];
    Ok((solution, numbers))
}

/// A profile of `n` pixels, its crest between two of them, and their places from it (m).
fn profile(
    n: usize,
    height: impl Fn(f64) -> f64,
) -> Result<(HeightMap, Vec<f64>), ValidationError> {
    let d = WAVELENGTH / n as f64;
    let places: Vec<f64> = (0..n).map(|i| i as f64 * d - 0.3 * d).collect();
    let heights = places.iter().map(|x| height(*x)).collect();
    Ok((HeightMap::new(Grid::new([1, n], [d, d])?, heights)?, places))
}

fn sinusoid(options: &Options, n: usize) -> CaseResult {
    let (amplitude, wavelength) = (AMPLITUDE, WAVELENGTH);
    let contact = Westergaard { amplitude, wavelength, modulus: modulus()?, m: 0.3 };
    let mean_pressure = Load::MeanPressure(contact.m * contact.closing_pressure());
    let (map, places) = profile(n, |x| contact.height(x))?;
    let solution = solve(options, Boundary::Periodic, &map, mean_pressure)?;
    let exact: Vec<f64> = places.iter().map(|x| contact.pressure(*x)).collect();
    let mean_gap = solution.state.mean_gap.unwrap_or(f64::NAN);
    let numbers = vec![
        number("mean gap", mean_gap, contact.mean_gap(), 2.0),
        field("pressure, rms", &solution.pressure, &exact, 1.0),
        area_number("area fraction", solution.touching_fraction(), contact.area_fraction()),
    ];
    Ok((solution, numbers))
}

fn two_harmonics(options: &Options, n: usize) -> CaseResult {
    let (amplitudes, wavelength, half_angle) = ([AMPLITUDE, 1e-7], WAVELENGTH, PI * 0.37);
    let contact = TwoHarmonic { amplitudes, wavelength, modulus: modulus()?, half_angle };
    let (map, places) = profile(n, |x| contact.height(x))?;
    let solution =
        solve(options, Boundary::Periodic, &map, Load::MeanPressure(contact.mean_pressure()))?;
    let pressure: Vec<f64> = places.iter().map(|x| contact.pressure(*x)).collect();
    let gap: Vec<f64> = places.iter().map(|x| contact.gap(*x)).collect();
    let numbers = vec![
        field("gap, rms", &solution.gap, &gap, 2.0),
        field("pressure, rms", &solution.pressure, &pressure, 1.0),
        area_number("area fraction", solution.touching_fraction(), contact.area_fraction()),
    ];
    Ok((solution, numbers))
}

/// Heights (m) of the egg box `amplitude cos(2 pi x / wavelength) cos(2 pi y / wavelength)` on `n` x `n` pixels, a summit at
/// `[y0, x0]` pixels, and the mean pressure that closes every gap, `p* = sqrt(2) pi E* amplitude / wavelength` (Pa).
///
/// # Source
/// Johnson, Greenwood & Higginson (1985), *Int. J. Mech. Sci.* 27, 383–396, doi:10.1016/0020-7403(85)90029-3.
fn egg_box(n: usize, [y0, x0]: [f64; 2]) -> Result<(HeightMap, f64), SurfaceError> {
    let d = WAVELENGTH / n as f64;
    let turn = 2.0 * PI / WAVELENGTH;
    let height =
        |y: f64, x: f64| AMPLITUDE * (turn * (y - y0 * d)).cos() * (turn * (x - x0 * d)).cos();
    let map = HeightMap::from_fn(Grid::new([n, n], [d, d])?, height)?;
    Ok((map, SQRT_2 * PI * modulus()?.pascals() * AMPLITUDE / WAVELENGTH))
}

/// The bi-sinusoid at a tenth of p\*: area fraction, and mean gap over amplitude, each with its uncertainty, by FFT conjugate
/// gradients on 1024 x 1024 nodes per asperity, area by sub-pixel extrapolation of the squared pressure to zero;
/// uncertainty from the change between 512 and 1024 nodes. Of 21 such loads the mean gap integrates to 0.125004 over
/// p/p\* (exact: 1/8).
const CONVERGED: [[f64; 2]; 2] = [[0.1906, 2e-5], [0.38474924, 4e-7]];

fn bi_sinusoid(options: &Options, n: usize) -> CaseResult {
    let [known_area, known_gap] = CONVERGED;
    let (map, p_star) = egg_box(n, [0.31, 0.17])?;
    let solution = solve(options, Boundary::Periodic, &map, Load::MeanPressure(0.1 * p_star))?;
    let gap = solution.state.mean_gap.unwrap_or(f64::NAN) / AMPLITUDE;
    let area = solution.state.area_fraction;
    let numbers = vec![
        ValidationRow {
            uncertainty: known_gap[1] / known_gap[0],
            ..number("mean gap / amplitude", gap, known_gap[0], 2.0)
        },
        ValidationRow {
            uncertainty: known_area[1] / known_area[0],
            ..area_number("area fraction, corrected", area, known_area[0])
        },
    ];
    Ok((solution, numbers))
}

/// Every gap closed, and a tenth more: the egg box is one wave, whose pressure `p* h / amplitude` adds to the mean
/// (Johnson 1985, *Contact Mechanics*, section 13.2).
fn closed(options: &Options, n: usize) -> CaseResult {
    let (map, p_star) = egg_box(n, [0.0, 0.0])?;
    let least = solve(options, Boundary::Periodic, &map, Load::MeanGap(0.0))?.state.mean_pressure;
    let solution = solve(options, Boundary::Periodic, &map, Load::MeanPressure(1.1 * p_star))?;
    let exact: Vec<f64> = map.heights().iter().map(|h| p_star * (h / AMPLITUDE + 1.1)).collect();
    let numbers = vec![
        ValidationRow { expected_order: None, ..number("closing pressure", least, p_star, 0.0) },
        ValidationRow {
            expected_order: None,
            ..field("pressure, rms", &solution.pressure, &exact, 0.0)
        },
    ];
    Ok((solution, numbers))
}
