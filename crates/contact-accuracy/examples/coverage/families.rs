//! Surfaces given by formulas on the unit square, so that they are known on any grid: smooth ones, and ones with
//! creases, tips, steps and edges that do not match.

use Half::{Training as T, Validation as V};
use contact_accuracy::{Grid, HeightMap, Solution};
use std::f64::consts::TAU;

/// A number from 0 to 1 for each place in a sequence.
pub(crate) struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        // SplitMix64 (Steele, Lea & Flood 2014, doi:10.1145/2660193.2660195).
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A height at each place of the unit square.
pub(crate) type Heights = Box<dyn Fn(f64, f64) -> f64>;

/// Waves of `least` to `most` periods on a side, of rms 1, self-affine; `along` of the slopes along y are kept.
fn waves(dice: &mut Dice, hurst: f64, [least, most]: [f64; 2], along: f64) -> Heights {
    let mut waves = Vec::new();
    let end = most as i32;
    for ky in -end..=end {
        for kx in 0..=end {
            let k = f64::from(kx).hypot(f64::from(ky) / along);
            let phase = TAU * dice.roll();
            if (least..=most).contains(&k) && (kx > 0 || ky > 0) {
                waves.push([f64::from(ky), f64::from(kx), phase, k.powf(-1.0 - hurst)]);
            }
        }
    }
    let rms = (waves.iter().map(|w| 0.5 * w[3] * w[3]).sum::<f64>()).sqrt();
    Box::new(move |y, x| {
        let wave = |w: &[f64; 4]| w[3] * (TAU * (w[0] * y + w[1] * x) + w[2]).cos();
        waves.iter().map(wave).sum::<f64>() / rms
    })
}

/// From the middle of a period to both sides.
fn off(s: f64) -> f64 {
    s - (s + 0.5).floor()
}

/// Distances to the nearest two of `count` places.
fn distances(dice: &mut Dice, count: usize) -> impl Fn(f64, f64) -> [f64; 2] + use<> {
    let places: Vec<[f64; 2]> = (0..count).map(|_| [dice.roll(), dice.roll()]).collect();
    move |y, x| {
        places.iter().fold([9.0, 9.0], |[first, second], p| {
            let d = off(y - p[0]).hypot(off(x - p[1]));
            [first.min(d), second.min(d.max(first))]
        })
    }
}

/// Straight lines, of a whole number of periods along both sides: distances to the nearest of each of `count`.
fn lines(dice: &mut Dice, count: usize, most: f64) -> impl Fn(f64, f64) -> Vec<f64> + use<> {
    let mut one = || {
        let mut whole = || ((2.0 * most + 1.0) * dice.roll()).floor() - most;
        let (a, b) = (whole(), whole());
        [a, if a.abs() + b.abs() < 0.5 { 1.0 } else { b }, dice.roll()]
    };
    let lines: Vec<[f64; 3]> = (0..count).map(|_| one()).collect();
    move |y, x| lines.iter().map(|[a, b, c]| off(a * y + b * x + c).abs() / a.hypot(*b)).collect()
}

/// The highest of 25 pyramids.
fn pyramids(dice: &mut Dice) -> Heights {
    let all: Vec<[f64; 4]> =
        (0..25).map(|_| [dice.roll(), dice.roll(), 3.0 * dice.roll(), dice.roll()]).collect();
    Box::new(move |y, x| {
        let one = |p: &[f64; 4]| {
            let (dy, dx) = (off(y - p[0]), off(x - p[1]));
            let (u, v) = (p[2].cos() * dx + p[2].sin() * dy, p[2].cos() * dy - p[2].sin() * dx);
            0.05 * p[3] - u.abs().max(v.abs())
        };
        all.iter().map(one).fold(-9.0, f64::max)
    })
}

/// The part of a family: its constants were fixed with the one half, and judged on the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Half {
    Training,
    Validation,
}

type Distances = Box<dyn Fn(f64, f64) -> [f64; 2]>;

/// Heights from chance, waves of 3 to 8 periods, and the distances to the nearest two of 14 places.
type FamilyRecipe = fn(&mut Dice, Heights, Distances) -> Heights;

fn self_affine(dice: &mut Dice, hurst: f64, ends: [f64; 2]) -> Heights {
    waves(dice, hurst, ends, 1.0)
}

fn positive(z: f64) -> f64 {
    z.max(0.0)
}

/// Every family, its half, and what it is.
pub(crate) const FAMILIES: [(&str, Half, FamilyRecipe); 43] = [
    ("waves, long", T, |dice, _, _| self_affine(dice, 0.8, [2.0, 8.0])),
    ("waves, 8 points", V, |dice, _, _| self_affine(dice, 0.8, [3.0, 16.0])),
    ("waves, 4 points", T, |dice, _, _| self_affine(dice, 0.6, [3.0, 32.0])),
    ("waves, 2.7 points", V, |dice, _, _| self_affine(dice, 0.5, [3.0, 47.0])),
    ("short waves", T, |dice, _, _| self_affine(dice, 0.3, [3.0, 15.0])),
    ("white noise on top", V, |dice, rough, _| {
        let noise = self_affine(dice, -1.0, [3.0, 47.0]);
        Box::new(move |y, x| rough(y, x) + 0.02 * noise(y, x))
    }),
    ("lay", V, |dice, _, _| waves(dice, 0.7, [3.0, 24.0], 0.2)),
    ("lay, smooth", T, |dice, _, _| waves(dice, 0.9, [3.0, 10.0], 0.12)),
    ("turned", V, |dice, rough, _| {
        let (a, b) = (7.0, 1.0 + (2.0 * dice.roll()).floor());
        Box::new(move |y, x| (TAU * (a * x + b * y)).cos() + 0.2 * rough(y, x))
    }),
    ("egg box", T, |_, _, _| Box::new(|y, x| (TAU * 4.0 * x).cos() * (TAU * 4.0 * y).cos())),
    ("egg box, turned", V, |_, _, _| {
        Box::new(|y, x| (TAU * (4.0 * x + y)).cos() + (TAU * (4.0 * y - x)).cos())
    }),
    ("log-normal", T, |_, rough, _| Box::new(move |y, x| (0.8 * rough(y, x)).exp())),
    ("exponential tails", V, |_, rough, _| Box::new(move |y, x| (1.2 * rough(y, x)).exp())),
    ("balls", T, |_, _, d| Box::new(move |y, x| positive(0.04 - d(y, x)[0].powi(2)).sqrt())),
    ("packed balls", V, |dice, _, _| {
        let d = distances(dice, 60);
        Box::new(move |y, x| positive(0.02 - d(y, x)[0].powi(2)).sqrt())
    }),
    ("foam", T, |_, _, d| Box::new(move |y, x| d(y, x)[1] - d(y, x)[0])),
    ("folded, valleys", V, |_, rough, _| Box::new(move |y, x| rough(y, x).abs())),
    ("higher of two", T, |dice, rough, _| {
        let other = self_affine(dice, 0.8, [3.0, 8.0]);
        Box::new(move |y, x| rough(y, x).max(other(y, x)))
    }),
    ("lower of two", V, |dice, rough, _| {
        let other = self_affine(dice, 0.8, [3.0, 8.0]);
        Box::new(move |y, x| rough(y, x).min(other(y, x)))
    }),
    ("two levels", T, |_, rough, _| {
        Box::new(move |y, x| (6.0 * rough(y, x)).tanh() + 0.1 * rough(y, x))
    }),
    ("pillars", V, |_, rough, d| {
        Box::new(
            move |y, x| {
                if d(y, x)[0] < 0.08 { 1.0 + 0.1 * rough(y, x) } else { 0.1 * rough(y, x) }
            },
        )
    }),
    ("pores", T, |_, rough, d| {
        Box::new(move |y, x| {
            let depth = if d(y, x)[0] < 0.04 { 2.0 } else { 0.0 };
            0.3 * rough(y, x) - depth
        })
    }),
    ("terraces", V, |dice, rough, _| {
        let fine = self_affine(dice, 0.8, [6.0, 16.0]);
        Box::new(move |y, x| (1.5 * rough(y, x)).floor() + 0.1 * fine(y, x))
    }),
    ("stairs", T, |_, rough, _| {
        Box::new(move |y, x| {
            let s = 2.0 * rough(y, x);
            s.floor() + (4.0 * (s - s.floor() - 0.5)).clamp(-0.5, 0.5)
        })
    }),
    ("cut", V, |_, rough, _| Box::new(move |y, x| rough(y, x).min(0.3))),
    ("burrs", T, |_, rough, d| {
        Box::new(move |y, x| rough(y, x) + 3.0 * (-(d(y, x)[0] / 0.02).powi(2)).exp())
    }),
    ("tips", V, |_, rough, d| {
        Box::new(move |y, x| 0.3 * rough(y, x) + 4.0 * (-d(y, x)[0] / 0.03).exp())
    }),
    ("cones", T, |_, _, d| Box::new(move |y, x| -d(y, x)[0])),
    ("pyramids", V, |dice, _, _| pyramids(dice)),
    ("ridges", T, |_, _, d| Box::new(move |y, x| d(y, x)[0] - d(y, x)[1])),
    ("wedges", V, |_, rough, d| {
        Box::new(move |y, x| 0.02 * rough(y, x) - (d(y, x)[1] - d(y, x)[0]).min(0.08))
    }),
    ("folded, ridges", T, |_, rough, _| Box::new(move |y, x| -rough(y, x).abs())),
    ("fractional parts", V, |_, rough, _| Box::new(move |y, x| off(0.35 * rough(y, x)).abs())),
    ("cusps", T, |_, rough, _| Box::new(move |y, x| -rough(y, x).abs().sqrt())),
    ("ridges of ridges", V, |dice, _, _| {
        let mut part = |share: f64, most| (share, self_affine(dice, 0.8, [3.0, most]));
        let all = [part(1.0, 4.0), part(0.5, 8.0), part(0.25, 16.0)];
        Box::new(move |y, x| all.iter().map(|(share, waves)| -share * waves(y, x).abs()).sum())
    }),
    ("ploughed", T, |dice, rough, _| {
        let lines = lines(dice, 8, 2.0);
        Box::new(move |y, x| {
            let groove =
                |s: f64| positive(1.0 - (s - 0.03).abs() / 0.01) - 2.0 * positive(1.0 - s / 0.02);
            rough(y, x) + lines(y, x).into_iter().map(groove).sum::<f64>()
        })
    }),
    ("lay of creases", V, |dice, _, _| {
        let lines = lines(dice, 9, 5.0);
        Box::new(move |y, x| lines(y, x).iter().sum())
    }),
    ("sawtooth", T, |dice, rough, _| {
        let (a, phase) = (5.0 + (4.0 * dice.roll()).floor(), dice.roll());
        Box::new(move |y, x| {
            let s = a * x + y + phase;
            let s = s - s.floor();
            (if s < 0.7 { s / 0.7 } else { (1.0 - s) / 0.3 }) + 0.2 * rough(y, x)
        })
    }),
    ("scratched", V, |dice, rough, _| {
        let lines = lines(dice, 10, 2.0);
        Box::new(move |y, x| {
            let scratch = |s: f64| -2.0 * (-(s / 0.012).powi(2)).exp();
            rough(y, x) + lines(y, x).into_iter().map(scratch).sum::<f64>()
        })
    }),
    ("patchy", T, |dice, rough, _| {
        let fine = self_affine(dice, 0.6, [8.0, 24.0]);
        Box::new(move |y, x| (1.0 + 0.8 * rough(y, x).tanh()) * fine(y, x))
    }),
    // Places that are no whole period, so that opposite edges do not match.
    ("crop", V, |dice, _, _| {
        let whole = self_affine(dice, 0.8, [3.0, 24.0]);
        Box::new(move |y, x| whole(0.61 * y, 0.61 * x))
    }),
    ("crop, long waves", T, |dice, _, _| {
        let whole = self_affine(dice, 0.8, [1.0, 20.0]);
        Box::new(move |y, x| whole(0.47 * y, 0.47 * x))
    }),
    ("crop of a lay", V, |dice, _, _| {
        let whole = waves(dice, 0.7, [3.0, 24.0], 0.2);
        Box::new(move |y, x| whole(0.61 * y, 0.61 * x))
    }),
];

/// Families of the cases that not all take part in.
pub(crate) const FEW: [&str; 8] = [
    "waves, 8 points",
    "short waves",
    "lay",
    "log-normal",
    "balls",
    "two levels",
    "cones",
    "ridges",
];

/// A family of the sampling variability alone.
pub(crate) const MANY_WAVES: &str = "waves, many";

/// The heights of a family, each from its own seeds.
pub(crate) fn family(name: &str, seed: u64) -> Option<Heights> {
    let dice = &mut Dice(1000 * seed + name.bytes().map(u64::from).sum::<u64>());
    let rough = self_affine(dice, 0.8, [3.0, 8.0]);
    let d = Box::new(distances(dice, 14));
    if name == MANY_WAVES {
        return Some(self_affine(dice, 0.8, [16.0, 32.0]));
    }
    Some(FAMILIES.iter().find(|family| family.0 == name)?.2(dice, rough, d))
}

/// The surface on `points` points along each side.
pub(crate) fn map(points: usize, heights: &Heights) -> HeightMap {
    let pixel = 1.0 / points as f64;
    let grid = Grid::new([points, points], [pixel, pixel]).unwrap();
    HeightMap::from_fn(grid, heights).unwrap()
}

/// Mean of `1/(g + M)` over the points, M the temperature `jump`; 0 where one carries pressure.
pub(crate) fn gas(truth: &Solution, jump: f64) -> f64 {
    let points = truth.gap.iter().zip(&truth.pressure);
    let open = points.map(|(g, p)| if *p > 0.0 { 0.0 } else { 1.0 / (g.max(0.0) + jump) });
    open.sum::<f64>() / truth.gap.len() as f64
}
