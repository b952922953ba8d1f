//! Slopes and curvatures by finite differences.

use crate::clean::row_jumps;
use crate::linear::sum;
use crate::{HeightStatistics, StatsError, Warning};
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

/// Mean squares of the slopes and second derivatives along the two axes. The central slope `(z[i+1] - z[i-1]) / 2 dx`
/// loses four times as much as the forward one, and is blind to the shortest wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DirectionalMoments {
    /// Mean square forward slopes (-).
    pub(crate) m2_x: f64,
    pub(crate) m2_y: f64,
    /// Tensor of the central slopes (-), whose eigenvectors show the lay.
    m2_x_central: f64,
    m2_y_central: f64,
    m2_xy: f64,
    /// Mean square second differences (m⁻²).
    pub(crate) m4_x: f64,
    pub(crate) m4_y: f64,
}

/// m0, m2, m4 of the isotropic surface with the mean slope and curvature of both axes of a levelled map, by finite
/// differences of neighbours:
///
/// ```math
/// m_0 = \langle z^2 \rangle, \quad m_2 = \frac{m_{2x} + m_{2y}}{2}, \quad m_4 = \frac{m_{4x} + m_{4y}}{2}, \qquad
/// m_{2x} = \Big\langle \Big(\frac{z_{i+1}-z_i}{\Delta x}\Big)^2 \Big\rangle, \quad
/// m_{4x} = \Big\langle \Big(\frac{z_{i+1}-2z_i+z_{i-1}}{\Delta x^2}\Big)^2 \Big\rangle
/// ```
///
/// Forward differences read a wave of wavenumber q as `[2 sin(q dx/2) / dx]²` instead of q²:
/// m2 comes out low by `dx² m4 / 12` and m4 by `dx² m6 / 6`, at the shortest wavelength by 59 %
/// and 84 %. With what speaks against an isotropic Gaussian surface: rows that jump or a lay, and heights that are not normal.
///
/// # Errors
/// [`StatsError::TooSmall`] below 3 x 3 pixels.
///
/// # Source
/// McCool (1986), doi:10.1016/0043-1648(86)90045-1, for moments from differences of neighbouring
/// heights; the transfer functions follow from the difference of two shifted waves.
pub fn moments(
    map: &HeightMap,
    edges: Edges,
) -> Result<(SpectralMoments, Vec<Warning>), StatsError> {
    let (moments, heights, differences) = by_differences(map, edges)?;
    let bandwidth = Some(moments.bandwidth()).filter(|b| b.is_finite());
    let shape = Warning::of_distribution(heights.skewness, heights.kurtosis, bandwidth);
    Ok((moments, [differences.uneven(map)].into_iter().chain(shape).flatten().collect()))
}

/// The moments alone, and what they are made of.
pub(crate) fn by_differences(
    map: &HeightMap,
    edges: Edges,
) -> Result<(SpectralMoments, HeightStatistics, DirectionalMoments), StatsError> {
    let (heights, differences) = (HeightStatistics::of(map), DirectionalMoments::of(map, edges)?);
    Ok((differences.isotropic(heights.rms_height.powi(2)), heights, differences))
}

/// Mean absolute slope of a map along both axes \[-\], by differences of neighbours; of an isotropic Gaussian surface
/// √(2 m2/π).
pub fn mean_slope(map: &HeightMap) -> f64 {
    let ([_, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
    let heights = map.heights();
    let steps = |next: usize, inside: &dyn Fn(usize) -> bool| {
        let pairs = heights.iter().zip(heights.get(next..).unwrap_or(&[]));
        let rises = pairs.enumerate().filter(|(i, _)| inside(*i)).map(|(_, (a, b))| (b - a).abs());
        let (sum, count) = rises.fold((0.0, 0_usize), |(sum, n), rise| (sum + rise, n + 1));
        sum / count.max(1) as f64
    };
    f64::midpoint(steps(1, &|i| (i + 1) % nx > 0) / dx, steps(nx, &|_| true) / dy)
}

impl DirectionalMoments {
    /// By all stencils the edges allow.
    pub(crate) fn of(map: &HeightMap, edges: Edges) -> Result<Self, StatsError> {
        let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
        StatsError::require_shape("a second difference along both axes", [ny, nx], [3, 3])?;
        let heights = map.heights();
        let row = |iy: usize| &heights[(iy % ny) * nx..(iy % ny + 1) * nx];
        let periodic = edges == Edges::Periodic;
        let mut sums = [(0.0, 0); 7];
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
            add(&mut sums[0], forward.windows(2).map(|z| square(z[1] - z[0])));
            add(&mut sums[1], line.windows(3).map(|z| square(z[2] - z[0])));
            add(&mut sums[2], line.windows(3).map(|z| square(z[2] - z[1] - (z[1] - z[0]))));
            if periodic || iy + 1 < ny {
                add(&mut sums[3], here.iter().zip(next).map(|(z, n)| square(n - z)));
            }
            if periodic || (iy > 0 && iy + 1 < ny) {
                let column = above.iter().zip(here).zip(next);
                add(&mut sums[4], column.clone().map(|((a, _), n)| square(n - a)));
                add(&mut sums[5], column.map(|((a, z), n)| square(n - z - (z - a))));
                let skip = usize::from(!periodic);
                let rise = above[skip..].iter().zip(&next[skip..]).map(|(a, n)| n - a);
                add(&mut sums[6], line.windows(3).zip(rise).map(|(z, n)| (z[2] - z[0]) * n));
            }
        }
        let [m2_x, m2_x_central, m4_x, m2_y, m2_y_central, m4_y, m2_xy] = sums.map(mean);
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

    /// Moments of the isotropic surface with the mean of both axes, given the mean square height (m²).
    pub(crate) fn isotropic(&self, m0: f64) -> SpectralMoments {
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

    /// That the rows of this map jump, whose slopes are then no lay; or that there is one.
    pub(crate) fn uneven(&self, map: &HeightMap) -> Option<Warning> {
        // Levelling may take heights at the end of the range beyond it: then rows are not compared.
        let rows = row_jumps(map.grid(), map.heights()).ok().and_then(|(_, _, warning)| warning);
        let lay = self.anisotropy().filter(|r| *r > 2.0);
        rows.or(lay.map(|ratio| Warning::Anisotropic { ratio }))
    }
}

fn square(x: f64) -> f64 {
    x * x
}

/// Adds the terms of a row and counts them.
pub(crate) fn add((all, count): &mut (f64, usize), terms: impl ExactSizeIterator<Item = f64>) {
    *count += terms.len();
    *all += sum(terms);
}

pub(crate) fn mean((sum, count): (f64, usize)) -> f64 {
    sum / count as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use contact_types::Grid;
    use std::f64::consts::TAU;

    /// Ridges that rise 1 and fall 1 along x, and 0.3 a point along y, of pixels 2 by 0.5.
    #[test]
    fn mean_slope_of_ridges() {
        let grid = Grid::new([5, 6], [2.0, 0.5]).unwrap();
        let height = |y: f64, x: f64| 0.15 * y + (x * 2.0) % 2.0;
        let found = mean_slope(&HeightMap::from_fn(grid, height).unwrap());
        assert!((found - 0.5 * (2.0 + 0.15)).abs() < 1e-12, "{found}");
    }

    /// One oblique wave: the central slopes are the exact ones times sin(q d) / d q, and it has no slope along its
    /// crests. A checkerboard, the shortest wave there is, they do not see.
    #[test]
    fn central_slopes_of_a_wave() {
        let (d, a) = ([3e-7, 2e-7], 3e-8);
        let grid = Grid::new([15, 22], d).unwrap();
        for k in [[1.0, 1.0], [4.0, 7.0], [7.0, 10.0]] {
            let q = [TAU * k[0] / (15.0 * d[0]), TAU * k[1] / (22.0 * d[1])];
            let map = HeightMap::from_fn(grid, |y, x| a * (q[0] * y + q[1] * x).cos()).unwrap();
            let m = DirectionalMoments::of(&map, Edges::Periodic).unwrap();
            let [y, x] = [0, 1].map(|axis| a / 2f64.sqrt() * (q[axis] * d[axis]).sin() / d[axis]);
            close(m.m2_x_central, x * x, 1e-12);
            close(m.m2_y_central, y * y, 1e-12);
            close(m.m2_xy, x * y, 1e-12);
            assert!(m.anisotropy().unwrap() > 1e10);
        }
        let sign = |i: usize| if (i / 22 + i % 22).is_multiple_of(2) { a } else { -a };
        let map = HeightMap::new(grid, (0..grid.len()).map(sign).collect()).unwrap();
        let m = DirectionalMoments::of(&map, Edges::Open).unwrap();
        assert_eq!((m.m2_x_central, m.m2_y_central, m.anisotropy()), (0.0, 0.0, None));
    }
}
