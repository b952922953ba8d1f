//! The page over many maps: distributions, not a section for each.

use crate::digest::Quantiles;
use crate::draw::svg::escape;
use crate::figures::spread::{Curves, Strip, curves, histograms, strips};
use crate::messages;
use crate::numbers::{
    AREAS, METRES, NEWTONS, PASCALS, SPACE, Unit, chosen, counted, percent, quantity,
    signed_percent, significant, unit_for,
};
use crate::page::how_made::{
    bodies_words, hardness_words, level_words, materials_words, modulus_in_head, program_words,
};
use crate::page::html::document;
use crate::page::shared::{Numbering, date, row, table, why, wide};
use crate::page::tables::swatch;
use crate::plot_styles::plot_style;
use crate::provenance::Provenance;
use contact_compare::{Card, Settings, Theory, built_in};
use contact_types::Named;
use serde_json::Value;

/// A run over many maps.
#[derive(Debug)]
pub struct Summary<'a> {
    /// Name and [digest](crate::digest) of each map with an answer.
    pub maps: Vec<(String, &'a Value)>,
    /// Name of each file without one, and why.
    pub failed: Vec<(String, String)>,
    /// What was asked.
    pub settings: &'a Settings,
    /// Wall-clock time of all of it (s).
    pub seconds: f64,
}

const MOST_LISTED: usize = 1000;

impl Summary<'_> {
    fn values(&self, key: &str) -> Vec<Option<f64>> {
        self.maps.iter().map(|(_, map)| map[key].as_f64().filter(|v| v.is_finite())).collect()
    }

    fn errors(&self, model: &str) -> Vec<Option<f64>> {
        self.maps.iter().map(|(_, map)| map["models"][model]["area_error"].as_f64()).collect()
    }

    fn models(&self) -> Vec<&'static Card> {
        let is_there =
            |card: &&Card| self.maps.iter().any(|(_, map)| map["models"][&*card.name].is_object());
        built_in().of_studies().map(Theory::card).filter(is_there).collect()
    }

    /// Force over pressure (m²), if the loads are forces.
    fn area(map: &Value) -> Option<f64> {
        Some(map["load"].as_f64()? / map["mean_pressure"].as_f64()?)
    }

    /// In what the loads are read that all maps were asked, if they were asked the same.
    fn shared(&self) -> Option<(&'static str, &'static [Unit])> {
        let is_force = self.maps.iter().any(|(_, map)| Self::area(map).is_some());
        let pressure = self.settings.pressures.as_ref().map(|_| ("Nominal pressure", PASCALS));
        if is_force { Some(("Load", NEWTONS)) } else { pressure }
    }

    fn curves(&self) -> Curves {
        let list = |map: &Value| -> Vec<[f64; 2]> {
            let points = map["curve"].as_array().map_or(&[][..], Vec::as_slice);
            let scale = Self::area(map).unwrap_or(1.0);
            points.iter().filter_map(|p| Some([scale * p[0].as_f64()?, p[1].as_f64()?])).collect()
        };
        let mut each: Vec<Vec<[f64; 2]>> = self.maps.iter().map(|(_, map)| list(map)).collect();
        let shared = self.shared();
        if shared.is_none() {
            for (curve, gradient) in each.iter_mut().zip(self.values("rms_gradient")) {
                let scale = self.settings.modulus * gradient.filter(|g| *g > 0.0).unwrap_or(1.0);
                for point in curve {
                    point[0] /= scale;
                }
            }
        }
        Curves { each, shared }
    }
}

/// The page over many maps.
pub fn summary_html(summary: &Summary<'_>, provenance: &Provenance) -> String {
    let count = summary.maps.len();
    let all = count + summary.failed.len();
    let settings = summary.settings;
    let hardness = settings.hardness.map(|h| format!(" · <i>H</i> = {}", chosen(h, PASCALS)));
    let (files, date) = (counted(all, "file"), date(provenance.unix_time));
    let (modulus, hardness) = (modulus_in_head(settings), hardness.unwrap_or_default());
    let (headline, standing) = (headline(summary), standing(summary));
    let mut body = format!(
        "<header><p class=\"file\">rough-contact report · {files} · {modulus}{hardness} · {date}</p>\n\
         <h1>{headline}</h1>\n<p>{standing}</p></header>\n"
    );
    if count > 0 {
        let mut numbers = Numbering::default();
        body += &load_and_errors(summary, &mut numbers);
        body += &models(summary);
        body += &distributions(summary, &mut numbers);
    }
    body += &to_check(summary);
    body += &failed(summary);
    body += &listed(summary);
    body += &how_made(summary, provenance);
    document(&format!("{} (rough-contact)", counted(all, "map")), false, &body, "")
}

fn headline(summary: &Summary<'_>) -> String {
    let sizes = |card: &'static Card| {
        let errors: Vec<f64> = summary.errors(&card.name).into_iter().flatten().collect();
        let full = errors.len() == summary.maps.len();
        let spread = Quantiles::of(errors.iter().map(|e| e.abs())).filter(|_| full)?;
        Some((card, spread.median(), Quantiles::of(errors.into_iter())?))
    };
    // Of bodies that yield a theory of elastic ones is right by accident at most.
    let ranks = |card: &&'static Card| summary.settings.hardness.is_none() || card.yields;
    let ranked = summary.models().into_iter().filter(ranks).filter_map(sizes);
    let maps = counted(summary.maps.len(), "map");
    let Some((card, size, errors)) = ranked.min_by(|a, b| a.1.total_cmp(&b.1)) else {
        return format!("{maps} solved; no closed form answers on all of them");
    };
    let [low, high] = [0.1, 0.9].map(|part| signed_percent(errors.quantile(part)));
    let (title, size) = (escape(&card.title), percent(size));
    format!(
        "Nearest over {maps}: {title}, <b>{size}</b> off in the median, 10th–90th percentile {low} to {high}"
    )
}

fn standing(summary: &Summary<'_>) -> String {
    let of = |test: fn(&Value) -> bool| summary.maps.iter().filter(|(_, map)| test(map)).count();
    let short = of(|map| map["converged"] != true);
    let bare = of(|map| !map["area_interval"].is_array());
    let warned = of(|map| map["to_check"].as_u64().is_some_and(|n| n > 0));
    let failed = match summary.failed.len() {
        0 => String::new(),
        n => format!(", <b>files without: {n}</b> (below, with the reason)"),
    };
    let loads = match summary.shared() {
        Some(_) => {
            "the same for every map; the headline is the one at which about 2 % touches, or the \
                    one asked for"
                .to_owned()
        }
        None => format!(
            "chosen for each map, from about 0.1{SPACE}% to half of it in contact; the headline is at \
             about 2{SPACE}%"
        ),
    };
    format!(
        "Maps with an answer: {}{failed}. Headlines that did not converge: {short}; without uncertainty estimate: {bare}. \
         Maps with something to check: {warned}. Loads: {loads}.",
        summary.maps.len()
    )
}

fn load_and_errors(summary: &Summary<'_>, numbers: &mut Numbering) -> String {
    let strip = |(place, card): (usize, &'static Card)| {
        let errors = Quantiles::of(summary.errors(&card.name).into_iter().flatten())?;
        let (label, look) = (card.label.to_string(), plot_style(&card.name, place));
        Some(Strip { label, look, errors })
    };
    let list: Vec<Strip> = summary.models().into_iter().enumerate().filter_map(strip).collect();
    let caption = "Real contact area</b> of every map by the deterministic solution. Thick: median; grey: 10th–90th percentile.";
    let area = numbers.figure("b", curves(&summary.curves()), caption);
    let caption = format!(
        "Error of the closed forms</b> at the headline of each map. Mark: median; bar: interquartile range; line: 10th–90th percentile. Grey: within 10{SPACE}%."
    );
    let errors = numbers.figure("b", strips(&list), &caption);
    format!("<h2>Area and load</h2>\n<div class=\"two\">\n{area}{errors}</div>\n")
}

fn models(summary: &Summary<'_>) -> String {
    let line = |(place, card): (usize, &'static Card)| {
        let name = &*card.name;
        let errors = summary.errors(name);
        let verdicts = |word: &str| {
            let is = |map: &&(String, &Value)| map.1["models"][name]["verdict"] == word;
            summary.maps.iter().filter(is).count().to_string()
        };
        let mean =
            |(_, map): &(String, &Value)| map["models"][name]["mean_absolute_area_error"].as_f64();
        let spread = Quantiles::of(errors.iter().copied().flatten());
        let over = Quantiles::of(summary.maps.iter().filter_map(mean));
        let worst = errors.iter().enumerate().filter_map(|(i, e)| Some((i, (*e)?)));
        let worst = worst.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let worst = worst.map_or("–".into(), |(i, e)| {
            format!("{}: {}", signed_percent(e), escape(&summary.maps[i].0))
        });
        let q =
            |part: f64| spread.as_ref().map_or("–".into(), |s| signed_percent(s.quantile(part)));
        let numbers = [
            errors.iter().flatten().count().to_string(),
            q(0.5),
            format!("{} to {}", q(0.1), q(0.9)),
            over.map_or("–".into(), |s| percent(s.median())),
            ["yes", "caution", "no"].map(verdicts).join(" / "),
        ];
        let swatch = swatch(plot_style(name, place));
        let head = format!("<div>{swatch}<span>{}</span></div>", escape(&card.title));
        row(&head, numbers, &why(&worst))
    };
    let rows: String = summary.models().into_iter().enumerate().map(line).collect();
    let columns = "Model|#Maps|#Median|#10th–90th percentile|#Over all loads|#Yes / caution / no|Farthest off";
    let caption = "Error of the area against the deterministic solution";
    let table = table(r#"class="models""#, caption, columns, &rows);
    format!(
        "<h2>Models</h2>\n<div class=\"scroll\" tabindex=\"0\">{}</div>\n<p class=\"why\">At the headline of each map; over all loads: median of the mean |error|.</p>\n",
        table.trim_end()
    )
}

/// A quantity whose spread is shown: its key, symbol (HTML) and name, the units it is read in, whether it is drawn.
type SpreadQuantity = (&'static str, &'static str, &'static str, &'static [Unit], bool);

const QUANTITIES: [SpreadQuantity; 14] = [
    ("rms_height", "<i>Sq</i>", "RMS height", METRES, true),
    ("rms_gradient", "<i>Sdq</i>", "RMS gradient", &[], true),
    ("bandwidth", "<i>α</i>", "Bandwidth m₀m₄/m₂²", &[], false),
    ("skewness", "<i>Ssk</i>", "Skewness", &[], false),
    ("kurtosis", "<i>Sku</i>", "Kurtosis", &[], false),
    ("hurst", "<i>H</i>", "Hurst exponent", &[], false),
    ("load", "<i>F</i>", "Headline load", NEWTONS, false),
    ("mean_pressure", "<i>p</i>", "Headline pressure", PASCALS, false),
    ("area_fraction", "<i>A</i>/<i>A</i>₀", "Real contact area", &[], true),
    ("real_pressure", "<i>p</i><sub>r</sub>", "Mean real pressure", PASCALS, true),
    ("mean_gap", "<i>ḡ</i>", "Mean gap", METRES, true),
    ("contact_spots", "<i>n</i>", "Contact spots", &[], false),
    ("median_spot_area", "", "Median spot area", AREAS, true),
    ("seconds", "", "Solver, all loads", &[Unit { scale: 1.0, name: "s" }], false),
];

fn distributions(summary: &Summary<'_>, numbers: &mut Numbering) -> String {
    let (mut drawn, mut rows) = (Vec::new(), String::new());
    for (key, symbol, name, units, is_drawn) in QUANTITIES {
        let values = summary.values(key);
        let Some(spread) = Quantiles::of(values.iter().copied().flatten()) else { continue };
        // That of the median, and of the area per cent.
        let unit = match units {
            _ if key == "area_fraction" => Unit { scale: 0.01, name: "%" },
            [] => Unit { scale: 1.0, name: "" },
            units => unit_for(spread.median(), units),
        };
        let unit_name = |before: &str, after: &str| match unit.name {
            "" => String::new(),
            unit => format!("{before}{unit}{after}"),
        };
        if is_drawn {
            let in_unit = Quantiles::of(spread.sorted.iter().map(|v| v / unit.scale));
            drawn.extend(in_unit.map(|values| (name.to_owned() + &unit_name(" (", ")"), values)));
        }
        let at = |part| significant(spread.quantile(part) / unit.scale, 3);
        let [q0, q10, q25, q50, q75, q90, q100] = [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0].map(at);
        let count = spread.sorted.len().to_string();
        let whose = |value: f64| {
            let place = values.iter().position(|v| v.is_some_and(|v| v.total_cmp(&value).is_eq()));
            place.map_or(String::new(), |i| escape(&summary.maps[i].0))
        };
        let [low, high] = spread.ends().map(whose);
        let head = format!("{name} {symbol}").trim_end().to_owned() + &unit_name(", ", "");
        let numbers = [count, q0, q10, q25, q50, q75, q90, q100];
        rows.push_str(&row(&head, numbers, &why(&format!("{low} … {high}"))));
    }
    let caption = "Distributions over the maps.</b> Maps per class; dashed: median. A logarithmic axis where the values span more \
         than a factor of eight.";
    let figure = wide(&numbers.figure("b", histograms(&drawn), caption));
    let columns = format!(
        "Quantity|#Maps|#Lowest|#10{SPACE}%|#25{SPACE}%|#Median|#75{SPACE}%|#90{SPACE}%|#Highest|Lowest … highest are of"
    );
    let caption = "Quantiles over the maps, contact at the headline";
    let table = table(r#"class="over" tabindex="0""#, caption, &columns, &rows);
    format!(
        "<h2>How the maps differ</h2>\n{figure}<div class=\"wide scroll\" tabindex=\"0\">{}</div>\n",
        table.trim_end()
    )
}

fn to_check(summary: &Summary<'_>) -> String {
    let mut kinds: Vec<(&str, usize, &str, &str)> = Vec::new();
    for (name, map) in &summary.maps {
        for check in map["checks"].as_array().into_iter().flatten() {
            let (kind, claim) = (check["kind"].as_str(), check["claim"].as_str());
            let (kind, claim) = (kind.unwrap_or_default(), claim.unwrap_or_default());
            match kinds.iter_mut().find(|k| k.0 == kind) {
                Some(known) => known.1 += 1,
                None => kinds.push((kind, 1, claim, name)),
            }
        }
    }
    if kinds.is_empty() {
        return String::new();
    }
    kinds.sort_by_key(|k| std::cmp::Reverse(k.1));
    let line = |(_, count, claim, name): &(&str, usize, &str, &str)| {
        let (claim, name) = (escape(claim), why(&escape(name)));
        format!("<tr><td class=\"n\">{count}</td><td>{claim}</td>{name}</tr>\n")
    };
    let rows: String = kinds.iter().map(line).collect();
    let columns = "#Maps|As said of the first of them|The first";
    let table = table(r#"class="over" tabindex="0""#, "By kind", columns, &rows);
    format!("<h2>To be checked before use</h2>\n{table}")
}

fn failed(summary: &Summary<'_>) -> String {
    if summary.failed.is_empty() {
        return String::new();
    }
    let line = |(name, why): &(String, String)| {
        row(&escape(name), [], &format!("<td>{}</td>", escape(why)))
    };
    let rows: String = summary.failed.iter().map(line).collect();
    let failed = summary.failed.len();
    let caption = format!("{failed} of {}", failed + summary.maps.len());
    let table = table(r#"class="key""#, &caption, "", &rows);
    format!("<h2>Files without an answer</h2>\n{table}")
}

fn listed(summary: &Summary<'_>) -> String {
    if summary.maps.is_empty() || summary.maps.len() > MOST_LISTED {
        return String::new();
    }
    let line = |(name, map): &(String, &Value)| {
        let of =
            |key: &str, write: &dyn Fn(f64) -> String| map[key].as_f64().map_or("–".into(), write);
        let check = map["to_check"].as_u64().filter(|n| *n > 0);
        let numbers = [
            of("rms_height", &|v| quantity(v, METRES, 3)),
            of("rms_gradient", &|v| significant(v, 2)),
            of("mean_pressure", &|v| messages::load(v, Summary::area(map))),
            of("area_fraction", &percent),
            check.map_or("–".into(), |n| n.to_string()),
        ];
        let other = map["against"].as_str().map_or(String::new(), |b| format!(" against {b}"));
        row(&escape(&format!("{name}{other}")), numbers, "")
    };
    let rows: String = summary.maps.iter().map(line).collect();
    let columns = "Map|#<i>Sq</i>|#<i>Sdq</i>|#Headline|#Area|#To check";
    let table = table(r#"class="over" tabindex="0""#, "", columns, &rows);
    let table = table.trim_end();
    format!("<details><summary>Every map in one line</summary>{table}</details>\n")
}

fn how_made(summary: &Summary<'_>, provenance: &Provenance) -> String {
    let settings = summary.settings;
    let solver = match settings.accuracy {
        Some(accuracy) => format!("for each map what {} of the area needs", percent(accuracy)),
        None => format!(
            "{}, {}, tolerance {:e}",
            settings.method.name(),
            settings.precision.name(),
            settings.tolerance
        ),
    };
    let program = program_words(provenance, settings, summary.seconds);
    let (bodies, materials) = (bodies_words(settings), materials_words(settings));
    let hardness = hardness_words(settings).map_or(String::new(), |words| format!("; {words}"));
    let (level, edges) = (level_words(settings.level), settings.edges.name());
    let repeat = escape(&provenance.repeat);
    format!(
        "<h2>How this was made</h2>\n<dl><dt>Program</dt><dd>{program}</dd>\n\
         <dt>Material</dt><dd>{bodies}{hardness}{materials}</dd>\n<dt>Surface</dt><dd>level: {level}; edges: \
         {edges}</dd>\n<dt>Solver</dt><dd>{solver}; area corrected for the contact line</dd></dl>\n<p>Made \
         with</p><pre>{repeat}</pre>\n<p class=\"why\">One row for each file is in <code>table.csv</code>, its results \
         in <code>results.json</code>. <code>compare</code> with one of the files alone writes its \
         report, with a closer look at its accuracy.</p>\n"
    )
}
