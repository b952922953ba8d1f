//! The report on profiles: trace, roughness, spectrum, models with what the length leaves open.

use crate::draw::svg::escape;
use crate::figures::profiles;
use crate::figures::surface::{Spectrum, spectrum};
use crate::messages;
use crate::messages::loads::loads_line;
use crate::messages::profile::{area_range, profile_headline, spread};
use crate::numbers::{METRES, PASCALS, SPACE, chosen, percent, quantity, significant, unit_for};
use crate::page::how_made::{bodies_words, modulus_in_head, origin_words};
use crate::page::html::{document, references};
use crate::page::sections::notes;
use crate::page::shared::{Numbering, date, key_table, row, table, terms, why};
use crate::page::tables::{applies, cells, cited, model_area, model_head, model_pressure};
use crate::provenance::Provenance;
use contact_compare::{ModelComparison, ProfileComparison};
use contact_types::SpectralMoments;
use surface_stats::profile::{ParameterMean, ProfileStatistics, SettingSource};

pub(crate) fn report(studies: &[ProfileComparison], provenance: &Provenance) -> String {
    let several = studies.len() > 1;
    let mut numbers = Numbering::default();
    let mut body = String::new();
    if several {
        body += &format!("<h1>{} profiles of surfaces</h1>\n", studies.len());
    }
    for (index, study) in studies.iter().enumerate() {
        let (id, name) = (&*format!("s{index}"), escape(&study.surface.name));
        let heading = if several { format!("<h2>{name}</h2>\n") } else { String::new() };
        let (h, numbers) = (if several { "h3" } else { "h2" }, &mut numbers);
        let (opening, key) = (opening(study, several, provenance), key_numbers(study));
        let notes = notes(&study.findings(), id);
        let (pictures, models) = (pictures(study, numbers, h, id), models(study, numbers, h, id));
        let (roughness, sampling) = (roughness(study), sampling(study));
        body += &format!(
            "<div class=\"surface\">\n{heading}{opening}<div class=\"two\">\n{key}{notes}</div>\n{pictures}{models}\
             <{h}>Roughness parameters</{h}>\n{roughness}\
             <{h}>What the spacing of the points does</{h}>\n{sampling}</div>\n"
        );
    }
    body += &how_made(studies, provenance);
    body += &references(&numbers.sources);
    let title = match studies {
        [one] => format!("{} (rough-contact, profile)", one.surface.name),
        many => format!("{} profiles (rough-contact)", many.len()),
    };
    document(&title, several, &body, "")
}

fn opening(study: &ProfileComparison, several: bool, provenance: &Provenance) -> String {
    let s = &study.statistics;
    let traces = if s.traces == 1 { "one trace".into() } else { format!("{} traces", s.traces) };
    let (name, date) = (escape(&study.surface.name), date(provenance.unix_time));
    let say = escape(&profile_headline(study));
    let [before, after, first] = if several {
        [String::new(), String::new(), format!("<p class=\"say\">{say}</p>")]
    } else {
        let before = format!("rough-contact report · <b>{name}</b> · ");
        [before, format!(" · {date}"), format!("<h1>{say}</h1>")]
    };
    let (points, modulus) = (s.points, modulus_in_head(&study.settings));
    let (length, spacing) = (chosen(s.length, METRES), quantity(s.spacing, METRES, 3));
    format!(
        "<header><p class=\"file\">{before}profile, {traces} of {length}, {points} points every {spacing} · \
         {modulus}{after}</p>\n{first}\n<p>A trace is one line of a surface: it has no \
         deterministic answer but that of parallel ridges \
         (<code>solve --plane-strain</code>). The models take the moments of the trace for those of \
         an isotropic surface.</p></header>\n"
    )
}

fn pictures(study: &ProfileComparison, numbers: &mut Numbering, h: &str, id: &str) -> String {
    let s = &study.statistics;
    let mut out = format!("<{h}>The trace</{h}>\n");
    let first = if s.traces > 1 { " The first of them." } else { "" };
    let caption = format!(
        "The trace</b> without its form.{first} Shaded: every other section length of the roughness \
         parameters."
    );
    let drawn = numbers.figure(id, profiles::first_trace(study), &caption);
    if !drawn.is_empty() {
        out.push_str(&format!("<div class=\"wide\">{drawn}</div>\n"));
    }
    let smoothed = study.spectrum.smoothed();
    let mut points: Vec<_> = smoothed.iter().map(|[f, psd]| [1.0 / f, *psd]).collect();
    let mut last = f64::INFINITY;
    // About 24 points per octave: what a figure can show.
    points.retain(|[wavelength, _]| {
        let is_kept = *wavelength <= last / 1.03;
        last = if is_kept { *wavelength } else { last };
        is_kept
    });
    let fit = s.hurst.zip(s.fractal_range);
    let psd = Spectrum { points, fit, is_profile: true };
    let caption = "Power spectral density</b> of the trace, one-sided, under a Hann window, running mean over \
                   a third of an octave.";
    let mut two = numbers.figure(id, spectrum(&psd), caption);
    let traces = if s.traces == 1 { "trace" } else { "traces" };
    let caption = format!(
        "Real contact area</b> by every model that answers, for an isotropic surface. Grey band: from the lowest to \
         the highest of those made of moments, with the 95{SPACE}% intervals that the length of the {traces} leaves."
    );
    two += &numbers.figure(id, profiles::area(study), &caption);
    out + &format!("<div class=\"two\">\n{two}</div>\n")
}

fn models(study: &ProfileComparison, numbers: &mut Numbering, h: &str, id: &str) -> String {
    let p = chosen(study.pressures[study.headline], PASCALS);
    let line = |(place, m): (usize, &ModelComparison)| {
        let card = &m.card;
        let source = cited(numbers, card.citation.clone());
        let curve = m.outcome.as_ref().ok();
        let point = curve.map(|c| &c.points[study.headline]);
        let dash = || "–".to_owned();
        let interval = curve.and_then(|c| c.intervals[study.headline]);
        let cells = cells([
            ("Area", "", point.map_or_else(dash, model_area)),
            ("95 % interval", "", interval.map_or_else(dash, area_range)),
            ("Real pressure", "", point.map_or_else(dash, model_pressure)),
        ]);
        let class = if m.outcome.is_ok() { "" } else { " class=\"na\"" };
        let head = model_head(card, place);
        let applies = applies(m.verdict.answer, &messages::reason_of(card, &m.verdict));
        format!("<tr{class}>{head}{cells}{applies}{source}</tr>\n")
    };
    let rows: String = study.models.iter().enumerate().map(line).collect();
    let columns = format!(
        "Model|#Area at {p}|#95{SPACE}% interval|#Real pressure|Applies, if the surface is isotropic?|#Ref."
    );
    let table = table(r#"class="models""#, "", &columns, &rows);
    format!(
        "<{h} id=\"{id}-m\">What the models say</{h}>\n{table}\
         <p class=\"why\">The interval is what other traces of the same surface would give, through \
         <i>m</i><sub>0</sub>, <i>m</i><sub>2</sub>, <i>m</i><sub>4</sub>; the error of the theory is \
         not in it. Amplitudes are those of the smoothed PSD, the nominal area of Majumdar and Bhushan \
         is the square of the length: these models carry no interval here.</p>\n"
    )
}

fn how_made(studies: &[ProfileComparison], made: &Provenance) -> String {
    let mut rows = vec![(
        "Program".to_owned(),
        format!("rough-contact {}, {}", escape(&made.version), escape(&made.platform)),
    )];
    for study in studies {
        let name = if studies.len() > 1 { escape(&study.surface.name) } else { "Input".to_owned() };
        let s = &study.statistics;
        let form = match s.options.degree {
            0 => "mean taken off".to_owned(),
            1 => "line taken off by least squares".to_owned(),
            n => format!("polynomial of degree {n} taken off by least squares"),
        };
        let filter = |name: &str, value: Option<f64>| {
            value.map_or(String::new(), |v| format!("; {name} = {}", chosen(v, METRES)))
        };
        let filters = filter("λs", s.options.short) + &filter("λc", s.options.cutoff);
        rows.push((name, format!("{}. {form}{filters}", origin_words(&study.surface.origin))));
        for step in study.surface.origin.cleaned() {
            rows.push(("Cleaning".into(), escape(&step.to_string())));
        }
        if let Some(step) = s.height_step {
            rows.push(("Height step".into(), quantity(step, METRES, 2)));
        }
        if let Some([m2, m4]) = s.seen {
            let (m2, m4) = (percent(m2), percent(m4));
            let text = format!(
                "finite differences of neighbouring points; they recover {m2} of m₂ and {m4} of m₄ of the spectrum"
            );
            rows.push(("Moments".into(), text));
        }
    }
    if let Some(first) = studies.first() {
        let settings = &first.settings;
        rows.push(("Material".into(), bodies_words(settings)));
        rows.extend(loads_line(settings).map(|words| ("Loads".into(), words)));
    }
    let (terms, repeat) = (terms(&rows), escape(&made.repeat));
    format!(
        "<h2>How this was made</h2>\n{terms}<p>Repeat, from the folder it was made in, \
         with</p><pre>{repeat}</pre>\n<p class=\"why\">The numbers behind the figures are in \
         <code>curves.csv</code>, all results in <code>results.json</code>, every setting in \
         <code>run.toml</code>.</p>\n"
    )
}

fn key(name: &str, value: String, why: impl Into<String>) -> [String; 3] {
    [name.into(), value, why.into()]
}

/// Moments with what the length leaves open, and what is made of them.
fn key_numbers(study: &ProfileComparison) -> String {
    let s = &study.statistics;
    let m = s.moments;
    let ends = |k: usize| {
        let factor =
            s.intervals[k].and_then(|[low, high]| (low > 0.0).then(|| (high / low).sqrt()));
        spread(factor)
    };
    let height = unit_for(m.rms_height(), METRES);
    let gradient = significant(m.rms_gradient(), 3);
    let mut rows = vec![
        key(
            "<i>m</i><sub>0</sub>",
            format!("{}{SPACE}{}²", significant(m.m0 / height.scale.powi(2), 3), height.name),
            format!("{}; rms height {}", ends(0), quantity(m.rms_height(), METRES, 3)),
        ),
        key(
            "<i>m</i><sub>2</sub>",
            significant(m.m2, 3),
            format!("{}; rms gradient of the surface {gradient}", ends(1)),
        ),
        key(
            "<i>m</i><sub>4</sub>",
            format!("{}{SPACE}µm⁻²", significant(m.m4 * 1e-12, 3)),
            ends(2),
        ),
    ];
    if let Some(bandwidth) = s.bandwidth {
        rows.push(key("Bandwidth <i>α</i>", significant(bandwidth, 3), "m₀ m₄ / m₂²"));
    }
    if let Some(a) = s.asperities {
        let density = format!("{}{SPACE}mm⁻²", significant(a.density * 1e-6, 3));
        let [radius, height] = [a.radius, a.height_std].map(|l| quantity(l, METRES, 3));
        let of = "of the isotropic Gaussian surface";
        let why = format!("radius {radius}, height deviation {height}, {of}");
        rows.push(key("Summits", density, why));
    }
    if let (Some(hurst), Some([short, long])) = (s.hurst, s.fractal_range) {
        rows.push(key(
            "Hurst exponent",
            significant(hurst, 2),
            format!("PSD between {} and {}", quantity(long, METRES, 2), quantity(short, METRES, 2)),
        ));
    }
    if let Some(rolloff) = s.rolloff {
        rows.push(key("Roll-off", quantity(rolloff, METRES, 2), "longer waves have a flat PSD"));
    }
    if let Some(rms) = s.noise_rms {
        let why = s.reliable_wavelength.map_or("nothing stands out of it".to_owned(), |l| {
            format!("waves longer than {} stand out of it", quantity(l, METRES, 2))
        });
        rows.push(key("Noise", quantity(rms, METRES, 2), why));
    }
    let traces = if s.traces == 1 { "trace" } else { "traces (mean)" };
    key_table(&format!("Moments of the {traces}, finite differences"), &rows)
}

fn shown(symbol: &str, value: Option<f64>) -> String {
    let Some(value) = value else { return "–".into() };
    match &symbol[1..] {
        "sk" | "ku" | "dq" => significant(value, 3).replace('-', "\u{2212}"),
        "mr1" | "mr2" => percent(value),
        _ => quantity(value, METRES, 3),
    }
}

fn meaning(symbol: &str) -> &'static str {
    match &symbol[1..] {
        "a" => "mean absolute height",
        "q" => "rms height",
        "z" => "highest less lowest, mean of the sections",
        "p" => "highest peak, mean of the sections",
        "v" => "deepest pit, mean of the sections",
        "t" => "highest less lowest of the whole evaluation length",
        "sk" => "skewness",
        "ku" => "kurtosis",
        "dq" => "rms slope, seven-point differences",
        "Sm" => "mean width of the profile elements",
        "k" => "core height",
        "pk" => "reduced peak height",
        "vk" => "reduced valley depth",
        "mr1" => "material ratio at the top of the core",
        "mr2" => "material ratio at the bottom of the core",
        _ => "",
    }
}

/// Which waves are roughness and how long a part was evaluated: plain text.
pub fn setting_words(s: &ProfileStatistics) -> String {
    let found = match &s.roughness {
        Ok(found) => found,
        Err(error) => return format!("No roughness parameters: {error}."),
    };
    let (setting, sections) = (found.setting, found.sections);
    let why = match setting.source {
        SettingSource::Asked => "as asked for".to_owned(),
        SettingSource::Class(n) => format!("setting class Sc{n} of ISO 21920-3, by Ra"),
        SettingSource::Longest(n) => {
            format!("setting class Sc{n} of ISO 21920-3, the coarsest that the length allows")
        }
    };
    let short = setting
        .short
        .map_or_else(|| "no λs".to_owned(), |short| format!("λs = {}", chosen(short, METRES)));
    let number = if sections == 1 { "section length" } else { "section lengths" };
    let five = if sections < 5 { " (five are usual)" } else { "" };
    format!(
        "Gaussian filter (ISO 16610-21): λc = {}, {short}; {why}. {sections} {number}{five} evaluated; \
         half a cut-off is left out at both ends, where the filter sees one side only.",
        chosen(setting.cutoff, METRES)
    )
}

fn roughness(study: &ProfileComparison) -> String {
    let s = &study.statistics;
    let several = s.traces > 1;
    let line = |(k, whole): (usize, &ParameterMean)| {
        let symbol = whole.symbol.as_str();
        let rough = s.roughness.as_ref().ok().map(|found| &found.parameters[k]);
        let numbers = [
            shown(symbol, rough.and_then(|r| r.mean)),
            shown(symbol, rough.and_then(|r| r.deviation)),
            shown(symbol, whole.mean),
            shown(symbol, whole.deviation),
        ];
        let (head, meaning) = (format!("R{0}, P{0}", &symbol[1..]), why(meaning(symbol)));
        match numbers {
            all if several => row(&head, all, &meaning),
            [rough, _, whole, _] => row(&head, [rough, whole], &meaning),
        }
    };
    let rows: String = s.primary.iter().enumerate().map(line).collect();
    let deviation = if several { "#s|" } else { "" };
    let columns = format!("ISO 21920-2|#Roughness R|{deviation}#Whole trace P|{deviation}");
    let table = table(r#"class="stat""#, "", &columns, &rows);
    format!("<p>{}</p>\n{table}", escape(&setting_words(s)))
}

fn sampling(study: &ProfileComparison) -> String {
    let s = &study.statistics;
    let Some((_, first)) = s.by_spacing.first() else { return String::new() };
    let ratio = |value: f64, of: f64| if of > 0.0 { percent(value / of) } else { "–".into() };
    let line = |(distance, m): &(f64, SpectralMoments)| {
        row(&quantity(*distance, METRES, 3), [ratio(m.m2, first.m2), ratio(m.m4, first.m4)], "")
    };
    let rows: String = s.by_spacing.iter().take(8).map(line).collect();
    let seen = s.seen.map_or(String::new(), |[m2, m4]| {
        let (m2, m4) = (percent(m2), percent(m4));
        format!(
            "Differences of neighbouring points recover {m2} of m₂ and {m4} of m₄ of the waves in the trace. "
        )
    });
    let caption = "Differences over longer distances, against those of neighbours";
    let columns = "Distance|#<i>m</i><sub>2</sub>|#<i>m</i><sub>4</sub>";
    let table = table(r#"class="stat""#, caption, columns, &rows);
    format!(
        "<p>{seen}A stylus smooths what is narrower than its tip, which no number here can undo.</p>\n{table}"
    )
}
