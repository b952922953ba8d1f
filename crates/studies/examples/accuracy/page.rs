//! Figure and tables of the book, from the table of the check.

use crate::ensemble::Family;
use crate::measure::Mode;
use contact_accuracy::quantile;
use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::Path;
use studies::figures::accuracy::write_accuracy;

/// One request on one surface at one load.
struct Row {
    surface: String,
    family: String,
    mode: Mode,
    load: f64,
    request: f64,
    claimed: bool,
    error: f64,
    /// Error and half width of the load that belongs to a given gap, or of the gap at a given load.
    other: [Option<f64>; 2],
    factor: f64,
    given_up: f64,
    work: f64,
    default: f64,
    reason: String,
}

/// Writes `accuracy.svg` and `accuracy.md` into `folder`.
pub(crate) fn write(table: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(table)?;
    let lines = text.lines().filter(|l| !l.starts_with('#')).skip(1);
    let rows: Vec<Row> = lines.map(parse).collect::<Option<_>>().ok_or("no table of the check")?;
    fs::create_dir_all(folder)?;
    let claimed = rows.iter().filter(|r| r.claimed).map(|r| [r.request, r.error.abs()]);
    let claimed: Vec<[f64; 2]> = claimed.collect();
    write_accuracy(&claimed, &mut File::create(folder.join("accuracy.svg"))?)?;
    fs::write(folder.join("accuracy.md"), tables(&rows))?;
    Ok(())
}

fn parse(line: &str) -> Option<Row> {
    let cells: Vec<&str> = line.split(',').collect();
    let number = |k: usize| cells.get(k)?.parse::<f64>().ok();
    Some(Row {
        surface: (*cells.first()?).to_owned(),
        family: (*cells.get(1)?).to_owned(),
        mode: Mode::ALL.into_iter().find(|m| cells.get(3) == Some(&m.name()))?,
        load: number(4)?,
        request: number(7)?,
        claimed: *cells.get(8)? == "1",
        error: number(10)?,
        other: [number(11), number(12)],
        factor: number(13)?,
        given_up: number(14)?,
        work: number(15)?,
        default: number(16)?,
        reason: (*cells.get(17)?).to_owned(),
    })
}

fn tables(rows: &[Row]) -> String {
    let mut requests: Vec<f64> = rows.iter().map(|r| r.request).collect();
    requests.sort_by(|a, b| b.total_cmp(a));
    requests.dedup();
    let mut surfaces: Vec<&str> = rows.iter().map(|r| r.surface.as_str()).collect();
    surfaces.sort_unstable();
    surfaces.dedup();
    let mut page = format!("{} surfaces, {} requests.\n", surfaces.len(), rows.len());
    for mode in Mode::ALL {
        let these: Vec<&Row> = rows.iter().filter(|r| r.mode == mode).collect();
        page.push_str(&by_request(mode, &these, &requests));
    }
    page.push_str("\nWhere it says no, and why:\n\n| asked for | stepped | unresolved | spots too small for any grid |\n|---|---|---|---|\n");
    for request in &requests {
        let count = |why: &str| {
            rows.iter().filter(|r| r.request.total_cmp(request).is_eq() && r.reason == why).count()
        };
        let [stepped, unresolved, spots] = ["stepped", "unresolved", "spots"].map(count);
        let _ = writeln!(
            page,
            "| {} % | {stepped} | {unresolved} | {spots} |",
            digits(100.0 * request)
        );
    }
    page.push_str(
        "\nOf the answers of all three that claim to meet their request, met:\n\n| surfaces |",
    );
    let mut loads: Vec<f64> = rows.iter().map(|r| r.load).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    for load in &loads {
        let _ = write!(page, " p = {load} E\\* h′rms |");
    }
    let _ = writeln!(page, "\n|---|{}", "---|".repeat(loads.len()));
    for family in Family::ALL {
        let _ = write!(page, "| {} |", family.name());
        for load in &loads {
            let these: Vec<&Row> = rows
                .iter()
                .filter(|r| {
                    r.claimed && r.family == family.name() && r.load.total_cmp(load).is_eq()
                })
                .collect();
            let _ = write!(page, " {} |", share(&these));
        }
        page.push('\n');
    }
    page
}

/// The requests of one kind: what was claimed, what was met, and what it cost.
fn by_request(mode: Mode, rows: &[&Row], requests: &[f64]) -> String {
    let what = match mode {
        Mode::Pressure => "**Mean pressure given.**",
        Mode::Gap => "**Mean gap given**, that of the truth at the same pressures.",
        Mode::Isolated => "**Isolated contact**, mean pressure given.",
    };
    let mut page = format!(
        "\n{what}{}\n\n\
         | asked for | cases | claimed | of these met | median error | coarsened / as given / \
         refined | work over default, median (range of nine in ten) | a grid given up |\n\
         |---|---|---|---|---|---|---|---|\n",
        others(mode, rows)
    );
    for request in requests {
        let all = rows.iter().filter(|r| r.request.total_cmp(request).is_eq());
        let all: Vec<&Row> = all.copied().collect();
        let claimed: Vec<&Row> = all.iter().copied().filter(|r| r.claimed).collect();
        let errors = sorted(claimed.iter().map(|r| r.error.abs()));
        let work = sorted(claimed.iter().map(|r| r.work / r.default));
        let factors = [
            claimed.iter().filter(|r| r.factor < 1.0).count(),
            claimed.iter().filter(|r| (r.factor - 1.0).abs() < 1e-9).count(),
            claimed.iter().filter(|r| r.factor > 1.0).count(),
        ];
        let at = |list: &[f64], part: f64| quantile(list, part).unwrap_or(f64::NAN);
        // Writing to a String cannot fail.
        let _ = writeln!(
            page,
            "| {} % | {} | {} | {} | {} % | {} / {} / {} | {} ({} to {}) | {} |",
            digits(100.0 * request),
            all.len(),
            claimed.len(),
            share(&claimed),
            digits(100.0 * at(&errors, 0.5)),
            factors[0],
            factors[1],
            factors[2],
            digits(at(&work, 0.5)),
            digits(at(&work, 0.05)),
            digits(at(&work, 0.95)),
            claimed.iter().filter(|r| r.given_up > 0.0).count()
        );
    }
    page
}

/// How often the interval of the other number held, claimed or not.
fn others(mode: Mode, rows: &[&Row]) -> String {
    let bars = rows.iter().filter_map(|r| Some([r.other[0]?.abs(), r.other[1]?]));
    let bars: Vec<[f64; 2]> = bars.collect();
    if bars.is_empty() {
        return String::new();
    }
    let held = bars.iter().filter(|[error, half]| error <= half).count();
    let half = quantile(&sorted(bars.iter().map(|b| b[1])), 0.5).unwrap_or(f64::NAN);
    let (number, scale) = match mode {
        Mode::Gap => ("mean pressure found", ""),
        _ => ("mean gap", " of the rms height"),
    };
    format!(
        " The interval of the {number} held in {held} of {} answers that have one, ±{} %{scale} in \
         the median.",
        bars.len(),
        digits(100.0 * half)
    )
}

/// How many errors are within their request.
fn share(rows: &[&Row]) -> String {
    if rows.is_empty() {
        return "–".to_owned();
    }
    let met = rows.iter().filter(|r| r.error.abs() <= r.request).count();
    format!("{met} of {} ({:.1} %)", rows.len(), 100.0 * met as f64 / rows.len() as f64)
}

fn sorted(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
}

/// Two significant digits.
fn digits(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let decade = if value > 0.0 { value.log10().floor() as i32 } else { 0 };
    format!("{value:.*}", usize::try_from(1 - decade).unwrap_or(0))
}
