//! Families that were written down before the rules for few spots and for sharp crests were tried on
//! anything but the others, and solved once.

use studies::maps::{Draw, Heights, mix, softmin, triangle};

/// Their names.
pub(crate) const FRESH: [&str; 10] = [
    "few worn hills",
    "blisters",
    "sharp blades",
    "chamfered steps",
    "cracked coating",
    "dendrites",
    "run in",
    "sanded across",
    "sparse summits",
    "smooth, bent",
];

/// Heights of a map of a family, in any unit.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    let fine = d.field(0.7, 5.0, 24.0, 1.0, 38)?;
    let rough = d.log(0, 0.003, 0.06);
    Ok(match family {
        "few worn hills" => {
            let hills = d.field(1.0, side / 6.0, side / 2.0, 1.0, 39)?;
            let level = d.lin(3, 0.4, 1.5);
            mix(&hills, &fine, |z, f| softmin(z, level, 0.05) + rough * f)
        }
        "blisters" => {
            // Caps that meet the ground at an angle.
            let count = d.log(1, 4.0, 30.0).round() as usize;
            let u = d.uniform(3 * count, 39);
            let a = d.points(|y, x| {
                (0..count)
                    .map(|i| {
                        let r = 4.0 + 10.0 * u[3 * i];
                        let far =
                            d.apart(y, u[3 * i + 1] * side).hypot(d.apart(x, u[3 * i + 2] * side));
                        (1.0 - (far / r).powi(2)).max(0.0)
                    })
                    .sum()
            });
            mix(&a, &d.rough(40)?, |a, z| a + 0.1 * z)
        }
        "sharp blades" => {
            let (k, power) = (d.log(1, 2.0, 9.0).round(), d.lin(3, 0.4, 0.9));
            let a = d.points(|_, x| -(2.0 * triangle(k * x / side) - 1.0).abs().powf(power));
            mix(&a, &fine, |a, f| a + 2.0 * rough * f)
        }
        "chamfered steps" => {
            let (k, wide) = (d.log(1, 2.0, 7.0).round(), d.log(3, 0.05, 0.3));
            let a = d.points(|y, x| {
                let ramp = |s: f64| ((s * k / side).fract() / wide).min(1.0);
                ramp(x) + 0.5 * ramp(y + 0.2 * x)
            });
            mix(&a, &fine, |a, f| a + rough * f)
        }
        "cracked coating" => {
            // Plates, each at a level of its own, between cracks of a pixel or two.
            let count = d.log(1, 6.0, 25.0).round() as usize;
            let u = d.uniform(3 * count, 39);
            let a = d.points(|y, x| {
                let mut near = [(f64::INFINITY, 0.0); 2];
                for i in 0..count {
                    let r = d.apart(y, u[3 * i] * side).hypot(d.apart(x, u[3 * i + 1] * side));
                    if r < near[0].0 {
                        near = [(r, u[3 * i + 2]), near[0]];
                    } else if r < near[1].0 {
                        near[1] = (r, 0.0);
                    }
                }
                if near[1].0 - near[0].0 < 2.0 { -1.0 } else { 0.3 * near[0].1 }
            });
            mix(&a, &fine, |a, f| a + 3.0 * rough * f)
        }
        "dendrites" => {
            let power = d.lin(3, 1.5, 4.0);
            d.rough(39)?.iter().map(|z| (1.0 - z.abs() / 3.0).max(0.0).powf(power)).collect()
        }
        "run in" => {
            // Worn the more the higher, ridges of the lay kept between.
            let lay = d.field(0.8, d.log(1, 5.0, 10.0), side / 4.0, d.log(2, 2.0, 6.0), 39)?;
            let level = d.lin(3, -0.3, 1.0);
            lay.iter().map(|z| if *z > level { level + 0.1 * (z - level) } else { *z }).collect()
        }
        "sanded across" => {
            let one = d.field(0.7, 5.0, side / 4.0, 5.0, 39)?;
            let other = d.field(0.7, 5.0, side / 4.0, 5.0, 40)?;
            d.points(|y, x| {
                let (i, j) = (y as usize, x as usize);
                one[i * n + j].min(0.5 + other[j * n + i])
            })
        }
        "sparse summits" => {
            let s = d.lin(3, 0.7, 1.2);
            d.rough(39)?.iter().map(|z| (s * z).exp()).collect()
        }
        "smooth, bent" => {
            let s = d.lin(3, -0.5, 0.5);
            let waves = d.field(d.lin(2, 0.4, 1.0), d.log(1, 7.0, 14.0), side / 4.0, 1.0, 39)?;
            waves.iter().map(|z| z + 0.3 * s * z * z).collect()
        }
        _ => return Err(format!("no family {family}").into()),
    })
}
