//! The report as a reader, a printer and a program meet it: the checks of its contract on real
//! studies of small surfaces.

use crate::studies::{HOSTILE, ONE, THREE, YIELDING, all, file, html, run, small};
use contact_compare::{Comparison, FileOrigin, Origin, Settings, Surface};
use contact_types::{Grid, HeightMap};
use std::collections::HashMap;

/// Width of a letter in ems, at least, in Helvetica and what replaces it.
fn least_width(letter: char) -> f64 {
    match letter {
        'i' | 'j' | 'l' | '\u{202F}' => 0.2,
        'f' | 't' | 'I' | ' ' | '.' | ',' | '/' => 0.27,
        'r' | '-' | '(' | ')' => 0.33,
        _ => 0.5,
    }
}

fn csv(comparison: &Comparison) -> String {
    file(comparison, "curves.csv")
}

fn results(comparison: &Comparison) -> serde_json::Value {
    serde_json::from_str(&file(comparison, "results.json")).unwrap()
}

/// The figures inside a page.
fn figures(page: &str) -> impl Iterator<Item = &str> {
    page.match_indices("<svg ").map(|(i, _)| &page[i..i + page[i..].find("</svg>").unwrap() + 6])
}

/// Name, attributes and text of every element of a figure, which must parse as XML.
fn elements(svg: &str) -> Vec<(String, HashMap<String, String>, String)> {
    use quick_xml::events::Event;
    let mut reader = quick_xml::Reader::from_str(svg);
    let mut found: Vec<(String, HashMap<String, String>, String)> = Vec::new();
    loop {
        match reader.read_event().unwrap() {
            Event::Start(e) | Event::Empty(e) => {
                let attributes = e.attributes().map(|a| a.unwrap());
                let attributes =
                    attributes.map(|a| (a.key.as_ref().to_owned(), a.value.to_string()));
                found.push((e.name().as_ref().to_owned(), attributes.collect(), String::new()));
            }
            Event::Text(t) => found.last_mut().into_iter().for_each(|last| last.2.push_str(&t)),
            Event::Eof => return found,
            _ => {}
        }
    }
}

/// One file that fetches nothing, without a number that is missing or broken; ids are unique and references lead to them.
#[test]
fn a_page_keeps_its_contract() {
    for comparison in all() {
        let page = html(comparison);
        let elsewhere = page.replace("http://www.w3.org/2000/svg", "");
        assert!(!elsewhere.contains("http:") && !elsewhere.contains("https:"));
        assert!(elsewhere.split("src=").skip(1).all(|s| s.starts_with("\"data:image/png;")));
        assert!(!elsewhere.contains("@import") && page.contains("default-src 'none'"));
        assert!(page.len() < 3_000_000, "{} bytes", page.len());
        // Without the pictures, in whose letters anything may occur.
        let parts = page.split("base64,");
        let page: String = parts.map(|part| part.split_once('"').unwrap().1).collect();
        for bad in ["NaN", "inf ", "inf<", "-0.0", "<td></td>", "e-0", "class=\"n\"></td>"] {
            assert!(!page.contains(bad), "{bad}: {}", &page[page.find(bad).unwrap() - 80..][..160]);
        }
        let listed = results(comparison)["surfaces"].as_array().unwrap().len();
        assert_eq!(listed, comparison.surfaces.len());
        let quoted = |begins: &str| -> Vec<String> {
            let all = page.split(begins).skip(1);
            all.map(|s| s[..s.find('"').unwrap()].to_owned()).collect()
        };
        let mut ids = quoted(" id=\"");
        let count = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), count);
        for target in quoted("href=\"#") {
            assert!(ids.contains(&target), "#{target}");
        }
    }
}

#[test]
fn user_strings_cannot_leave_their_place() {
    let page = html(&HOSTILE);
    assert!(!page.contains("<b>\"&"));
    // One data element and one program; nothing of the file's name in between.
    assert_eq!(page.matches("</script>").count(), 2);
    assert!(csv(&HOSTILE).contains("\"</script><b>\"\"&'.x3p\""));
}

#[test]
fn figures_are_xml_and_say_what_they_show() {
    for comparison in all() {
        let page = html(comparison);
        // Beside swatches in a table, beside their names.
        for svg in figures(&page).filter(|svg| !svg.starts_with("<svg viewBox=\"0 0 34 12\"")) {
            let found = elements(svg);
            for name in ["title", "desc"] {
                let element = found.iter().find(|(n, ..)| n == name).unwrap();
                assert!(element.2.len() > 10, "{name}: {:?}", element.2);
            }
        }
        for name in ["area.svg", "pressure.svg"] {
            let file = file(comparison, name);
            assert!(["var(", "class=\"cur\""].iter().all(|no| !file.contains(no)));
            assert!(file.contains("mm\""));
            assert!(elements(&file).len() > 20);
        }
    }
}

/// Direct labels of one figure keep the distance of a line of type.
#[test]
fn labels_do_not_overlap() {
    let number =
        |a: &HashMap<String, String>, key: &str| a.get(key).map(|v| v.parse::<f64>().unwrap());
    for comparison in all() {
        let page = html(comparison);
        for svg in figures(&page) {
            let mut labels: Vec<[f64; 4]> = Vec::new();
            for (_, a, text) in elements(svg) {
                if !a.get("class").is_some_and(|c| c.ends_with(" label")) {
                    continue;
                }
                let size = number(&a, "font-size").unwrap_or(10.0);
                let width = size * text.chars().map(least_width).sum::<f64>();
                let (x, y) = (number(&a, "x").unwrap(), number(&a, "y").unwrap());
                let left = match a.get("text-anchor").map(String::as_str) {
                    Some("end") => x - width,
                    Some("middle") => x - width / 2.0,
                    _ => x,
                };
                labels.push([left, y - 0.75 * size, left + width, y + 0.2 * size]);
            }
            for (i, a) in labels.iter().enumerate() {
                for b in &labels[..i] {
                    let apart = a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
                    assert!(apart, "{a:?} {b:?} in {}", &svg[..200]);
                }
            }
        }
    }
}

/// A dot of Fig. 1 stands where its row of the table puts it.
#[test]
fn plotted_numbers_are_in_the_csv() {
    let table = csv(&ONE);
    let mut rows = table.lines();
    let header: Vec<&str> = rows.next().unwrap().split(',').collect();
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let (p, a) = (column("mean_pressure [Pa]"), column("area_fraction_deterministic [-]"));
    let cells = rows.map(|r| r.split(',').collect::<Vec<_>>());
    let numbers = cells.map(|r| [p, a].map(|column| r[column].parse::<f64>().unwrap()));
    let numbers: Vec<[f64; 2]> = numbers.collect();
    assert_eq!(numbers.len(), ONE.surfaces[0].deterministic.len());

    let circles = elements(&file(&ONE, "area.svg")).into_iter().filter(|(n, ..)| n == "circle");
    let dots = circles.map(|(_, a, _)| ["cx", "cy"].map(|key| a[key].parse::<f64>().unwrap()));
    let dots: Vec<[f64; 2]> = dots.collect();
    assert_eq!(dots.len(), numbers.len());
    // Both axes are logarithmic: positions are linear in the logarithms of the table.
    for axis in 0..2 {
        let (n, last) = (dots.len(), dots.len() - 1);
        let slope =
            (dots[last][axis] - dots[0][axis]) / (numbers[last][axis] / numbers[0][axis]).ln();
        for i in 0..n {
            let expected = dots[0][axis] + slope * (numbers[i][axis] / numbers[0][axis]).ln();
            let found = dots[i][axis];
            assert!((found - expected).abs() < 0.02, "dot {i}: {found} {expected}");
        }
    }
}

/// A model whose formula is a line has it below the table in which it is ranked.
#[test]
fn the_fitted_formula_is_printed() {
    let page = html(&ONE);
    let formula =
        &ONE.surfaces[0].models.iter().find(|m| m.card.name == "equation").unwrap().card.formula;
    assert!(formula.contains("0.445") && page.contains(&format!("Equation: {formula}.")));
}

#[test]
fn the_headline_agrees_with_table_and_csv() {
    let page = html(&ONE);
    let surface = &ONE.surfaces[0];
    let budget = surface.headline_answer().unwrap().budget.area;
    let area = 100.0 * budget.value;
    let h1 = &page[page.find("<h1>").unwrap()..page.find("</h1>").unwrap()];
    let bold = &h1[h1.find("<b>").unwrap() + 3..h1.find("</b>").unwrap()];
    // A map of 96 points a side, whose load few blocks carry, may say the upper end alone.
    let (number, stands_for) = match bold.strip_prefix("at most ") {
        Some(most) => (most, 100.0 * budget.prediction().unwrap()[1]),
        None => (bold, area),
    };
    let number = number.split([' ', '\u{202F}']).next().unwrap();
    let printed: f64 = number.parse().unwrap();
    assert!((printed / stands_for - 1.0).abs() < 0.03, "{printed} {stands_for}");
    assert!(page.matches(bold).count() >= 2, "headline and key number: prediction");
    // The model table and the read-out carry the same interval.
    let stated = budget.prediction().unwrap()[1] - budget.value;
    assert!(stated > budget.half_width().unwrap());
    let row = &page[page.find("data-k=\"a-det\"").unwrap()..];
    let cell = &row[row.find('>').unwrap() + 1..row.find("</td>").unwrap()];
    assert!(page.matches(cell).count() >= 3, "table, read-out, slider: {cell}");
    let (said, expected) = match cell.strip_prefix("at most ") {
        Some(most) => (most, stands_for),
        None => (cell.split_once("± ").unwrap().1, 100.0 * stated),
    };
    let said: f64 = said.split([' ', '\u{202F}']).next().unwrap().parse().unwrap();
    assert!((said / expected - 1.0).abs() < 0.35, "{said} {expected}");
}

/// The same study gives the same bytes, times excepted.
#[test]
fn the_report_is_deterministic() {
    let timeless = |mut comparison: Comparison| {
        comparison.seconds = 1.0;
        for surface in &mut comparison.surfaces {
            surface.setup_seconds = 1.0;
            for answer in surface.deterministic.iter_mut().filter_map(|p| p.answer.as_mut()) {
                answer.diagnostics.seconds = 1.0;
            }
            for curve in surface.models.iter_mut().filter_map(|m| m.outcome.as_mut().ok()) {
                (curve.preparation, curve.seconds) = (1e-3, 1e-6);
            }
        }
        comparison
    };
    let settings = |threads| Settings { threads, ..Settings::default() };
    let a = timeless(run(small(&["blasted"]), settings(1)));
    let mut b = timeless(run(small(&["blasted"]), settings(2)));
    b.settings.threads = 1;
    assert!(html(&a) == html(&b));
    assert_eq!(csv(&a), csv(&b));
}

/// A stiffness with both intervals, choices with what they do.
#[test]
fn the_budget_has_every_source_and_choices_are_listed() {
    let surface = &ONE.surfaces[0];
    let answer = surface.headline_answer().unwrap();
    let stiffness = answer.budget.stiffness.unwrap();
    let [low, high] = stiffness.interval().unwrap();
    let [lowest, highest] = stiffness.prediction().unwrap();
    assert!(lowest < low && low < stiffness.value && stiffness.value < high && high < highest);
    // The slope of the curve between the loads beside the headline holds it.
    let gap = |i: usize| surface.deterministic[i].answer.as_ref().unwrap().mean_gap.unwrap();
    let load = |i: usize| surface.deterministic[i].mean_pressure;
    let h = surface.headline;
    let slope =
        surface.headline_pressure() * (load(h + 1) / load(h - 1)).ln() / (gap(h - 1) - gap(h + 1));
    assert!((stiffness.value / slope - 1.0).abs() < 0.1, "{} {slope}", stiffness.value);
    assert!(!surface.choices.as_ref().unwrap().is_empty());
    let page = html(&ONE);
    let sources = ["Of this map ±", "Sampling variability", "Of the surface ±"];
    for words in sources.into_iter().chain(["Choices that move the answer"]) {
        assert!(page.contains(words), "{words}");
    }
}

/// Grids that were solved are in Fig. 4 and in the results; those that were not asked for are nowhere.
#[test]
fn coarser_grids_are_drawn_and_listed_where_they_were_solved() {
    let page = html(&ONE);
    let figure = figures(&page).find(|svg| svg.contains("Error against time")).unwrap();
    let value = results(&ONE);
    let listed = value["surfaces"][0]["coarser"].as_array().unwrap();
    // 96 x 96 points: an eighth of them a side are too few.
    assert_eq!(listed.len(), 2);
    for (grid, label) in listed.iter().zip(["½ grid", "¼ grid"]) {
        assert!(figure.contains(label), "{label}");
        let area = grid["area_fraction"].as_f64().unwrap();
        let truth = ONE.surfaces[0].headline_answer().unwrap().area_fraction;
        assert!((grid["area_error"].as_f64().unwrap() - (area / truth - 1.0)).abs() < 1e-12);
    }
    let page = html(&THREE);
    assert!(!page.contains("½ grid"));
}

#[test]
fn a_flat_surface_is_answered() {
    let grid = Grid::new([16, 16], [1e-6, 1e-6]).unwrap();
    let heights = HeightMap::new(grid, vec![2e-6; 256]).unwrap();
    let file = FileOrigin { path: "flat".into(), fill: "refuse".into(), ..FileOrigin::default() };
    let surface = Surface { name: "flat".into(), origin: Origin::File(file), heights };
    let comparison = run(vec![surface], Settings::default());
    let answer = comparison.surfaces[0].headline_answer().unwrap();
    assert!((answer.area_fraction - 1.0).abs() < 1e-12);
    let page = html(&comparison);
    assert!(page.contains("flat") && !page.contains("NaN"));
}

/// All words of the page, folded ones and numbers of tables among them; not those of figures.
fn words(page: &str) -> usize {
    let mut text = page.split("<body>").nth(1).unwrap().to_owned();
    for name in ["svg", "script"] {
        let (begins, ends) = (format!("<{name}"), format!("</{name}>"));
        let mut parts = text.split(&begins);
        let first = parts.next().unwrap().to_owned();
        text = first + &parts.map(|part| part.split_once(&ends).unwrap().1).collect::<String>();
    }
    let within_a_word = ["a", "b", "code", "i", "span", "sub", "sup"];
    let piece = |piece: &str| {
        // An attribute may hold the sign that ends an element; text does not.
        let (tag, text) = piece.rsplit_once('>').unwrap_or(("b", piece));
        let name = tag.trim_start_matches('/').split(' ').next().unwrap();
        if within_a_word.contains(&name) { text.to_owned() } else { format!(" {text}") }
    };
    text.split('<').map(piece).collect::<String>().split_whitespace().count()
}

/// Of an elastic map, and of one that yields and conducts, with two panels of each curve.
#[test]
fn the_page_is_short() {
    let count = [&*ONE, &*YIELDING].map(|study| words(&html(study)));
    let most = [1104, 1354].map(|page| page + 12 * ONE.surfaces[0].models.len());
    assert!(count[0] <= most[0] && count[1] <= most[1], "{count:?} words");
}
