//! What the survey found, and what it says of a surface: how far each closed form was from the
//! deterministic area on surfaces like it.
//!
//! The rows come from `cargo xtask survey` and are kept in `crates/compare/data/survey.csv`. A surface is
//! *like* another if their measured numbers agree within the limits of [`Likeness`]; nothing is
//! fitted, so a claim is never more than a range of what was seen, with the number of surfaces
//! behind it.

use contact_accuracy::round_to_digits;
use contact_types::HeightMap;
use serde::Serialize;
use std::sync::OnceLock;

/// How a surface of the survey was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
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
    /// Nayak's bandwidth of the moments the models are given.
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
        let errors = self.errors.iter().copied();
        for value in numbers.into_iter().map(Some).chain(errors) {
            let cell = value.map_or(String::new(), |v| round_to_digits(v, 4).to_string());
            line = line + "," + &cell;
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

/// A surface at a load, as the survey sees it; fields as in [`Row`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Query {
    /// Nayak's bandwidth of the moments the models are given.
    pub bandwidth: f64,
    /// Rms gradient by finite differences over the spectral one.
    pub resolved: f64,
    /// Larger over smaller directional m2.
    pub anisotropy: f64,
    /// Skewness of the heights.
    pub skewness: f64,
    /// Kurtosis of the heights.
    pub kurtosis: f64,
    /// Height step over pixel and rms gradient; 0 without steps.
    pub step: f64,
    /// Rms slope of the highest points over that of all.
    pub peak_slope: f64,
    /// Mean pressure over E* h'_rms.
    pub load: f64,
}

impl From<&Row> for Query {
    fn from(row: &Row) -> Self {
        Self {
            bandwidth: row.bandwidth,
            resolved: row.resolved,
            anisotropy: row.anisotropy,
            skewness: row.skewness,
            kurtosis: row.kurtosis,
            step: row.step,
            peak_slope: row.peak_slope,
            load: row.load,
        }
    }
}

/// Rms slope of the highest points, twice as many as touch, over that of all of them, by forward
/// differences on the map as it repeats \[-\]. Where the top of a surface is smoother than the
/// rest, contact is larger than its moments say. 1 for a flat map.
pub fn peak_slope(map: &HeightMap, area_fraction: f64) -> f64 {
    let [ny, nx] = map.grid().shape();
    let [dy, dx] = map.grid().pixel();
    let mut sorted = map.heights().to_vec();
    let kept = ((2.0 * area_fraction * sorted.len() as f64) as usize).clamp(1, sorted.len());
    let place = sorted.len() - kept;
    let level = *sorted.select_nth_unstable_by(place, f64::total_cmp).1;
    let (mut top, mut count, mut all) = (0.0, 0.0, 0.0);
    for iy in 0..ny {
        for ix in 0..nx {
            let z = map.at(iy, ix);
            let gx = (map.at(iy, (ix + 1) % nx) - z) / dx;
            let gy = (map.at((iy + 1) % ny, ix) - z) / dy;
            let square = gx * gx + gy * gy;
            all += square;
            if z >= level {
                top += square;
                count += 1.0;
            }
        }
    }
    if all > 0.0 { ((top / count) / (all / sorted.len() as f64)).sqrt() } else { 1.0 }
}

/// How much two surfaces may differ and still count as alike. Chosen on the survey itself so that
/// ranges from other surfaces hold the error of the one left out (see the book).
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Likeness {
    /// Factor between bandwidths.
    pub bandwidth: f64,
    /// Factor between loads.
    pub load: f64,
    /// Difference of the share of the gradient that finite differences see.
    pub resolved: f64,
    /// Factor between anisotropies.
    pub anisotropy: f64,
    /// Difference of skewness.
    pub skewness: f64,
    /// Difference of kurtosis.
    pub kurtosis: f64,
    /// Difference of the height step over pixel and gradient, or a factor of 2 if larger.
    pub step: f64,
    /// Difference of the relative slope of the highest points.
    pub peak_slope: f64,
}

/// The limits the report uses.
pub const LIKENESS: Likeness = Likeness {
    bandwidth: 1.5,
    load: 1.6,
    resolved: 0.05,
    anisotropy: 1.6,
    skewness: 0.3,
    kurtosis: 0.8,
    step: 0.1,
    peak_slope: 0.08,
};

impl Likeness {
    fn accepts(&self, row: &Row, query: &Query) -> bool {
        let factor = |a: f64, b: f64| (a / b).ln().abs();
        let steps = row.step.max(query.step);
        factor(row.load, query.load) <= self.load.ln()
            && factor(row.bandwidth, query.bandwidth) <= self.bandwidth.ln()
            && (row.resolved - query.resolved).abs() <= self.resolved
            && factor(row.anisotropy, query.anisotropy) <= self.anisotropy.ln()
            && (row.skewness - query.skewness).abs() <= self.skewness
            && (row.kurtosis - query.kurtosis).abs() <= self.kurtosis
            && (row.step - query.step).abs() <= self.step.max(0.5 * steps)
            && (row.peak_slope - query.peak_slope).abs() <= self.peak_slope
    }
}

/// What a model's error was on surfaces like the one asked for.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Experience {
    /// Lowest signed relative error seen, less the bar of its reference.
    pub low: f64,
    /// Highest, plus the bar of its reference.
    pub high: f64,
    /// Distinct surfaces behind the range.
    pub surfaces: usize,
}

/// Fewest surfaces a range may stand on.
pub const FEWEST: usize = 5;

/// Model whose error follows a number of its own, the fractal dimension, more than anything
/// surfaces are compared by: ranges from like surfaces held it in 88 of 100 cases only.
const NOT_QUOTED: &str = "majumdar-bhushan";

/// The table of the survey.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    models: Vec<String>,
    rows: Vec<Row>,
}

impl Survey {
    /// The survey this version was built with.
    ///
    /// # Panics
    /// Never: a test reads the committed table.
    pub fn built_in() -> &'static Self {
        static SURVEY: OnceLock<Survey> = OnceLock::new();
        SURVEY.get_or_init(|| {
            Self::parse(include_str!("../data/survey.csv"))
                .expect("a test reads the committed table")
        })
    }

    /// Reads the table; `None` if a line is not one of its rows.
    pub fn parse(table: &str) -> Option<Self> {
        let mut lines = table.lines().filter(|line| !line.starts_with('#'));
        let models = lines.next()?.split(',').skip(12).map(str::to_owned).collect();
        let rows = lines.map(Row::parse).collect::<Option<Vec<_>>>()?;
        Some(Self { models, rows })
    }

    /// Names of the models, in the order of the errors of a row.
    pub fn models(&self) -> &[String] {
        &self.models
    }

    /// All rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The range of a model's error on surfaces like `query`; `None` if fewer than [`FEWEST`]
    /// such surfaces are in the survey, or the model is not, or likeness does not tell its error
    /// (Majumdar–Bhushan).
    pub fn ask(&self, model: &str, query: &Query) -> Option<Experience> {
        (model != NOT_QUOTED).then(|| self.ask_without(model, query, None)).flatten()
    }

    /// The same without one surface, to see whether the others would have told its error.
    pub fn ask_without(
        &self,
        model: &str,
        query: &Query,
        left_out: Option<usize>,
    ) -> Option<Experience> {
        let column = self.models.iter().position(|m| m == model)?;
        let mut range = Experience { low: f64::INFINITY, high: f64::NEG_INFINITY, surfaces: 0 };
        let mut last = None;
        for row in &self.rows {
            if Some(row.surface) == left_out || !LIKENESS.accepts(row, query) {
                continue;
            }
            let Some(error) = row.errors.get(column).copied().flatten() else { continue };
            range.low = range.low.min(error - row.bar * (1.0 + error));
            range.high = range.high.max(error + row.bar * (1.0 + error));
            range.surfaces += usize::from(last != Some(row.surface)); // rows come by surface
            last = Some(row.surface);
        }
        (range.surfaces >= FEWEST).then_some(range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(surface: usize, bandwidth: f64, error: f64) -> Row {
        Row {
            surface,
            family: Family::Gaussian,
            bandwidth,
            resolved: 0.97,
            anisotropy: 1.05,
            skewness: 0.0,
            kurtosis: 3.0,
            step: 0.0,
            peak_slope: 1.0,
            load: 0.01,
            area: 0.02,
            bar: 0.01,
            errors: vec![Some(error)],
        }
    }

    fn table(rows: &[Row]) -> String {
        let lines: Vec<String> = rows.iter().map(Row::line).collect();
        format!("# origin\n{}\n{}\n", header(&["persson"]), lines.join("\n"))
    }

    #[test]
    fn a_table_comes_back_as_it_was() {
        let mut rows: Vec<Row> = (0..3).map(|i| row(i, 5.0, -0.1)).collect();
        rows[1].errors[0] = None;
        assert_eq!(Survey::parse(&table(&rows)).unwrap().rows(), rows);
        assert!(Survey::parse("# nothing\n").is_none());
        assert!(Survey::parse(&table(&rows).replace("gaussian", "round")).is_none());
    }

    /// The committed table: every family, and every model answers its own rows.
    #[test]
    fn the_built_in_survey_is_whole() {
        let survey = Survey::built_in();
        assert!(survey.rows().len() >= 7 * 200);
        for (family, name) in Family::ALL {
            assert!(survey.rows().iter().any(|r| r.family == family), "{name}");
        }
        let query = Query::from(&survey.rows()[0]);
        for model in survey.models() {
            assert_eq!(survey.ask(model, &query).is_some(), model != NOT_QUOTED, "{model}");
        }
    }

    /// A ridge profile, smooth on top and rough below: a roof of slope 1 above a saw of slope 10.
    #[test]
    fn a_smooth_top_has_a_small_peak_slope() {
        let grid = contact_types::Grid::new([1, 64], [1.0, 1.0]).unwrap();
        let roof = |x: f64| 100.0 + 15.5 - (x - 15.5).abs();
        let saw = |x: f64| 50.0 + 10.0 * (x % 2.0);
        let map = HeightMap::from_fn(grid, |_, x| if x < 32.0 { roof(x) } else { saw(x) }).unwrap();
        assert!(peak_slope(&map, 0.1) < 0.2);
        assert!((peak_slope(&map, 0.5) - 1.0).abs() < 1e-12);
    }

    /// Five like surfaces answer with their range and the bars; a sixth of another bandwidth does
    /// not count, and four are too few.
    #[test]
    fn only_like_surfaces_speak_and_only_enough_of_them() {
        let mut rows: Vec<Row> = [-0.10, -0.12, -0.08, -0.09, -0.11]
            .iter()
            .enumerate()
            .map(|(i, e)| row(i, 5.0, *e))
            .collect();
        rows.push(row(5, 50.0, 0.9));
        let survey = Survey::parse(&table(&rows)).unwrap();
        let query = Query::from(&rows[0]);
        let seen = survey.ask("persson", &query).unwrap();
        assert_eq!(seen.surfaces, 5);
        assert!((seen.low - (-0.12 - 0.0088)).abs() < 1e-12);
        assert!((seen.high - (-0.08 + 0.0092)).abs() < 1e-12);
        assert_eq!(survey.ask_without("persson", &query, Some(0)), None);
        assert_eq!(survey.ask("unknown", &query), None);
    }
}
