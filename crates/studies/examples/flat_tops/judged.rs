//! Families of maps that took no part.

use crate::second;
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, gradient, mix, softmin, triangle};

/// Their names.
pub(crate) const JUDGED: [&str; 42] = [
    "self-affine",
    "log-normal",
    "oblique lay",
    "lapped",
    "stamped",
    "knurled",
    "embossed",
    "dimples",
    "cusp valleys",
    "scratched",
    "worn lay",
    "honed",
    "bimodal",
    "egg boxes",
    "cones",
    "facets",
    "two scales",
    "debris",
    "rounded down",
    "cut out",
    "coined",
    "diamonds, worn",
    "etched grains",
    "laser dots",
    "printed bars",
    "peened",
    "filled valleys",
    "milled arcs",
    "woven",
    "cracked",
    "part of a pattern",
    "smooth, fine",
    "sealed pores",
    "puddles",
    "ridges on a flat",
    "grit on a flat",
    "cut at both ends",
    "etched channels",
    "wiped coating",
    "tiles",
    "cusp ridges",
    "smooth, long",
];

/// Heights of a map of a family, in any unit.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    Ok(match family {
        "self-affine" => {
            d.field(d.lin(3, 0.2, 1.0), d.log(1, 5.0, 12.0), side / d.log(2, 2.0, 8.0), 1.0, 7)?
        }
        "log-normal" => {
            let s = d.lin(3, 0.3, 0.6);
            let s = if d.t[0] < 0.5 { s } else { -s };
            d.rough(7)?.iter().map(|z| (s * z).exp() / s).collect()
        }
        "oblique lay" => {
            let lay = d.field(0.8, d.log(1, 5.0, 10.0), side / 4.0, d.log(3, 3.0, 10.0), 7)?;
            d.points(|y, x| lay[(y as usize) * n + (x as usize + y as usize) % n])
        }
        "lapped" => {
            // A plane lapped flat that keeps its deepest pits and shallow scratches.
            let level = d.lin(3, -1.0, 0.2);
            let fine = d.field(0.5, 3.0, 12.0, 1.0, 8)?;
            mix(&d.rough(7)?, &fine, |z, f| softmin(z, level, 0.08) + 0.015 * f)
        }
        "stamped" => {
            // A coarse relief pressed into a fine one: everything above a plane flat, with a rounded rim.
            let (level, w) = (d.lin(3, 0.0, 1.2), d.log(0, 0.1, 0.5));
            d.rough(7)?
                .iter()
                .map(|z| {
                    level
                        + w * (((z - level) / w).min(0.0) - 0.2 * ((z - level) / w).max(0.0).tanh())
                })
                .collect()
        }
        "knurled" => {
            let (k, flat) = (d.log(1, 3.0, 12.0).round(), d.lin(3, 0.5, 1.0));
            let rough = d.log(0, 1e-3, 0.05);
            let fine = d.field(0.7, 5.0, 30.0, 1.0, 8)?;
            let a = d.points(|y, x| {
                let u = triangle(k * (x + y) / side).min(triangle(k * (x - y) / side + 0.5));
                u.min(flat)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "embossed" => {
            let u = d.uniform(400, 8);
            let cells = 10.0;
            let edge = d.log(3, 0.4, 2.5);
            let rough = d.log(0, 0.005, 0.1);
            let fine = d.field(0.7, 4.0, 30.0, 1.0, 8)?;
            // Bars of random length along x and y: strokes.
            let bars: Vec<[f64; 4]> = (0..20)
                .map(|i| {
                    let [a, b, c, e] = [u[4 * i], u[4 * i + 1], u[4 * i + 2], u[4 * i + 3]];
                    let long = (0.1 + 0.2 * c) * side;
                    let thin = side / cells / 3.0;
                    if e < 0.5 {
                        [a * side, b * side, long, thin]
                    } else {
                        [a * side, b * side, thin, long]
                    }
                })
                .collect();
            let a = d.points(|y, x| {
                bars.iter()
                    .map(|[cy, cx, ly, lx]| {
                        let s = (d.apart(y, *cy).abs() - 0.5 * ly)
                            .max(d.apart(x, *cx).abs() - 0.5 * lx);
                        0.5 * (1.0 - (s / edge).tanh())
                    })
                    .fold(0.0, f64::max)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "dimples" => {
            let k = d.lin(1, 3.0, 9.0).round();
            let r0 = d.lin(2, 0.25, 0.45);
            let rough = d.log(0, 0.005, 0.1);
            let fine = d.field(0.7, 5.0, 30.0, 1.0, 8)?;
            let a = d.points(|y, x| {
                let c = |s: f64| (s * k / side).rem_euclid(1.0) - 0.5;
                let r2 = (c(y).powi(2) + c(x).powi(2)) / (r0 * r0);
                -(1.0 - r2).max(0.0)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "cusp valleys" => {
            let k = d.log(1, 3.0, 14.0).round();
            let p = d.lin(3, 0.4, 1.0);
            let both = d.t[2] < 0.5;
            d.points(|y, x| {
                let c = |s: f64| (TAU * 0.5 * k * s / side).sin().abs().powf(p);
                if both { c(x) + c(y) } else { c(x) + 0.2 * (TAU * y / side).cos() }
            })
        }
        "scratched" => {
            let count = d.log(1, 5.0, 40.0).round() as usize;
            let u = d.uniform(3 * count, 8);
            let (deep, wide) = (d.log(2, 1.0, 6.0), d.log(3, 0.8, 4.0));
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let slope = (4.0 * u[3 * i]).floor() - 2.0;
                        let s = d.apart(x + slope * y, u[3 * i + 1] * side)
                            / (1.0 + slope * slope).sqrt();
                        -deep * (1.0 - s.abs() / wide).max(0.0)
                    })
                    .fold(0.0, f64::min)
            });
            mix(&d.rough(7)?, &a, |z, s| z + s)
        }
        "worn lay" => {
            let z = d.field(0.8, d.log(1, 5.0, 10.0), side / 4.0, d.log(2, 2.0, 6.0), 7)?;
            let (level, w) = (d.lin(3, 0.0, 1.5), d.log(0, 0.02, 0.3));
            z.iter().map(|z| softmin(*z, level, w)).collect()
        }
        "honed" => {
            let a = d.field(0.8, 6.0, side / 4.0, 5.0, 7)?;
            let b = d.field(0.8, 6.0, side / 4.0, 5.0, 8)?;
            let level = d.lin(3, 0.0, 1.0);
            let v: Vec<f64> = d.points(|y, x| {
                let (y, x) = (y as usize, x as usize);
                a[y * n + (x + y) % n].min(b[y * n + (x + (n - y)) % n])
            });
            v.iter().map(|z| softmin(*z, level - 0.5, 0.1)).collect()
        }
        "bimodal" => {
            let fine = d.field(0.6, d.log(1, 4.0, 10.0), 30.0, 1.0, 8)?;
            let (s, f0) = (d.log(2, 1.0, 8.0), d.log(3, 0.02, 0.3));
            mix(&d.field(0.8, 16.0, side / 3.0, 1.0, 7)?, &fine, |z, f| (s * z).tanh() + f0 * f)
        }
        "egg boxes" => {
            let k = d.log(1, 1.0, 10.0).round();
            let p = d.lin(3, -0.5, 0.5);
            d.points(|y, x| {
                let c = |s: f64| (TAU * k * s / side + 0.3).cos();
                let e = c(x) + c(y);
                e + p * c(x) * c(y)
            })
        }
        "cones" => {
            let k = d.lin(1, 2.0, 8.0).round();
            let u = d.uniform(200, 8);
            d.points(|y, x| {
                let (cy, cx) = ((y * k / side).floor(), (x * k / side).floor());
                let i = (cy * k + cx) as usize;
                let r = (y * k / side - cy - 0.4 - 0.2 * u[i])
                    .hypot(x * k / side - cx - 0.4 - 0.2 * u[i + 90]);
                (0.4 - r).max(0.0)
            })
        }
        "facets" => {
            let count = d.log(1, 10.0, 60.0).round() as usize;
            let u = d.uniform(5 * count, 8);
            d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let (dy, dx) =
                            (d.apart(y, u[5 * i] * side), d.apart(x, u[5 * i + 1] * side));
                        let g = [u[5 * i + 2] - 0.5, u[5 * i + 3] - 0.5];
                        12.0 * u[5 * i + 4] + g[0] * dy + g[1] * dx - 0.6 * dy.abs().max(dx.abs())
                    })
                    .fold(f64::MIN, f64::max)
            })
        }
        "two scales" => {
            let fine = d.field(0.8, d.log(1, 3.5, 6.0), 20.0, 1.0, 8)?;
            let f0 = d.log(3, 0.05, 0.5);
            mix(&d.field(0.8, 24.0, side / 2.0, 1.0, 7)?, &fine, |z, f| z + f0 * f)
        }
        "debris" => {
            let count = d.log(1, 5.0, 40.0).round() as usize;
            let u = d.uniform(3 * count, 8);
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r = 1.5 + 4.0 * u[3 * i];
                        let s = d
                            .apart(y, u[3 * i + 1] * side)
                            .abs()
                            .max(d.apart(x, u[3 * i + 2] * side).abs());
                        if s < r { 0.7 * r } else { 0.0 }
                    })
                    .fold(0.0, f64::max)
            });
            let low = d.log(2, 0.2, 1.0);
            mix(&d.rough(7)?, &a, |z, p| low * z + p)
        }
        "rounded down" => {
            let z = d.rough(7)?;
            let q = d.log(3, 0.05, 0.5) * gradient(&z, n);
            z.iter().map(|z| (z / q).floor() * q).collect()
        }
        "cut out" => {
            let m = 2 * n;
            let cutoff = d.log(1, 4.0, 12.0);
            let rolloff = side / d.log(2, 0.5, 6.0);
            let whole = d.field_on(m, d.lin(0, 0.4, 0.9), cutoff, rolloff, 1.0, 0)?;
            (0..n * n).map(|i| whole[i / n * m + i % n]).collect()
        }
        _ => return second::heights(family, d),
    })
}
