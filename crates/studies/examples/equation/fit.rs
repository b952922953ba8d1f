//! The constants from the fitted surfaces: least squares in the logarithm of the argument, weighted by
//! what they change of the area, and half widths from quantiles of what is left.

use crate::table::{Row, one};
use multiscale_models::special::{erf, erf_inv};
use multiscale_models::{
    INTERVAL_TERMS, MAP_TERMS, MapEquation, NUMBER_TERMS, map_spread_terms, map_terms, number_terms,
};
use std::error::Error;
use std::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};

/// Areas above this tell nothing of the argument.
const FULL: f64 = 0.995;
/// Relative error of the area beyond which a row counts less.
const USUAL: f64 = 0.06;
/// Step of the area for slopes of w.
const NEAR: f64 = 1e-3;
/// Share of the cases of families left out that the half width is to hold: above the 95 of 100 that are stated, for
/// families differ, and one that is held worse than others is to hold still.
pub(crate) const SHARE: f64 = 0.993;
/// Area of a Gaussian surface at which the chance of few contacts is as large as the rest of the error.
const FEW: f64 = 0.025;
/// Rounds of weights.
const ROUNDS: usize = 6;

/// One equation of the least squares: what the constants multiply, what they should give, and what
/// 1 of that is in the logarithm of the area.
struct Line<const N: usize> {
    terms: [f64; N],
    wanted: f64,
    weight: f64,
    /// What it counts for beside that.
    counts: f64,
}

/// Error of the area (per cent) that is wanted of 95 of 100 cases of a family, of those of which one is stated.
fn goal(family: &str) -> Option<f64> {
    Some(match family {
        "gaussian" | "wide" | "lay" | "stepped" => 4.0,
        "bent" => 6.0,
        "worn" | "plateau-honed" | "turned" | "patchy" | "scratched" => 10.0,
        _ => return None,
    })
}

/// What a family counts for beside another: the more, the less it may be off.
fn importance(family: &str) -> f64 {
    goal(family).map_or(1.0, |goal| 15.0 / goal)
}

/// Families of isotropic Gaussian heights.
pub(crate) fn is_gaussian(row: &Row) -> bool {
    matches!(row.family.as_str(), "gaussian" | "wide")
}

/// Constants of the law for numbers.
pub(crate) fn numbers(rows: &[Row]) -> [f64; NUMBER_TERMS] {
    let mut lines = Vec::new();
    for row in rows.iter().filter(|r| is_gaussian(r)) {
        for load in row.loads.iter().filter(|l| l.area < FULL) {
            let u = erf_inv(load.area);
            let t = erf(SQRT_2 * load.x);
            lines.push(Line {
                terms: number_terms(t, row.bandwidth.ln()),
                wanted: (u / (SQRT_2 * load.x)).ln(),
                weight: sensitivity(u, load.area),
                // Few contacts are chance: they count less.
                counts: 1.0 / (1.0 + FEW / load.area).sqrt(),
            });
        }
    }
    robust(&mut lines, |_, _| {})
}

/// Constants of the law for a map.
pub(crate) fn map(rows: &[Row]) -> [f64; MAP_TERMS] {
    map_without(rows, &[])
}

/// The same with some of them 0.
pub(crate) fn map_without(rows: &[Row], left_out: &[usize]) -> [f64; MAP_TERMS] {
    let kept = |terms: [f64; MAP_TERMS]| {
        std::array::from_fn(|i| if left_out.contains(&i) { 0.0 } else { terms[i] })
    };
    let (mut lines, mut beside) = (Vec::new(), Vec::new());
    for row in rows {
        // Whatever the number of its maps.
        let alike = rows.iter().filter(|r| r.family == row.family).count() as f64;
        let part = importance(&row.family) * (rows.len() as f64 / alike).sqrt();
        for load in row.loads.iter().filter(|l| l.area < FULL) {
            let u = erf_inv(load.area);
            let log = row.bandwidth.ln();
            lines.push(Line {
                terms: kept(map_terms(load.area, &row.curves, log)),
                wanted: (u / (SQRT_2 * load.x)).ln(),
                weight: sensitivity(u, load.area),
                counts: part,
            });
            let more = kept(map_terms((load.area * (1.0 + NEAR)).min(1.0), &row.curves, log));
            beside.push((more, sensitivity(u, load.area)));
        }
    }
    // w follows the area it gives: an error of the argument counts for more where w rises.
    robust(&mut lines, |lines, c| {
        for (line, (more, plain)) in lines.iter_mut().zip(&beside) {
            let rise = (dot(more, c) - dot(&line.terms, c)) / NEAR;
            line.weight = 1.0 / (1.0 / plain - rise).max(0.15);
        }
    })
}

/// d ln A / d ln u.
fn sensitivity(u: f64, area: f64) -> f64 {
    FRAC_2_SQRT_PI * (-u * u).exp() * u / area
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Least squares in which large errors count less, rounded to 0.001.
fn robust<const N: usize>(
    lines: &mut [Line<N>],
    reweigh: impl Fn(&mut [Line<N>], &[f64; N]),
) -> [f64; N] {
    let mut trust = vec![1.0; lines.len()];
    let mut constants = [0.0; N];
    for _ in 0..ROUNDS {
        constants = least_squares(lines, &trust);
        reweigh(lines, &constants);
        for (trust, line) in trust.iter_mut().zip(lines.iter()) {
            let left = (line.wanted - dot(&line.terms, &constants)) * line.weight;
            *trust = 1.0 / (1.0 + (left / USUAL).powi(2)).sqrt();
        }
    }
    constants.map(|c| (c * 1000.0).round() / 1000.0)
}

/// By the normal equations, eliminated with the largest pivot: a dozen well-scaled unknowns.
fn least_squares<const N: usize>(lines: &[Line<N>], trust: &[f64]) -> [f64; N] {
    let mut m = [[0.0; N]; N];
    let mut v = [0.0; N];
    for (line, trust) in lines.iter().zip(trust) {
        let weight = (line.weight * trust * line.counts).powi(2);
        for i in 0..N {
            v[i] += weight * line.terms[i] * line.wanted;
            for j in 0..N {
                m[i][j] += weight * line.terms[i] * line.terms[j];
            }
        }
    }
    // What multiplies a constant that is left out is 0 everywhere: the constant stays 0.
    for (k, row) in m.iter_mut().enumerate() {
        if row[k] <= 0.0 {
            row[k] = 1.0;
        }
    }
    for k in 0..N {
        let pivot = (k..N).max_by(|a, b| m[*a][k].abs().total_cmp(&m[*b][k].abs())).unwrap_or(k);
        m.swap(k, pivot);
        v.swap(k, pivot);
        for i in k + 1..N {
            let part = m[i][k] / m[k][k];
            for j in k..N {
                m[i][j] -= part * m[k][j];
            }
            v[i] -= part * v[k];
        }
    }
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| m[k][j] * v[j]).sum();
        v[k] = (v[k] - known) / m[k][k];
    }
    v
}

/// An answer against a solution: what the half width is made of, the error in the logarithm that it is to hold (of the load
/// for a map, of the area for numbers), and the relative error of the area.
pub(crate) struct Miss<const N: usize> {
    pub(crate) family: String,
    terms: [f64; N],
    error: f64,
    pub(crate) of_area: f64,
}

/// How the law for a map with these constants misses the rows that are partly open.
pub(crate) fn misses(
    rows: &[Row],
    c: &[f64; MAP_TERMS],
) -> Result<Vec<Miss<INTERVAL_TERMS>>, Box<dyn Error>> {
    let mut list = Vec::new();
    for row in rows {
        let narrow = [0.0; INTERVAL_TERMS];
        let law = MapEquation::with_constants(row.moments(), &row.curves, one()?, (c, &narrow))?;
        for load in row.loads.iter().filter(|l| l.area < FULL) {
            list.push(Miss {
                family: row.family.clone(),
                terms: map_spread_terms(load.area, &row.curves),
                error: (load.x / law.pressure_at_area(load.area)?).ln(),
                of_area: law.area_fraction(load.x)? / load.area - 1.0,
            });
        }
    }
    Ok(list)
}

/// The same of the law for numbers, Gaussian rows only.
pub(crate) fn number_misses(rows: &[Row], c: &[f64; NUMBER_TERMS]) -> Vec<Miss<2>> {
    let mut list = Vec::new();
    for row in rows.iter().filter(|r| is_gaussian(r)) {
        for load in row.loads.iter().filter(|l| l.area < FULL) {
            let t = erf(SQRT_2 * load.x);
            let w = dot(&number_terms(t, row.bandwidth.ln()), c);
            let area = erf(SQRT_2 * load.x * w.exp());
            let open = (1.0 - area).max(0.0).sqrt();
            let terms = [open, open * (1e-3 / area.max(1e-4)).sqrt()];
            let (error, of_area) = ((load.area / area).ln(), area / load.area - 1.0);
            list.push(Miss { family: row.family.clone(), terms, error, of_area });
        }
    }
    list
}

/// Constants of a half width: the most likely ones for errors of a Laplace distribution, of which 95 %
/// lie within three times the mean; then all by one factor, so that `share` of the errors are held.
/// Every family has the same weight.
pub(crate) fn spread<const N: usize>(misses: &[Miss<N>], share: f64) -> [f64; N] {
    const LEAST: f64 = 1e-3;
    let weight = |m: &Miss<N>| 1.0 / misses.iter().filter(|o| o.family == m.family).count() as f64;
    let weights: Vec<f64> = misses.iter().map(weight).collect();
    let loss = |c: &[f64; N]| -> f64 {
        let one = |m: &Miss<N>, w: &f64| {
            let half = dot(&m.terms, c) + LEAST;
            w * (half.ln() + 3.0 * m.error.abs() / half)
        };
        misses.iter().zip(&weights).map(|(m, w)| one(m, w)).sum()
    };
    let mut c = [0.03; N];
    let mut step = 0.02;
    while step > 2e-4 {
        let (mut best, mut is_better) = ((loss(&c), c), false);
        for i in 0..N {
            for way in [-step, step] {
                let mut tried = c;
                tried[i] = f64::max(tried[i] + way, 0.0);
                let found = loss(&tried);
                if found < best.0 {
                    (best, is_better) = ((found, tried), true);
                }
            }
        }
        if !is_better {
            step *= 0.5;
        }
        c = best.1;
    }
    let mut ratios: Vec<(f64, f64)> = misses
        .iter()
        .zip(&weights)
        .map(|(m, w)| (m.error.abs() / (dot(&m.terms, &c) + 1e-12), *w))
        .collect();
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    let all: f64 = weights.iter().sum();
    let mut held = 0.0;
    let factor = ratios.iter().find(|(_, w)| {
        held += w;
        held >= share * all
    });
    c.map(|c| c * factor.map_or(1.0, |f| f.0))
}

/// Share of each family that lies within the half width.
pub(crate) fn held<const N: usize>(misses: &[Miss<N>], c: &[f64; N]) -> Vec<(String, f64)> {
    let mut counts: Vec<(String, f64, f64)> = Vec::new();
    for m in misses {
        let inside = f64::from(u8::from(m.error.abs() <= dot(&m.terms, c) + 1e-3));
        match counts.iter_mut().find(|n| n.0 == m.family) {
            Some(n) => (n.1, n.2) = (n.1 + inside, n.2 + 1.0),
            None => counts.push((m.family.clone(), inside, 1.0)),
        }
    }
    counts.into_iter().map(|(name, inside, all)| (name, inside / all)).collect()
}

/// How the law misses families that took no part: each is left out in turn, and the constants are fitted to the
/// others.
pub(crate) fn left_out(rows: &[Row]) -> Result<Vec<Miss<INTERVAL_TERMS>>, Box<dyn Error>> {
    let mut names: Vec<&str> = rows.iter().map(|r| r.family.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let mut list = Vec::new();
    for name in names {
        let (out, rest): (Vec<Row>, Vec<Row>) =
            rows.iter().cloned().partition(|r| r.family == name);
        list.extend(misses(&out, &map(&rest))?);
    }
    Ok(list)
}
