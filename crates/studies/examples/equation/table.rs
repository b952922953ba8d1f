//! The rows of the tables: a map with what it tells, and its solutions.

use crate::measure::{LOADS, header};
use contact_types::{CURVE_LEVELS, CURVE_SHARES, ContactCurves, ContactModulus, SpectralMoments};
use multiscale_models::MapCurves;
use std::error::Error;
use std::fs;
use std::path::Path;

/// One map.
#[derive(Debug, Clone)]
pub(crate) struct Row {
    pub(crate) family: String,
    /// Nayak's bandwidth by differences \[-\].
    pub(crate) bandwidth: f64,
    /// Ratio of rms slopes across and along the lay.
    pub(crate) ratio: f64,
    pub(crate) skewness: f64,
    pub(crate) curves: MapCurves,
    pub(crate) loads: Vec<Load>,
}

/// One solution.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Load {
    /// p/(E* g).
    pub(crate) x: f64,
    pub(crate) area: f64,
    /// Half width of its grid error: 0.3 of the correction for the contact line or what twice the points moved,
    /// whichever is larger.
    pub(crate) bar: f64,
    /// The area on the given grid.
    pub(crate) given: f64,
}

impl Row {
    fn parse(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split(',').collect();
        let numbers: Option<Vec<f64>> = cells[1..].iter().map(|c| c.parse().ok()).collect();
        let numbers = numbers?;
        let (fixed, rest) = numbers.split_at_checked(10)?;
        let mut rest = rest;
        let mut part = || {
            let (curve, after) = rest.split_first_chunk::<CURVE_LEVELS>()?;
            rest = after;
            Some(*curve)
        };
        // In the order of `measure::header`.
        let curves = ContactCurves {
            slope: part()?,
            evenness: part()?,
            resolved: part()?,
            pressure: part()?,
            pressure_evenness: part()?,
            pressed: part()?,
            pressed_slope: part()?,
            curvature_evenness: part()?,
            curvature_difference: part()?,
            curvature_product: part()?,
            level: part()?,
            flattened: *rest.first_chunk::<CURVE_SHARES>()?,
        };
        let loads = &rest[CURVE_SHARES..];
        (loads.len() == 5 * LOADS.len()).then_some(())?;
        let curves = MapCurves::new(&curves).ok()?;
        // As in the survey: what is left of the correction, or what refining moved.
        let bar = |l: &[f64]| l[2].max((l[1] - l[4]).abs());
        let load = |l: &[f64]| Load { x: l[0], area: l[1], bar: bar(l), given: l[4] };
        Some(Self {
            family: cells[0].into(),
            bandwidth: fixed[4],
            ratio: fixed[5],
            skewness: fixed[7],
            curves,
            loads: loads.chunks_exact(5).map(load).collect(),
        })
    }

    /// Moments of gradient 1 and this bandwidth, for a modulus of 1 Pa: pressures are loads.
    pub(crate) fn moments(&self) -> SpectralMoments {
        SpectralMoments { m0: 1.0, m2: 0.5, m4: 0.25 * self.bandwidth }
    }
}

/// A modulus of 1 Pa.
pub(crate) fn one() -> Result<ContactModulus, Box<dyn Error>> {
    Ok(ContactModulus::from_pascals(1.0)?)
}

/// The maps of a table.
pub(crate) fn read(table: &Path) -> Result<Vec<Row>, Box<dyn Error>> {
    let text = fs::read_to_string(table)?;
    let mut lines = text.lines().filter(|l| !l.starts_with('#'));
    if lines.next() != Some(header().as_str()) {
        return Err(format!("{} has another header", table.display()).into());
    }
    lines.map(|l| Row::parse(l).ok_or_else(|| format!("cannot read '{l}'").into())).collect()
}
