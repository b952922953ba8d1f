//! One map: what it tells cheaply, and its deterministic solution over the loads.

use crate::families::Case;
use contact_accuracy::round_to_digits;
use contact_types::{
    CURVE_LEVELS, CURVE_SHARES, ContactModulus, HeightMap, PartCurve, SpectralMoments,
};
use fft_bem_solver::{BOUNDARY_CORRECTION, Load, Solver};
use std::error::Error;
use std::fmt::Write as _;
use surface_stats::clean::resample;
use surface_stats::spectrum::{PowerSpectrum, Window};
use surface_stats::{DirectionalMoments, Edges, HeightStatistics, contact_curves, height_step};

const MODULUS: f64 = 1e11;
/// Relative rms pressure error to reach.
const TOLERANCE: f64 = 3e-4;
/// Part of the contact-line correction that is left as uncertainty.
const LEFT_OVER: f64 = 0.3;
/// The lighter loads, solved on twice as many points along each side: beyond them, above 53 % on Gaussian surfaces, the
/// half width of the grid error is about 1 % and less.
const REFINED: usize = 7;
/// Loads p/(E* g): areas of 0.1 to 99 % on Gaussian surfaces.
pub(crate) const LOADS: [f64; 9] = [0.0005, 0.0016, 0.005, 0.015, 0.045, 0.12, 0.3, 0.65, 1.2];

/// Names of the curves over the highest part, in the order of [`ContactCurves`](contact_types::ContactCurves).
const PARTS: [&str; 11] = ["s", "e", "r", "q", "qe", "qp", "sp", "ce", "cd", "cp", "lv"];

/// First line of the table.
pub(crate) fn header() -> String {
    let mut line = String::from("family,seed,n,hurst,alpha,alpha_fd,ratio,step,skew,kurtosis,g_fd");
    for (name, levels) in PARTS.map(|c| (c, CURVE_LEVELS)).into_iter().chain([("f", CURVE_SHARES)])
    {
        for k in 0..levels {
            let _ = write!(line, ",{name}{k}");
        }
    }
    for k in 0..LOADS.len() {
        let _ = write!(line, ",x{k},area{k},bar{k},gap{k},given{k}");
    }
    line
}

fn add(line: &mut String, value: f64) {
    let _ = write!(line, ",{}", round_to_digits(value, 6));
}

/// What a map tells: the first part of its line.
pub(crate) fn tells(case: &Case) -> Result<String, Box<dyn Error>> {
    let map = case.map()?;
    let (moments, _) = PowerSpectrum::of(&map, Window::None)?.moments();
    let rms = moments.rms_height();
    let differences = DirectionalMoments::of(&map, Edges::Periodic)?;
    let seen = differences.isotropic(rms * rms);
    let (gradient, by_points) = (moments.rms_gradient(), seen.rms_gradient());
    let [_, dx] = map.grid().pixel();
    let heights = HeightStatistics::of(&map);
    let curves = contact_curves(&map, Edges::Periodic).ok_or("a flat map")?;
    let fixed = [
        moments.bandwidth(),
        seen.bandwidth(),
        differences.anisotropy().ok_or("a flat map")?.sqrt(),
        height_step(map.heights()).map_or(0.0, |q| q / (by_points * dx)),
        heights.skewness.unwrap_or(0.0),
        heights.kurtosis.unwrap_or(3.0),
        by_points / gradient,
    ];
    let mut line = format!(
        "{},{},{},{}",
        case.family.name,
        case.draw.seed,
        case.draw.n,
        round_to_digits(case.draw.t[0], 4)
    );
    let over: [PartCurve; PARTS.len()] = [
        curves.slope,
        curves.evenness,
        curves.resolved,
        curves.pressure,
        curves.pressure_evenness,
        curves.pressed,
        curves.pressed_slope,
        curves.curvature_evenness,
        curves.curvature_difference,
        curves.curvature_product,
        curves.level,
    ];
    for value in fixed.into_iter().chain(over.into_iter().flatten()).chain(curves.flattened) {
        add(&mut line, value);
    }
    Ok(line)
}

/// Moments by differences.
pub(crate) fn moments(map: &HeightMap) -> Result<SpectralMoments, Box<dyn Error>> {
    let rms = HeightStatistics::of(map).rms_height;
    Ok(DirectionalMoments::of(map, Edges::Periodic)?.isotropic(rms * rms))
}

/// Corrected areas at these loads on the given points.
pub(crate) fn areas(map: &HeightMap, loads: &[f64]) -> Result<Vec<f64>, Box<dyn Error>> {
    Ok(solved(map, map, loads)?.into_iter().map(|[area, ..]| area).collect())
}

/// On `map`, which may have more points than `given`: for each load over E\* g of `given` the corrected area, what is left of
/// its correction, and the mean gap over the rms height.
fn solved(
    map: &HeightMap,
    given: &HeightMap,
    loads: &[f64],
) -> Result<Vec<[f64; 3]>, Box<dyn Error>> {
    let modulus = ContactModulus::from_pascals(MODULUS)?;
    let moments = moments(given)?;
    let mut solver =
        Solver::builder().tolerance(TOLERANCE).threads(1).build(map.grid(), modulus)?;
    let mut list = Vec::new();
    for x in loads {
        let pressure = x * MODULUS * moments.rms_gradient();
        let found = solver.solve(map, Load::MeanPressure(pressure))?;
        let d = &found.diagnostics;
        let bar = LEFT_OVER * BOUNDARY_CORRECTION * d.contact_perimeter;
        let gap = found.state.mean_gap.ok_or("no mean gap")?;
        list.push([d.area_fraction_corrected, bar, gap / moments.rms_height()]);
    }
    Ok(list)
}

/// Its deterministic solutions: the rest of the line. The area with its half width on the finer grid where there is
/// one; the mean gap, and the area again, on the given one.
pub(crate) fn solutions(case: &Case) -> Result<String, Box<dyn Error>> {
    let map = case.map()?;
    let given = solved(&map, &map, &LOADS)?;
    // What lies between the points of a map in steps, or with noise from point to point, is not known: the points are the
    // surface.
    let by_points = ["stepped", "quantised", "noisy", "noisy-worn", "noisy-lay", "spiked"];
    let finer = if by_points.contains(&case.family.name) {
        Vec::new()
    } else {
        let shape = map.grid().shape().map(|n| 2 * n);
        solved(&resample(&map, shape, Edges::Periodic)?, &map, &LOADS[..REFINED])?
    };
    let mut line = String::new();
    for (k, x) in LOADS.into_iter().enumerate() {
        let [area, bar, _] = *finer.get(k).unwrap_or(&given[k]);
        for value in [x, area, bar, given[k][2], given[k][0]] {
            add(&mut line, value);
        }
    }
    Ok(line)
}
