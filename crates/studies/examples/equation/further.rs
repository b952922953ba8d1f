//! Eight further families that took no part in any law before.

use crate::fields::{fine, other, rough};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin};

/// Hammered: round dents side by side, the crests between them sharp, with the hammer's own roughness.
pub(crate) fn hammered(d: &Draw) -> Heights {
    let count = 40 + (100.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 51));
    let size = 1.1 * n / (count as f64).sqrt();
    let dents = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / size;
            r * r + 0.3 * u[2]
        };
        u.chunks_exact(3).map(one).fold(f64::INFINITY, f64::min)
    });
    let on_top = 0.01 + 0.06 * other(d, 9.3);
    Ok(mix(&dents, &fine(d, 1)?, |z, f| z + on_top * f))
}

/// Folded both ways: creases that stand up and creases that lie low.
pub(crate) fn folded(d: &Draw) -> Heights {
    let (a, b) = (rough(d, 1.0, 0)?, rough(d, 1.0, 1)?);
    let sharp = 0.1 + 0.2 * other(d, 9.3);
    let share = d.lin(3, 0.2, 1.0);
    Ok(mix(&a, &b, |a, b| a.hypot(sharp) - share * b.hypot(sharp)))
}

/// Bricks: oblong tiles in rows, each at a level and a tilt of its own, a groove around each.
pub(crate) fn bricks(d: &Draw) -> Heights {
    let (n, rows) = (d.n as f64, 4 + (8.0 * d.t[3]) as usize);
    let columns = rows.div_ceil(2);
    let u = d.uniform(2 * rows * columns, 53);
    let deep = 0.5 + 2.0 * other(d, 9.3);
    let tiles = d.points(|y, x| {
        let row = ((y / n * rows as f64) as usize).min(rows - 1);
        let across = y / n * rows as f64 - row as f64 - 0.5;
        let at = (x / n * columns as f64 + 0.5 * (row % 2) as f64).rem_euclid(columns as f64);
        let column = (at as usize).min(columns - 1);
        let along = at - column as f64 - 0.5;
        let tile = 2 * (row * columns + column);
        let edge = (0.5 - across.abs()) * n / rows as f64;
        let end = (0.5 - along.abs()) * n / columns as f64;
        let groove = (-(edge.min(end) / 3.0).powi(2)).exp();
        0.5 * u[tile] + (u[tile + 1] - 0.5) * along - deep * groove
    });
    Ok(mix(&tiles, &rough(d, 1.0, 0)?, |t, z| 2.0 * t + 0.3 * z))
}

/// Ploughed: short furrows in all directions, what was in them heaped along their sides.
pub(crate) fn ploughed(d: &Draw) -> Heights {
    let count = 10 + (60.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(5 * count, 57));
    let rim = 1.0 + 2.0 * other(d, 9.3);
    let furrows = d.points(|y, x| {
        let one = |u: &[f64]| {
            let (sin, cos) = (TAU * u[2]).sin_cos();
            let (dy, dx) = (d.apart(y, u[0] * n), d.apart(x, u[1] * n));
            let along = (dx * cos + dy * sin) / (20.0 + 80.0 * u[3]);
            let across = (dy * cos - dx * sin) / (4.0 + 4.0 * u[4]);
            (rim * across * across - 1.5) * (-across * across - along.powi(4)).exp()
        };
        u.chunks_exact(5).map(one).sum()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &furrows, |z, f| 0.5 * z + f))
}

/// Blistered: wide low domes under a smooth skin.
pub(crate) fn blistered(d: &Draw) -> Heights {
    let count = 4 + (16.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 59));
    let domes = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (n * (0.03 + 0.07 * u[2]));
            (1.0 - r * r).max(0.0).powi(2) * (0.5 + u[2])
        };
        u.chunks_exact(3).map(one).fold(0.0, f64::max)
    });
    let skin = 0.02 + 0.1 * other(d, 9.3);
    Ok(mix(&domes, &fine(d, 1)?, |z, f| z + skin * f))
}

/// Stripes along the travel of a tool, each of a height and a roughness of its own.
pub(crate) fn striped(d: &Draw) -> Heights {
    let stripes = 4 + (14.0 * d.t[3]) as usize;
    let (u, n) = (d.uniform(2 * stripes, 61), d.n);
    let step = 1.5 * other(d, 9.3);
    let ground = rough(d, 3.0, 0)?;
    let value = |k: usize, i: usize| u[2 * (i % stripes) + k];
    let at = |i: usize| {
        let x = (i % n) as f64 / n as f64 * stripes as f64;
        let (one, next) = (x as usize, x as usize + 1);
        let t = 0.5 + 0.5 * (8.0 * (x.fract() - 0.5)).tanh();
        let of = |k: usize| value(k, one) * (1.0 - t) + value(k, next) * t;
        step * of(0) + (0.2 + of(1)) * ground[i]
    };
    Ok((0..n * n).map(at).collect())
}

/// Torn along a lay: many low ridges, few high ones.
pub(crate) fn pulled(d: &Draw) -> Heights {
    let (stretch, uneven) = (2.0 + 4.0 * other(d, 9.3), d.lin(3, 0.4, 1.0));
    let (lay, small) = (rough(d, stretch, 0)?, fine(d, 1)?);
    Ok(mix(&lay, &small, |z, f| (uneven * z).exp() + 0.05 * f))
}

/// Facets of crystals: of planes in all directions the highest, edges between them, a fine roughness.
pub(crate) fn faceted(d: &Draw) -> Heights {
    let count = 30 + (90.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(5 * count, 67));
    let size = n / (count as f64).sqrt();
    let facets = d.points(|y, x| {
        let one = |u: &[f64]| {
            let (dy, dx) = (d.apart(y, u[0] * n) / size, d.apart(x, u[1] * n) / size);
            // A pyramid of four sides, turned.
            let (sin, cos) = (TAU * u[2]).sin_cos();
            let (a, b) = (dx * cos + dy * sin, dy * cos - dx * sin);
            0.5 * u[3] - a.abs().max((0.5 + u[4]) * b.abs())
        };
        u.chunks_exact(5).map(one).fold(-10.0, f64::max)
    });
    let level = 0.1 + 0.6 * other(d, 9.3);
    Ok(mix(&facets, &fine(d, 1)?, |z, f| softmin(z, level, 0.05) + 0.02 * f))
}
