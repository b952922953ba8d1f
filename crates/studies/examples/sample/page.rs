//! The tables of the book: how often the intervals of each family held its mean, and how wide they are.

use contact_accuracy::median;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use studies::rows::Families;

/// A row of the table.
struct Row {
    family: String,
    load: f64,
    /// Value and half width of area, gap, stiffness.
    numbers: [[f64; 2]; 3],
}

/// Of one number over some loads: held, all, half widths over the value, scatters.
#[derive(Default)]
struct Coverage {
    held: usize,
    all: usize,
    widths: Vec<f64>,
    scatter: Vec<f64>,
}

/// Writes sample.md into `folder`.
pub(crate) fn write(table: &Path, folder: &Path, families: Families) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let rows = read(&fs::read_to_string(table)?)?;
    let mut page = String::new();
    let titles = [
        "Families that took no part",
        "Families that were judged before, and are now among those that the constants were fixed on",
        "Families that the constants were fixed on from the start",
    ];
    for (place, title) in titles.into_iter().enumerate() {
        let of = |row: &&Row| families.place(&row.family) == place;
        let rows: Vec<&Row> = rows.iter().filter(of).collect();
        if !rows.is_empty() {
            tables(&mut page, title, &rows);
        }
    }
    fs::write(folder.join("sample.md"), page)?;
    Ok(())
}

fn tables(page: &mut String, title: &str, rows: &[&Row]) {
    let _ = writeln!(
        page,
        "### {title}\n\n| family | area: scatter | stated | held | gap: scatter | stated | held | stiffness: \
         held |\n|---|---|---|---|---|---|---|---|"
    );
    let mut families: Vec<&str> = Vec::new();
    let mut loads: Vec<f64> = Vec::new();
    for row in rows {
        if !families.contains(&row.family.as_str()) {
            families.push(&row.family);
        }
        if !loads.iter().any(|l| (l / row.load - 1.0).abs() < 1e-9) {
            loads.push(row.load);
        }
    }
    for family in &families {
        line(page, family, &coverage(rows, &[family], &loads));
    }
    for load in &loads {
        let name = format!("p = {load} E\\* h′rms");
        line(page, &name, &coverage(rows, &families, &[*load]));
    }
    line(page, "**all**", &coverage(rows, &families, &loads));
    page.push('\n');
}

/// Of area, gap and stiffness, against the mean of each family at each load.
fn coverage(rows: &[&Row], families: &[&str], loads: &[f64]) -> [Coverage; 3] {
    [0, 1, 2].map(|k| {
        let mut found = Coverage::default();
        for family in families {
            for load in loads {
                let same = |r: &&&Row| r.family == *family && (r.load / load - 1.0).abs() < 1e-9;
                let numbers = rows.iter().filter(same).map(|r| r.numbers[k]);
                let list: Vec<[f64; 2]> =
                    numbers.filter(|[v, h]| v.is_finite() && h.is_finite()).collect();
                found.take(&list);
            }
        }
        found
    })
}

impl Coverage {
    /// One family at one load.
    fn take(&mut self, list: &[[f64; 2]]) {
        if list.len() < 2 {
            return;
        }
        let n = list.len() as f64;
        let mean = list.iter().map(|[v, _]| v).sum::<f64>() / n;
        let square = list.iter().map(|[v, _]| (v - mean).powi(2)).sum::<f64>() / (n - 1.0);
        self.scatter.push(square.sqrt() / mean);
        for [value, half] in list {
            self.all += 1;
            self.held += usize::from((value - mean).abs() <= *half);
            self.widths.push(half / value);
        }
    }

    fn held(&self) -> String {
        format!("{} of {}", self.held, self.all)
    }

    /// "4.2–19 %"
    fn range(&self) -> String {
        let low = self.scatter.iter().copied().fold(f64::INFINITY, f64::min);
        let high = self.scatter.iter().copied().fold(0.0, f64::max);
        format!("{:.1}–{:.1} %", 100.0 * low, 100.0 * high)
    }
}

fn line(page: &mut String, name: &str, [area, gap, stiffness]: &[Coverage; 3]) {
    let width = |c: &Coverage| 100.0 * median(c.widths.iter().copied()).unwrap_or(f64::NAN);
    let _ = writeln!(
        page,
        "| {name} | {} | ±{:.0} % | {} | {} | ±{:.0} % | {} | {} |",
        area.range(),
        width(area),
        area.held(),
        gap.range(),
        width(gap),
        gap.held(),
        stiffness.held()
    );
}

fn read(text: &str) -> Result<Vec<Row>, Box<dyn Error>> {
    let mut rows = Vec::new();
    for line in text.lines().filter(|l| l.starts_with('"')) {
        let (family, rest) = line[1..].split_once("\",").ok_or("a row without a family")?;
        let cells: Vec<&str> = rest.split(',').collect();
        let number = |k: usize| -> Result<f64, Box<dyn Error>> {
            Ok(cells.get(k).ok_or("a row is too short")?.parse()?)
        };
        let pair =
            |k: usize| -> Result<[f64; 2], Box<dyn Error>> { Ok([number(k)?, number(k + 1)?]) };
        rows.push(Row {
            family: family.to_owned(),
            load: number(1)?,
            numbers: [pair(3)?, pair(5)?, pair(7)?],
        });
    }
    Ok(rows)
}
