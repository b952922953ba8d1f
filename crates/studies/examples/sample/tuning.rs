//! Families that the constants were fixed on.

use crate::families::{crop, field, lines, marks, onto, wide};
use studies::maps::{Draw, Heights, mix};

/// Their names; numbers in them are read.
pub(crate) const TUNING: [&str; 22] = [
    "scratches 4",
    "scratches 12",
    "scratches 30",
    "wide scratches 6",
    "wide scratches 20",
    "scratches of two depths 12",
    "crop 0.25 H 0.5",
    "crop 0.5 H 0.85",
    "crop 1 H 0.5",
    "crop 2 H 0.85",
    "crop 0.25 H 0.85",
    "tilted crop 0.25 H 0.5",
    "tilted crop 0.5 H 0.85",
    "tilted crop 2 H 0.5",
    "pits 5",
    "pits 20",
    "bumps 5",
    "bumps 20",
    "waves from 32",
    "waves from 100",
    "lay of 4",
    "patches",
];

/// The numbers in a name.
fn numbers(family: &str) -> Vec<f64> {
    family.split(' ').filter_map(|word| word.parse().ok()).collect()
}

/// Heights in points; whether the plane is left in.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let known = numbers(family);
    let slopes = [-2.0, -1.0, 0.0, 1.0];
    Ok(match family {
        _ if family.contains("scratches") => {
            let width = if family.starts_with("wide") { 6.0 } else { 2.5 };
            let two = family.contains("depths");
            let ground = field(d, [0.7, 5.0, 32.0], 0)?;
            let lines = lines(d, known[0], &slopes, 1);
            onto(d, &ground, &lines, |line, y, x| {
                let [u, _] = line.own;
                let deep = match (two, u < 0.3) {
                    (false, _) => 0.5 + u,
                    (true, true) => 3.0,
                    (true, false) => 0.5,
                };
                -deep * (-0.5 * (line.distance(d, y, x) / width).powi(2)).exp()
            })
        }
        _ if family.contains("crop") => crop(d, [known[1], 5.0, known[0]], 1.0)?,
        _ if family.starts_with("pits") || family.starts_with("bumps") => {
            let sign = if family.starts_with("pits") { -1.0 } else { 1.0 };
            let ground = field(d, [0.7, 5.0, 32.0], 0)?;
            onto(d, &ground, &marks(d, known[0], 1), |mark, y, x| {
                let (wide, tall) = (3.0 + 5.0 * mark.own[0], 0.5 + mark.own[1]);
                sign * tall * (-0.5 * (mark.distance(d, y, x) / wide).powi(2)).exp()
            })
        }
        _ if family.starts_with("waves") => field(d, [0.8, 5.0, known[0]], 0)?,
        "lay of 4" => wide(d, d.n, [0.7, 5.0, 40.0], 4.0, 0)?,
        "patches" => {
            let strength = field(d, [0.8, 30.0, 60.0], 1)?;
            mix(&field(d, [0.7, 5.0, 30.0], 0)?, &strength, |h, s| {
                h * (1.0 + 0.8 * (s / 1.2).tanh())
            })
        }
        _ => return Err(format!("no family {family}").into()),
    })
}
