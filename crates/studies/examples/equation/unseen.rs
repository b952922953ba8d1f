//! Five further families that take no part in the law: it is asked once what it says of them.

use crate::fields::{fine, other, rough};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, triangle};

/// A weld: bowed ripples one after the other, rough in themselves.
pub(crate) fn rippled(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, (5.0 + 20.0 * d.t[3]).round());
    let bow = 0.5 + 2.0 * other(d, 9.3);
    let ripples = d.points(|y, x| {
        let across = triangle(x / n);
        (1.0 - triangle(count * y / n + bow * across * across)).powf(1.5)
    });
    Ok(mix(&ripples, &rough(d, 1.0, 0)?, |r, z| 2.0 * r + 0.3 * z))
}

/// Sprayed: drops that spread flat one on the other, each with a rim.
pub(crate) fn sprayed(d: &Draw) -> Heights {
    let count = 60 + (200.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 61));
    let rim = 0.2 + 0.6 * other(d, 9.3);
    let drops = d.points(|y, x| {
        let mut height = 0.0;
        for u in u.chunks_exact(3) {
            let size = n / 24.0 * (1.0 + 2.0 * u[2]);
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / size;
            height += (1.0 + rim * r.powi(4)) / (1.0 + r.powi(16));
        }
        height
    });
    Ok(mix(&drops, &fine(d, 1)?, |z, f| z + 0.08 * f))
}

/// Sanded by an orbital machine: arcs of circles cut across each other.
pub(crate) fn sanded(d: &Draw) -> Heights {
    let count = 20 + (60.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(4 * count, 63));
    let deep = 0.5 + 1.5 * other(d, 9.3);
    let arcs = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n));
            let off = (r - n * (0.05 + 0.3 * u[2])) / (3.0 + 4.0 * u[3]);
            (-off * off).exp()
        };
        u.chunks_exact(4).map(one).sum::<f64>()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &arcs, |z, a| 0.4 * z - deep * a))
}

/// Etched grains: each a face at a height and a tilt of its own, terraced along it.
pub(crate) fn grained(d: &Draw) -> Heights {
    let count = 20 + (80.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(5 * count, 67));
    let size = n / (count as f64).sqrt();
    let terrace = 0.1 + 0.4 * other(d, 9.3);
    let grains = d.points(|y, x| {
        let mut nearest = (f64::INFINITY, 0.0);
        for u in u.chunks_exact(5) {
            let (dy, dx) = (d.apart(y, u[0] * n), d.apart(x, u[1] * n));
            let (sin, cos) = (TAU * u[2]).sin_cos();
            let far = dy.hypot(dx);
            if far < nearest.0 {
                let along = (dx * cos + dy * sin) / size;
                nearest = (far, u[3] + 0.6 * u[4] * along + terrace * triangle(3.0 * along));
            }
        }
        nearest.1
    });
    Ok(mix(&grains, &fine(d, 1)?, |g, f| g + 0.03 * f))
}

/// A grid of grooves cut both ways by a laser, with a bead of melt along each.
pub(crate) fn gridded(d: &Draw) -> Heights {
    let (n, lines) = (d.n as f64, (3.0 + 9.0 * d.t[3]).round());
    let bead = 0.3 + 0.7 * other(d, 9.3);
    let groove = |at: f64| {
        let off = 0.5 * (1.0 - triangle(lines * at / n)) * n / lines / 5.0;
        (bead * off * off - 1.0) * 2.0 * (-off * off).exp()
    };
    let cut = d.points(|y, x| groove(y) + groove(x));
    Ok(mix(&rough(d, 1.0, 0)?, &cut, |z, c| 0.5 * z + c))
}
