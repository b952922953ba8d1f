//! Families that were written down after the constants had been fixed on all the others, and run once.

use crate::families::{crop, exponential, field, lines, marks, onto, wide};
use std::f64::consts::TAU;
use studies::maps::{Draw, Heights, mix, softmin};

/// Their names.
pub(crate) const FRESH: [&str; 16] = [
    "worn",
    "honed, two depths",
    "chips on a lay",
    "shot-peened",
    "craters with rims, eroded",
    "bead-blasted",
    "printed layers, with drops",
    "one deep groove",
    "two roughnesses",
    "inclusions that stand out",
    "corroded in places",
    "fine and deep scratches",
    "raised fibres",
    "crop, peened",
    "crop, with chips",
    "crop, grooved",
];

/// The lowest of spherical caps pressed in, or 0 where there is none; radius of the ball, and of the rim.
fn dents(d: &Draw, mean: f64, [ball, least, most]: [f64; 3], salt: u64) -> Vec<f64> {
    let marks = marks(d, mean, salt);
    d.points(|y, x| {
        let depth = |mark: &crate::families::Mark| {
            let rim = least + (most - least) * mark.own[0];
            (mark.distance(d, y, x).powi(2) - rim * rim) / (2.0 * ball)
        };
        marks.iter().map(depth).fold(0.0, f64::min)
    })
}

/// Heights in points.
pub(crate) fn heights(family: &str, d: &Draw) -> Heights {
    let n = d.n;
    let side = n as f64;
    Ok(match family {
        "worn" => {
            let ground = field(d, [0.8, 6.0, 48.0], 0)?;
            ground.iter().map(|z| softmin(*z, 0.5, 0.15)).collect()
        }
        "honed, two depths" => {
            let ground = field(d, [0.6, 5.0, 20.0], 0)?;
            let flat: Vec<f64> = ground.iter().map(|z| softmin(*z, 0.0, 0.08)).collect();
            onto(d, &flat, &lines(d, 16.0, &[-2.0, 2.0], 61), |line, y, x| {
                let deep = if line.own[0] < 0.25 { 1.8 } else { 0.4 };
                let s = line.distance(d, y, x) / (2.0 + 1.5 * deep);
                -deep * (-0.5 * s * s).exp()
            })
        }
        "chips on a lay" => {
            let ground = wide(d, n, [0.6, 5.0, 16.0], 4.0, 0)?;
            onto(d, &ground, &marks(d, 16.0, 61), |mark, y, x| {
                let [along, across] = mark.seen(d, y, x);
                let s = (along / (3.0 + 5.0 * mark.own[0])).powi(2) + (across / 2.5).powi(2);
                (0.2 + 0.6 * exponential(mark.own[1])) * (-0.5 * s).exp()
            })
        }
        "shot-peened" => {
            let dents = dents(d, 40.0, [70.0, 8.0, 18.0], 61);
            mix(&field(d, [0.7, 5.0, 20.0], 0)?, &dents, |a, b| 0.3 * a + b)
        }
        "craters with rims, eroded" => {
            let ground = field(d, [0.5, 5.0, 12.0], 0)?;
            let ground: Vec<f64> = ground.iter().map(|z| 0.5 * z).collect();
            onto(d, &ground, &marks(d, 25.0, 61), |mark, y, x| {
                // As many small ones as there are large.
                let rim = 4.0 * 4f64.powf(mark.own[0]);
                let s = mark.distance(d, y, x) / rim;
                let wall = 1.0 / (1.0 + (8.0 * (s - 1.0)).exp());
                0.1 * rim * (0.8 * (-((s - 1.1) / 0.2).powi(2)).exp() - wall)
            })
        }
        "bead-blasted" => {
            let large = dents(d, 60.0, [25.0, 3.0, 8.0], 61);
            let small = dents(d, 300.0, [12.0, 2.0, 4.0], 63);
            let dented = mix(&large, &small, |a, b| a + b);
            mix(&field(d, [0.8, 5.0, 60.0], 0)?, &dented, |a, b| a + b)
        }
        "printed layers, with drops" => {
            let ground = field(d, [0.6, 5.0, 16.0], 0)?;
            let u = d.uniform(8, 61);
            let layers = d.points(|y, _| {
                let phase = (y * 8.0 / side).rem_euclid(8.0);
                let (layer, t) = (phase as usize % 8, phase.fract());
                // A bead, higher or lower than its neighbours.
                (0.6 + 0.8 * u[layer]) * (1.0 - (2.0 * t - 1.0).powi(2)).sqrt()
            });
            let ground = mix(&ground, &layers, |a, b| 0.6 * a + b);
            onto(d, &ground, &marks(d, 9.0, 62), |mark, y, x| {
                let radius = 4.0 + 5.0 * mark.own[0];
                let s = (mark.distance(d, y, x) / radius).powi(2);
                0.25 * radius * (1.0 - s).max(0.0).sqrt()
            })
        }
        "one deep groove" => {
            let u = d.uniform(3, 61);
            let (at, wide, deep) = (u[0] * side, 4.0 + 4.0 * u[1], 1.5 + 2.0 * u[2]);
            let groove = d.points(|y, x| {
                let s = d.apart(x + y, at) / wide;
                -deep * (-0.5 * s * s).exp()
            });
            mix(&field(d, [0.7, 5.0, 30.0], 0)?, &groove, |a, b| a + b)
        }
        "two roughnesses" => {
            let place = field(d, [0.8, 30.0, 0.35 * side], 61)?;
            let smooth = field(d, [0.8, 8.0, 30.0], 62)?;
            let rough = field(d, [0.6, 4.0, 16.0], 0)?;
            let share = |s: f64| 1.0 / (1.0 + (-8.0 * (s - 0.5)).exp());
            let mixed = mix(&rough, &place, |r, s| 1.5 * r * share(s));
            mix(&mixed, &smooth, |a, b| a + 0.4 * b)
        }
        "inclusions that stand out" => {
            let ground = field(d, [0.7, 5.0, 30.0], 0)?;
            onto(d, &ground, &marks(d, 10.0, 61), |mark, y, x| {
                let radius = 4.0 + 6.0 * mark.own[0];
                let edge = mark.distance(d, y, x) - radius;
                (0.2 + 0.7 * mark.own[1]) / (1.0 + (edge / 0.8).clamp(-40.0, 40.0).exp())
            })
        }
        "corroded in places" => {
            let place = field(d, [0.8, 24.0, 0.4 * side], 61)?;
            let pits = dents(d, 120.0, [6.0, 2.0, 5.0], 62);
            let bitten = mix(&pits, &place, |p, s| p / (1.0 + (-5.0 * (s - 0.5)).exp()));
            mix(&field(d, [0.7, 5.0, 30.0], 0)?, &bitten, |a, b| a + b)
        }
        "fine and deep scratches" => {
            let ground = field(d, [0.5, 5.0, 20.0], 0)?;
            let fine = lines(d, 40.0, &[-2.0, -1.0, 0.0, 1.0, 2.0], 61);
            let deep = lines(d, 4.0, &[-1.0, 0.0, 1.0], 63);
            let fine = onto(d, &ground, &fine, |line, y, x| {
                -0.25 * (-0.5 * (line.distance(d, y, x) / 1.8).powi(2)).exp()
            });
            onto(d, &fine, &deep, |line, y, x| {
                let s = line.distance(d, y, x).abs() / (4.0 + 3.0 * line.own[0]);
                -(1.0 + 1.0 * line.own[1]) * (1.0 - s).max(0.0)
            })
        }
        "raised fibres" => {
            let ground = field(d, [0.7, 6.0, 24.0], 0)?;
            onto(d, &ground, &marks(d, 14.0, 61), |mark, y, x| {
                let [along, across] = mark.seen(d, y, x);
                let long = 14.0 + 26.0 * mark.own[0];
                let bent = across - 0.15 * (TAU * along / (2.0 * long)).sin() * long * 0.3;
                let end = 0.5 * (1.0 - ((along.abs() - long) / 2.0).tanh());
                (0.4 + 0.5 * mark.own[1]) * end * (1.0 - (bent / 3.5).powi(2)).max(0.0).sqrt()
            })
        }
        "crop, peened" => {
            let long = crop(d, [0.8, 8.0, 0.5], 1.0)?;
            mix(&dents(d, 30.0, [60.0, 6.0, 16.0], 61), &long, |a, b| a + b)
        }
        "crop, with chips" => {
            let ground = crop(d, [0.7, 6.0, 0.6], 1.0)?;
            onto(d, &ground, &marks(d, 14.0, 61), |mark, y, x| {
                let r = mark.distance(d, y, x) / (2.5 + 2.0 * mark.own[0]);
                0.7 * exponential(mark.own[1]) * (-0.5 * r * r).exp()
            })
        }
        "crop, grooved" => {
            let ground = crop(d, [0.7, 5.0, 0.5], 3.0)?;
            onto(d, &ground, &lines(d, 8.0, &[0.0], 61), |line, y, x| {
                let s = line.distance(d, y, x) / (3.0 + 4.0 * line.own[1]);
                -0.8 * (0.3 + line.own[0]) * (1.0 - s * s).max(0.0)
            })
        }
        _ => return Err(format!("no family {family}").into()),
    })
}
