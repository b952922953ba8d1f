//! Slopes and curvatures by finite differences.

use crate::StatsError;
use contact_types::{HeightMap, Named, SpectralMoments};

/// What lies beyond the edges of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Edges {
    /// Nothing: only stencils that stay inside are used.
    #[default]
    Open,
    /// The map again: stencils wrap around.
    Periodic,
}

impl Named for Edges {
    const NAMES: &'static [(Self, &'static str)] =
        &[(Self::Open, "open"), (Self::Periodic, "periodic")];
}

/// Mean squares of the slopes and second derivatives along the two axes.
///
/// ```math
/// m_{2x} = \Big\langle \Big(\frac{z_{i+1}-z_i}{\Delta x}\Big)^2 \Big\rangle, \qquad
/// m_{4x} = \Big\langle \Big(\frac{z_{i+1}-2z_i+z_{i-1}}{\Delta x^2}\Big)^2 \Big\rangle
/// ```
///
/// Forward differences read a wave of wavenumber q as `[2 sin(q dx/2) / dx]²` instead of q²:
/// m2 comes out low by `dx² m4 / 12` and m4 by `dx² m6 / 6`, at the shortest wavelength by 59 %
/// and 84 %. The central slope `(z[i+1] - z[i-1]) / 2 dx` loses four times as much and is blind
/// to that wavelength.
///
/// # Source
/// McCool (1986), doi:10.1016/0043-1648(86)90045-1, for moments from differences of neighbouring
/// heights; the transfer functions follow from the difference of two shifted waves.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct DirectionalMoments {
    /// Mean square forward slope along x (-).
    pub m2_x: f64,
    /// Mean square forward slope along y (-).
    pub m2_y: f64,
    /// Mean square central slope along x (-).
    pub m2_x_central: f64,
    /// Mean square central slope along y (-).
    pub m2_y_central: f64,
    /// Mean product of the central slopes along x and y (-): with the two above, the slope
    /// tensor, whose eigenvectors show the lay.
    pub m2_xy: f64,
    /// Mean square second difference along x (m⁻²).
    pub m4_x: f64,
    /// Mean square second difference along y (m⁻²).
    pub m4_y: f64,
}

impl DirectionalMoments {
    /// By all stencils the edges allow.
    ///
    /// # Errors
    /// [`StatsError::TooSmall`] below 3 x 3 pixels.
    pub fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
        StatsError::require_shape("a second difference along both axes", [ny, nx], [3, 3])?;
        let heights = map.heights();
        let row = |iy: usize| &heights[(iy % ny) * nx..(iy % ny + 1) * nx];
        let periodic = edges == Edges::Periodic;
        let mut sums = [Mean::default(); 7];
        let mut line = Vec::with_capacity(nx + 2); // a row with what lies beyond its ends
        for iy in 0..ny {
            let (here, next, above) = (row(iy), row(iy + 1), row(iy + ny - 1));
            line.clear();
            if periodic {
                line.push(here[nx - 1]);
                line.extend_from_slice(here);
                line.push(here[0]);
            } else {
                line.extend_from_slice(here);
            }
            let forward = if periodic { &line[1..] } else { &line[..] };
            sums[0].add(forward.windows(2).map(|z| square(z[1] - z[0])));
            sums[1].add(line.windows(3).map(|z| square(z[2] - z[0])));
            sums[2].add(line.windows(3).map(|z| square(z[2] - z[1] - (z[1] - z[0]))));
            if periodic || iy + 1 < ny {
                sums[3].add(here.iter().zip(next).map(|(z, n)| square(n - z)));
            }
            if periodic || (iy > 0 && iy + 1 < ny) {
                let column = above.iter().zip(here).zip(next);
                sums[4].add(column.clone().map(|((a, _), n)| square(n - a)));
                sums[5].add(column.map(|((a, z), n)| square(n - z - (z - a))));
                let skip = usize::from(!periodic);
                let rise = above[skip..].iter().zip(&next[skip..]).map(|(a, n)| n - a);
                sums[6].add(line.windows(3).zip(rise).map(|(z, n)| (z[2] - z[0]) * n));
            }
        }
        let [m2_x, m2_x_central, m4_x, m2_y, m2_y_central, m4_y, m2_xy] = sums.map(Mean::value);
        Ok(Self {
            m2_x: m2_x / (dx * dx),
            m2_y: m2_y / (dy * dy),
            m2_x_central: m2_x_central / (4.0 * dx * dx),
            m2_y_central: m2_y_central / (4.0 * dy * dy),
            m2_xy: m2_xy / (4.0 * dx * dy),
            m4_x: m4_x / (dx * dx) / (dx * dx),
            m4_y: m4_y / (dy * dy) / (dy * dy),
        })
    }

    /// Moments of the isotropic surface with the mean slope and curvature of both axes, given
    /// the mean square height `m0` in m².
    pub fn isotropic(&self, m0: f64) -> SpectralMoments {
        SpectralMoments {
            m0,
            m2: f64::midpoint(self.m2_x, self.m2_y),
            m4: f64::midpoint(self.m4_x, self.m4_y),
        }
    }

    /// Largest over smallest mean square slope over all directions, from the tensor of central
    /// slopes; 1 for an isotropic surface, infinite if one direction has no slope, `None` if the
    /// map is flat.
    pub(crate) fn anisotropy(&self) -> Option<f64> {
        let mean = f64::midpoint(self.m2_x_central, self.m2_y_central);
        let half = 0.5 * (self.m2_x_central - self.m2_y_central);
        let spread = half.hypot(self.m2_xy).min(mean);
        (mean > 0.0).then(|| (mean + spread) / (mean - spread))
    }
}

fn square(x: f64) -> f64 {
    x * x
}

/// A running mean, summed row by row.
#[derive(Debug, Clone, Copy, Default)]
struct Mean {
    sum: f64,
    count: usize,
}

impl Mean {
    fn add(&mut self, terms: impl Iterator<Item = f64>) {
        let mut sum = 0.0;
        for term in terms {
            sum += term;
            self.count += 1;
        }
        self.sum += sum;
    }

    fn value(self) -> f64 {
        self.sum / self.count as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    /// One oblique wave: each mean square is the exact one times its transfer function
    /// (2 sin(q d/2) / d)^2, (sin(q d) / d)^2, (2 sin(q d/2) / d)^4.
    #[test]
    fn transfer_functions_of_a_wave() {
        let (ny, nx, dy, dx) = (15, 22, 3e-7, 2e-7);
        let grid = Grid::new([ny, nx], [dy, dx]).unwrap();
        for (ky, kx) in [(1, 1), (4, 7), (7, 10)] {
            let q = [TAU * f64::from(ky) / (15.0 * dy), TAU * f64::from(kx) / (22.0 * dx)];
            let amplitude = 3e-8;
            let map =
                HeightMap::from_fn(grid, |y, x| amplitude * (q[0] * y + q[1] * x).cos()).unwrap();
            let m = DirectionalMoments::of(&map, Edges::Periodic).unwrap();
            let m0 = amplitude * amplitude / 2.0;
            let half = |q: f64, d: f64| (2.0 * (q * d / 2.0).sin() / d).powi(2);
            let full = |q: f64, d: f64| (q * d).sin() / d;
            for (found, expected) in [
                (m.m2_x, m0 * half(q[1], dx)),
                (m.m2_y, m0 * half(q[0], dy)),
                (m.m2_x_central, m0 * full(q[1], dx).powi(2)),
                (m.m2_y_central, m0 * full(q[0], dy).powi(2)),
                (m.m2_xy, m0 * full(q[1], dx) * full(q[0], dy)),
                (m.m4_x, m0 * half(q[1], dx).powi(2)),
                (m.m4_y, m0 * half(q[0], dy).powi(2)),
            ] {
                assert_relative_eq!(found, expected, max_relative = 1e-12);
            }
            // A single wave has no slope along its crests.
            assert!(m.anisotropy().unwrap() > 1e10);
        }
    }

    /// A checkerboard of +-s, the shortest wave there is: 4 s²/d², 0 and 16 s²/d⁴.
    #[test]
    fn the_shortest_wave_is_invisible_to_central_slopes() {
        let grid = Grid::new([6, 8], [1.0, 0.5]).unwrap();
        let map = HeightMap::from_fn(grid, |y, x| {
            if ((y + 2.0 * x) as u64).is_multiple_of(2) { 1.0 } else { -1.0 }
        });
        for edges in [Edges::Open, Edges::Periodic] {
            let m = DirectionalMoments::of(map.as_ref().unwrap(), edges).unwrap();
            assert_relative_eq!(m.m2_x, 16.0);
            assert_relative_eq!(m.m2_y, 4.0);
            assert_relative_eq!(m.m4_x, 256.0);
            assert_relative_eq!(m.m4_y, 16.0);
            assert_relative_eq!(m.m2_x_central + m.m2_y_central, 0.0);
            assert_eq!(m.anisotropy(), None);
        }
    }
}
