//! Families that were written down after the rule for patterns of like cells and for what is left of the
//! doubt on the finer grid, and judged by it; the rule for points that are pressed lightly came of one of them.

use crate::third;
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin, triangle};

/// Heights of a map of a family, in any unit.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    let fine = d.field(0.7, 5.0, 24.0, 1.0, 18)?;
    let rough = d.log(0, 0.003, 0.06);
    Ok(match family {
        "coined" => {
            // Pyramids with cut tops of slightly different height.
            let k = d.log(1, 3.0, 8.0).round();
            let (u, flat) = (d.uniform(100, 19), d.lin(3, 0.3, 0.8));
            let a = d.points(|y, x| {
                let (cy, cx) = ((y * k / side).floor(), (x * k / side).floor());
                let c = |s: f64| ((s * k / side).fract() - 0.5).abs();
                (1.0 - 2.0 * c(y).max(c(x))).min(flat + 0.1 * u[(cy * k + cx) as usize])
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "diamonds, worn" => {
            let (k, m) = (d.log(1, 3.0, 9.0).round(), d.lin(2, 1.0, 4.0).round());
            let level = d.lin(3, 0.4, 0.9);
            let a = d.points(|y, x| {
                let u = triangle((k * x + m * y) / side).min(triangle((k * x - m * y) / side));
                softmin(u, level, 0.03)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "etched grains" => {
            let sharp = d.log(3, 2.0, 12.0);
            let coarse = d.field(0.8, d.log(1, 8.0, 20.0), side / 3.0, 1.0, 19)?;
            mix(&coarse, &fine, |z, f| (sharp * z).tanh() + 3.0 * rough * f)
        }
        "laser dots" => {
            let k = d.lin(1, 3.0, 8.0).round();
            let r0 = d.lin(2, 0.2, 0.4);
            let a = d.points(|y, x| {
                let row = (y * k / side).floor();
                let cy = (y * k / side).fract() - 0.5;
                let cx = (x * k / side + 0.5 * (row % 2.0)).fract() - 0.5;
                let s = (cy.hypot(cx) / r0).powi(2);
                (s - 1.0).min(0.0) + 0.3 * (-(s - 1.0).powi(2) / 0.1).exp()
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "printed bars" => {
            let (k, m) = (d.log(1, 3.0, 12.0).round(), d.lin(2, 0.0, 2.0).round());
            let edge = d.log(3, 0.02, 0.15);
            let a = d.points(|y, x| {
                let s = triangle((k * x + m * y) / side) - 0.5;
                (s / edge).tanh()
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "peened" => {
            let count = d.log(1, 15.0, 80.0).round() as usize;
            let u = d.uniform(3 * count, 19);
            d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r = 8.0 + 14.0 * u[3 * i];
                        let r2 = d.apart(y, u[3 * i + 1] * side).powi(2)
                            + d.apart(x, u[3 * i + 2] * side).powi(2);
                        -(r * r - r2).max(0.0) / r
                    })
                    .fold(0.0, f64::min)
            })
        }
        "filled valleys" => {
            let level = d.lin(3, -0.5, 0.5);
            d.rough(19)?.iter().map(|z| z.max(level)).collect()
        }
        "milled arcs" => {
            let (k, far) = (d.log(1, 4.0, 12.0).round(), d.log(2, 0.7, 3.0));
            let a = d.points(|y, x| {
                let r = (x + far * side).hypot(y - 0.4 * side);
                let t = (r * k / side).fract() - 0.5;
                4.0 * t * t
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "woven" => {
            let k = d.log(1, 3.0, 9.0).round();
            let a = d.points(|y, x| {
                let c = |s: f64| (TAU * k * s / side).sin();
                (c(x).abs().sqrt() * c(0.5 * y))
                    .max(c(y).abs().sqrt() * c(0.5 * x + 0.25 * side / k))
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "cracked" => {
            let count = d.log(1, 8.0, 40.0).round() as usize;
            let u = d.uniform(2 * count, 19);
            let wide = d.log(3, 1.0, 4.0);
            let a = d.points(|y, x| {
                let mut near = [f64::INFINITY; 2];
                for i in 0..count {
                    let r = d.apart(y, u[2 * i] * side).hypot(d.apart(x, u[2 * i + 1] * side));
                    if r < near[0] {
                        near = [r, near[0]];
                    } else {
                        near[1] = near[1].min(r);
                    }
                }
                -(1.0 - (near[1] - near[0]) / wide).max(0.0)
            });
            mix(&a, &fine, |a, f| a + 10.0 * rough * f)
        }
        "part of a pattern" => {
            // Waves that do not end with the map.
            let (p, q) = (d.log(1, 9.0, 31.0), d.log(2, 9.0, 31.0));
            let level = d.lin(3, 0.5, 1.8);
            let a = d.points(|y, x| {
                softmin((TAU * x / p).cos() + (TAU * (y + 0.3 * x) / q).cos(), level, 0.05)
            });
            mix(&a, &fine, |a, f| a + 3.0 * rough * f)
        }
        "smooth, fine" => d.field(d.lin(3, 0.3, 0.9), d.log(1, 4.0, 9.0), side / 5.0, 1.0, 19)?,
        _ => return third::heights(family, d),
    })
}
