//! Two complete measurements beside each other: what is the same, and how far times moved.

use crate::page::{cheapest, name, percent};
use compare::find;
use contact_accuracy::quantile;
use std::fmt::Write as _;
use studies::tradeoff::{Row, Table, ways};

/// What a row is measured of.
type Key<'a> = (&'a str, &'a str, Option<&'a str>, Option<usize>, [Option<u64>; 2]);

fn key(row: &Row) -> Key<'_> {
    let bits = |value: Option<f64>| value.map(f64::to_bits);
    let precision = row.precision.as_deref();
    (&row.surface, &row.method, precision, row.points, [bits(row.load), bits(row.tolerance)])
}

/// Rows whose times are looked at together: their name, and which they are.
type Group = (&'static str, fn(&Row) -> bool);

/// The words and the table of the book on how well a second measurement repeats the first.
pub(crate) fn compare(first: &Table, second: &Table) -> String {
    let pairs: Vec<(&Row, &Row)> = first
        .rows
        .iter()
        .filter_map(|a| Some((a, second.rows.iter().find(|b| key(a) == key(b))?)))
        .collect();
    let mut page = String::new();
    for line in &second.origin {
        let _ = writeln!(page, "{line}  ");
    }
    let results = |r: &Row| [r.area, r.corrected, r.truth, r.pressure_error, r.pairs];
    let is_same = |(a, b): &&(&Row, &Row)| {
        let equal = |(a, b): (Option<f64>, Option<f64>)| match (a, b) {
            (Some(a), Some(b)) => a.total_cmp(&b).is_eq(),
            (a, b) => a.is_none() && b.is_none(),
        };
        results(a).into_iter().zip(results(b)).all(equal)
    };
    let largest = |of: fn(&Row) -> Option<f64>| {
        let moved = |(a, b): &(&Row, &Row)| Some((of(b)? / of(a)? - 1.0).abs());
        pairs.iter().filter_map(moved).fold(0.0, f64::max)
    };
    let [area, work] = [largest(|r| r.corrected.or(r.area)), largest(|r| r.pairs)];
    let changes = if area.max(work) > 0.0 {
        format!(
            "the largest changes are {} of an area and {} of a number of pairs",
            percent(area),
            percent(work)
        )
    } else {
        "no area and no number of pairs has changed".to_owned()
    };
    let _ = writeln!(
        page,
        "Of {} rows {} were measured again. In {} of these area, truth, error of the pressure and FFT \
         pairs are the same to all six digits; {changes}.\n",
        first.rows.len(),
        pairs.len(),
        pairs.iter().filter(is_same).count(),
    );
    page.push_str(
        "| time, second over first | rows | median | 5 to 95 % of the rows | smallest to largest |\n\
         |---|---|---|---|---|\n",
    );
    let groups: [Group; 4] = [
        ("closed forms", |r| find(&r.method).is_some()),
        ("chord method", |r| r.method == "chord"),
        ("Polonsky–Keer, Stanley–Kato", |r| {
            r.method == "polonsky-keer" || r.method == "stanley-kato"
        }),
        ("all", |_| true),
    ];
    for (words, belongs) in groups {
        let of_group = pairs.iter().filter(|(a, _)| belongs(a));
        let mut ratios: Vec<f64> = of_group.map(|(a, b)| b.seconds / a.seconds).collect();
        ratios.sort_by(f64::total_cmp);
        let Some([low, middle, high, least, most]) = quantiles(&ratios) else { continue };
        let _ = writeln!(
            page,
            "| {words} | {} | {middle:.2} | {low:.2} to {high:.2} | {least:.2} to {most:.2} |",
            ratios.len()
        );
    }
    // Ways are chosen by all their cases.
    if pairs.len() == first.rows.len() {
        page.push_str(&choice(first, second));
    }
    page
}

/// Whether the cheapest way to every accuracy is the same.
fn choice(first: &Table, second: &Table) -> String {
    let choices = |table: &Table| -> Vec<String> {
        let found = ways(table.rows.iter());
        let choose = |(wanted, way): (f64, Option<&_>)| {
            format!("{}: {}", percent(wanted), way.map_or("none".to_owned(), name))
        };
        cheapest(&found).into_iter().map(choose).collect()
    };
    let before = choices(first);
    let changed: Vec<String> =
        choices(second).into_iter().filter(|choice| !before.contains(choice)).collect();
    match changed[..] {
        [] => "\nThe cheapest way to every accuracy of the first table is the same.\n".to_owned(),
        _ => format!("\nThe cheapest way is another to {}.\n", changed.join("; ")),
    }
}

fn quantiles(sorted: &[f64]) -> Option<[f64; 5]> {
    let [low, middle, high] = [0.05, 0.5, 0.95].map(|part| quantile(sorted, part));
    Some([low?, middle?, high?, *sorted.first()?, *sorted.last()?])
}
