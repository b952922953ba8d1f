//! What the book says of the survey, from its table: figures and the summary.

use compare::find;
use compare::survey::{Family, Query, Row, Survey};
use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::Path;
use studies::figures::survey::{write_survey_map, write_survey_slopes};

/// Loads of the summary.
const SHOWN: [f64; 3] = [0.003, 0.03, 0.2];

/// Writes `survey-map.svg`, `survey-slopes.svg` and `survey.md` into `folder`.
pub(crate) fn write(table: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(table)?;
    let survey = Survey::parse(&text).ok_or("the table of the survey cannot be read")?;
    fs::create_dir_all(folder)?;
    write_survey_map(&survey, &mut File::create(folder.join("survey-map.svg"))?)?;
    write_survey_slopes(&survey, &mut File::create(folder.join("survey-slopes.svg"))?)?;
    fs::write(folder.join("survey.md"), bars(&survey) + &summary(&survey) + &check(&survey))?;
    Ok(())
}

/// How well the reference is known, which is what no error of a model can be read below.
fn bars(survey: &Survey) -> String {
    let mut page = String::from(
        "Half width of the reference (%), median and largest:\n\n| load p/(E\\* h′rms) |",
    );
    let loads = || survey.rows().iter().take_while(|r| r.surface == 0).map(|r| r.load);
    for load in loads() {
        let _ = write!(page, " {load} |");
    }
    let _ = write!(page, "\n|---|{}\n| ± |", "---|".repeat(loads().count()));
    for load in loads() {
        let same = |r: &&Row| (r.load / load - 1.0).abs() < 1e-6;
        let mut bars: Vec<f64> = survey.rows().iter().filter(same).map(|r| r.bar).collect();
        bars.sort_by(f64::total_cmp);
        let largest = bars.last().copied().unwrap_or(f64::NAN);
        let _ = write!(page, " {:.1}, {:.1} |", 100.0 * bars[bars.len() / 2], 100.0 * largest);
    }
    page + "\n\nMedian error (%) and, in brackets, the range from 5 to 95 % of the surfaces; n where \
            a model answers on some of them only:\n\n"
}

/// Median and 5 to 95 % range of each model's error, by family and load.
fn summary(survey: &Survey) -> String {
    let mut page = String::from("| surfaces | load p/(E\\* h′rms) |");
    let labels: Vec<_> = survey
        .models()
        .iter()
        .map(|m| find(m).map_or(m.as_str(), |e| e.card().label.as_ref()))
        .collect();
    for label in &labels {
        let _ = write!(page, " {label} |");
    }
    page.push_str("\n|---|---|");
    page.push_str(&"---|".repeat(labels.len()));
    page.push('\n');
    for (family, words) in [
        (Family::Gaussian, "Gaussian"),
        (Family::Skewed, "skewed"),
        (Family::Anisotropic, "with a lay"),
        (Family::Stepped, "stepped"),
    ] {
        for load in SHOWN {
            let rows: Vec<&Row> = survey
                .rows()
                .iter()
                .filter(|r| r.family == family && (r.load / load - 1.0).abs() < 1e-6)
                .collect();
            let _ = write!(page, "| {words} ({}) | {load} |", rows.len());
            for column in 0..labels.len() {
                let mut errors: Vec<f64> = rows.iter().filter_map(|r| r.errors[column]).collect();
                errors.sort_by(f64::total_cmp);
                let at = |part: f64| errors[(part * (errors.len() - 1) as f64).round() as usize];
                let mut cell = if errors.is_empty() {
                    "–".into()
                } else {
                    format!("{} ({} to {})", percent(at(0.5)), percent(at(0.05)), percent(at(0.95)))
                };
                if errors.len() < rows.len() {
                    let _ = write!(cell, ", n = {}", errors.len());
                }
                let _ = write!(page, " {cell} |");
            }
            page.push('\n');
        }
    }
    page
}

fn percent(error: f64) -> String {
    format!("{:+.0}", 100.0 * error).replace('-', "\u{2212}")
}

/// Every surface left out once: how often the others tell its error.
fn check(survey: &Survey) -> String {
    let mut page = String::from(
        "\nEach surface left out once, and the others asked:\n\n\
         | model | asked | answered | range held the error | median width of the range |\n\
         |---|---|---|---|---|\n",
    );
    for (column, model) in survey.models().iter().enumerate() {
        let (mut asked, mut held, mut widths) = (0, 0, Vec::new());
        for row in survey.rows() {
            let Some(error) = row.errors[column] else { continue };
            asked += 1;
            let Some(seen) = survey.ask_without(model, &Query::from(row), Some(row.surface)) else {
                continue;
            };
            held += usize::from((seen.low..=seen.high).contains(&error));
            widths.push(seen.high - seen.low);
        }
        widths.sort_by(f64::total_cmp);
        let answered = widths.len();
        let Some(width) = widths.get(answered / 2) else { continue };
        let _ = writeln!(
            page,
            "| {} | {asked} | {answered} | {held} ({:.1} %) | {:.0} points |",
            find(model).map_or(model.as_str(), |e| e.card().label.as_ref()),
            100.0 * held as f64 / answered as f64,
            100.0 * width
        );
    }
    page
}
