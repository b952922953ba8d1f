//! What the slider and the zoom of a report show is what the solver found, at every load.

use crate::studies::{ONE, YIELDING, all, html};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use contact_compare::{Load, Solver, SurfaceComparison};
use serde_json::Value;

/// The element that begins so, up to its end.
fn element<'a>(page: &'a str, begins: &str) -> &'a str {
    let rest = page.split(begins).nth(1).unwrap_or_else(|| panic!("no {begins}"));
    rest.split('>').next().unwrap()
}

fn facts(element: &str) -> Value {
    let text = element.split('\'').nth(1).unwrap();
    let text = text.replace("&lt;", "<").replace("&#39;", "'").replace("&amp;", "&");
    serde_json::from_str(&text).unwrap()
}

fn grey(element: &str) -> Vec<u8> {
    let file = element.split("src=\"data:image/png;base64,").nth(1).unwrap().split('"').next();
    let file = STANDARD.decode(file.unwrap()).unwrap();
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut grey = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut grey).unwrap();
    grey
}

/// The one picture behind the slider holds the solver's contact at every load, point by point; that of the
/// pressure the contact of the headline, and its pressures to a step of the ramp.
#[test]
fn the_moving_map_is_the_contact_of_every_load() {
    let page = html(&ONE);
    let surface = &ONE.surfaces[0];
    // Load of first contact and pressure of the headline, in grey. Facts may hold the sign that ends an element, in quotes.
    let behind = page.split("<img class=\"first\"").nth(1).unwrap();
    let (facts, first) = (facts(behind), grey(behind));
    let pressure = grey(element(&page, "<img class=\"pressure\""));
    assert_eq!(first.len(), surface.solved_map().grid().len());
    let (step, lost) = (facts["step"].as_u64().unwrap(), facts["lost"].as_array().unwrap());
    for (load, point) in surface.deterministic.iter().enumerate() {
        let off = lost.iter().filter(|l| l[0] == load).count();
        let touching = first.iter().filter(|g| u64::from(**g) <= load as u64 * step).count() - off;
        let solved = point.answer.as_ref().unwrap().diagnostics.contact_pixels;
        assert_eq!(touching, solved, "load {load}");
        assert!(facts["titles"][load].as_str().unwrap().contains(&format!(" {touching} of ")));
    }
    let headline = surface.headline as u64 * step;
    let top = surface.pressure.iter().zip(&pressure).filter(|(_, c)| **c == 255).map(|(p, _)| *p);
    let top = top.fold(f64::INFINITY, f64::min); // half a step below the end of the ramp
    for (i, (g, p)) in first.iter().zip(&surface.pressure).enumerate() {
        let lost = lost.iter().any(|l| l[0] == surface.headline && l[1] == i);
        assert_eq!(u64::from(*g) <= headline && !lost, *p > 0.0, "point {i}");
        assert_eq!(pressure[i] > 0, *p > 0.0, "pressure of point {i}");
        let shown = f64::from(pressure[i]) / 255.0;
        assert!(pressure[i] <= 1 || (shown - (p / top).min(1.0)).abs() < 0.01, "point {i}");
    }
}

/// Solved once more with whole maps: the section of the page is their row at every load, gaps to half a step
/// of what 16 bits hold, its flat the mean gap.
fn holds_the_row(surface: &SurfaceComparison, page: &str, settings: &contact_compare::Settings) {
    let facts = facts(page.split("<span class=\"cut\"").nth(1).unwrap());
    let map = surface.solved_map();
    let [ny, nx] = map.grid().shape();
    let row = (facts["row"].as_f64().unwrap() * ny as f64 - 0.5).round() as usize;
    let along = row * nx..(row + 1) * nx;
    let sixteen = |name: &str| -> Vec<f64> {
        let bytes = STANDARD.decode(facts[name].as_str().unwrap()).unwrap();
        bytes.chunks(2).map(|b| f64::from(u16::from_le_bytes([b[0], b[1]]))).collect()
    };
    let (step, low) = (facts["step"].as_f64().unwrap(), facts["low"].as_f64().unwrap());
    let half = 0.5 * step * (1.0 + 1e-6);
    for (stored, height) in sixteen("heights").iter().zip(&map.heights()[along.clone()]) {
        assert!((low + step * stored - (height - map.mean())).abs() <= half);
    }
    let mut solver = Solver::builder()
        .method(settings.method)
        .precision(settings.precision)
        .tolerance(settings.tolerance)
        .threads(1)
        .hardness(settings.hardness.unwrap_or(f64::INFINITY))
        .build(map.grid(), surface.inputs.modulus)
        .unwrap();
    let (gaps, pressures) =
        (sixteen("gaps"), STANDARD.decode(facts["pressures"].as_str().unwrap()));
    let (pressures, mut touched, mut open) = (pressures.unwrap(), 0, 0);
    let tops = &self::facts(page.split("<img class=\"first\"").nth(1).unwrap())["tops"];
    assert_eq!(gaps.len(), nx * surface.deterministic.len());
    for (load, point) in surface.deterministic.iter().enumerate() {
        let found = solver.solve(map, Load::MeanPressure(point.mean_pressure)).unwrap();
        holds_the_pressure(&found.pressure, page, load, load == surface.headline, &tops[load]);
        let (spots, _) = contact_compare::contact_spots(&found.pressure, map.grid(), true);
        let again = contact_compare::Distributions::of(&found.pressure, &found.gap, &spots);
        assert!(again.as_ref().is_some_and(|d| d.gap.is_some()));
        assert_eq!(surface.distributions[load], again, "load {load}");
        let flat = facts["flats"][load].as_f64().unwrap();
        assert!((flat / found.state.mean_gap.unwrap() - 1.0).abs() < 1e-12, "load {load}");
        for (i, at) in along.clone().enumerate() {
            let touches = found.pressure[at] > 0.0;
            let gap = if touches { 0.0 } else { found.gap[at].max(0.0) };
            let stored = step * gaps[load * nx + i];
            assert!((stored - gap).abs() <= half, "load {load}, point {i}: {stored} {gap}");
            assert_eq!(pressures[load * nx + i] > 0, touches, "load {load}, point {i}");
            touched += usize::from(touches);
            open += usize::from(gap > half);
        }
    }
    assert!(touched > 10 && open > 10, "{touched} {open}");
}

/// Every point of a map that is not reduced has its pressure, to half a step of 255 up to the 99th percentile.
fn holds_the_pressure(found: &[f64], page: &str, load: usize, headline: bool, top: &Value) {
    let begins = format!("<img class=\"pressed\" hidden alt=\"\" data-load=\"{load}\"");
    if headline {
        assert!(!page.contains(&begins) && top.is_null(), "the headline has the whole map");
        return;
    }
    let classes = grey(element(page, &begins));
    let mut contact: Vec<f64> = found.iter().copied().filter(|p| *p > 0.0).collect();
    contact.sort_by(f64::total_cmp);
    let high = contact[(contact.len() - 1) * 99 / 100];
    let rounded: f64 = format!("{high:.1e}").parse().unwrap();
    let digits = top.as_str().unwrap().trim_start_matches('≥').replace('\u{202F}', "");
    let shown: f64 = digits.parse().unwrap();
    let thousands = (rounded / shown).log10() / 3.0; // the unit of the headline
    assert!((thousands - thousands.round()).abs() < 0.02, "{shown} {rounded}");
    assert_eq!(top.as_str().unwrap().starts_with('≥'), contact[contact.len() - 1] > rounded);
    for (i, (class, p)) in classes.iter().zip(found).enumerate() {
        assert_eq!(*class > 0, *p > 0.0, "load {load}, point {i}");
        let shown = f64::from(*class) / 255.0;
        let off = (shown - (p / rounded).min(1.0)).abs();
        assert!(*class <= 1 || off <= 0.5 / 255.0 + 1e-9, "load {load}, point {i}: {shown} {p}");
    }
    assert_eq!(classes.len(), found.len());
}

#[test]
fn the_section_is_the_solver_s_gap_at_every_load() {
    for study in [&*ONE, &*YIELDING] {
        holds_the_row(&study.surfaces[0], &html(study), &study.settings);
    }
}

/// Without scripts the section of the headline stands there, with its numbers, and the row on the map.
#[test]
fn every_surface_that_is_rough_has_its_section() {
    for study in all() {
        let page = html(study);
        let count = page.matches("Section</b> along the dashed line").count();
        assert_eq!(count, study.surfaces.len());
        assert_eq!(page.matches(" of this line touches.</desc>").count(), count);
        // On the map, and once more in the enlargement if the row crosses it.
        assert!(page.matches("stroke-dasharray=\"4 3\"").count() >= count);
    }
}

/// In a row of the table, a line in every figure over the load, a cell for each load in the lists.
#[test]
fn models_carry_their_names_through_the_page() {
    for study in all() {
        let page = html(study);
        for surface in &study.surfaces {
            for model in surface.models.iter().filter(|m| m.outcome.is_ok()) {
                let name = &model.card.name;
                assert!(page.contains(&format!("<tr data-m=\"{name}\">")), "{name}");
                // A line and a label in each of three figures.
                assert!(page.matches(&format!("<g data-m=\"{name}\">")).count() >= 4, "{name}");
            }
            for line in page.split("<script type=\"application/json\">").skip(1) {
                let data = line.split("</script>").next().unwrap().replace("\\u003c", "<");
                let data: Value = serde_json::from_str(&data).unwrap();
                let listed = data["models"].as_array().unwrap();
                assert!(listed.len() > 1 && listed[0]["name"] == "det");
                for name in listed.iter().map(|model| model["name"].as_str().unwrap()) {
                    // A solution is the reference and has no error.
                    let is_solution = ["det", "elastic"].contains(&name);
                    for letter in ["a", "p", "e"].iter().filter(|l| **l != "e" || !is_solution) {
                        let cells = data["cells"][format!("{letter}-{name}")].as_array().unwrap();
                        assert_eq!(cells.len(), data["read"].as_array().unwrap().len());
                    }
                }
            }
        }
    }
}
