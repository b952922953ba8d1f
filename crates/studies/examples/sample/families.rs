//! What the families of this study are made with: fields whose strength differs from map to map as
//! it does from place to place, crops of larger maps, and marks strewn at random.

use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, self_affine};
use surface_stats::synthesis::Scale;

/// A field of 0.1 rms gradient expected over its family, heights in points: a map has what it has.
pub(crate) fn field(d: &Draw, [hurst, cutoff, rolloff]: [f64; 3], salt: u64) -> Heights {
    wide(d, d.n, [hurst, cutoff, rolloff], 1.0, salt)
}

/// The same on `n` points along each side, `stretch` times longer along y.
pub(crate) fn wide(
    d: &Draw,
    n: usize,
    [hurst, cutoff, rolloff]: [f64; 3],
    stretch: f64,
    salt: u64,
) -> Heights {
    let scale = Scale::ExpectedRmsGradient(0.1);
    self_affine(n, [hurst, cutoff, rolloff], stretch, scale, d.seed + 100_000 * salt)
}

/// The corner of a field on four times the points along each side, whose roll-off wavelength is the
/// side of the corner over `ratio`.
pub(crate) fn crop(d: &Draw, [hurst, cutoff, ratio]: [f64; 3], stretch: f64) -> Heights {
    let (n, m) = (d.n, 4 * d.n);
    let whole = wide(d, m, [hurst, cutoff, n as f64 / ratio], stretch, 0)?;
    Ok((0..n * n).map(|i| whole[i / n * m + i % n]).collect())
}

/// A number of marks that come independently of one another, `mean` of them on average.
pub(crate) fn poisson(d: &Draw, mean: f64, salt: u64) -> usize {
    let mut product = 1.0;
    let uniform = d.uniform(20 + 4 * mean as usize, salt);
    uniform
        .iter()
        .take_while(|u| {
            product *= *u;
            product > (-mean).exp()
        })
        .count()
}

/// A line across the whole map, through its edges.
pub(crate) struct Line {
    /// Columns per row.
    slope: f64,
    /// Where it starts.
    at: f64,
    /// Two numbers of its own, between 0 and 1.
    pub(crate) own: [f64; 2],
}

impl Line {
    /// Distance of a point.
    pub(crate) fn distance(&self, d: &Draw, y: f64, x: f64) -> f64 {
        d.apart(x + self.slope * y, self.at) / self.slope.hypot(1.0)
    }
}

/// Lines, `mean` on average, of these slopes.
pub(crate) fn lines(d: &Draw, mean: f64, slopes: &[f64], salt: u64) -> Vec<Line> {
    let count = poisson(d, mean, salt);
    let u = d.uniform(4 * count, salt + 1);
    let line = |u: &[f64]| Line {
        slope: slopes[(u[0] * slopes.len() as f64) as usize],
        at: u[1] * d.n as f64,
        own: [u[2], u[3]],
    };
    u.chunks_exact(4).map(line).collect()
}

/// A spot or a stroke somewhere on the map.
pub(crate) struct Mark {
    at: [f64; 2],
    angle: f64,
    /// Three numbers of its own, between 0 and 1.
    pub(crate) own: [f64; 3],
}

impl Mark {
    /// Along and across its direction, from its middle, on the map that repeats.
    pub(crate) fn seen(&self, d: &Draw, y: f64, x: f64) -> [f64; 2] {
        let (dy, dx) = (d.apart(y, self.at[0]), d.apart(x, self.at[1]));
        let (sin, cos) = self.angle.sin_cos();
        [dx * cos + dy * sin, dy * cos - dx * sin]
    }

    /// Distance from its middle.
    pub(crate) fn distance(&self, d: &Draw, y: f64, x: f64) -> f64 {
        let [a, b] = self.seen(d, y, x);
        a.hypot(b)
    }
}

/// Marks, `mean` on average, anywhere.
pub(crate) fn marks(d: &Draw, mean: f64, salt: u64) -> Vec<Mark> {
    let count = poisson(d, mean, salt);
    let side = d.n as f64;
    let u = d.uniform(6 * count, salt + 1);
    let mark = |u: &[f64]| Mark {
        at: [u[0] * side, u[1] * side],
        angle: u[2] * TAU,
        own: [u[3], u[4], u[5]],
    };
    u.chunks_exact(6).map(mark).collect()
}

/// An exponentially distributed number of mean 1 from one between 0 and 1.
pub(crate) fn exponential(u: f64) -> f64 {
    -(1.0 - u).max(1e-12).ln()
}

/// Sums what `f` gives of each part at each point, onto a ground.
pub(crate) fn onto<T>(
    d: &Draw,
    ground: &[f64],
    parts: &[T],
    f: impl Fn(&T, f64, f64) -> f64,
) -> Vec<f64> {
    let sum = d.points(|y, x| parts.iter().map(|part| f(part, y, x)).sum());
    sum.iter().zip(ground).map(|(a, b)| a + b).collect()
}
