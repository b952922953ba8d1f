//! Slope, curvature and autocorrelation by the distance over which they are taken.
//!
//! Sanner, Nöhring, Thimons, Jacobs & Pastewka 2022, *Scale-dependent roughness parameters for topography
//! analysis*, Appl. Surf. Sci. Adv. 7, 100190, doi:10.1016/j.apsadv.2021.100190, eqs 3 to 9.

use contact_types::HeightMap;

/// What differences over one distance say, along x (rows) or y (columns).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct ByDistance {
    /// The distance ℓ (m): a whole number of points.
    pub distance: f64,
    /// Rms slope √⟨\[z(x+ℓ) − z(x)\]²⟩ / ℓ (-).
    pub slope: f64,
    /// Rms curvature √⟨\[z(x+ℓ) − 2 z(x) + z(x−ℓ)\]²⟩ / ℓ² (1/m); `None` where the map is shorter than 2ℓ.
    pub curvature: Option<f64>,
    /// Autocorrelation of the heights about their mean, ⟨z(x+ℓ) z(x)⟩ / ⟨z²⟩ (-), over the pairs that
    /// there are; `None` for a flat map.
    pub autocorrelation: Option<f64>,
}

/// Along x, then along y, at distances of 1, 2, 3, 4, 6, 8, 12, … points up to half of the side, by pairs within the map.
pub fn by_distance(map: &HeightMap) -> [Vec<ByDistance>; 2] {
    let ([ny, nx], [dy, dx]) = (map.grid().shape(), map.grid().pixel());
    let z = map.heights();
    let mean = map.mean();
    let variance = z.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / z.len() as f64;
    let at = |y: usize, x: usize| z[y * nx + x] - mean;
    let along_x = steps(nx).map(|lag| line(ny, nx, lag, dx, variance, at));
    let along_y = steps(ny).map(|lag| line(nx, ny, lag, dy, variance, |column, i| at(i, column)));
    [along_x.collect(), along_y.collect()]
}

/// 1, 2, 3, 4, 6, 8, 12, 16, … up to half of `n`.
fn steps(n: usize) -> impl Iterator<Item = usize> {
    let powers = std::iter::successors(Some(1_usize), |p| p.checked_mul(2));
    let all = powers.flat_map(|p| [Some(p), (p > 1).then_some(p + p / 2)]).flatten();
    all.take_while(move |lag| *lag <= (n / 2).max(1) && *lag < n)
}

fn line(
    lines: usize,
    points: usize,
    lag: usize,
    pixel: f64,
    variance: f64,
    z: impl Fn(usize, usize) -> f64,
) -> ByDistance {
    let distance = lag as f64 * pixel;
    let (mut first, mut product, mut second) = (0.0, 0.0, 0.0);
    for row in 0..lines {
        for i in 0..points - lag {
            let (a, b) = (z(row, i), z(row, i + lag));
            first += (b - a) * (b - a);
            product += a * b;
        }
        for i in 2 * lag..points {
            let bend = z(row, i) - 2.0 * z(row, i - lag) + z(row, i - 2 * lag);
            second += bend * bend;
        }
    }
    let pairs = (lines * (points - lag)) as f64;
    let triples = (lines * points.saturating_sub(2 * lag)) as f64;
    ByDistance {
        distance,
        slope: (first / pairs).sqrt() / distance,
        curvature: (triples > 0.0).then(|| (second / triples).sqrt() / (distance * distance)),
        autocorrelation: (variance > 0.0).then(|| product / pairs / variance),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::Grid;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn of_a_wave_they_are_the_closed_forms() {
        let (n, waves, amplitude, pixel) = (256, 8.0, 2e-7, 1e-6);
        let grid = Grid::new([4, n], [3e-6, pixel]).unwrap();
        // Rows in quadrature: sums over them are free of the phase.
        let height = |i: usize| {
            let phase = (i / n) as f64 * PI / 2.0;
            amplitude * (TAU * waves * (i % n) as f64 / n as f64 + phase).sin()
        };
        let map = HeightMap::new(grid, (0..4 * n).map(height).collect()).unwrap();
        let [along_x, along_y] = by_distance(&map);
        let lags: Vec<f64> = along_x.iter().map(|d| (d.distance / pixel).round()).collect();
        assert_eq!(lags[..7], [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0]);
        assert_eq!((lags.len(), lags[13], along_y.len()), (14, 128.0, 2));
        for d in along_x.iter().filter(|d| d.distance < 64.5 * pixel) {
            let half = PI * waves * d.distance / (n as f64 * pixel);
            let slope = 2.0_f64.sqrt() * amplitude * half.sin().abs() / d.distance;
            let curvature = 8.0_f64.sqrt() * amplitude * half.sin().powi(2) / d.distance.powi(2);
            let found = [d.slope, d.curvature.unwrap(), d.autocorrelation.unwrap()];
            let scale = [1.0, amplitude / pixel.powi(2), 1.0];
            for (k, exact) in [slope, curvature, (2.0 * half).cos()].into_iter().enumerate() {
                assert!((found[k] - exact).abs() < 1e-9 * scale[k], "{d:?} {exact}");
            }
        }
    }

    #[test]
    fn a_flat_map_has_no_autocorrelation() {
        let grid = Grid::new([3, 2], [1e-6; 2]).unwrap();
        let [along_x, along_y] = by_distance(&HeightMap::new(grid, vec![1e-6; 6]).unwrap());
        assert_eq!((along_x.len(), along_y.len()), (1, 1));
        assert!(along_x[0].slope < 1e-12 && along_x[0].curvature.is_none());
        assert!(along_x[0].autocorrelation.is_none());
    }
}
