//! Families of kinds that one meets and that took no part in any law before: written down with the constants that they are
//! to judge.

use crate::fields::{fine, other, rough};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin};

/// Square posts in rows, as of a stamp, with walls of a few points and a rough skin on tops and ground.
pub(crate) fn posts(d: &Draw) -> Heights {
    let (n, rows) = (d.n as f64, (3.0 + 9.0 * d.t[3]).round());
    let (pitch, half) = (n / rows, 0.15 + 0.25 * other(d, 7.9));
    let posts = d.points(|y, x| {
        let inside = |c: f64| {
            let away = ((c / pitch).fract() - 0.5).abs() - half;
            1.0 / (1.0 + (away * pitch / 1.5).exp())
        };
        inside(y) * inside(x)
    });
    Ok(mix(&posts, &rough(d, 1.0, 0)?, |p, z| 3.0 * p + 0.5 * z))
}

/// Plated: nodules of many sizes grown into each other, each a dome.
pub(crate) fn nodules(d: &Draw) -> Heights {
    let count = 80 + (200.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 41));
    let size = n / (count as f64).sqrt();
    let domes = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = size * (0.3 + 1.2 * u[2] * u[2]);
            let away = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / r;
            r * (1.0 - away * away)
        };
        u.chunks_exact(3).map(one).fold(0.0, f64::max)
    });
    Ok(mix(&domes, &fine(d, 1)?, |z, f| z + 0.03 * size * f))
}

/// Corroded: pits within pits, the more and the deeper where it has begun.
pub(crate) fn corroded(d: &Draw) -> Heights {
    let n = d.n as f64;
    let begun = d.field(0.9, n / 12.0, n / 4.0, 1.0, 1)?;
    let depth = d.lin(3, 0.5, 2.0);
    let ground = rough(d, 1.0, 0)?;
    let eaten = d.field(0.4, 8.0, n / 16.0, 1.0, 2)?;
    let at = |i: usize| {
        let share = 1.0 / (1.0 + (-6.0 * begun[i]).exp());
        0.3 * ground[i] - depth * share * (1.2 * eaten[i]).exp()
    };
    Ok((0..d.n * d.n).map(at).collect())
}

/// Walls between cells, rounded at their tops, the cells' floors smoother and lower.
pub(crate) fn honeycomb(d: &Draw) -> Heights {
    let count = 15 + (45.0 * d.t[3]) as usize;
    let (n, u, wide) = (d.n as f64, d.uniform(2 * count, 43), 4.0 + 8.0 * other(d, 7.9));
    let walls = d.points(|y, x| {
        let (mut first, mut second) = (f64::INFINITY, f64::INFINITY);
        for u in u.chunks_exact(2) {
            let away = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n));
            (first, second) = (first.min(away), second.min(away.max(first)));
        }
        (-((second - first) / wide).powi(2)).exp()
    });
    Ok(mix(&walls, &rough(d, 1.0, 0)?, |w, z| 2.0 * w + (0.1 + 0.2 * w) * z))
}

/// Polished, with hard grains that stand out of the matrix, each flat, the matrix smoother than they.
pub(crate) fn inclusions(d: &Draw) -> Heights {
    let n = d.n as f64;
    let place = d.field(0.9, n / 32.0, n / 10.0, 1.0, 1)?;
    let (above, relief) = (d.lin(3, 0.3, 1.5), 0.3 + 2.0 * other(d, 7.9));
    let hard = |s: f64| 1.0 / (1.0 + (-14.0 * (s - above)).exp());
    Ok(mix(&rough(d, 1.0, 0)?, &place, |z, s| relief * hard(s) + (0.08 + 0.1 * hard(s)) * z))
}

/// Teeth with one steep and one long side, the long side rough.
pub(crate) fn saw_toothed(d: &Draw) -> Heights {
    let (n, teeth) = (d.n as f64, (4.0 + 12.0 * d.t[3]).round());
    let steep = 0.08 + 0.2 * other(d, 7.9);
    let sides = d.points(|y, x| {
        let at = (teeth * x / n + 0.05 * (TAU * y / n).sin()).rem_euclid(1.0);
        softmin(at / (1.0 - steep), (1.0 - at) / steep, 0.08)
    });
    Ok(mix(&sides, &rough(d, 2.0, 0)?, |s, z| 1.5 * s + 0.15 * z))
}

/// A lay with the waves of a tool that chattered across it.
pub(crate) fn chattered(d: &Draw) -> Heights {
    let (n, marks) = (d.n as f64, (6.0 + 14.0 * d.t[3]).round());
    let depth = 0.5 + 2.0 * other(d, 7.9);
    let wander = d.field(0.9, n / 6.0, n / 2.0, 1.0, 1)?;
    let lay = rough(d, 4.0, 0)?;
    let at = |i: usize| {
        let y = (i / d.n) as f64;
        let beat = 0.5 + 0.5 * (2.0 * TAU * y / n).cos();
        0.5 * lay[i] + depth * beat * (TAU * marks * y / n + 0.5 * wander[i]).cos()
    };
    Ok((0..d.n * d.n).map(at).collect())
}

/// A rough ground with single narrow peaks, as of dust or of what the optics saw there.
pub(crate) fn spiky(d: &Draw) -> Heights {
    let count = 3 + (60.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(4 * count, 47));
    let peaks = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (3.0 + 4.0 * u[2]);
            (1.0 + 4.0 * u[3] * u[3]) * (-r * r).exp()
        };
        u.chunks_exact(4).map(one).sum()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &peaks, |z, p| z + 1.5 * p))
}

/// Cast: the skin of the mould, sand by sand, sunk in between.
pub(crate) fn cast(d: &Draw) -> Heights {
    let n = d.n as f64;
    let sand = d.field(0.6, n / 48.0, n / 16.0, 1.0, 0)?;
    let sunk = d.field(0.8, n / 16.0, n / 4.0, 1.0, 1)?;
    let (share, on_top) = (d.lin(3, 0.3, 1.2), 0.02 + 0.08 * other(d, 7.9));
    let f = fine(d, 2)?;
    let at = |i: usize| softmin(sand[i].abs(), 1.2, 0.1) + share * sunk[i] + on_top * f[i];
    Ok((0..d.n * d.n).map(at).collect())
}

/// Roughness whose strength varies from place to place at every scale.
pub(crate) fn cascaded(d: &Draw) -> Heights {
    let n = d.n as f64;
    let wide = d.field(0.9, n / 8.0, n / 3.0, 1.0, 1)?;
    let narrow = d.field(0.9, n / 32.0, n / 10.0, 1.0, 2)?;
    let uneven = d.lin(3, 0.2, 0.7);
    let ground = rough(d, 1.0, 0)?;
    let at = |i: usize| (uneven * (wide[i] + narrow[i])).clamp(-2.5, 1.5).exp() * ground[i];
    Ok((0..d.n * d.n).map(at).collect())
}
