//! Removal of nominal form: polynomial, sphere, cylinder.

use crate::linear::NormalEquations;
use crate::polynomial::{MAX_DEGREE, Polynomial};
use crate::{StatsError, scale};
use contact_types::Grid;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt;
use std::str::FromStr;

/// Iterations a sphere or cylinder may take; ten are common for half a sphere, three for a cap.
const MAX_ITERATIONS: usize = 60;

/// A step that improves the sum of squares by less than this fraction is the last.
const SETTLED: f64 = 1e-9;

/// Nominal form of a measured part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "String", into = "String")
)]
pub enum Form {
    /// All terms up to a total degree: 0 mean, 1 plane, 2 quadratic, up to 12.
    Polynomial(usize),
    /// A sphere in any position, convex or concave.
    Sphere,
    /// A circular cylinder in any direction of the plane, convex or concave, with a tilt along
    /// its axis.
    Cylinder,
}

impl FromStr for Form {
    type Err = StatsError;

    /// `plane`, `quadratic`, `polynomial:N`, `sphere` or `cylinder`.
    fn from_str(text: &str) -> Result<Self, StatsError> {
        let text = text.trim();
        let unknown = |why| Err(StatsError::UnknownForm { text: text.to_owned(), why });
        match text {
            "plane" => Ok(Self::Polynomial(1)),
            "quadratic" => Ok(Self::Polynomial(2)),
            "sphere" => Ok(Self::Sphere),
            "cylinder" => Ok(Self::Cylinder),
            _ => match text.strip_prefix("polynomial:").map(str::parse) {
                Some(Ok(degree)) if degree <= MAX_DEGREE => Ok(Self::Polynomial(degree)),
                Some(_) => unknown("has no degree from 0 to 12; write for example polynomial:4"),
                None => unknown(
                    "is no form; write plane, quadratic, polynomial:N with N from 0 to 12, sphere or \
                     cylinder",
                ),
            },
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Polynomial(1) => f.write_str("plane"),
            Self::Polynomial(2) => f.write_str("quadratic"),
            Self::Polynomial(degree) => write!(f, "polynomial:{degree}"),
            Self::Sphere => f.write_str("sphere"),
            Self::Cylinder => f.write_str("cylinder"),
        }
    }
}

impl TryFrom<String> for Form {
    type Error = StatsError;

    fn try_from(text: String) -> Result<Self, StatsError> {
        text.parse()
    }
}

impl From<Form> for String {
    fn from(form: Form) -> Self {
        form.to_string()
    }
}

/// What was found.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "form", rename_all = "snake_case")
)]
pub enum FormParameters {
    /// Nothing but the degree is worth naming.
    Polynomial {
        /// Total degree.
        degree: usize,
    },
    /// Of the sphere.
    Sphere {
        /// Signed radius (m): positive if convex (the centre lies below). Infinite for a plane.
        radius: f64,
        /// Position of the highest (convex) or lowest point, `[y, x]` (m); the middle of the map
        /// for a plane.
        apex: [f64; 2],
    },
    /// Of the cylinder.
    Cylinder {
        /// Signed radius (m): positive if convex. Infinite for a plane.
        radius: f64,
        /// Direction of the axis in the plane (rad), from x towards y.
        direction: f64,
        /// Slope along the axis (-).
        tilt: f64,
    },
}

/// Fits `form` by least squares of the vertical distances to the points of `heights` (m, row-major)
/// that are not NaN, and replaces their heights by their distances above it. What was found, and
/// the number of points fitted.
pub(super) fn take_form_off(
    grid: Grid,
    heights: &mut [f64],
    form: Form,
) -> Result<(FormParameters, usize), StatsError> {
    scale::check_measured(grid, heights)?;
    let points = heights.iter().filter(|h| !h.is_nan()).count();
    let needed = match form {
        Form::Polynomial(degree) => (degree + 1) * (degree + 2) / 2,
        Form::Sphere => 4,
        Form::Cylinder => 5,
    };
    if points < needed {
        return Err(StatsError::TooFewPoints { what: "this form", needed, found: points });
    }
    if let Form::Polynomial(degree) = form {
        Polynomial::fit(grid, heights, degree)?.remove_from(heights);
        return Ok((FormParameters::Polynomial { degree }, points));
    }
    let origin = heights.iter().copied().find(|h| !h.is_nan()).unwrap_or(0.0);
    let frame = CentredGrid::of(grid);
    let round = Round::fit(&frame, heights, origin, form == Form::Cylinder)?;
    for (i, h) in heights.iter_mut().enumerate() {
        let (x, y) = frame.position(i);
        // A missing point may lie beyond the sphere; NaN stays NaN.
        let form = round.height(x, y).unwrap_or(f64::NAN);
        *h = (*h - origin) - form * frame.unit;
    }
    Ok((round.parameters(&frame), points))
}

/// Lengths in units of half the longer side, positions from the middle of the map.
struct CentredGrid {
    grid: Grid,
    unit: f64,
}

impl CentredGrid {
    fn of(grid: Grid) -> Self {
        let [ly, lx] = grid.size();
        Self { grid, unit: 0.5 * ly.max(lx) }
    }

    fn position(&self, index: usize) -> (f64, f64) {
        let ([ny, nx], [dy, dx]) = (self.grid.shape(), self.grid.pixel());
        let middle = |i: usize, n: usize| i as f64 - 0.5 * (n - 1) as f64;
        (middle(index % nx, nx) * dx / self.unit, middle(index / nx, ny) * dy / self.unit)
    }

    /// `(x, y, z)` of the valid points, with z above `origin` (m).
    fn points(&self, heights: &[f64], origin: f64) -> impl Iterator<Item = (f64, f64, f64)> {
        let valid = heights.iter().enumerate().filter(|(_, h)| !h.is_nan());
        valid.map(move |(i, h)| {
            let (x, y) = self.position(i);
            (x, y, (h - origin) / self.unit)
        })
    }
}

/// A sphere or cylinder as the root of `A (u² + z²) - z + B u + C w + E = 0` that stays finite as
/// A goes to 0, where it becomes a plane. For a sphere u² is x² + y², B u is B x and C w is C y.
/// For a cylinder u runs across the axis and `C w`, the tilt along it, is added to z outside the
/// root.
#[derive(Clone, Copy)]
struct Round {
    origin: f64,
    is_cylinder: bool,
    /// A, B, C, E; for a cylinder also the direction of u.
    p: [f64; 5],
}

impl Round {
    fn fit(
        frame: &CentredGrid,
        heights: &[f64],
        origin: f64,
        is_cylinder: bool,
    ) -> Result<Self, StatsError> {
        let across = if is_cylinder { Self::direction_across(frame, heights, origin) } else { 0.0 };
        let mut fit = Self { origin, is_cylinder, p: [0.0, 0.0, 0.0, 0.0, across] };
        let mut error = fit.misfit(frame, heights).unwrap_or(f64::INFINITY);
        let valid = || frame.points(heights, origin);
        let least = 1e-6 + origin.abs() / frame.unit;
        let magnitude = valid().fold(least, |m, (.., z)| m.max(z.abs()));
        let rounding = 4.0 * f64::EPSILON * magnitude;
        let floor = valid().count() as f64 * rounding * rounding;
        for _ in 0..MAX_ITERATIONS {
            let step = fit.gauss_newton(frame, heights);
            // Halve the step until every point lies below the equator and the fit is better.
            let mut beyond_equator = false;
            let next = (0..=20).find_map(|halvings| {
                let (mut trial, fraction) = (fit, 0.5f64.powi(halvings));
                trial.p.iter_mut().zip(&step).for_each(|(p, d)| *p += fraction * d);
                let misfit = trial.misfit(frame, heights);
                beyond_equator |= misfit.is_none();
                misfit.filter(|e| *e <= error).map(|e| (trial, e))
            });
            let Some((trial, e)) = next else {
                if beyond_equator {
                    break;
                }
                return Ok(fit); // no better point in the best direction
            };
            let settled = e <= floor || (!beyond_equator && error - e <= SETTLED * error);
            (fit, error) = (trial, e);
            if settled {
                return Ok(fit);
            }
        }
        let form = if is_cylinder { "cylinder" } else { "sphere" };
        Err(StatsError::NotConverged { form, iterations: MAX_ITERATIONS })
    }

    /// Coordinates across and along the axis: for a sphere simply x and y.
    fn turned(&self, x: f64, y: f64) -> (f64, f64) {
        let (sin, cos) = self.p[4].sin_cos();
        (x * cos + y * sin, y * cos - x * sin)
    }

    /// Height over the frame's unit; `None` beyond the equator.
    fn height(&self, x: f64, y: f64) -> Option<f64> {
        let [a, b, c, e, _] = self.p;
        let (u, w) = self.turned(x, y);
        let (square, inner, tilt) =
            if self.is_cylinder { (u * u, 0.0, c * w) } else { (u * u + w * w, c * w, 0.0) };
        let q = a * square + b * u + inner + e;
        let root = 1.0 - 4.0 * a * q;
        (root > 0.0).then(|| 2.0 * q / (1.0 + root.sqrt()) + tilt)
    }

    fn misfit(&self, frame: &CentredGrid, heights: &[f64]) -> Option<f64> {
        let square = |(x, y, z): (f64, f64, f64)| Some((z - self.height(x, y)?).powi(2));
        frame.points(heights, self.origin).map(square).sum()
    }

    /// Step of all parameters that fits the residual to first order.
    fn gauss_newton(&self, frame: &CentredGrid, heights: &[f64]) -> Vec<f64> {
        let [a, b, c, ..] = self.p;
        let terms = if self.is_cylinder { 5 } else { 4 };
        let mut equations = NormalEquations::new(terms);
        for (x, y, height) in frame.points(heights, self.origin) {
            let Some(z) = self.height(x, y) else { continue };
            let (u, w) = self.turned(x, y);
            let (g, along) = if self.is_cylinder { (z - c * w, 0.0) } else { (z, w * w) };
            let s = 1.0 - 2.0 * a * g;
            let inner = if self.is_cylinder { w } else { w / s };
            // Turning the axis by one radian moves u by w and w by -u.
            let turn = w * (2.0 * a * u + b) / s - c * u;
            let basis = [(g * g + u * u + along) / s, u / s, inner, 1.0 / s, turn];
            equations.add_point(&basis[..terms], height - z);
        }
        equations.solve()
    }

    /// Direction of the strongest curvature of the least-squares quadratic.
    fn direction_across(frame: &CentredGrid, heights: &[f64], origin: f64) -> f64 {
        let mut equations = NormalEquations::new(6);
        for (x, y, z) in frame.points(heights, origin) {
            equations.add_point(&[x * x, x * y, y * y, x, y, 1.0], z);
        }
        let q = equations.solve();
        // Eigenvector of [[q0, q1/2], [q1/2, q2]] with the eigenvalue of larger modulus.
        let angle = 0.5 * q[1].atan2(q[0] - q[2]);
        if q[0] + q[2] >= 0.0 { angle } else { angle + FRAC_PI_2 }
    }

    fn parameters(&self, frame: &CentredGrid) -> FormParameters {
        let [a, b, c, e, across] = self.p;
        // Centre (-B/2A, -C/2A, 1/2A); R² = (1 + B² + C²)/4A² - E/A. A < 0 is convex.
        let slope_square = if self.is_cylinder { b * b } else { b * b + c * c };
        let radius = -0.5 * (1.0 + slope_square - 4.0 * a * e).sqrt() / a * frame.unit;
        let radius = if radius.is_finite() { radius } else { f64::INFINITY };
        if self.is_cylinder {
            // The axis has no sense of direction: report 0 to pi and the slope that goes with it.
            let half_turns = ((across + FRAC_PI_2) / PI).floor();
            let direction = across + FRAC_PI_2 - half_turns * PI;
            let tilt = if half_turns.rem_euclid(2.0) < 0.5 { c } else { -c };
            return FormParameters::Cylinder { radius, direction, tilt };
        }
        let ([ny, nx], [dy, dx]) = (frame.grid.shape(), frame.grid.pixel());
        let middle = [0.5 * (ny - 1) as f64 * dy, 0.5 * (nx - 1) as f64 * dx];
        let from_middle = |slope: f64| {
            let distance = -0.5 * slope / a * frame.unit;
            if distance.is_finite() { distance } else { 0.0 } // a plane has no apex
        };
        let apex = [middle[0] + from_middle(c), middle[1] + from_middle(b)];
        FormParameters::Sphere { radius, apex }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use approx::assert_abs_diff_eq;

    fn grid() -> Grid {
        Grid::new([60, 80], [2e-6, 1e-6]).unwrap()
    }

    fn heights(z: impl Fn(f64, f64) -> f64) -> Vec<f64> {
        (0..grid().len()).map(|i| z((i / 80) as f64 * 2e-6, (i % 80) as f64 * 1e-6)).collect()
    }

    /// How far a circle of this signed radius has fallen at a distance from its apex.
    fn sag(r: f64, square: f64) -> f64 {
        square / (r + r.signum() * (r * r - square).sqrt())
    }

    /// Ball and bowl, off centre, deep and shallow, with a missing corner.
    #[test]
    fn spheres_of_all_depths() {
        let apex = [50e-6, 30e-6];
        for radius in [120e-6, -120e-6, 5e-3, -1.0] {
            let distance = |y: f64, x: f64| (x - apex[1]).powi(2) + (y - apex[0]).powi(2);
            let mut h = heights(|y, x| 76e-3 - sag(radius, distance(y, x)));
            h[..500].fill(f64::NAN);
            let (parameters, points) = take_form_off(grid(), &mut h, Form::Sphere).unwrap();
            let FormParameters::Sphere { radius: found, apex: at } = parameters else {
                panic!("not a sphere")
            };
            assert_eq!(points, 60 * 80 - 500);
            close(found, radius, 1e-6);
            for (at, apex) in at.iter().zip(apex) {
                assert_abs_diff_eq!(*at, apex, epsilon = 1e-9 * (1.0 + radius.abs() / 1e-3));
            }
            assert_eq!(h.iter().filter(|h| h.is_nan()).count(), 500);
            assert!(h.iter().all(|h| h.is_nan() || h.abs() < 1e-15));
        }
    }

    #[test]
    fn cylinders_in_any_direction() {
        for (radius, direction, tilt) in
            [(200e-6, 0.4, 0.0), (-200e-6, 2.0, 0.05), (3e-3, 1.57, -0.01), (1e-3, 0.0, 0.0)]
        {
            let (sin, cos) = f64::sin_cos(direction);
            let mut h = heights(|y, x| {
                let across = y * cos - x * sin - 20e-6;
                tilt * (x * cos + y * sin) - sag(radius, across * across)
            });
            let (parameters, _) = take_form_off(grid(), &mut h, Form::Cylinder).unwrap();
            let FormParameters::Cylinder { radius: found, direction: angle, tilt: slope } =
                parameters
            else {
                panic!("not a cylinder")
            };
            close(found, radius, 1e-6);
            assert_abs_diff_eq!((angle - direction).sin(), 0.0, epsilon = 1e-8);
            let sign = (angle - direction).cos().signum();
            assert_abs_diff_eq!(sign * slope, tilt, epsilon = 1e-9);
            assert!(h.iter().all(|h| h.abs() < 1e-13), "{radius} {direction}");
        }
    }

    /// A plane is a sphere or a cylinder of infinite radius, and a rough plane does not trap the fit.
    #[test]
    fn flat_and_rough_planes() {
        for form in [Form::Sphere, Form::Cylinder, Form::Polynomial(4)] {
            for plane in [|y, x| 0.1 * x - 0.2 * y, |_, _| 5.0] {
                let mut h = heights(plane);
                take_form_off(grid(), &mut h, form).unwrap();
                assert!(h.iter().all(|h| h.abs() < 1e-15), "{form:?}");
            }
            let mut h = heights(|y, x| 1e-7 * ((1e6 * x).sin() * (2.3e6 * y).cos() + 1e4 * y));
            take_form_off(grid(), &mut h, form).unwrap();
            assert!(h.iter().all(|h| h.is_finite()));
        }
    }

    #[test]
    fn too_few_points_are_refused() {
        let mut h = vec![f64::NAN; 60 * 80];
        h[7] = 1.0;
        for form in [Form::Sphere, Form::Cylinder, Form::Polynomial(1)] {
            let error = take_form_off(grid(), &mut h, form);
            assert!(matches!(error, Err(StatsError::TooFewPoints { found: 1, .. })), "{form:?}");
        }
        let error = take_form_off(grid(), &mut h[1..], Form::Sphere);
        assert!(matches!(error, Err(StatsError::Shape { .. })));
    }

    #[test]
    fn forms_read_back_as_they_are_written() {
        for text in ["plane", "quadratic", "polynomial:0", "polynomial:12", "sphere", "cylinder"] {
            assert_eq!(text.parse::<Form>().unwrap().to_string(), text);
        }
        assert_eq!("polynomial:1".parse::<Form>(), "plane".parse());
        for text in ["polynomial:13", "polynomial:", "polynomial:-1", "polynomial:2.5", "ball", ""]
        {
            assert!(text.parse::<Form>().is_err(), "{text}");
        }
    }
}
