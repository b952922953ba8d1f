//! The report on profiles: trace, roughness, spectrum, models with what the length leaves open.

use crate::draw::svg::escape;
use crate::figures::profiles;
use crate::figures::surface::{Spectrum, spectrum};
use crate::messages;
use crate::messages::loads::loads_line;
use crate::messages::profile::{area_range, profile_headline};
use crate::numbers::{METRES, PASCALS, SPACE, chosen, percent, quantity};
use crate::page::how_made::{bodies_words, modulus_in_head, origin_words};
use crate::page::html::{document, references};
use crate::page::profile_tables::{key_numbers, roughness, sampling};
use crate::page::sections::notes;
use crate::page::shared::{Numbering, date, table, terms};
use crate::page::tables::{applies, cells, cited, model_area, model_head, model_pressure};
use crate::provenance::Provenance;
use contact_compare::{ModelComparison, ProfileComparison};

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
    format!(
        "<header><p class=\"file\">{before}profile, {traces} of {}, {} points every {} · \
         {}{after}</p>\n{first}\n<p>A trace is one line of a surface: it has no \
         deterministic answer but that of parallel ridges \
         (<code>solve --plane-strain</code>). The models take the moments of the trace for those of \
         an isotropic surface.</p></header>\n",
        chosen(s.length, METRES),
        s.points,
        quantity(s.spacing, METRES, 3),
        modulus_in_head(&study.settings)
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
            let text = format!(
                "finite differences of neighbouring points; they recover {} of m₂ and {} of m₄ of the \
                 spectrum",
                percent(m2),
                percent(m4)
            );
            rows.push(("Moments".into(), text));
        }
    }
    if let Some(first) = studies.first() {
        let settings = &first.settings;
        rows.push(("Material".into(), bodies_words(settings)));
        rows.extend(loads_line(settings).map(|words| ("Loads".into(), words)));
    }
    format!(
        "<h2>How this was made</h2>\n{}<p>Repeat, from the folder it was made in, \
         with</p><pre>{}</pre>\n<p class=\"why\">The numbers behind the figures are in \
         <code>curves.csv</code>, all results in <code>results.json</code>, every setting in \
         <code>run.toml</code>.</p>\n",
        terms(&rows),
        escape(&made.repeat)
    )
}
