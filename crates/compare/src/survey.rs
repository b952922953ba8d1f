//! What the survey found, and what it says of a surface: how far each closed form was from the
//! deterministic area on surfaces like it.
//!
//! The rows come from `cargo xtask survey` and are kept in `fixtures/survey.csv`. A surface is
//! *like* another if their measured numbers agree within the limits of [`Likeness`]; nothing is
//! fitted, so a claim is never more than a range of what was seen, with the number of surfaces
//! behind it.

use std::fmt::Write as _;

/// How a surface of the survey was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// Isotropic, Gaussian.
    Gaussian,
    /// Isotropic, heights bent to skewness and heavier or lighter tails.
    Skewed,
    /// Gaussian with a lay.
    Anisotropic,
    /// Isotropic, Gaussian, heights rounded to steps.
    Stepped,
}

impl Family {
    const ALL: [(Self, &'static str); 4] = [
        (Self::Gaussian, "gaussian"),
        (Self::Skewed, "skewed"),
        (Self::Anisotropic, "anisotropic"),
        (Self::Stepped, "stepped"),
    ];

    /// Name in the table.
    #[allow(clippy::missing_panics_doc, reason = "every variant is in the list")]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(f, _)| *f == self).expect("every family is listed").1
    }

    fn of(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(_, n)| *n == name).map(|(f, _)| *f)
    }
}

/// One surface at one load.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Number of the surface.
    pub surface: usize,
    /// How it was made.
    pub family: Family,
    /// Nayak's bandwidth, spectral.
    pub bandwidth: f64,
    /// Rms gradient by finite differences over the spectral one.
    pub resolved: f64,
    /// Larger over smaller directional m2.
    pub anisotropy: f64,
    /// Skewness of the heights.
    pub skewness: f64,
    /// Kurtosis of the heights (3 for a Gaussian).
    pub kurtosis: f64,
    /// Height step over pixel and rms gradient; 0 without steps.
    pub step: f64,
    /// Rms slope of the highest points (twice the contact area) over that of all.
    pub peak_slope: f64,
    /// Mean pressure over E* h'_rms.
    pub load: f64,
    /// Deterministic area fraction, corrected, on twice the points.
    pub area: f64,
    /// Relative half width of that area.
    pub bar: f64,
    /// Signed relative error of each model; `None` where it gave no answer.
    pub errors: Vec<Option<f64>>,
}

/// First line of the table.
pub fn header(models: &[&str]) -> String {
    let fixed = "surface,family,bandwidth,resolved,anisotropy,skewness,kurtosis,step,peak_slope,\
                 load,area,bar";
    format!("{fixed},{}", models.join(","))
}

impl Row {
    /// The row as a line of the table, four digits each.
    pub fn line(&self) -> String {
        let mut line = format!("{},{}", self.surface, self.family.name());
        let numbers = [
            self.bandwidth,
            self.resolved,
            self.anisotropy,
            self.skewness,
            self.kurtosis,
            self.step,
            self.peak_slope,
            self.load,
            self.area,
            self.bar,
        ];
        // Writing to a String cannot fail.
        for value in numbers {
            let _ = write!(line, ",{}", four(value));
        }
        for error in &self.errors {
            let _ = write!(line, ",{}", error.map_or(String::new(), four));
        }
        line
    }

    fn parse(line: &str) -> Option<Self> {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| cells.get(k)?.parse::<f64>().ok();
        Some(Self {
            surface: cells.first()?.parse().ok()?,
            family: Family::of(cells.get(1)?)?,
            bandwidth: number(2)?,
            resolved: number(3)?,
            anisotropy: number(4)?,
            skewness: number(5)?,
            kurtosis: number(6)?,
            step: number(7)?,
            peak_slope: number(8)?,
            load: number(9)?,
            area: number(10)?,
            bar: number(11)?,
            errors: cells.get(12..)?.iter().map(|c| c.parse().ok()).collect(),
        })
    }
}

/// Four significant digits, without an exponent where a plain number is short.
fn four(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().expect("a formatted number parses");
    format!("{rounded}")
}
