//! The tables of the book: how often the intervals of each family held, and how wide they are.

use contact_accuracy::median;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use studies::rows::Families;

/// A row of the table by the names of its columns.
struct Row {
    family: String,
    own: bool,
    load: f64,
    rms: f64,
    /// Value, half width, truth of area, gap, stiffness.
    numbers: [[f64; 3]; 3],
    /// Areas claimed at 5 % and 2 %.
    claimed: [f64; 2],
}

/// Counts of some rows.
#[derive(Default)]
struct Counts {
    rows: usize,
    own: usize,
    /// Held, and stated, of each number.
    held: [[usize; 2]; 3],
    /// Relative half widths of the area; half widths of the gap over the rms height.
    widths: [Vec<f64>; 2],
    /// Kept, and made.
    claims: [usize; 2],
}

/// Columns of the table.
const COLUMNS: usize = 17;

/// Loads that count as one class in the second table.
const CLASSES: [[f64; 2]; 4] = [[0.0, 0.002], [0.002, 0.03], [0.03, 0.2], [0.2, 2.0]];

/// Writes flat-tops.md into `folder`.
pub(crate) fn write(table: &Path, folder: &Path, families: Families) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let rows = read(&fs::read_to_string(table)?)?;
    let mut page = String::new();
    let titles = [
        "Families that took no part in anything",
        "Families that took no part in the first rule",
        "Families that the constants were fixed on",
    ];
    for (place, title) in titles.into_iter().enumerate() {
        let rows: Vec<&Row> = rows.iter().filter(|r| families.place(&r.family) == place).collect();
        if rows.is_empty() {
            continue;
        }
        let _ = writeln!(
            page,
            "### {title}\n\n| family | answers | bar of the given grid | area held | gap held | \
             stiffness held | area ±, median | gap ±, of the rms height | claims of `--accuracy` \
             kept |\n|---|---|---|---|---|---|---|---|---|"
        );
        let mut families: Vec<&str> = Vec::new();
        for row in &rows {
            if !families.contains(&row.family.as_str()) {
                families.push(&row.family);
            }
        }
        for family in families {
            let of: Vec<&Row> = rows.iter().copied().filter(|r| r.family == family).collect();
            line(&mut page, family, &of);
        }
        line(&mut page, "**all**", &rows);
        for [low, high] in CLASSES {
            let of: Vec<&Row> =
                rows.iter().copied().filter(|r| low < r.load && r.load <= high).collect();
            line(&mut page, &format!("p from {low} to {high} of E\\* h′rms"), &of);
        }
        page.push('\n');
    }
    fs::write(folder.join("flat-tops.md"), page)?;
    Ok(())
}

fn read(text: &str) -> Result<Vec<Row>, Box<dyn Error>> {
    let mut rows = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with('#') && !l.starts_with("family,")) {
        let mut cells: Vec<&str> = line.split(',').collect();
        // A name may hold a comma.
        let more = cells.len().saturating_sub(COLUMNS);
        let family = cells[..=more].join(",");
        cells.drain(..more);
        let number = |k: usize| -> Result<f64, Box<dyn Error>> {
            Ok(cells.get(k).ok_or("a row is too short")?.parse()?)
        };
        let three = |k: usize| -> Result<[f64; 3], Box<dyn Error>> {
            Ok([number(k)?, number(k + 1)?, number(k + 2)?])
        };
        rows.push(Row {
            family,
            own: cells.get(4) == Some(&"own"),
            load: number(2)?,
            rms: number(5)?,
            numbers: [three(6)?, three(9)?, three(12)?],
            claimed: [number(15)?, number(16)?],
        });
    }
    Ok(rows)
}

fn line(page: &mut String, name: &str, rows: &[&Row]) {
    let mut counts = Counts::default();
    for row in rows {
        counts.take(row);
    }
    let Counts { rows, own, held, widths, claims } = counts;
    let [area, gap, stiffness] = held.map(|[held, all]| format!("{held} of {all}"));
    let [area_width, gap_width] = widths.map(|w| 100.0 * median(w.into_iter()).unwrap_or(f64::NAN));
    let _ = writeln!(
        page,
        "| {name} | {rows} | {own} | {area} | {gap} | {stiffness} | {area_width:.2} % | \
         {gap_width:.2} % | {} of {} |",
        claims[0], claims[1]
    );
}

impl Counts {
    fn take(&mut self, row: &Row) {
        self.rows += 1;
        self.own += usize::from(row.own);
        for (count, [value, half, truth]) in self.held.iter_mut().zip(row.numbers) {
            if half.is_finite() && truth.is_finite() {
                count[1] += 1;
                count[0] += usize::from((value - truth).abs() <= half);
            }
        }
        let [[area, area_half, truth], [_, gap_half, _], _] = row.numbers;
        if area > 0.0 && area_half.is_finite() {
            self.widths[0].push(area_half / area);
        }
        if gap_half.is_finite() {
            self.widths[1].push(gap_half / row.rms);
        }
        for (claim, asked) in row.claimed.iter().zip(crate::measure::REQUESTS) {
            if claim.is_finite() {
                self.claims[1] += 1;
                self.claims[0] += usize::from((claim - truth).abs() <= asked * claim);
            }
        }
    }
}
