//! Families that were judged before the constants were fixed on them too: other formulas, other seeds.

use crate::families::{crop, exponential, field, lines, marks, onto, poisson, wide};
use crate::later;
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin};

/// Their names.
pub(crate) const JUDGED: [&str; 30] = [
    "strokes at any angle",
    "parallel grooves",
    "cross-hatch",
    "ploughed scratches",
    "honed, few deep grooves",
    "craters",
    "clusters of drops",
    "few hills",
    "dots, some missing",
    "volatile",
    "few long waves",
    "grains of two levels",
    "self-affine",
    "roll-off at the side",
    "crop of a lay",
    "crop, log-normal",
    "crop, H 1, tilted",
    "crop, H 0.3",
    "crop, worn",
    "crop, scratched",
    "few ridges",
    "oblique scratches",
    "scuffed",
    "hail",
    "islands",
    "ground, with burrs",
    "crop, H 0.7",
    "crop of two scales",
    "crop, patchy",
    "crop of a lay, tilted",
];

/// Heights in points.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    Ok(match family {
        "strokes at any angle" => {
            let ground = field(d, [0.6, 5.0, 24.0], 0)?;
            onto(d, &ground, &marks(d, 9.0, 1), |mark, y, x| {
                let [along, across] = mark.seen(d, y, x);
                let [long, wide, deep] = mark.own;
                let (long, wide) = (side * (0.1 + 0.3 * long), 2.0 + 3.0 * wide);
                let end = 0.5 * (1.0 - ((along.abs() - long) / 3.0).tanh());
                -exponential(deep) * end * (1.0 - across.abs() / wide).max(0.0)
            })
        }
        "parallel grooves" => {
            let ground = wide(d, n, [0.7, 5.0, 24.0], 5.0, 0)?;
            onto(d, &ground, &lines(d, 7.0, &[0.0], 1), |line, y, x| {
                let wide = 3.0 + 6.0 * line.own[1];
                let s = line.distance(d, y, x) / wide;
                -1.2 * exponential(line.own[0]) * (1.0 - s * s).max(0.0)
            })
        }
        "cross-hatch" => {
            let ground = field(d, [0.5, 4.0, 16.0], 0)?;
            onto(d, &ground, &lines(d, 14.0, &[-1.0, 1.0], 1), |line, y, x| {
                let s = line.distance(d, y, x) / (3.0 + 2.0 * line.own[1]);
                -(0.4 + 1.2 * line.own[0])
                    * if s < 1.0 { 0.5 + 0.5 * (0.5 * TAU * s).cos() } else { 0.0 }
            })
        }
        "ploughed scratches" => {
            let ground = field(d, [0.8, 6.0, 40.0], 0)?;
            onto(d, &ground, &lines(d, 8.0, &[-1.0, 0.0, 2.0], 1), |line, y, x| {
                let s = (line.distance(d, y, x) / (2.5 + line.own[1])).powi(2);
                (0.5 + line.own[0]) * (s - 1.0) * (-0.5 * s).exp()
            })
        }
        "honed, few deep grooves" => {
            let ground = field(d, [0.7, 6.0, 30.0], 0)?;
            let flat: Vec<f64> = ground.iter().map(|z| softmin(*z, 0.0, 0.1)).collect();
            onto(d, &flat, &lines(d, 5.0, &[-1.0, 1.0], 1), |line, y, x| {
                -2.5 * (-0.5 * (line.distance(d, y, x) / 3.5).powi(2)).exp()
            })
        }
        "craters" => {
            let ground = field(d, [0.7, 5.0, 30.0], 0)?;
            onto(d, &ground, &marks(d, 12.0, 1), |mark, y, x| {
                let radius = 4.0 / (1.0 - 0.85 * mark.own[0]).sqrt();
                let s = (mark.distance(d, y, x) / radius).powi(2);
                0.12 * radius * ((s - 1.0).min(0.0) + 0.4 * (-(s - 1.0).powi(2) / 0.1).exp())
            })
        }
        "clusters of drops" => {
            let ground = field(d, [0.7, 5.0, 30.0], 0)?;
            let parents = marks(d, 4.0, 1);
            let children: Vec<f64> = d.points(|y, x| {
                parents
                    .iter()
                    .enumerate()
                    .map(|(k, parent)| {
                        let u = d.uniform(24, 50 + k as u64);
                        let [a, b] = parent.seen(d, y, x);
                        u.chunks_exact(3)
                            .map(|u| {
                                let (dy, dx) = (24.0 * (u[0] - 0.5), 24.0 * (u[1] - 0.5));
                                let r = 3.0 + 4.0 * u[2];
                                0.1 * (r * r - (a - dy).powi(2) - (b - dx).powi(2)).max(0.0) / r
                            })
                            .fold(0.0, f64::max)
                    })
                    .fold(0.0, f64::max)
            });
            mix(&ground, &children, |a, b| a + b)
        }
        "few hills" => {
            let ground = field(d, [0.8, 6.0, 20.0], 0)?;
            onto(d, &ground, &marks(d, 6.0, 1), |mark, y, x| {
                let wide = 8.0 + 10.0 * mark.own[0];
                (1.0 + 2.0 * mark.own[1]) * (-0.5 * (mark.distance(d, y, x) / wide).powi(2)).exp()
            })
        }
        "dots, some missing" => {
            let ground = field(d, [0.7, 5.0, 30.0], 0)?;
            let u = d.uniform(36, 1);
            let a = d.points(|y, x| {
                let (cy, cx) = ((y * 6.0 / side).floor(), (x * 6.0 / side).floor());
                let c = |s: f64, i: f64| s * 6.0 / side - i - 0.5;
                let r = c(y, cy).hypot(c(x, cx)) / 0.3;
                if u[(cy * 6.0 + cx) as usize] < 0.7 { -1.5 * (-r.powi(4)).exp() } else { 0.0 }
            });
            mix(&ground, &a, |a, b| a + b)
        }
        "volatile" => {
            let strength = field(d, [0.8, 40.0, 0.5 * side], 1)?;
            mix(&field(d, [0.6, 4.0, 20.0], 0)?, &strength, |h, s| h * (0.35 * s).exp())
        }
        "few long waves" => {
            let u = d.uniform(12, 1);
            let ground = field(d, [0.7, 5.0, 20.0], 0)?;
            let waves = d.points(|y, x| {
                [[0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [1.0, 0.0]]
                    .iter()
                    .enumerate()
                    .map(|(k, [ky, kx])| {
                        let amplitude = (2.0 * exponential(u[3 * k])).sqrt();
                        amplitude * (TAU * ((ky * y + kx * x) / side + u[3 * k + 1])).cos()
                    })
                    .sum()
            });
            mix(&ground, &waves, |a, b| a + 0.7 * b)
        }
        "grains of two levels" => {
            let coarse = field(d, [0.8, 16.0, 0.35 * side], 1)?;
            mix(&field(d, [0.6, 4.0, 20.0], 0)?, &coarse, |f, z| (3.0 * z).tanh() + 0.6 * f)
        }
        "self-affine" => field(d, [0.6, 4.0, 0.25 * side], 0)?,
        "roll-off at the side" => field(d, [0.75, 6.0, side], 0)?,
        "crop of a lay" => crop(d, [0.7, 5.0, 0.4], 4.0)?,
        "crop, log-normal" => {
            crop(d, [0.7, 6.0, 0.5], 1.0)?.iter().map(|z| 2.0 * (0.4 * z).exp()).collect()
        }
        "crop, H 1, tilted" => crop(d, [1.0, 8.0, 0.7], 1.0)?,
        "crop, H 0.3" => crop(d, [0.3, 5.0, 0.3], 1.0)?,
        "crop, worn" => {
            crop(d, [0.75, 6.0, 0.5], 1.0)?.iter().map(|z| softmin(*z, 0.5, 0.3)).collect()
        }
        "crop, scratched" => {
            let ground = crop(d, [0.6, 5.0, 0.7], 1.0)?;
            // Not through the edges: they end there.
            let count = poisson(d, 8.0, 1);
            let u = d.uniform(4 * count, 2);
            let a = d.points(|y, x| {
                u.chunks_exact(4)
                    .map(|u| {
                        let angle = 0.5 * TAU * u[0];
                        let (sin, cos) = angle.sin_cos();
                        let s = (x - u[1] * side) * cos + (y - u[2] * side) * sin;
                        -(0.5 + u[3]) * (-0.5 * (s / 3.0).powi(2)).exp()
                    })
                    .sum()
            });
            mix(&ground, &a, |a, b| a + b)
        }
        _ => later::heights(family, d)?,
    })
}
