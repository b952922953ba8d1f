//! What the book says of the equation, from the two tables.

use crate::chance;
use crate::fit;
use crate::table::{Row, one, read};
use compare::{Inputs, built_in};
use multiscale_models::{AreaLaw, Equation, MAP_TERMS, MapEquation, Persson};
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

/// Of the others that need moments only.
const OTHERS: [&str; 4] = ["gw", "bgt", "greenwood-elliptical", "persson"];
/// Yang & Persson's factor of the energy of partial contact, with which partial contact slows the diffusion.
const GAMMA: f64 = 0.45;
const LIGHT: &str = "| | A ≈ 0.1 % | 0.4 % | 1 % | 3.5 % | 10 % | 25 % | 53 % | 85 % | 99 % |\n|---|---|---|---|---|---|---|---|---|---|\n";

/// One answer against a solution.
struct Answer<'a> {
    row: &'a Row,
    /// Place of the load.
    load: usize,
    numbers: f64,
    map: f64,
    is_held: [bool; 2],
    /// Half width of the interval of the law for a map, in the logarithm.
    half: f64,
    others: [Option<f64>; OTHERS.len()],
    /// Persson's law with the reduced diffusion, published factor and fitted one.
    reduced: [f64; 2],
}

/// Persson's law where partial contact slows the diffusion.
fn reduced(row: &Row, gamma: f64) -> Result<Persson, Box<dyn Error>> {
    let law = Persson::from_moments(row.moments(), one()?)?.with_gamma(gamma)?;
    Ok(law.with_area_law(AreaLaw::ReducedDiffusion))
}

/// The factor, of two digits, with which that law is nearest on the Gaussian ones of these maps.
fn fitted_gamma(rows: &[Row]) -> Result<f64, Box<dyn Error>> {
    let mut best = (f64::INFINITY, GAMMA);
    for percent in 30..=100 {
        let gamma = f64::from(percent) / 100.0;
        let mut sum = 0.0;
        for row in rows.iter().filter(|r| fit::is_gaussian(r)) {
            let law = reduced(row, gamma)?;
            for load in &row.loads {
                sum += (law.area_fraction(load.x)? / load.area).ln().abs();
            }
        }
        if sum < best.0 {
            best = (sum, gamma);
        }
    }
    Ok(best.1)
}

/// Writes `equation.md` into `folder`; fails if the constants of the crate are not those of the fit.
pub(crate) fn write(
    [fitted, judged, chance]: [&Path; 3],
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let (fitted, judged) = (read(fitted)?, read(judged)?);
    same_constants(&fitted)?;
    let gamma = fitted_gamma(&fitted)?;
    let answers = answers(&judged, gamma)?;
    let page = [
        families(&answers),
        by_load(&answers),
        bias(&fitted, gamma)?,
        chance::page(&fs::read_to_string(chance)?)?,
        classes(&answers),
        terms(&fitted, &judged)?,
        others(&answers, gamma),
    ];
    fs::create_dir_all(folder)?;
    fs::write(folder.join("equation.md"), page.join("\n"))?;
    Ok(())
}

impl Answer<'_> {
    /// Half width of the grid error of the solution, over its area.
    fn grid(&self) -> f64 {
        let load = self.row.loads[self.load];
        load.bar / load.area
    }
}

/// The fit gives what the crate has.
fn same_constants(rows: &[Row]) -> Result<(), Box<dyn Error>> {
    let constants = fit::map(rows);
    let half = fit::spread(&fit::left_out(rows)?, fit::SHARE);
    let row = rows.first().ok_or("no rows")?;
    for row in [row, rows.last().unwrap_or(row)] {
        let law = MapEquation::new(row.moments(), &row.curves, one()?)?;
        let again =
            MapEquation::with_constants(row.moments(), &row.curves, one()?, (&constants, &half))?;
        for load in &row.loads {
            let [a, b] = [&law, &again].map(|l| l.area_fraction(load.x));
            if (a? / b? - 1.0).abs() > 1e-9 {
                return Err("the constants of the crate are not those of the fit".into());
            }
        }
    }
    Ok(())
}

fn answers(rows: &[Row], gamma: f64) -> Result<Vec<Answer<'_>>, Box<dyn Error>> {
    let mut list = Vec::new();
    for row in rows {
        let numbers = Equation::from_moments(row.moments(), one()?)?;
        let law = MapEquation::new(row.moments(), &row.curves, one()?)?;
        let inputs = Inputs { moments: Some(row.moments()), ..Inputs::new(one()?) };
        let slowed = [reduced(row, GAMMA)?, reduced(row, gamma)?];
        let others = OTHERS.map(|name| {
            built_in().iter().find(|t| t.card().name == name).and_then(|t| t.build(&inputs).ok())
        });
        for (k, load) in row.loads.iter().enumerate() {
            let [a, b] = [numbers.area_fraction(load.x)?, law.area_fraction(load.x)?];
            let holds = |[low, high]: [f64; 2]| low <= load.area && load.area <= high;
            list.push(Answer {
                row,
                load: k,
                numbers: a / load.area - 1.0,
                map: b / load.area - 1.0,
                is_held: [holds(numbers.interval(a)), holds(law.interval(b))],
                half: (b / law.interval(b)[0]).ln(),
                reduced: [
                    slowed[0].area_fraction(load.x)? / load.area - 1.0,
                    slowed[1].area_fraction(load.x)? / load.area - 1.0,
                ],
                others: std::array::from_fn(|i| {
                    let state = others[i].as_ref()?.at_pressure(load.x).ok()?;
                    Some(state.area_fraction / load.area - 1.0)
                }),
            });
        }
    }
    Ok(list)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

/// Median and 95 % of the absolute errors, in per cent.
fn seen(errors: impl Iterator<Item = f64>) -> String {
    let mut errors: Vec<f64> = errors.collect();
    if errors.is_empty() {
        return "–".into();
    }
    errors.sort_by(f64::total_cmp);
    let median = 100.0 * errors[errors.len() / 2];
    let sign = if median < 0.0 { "−" } else { "+" };
    format!("{:.1} ({sign}{:.1})", within(errors.iter().copied()), median.abs())
}

/// 95 % of the absolute errors, in per cent; there is at least one.
fn within(errors: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = errors.map(f64::abs).collect();
    sizes.sort_by(f64::total_cmp);
    100.0 * sizes[((sizes.len() as f64 * 0.95) as usize).min(sizes.len() - 1)]
}

fn names(answers: &[Answer<'_>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for a in answers {
        if !names.contains(&a.row.family) {
            names.push(a.row.family.clone());
        }
    }
    names
}

fn persson(a: &Answer<'_>) -> Option<f64> {
    a.others[3]
}

fn families(answers: &[Answer<'_>]) -> String {
    let mut page = String::from(
        "Per cent: 95 % of the cases are within (median). Held: share of the cases inside the \
         law's own interval; ±: its median half width. Grid: half width of the grid error of the solutions, 95 % \
         below; surely law: what of the map law's error is beyond that half width, 95 % within.\n\n\
         | family | maps | Persson | for numbers | for a map | held | ± | grid | surely law |\n\
         |---|---|---|---|---|---|---|---|---|\n",
    );
    for name in names(answers) {
        let own: Vec<&Answer<'_>> = answers.iter().filter(|a| a.row.family == name).collect();
        let maps = own.iter().filter(|a| a.load == 0).count();
        let held = own.iter().filter(|a| a.is_held[1]).count() as f64 / own.len() as f64;
        let _ = writeln!(
            page,
            "| {name} | {maps} | {} | {} | {} | {:.0} % | {:.0} | {:.1} | {:.1} |",
            seen(own.iter().filter_map(|a| persson(a))),
            seen(own.iter().map(|a| a.numbers)),
            seen(own.iter().map(|a| a.map)),
            100.0 * held,
            100.0 * median(own.iter().map(|a| a.half)),
            within(own.iter().map(|a| a.grid())),
            within(own.iter().map(|a| (a.map.abs() - a.grid()).max(0.0)))
        );
    }
    let of = |f: &dyn Fn(&Answer<'_>) -> bool| seen(answers.iter().filter(|a| f(a)).map(|a| a.map));
    let gaussian: Vec<&Answer<'_>> = answers.iter().filter(|a| fit::is_gaussian(a.row)).collect();
    let held = gaussian.iter().filter(|a| a.is_held[0]).count() as f64 / gaussian.len() as f64;
    let _ = writeln!(
        page,
        "\nAll {} cases: {}. The interval of the law for numbers holds {:.0} % of the Gaussian cases.\n",
        answers.len(),
        of(&|_| true),
        100.0 * held
    );
    page
}

fn by_load(answers: &[Answer<'_>]) -> String {
    let mut page = format!("Over the load, areas as on Gaussian surfaces:\n\n{LIGHT}");
    let mut line = |name: &str, f: &dyn Fn(&Answer<'_>) -> Option<f64>| {
        let _ = write!(page, "| {name} |");
        for k in 0..9 {
            let _ =
                write!(page, " {} |", seen(answers.iter().filter(|a| a.load == k).filter_map(f)));
        }
        page.push('\n');
    };
    let gaussian = |a: &Answer<'_>| fit::is_gaussian(a.row);
    line("Gaussian, numbers", &|a| gaussian(a).then_some(a.numbers));
    line("Gaussian, map", &|a| gaussian(a).then_some(a.map));
    line("all others, map", &|a| (!gaussian(a)).then_some(a.map));
    line("half width of the grid error", &|a| Some(a.grid()));
    line("what twice the points moved", &|a| {
        let load = a.row.loads[a.load];
        let moved = (load.area / load.given).ln();
        (moved.abs() > 0.0).then_some(moved)
    });
    page
}

/// The law for numbers on the Gaussian maps that it was fitted on, which are more than the judged ones: its bias by
/// load and bandwidth.
fn bias(fitted: &[Row], gamma: f64) -> Result<String, Box<dyn Error>> {
    let rows: Vec<Row> = fitted.iter().filter(|r| fit::is_gaussian(r)).cloned().collect();
    let answers = answers(&rows, gamma)?;
    let mut page =
        format!("\nThe law for numbers on the Gaussian maps that it was fitted on:\n\n{LIGHT}");
    for (name, low, high) in
        [("below 5", 0.0, 5.0), ("5 to 15", 5.0, 15.0), ("above 15", 15.0, f64::INFINITY)]
    {
        let of = |r: &Row| (low..high).contains(&r.bandwidth);
        let _ = write!(page, "| α {name}, {} maps |", rows.iter().filter(|r| of(r)).count());
        for k in 0..9 {
            let own = answers.iter().filter(|a| a.load == k && of(a.row));
            let _ = write!(page, " {} |", seen(own.map(|a| a.numbers)));
        }
        page.push('\n');
    }
    Ok(page)
}

fn classes(answers: &[Answer<'_>]) -> String {
    let mut page =
        String::from("\n| class | maps | for numbers | for a map |\n|---|---|---|---|\n");
    let mut line = |name: &str, f: &dyn Fn(&Row) -> bool| {
        let own: Vec<&Answer<'_>> = answers.iter().filter(|a| f(a.row)).collect();
        let maps = own.iter().filter(|a| a.load == 0).count();
        let numbers = seen(own.iter().map(|a| a.numbers));
        let map = seen(own.iter().map(|a| a.map));
        let _ = writeln!(page, "| {name} | {maps} | {numbers} | {map} |");
    };
    let gaussian =
        |r: &Row, low: f64, high: f64| fit::is_gaussian(r) && (low..high).contains(&r.bandwidth);
    line("Gaussian, α below 5", &|r| gaussian(r, 0.0, 5.0));
    line("Gaussian, α 5 to 15", &|r| gaussian(r, 5.0, 15.0));
    line("Gaussian, α above 15", &|r| gaussian(r, 15.0, f64::INFINITY));
    line("skewness below −0.5", &|r| r.skewness < -0.5);
    line("skewness −0.5 to 0.5", &|r| r.skewness.abs() <= 0.5);
    line("skewness above 0.5", &|r| r.skewness > 0.5);
    line("ratio of slopes above 1.5", &|r| r.ratio > 1.5);
    page
}

/// What each group of constants buys: fitted without them on the fitted surfaces, asked of the judged.
fn terms(fitted: &[Row], judged: &[Row]) -> Result<String, Box<dyn Error>> {
    let steps: [(&str, &[usize]); 7] = [
        ("all", &[]),
        ("without how well the part is resolved", &[21, 22, 23]),
        ("nor the flattened part", &[19]),
        ("nor any curvature", &[5, 6, 7, 9, 10, 11, 18, 20]),
        ("nor where it is pressed", &[12, 13, 14, 15, 16, 17]),
        ("nor the evenness of slopes", &[8]),
        ("nor any slope of the highest part", &[3, 4]),
    ];
    let mut left_out = Vec::new();
    let mut page = String::from(
        "\n| constants of the law for a map | number | Gaussian | fitted families | new families |\n|---|---|---|---|---|\n",
    );
    for (name, more) in steps {
        left_out.extend(more);
        let constants = fit::map_without(fitted, &left_out);
        let errors = fit::misses(judged, &constants)?;
        let of = |f: &dyn Fn(&str) -> bool| {
            seen(errors.iter().filter(|m| f(&m.family)).map(|m| m.of_area))
        };
        let known = |n: &str| fitted.iter().any(|r| r.family == n);
        let smooth = |n: &str| matches!(n, "gaussian" | "wide");
        let _ = writeln!(
            page,
            "| {name} | {} | {} | {} | {} |",
            MAP_TERMS - left_out.len(),
            of(&smooth),
            of(&|n| known(n) && !smooth(n)),
            of(&|n| !known(n))
        );
    }
    Ok(page)
}

fn others(answers: &[Answer<'_>], gamma: f64) -> String {
    let mut page = format!("\nThe others on the same judged surfaces, Gaussian ones:\n\n{LIGHT}");
    let mut line = |name: &str, of: &dyn Fn(&Answer<'_>) -> Option<f64>| {
        let _ = write!(page, "| {name} |");
        for k in 0..9 {
            let own = answers.iter().filter(|a| a.load == k && fit::is_gaussian(a.row));
            let _ = write!(page, " {} |", seen(own.filter_map(of)));
        }
        page.push('\n');
    };
    for (i, name) in OTHERS.iter().enumerate() {
        line(name, &|a| a.others[i]);
    }
    line(&format!("persson, reduced diffusion, γ = {GAMMA}"), &|a| Some(a.reduced[0]));
    line(&format!("the same, γ = {gamma} fitted"), &|a| Some(a.reduced[1]));
    page
}
