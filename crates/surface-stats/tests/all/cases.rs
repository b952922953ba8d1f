//! Maps at the extremes whose statistics are known in closed form, and what the crate makes of
//! them.

#![allow(clippy::print_stdout, reason = "the lines are counted in the book")]

use contact_types::{Grid, HeightMap};
use std::f64::consts::{PI, TAU};
use surface_stats::{Edges, StatsOptions, SurfaceStatistics};

/// Every line of the table in the book, each with its limit.
#[test]
fn closed_forms_at_the_extremes() {
    waves();
    offsets();
    few_levels();
}

/// Prints a line: which numbers of which map, what is extreme about it, and their largest relative error, absolute where
/// the value is 0.
fn hold(what: &str, extreme: &str, error: f64, limit: f64) {
    println!("surface-stats: {what}, {extreme}: {error:.1e}");
    assert!(error <= limit, "{what}, {extreme}: {error:e}, limit {limit:e}");
}

/// What is absent where it should be a number.
fn given(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

pub(crate) fn map(
    shape: [usize; 2],
    pixel: [f64; 2],
    height: impl Fn(usize, usize) -> f64,
) -> HeightMap {
    let heights = (0..shape[0] * shape[1]).map(|i| height(i / shape[1], i % shape[1])).collect();
    let grid = Grid::new(shape, pixel).expect("the pixels are positive");
    HeightMap::new(grid, heights).expect("the heights are finite")
}

fn statistics(map: &HeightMap) -> SurfaceStatistics {
    let options = StatsOptions { edges: Edges::Periodic, ..StatsOptions::default() };
    SurfaceStatistics::of(map, &options).expect("the map is within range")
}

/// The largest relative error of pairs (found, expected); absolute where 0 is expected.
fn worst(pairs: &[(f64, f64)]) -> f64 {
    let error = |&(found, expected): &(f64, f64)| {
        let difference = (found - expected).abs();
        if expected.abs() > 0.0 { difference / expected.abs() } else { difference }
    };
    pairs.iter().map(error).fold(0.0, |worst, e| if e <= worst { worst } else { e })
}

/// One plane wave `amplitude cos(qy y + qx x)` with `turns` periods along each side.
struct PlaneWave {
    shape: [usize; 2],
    pixel: [f64; 2],
    turns: [usize; 2],
    amplitude: f64,
}

impl PlaneWave {
    fn map(&self) -> HeightMap {
        let ([ny, nx], [ky, kx]) = (self.shape, self.turns);
        // Whole turns are left out in integers, so that the angle has all its digits.
        let angle = |k: usize, i: usize, n: usize| TAU * ((k * i) % n) as f64 / n as f64;
        let phase = |iy: usize, ix: usize| angle(ky, iy, ny) + angle(kx, ix, nx);
        map(self.shape, self.pixel, |iy, ix| self.amplitude * phase(iy, ix).cos())
    }

    /// Wavenumbers times half a pixel.
    fn half_angles(&self) -> [f64; 2] {
        [0, 1].map(|a| PI * self.turns[a] as f64 / self.shape[a] as f64)
    }

    fn m0(&self) -> f64 {
        self.amplitude * self.amplitude / 2.0
    }

    /// Found against `m0 (2 sin(q d/2) / d)^2` and `^4` of each axis and what follows from them.
    fn by_differences(&self, found: &SurfaceStatistics) -> f64 {
        let (halves, m0) = (self.half_angles(), self.m0());
        let [m2_y, m2_x] = [0, 1].map(|a| m0 * (2.0 * halves[a].sin() / self.pixel[a]).powi(2));
        let [m4_y, m4_x] = [0, 1].map(|a| m0 * (2.0 * halves[a].sin() / self.pixel[a]).powi(4));
        let (m2, m4) = (f64::midpoint(m2_x, m2_y), f64::midpoint(m4_x, m4_y));
        worst(&[
            (found.m0, m0),
            (found.m2_x, m2_x),
            (found.m2_y, m2_y),
            (found.m4_x, m4_x),
            (found.m4_y, m4_y),
            (found.rms_gradient, (2.0 * m2).sqrt()),
            (given(found.bandwidth), m0 * m4 / (m2 * m2)),
        ])
    }

    /// Found against `m2 = m0 q^2 / 2`, `m4 = m0 (qx^4 + qy^4) / 2`.
    fn by_spectrum(&self, found: &SurfaceStatistics) -> f64 {
        let [qy, qx] = [0, 1].map(|a| 2.0 * self.half_angles()[a] / self.pixel[a]);
        let (m0, q2) = (self.m0(), qy * qy + qx * qx);
        worst(&[
            (found.m0_spectral, m0),
            (found.m2_spectral, 0.5 * m0 * q2),
            (found.m4_spectral, 0.5 * m0 * (qx.powi(4) + qy.powi(4))),
        ])
    }
}

/// What is extreme, pixels, amplitude over pixel (the steepest point has about this slope), shape and turns.
type Group = (&'static str, &'static [[f64; 2]], &'static [f64], [usize; 2], [usize; 2]);

fn waves() {
    let (square, few, all) = ([24, 31], [3, 5], &[1e-12, 1.0, 1e3]);
    let groups: [Group; 8] = [
        ("slope 1e−12", &[[1e-6, 1.5e-6]], &[1e-12], square, few),
        ("slope 1000", &[[1e-6, 1.5e-6]], &[1e3], square, few),
        ("pixels of 1e−15 m", &[[1e-15, 2e-15]], all, square, few),
        ("pixels of 1e6 m", &[[1e6, 2e6]], all, square, few),
        ("pixels 1 : 1000", &[[1e-9, 1e-6], [1e-3, 1e-6]], &[0.1], square, few),
        ("prime sides, 61 × 53", &[[1e-6, 1e-6]], &[0.1], [61, 53], [7, 4]),
        ("one period of 4099 pixels", &[[1e-6, 1e-6]], &[0.1], [31, 4099], [5, 1]),
        ("shortest wave the pixels hold", &[[1e-6, 2e-6]], &[0.1], [16, 32], [8, 16]),
    ];
    for (extreme, pixels, steepness, shape, turns) in groups {
        let mut errors = [0.0_f64; 2];
        for (&pixel, s) in pixels.iter().flat_map(|p| steepness.iter().map(move |s| (p, s))) {
            let amplitude = s * f64::min(pixel[0], pixel[1]);
            let wave = PlaneWave { shape, pixel, turns, amplitude };
            let mut map = wave.map();
            let is_shortest = wave.turns[0] * 2 == wave.shape[0];
            if is_shortest {
                // +A and −A in turn have twice the mean square of a wave sampled anywhere.
                let half = map.heights().iter().map(|h| h * 0.5f64.sqrt()).collect();
                map = HeightMap::new(map.grid(), half).expect("the heights are finite");
            }
            let found = statistics(&map);
            errors[0] = errors[0].max(wave.by_differences(&found));
            errors[1] = errors[1].max(wave.by_spectrum(&found));
        }
        hold("one cosine: m0, m2, m4 by differences", extreme, errors[0], 1e-12);
        hold("one cosine: m0, m2, m4 by spectrum", extreme, errors[1], 1e-12);
    }
}

/// Relief of nanometres far from zero, where a double has few digits left for it.
fn offsets() {
    let wave = PlaneWave { shape: [61, 64], pixel: [1e-6, 1e-6], turns: [4, 5], amplitude: 1e-9 };
    let relief = wave.map();
    for (offset, place) in [(0.076, "76 mm"), (1e6, "1e6 m")] {
        let heights: Vec<f64> = relief.heights().iter().map(|h| h + offset).collect();
        // The difference of two close doubles is exact.
        let back = heights.iter().map(|h| h - offset).collect();
        let high = HeightMap::new(relief.grid(), heights).expect("the heights are finite");
        let low = HeightMap::new(relief.grid(), back).expect("the heights are finite");
        let (found, moved) = (statistics(&high), statistics(&low));
        let extreme = format!("heights of 1 nm on {place}");
        let error = worst(&[
            (found.m0, moved.m0),
            (found.m2, moved.m2),
            (found.m4, moved.m4),
            (found.m0_spectral, moved.m0_spectral),
            (found.m2_spectral, moved.m2_spectral),
            (found.m4_spectral, moved.m4_spectral),
        ]);
        let what = "one cosine: m0, m2, m4, both ways, against the same heights moved back to 0";
        hold(what, &extreme, error, 1e-12);
        // Each height is off by half a spacing at most, which moves the root mean square of the
        // heights by no more, of first differences by twice, of second by four times as much.
        let half_spacing = 0.5 * (offset.next_up() - offset);
        let (m0, d) = (wave.m0(), wave.pixel);
        let halves = wave.half_angles();
        let rms = |power: i32, a: usize| m0.sqrt() * (2.0 * halves[a].sin()).powi(power);
        let share = |square: f64, pixel: f64, power: i32, a: usize| {
            let found = square.sqrt() * pixel.powi(power);
            (found - rms(power, a)).abs() / (half_spacing * 2f64.powi(power))
        };
        let shares = [
            share(found.m0, 1.0, 0, 0),
            share(found.m2_y, d[0], 1, 0),
            share(found.m2_x, d[1], 1, 1),
            share(found.m4_y, d[0], 2, 0),
            share(found.m4_x, d[1], 2, 1),
        ];
        let error = shares.into_iter().fold(0.0, f64::max);
        let what =
            "one cosine: m0, m2, m4 by differences, share of what rounding of the heights allows";
        hold(what, &extreme, error, 1.0);
    }
}

/// One spike, two levels, steps.
fn few_levels() {
    let error = [1e-40, 1e-9, 1e40].map(spike).into_iter().fold(0.0, f64::max);
    let what = "one spike: Sq, Ssk, Sku = 262 142, m2, m4";
    hold(what, "one pixel of 512², high by 1e−40, 1e−9, 1e40 m", error, 1e-12);

    let (a, d) = (1e-9, 1e-6);
    for (offset, extreme) in [(0.0, "±1 nm, chequered"), (1e6, "1e6 m ± 1 m, chequered")] {
        let a = if offset > 0.0 { 1.0 } else { a };
        let sign = |iy: usize, ix: usize| if (iy + ix).is_multiple_of(2) { a } else { -a };
        let s = statistics(&map([16, 18], [d, d], |iy, ix| offset + sign(iy, ix)));
        let error = worst(&[
            (s.rms_height, a),
            (s.mean_abs_height, a),
            (given(s.skewness), 0.0),
            (given(s.kurtosis), 1.0),
            (s.m2, (2.0 * a / d).powi(2)),
            (s.m4, (4.0 * a / (d * d)).powi(2)),
        ]);
        hold("two levels: Sq, Sa, Ssk = 0, Sku = 1, m2, m4", extreme, error, 1e-14);
    }
    let what = "stairs of 25 steps: step found, Sq, Sku, m2, m4";
    hold(what, "steps of 10 nm", stairs(0.0), 1e-12);
    hold(what, "steps of 10 nm on 76 mm (heights hold 7e−10 of a step)", stairs(0.076), 1e-9);
}

/// One pixel of 512 x 512: the moments of a coin that shows heads with probability 1/n.
fn spike(height: f64) -> f64 {
    let (n, d) = (512.0 * 512.0, 1e-6);
    let peak = |iy, ix| if (iy, ix) == (200, 77) { height } else { 0.0 };
    let map = map([512, 512], [d, d], peak);
    let found = statistics(&map);
    let p = 1.0 / n;
    let spread = p * (1.0 - p);
    let squared = height * height / n;
    worst(&[
        (found.rms_height, height * spread.sqrt()),
        (given(found.skewness), (1.0 - 2.0 * p) / spread.sqrt()),
        (given(found.kurtosis), 1.0 / spread - 3.0),
        (found.m2_x, 2.0 * squared / (d * d)),
        (found.m2_y, 2.0 * squared / (d * d)),
        (found.m4_x, 6.0 * squared / (d * d) / (d * d)),
        (found.m4_y, 6.0 * squared / (d * d) / (d * d)),
    ])
}

/// Two flights of L = 25 steps of 10 nm along x: every level as often.
fn stairs(offset: f64) -> f64 {
    let (levels, step, d) = (25.0_f64, 1e-8, 1e-6);
    let map = map([8, 50], [d, d], |_, ix| offset + step * (ix % 25) as f64);
    let s = statistics(&map);
    let squares = levels * levels;
    worst(&[
        (given(s.height_step), step),
        (s.rms_height, step * ((squares - 1.0) / 12.0).sqrt()),
        (given(s.kurtosis), 0.6 * (3.0 * squares - 7.0) / (squares - 1.0)),
        // L - 1 rises of one step and one fall of L - 1.
        (s.m2_x, (levels - 1.0) * (step / d).powi(2)),
        // The fall bends the line by L steps on each side.
        (s.m4_x, 2.0 * levels * (step / (d * d)).powi(2)),
        (s.m2_y, 0.0),
        (s.m4_y, 0.0),
    ])
}
