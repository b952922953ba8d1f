//! Families that the law for a map has never seen, of the kinds one would rather not be asked.

use crate::fields::{fine, other, rough};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin, triangle};

/// Flat dots in rows on a rough ground, each with a raised rim, as a laser melts them.
pub(crate) fn laser_dots(d: &Draw) -> Heights {
    let (n, rows) = (d.n as f64, (4.0 + 8.0 * d.t[3]).round());
    let (pitch, rim) = (n / rows, 0.2 + 0.8 * other(d, 5.7));
    let dots = d.points(|y, x| {
        let apart = |c: f64| (c / pitch - (c / pitch).round()) * pitch;
        let r = apart(y).hypot(apart(x)) / (0.3 * pitch);
        1.0 / (1.0 + ((r - 1.0) * 12.0).exp()) + rim * (-((r - 1.0) / 0.15).powi(2)).exp()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &dots, |z, p| 0.25 * z + p))
}

/// Smooth swells with narrow furrows between them, a fine skin on top.
pub(crate) fn orange_peel(d: &Draw) -> Heights {
    let n = d.n as f64;
    let swell = d.field(0.9, n / 24.0, n / 8.0, 1.0, 0)?;
    let on_top = d.lin(3, 0.005, 0.08);
    Ok(mix(&swell, &fine(d, 1)?, |z, f| -(-1.2 * z).exp().ln_1p() + on_top * f))
}

/// Overlapping round dents, the rims between them ground to a level along a lay.
pub(crate) fn peened_ground(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, 60);
    let (u, level) = (d.uniform(3 * count, 11), 0.3 + 0.5 * d.t[3]);
    let dents = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (n * (0.08 + 0.06 * u[2]));
            r * r - 1.0
        };
        u.chunks_exact(3).map(one).fold(0.0, f64::min) + 1.0
    });
    let grain = d.field(0.7, 8.0, 40.0, 4.0, 1)?;
    let on_top = 0.01 + 0.05 * other(d, 5.7);
    Ok(mix(&dents, &grain, |z, g| softmin(z, level, 0.03) + on_top * g))
}

/// Grooves at even distances in a rough ground, a sharp burr along both edges.
pub(crate) fn burred(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, (3.0 + 9.0 * d.t[3]).round());
    let (pitch, burr) = (n / count, 0.5 + 2.5 * other(d, 5.7));
    let grooves = d.points(|_, x| {
        let at = (x / pitch - (x / pitch).round()).abs() * pitch;
        let edge = (at - 0.15 * pitch) / 4.0;
        burr * (-edge * edge).exp() - 3.0 / (1.0 + (2.0 * edge).exp())
    });
    Ok(mix(&rough(d, 1.0, 0)?, &grooves, |z, g| 0.5 * z + g))
}

/// Threads along both axes that pass over and under each other.
pub(crate) fn woven(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, 2.0 * (3.0 + 4.0 * d.t[3]).round());
    let threads = d.points(|y, x| {
        let (a, b) = (0.5 * count * TAU * x / n, 0.5 * count * TAU * y / n);
        let over = |across: f64, along: f64| {
            across.cos().abs() + 0.5 * (3.0 * across.cos()).tanh() * along.cos()
        };
        over(a, b).max(over(b, a + 0.5 * TAU))
    });
    let on_top = 0.01 + 0.1 * other(d, 5.7);
    Ok(mix(&threads, &fine(d, 1)?, |z, f| z + on_top * f))
}

/// A bed of balls worn flat, the wear's own roughness on the flats.
pub(crate) fn sintered_worn(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, 90);
    let (u, level) = (d.uniform(3 * count, 13), 0.5 + 0.4 * d.t[3]);
    let bed = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (0.09 * n);
            (1.0 - r * r).max(0.0).sqrt() + 0.2 * u[2]
        };
        u.chunks_exact(3).map(one).fold(0.0, f64::max)
    });
    let on_top = 0.005 + 0.05 * other(d, 5.7);
    Ok(mix(&bed, &fine(d, 1)?, |z, f| softmin(z, level, 0.04) + on_top * f))
}

/// Narrow deep cracks that close on themselves in a rough ground.
pub(crate) fn cracked(d: &Draw) -> Heights {
    let n = d.n as f64;
    let net = d.field(0.9, n / 16.0, n / 5.0, 1.0, 1)?;
    let (width, depth) = (0.05 + 0.1 * other(d, 5.7), d.lin(3, 1.0, 6.0));
    Ok(mix(&rough(d, 1.0, 0)?, &net, |z, f| 0.5 * z - depth * (-(f / width).powi(2)).exp()))
}

/// One straight scratch with raised edges across a rough ground.
pub(crate) fn one_scratch(d: &Draw) -> Heights {
    let (n, wide) = (d.n as f64, d.lin(3, 6.0, 20.0));
    let rim = 1.0 + 3.0 * other(d, 5.7);
    let mark = d.points(|_, x| {
        let r = d.apart(x, 0.5 * n) / wide;
        (rim * r * r - 4.0) * (-r * r).exp()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &mark, |z, m| z + m))
}

/// A few smooth caps that stand out of a rough ground, with ripples of one length over all.
pub(crate) fn caps(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, 4 + (20.0 * d.t[3]) as usize);
    let u = d.uniform(4 * count, 17);
    let caps = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (0.03 * n * (1.0 + u[2]));
            (2.0 + 4.0 * u[3]) * (1.0 - r * r)
        };
        let ripple = 0.1 * triangle(12.0 * y / n);
        u.chunks_exact(4).map(one).fold(0.0, f64::max) + ripple
    });
    Ok(mix(&rough(d, 1.0, 0)?, &caps, |z, c| 0.5 * z + c))
}
