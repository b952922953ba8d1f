//! Families that were judged second: written down after the constants had been changed once more, and run
//! once before they were changed again.

use crate::families::{crop, exponential, field, lines, marks, onto, wide};
use studies::maps::{Draw, Heights, mix};

/// Heights in points.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    Ok(match family {
        "few ridges" => {
            let ground = field(d, [0.6, 5.0, 24.0], 0)?;
            onto(d, &ground, &lines(d, 6.0, &[-1.0, 0.0, 1.0], 31), |line, y, x| {
                let s = line.distance(d, y, x) / (4.0 + 3.0 * line.own[0]);
                (0.5 + line.own[1]) * (-0.5 * s * s).exp()
            })
        }
        "oblique scratches" => {
            let ground = field(d, [0.8, 5.0, 28.0], 0)?;
            onto(d, &ground, &lines(d, 18.0, &[-3.0, 1.0, 2.0], 31), |line, y, x| {
                let s = line.distance(d, y, x).abs() / (2.0 + 3.0 * line.own[0]);
                -(0.3 + 1.5 * line.own[1]) * (1.0 - s).max(0.0)
            })
        }
        "scuffed" => {
            // Bundles of short parallel scratches.
            let ground = field(d, [0.7, 5.0, 30.0], 0)?;
            onto(d, &ground, &marks(d, 5.0, 31), |mark, y, x| {
                let [along, across] = mark.seen(d, y, x);
                let [long, wide, deep] = mark.own;
                let (long, wide) = (side * (0.1 + 0.2 * long), 6.0 + 10.0 * wide);
                if along.abs() > long || across.abs() > wide {
                    return 0.0;
                }
                -(0.4 + deep) * (0.5 - 0.5 * (across * 1.2).cos()) * (1.0 - (along / long).powi(2))
            })
        }
        "hail" => {
            let ground = field(d, [0.7, 6.0, 30.0], 0)?;
            onto(d, &ground, &marks(d, 6.0, 31), |mark, y, x| {
                let radius = 10.0 + 14.0 * mark.own[0];
                let s = (mark.distance(d, y, x) / radius).powi(2);
                0.06 * radius * (s - 1.0).min(0.0)
            })
        }
        "islands" => {
            let coarse = field(d, [0.8, 20.0, 0.4 * side], 31)?;
            mix(&field(d, [0.6, 4.0, 20.0], 0)?, &coarse, |f, z| {
                0.6 * f + 1.5 / (1.0 + (-6.0 * (z - 1.0)).exp())
            })
        }
        "ground, with burrs" => {
            let ground = wide(d, n, [0.7, 5.0, 20.0], 3.0, 0)?;
            onto(d, &ground, &marks(d, 12.0, 31), |mark, y, x| {
                let r = mark.distance(d, y, x) / (2.5 + 2.0 * mark.own[0]);
                0.8 * exponential(mark.own[1]) * (-0.5 * r * r).exp()
            })
        }
        "crop, H 0.7" => crop(d, [0.7, 6.0, 0.4], 1.0)?,
        "crop of two scales" => {
            let long = crop(d, [0.9, 40.0, 0.6], 1.0)?;
            mix(&field(d, [0.6, 4.0, 20.0], 7)?, &long, |f, z| f + 0.5 * z)
        }
        "crop, patchy" => {
            let strength = field(d, [0.8, 30.0, 0.5 * side], 31)?;
            mix(&crop(d, [0.6, 5.0, 0.8], 1.0)?, &strength, |h, s| {
                h * (1.0 + 0.7 * (s / 1.5).tanh())
            })
        }
        "crop of a lay, tilted" => crop(d, [0.6, 5.0, 0.6], 3.0)?,
        _ => return Err(format!("no family {family}").into()),
    })
}
