//! Form removal before statistics.

use crate::polynomial::Polynomial;
use crate::seam::{MOST_SEAM_JUMP, seam_jump_on};
use crate::{HeightStatistics, StatsError, Warning};
use contact_types::{HeightMap, Named};

/// What is taken off a map by least squares.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
#[non_exhaustive]
pub enum Level {
    /// Nothing: the heights stay as they are.
    None,
    /// The mean height.
    Mean,
    /// The plane.
    Plane,
    /// All terms up to second degree: plane, cylinder, sphere-like cap and saddle.
    Quadratic,
    /// The plane; but the mean where opposite edges meet, and no better without the plane: a map that repeats has no tilt.
    #[default]
    Auto,
}

impl Level {
    /// What it is for this map, itself or what [`Auto`](Self::Auto) chooses, and the map with its least-squares form
    /// removed; heights are then distances from the form.
    ///
    /// Combinations of terms that the map cannot determine (a tilt across a single row) are not
    /// removed. Offsets cost no digits beyond those that the heights themselves have lost.
    ///
    /// # Errors
    /// [`StatsError::OutOfRange`] for heights or pixels beyond what can be squared.
    ///
    /// ```
    /// use contact_types::{Grid, HeightMap};
    /// use std::f64::consts::TAU;
    /// use surface_stats::Level;
    ///
    /// let grid = Grid::new([64, 64], [1e-6, 1e-6])?;
    /// let wave = HeightMap::from_fn(grid, |_, x| 1e-8 * (TAU * x / 64e-6).cos())?;
    /// let tilted = HeightMap::from_fn(grid, |_, x| 1e-8 * (TAU * x / 64e-6).cos() + 0.01 * x)?;
    /// assert_eq!(Level::Auto.taken_off(wave)?.0, Level::Mean);
    /// assert_eq!(Level::Auto.taken_off(tilted)?.0, Level::Plane);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn taken_off(self, map: HeightMap) -> Result<(Self, HeightMap), StatsError> {
        let Some(degree) = self.degree() else { return Ok((self, map)) };
        let form = Polynomial::fit(map.grid(), map.heights(), degree)?;
        let (level, form) = match self {
            Self::Auto if meets(&map, &form) => (Self::Mean, form.mean()),
            Self::Auto => (Self::Plane, form),
            _ => (self, form),
        };
        Ok((level, form.taken_off(map)?))
    }

    /// Total degree of the polynomial taken off; `None` if nothing is. Of [`Auto`](Self::Auto) that of a profile, the line.
    pub fn degree(self) -> Option<usize> {
        match self {
            Self::None => None,
            Self::Mean => Some(0),
            Self::Plane | Self::Auto => Some(1),
            Self::Quadratic => Some(2),
        }
    }
}

impl Named for Level {
    const NAMES: &'static [(Self, &'static str)] = &[
        (Self::Auto, "auto"),
        (Self::None, "none"),
        (Self::Mean, "mean"),
        (Self::Plane, "plane"),
        (Self::Quadratic, "quadratic"),
    ];
}

/// The warning of a map asked to keep its plane, where that explains a good part of the height variance.
///
/// # Errors
/// As [`Level::taken_off`].
pub fn tilted(map: &HeightMap, asked: Level) -> Result<Option<Warning>, StatsError> {
    if !matches!(asked, Level::None | Level::Mean) {
        return Ok(None);
    }
    let plane = Polynomial::fit(map.grid(), map.heights(), 1)?;
    let rms = |map: &HeightMap| HeightStatistics::of(map).rms_height;
    let without = rms(&plane.taken_off(map.clone())?);
    let explained = 1.0 - (without / rms(map)).powi(2); // no number for a flat map
    // A map that repeats has no tilt, whatever a plane explains of it.
    let is_tilted = explained > 0.05 && !meets(map, &plane);
    Ok(is_tilted.then_some(Warning::Tilted { explained }))
}

/// True if opposite edges meet, and no better without the plane.
fn meets(map: &HeightMap, plane: &Polynomial) -> bool {
    let jump = seam_jump_on(map, [0.0; 2]);
    jump <= MOST_SEAM_JUMP && jump <= seam_jump_on(map, plane.rises())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use contact_types::Grid;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn ripple(y: f64, x: f64) -> f64 {
        1e-8 * (3e6 * x).sin() * (2e6 * y + 0.3).cos()
    }

    proptest! {
        /// What is left is orthogonal to every term, whatever offset up to 100 mm it was on.
        #[test]
        fn residual_is_orthogonal_to_the_form(
            ny in 3usize..24, nx in 3usize..24, a in -0.1..0.1, b in -0.1..0.1,
            offset in -0.1..0.1f64,
        ) {
            let grid = Grid::new([ny, nx], [2e-6, 1e-6]).unwrap();
            let form = |y: f64, x: f64| offset + a * x + b * y + 40.0 * x * y - 30.0 * x * x;
            let map = HeightMap::from_fn(grid, |y, x| form(y, x) + ripple(y, x)).unwrap();
            let (_, flat) = Level::Quadratic.taken_off(map).unwrap();
            let rounding = 4.0 * f64::EPSILON * (offset.abs() + 1e-5);
            let terms: [fn(f64, f64) -> f64; 6] =
                [|_, _| 1.0, |_, x| x, |y, _| y, |_, x| x * x, |y, x| x * y, |y, _| y * y];
            for term in terms {
                let sum: f64 = (0..grid.len())
                    .map(|i| {
                        let v = 2.0 * (i / nx) as f64 / (ny - 1) as f64 - 1.0;
                        let u = 2.0 * (i % nx) as f64 / (nx - 1) as f64 - 1.0;
                        flat.heights()[i] * term(v, u)
                    })
                    .sum();
                assert_abs_diff_eq!(sum, 0.0, epsilon = rounding * grid.len() as f64);
            }
            // The form costs only the digits that it took: the same residual as without it.
            let bare = HeightMap::from_fn(grid, ripple).unwrap();
            let (_, bare) = Level::Quadratic.taken_off(bare).unwrap();
            for (p, q) in flat.heights().iter().zip(bare.heights()) {
                assert_abs_diff_eq!(p, q, epsilon = rounding);
            }
        }
    }

    /// A wave keeps its plane at any phase; noise, which meets itself everywhere, loses a tilt of half its own height.
    #[test]
    fn what_repeats_has_no_tilt() {
        let grid = Grid::new([48, 64], [1.0, 1.0]).unwrap();
        for shift in 0..64 {
            let wave = |_: f64, x: f64| (TAU * (x + f64::from(shift)) / 64.0).sin();
            let wave = HeightMap::from_fn(grid, wave).unwrap();
            assert_eq!(Level::Auto.taken_off(wave).unwrap().0, Level::Mean, "{shift}");
        }
        let noise = |y: f64, x: f64| (1e4 * (x + 64.0 * y).powi(2)).sin() + 0.01 * x;
        let noise = HeightMap::from_fn(grid, noise).unwrap();
        assert_eq!(Level::Auto.taken_off(noise).unwrap().0, Level::Plane);
    }

    #[test]
    fn single_rows_columns_and_pixels_are_levelled() {
        for shape in [[1, 9], [9, 1], [1, 1], [2, 2], [1, 2]] {
            let grid = Grid::new(shape, [1e-6, 1e-6]).unwrap();
            let map = HeightMap::from_fn(grid, |y, x| 1.0 + 3.0 * x - 2.0 * y).unwrap();
            for kind in [Level::Plane, Level::Quadratic] {
                let (_, flat) = kind.taken_off(map.clone()).unwrap();
                assert!(flat.heights().iter().all(|h| h.abs() < 1e-15), "{shape:?} {kind:?}");
            }
        }
    }
}
