//! What the book says of the study, from its tables: how often each stated interval held.

use crate::ensemble::{self, CLASSES, POINTS};
use crate::fresh;
use crate::measure::Surface;
use crate::sample_page::realisations;
use crate::table::Table;
use compare::budget::{Map, grid, iteration};
use contact_accuracy::NoAreaInterval;
use contact_types::Grid;
use fft_bem_solver::PERIMETER_CORRECTION;
use std::error::Error;
use std::fmt::Write as _;
use std::fs::{self, File};
use std::path::Path;
use studies::figures::budget::{BarErrors, write_budget};

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

/// Writes `budget.svg` and `budget.md` into `folder`, from the tables of the study, of the maps that
/// took no part and of the realisations.
pub(crate) fn write(tables: [&Path; 3], folder: &Path) -> Result<(), Box<dyn Error>> {
    let [study, fresh, sample] = tables.map(Table::read);
    let (study, fresh) = (study?, fresh?);
    let used = cases(&study, &ensemble::recipes())?;
    let unused = cases(&fresh, &fresh::recipes())?;
    fs::create_dir_all(folder)?;
    write_budget(&groups(&used), &mut File::create(folder.join("budget.svg"))?)?;
    write_budget(&groups(&unused), &mut File::create(folder.join("budget-fresh.svg"))?)?;
    let page = [
        "### The maps of the study\n\n".to_owned(),
        by_class(&used, |count| count),
        outside(&used),
        early(&study),
        "\n### Maps that took no part\n\n".to_owned(),
        by_class(&unused, |_| fresh::EACH),
        outside(&unused),
        early(&fresh),
        "\n### Finite sample\n\n".to_owned(),
        realisations(&sample?),
    ];
    fs::write(folder.join("budget.md"), page.concat())?;
    Ok(())
}

/// Errors over half widths by number and class, for the figure.
fn groups(cases: &[Case]) -> [(&'static str, Vec<BarErrors>); 3] {
    let group = |title, value: fn(&Case) -> [f64; 2]| {
        let classes = CLASSES.iter().map(|&(_, _, class)| BarErrors {
            class: class.to_owned(),
            ratios: stated(cases, class).map(|c| value(c)[0] / value(c)[1]).collect(),
        });
        (title, classes.collect())
    };
    [group("Area", |c| c.area), group("Mean gap", |c| c.gap), group("Stiffness", |c| c.stiffness)]
}

/// Cases inside the gate.
fn stated<'a>(cases: &'a [Case], class: &'a str) -> impl Iterator<Item = &'a Case> {
    cases.iter().filter(move |c| c.class == class && c.gate.is_ok())
}

fn cases<S: Surface>(table: &Table, surfaces: &[S]) -> Result<Vec<Case>, Box<dyn Error>> {
    let mut known: Option<(usize, Map)> = None;
    let mut cases = Vec::new();
    for row in 0..table.len() {
        let surface = table.get(row, "surface") as usize;
        let map = match known {
            Some((index, map)) if index == surface => map,
            _ => Map::of(&surfaces[surface].make(1)?)?,
        };
        known = Some((surface, map));
        cases.push(case(table, row, surfaces[surface].name(), &map));
    }
    Ok(cases)
}

fn corrected(table: &Table, row: usize, grid: &str) -> [f64; 2] {
    let correction = PERIMETER_CORRECTION * table.get(row, &format!("edges{grid}"));
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
    let left_over = map.accuracy.left_of_correction();
    let refined = Grid::new([2 * POINTS; 2], [1.0; 2]).expect("a grid of square pixels");
    let finer = grid::Finer {
        area: twice,
        correction: finer_line,
        gap: None,
        pressure: f64::NAN,
        bar: map.accuracy.on(refined).line_left_over(get("edges2")),
        gap_bar: 0.0,
        stiffness: None,
        doublings: 0.0,
        monotone: None,
    };
    let share = grid::Line { area: given, edges: get("edges1") };
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
            get("stiffness_e4") / get("stiffness4") - 1.0,
            grid::stiffness_half_width(map, share) + get("stiffness_left_e4"),
        ],
    }
}

/// "151 of 157 (96 %), ±2.8 %".
fn held(cases: &[&Case], value: fn(&Case) -> [f64; 2]) -> String {
    let pairs: Vec<[f64; 2]> = cases.iter().map(|c| value(c)).collect();
    let inside = pairs.iter().filter(|[error, half]| error.abs() <= *half).count();
    let n = pairs.len();
    if n == 0 {
        return "–".into();
    }
    let mut widths: Vec<f64> = pairs.iter().map(|p| p[1]).collect();
    widths.sort_by(f64::total_cmp);
    format!("{inside} of {n}, ±{:.2} %", 100.0 * widths[n / 2])
}

fn by_class(cases: &[Case], count: impl Fn(usize) -> usize) -> String {
    let mut page = String::from(
        "Inside the gate: how many intervals held the truth, and the median half width.\n\n\
         | surfaces | area, real pressure | mean gap | stiffness | area error, 95 % below |\n\
         |---|---|---|---|---|\n",
    );
    let mut line = |name: &str, cases: &[&Case]| {
        let mut sizes: Vec<f64> = cases.iter().map(|c| (c.area[0] / c.area[1]).abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let at = sizes.get((0.95 * (sizes.len().max(1) - 1) as f64).round() as usize);
        let _ = writeln!(
            page,
            "| {name} | {} | {} | {} | {} half widths |",
            held(cases, |c| c.area),
            held(cases, |c| c.gap),
            held(cases, |c| c.stiffness),
            at.map_or("–".into(), |s| format!("{s:.2}")),
        );
    };
    for (_, number, class) in CLASSES {
        let cases: Vec<&Case> = stated(cases, class).collect();
        line(&format!("{class} ({})", count(number)), &cases);
    }
    let all: Vec<&Case> = cases.iter().filter(|c| c.gate.is_ok()).collect();
    line("**all**", &all);
    page
}

fn outside(cases: &[Case]) -> String {
    let mut page = String::from(
        "\nOutside the gate: what the refused bar would have done, and the bar of one more solution \
         on the twice finer grid. The last line is that bar inside the gate, where it is not \
         needed.\n\n\
         | refused for | plain bar, had it been stated | refined bar |\n|---|---|---|\n",
    );
    let mut line = |name: &str, gate: Result<(), &str>| {
        let cases: Vec<&Case> = cases.iter().filter(|c| c.gate == gate).collect();
        let [plain, refined] = [held(&cases, |c| c.area), held(&cases, |c| c.refined)];
        let _ = writeln!(page, "| {name} | {plain} | {refined} |");
    };
    for reason in ["stepped", "small spots", "short waves"] {
        line(reason, Err(reason));
    }
    line("nothing", Ok(()));
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
        for row in 0..table.len() {
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
