//! The surfaces the equation is fitted on, and those it is judged on: of other seeds and, for a fifth of the
//! families, of kinds that took no part in the fit.

use crate::brought;
use crate::fields::{fine, other, rough};
use crate::further;
use crate::instrument;
use crate::met;
use crate::unkind;
use crate::unseen;
use contact_types::HeightMap;
use std::error::Error;
use std::f64::consts::TAU;
use studies::drawing::van_der_corput;
use studies::maps::{Draw, Heights, mix, scaled, softmin, triangle};

/// What its maps are used for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Fit,
    Judge,
}

/// A family and how many of its maps are fitted, were judged by the seven laws before this one and are fitted since,
/// are judged.
pub(crate) struct Family {
    pub(crate) name: &'static str,
    pub(crate) maps: [usize; 9],
    make: fn(&Draw) -> Heights,
}

/// One map.
#[derive(Clone, Copy)]
pub(crate) struct Case {
    pub(crate) family: &'static Family,
    pub(crate) draw: Draw,
}

const fn family(name: &'static str, maps: [usize; 9], make: fn(&Draw) -> Heights) -> Family {
    Family { name, maps, make }
}

/// All of them. A map keeps its numbers as long as its family keeps its place and its counts grow.
pub(crate) static FAMILIES: [Family; 77] = [
    family("gaussian", [32, 8, 6, 5, 4, 12, 12, 12, 12], gaussian),
    family("wide", [24, 8, 6, 5, 4, 8, 8, 8, 8], wide),
    family("lay", [13, 8, 6, 5, 4, 12, 12, 16, 16], lay),
    family("bent", [13, 8, 6, 5, 4, 12, 12, 10, 10], bent),
    family("worn", [13, 8, 6, 5, 4, 12, 12, 10, 10], worn),
    family("turned", [13, 8, 6, 5, 4, 12, 12, 10, 10], turned),
    family("patchy", [13, 8, 6, 5, 4, 12, 12, 10, 10], patchy),
    family("scratched", [13, 8, 6, 5, 4, 12, 12, 10, 10], scratched),
    family("stepped", [13, 8, 6, 5, 4, 12, 12, 16, 16], stepped),
    family("cross-hatched", [0, 8, 6, 5, 4, 4, 3, 2, 2], cross_hatched),
    family("plateau-honed", [0, 8, 6, 5, 4, 12, 12, 10, 10], plateau_honed),
    family("log-normal", [0, 8, 6, 5, 4, 4, 3, 2, 2], log_normal),
    family("pillars", [0, 8, 6, 5, 4, 4, 3, 2, 2], pillars),
    family("pitted", [0, 8, 6, 5, 4, 4, 3, 2, 2], pitted),
    family("partly-polished", [0, 8, 6, 5, 4, 4, 3, 2, 2], partly_polished),
    family("milled", [0, 8, 6, 5, 4, 4, 3, 2, 2], milled),
    family("two-levels", [0, 8, 6, 5, 4, 4, 3, 2, 2], two_levels),
    family("weibull", [0, 8, 6, 5, 4, 4, 3, 2, 2], weibull),
    family("dimpled", [0, 0, 8, 5, 4, 4, 3, 2, 2], dimpled),
    family("ball-bed", [0, 0, 8, 5, 4, 4, 3, 2, 2], ball_bed),
    family("craters", [0, 0, 8, 5, 4, 4, 3, 2, 2], craters),
    family("terraces", [0, 0, 8, 5, 4, 4, 3, 2, 2], terraces),
    family("creased", [0, 0, 8, 5, 4, 4, 3, 2, 2], creased),
    family("gritty", [0, 0, 8, 5, 4, 4, 3, 2, 2], gritty),
    family("banded", [0, 0, 8, 5, 4, 4, 3, 2, 2], banded),
    family("wavy", [0, 0, 8, 5, 4, 4, 3, 2, 2], wavy),
    family("knurled", [0, 0, 8, 5, 4, 4, 3, 2, 2], knurled),
    family("bent-lay", [0, 0, 8, 5, 4, 4, 3, 2, 2], bent_lay),
    family("worn-wide", [0, 0, 8, 5, 4, 3, 2, 2, 2], worn_wide),
    family("lapped-lay", [0, 0, 8, 5, 4, 4, 3, 2, 2], lapped_lay),
    family("laser-dots", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::laser_dots),
    family("orange-peel", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::orange_peel),
    family("peened-ground", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::peened_ground),
    family("burred", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::burred),
    family("woven", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::woven),
    family("sintered-worn", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::sintered_worn),
    family("cracked", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::cracked),
    family("ridged", [0, 0, 0, 6, 4, 4, 3, 2, 2], ridged),
    family("one-scratch", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::one_scratch),
    family("caps", [0, 0, 0, 6, 4, 4, 3, 2, 2], unkind::caps),
    family("eroded", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::eroded),
    family("blasted-rolled", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::blasted_rolled),
    family("hairline", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::hairline),
    family("wood", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::wood),
    family("layered", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::layered),
    family("fretted", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::fretted),
    family("etched", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::etched),
    family("scaled-islands", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::scaled_islands),
    family("formed", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::formed),
    family("quantised", [0, 0, 0, 0, 6, 4, 3, 2, 2], brought::quantised),
    family("posts", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::posts),
    family("nodules", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::nodules),
    family("corroded", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::corroded),
    family("honeycomb", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::honeycomb),
    family("inclusions", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::inclusions),
    family("saw-toothed", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::saw_toothed),
    family("chattered", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::chattered),
    family("spiky", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::spiky),
    family("cast", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::cast),
    family("cascaded", [0, 0, 0, 0, 0, 6, 3, 2, 2], met::cascaded),
    family("hammered", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::hammered),
    family("folded", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::folded),
    family("bricks", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::bricks),
    family("ploughed", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::ploughed),
    family("blistered", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::blistered),
    family("striped", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::striped),
    family("pulled", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::pulled),
    family("faceted", [0, 0, 0, 0, 0, 0, 6, 2, 2], further::faceted),
    family("noisy", [0, 0, 0, 0, 0, 0, 14, 4, 4], instrument::noisy),
    family("noisy-worn", [0, 0, 0, 0, 0, 0, 14, 4, 4], instrument::noisy_worn),
    family("noisy-lay", [0, 0, 0, 0, 0, 0, 14, 4, 4], instrument::noisy_lay),
    family("spiked", [0, 0, 0, 0, 0, 0, 14, 4, 4], instrument::spiked),
    family("rippled", [0, 0, 0, 0, 0, 0, 0, 0, 6], unseen::rippled),
    family("sprayed", [0, 0, 0, 0, 0, 0, 0, 0, 6], unseen::sprayed),
    family("sanded", [0, 0, 0, 0, 0, 0, 0, 0, 6], unseen::sanded),
    family("grained", [0, 0, 0, 0, 0, 0, 0, 0, 6], unseen::grained),
    family("gridded", [0, 0, 0, 0, 0, 0, 0, 0, 6], unseen::gridded),
];

/// The maps of a part, interleaved so that any first part of the list covers all families.
pub(crate) fn cases(part: Part) -> Vec<Case> {
    let mut list = Vec::new();
    let sets = if part == Part::Judge { 8..9 } else { 0..8 };
    for set in sets {
        for i in 0..FAMILIES.iter().map(|f| f.maps[set]).max().unwrap_or(0) {
            for (place, family) in FAMILIES.iter().enumerate().filter(|(_, f)| i < f.maps[set]) {
                // Each set goes on where the sequence of the others is far away.
                let at = 1 + i + set * 5000;
                let t = [2, 3, 5, 7].map(|base| van_der_corput(at, base));
                let n = if family.name.contains("wide") { 1024 } else { 512 };
                let seed = (100_000 + 50_000 * set + 1000 * place + i) as u64;
                list.push(Case { family, draw: Draw { n, seed, t } });
            }
        }
    }
    list
}

impl Case {
    /// The map, of 0.1 rms gradient by differences.
    pub(crate) fn map(&self) -> Result<HeightMap, Box<dyn Error>> {
        scaled(&(self.family.make)(&self.draw)?, self.draw.n)
    }
}

fn gaussian(d: &Draw) -> Heights {
    if d.t[3] < 0.8 {
        return rough(d, 1.0, 0);
    }
    // Narrow bands, down to a bandwidth parameter of 1.6.
    let cutoff = d.log(1, 8.0, 24.0);
    d.field(d.lin(0, 0.2, 1.0), cutoff, cutoff * d.log(2, 1.05, 3.0), 1.0, 0)
}

fn wide(d: &Draw) -> Heights {
    let cutoff = d.log(1, 6.0, 12.0);
    d.field(d.lin(0, 0.2, 0.9), cutoff, d.n as f64 / d.log(2, 1.2, 10.0), 1.0, 0)
}

fn lay(d: &Draw) -> Heights {
    rough(d, d.log(3, 1.2, 6.0), 0)
}

/// Through sinh((asinh z + bend) / tails): skewed, with heavier or lighter tails.
fn bent(d: &Draw) -> Heights {
    let (bend, tails) = (d.lin(3, -0.7, 0.7), 0.75 + 0.6 * other(d, 7.3));
    Ok(rough(d, 1.0, 0)?.iter().map(|z| ((z.asinh() + bend) / tails).sinh()).collect())
}

/// Summits pressed to a level, and on most of them a fine roughness of the wear.
fn worn(d: &Draw) -> Heights {
    let level = d.lin(3, -0.5, 1.2);
    let on_top = 0.15 * other(d, 5.7);
    Ok(mix(&rough(d, 1.0, 0)?, &fine(d, 1)?, |z, f| softmin(z, level, 0.15) + on_top * f))
}

fn turned(d: &Draw) -> Heights {
    let marks = (4.0 + 24.0 * d.t[3]).round();
    let depth = 0.3 + 2.0 * other(d, 5.7);
    let n = d.n as f64;
    let waves = d.points(|_, x| depth * triangle(marks * x / n).powf(1.5));
    Ok(mix(&rough(d, 1.0, 0)?, &waves, |z, w| 0.5 * z + w))
}

/// Rough in some places, smoother in others.
fn patchy(d: &Draw) -> Heights {
    let n = d.n as f64;
    let strength = d.field(0.8, n / 8.0, n / 3.0, 1.0, 1)?;
    let contrast = d.lin(3, 0.2, 0.9);
    Ok(mix(&rough(d, 1.0, 0)?, &strength, |z, s| (1.0 + contrast * (1.5 * s).tanh()) * z))
}

/// Valleys along straight lines that repeat, with raised rims on some.
fn scratched(d: &Draw) -> Heights {
    let count = 3 + (20.0 * d.t[3]) as usize;
    let u = d.uniform(4 * count, 3);
    let n = d.n as f64;
    let rim = 0.4 * other(d, 5.7);
    let marks = d.points(|y, x| {
        let one = |u: &[f64]| {
            let slope = (7.0 * u[0]).floor() - 3.0;
            let r = d.apart(x + slope * y, u[1] * n) / slope.hypot(1.0) / (3.0 + 8.0 * u[2]);
            (1.0 + 3.0 * u[3]) * (rim * r * r - 1.0) * (-0.5 * r * r).exp()
        };
        u.chunks_exact(4).map(one).sum()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &marks, |z, m| z + m))
}

/// Heights rounded to 0.05 to 1.5 of gradient times point spacing.
fn stepped(d: &Draw) -> Heights {
    let z = rough(d, 1.0, 0)?;
    let step = d.log(3, 0.05, 1.5) * studies::maps::gradient(&z, d.n);
    Ok(z.iter().map(|z| (z / step).round() * step).collect())
}

fn cross_hatched(d: &Draw) -> Heights {
    let (n, a) = (d.n, rough(d, 1.5 + 4.0 * d.t[3], 0)?);
    let b = rough(d, 1.5 + 4.0 * d.t[3], 1)?;
    let sum = |i: usize| {
        let (iy, ix) = (i / n, i % n);
        a[iy * n + (ix + iy) % n] + b[iy * n + (ix + n - iy) % n]
    };
    Ok((0..n * n).map(sum).collect())
}

/// A worn ground with fine roughness, and honing grooves across each other.
fn plateau_honed(d: &Draw) -> Heights {
    let grooves = d.field(0.7, 10.0, 40.0, 12.0, 2)?;
    let n = d.n;
    let level = d.lin(3, -1.0, 0.5);
    let f = fine(d, 1)?;
    let at = |i: usize| {
        let (iy, ix) = (i / n, i % n);
        let (a, b) = (grooves[iy * n + (ix + iy) % n], grooves[iy * n + (ix + n - iy) % n]);
        softmin(a + 0.7 * b, level, 0.2) + 0.12 * f[i]
    };
    Ok((0..n * n).map(at).collect())
}

/// A honed surface upside down: grooves stand up as ridges.
fn ridged(d: &Draw) -> Heights {
    Ok(plateau_honed(d)?.iter().map(|z| -z).collect())
}

fn log_normal(d: &Draw) -> Heights {
    let s = d.lin(3, 0.1, 0.6);
    let sign = if d.t[3] * 10.0 % 1.0 < 0.5 { 1.0 } else { -1.0 };
    Ok(rough(d, 1.0, 0)?.iter().map(|z| sign * (sign * s * z).exp() / s).collect())
}

/// Few high plateaus with a fine roughness.
fn pillars(d: &Draw) -> Heights {
    let n = d.n as f64;
    let coarse = d.field(0.8, n / 20.0, n / 6.0, 1.0, 0)?;
    let on_top = d.lin(3, 0.05, 0.4);
    Ok(mix(&coarse, &fine(d, 1)?, |z, f| (1.5 * (z - 0.6)).tanh() + on_top * f))
}

fn pitted(d: &Draw) -> Heights {
    let n = d.n as f64;
    let pits = d.field(0.8, n / 24.0, n / 8.0, 1.0, 1)?;
    let depth = d.lin(3, 0.5, 4.0);
    Ok(mix(&rough(d, 1.0, 0)?, &pits, |z, p| z + softmin(0.7 - p, 0.0, 0.1) * depth))
}

fn partly_polished(d: &Draw) -> Heights {
    let n = d.n as f64;
    let place = d.field(0.9, n / 10.0, n / 4.0, 1.0, 1)?;
    let left = d.lin(3, 0.15, 0.7);
    let share = |s: f64| left + (1.0 - left) / (1.0 + (-8.0 * s).exp());
    Ok(mix(&rough(d, 1.0, 0)?, &place, |z, s| share(s) * z))
}

/// Arcs of a face mill.
fn milled(d: &Draw) -> Heights {
    let n = d.n as f64;
    let (pitch, depth) = (n / (5.0 + 20.0 * d.t[3]).round(), 0.3 + 1.5 * other(d, 5.7));
    let arcs = d.points(|y, x| {
        let bow = 0.15 * n * (TAU * y / n).cos();
        depth * (TAU * (x + bow) / pitch).cos()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &arcs, |z, a| 0.4 * z + a))
}

fn two_levels(d: &Draw) -> Heights {
    let n = d.n as f64;
    let coarse = d.field(0.8, n / 20.0, n / 5.0, 1.0, 0)?;
    let on_top = d.lin(3, 0.1, 0.6);
    Ok(mix(&coarse, &fine(d, 1)?, |z, f| (2.0 * z).tanh() + on_top * f))
}

/// Heights of a Weibull distribution by way of the Gaussian's own distribution.
fn weibull(d: &Draw) -> Heights {
    let shape = d.log(3, 1.2, 6.0);
    let below = |z: f64| 0.5 * libm_erfc(-z / std::f64::consts::SQRT_2);
    Ok(rough(d, 1.0, 0)?
        .iter()
        .map(|z| (-(1.0 - below(*z)).max(1e-9).ln()).powf(1.0 / shape))
        .collect())
}

/// Round dimples, as by laser, in rows on a rough ground.
fn dimpled(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, (4.0 + 8.0 * d.t[3]).round());
    let (pitch, depth) = (n / count, 1.0 + 3.0 * other(d, 5.7));
    let holes = d.points(|y, x| {
        let apart = |a: f64| (a / pitch).fract() - 0.5;
        let r = apart(y).hypot(apart(x)) / 0.3;
        depth * (r * r - 1.0).min(0.0)
    });
    Ok(mix(&rough(d, 1.0, 0)?, &holes, |z, h| 0.6 * z + h))
}

/// The tops of balls of several sizes thrown on a plane, the highest seen, with a fine roughness.
fn ball_bed(d: &Draw) -> Heights {
    let count = 60 + (200.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 5));
    let size = 1.2 * n / (count as f64).sqrt();
    let balls = d.points(|y, x| {
        let top = |u: &[f64]| {
            let r = size * (0.6 + 0.5 * u[2]);
            let square = d.apart(y, u[0] * n).powi(2) + d.apart(x, u[1] * n).powi(2);
            // A paraboloid, so that there are no walls.
            r - square / r
        };
        u.chunks_exact(3).map(top).fold(0.0, f64::max)
    });
    let on_top = 0.02 * size * other(d, 5.7);
    Ok(mix(&balls, &fine(d, 1)?, |b, f| b + on_top * f))
}

/// Blasted: craters that overlap, with raised rims, on a rough ground.
fn craters(d: &Draw) -> Heights {
    let count = 40 + (120.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(3 * count, 6));
    let pits = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (6.0 + 20.0 * u[2]);
            (r * r - 1.0) * (-r * r).exp()
        };
        u.chunks_exact(3).map(one).sum()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &pits, |z, p| 0.4 * z + 1.5 * p))
}

/// Wide steps a few roughnesses high, as of a crystal, each softened over some points, roughness on all.
fn terraces(d: &Draw) -> Heights {
    let n = d.n as f64;
    let coarse = d.field(0.9, n / 12.0, n / 3.0, 1.0, 0)?;
    let (step, on_top) = (d.lin(3, 0.4, 1.2), 0.02 + 0.15 * other(d, 5.7));
    let stairs = |z: f64| {
        let (whole, part) = ((z / step).floor(), (z / step).rem_euclid(1.0));
        step * (whole + 0.5 + 0.5 * (10.0 * (part - 0.5)).tanh() / 5f64.tanh())
    };
    Ok(mix(&coarse, &fine(d, 1)?, |z, f| stairs(z) + on_top * f))
}

/// Folded at its mean plane, upwards or downwards: creases as crests or as valleys.
fn creased(d: &Draw) -> Heights {
    let sign = if d.t[3] < 0.5 { 1.0 } else { -1.0 };
    let sharp = 0.05 + 0.2 * other(d, 5.7);
    Ok(rough(d, 1.0, 0)?.iter().map(|z| sign * z.hypot(sharp)).collect())
}

/// A finely rough ground with a few smooth grains.
fn gritty(d: &Draw) -> Heights {
    let count = 5 + (40.0 * d.t[3]) as usize;
    let (n, u) = (d.n as f64, d.uniform(4 * count, 7));
    let grains = d.points(|y, x| {
        let one = |u: &[f64]| {
            let r = d.apart(y, u[0] * n).hypot(d.apart(x, u[1] * n)) / (6.0 + 14.0 * u[2]);
            (0.5 + 3.0 * u[3]) * (-r * r).exp()
        };
        u.chunks_exact(4).map(one).sum()
    });
    Ok(mix(&rough(d, 1.0, 0)?, &grains, |z, g| 0.4 * z + g))
}

/// Rough in a band, nearly smooth beside it, at the same mean height.
fn banded(d: &Draw) -> Heights {
    let (n, calm) = (d.n as f64, 0.1 + 0.4 * other(d, 5.7));
    let wide = d.lin(3, 0.1, 0.4) * n;
    let share = d.points(|y, _| 1.0 / (1.0 + ((d.apart(y, 0.5 * n).abs() - wide) / 4.0).exp()));
    Ok(mix(&rough(d, 1.0, 0)?, &share, |z, s| (calm + (1.0 - calm) * s) * z))
}

/// One long wave along each axis under the roughness.
fn wavy(d: &Draw) -> Heights {
    let (n, height) = (d.n as f64, d.lin(3, 0.5, 4.0));
    let waves = d.points(|y, x| (TAU * x / n).cos() + 0.6 * (2.0 * TAU * y / n).cos());
    Ok(mix(&rough(d, 1.0, 0)?, &waves, |z, w| z + height * w))
}

/// Pyramids of two trains of ridges across each other, rounded, with a fine roughness.
fn knurled(d: &Draw) -> Heights {
    let (n, count) = (d.n as f64, (5.0 + 10.0 * d.t[3]).round());
    let ridges = d.points(|y, x| {
        let [a, b] = [(x + y) * count / n, (x - y) * count / n];
        softmin(triangle(a), triangle(b), 0.1)
    });
    let on_top = 0.03 + 0.2 * other(d, 5.7);
    Ok(mix(&ridges, &fine(d, 1)?, |r, f| r + on_top * f))
}

/// Bent heights on a lay.
fn bent_lay(d: &Draw) -> Heights {
    let (bend, stretch) = (d.lin(3, -0.6, 0.6), 2.0 + 4.0 * other(d, 7.3));
    Ok(rough(d, stretch, 0)?.iter().map(|z| (z.asinh() + bend).sinh()).collect())
}

/// A wide spectrum with its summits worn to a level.
fn worn_wide(d: &Draw) -> Heights {
    let level = d.lin(3, -0.5, 1.2);
    let on_top = 0.1 * other(d, 5.7);
    Ok(mix(&wide(d)?, &fine(d, 1)?, |z, f| softmin(z, level, 0.15) + on_top * f))
}

/// Ground along a lay, then lapped: its ridges flat, with the lapping's own roughness.
fn lapped_lay(d: &Draw) -> Heights {
    let level = d.lin(3, -0.3, 1.0);
    let stretch = 3.0 + 6.0 * other(d, 7.3);
    Ok(mix(&rough(d, stretch, 0)?, &fine(d, 1)?, |z, f| softmin(z, level, 0.2) + 0.08 * f))
}

/// Complementary error function to 1.2e-7 (Numerical Recipes, erfcc), enough to draw heights.
fn libm_erfc(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.5 * x.abs());
    let series = [
        -1.26551223,
        1.00002368,
        0.37409196,
        0.09678418,
        -0.18628806,
        0.27886807,
        -1.13520398,
        1.48851587,
        -0.82215223,
        0.17087277,
    ];
    let sum = series.iter().rev().fold(0.0, |sum, c| c + t * sum);
    let value = t * (-x * x + sum).exp();
    if x >= 0.0 { value } else { 2.0 - value }
}
