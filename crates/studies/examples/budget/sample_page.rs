//! What the book says of the finite sample, from its table: how often the stated interval held the
//! mean of the family.

use crate::families::{FAMILIES, Role};
use crate::table::Table;
use compare::budget::sample;
use std::fmt::Write as _;

/// The numbers of a row that have an interval.
const NUMBERS: [&str; 3] = ["area", "gap", "stiffness"];

/// What came out for one number over the maps and loads of a family.
#[derive(Default)]
struct Coverage {
    /// Intervals, and how many of them held the mean of the family.
    all: usize,
    held: usize,
    /// Half widths, relative.
    stated: Vec<f64>,
    /// Relative scatter at each load.
    scatter: Vec<f64>,
}

/// Table of the families, and the share of intervals that held by what a family was used for.
pub(crate) fn realisations(table: &Table) -> String {
    let mut page = String::from(
        "Scatter over 30 realisations at four loads (from 0.003 to 0.2 of E\\* h′rms) beside the \
         median stated half width, and how many of the 120 intervals held the mean of their \
         family.\n\n\
         | H, shortest, roll-off (points) | area: scatter | stated | held | gap: scatter | stated | \
         held | stiffness: held |\n|---|---|---|---|---|---|---|---|\n",
    );
    let roles = [
        (Role::Calibration, "fixed the factors"),
        (Role::Widening, "were seen when they were widened"),
        (Role::Check, "checked them, and were seen when they were widened again"),
        (Role::Fresh, "took no part"),
    ];
    let mut sums = String::new();
    for (role, words) in roles {
        let _ = writeln!(page, "| **{words}** | | | | | | | |");
        let mut totals = [[0; 2]; 3];
        for (place, family) in FAMILIES.iter().enumerate().filter(|(_, f)| f.role == role) {
            let [area, gap, stiffness] = coverage(table, place);
            for (total, part) in totals.iter_mut().zip([&area, &gap, &stiffness]) {
                total[0] += part.held;
                total[1] += part.all;
            }
            let _ = writeln!(
                page,
                "| {family} | {} | {} | {} | {} | {} | {} | {} |",
                area.range(),
                area.width(),
                area.held,
                gap.range(),
                gap.width(),
                gap.held,
                stiffness.held
            );
        }
        let parts = totals.map(|[held, all]| 100.0 * held as f64 / all as f64);
        let _ = writeln!(
            sums,
            "| **all that {words}** | | | {:.1} % | | | {:.1} % | {:.1} % |",
            parts[0], parts[1], parts[2]
        );
    }
    page + &sums
}

/// Area, gap and stiffness of the family at `place` in the list.
fn coverage(table: &Table, place: usize) -> [Coverage; 3] {
    let rows: Vec<usize> =
        (0..table.len()).filter(|r| table.get(*r, "family") as usize == place).collect();
    let mut loads: Vec<f64> = rows.iter().map(|r| table.get(*r, "load")).collect();
    loads.sort_by(f64::total_cmp);
    loads.dedup();
    NUMBERS.map(|name| {
        let mut found = Coverage::default();
        for load in &loads {
            let same = |r: &usize| (table.get(*r, "load") / load - 1.0).abs() < 1e-9;
            let rows: Vec<usize> = rows.iter().copied().filter(same).collect();
            let n = rows.len() as f64;
            let mean = rows.iter().map(|r| table.get(*r, name)).sum::<f64>() / n;
            let mut squares = 0.0;
            for &row in &rows {
                let (value, half) = (table.get(row, name), half_width(table, row, name));
                squares += (value / mean - 1.0).powi(2);
                found.held += usize::from((value - mean).abs() <= half * value);
                found.all += 1;
                found.stated.push(half);
            }
            found.scatter.push((squares / (n - 1.0)).sqrt());
        }
        found.stated.sort_by(f64::total_cmp);
        found
    })
}

/// Relative half width that one map states of the others.
fn half_width(table: &Table, row: usize, name: &str) -> f64 {
    let (blocks, height) = (table.get(row, "blocks"), table.get(row, "height"));
    // The table holds the parts that are larger on surfaces as kind as these; what the others add where they
    // are not is in the study of unkind ones.
    let carrying = (sample::PARTS * sample::PARTS) as f64;
    let blocks = sample::Blocks { scatter: blocks, carrying };
    let area = table.get(row, "area");
    let [fall, gradient, gap, highest] = [0.0; 4];
    let repeats = true;
    let told = sample::Sampled { blocks, area, fall, height, gradient, gap, highest, repeats };
    match name {
        "area" => told.area_half_width(),
        "gap" => told.gap_half_width(),
        _ => told.stiffness_half_width(),
    }
}

impl Coverage {
    /// "0.8–4.2 %"
    fn range(&self) -> String {
        let low = self.scatter.iter().copied().fold(f64::INFINITY, f64::min);
        let high = self.scatter.iter().copied().fold(0.0, f64::max);
        format!("{:.1}–{:.1} %", 100.0 * low, 100.0 * high)
    }

    /// "±7.2 %"
    fn width(&self) -> String {
        let middle = self.stated.get(self.stated.len() / 2);
        middle.map_or("–".into(), |half| format!("±{:.1} %", 100.0 * half))
    }
}
