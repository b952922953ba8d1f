//! Families that were written down before the rule for points that are pressed lightly was tried on
//! anything but the others, and judged by it; the rules for few spots and for sharp crests came of them.

use studies::maps::{Draw, Heights, mix, triangle};

/// Heights of a map of a family, in any unit.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    let fine = d.field(0.7, 5.0, 24.0, 1.0, 28)?;
    let rough = d.log(0, 0.003, 0.06);
    Ok(match family {
        "sealed pores" => {
            // Deep pores, filled up to a level that is itself a little rough.
            let (s, level) = (d.lin(1, 0.3, 0.7), d.lin(3, -1.5, 0.0));
            mix(&d.rough(29)?, &fine, |z, f| (-(-s * z).exp() / s).max(level + rough * f))
        }
        "puddles" => {
            let long = d.field(1.0, side / 4.0, side, 1.0, 29)?;
            let level = d.lin(3, -1.0, 0.5);
            mix(&d.rough(30)?, &long, |z, w| z.max(level + 0.2 * w))
        }
        "ridges on a flat" => {
            let count = d.log(1, 2.0, 12.0).round() as usize;
            let (u, wide) = (d.uniform(count, 29), d.log(3, 3.0, 16.0));
            let a = d.points(|_, x| {
                let ridge = |at: &f64| (1.0 - d.apart(x, at * side) / wide).max(0.0);
                u.iter().map(ridge).fold(0.0, f64::max)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "grit on a flat" => {
            let count = d.log(1, 6.0, 60.0).round() as usize;
            let u = d.uniform(3 * count, 29);
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r = 3.0 + 7.0 * u[3 * i];
                        let r2 = d.apart(y, u[3 * i + 1] * side).powi(2)
                            + d.apart(x, u[3 * i + 2] * side).powi(2);
                        (r * r - r2).max(0.0) / r
                    })
                    .fold(0.0, f64::max)
            });
            mix(&a, &fine, |a, f| a + 3.0 * rough * f)
        }
        "cut at both ends" => {
            let (low, high) = (d.lin(1, -1.5, -0.2), d.lin(3, 0.3, 1.8));
            d.rough(29)?.iter().map(|z| z.clamp(low, high)).collect()
        }
        "etched channels" => {
            let coarse = d.field(0.8, d.log(1, 10.0, 24.0), side / 3.0, 1.0, 29)?;
            let depth = d.log(3, 0.2, 2.0);
            mix(&coarse, &d.rough(30)?, |c, z| if c > -0.3 { 0.3 * z } else { -depth })
        }
        "wiped coating" => {
            let (level, left) = (d.lin(3, -0.5, 0.8), d.log(1, 0.05, 0.5));
            let wiped = |z: &f64| if *z > level { *z } else { level + left * (z - level) };
            d.rough(29)?.iter().map(wiped).collect()
        }
        "tiles" => {
            let k = d.log(1, 3.0, 8.0).round();
            let u = d.uniform(300, 29);
            let a = d.points(|y, x| {
                let (cy, cx) = ((y * k / side).floor(), (x * k / side).floor());
                let i = 3 * (cy * k + cx) as usize;
                let part = |s: f64| (s * k / side).fract() - 0.5;
                u[i] + (u[i + 1] - 0.5) * part(y) + (u[i + 2] - 0.5) * part(x)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "cusp ridges" => {
            let power = d.lin(3, 0.5, 1.0);
            let a: Vec<f64> = d.rough(29)?.iter().map(|z| -z.abs().powf(power)).collect();
            let groove = d.points(|_, x| triangle(4.0 * x / side));
            mix(&a, &groove, |a, g| a + 0.2 * g)
        }
        "smooth, long" => d.field(d.lin(3, 0.3, 1.0), d.log(1, 8.0, 16.0), side / 4.0, 1.0, 29)?,
        _ => return Err(format!("no family {family}").into()),
    })
}
