//! Families of maps on which the constants were fixed.

use studies::maps::{Draw, Heights, gradient, mix, softmin, triangle};

/// Their names.
pub(crate) const TUNING: [&str; 21] = [
    "gaussian",
    "short waves",
    "bent",
    "lay",
    "soft clip",
    "hard clip",
    "worn",
    "plateau-honed",
    "terraces",
    "pillars",
    "pits",
    "turned",
    "creased",
    "patches",
    "spikes",
    "dust",
    "quantised",
    "balls",
    "triangles",
    "tilted",
    "crop",
];

/// Heights of a map of a family, in any unit.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    Ok(match family {
        "gaussian" => d.rough(0)?,
        "short waves" => {
            d.field(d.lin(0, 0.3, 0.9), d.log(1, 2.2, 4.0), side / d.log(2, 2.0, 10.0), 1.0, 0)?
        }
        "bent" => {
            let s = if d.t[3] < 0.5 { -0.6 + 0.8 * d.t[3] } else { 0.2 + 0.8 * (d.t[3] - 0.5) };
            d.rough(0)?.iter().map(|z| (s * z).exp_m1() / s).collect()
        }
        "lay" => d.field(
            d.lin(0, 0.4, 0.95),
            d.log(1, 4.0, 10.0),
            side / d.log(2, 3.0, 10.0),
            d.log(3, 1.5, 8.0),
            0,
        )?,
        "soft clip" => {
            let (level, width) = (d.lin(3, -0.3, 1.5), d.log(0, 0.04, 0.3));
            d.rough(0)?.iter().map(|z| softmin(*z, level, width)).collect()
        }
        "hard clip" => {
            let level = d.lin(3, -0.3, 1.5);
            d.rough(0)?.iter().map(|z| z.min(level)).collect()
        }
        "worn" => {
            let (level, fine) = (d.lin(3, -0.3, 1.2), d.log(0, 0.01, 0.2));
            let small = d.field(0.7, d.log(2, 3.0, 8.0), 24.0, 1.0, 1)?;
            mix(&d.rough(0)?, &small, |z, f| z.min(level) + fine * f)
        }
        "plateau-honed" => {
            let angle = d.lin(0, 0.3, 1.0);
            let (period, depth, width) =
                ((side / d.log(1, 4.0, 12.0)).round(), d.log(2, 0.3, 3.0), d.log(3, 1.5, 6.0));
            let small = d.field(0.6, 4.0, 24.0, 1.0, 1)?;
            let k = (side / period).round();
            let m = (angle * k).round();
            let groove = |phase: f64| {
                let s = (phase.rem_euclid(1.0) - 0.5).abs() * period;
                -(-0.5 * (s / width).powi(2)).exp()
            };
            let deep = d.points(|y, x| {
                depth * (groove((k * x + m * y) / side) + groove((k * x - m * y) / side))
            });
            mix(&deep, &small, |g, f| g + 0.08 * f)
        }
        "terraces" => {
            let (q, edge) = (d.log(3, 0.3, 1.5), d.log(0, 0.05, 0.5));
            d.rough(0)?
                .iter()
                .map(|z| {
                    let s = z / q;
                    let k = s.floor();
                    let r = ((s - k - 0.5) / edge).tanh() / (0.5 / edge).tanh();
                    q * (k + 0.5 + 0.5 * r)
                })
                .collect()
        }
        "pillars" | "pits" => {
            let k = d.lin(1, 3.0, 9.0).round();
            let (radius, edge) = (side / k * d.lin(2, 0.2, 0.4), d.log(3, 0.5, 4.0));
            let u = d.uniform(100, 3);
            let fine = d.field(0.7, 6.0, 40.0, 1.0, 1)?;
            let rough = d.lin(0, 0.0, 0.06);
            let sign = if family == "pits" { -1.0 } else { 1.0 };
            let a = d.points(|y, x| {
                let (cy, cx) = ((y * k / side).floor(), (x * k / side).floor());
                let c = |i: f64| (i + 0.5) * side / k;
                let r = (y - c(cy)).hypot(x - c(cx));
                let tall = 1.0 + 0.1 * u[(cy * k + cx) as usize];
                sign * tall * 0.5 * (1.0 - ((r - radius) / edge).tanh())
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "turned" => {
            let k = d.log(1, 4.0, 16.0).round();
            let rough = d.log(0, 1e-3, 0.15);
            let fine = d.field(0.7, d.log(2, 4.0, 10.0), 40.0, 1.0, 1)?;
            let sharp = d.t[3];
            let a = d.points(|_, x| {
                let t = (x * k / side).rem_euclid(1.0) - 0.5;
                if sharp < 0.5 { 4.0 * t * t } else { -4.0 * t * t }
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "creased" => {
            let (a, b) = (d.rough(0)?, d.rough(1)?);
            if d.t[3] < 0.34 {
                mix(&a, &b, f64::max)
            } else if d.t[3] < 0.67 {
                a.iter().map(|z| -z.abs()).collect()
            } else {
                a.iter().map(|z| z.abs()).collect()
            }
        }
        "patches" => {
            let s = d.field(0.8, side / 5.0, side / 3.0, 1.0, 1)?;
            mix(&d.rough(0)?, &s, |z, s| z * (1.0 + 0.9 * (2.0 * s).tanh()))
        }
        "spikes" => {
            let count = d.log(1, 3.0, 40.0).round() as usize;
            let (tall, wide) = (d.log(2, 2.0, 8.0), d.log(3, 0.4, 2.0));
            let u = d.uniform(2 * count, 5);
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r2 = d.apart(y, (u[2 * i] * side).floor()).powi(2)
                            + d.apart(x, (u[2 * i + 1] * side).floor()).powi(2);
                        tall * (-0.5 * r2 / (wide * wide)).exp()
                    })
                    .sum()
            });
            mix(&d.rough(0)?, &a, |a, b| a + b)
        }
        "dust" => {
            let count = d.log(1, 3.0, 60.0).round() as usize;
            let u = d.uniform(3 * count, 5);
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r = 3.0 + 9.0 * u[3 * i];
                        let r2 = d.apart(y, u[3 * i + 1] * side).powi(2)
                            + d.apart(x, u[3 * i + 2] * side).powi(2);
                        (r * r - r2).max(0.0) / r * 0.5
                    })
                    .fold(0.0, f64::max)
            });
            let low = d.log(2, 0.05, 1.0);
            mix(&d.rough(0)?, &a, |z, p| low * z + p)
        }
        "quantised" => {
            let z = d.rough(0)?;
            let g = gradient(&z, n);
            let q = d.log(3, 0.1, 1.0) * g;
            z.iter().map(|z| (z / q).round() * q).collect()
        }
        "balls" => {
            let k = d.lin(1, 2.0, 8.0).round();
            let (a, u) = (side / k, d.uniform(100, 3));
            let spread = d.lin(2, 0.0, 0.3);
            let low = d.lin(3, -0.4, 0.3);
            d.points(|y, x| {
                let (cy, cx) = ((y / a).floor(), (x / a).floor());
                let r2 = ((y / a - cy - 0.5).powi(2) + (x / a - cx - 0.5).powi(2)) * 4.0;
                (1.0 - r2 + spread * u[(cy * k + cx) as usize]).max(low)
            })
        }
        "triangles" => {
            let k = d.log(1, 3.0, 12.0).round();
            let both = d.t[2];
            let rough = d.log(0, 1e-4, 0.05);
            let fine = d.field(0.7, 6.0, 40.0, 1.0, 1)?;
            let a = d.points(|y, x| {
                let t = triangle(k * x / side);
                if both < 0.5 { t } else { t + triangle(k * y / side) }
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "tilted" => {
            let (gy, gx) = (d.lin(2, -2.0, 2.0), d.lin(3, -2.0, 2.0));
            let a = d.points(|y, x| (gy * y + gx * x) / side);
            mix(&d.rough(0)?, &a, |z, t| z + t)
        }
        "crop" => {
            let m = 2 * n;
            let cutoff = d.log(1, 4.0, 12.0);
            let whole =
                d.field_on(m, d.lin(0, 0.4, 0.9), cutoff, side / d.log(2, 0.5, 6.0), 1.0, 0)?;
            (0..n * n).map(|i| whole[i / n * m + i % n]).collect()
        }
        _ => return Err(format!("no family {family}").into()),
    })
}
