//! Families of kinds that people bring, none of them among those the laws were fitted on or judged by before.

use crate::fields::{fine, other, rough};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin};

/// Eroded by sparks: shallow dishes one upon the other, the last one whole, each with a low rim of melt.
pub(crate) fn eroded(d: &Draw) -> Heights {
    let count = 150;
    let (n, u, rim) = (d.n as f64, d.uniform(4 * count, 19), 0.1 + 0.4 * other(d, 5.7));
    let size = d.lin(3, 0.04, 0.08) * n;
    let dishes = d.points(|y, x| {
        let mut height = 0.0;
        for u in u.chunks_exact(4) {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (size * (0.6 + 0.8 * u[2]));
            if r < 1.6 {
                // The dish takes away what was there before.
                let left = 1.0 / (1.0 + (-16.0 * (r - 1.0)).exp());
                let melt = rim * (-((r - 1.0) / 0.2).powi(2)).exp();
                height = left * height + (1.0 - left) * (r * r - 1.0 + u[3] - 0.5) + melt;
            }
        }
        height
    });
    Ok(mix(&dishes, &fine(d, 1)?, |z, f| z + 0.04 * f))
}

/// Blasted, then rolled: dents to one side, the hills pressed to a level that bears the roll's own lines.
pub(crate) fn blasted_rolled(d: &Draw) -> Heights {
    let n = d.n as f64;
    let dents = d.field(0.8, n / 48.0, n / 12.0, 1.0, 0)?;
    let lines = d.field(0.6, 8.0, 48.0, 8.0, 1)?;
    let (level, share) = (d.lin(3, -0.6, 0.8), 0.02 + 0.08 * other(d, 5.7));
    Ok(mix(&dents, &lines, |z, l| softmin(z, level, 0.25) + share * l))
}

/// Brushed: a long lay, and a few single lines much deeper than the rest.
pub(crate) fn hairline(d: &Draw) -> Heights {
    let count = 2 + (8.0 * d.t[3]) as usize;
    let (n, u, depth) = (d.n as f64, d.uniform(3 * count, 23), 2.0 + 6.0 * other(d, 5.7));
    let lines = d.points(|_, x| {
        let one = |u: &[f64]| {
            let r = d.apart(x, u[0] * n) / (6.0 + 6.0 * u[1]);
            -depth * (0.5 + u[2]) * (-r * r).exp()
        };
        u.chunks_exact(3).map(one).sum()
    });
    Ok(mix(&rough(d, 4.0 + 4.0 * other(d, 5.7), 0)?, &lines, |z, l| z + l))
}

/// The grain of wood: rings cut along the trunk, early wood softer and lower, with open pores along the grain.
pub(crate) fn wood(d: &Draw) -> Heights {
    let n = d.n as f64;
    let bend = d.field(0.9, n / 6.0, n / 2.0, 4.0, 0)?;
    let fibres = d.field(0.5, 8.0, 40.0, 8.0, 1)?;
    let rings = 4.0 + (8.0 * d.t[3]).round();
    let (pores, steep) = (0.5 + 2.0 * other(d, 5.7), 1.5);
    let at = |i: usize| {
        let x = (i % d.n) as f64;
        let ring = (steep * (TAU * (rings * x / n + 0.4 * bend[i])).sin()).tanh();
        ring + 0.3 * fibres[i] - pores * (fibres[i] - 1.2).max(0.0)
    };
    Ok((0..d.n * d.n).map(at).collect())
}

/// Printed in layers: round beads side by side, each as high as it came out, with drops stuck to them.
pub(crate) fn layered(d: &Draw) -> Heights {
    let n = d.n as f64;
    let layers = 4 + (12.0 * d.t[3]) as usize;
    let (heights, drops) = (d.uniform(layers, 29), 12 + (30.0 * other(d, 5.7)) as usize);
    let u = d.uniform(3 * drops, 31);
    let pitch = n / layers as f64;
    let beads = d.points(|y, x| {
        let layer = ((y / pitch) as usize).min(layers - 1);
        let across = (y / pitch).fract() - 0.5;
        let bead = (1.0 - 3.6 * across * across).sqrt() * (1.0 + 0.3 * heights[layer]);
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (0.02 * n * (0.5 + u[2]));
            0.5 * (1.0 - r * r)
        };
        bead + u.chunks_exact(3).map(one).fold(0.0, f64::max)
    });
    Ok(mix(&beads, &fine(d, 1)?, |z, f| z + 0.05 * f))
}

/// Fretted: in a worn ground a scar that is rougher, deeper within and heaped with debris at its edge.
pub(crate) fn fretted(d: &Draw) -> Heights {
    let (n, deep) = (d.n as f64, 0.5 + 2.5 * other(d, 5.7));
    let (wide, level) = (d.lin(3, 0.15, 0.35) * n, 0.3);
    let (ground, debris) = (rough(d, 1.0, 0)?, fine(d, 1)?);
    let at = |i: usize| {
        let (y, x) = ((i / d.n) as f64, (i % d.n) as f64);
        let r = d.apart(y, 0.5 * n).hypot(0.7 * d.apart(x, 0.5 * n)) / wide;
        let inside = 1.0 / (1.0 + (12.0 * (r - 1.0)).exp());
        let edge = (-((r - 1.0) / 0.15).powi(2)).exp();
        (1.0 - inside) * softmin(ground[i], level, 0.15)
            + inside * (debris[i] - deep)
            + edge * (1.0 + 0.5 * debris[i])
    };
    Ok((0..d.n * d.n).map(at).collect())
}

/// Etched: grains with straight boundaries, each at a level of its own, a groove between them.
pub(crate) fn etched(d: &Draw) -> Heights {
    let count = 20 + (60.0 * d.t[3]) as usize;
    let (n, u, groove) = (d.n as f64, d.uniform(3 * count, 37), 1.5 * other(d, 5.7));
    let grains = d.points(|y, x| {
        // The nearest two: where they are as near as each other runs the boundary.
        let (mut first, mut second) = ((f64::INFINITY, 0.0), (f64::INFINITY, 0.0));
        for u in u.chunks_exact(3) {
            let here = (d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)), u[2]);
            if here.0 < first.0 {
                (first, second) = (here, first);
            } else if here.0 < second.0 {
                second = here;
            }
        }
        let away = (second.0 - first.0) / 8.0;
        let share = 0.5 * (1.0 + away.tanh());
        share * first.1 + (1.0 - share) * second.1 - groove * (-away * away).exp()
    });
    Ok(mix(&grains, &rough(d, 1.0, 0)?, |z, f| 2.0 * z + 0.3 * f))
}

/// Islands of oxide, rough and of one thickness, on a smoother ground.
pub(crate) fn scaled_islands(d: &Draw) -> Heights {
    let n = d.n as f64;
    let place = d.field(0.9, n / 20.0, n / 6.0, 1.0, 1)?;
    let (above, thick) = (d.lin(3, -0.5, 1.0), 0.5 + 2.5 * other(d, 5.7));
    let share = |s: f64| 1.0 / (1.0 + (-10.0 * (s - above)).exp());
    Ok(mix(&rough(d, 1.0, 0)?, &place, |z, s| {
        let island = share(s);
        (0.2 + 0.6 * island) * z + thick * island
    }))
}

/// The round of a ball left in the map, under its roughness.
pub(crate) fn formed(d: &Draw) -> Heights {
    let (n, height) = (d.n as f64, d.log(3, 2.0, 12.0));
    let cap = d.points(|y, x| {
        let r = d.apart(y, 0.5 * n).hypot(d.apart(x, 0.5 * n)) / (0.5 * n);
        // Level at the sides, so that it repeats.
        if r < 1.0 { (1.0 - r * r).powi(2) } else { 0.0 }
    });
    Ok(mix(&rough(d, 1.0, 0)?, &cap, |z, c| z + height * c))
}

/// Heights in a few steps only, several times larger than what neighbours differ by; bent as by a pressed film.
pub(crate) fn quantised(d: &Draw) -> Heights {
    let bend = 0.6 * (2.0 * other(d, 5.7) - 1.0);
    let z: Vec<f64> = rough(d, 1.0, 0)?.iter().map(|z| (z.asinh() + bend).sinh()).collect();
    let step = d.log(3, 1.5, 4.0) * studies::maps::gradient(&z, d.n);
    Ok(z.iter().map(|z| (z / step).round() * step).collect())
}
