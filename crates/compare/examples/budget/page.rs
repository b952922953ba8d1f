//! What the book says of the study, from its tables: how often each stated interval held.

use crate::ensemble::{CLASSES, make, recipes};
use crate::realisations::FAMILIES;
use compare::budget::{Map, grid, iteration, sample};
use compare::report::{BarErrors, write_budget};
use fft_bem_solver::{BOUNDARY_CORRECTION, NoAreaInterval};
use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::Path;

/// A table read by the names of its columns.
pub(crate) struct Table {
    names: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let text = fs::read_to_string(path)?;
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<String>>();
        let names = cells(lines.next().ok_or("an empty table")?);
        Ok(Self { names, rows: lines.map(cells).collect() })
    }

    /// A number by row and column.
    fn get(&self, row: usize, column: &str) -> f64 {
        let place = self.names.iter().position(|n| n == column);
        place.and_then(|k| self.rows[row].get(k)?.parse().ok()).unwrap_or(f64::NAN)
    }
}

/// What is stated about one answer and what was true: half width and error over value.
struct Case {
    class: &'static str,
    /// Why the plain bar is refused, in a word.
    gate: Result<(), &'static str>,
    /// Of the area, plain: error and half width, relative to the area.
    area: [f64; 2],
    /// Of the area with the bar of the twice finer grid.
    refined: [f64; 2],
    gap: [f64; 2],
    stiffness: [f64; 2],
}

/// Writes `budget.svg` and `budget.md` into `folder`.
pub(crate) fn write(surfaces: &Path, sample: &Path, folder: &Path) -> Result<(), Box<dyn Error>> {
    let table = Table::read(surfaces)?;
    let cases = cases(&table)?;
    fs::create_dir_all(folder)?;
    let group = |title, value: fn(&Case) -> [f64; 2]| {
        let classes = CLASSES.iter().map(|&(_, _, class)| BarErrors {
            class: class.to_owned(),
            ratios: stated(&cases, class).map(|c| value(c)[0] / value(c)[1]).collect(),
        });
        (title, classes.collect::<Vec<_>>())
    };
    let groups = [
        group("Area", |c| c.area),
        group("Mean gap", |c| c.gap),
        group("Stiffness", |c| c.stiffness),
    ];
    write_budget(&groups, &mut File::create(folder.join("budget.svg"))?)?;
    let sample = Table::read(sample)?;
    let page = by_class(&cases) + &outside(&cases) + &early(&table) + &realisations(&sample);
    fs::write(folder.join("budget.md"), page)?;
    Ok(())
}

/// Cases inside the gate.
fn stated<'a>(cases: &'a [Case], class: &'a str) -> impl Iterator<Item = &'a Case> {
    cases.iter().filter(move |c| c.class == class && c.gate.is_ok())
}

fn cases(table: &Table) -> Result<Vec<Case>, Box<dyn Error>> {
    let recipes = recipes();
    let mut known: Option<(usize, Map)> = None;
    let mut cases = Vec::new();
    for row in 0..table.rows.len() {
        let surface = table.get(row, "surface") as usize;
        let map = match known {
            Some((index, map)) if index == surface => map,
            _ => Map::of(&make(&recipes[surface], 1)?)?,
        };
        known = Some((surface, map));
        cases.push(case(table, row, recipes[surface].name, &map));
    }
    Ok(cases)
}

fn corrected(table: &Table, row: usize, grid: &str) -> [f64; 2] {
    let correction = BOUNDARY_CORRECTION * table.get(row, &format!("edges{grid}"));
    [table.get(row, &format!("count{grid}")) - correction, correction]
}

fn case(table: &Table, row: usize, class: &'static str, map: &Map) -> Case {
    let get = |column: &str| table.get(row, column);
    let [[given, line], [twice, finer_line], [fine, _]] =
        ["1", "2", "4"].map(|grid| corrected(table, row, grid));
    // The corrected area is of first order: what the last refinement changed is left once more.
    let truth = fine + (fine - twice);
    let residual = get("residual_e4");
    let plain = map.accuracy.half_width_of(get("count1"), get("edges1"));
    let left = iteration::area_error(residual);
    let left_over = fft_bem_solver::left_of_correction(map.accuracy.directions);
    let finer = grid::Finer { area: twice, correction: finer_line, gap: None, left_over };
    let share = line / given;
    let (rms, answer) = (map.rms_height, get("area_e4"));
    let gap_half = grid::gap_half_width(map, share) / rms + iteration::GAP * residual;
    Case {
        class,
        gate: plain.map(|_| ()).map_err(|why| match why {
            NoAreaInterval::Stepped { .. } => "stepped",
            NoAreaInterval::SpotsTooSmall { .. } => "small spots",
            NoAreaInterval::Unresolved { .. } => "short waves",
            _ => "other",
        }),
        area: [
            (answer - truth) / truth,
            plain.unwrap_or(left_over * line) / truth + left * given / truth,
        ],
        refined: [
            (answer - truth) / truth,
            finer.area_half_width(given) / truth + left * given / truth,
        ],
        gap: [(get("gap_e4") - get("gap4")) / get("gap4"), gap_half / get("gap4")],
        stiffness: [
            get("stiffness1") / get("stiffness4") - 1.0,
            grid::stiffness_half_width(map, share),
        ],
    }
}

/// "151 of 157 (96 %), ±2.8 %".
fn held<'a>(cases: impl Iterator<Item = &'a Case>, value: fn(&Case) -> [f64; 2]) -> String {
    let pairs: Vec<[f64; 2]> = cases.map(value).collect();
    let inside = pairs.iter().filter(|[error, half]| error.abs() <= *half).count();
    let n = pairs.len();
    if n == 0 {
        return "–".into();
    }
    let mut widths: Vec<f64> = pairs.iter().map(|p| p[1]).collect();
    widths.sort_by(f64::total_cmp);
    format!("{inside} of {n}, ±{:.2} %", 100.0 * widths[n / 2])
}

fn by_class(cases: &[Case]) -> String {
    let mut page = String::from(
        "Inside the gate: how many intervals held the truth, and the median half width.\n\n\
         | surfaces | area, real pressure | mean gap | stiffness | area error, 95 % below |\n\
         |---|---|---|---|---|\n",
    );
    for (_, count, class) in CLASSES {
        let mut sizes: Vec<f64> =
            stated(cases, class).map(|c| (c.area[0] / c.area[1]).abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let at = sizes.get((0.95 * (sizes.len().max(1) - 1) as f64).round() as usize);
        let _ = writeln!(
            page,
            "| {class} ({count}) | {} | {} | {} | {} half widths |",
            held(stated(cases, class), |c| c.area),
            held(stated(cases, class), |c| c.gap),
            held(stated(cases, class), |c| c.stiffness),
            at.map_or("–".into(), |s| format!("{s:.2}")),
        );
    }
    page
}

fn outside(cases: &[Case]) -> String {
    let mut page = String::from(
        "\nOutside the gate: what the refused bar would have done, and the bar of one more solution \
         on the twice finer grid. The last line is that bar inside the gate, where it is not \
         needed.\n\n\
         | refused for | plain bar, had it been stated | refined bar |\n|---|---|---|\n",
    );
    for reason in ["stepped", "small spots", "short waves"] {
        let sel = || cases.iter().filter(|c| c.gate == Err(reason));
        let _ = writeln!(
            page,
            "| {reason} | {} | {} |",
            held(sel(), |c| c.area),
            held(sel(), |c| c.refined)
        );
    }
    let inside = || cases.iter().filter(|c| c.gate.is_ok());
    let _ = writeln!(
        page,
        "| nothing | {} | {} |",
        held(inside(), |c| c.area),
        held(inside(), |c| c.refined)
    );
    page
}

/// How far the answers move when the iteration stops early.
fn early(table: &Table) -> String {
    let mut page = String::from(
        "\nIteration stopped early, all surfaces and loads, against 1e−6: how often the stated part \
         of the iteration alone held, and the error relative to the part.\n\n\
         | tolerance | median residual | residual / η, median | area | area, 95 % of errors below | \
         gap |\n|---|---|---|---|---|---|\n",
    );
    for power in ["2", "3", "4"] {
        let mut residuals = Vec::new();
        let (mut ratios, mut errors) = (Vec::new(), Vec::new());
        let (mut area_held, mut gap_held) = (0, 0);
        for row in 0..table.rows.len() {
            let get = |column: &str| table.get(row, &format!("{column}_e{power}"));
            let area = corrected(table, row, "1")[0];
            let residual = get("residual");
            let error = (get("area") / area - 1.0).abs();
            residuals.push(residual);
            ratios.push(residual / get("eta"));
            errors.push(error);
            area_held += usize::from(error <= iteration::area_error(residual));
            let gap = (get("gap") - table.get(row, "gap1")).abs();
            gap_held += usize::from(gap <= iteration::GAP * residual);
        }
        let n = errors.len();
        for list in [&mut residuals, &mut ratios, &mut errors] {
            list.sort_by(f64::total_cmp);
        }
        let _ = writeln!(
            page,
            "| 1e−{power} | {} | {:.2} | {:.1} % | {:.3} % | {:.1} % |",
            format!("{:.1e}", residuals[n / 2]).replace('-', "−"),
            ratios[n / 2],
            100.0 * area_held as f64 / n as f64,
            100.0 * errors[(0.95 * n as f64) as usize],
            100.0 * gap_held as f64 / n as f64,
        );
    }
    page
}

/// Coverage of the finite-sample interval for the mean over realisations.
fn realisations(table: &Table) -> String {
    let mut page = String::from(
        "\nFinite sample: scatter over 30 realisations at four loads (from 0.003 to 0.2 of \
         E\\* h′rms) beside the median stated half width, and how many of the 120 intervals held \
         the mean of their family. The families below the line took no part in the calibration.\n\n\
         | H, shortest, roll-off (points) | area: scatter | stated | held | gap: scatter | stated | \
         held | stiffness: held |\n|---|---|---|---|---|---|---|---|\n",
    );
    let mut totals = [[0usize; 4]; 2]; // calibration, check: area, gap, stiffness, all
    for (family, [hurst, cutoff, rolloff]) in FAMILIES.iter().enumerate() {
        if family == CALIBRATION {
            page.push_str("| **check** | | | | | | | |\n");
        }
        let rows: Vec<usize> =
            (0..table.rows.len()).filter(|r| table.get(*r, "family") as usize == family).collect();
        let mut held = [0usize; 3];
        let mut spread = [[f64::INFINITY, 0.0_f64]; 2];
        let mut stated = [Vec::new(), Vec::new()];
        let mut loads: Vec<f64> = rows.iter().map(|r| table.get(*r, "load")).collect();
        loads.sort_by(f64::total_cmp);
        loads.dedup();
        for load in &loads {
            let same = |r: &&usize| (table.get(**r, "load") / load - 1.0).abs() < 1e-9;
            let rows: Vec<usize> = rows.iter().filter(same).copied().collect();
            let n = rows.len() as f64;
            for (k, name) in ["area", "gap", "stiffness"].iter().enumerate() {
                let mean = rows.iter().map(|r| table.get(*r, name)).sum::<f64>() / n;
                let square =
                    rows.iter().map(|r| (table.get(*r, name) / mean - 1.0).powi(2)).sum::<f64>();
                for &r in &rows {
                    let (blocks, height) = (table.get(r, "blocks"), table.get(r, "height"));
                    let half = match k {
                        0 => sample::area_half_width(blocks, height),
                        1 => sample::gap_half_width(height),
                        _ => sample::stiffness_half_width(blocks, height),
                    };
                    let value = table.get(r, name);
                    held[k] += usize::from((value - mean).abs() <= half * value);
                    if k < 2 {
                        stated[k].push(half);
                    }
                }
                if k < 2 {
                    let scatter = (square / (n - 1.0)).sqrt();
                    spread[k] = [spread[k][0].min(scatter), spread[k][1].max(scatter)];
                }
            }
        }
        let total = &mut totals[usize::from(family >= CALIBRATION)];
        for (sum, part) in total.iter_mut().zip(held.iter().chain([&rows.len()])) {
            *sum += part;
        }
        for list in &mut stated {
            list.sort_by(f64::total_cmp);
        }
        let range = |s: [f64; 2]| format!("{:.1}–{:.1} %", 100.0 * s[0], 100.0 * s[1]);
        let width = |list: &[f64]| format!("±{:.1} %", 100.0 * list[list.len() / 2]);
        let _ = writeln!(
            page,
            "| {hurst}, {cutoff}, {rolloff} | {} | {} | {} | {} | {} | {} | {} |",
            range(spread[0]),
            width(&stated[0]),
            held[0],
            range(spread[1]),
            width(&stated[1]),
            held[1],
            held[2]
        );
    }
    for (name, [area, gap, stiffness, n]) in ["calibration", "check"].iter().zip(totals) {
        let part = |k: usize| 100.0 * k as f64 / n as f64;
        let _ = writeln!(
            page,
            "| **all of {name}** | | | {:.1} % | | | {:.1} % | {:.1} % |",
            part(area),
            part(gap),
            part(stiffness)
        );
    }
    page
}

/// Families that fixed the constants.
const CALIBRATION: usize = 12;
