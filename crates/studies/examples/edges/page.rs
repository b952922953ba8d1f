//! Tables of the study.

use crate::case::{Case, Contact, LOADS, WAVES};
use crate::treatment::Treatment;
use contact_accuracy::edge_study::{EdgeExperience, EdgeStudy};
use contact_accuracy::quantile;
use std::fmt::Write as _;

/// The section of the page.
pub(crate) fn section(cases: &[Case]) -> String {
    let mut text = String::from("Relative error of the area (%), all surfaces:\n\n");
    let mut table = |head: &str, rows: Vec<(String, Vec<String>)>| {
        // Writing to a String cannot fail.
        let loads: Vec<String> = LOADS.iter().map(|x| format!(" {x} |")).collect();
        let _ = writeln!(text, "| {head} |{}", loads.concat());
        let _ = writeln!(text, "|---|{}", "---|".repeat(LOADS.len()));
        for (name, cells) in rows {
            let _ = writeln!(text, "| {name} | {} |", cells.join(" | "));
        }
        text.push('\n');
    };
    let by_load = |cell: &dyn Fn(&[&Case]) -> String| -> Vec<String> {
        (0..LOADS.len())
            .map(|k| cell(&cases.iter().filter(|c| c.load == k).collect::<Vec<_>>()))
            .collect()
    };
    let treatments = || Treatment::ALL.iter().enumerate();

    let mut rows = vec![("crops".to_owned(), by_load(&|c| c.len().to_string()))];
    rows.extend(treatments().map(|(k, t)| (t.name().to_owned(), by_load(&|c| errors(c, k)))));
    rows.push((
        "*periodic, as a sample of the whole*".to_owned(),
        by_load(&|c| spread(c.iter().map(|c| c.as_sample - 1.0).collect(), 100.0)),
    ));
    table("treatment, p/(E\\* h′rms) =", rows);

    let rows = WAVES
        .iter()
        .flat_map(|&waves| treatments().map(move |(k, t)| (waves, k, t)))
        .map(|(waves, k, t)| {
            let cells = by_load(&|c| {
                let kept: Vec<&Case> = c.iter().copied().filter(|c| same(c.waves, waves)).collect();
                errors(&kept, k)
            });
            (format!("{waves}, {}", t.name()), cells)
        })
        .collect();
    table("side over roll-off, treatment", rows);

    let attraction = |cases: &[&Case], of: &dyn Fn(&Case) -> f64| {
        spread(cases.iter().map(|c| of(c)).collect(), 1.0)
    };
    let mut rows = vec![(
        "natural surroundings".to_owned(),
        by_load(&|c| attraction(c, &|c| c.truth.edge.attraction())),
    )];
    rows.extend(treatments().map(|(k, t)| {
        (t.name().to_owned(), by_load(&|c| attraction(c, &|c| c.alone[k].edge.attraction())))
    }));
    table("load of the strip over its share", rows);

    let rows =
        treatments().map(|(k, t)| (t.name().to_owned(), by_load(&|c| median_cost(c, k)))).collect();
    table("FFT pairs of one crop", rows);
    text + &left_out(cases)
}

/// One line per crop and load, for the report.
pub(crate) fn rows(cases: &[Case]) -> String {
    let mut text = String::from("surface,hurst,waves,load,error,direct\n");
    for c in cases {
        let periodic = &c.alone[0];
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{:.3e},{:.4},{:.4}",
            c.surface,
            c.hurst,
            c.waves,
            c.carried,
            error(periodic, &c.truth),
            periodic.edge.direct_effect()
        );
    }
    text
}

/// Whether the range that the report would have quoted for each crop, made without its large map,
/// holds its error.
fn left_out(cases: &[Case]) -> String {
    let study = EdgeStudy::parse(&rows(cases)).expect("these are its rows");
    let ranges: Vec<(f64, EdgeExperience)> = study
        .rows()
        .iter()
        .filter_map(|r| Some((r.error, study.ask_without(r.load, r.direct, Some(r.surface))?)))
        .collect();
    let held = ranges.iter().filter(|(e, seen)| seen.low <= *e && *e <= seen.high).count();
    let widths = sorted(ranges.iter().map(|(_, seen)| seen.high - seen.low).collect());
    let width = quantile(&widths, 0.5).unwrap_or(0.0);
    format!(
        "Of {} crops and loads, {} find at least ten like them on the other surfaces; the range \
         of nine in ten of those holds the error of {} ({:.0} %), and half of the ranges are narrower than {:.0} points.\n",
        cases.len(),
        ranges.len(),
        held,
        100.0 * held as f64 / ranges.len().max(1) as f64,
        100.0 * width
    )
}

fn same(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

fn error(contact: &Contact, truth: &Contact) -> f64 {
    contact.area / truth.area - 1.0
}

fn errors(cases: &[&Case], k: usize) -> String {
    spread(cases.iter().map(|c| error(&c.alone[k], &c.truth)).collect(), 100.0)
}

fn median_cost(cases: &[&Case], k: usize) -> String {
    let sorted = sorted(cases.iter().map(|c| c.alone[k].transforms).collect());
    quantile(&sorted, 0.5).map_or("–".to_owned(), |m| format!("{m:.0}"))
}

/// Median and, in brackets, the range from 5 to 95 %; signed if in per cent.
fn spread(values: Vec<f64>, scale: f64) -> String {
    let sorted = sorted(values);
    let [Some(low), Some(middle), Some(high)] = [0.05, 0.5, 0.95].map(|q| quantile(&sorted, q))
    else {
        return "–".to_owned();
    };
    let show = |v: f64| {
        let text = if scale > 1.0 { format!("{:+.1}", scale * v) } else { format!("{v:.2}") };
        if text == "-0.0" || text == "+0.0" { "0.0".to_owned() } else { text.replace('-', "−") }
    };
    format!("{} ({} to {})", show(middle), show(low), show(high))
}

fn sorted(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    values
}
