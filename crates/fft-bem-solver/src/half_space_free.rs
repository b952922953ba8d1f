//! Influence coefficients of a half space that is loaded nowhere but on the map.

use contact_types::Grid;
use grid_fft::GridFft;
use std::f64::consts::PI;

/// The shape that the map is padded to with zeros, at least twice its size, and the transform there of Love's
/// coefficients over E*, `ky` in `0..=py/2` running fastest: displacement at the centres of the pixels, zero far away, as
/// each pixel of the map is loaded uniformly. The convolution is the sum over all pixels, without error.
///
/// # Source
/// Love (1929), *Phil. Trans. R. Soc. A* 228, 377; zero-padding: Liu, Wang & Liu (2000), *Wear*
/// 243, 101–111, doi:10.1016/S0043-1648(00)00427-0.
pub(crate) fn love_coefficients(grid: Grid, e_star: f64) -> ([usize; 2], Vec<f64>) {
    let padded = grid.shape().map(padded_length);
    let transform = love_transform(padded, grid.pixel(), e_star);
    let [rows, columns] = padded.map(|n| n / 2 + 1);
    let mut table = Vec::with_capacity(columns * rows);
    table.extend(
        (0..columns)
            .flat_map(|kx| (0..rows).map(move |ky| ky * columns + kx))
            .map(|wave| transform[wave]),
    );
    (padded, table)
}

/// Transform of Love's coefficients over E* on a grid of `shape` pixels that repeats, each taken at its nearest image;
/// `kx` in `0..=nx/2` running fastest. An even field has a real transform.
pub(crate) fn love_transform([ny, nx]: [usize; 2], [dy, dx]: [f64; 2], e_star: f64) -> Vec<f64> {
    let distance = |i: usize, n: usize| i.min(n - i) as f64;
    let mut fft = GridFft::new([ny, nx]);
    let mut coefficients = vec![0.0; ny * nx];
    for iy in 0..=ny / 2 {
        for ix in 0..=nx / 2 {
            let u = love([distance(iy, ny) * dy, distance(ix, nx) * dx], [dy, dx]);
            for jy in [iy, (ny - iy) % ny] {
                coefficients[jy * nx + ix] = u / e_star;
                coefficients[jy * nx + (nx - ix) % nx] = u / e_star;
            }
        }
    }
    let mut spectrum = fft.new_spectrum();
    fft.forward(&coefficients, &mut spectrum);
    spectrum.into_iter().map(|wave| wave.re).collect()
}

/// Displacement, times E*, at `[y, x]` from the centre of a rectangle of sides `[dy, dx]` under
/// unit pressure:
///
/// ```math
/// u=\frac{1}{\pi E^*}\int_{x-d_x/2}^{x+d_x/2}\!\int_{y-d_y/2}^{y+d_y/2}
///   \frac{d\xi\,d\eta}{\sqrt{\xi^2+\eta^2}},\qquad
/// \iint\frac{d\xi\,d\eta}{\sqrt{\xi^2+\eta^2}}=\xi\,\mathrm{arsinh}\frac{\eta}{|\xi|}
///   +\eta\,\mathrm{arsinh}\frac{\xi}{|\eta|}
/// ```
///
/// The difference of the four corners loses digits with the square of the distance; beyond 40 of
/// the longer sides the expansion in moments of the rectangle, to fourth order, is exact to
/// rounding instead.
///
/// # Source
/// Love (1929); Johnson (1985), *Contact Mechanics*, eq. (3.25).
pub(crate) fn love([y, x]: [f64; 2], [dy, dx]: [f64; 2]) -> f64 {
    let (a, b) = (0.5 * dx, 0.5 * dy);
    let r2 = x * x + y * y;
    if r2 > (40.0 * dx.max(dy)).powi(2) {
        return far_field([y, x], [b, a]) / PI;
    }
    let corner = |x: f64, y: f64| {
        let along = |x: f64, y: f64| if x.abs() > 0.0 { x * (y / x.abs()).asinh() } else { 0.0 };
        along(x, y) + along(y, x)
    };
    let sum =
        corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b);
    sum / PI
}

/// Integral of 1/r over a rectangle of half sides `[b, a]` at `[y, x]`, by its moments.
fn far_field([y, x]: [f64; 2], [b, a]: [f64; 2]) -> f64 {
    let (x2, y2) = (x * x, y * y);
    let r2 = x2 + y2;
    let (a2, b2) = (a * a / r2, b * b / r2);
    let (cx, cy) = (x2 / r2, y2 / r2);
    // Derivatives of 1/r times powers of r, weighted with the moments a^2/3, a^4/5, a^2 b^2/9.
    let second = (a2 * (3.0 * cx - 1.0) + b2 * (3.0 * cy - 1.0)) / 6.0;
    let pure = |c: f64| 105.0 * c * c - 90.0 * c + 9.0;
    let mixed = 105.0 * cx * cy - 12.0;
    let fourth =
        (pure(cx) * a2 * a2 / 5.0 + pure(cy) * b2 * b2 / 5.0 + 6.0 * mixed * a2 * b2 / 9.0) / 24.0;
    4.0 * a * b / r2.sqrt() * (1.0 + second + fourth)
}

/// The shortest even length with no prime factor above 5 that keeps `n` pixels from meeting
/// themselves; 1 for a single pixel.
fn padded_length(n: usize) -> usize {
    if n == 1 {
        return 1;
    }
    let is_smooth = |mut m: usize| {
        for factor in [2, 3, 5] {
            while m.is_multiple_of(factor) {
                m /= factor;
            }
        }
        m == 1
    };
    (2 * n - 1..=4 * n).find(|&m| m % 2 == 0 && is_smooth(m)).expect("a power of 2 is among them")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Boundary, HalfSpace, close};
    use contact_types::ContactModulus;

    /// Middle of a loaded square of side s: u = 4 s p asinh(1) / (pi E*) (Johnson 1985, §3.3).
    #[test]
    fn square_under_uniform_pressure() {
        let exact = 4.0 * 1.0_f64.asinh() / PI;
        close(love([0.0, 0.0], [1.0, 1.0]), exact, 1e-15);
        // Corner: half of the middle of the same square.
        close(love([0.5, 0.5], [1.0, 1.0]), 0.5 * exact, 1e-14);
    }

    /// Both branches where they meet, along several directions and for thin pixels.
    #[test]
    fn near_and_far_formulas_agree() {
        for [dy, dx] in [[1.0, 1.0], [0.2, 1.0], [1.0, 0.01]] {
            for angle in [0.0, 0.3, 0.7, 1.2, 1.57] {
                let (sine, cosine) = f64::sin_cos(angle);
                let near = love([39.999 * sine, 39.999 * cosine], [dy, dx]);
                let far = far_field([39.999 * sine, 39.999 * cosine], [0.5 * dy, 0.5 * dx]) / PI;
                // Area times rounding of the corner terms.
                close(near, far, 1e-12 / dx.min(dy));
            }
        }
    }

    /// Against the sum it stands for, on small grids of any shape.
    #[test]
    fn convolution_is_the_sum_over_pixels() {
        for (shape, pixel) in [([5, 7], [1.0, 0.4]), ([8, 3], [2.0, 1.0]), ([1, 9], [1.0, 1.0])] {
            let grid = Grid::new(shape, pixel).unwrap();
            let e_star = 3.0;
            let modulus = ContactModulus::from_pascals(e_star).unwrap();
            let p: Vec<f64> = (0..grid.len()).map(|i| 1.0 + (i as f64 * 1.7).sin()).collect();
            let mut u = p.clone();
            HalfSpace::new(grid, modulus, Boundary::Free).displace(&mut u);
            let nx = shape[1];
            for (i, u) in u.iter().enumerate() {
                let sum: f64 = p
                    .iter()
                    .enumerate()
                    .map(|(j, p)| {
                        let y = ((i / nx) as f64 - (j / nx) as f64) * pixel[0];
                        let x = ((i % nx) as f64 - (j % nx) as f64) * pixel[1];
                        p * love([y, x], pixel) / e_star
                    })
                    .sum();
                close(*u, sum, 1e-13);
            }
        }
    }
}
