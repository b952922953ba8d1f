//! Errors of closed forms where there is no map: what they were on isotropic Gaussian surfaces of like bandwidth at
//! like loads, 107 surfaces with deterministic solutions on twice the points.

use std::sync::OnceLock;

/// Bandwidths and loads within these factors are similar.
pub const SIMILAR: [f64; 2] = [1.5, 1.6];
/// Fewest surfaces that a range is quoted from.
const FEWEST: usize = 5;

/// One surface at one load.
struct SurveyRow {
    surface: u32,
    bandwidth: f64,
    load: f64,
    uncertainty: f64,
    /// Of each model.
    errors: Vec<f64>,
}

impl SurveyRow {
    fn parse(line: &str) -> Option<Self> {
        let (surface, numbers) = line.split_once(',')?;
        let mut numbers = numbers.split(',').map(|cell| cell.parse().ok());
        Some(Self {
            surface: surface.parse().ok()?,
            bandwidth: numbers.next()??,
            load: numbers.next()??,
            uncertainty: numbers.next()??,
            errors: numbers.collect::<Option<_>>()?,
        })
    }
}

struct Survey {
    models: Vec<&'static str>,
    rows: Vec<SurveyRow>,
}

fn built_in() -> &'static Survey {
    static SURVEY: OnceLock<Survey> = OnceLock::new();
    SURVEY.get_or_init(|| {
        let mut lines = include_str!("../data/survey.csv").lines().filter(|l| !l.starts_with('#'));
        let models = lines.next().unwrap_or_default().split(',').skip(4).collect();
        let rows = lines.map(SurveyRow::parse).collect::<Option<Vec<_>>>();
        Survey { models, rows: rows.expect("a test reads the committed table") }
    })
}

/// Signed relative error of a model's area, `[lowest, highest]` with the uncertainty of its reference, and on how many
/// surfaces of similar `bandwidth` \[-\] at similar `load` p/(E\* h′rms) \[-\];
/// `None` if there are fewer than five, or the model is none of those of the study.
pub fn gaussian_errors(model: &str, bandwidth: f64, load: f64) -> Option<([f64; 2], usize)> {
    let survey = built_in();
    let column = survey.models.iter().position(|m| *m == model)?;
    let near = |a: f64, b: f64, factor: f64| (a / b).ln().abs() <= factor.ln();
    let (mut low, mut high, mut surfaces) = (f64::INFINITY, f64::NEG_INFINITY, 0);
    let mut last = None;
    for row in &survey.rows {
        let is_near = near(row.bandwidth, bandwidth, SIMILAR[0]);
        if !(is_near && near(row.load, load, SIMILAR[1])) {
            continue;
        }
        let error = row.errors[column];
        let reference = row.uncertainty * (1.0 + error);
        (low, high) = (low.min(error - reference), high.max(error + reference));
        surfaces += usize::from(last != Some(row.surface)); // rows come by surface
        last = Some(row.surface);
    }
    (surfaces >= FEWEST).then_some(([low, high], surfaces))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Inputs, find};
    use contact_types::{ContactModulus, SpectralMoments};

    /// Every model of the table answers at the middle of it, and none where no surface is near.
    #[test]
    fn the_table_is_whole() {
        let survey = built_in();
        assert_eq!(survey.rows.len(), 7 * 107);
        let of_all = |row: &SurveyRow| row.errors.len() == survey.models.len();
        assert!(survey.rows.iter().all(of_all));
        assert!(survey.rows.iter().flat_map(|row| &row.errors).all(|error| error.is_finite()));
        for model in &survey.models {
            let ([low, high], surfaces) = gaussian_errors(model, 5.0, 0.03).expect("surfaces");
            assert!(low < high && surfaces >= 20, "{model}: {low} {high} {surfaces}");
            for (bandwidth, load) in [(5000.0, 0.03), (5.0, 10.0), (f64::NAN, 0.03), (0.0, 0.03)] {
                assert_eq!(gaussian_errors(model, bandwidth, load), None, "{model}");
            }
        }
        assert_eq!(gaussian_errors("archard", 5.0, 0.03), None);
    }

    /// Areas over the deterministic one, 1 + error, are in proportion to those of the models today.
    #[test]
    fn the_errors_are_those_of_the_models_as_they_are() {
        let modulus = ContactModulus::from_pascals(1.0).unwrap();
        let survey = built_in();
        let error = |row: &SurveyRow, model: &str| {
            row.errors[survey.models.iter().position(|m| *m == model).unwrap()]
        };
        for row in &survey.rows {
            let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 0.25 * row.bandwidth };
            let inputs = Inputs { moments: Some(moments), ..Inputs::new(modulus) };
            let area = |model: &str| {
                let model = find(model).unwrap().build(&inputs).unwrap();
                model.at_pressure(row.load).unwrap().area_fraction
            };
            let persson = area("persson") / (1.0 + error(row, "persson"));
            for model in ["gw", "bgt", "greenwood-elliptical", "equation"] {
                let reference = area(model) / (1.0 + error(row, model));
                assert!((reference / persson - 1.0).abs() < 5e-3, "{model}: {reference} {persson}");
            }
        }
    }
}
