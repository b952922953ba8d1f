//! Tables of the report on profiles.

use crate::messages::profile::spread;
use crate::numbers::{METRES, SPACE, chosen, percent, quantity, significant, unit_for};
use crate::page::shared::{key_table, row, table, why};
use contact_compare::ProfileComparison;
use contact_types::SpectralMoments;
use surface_stats::profile::{ParameterMean, ProfileStatistics, SettingSource};

fn key(name: &str, value: String, why: impl Into<String>) -> [String; 3] {
    [name.into(), value, why.into()]
}

/// Moments with what the length leaves open, and what is made of them.
pub(crate) fn key_numbers(study: &ProfileComparison) -> String {
    let s = &study.statistics;
    let m = s.moments;
    let ends = |k: usize| {
        let factor =
            s.intervals[k].and_then(|[low, high]| (low > 0.0).then(|| (high / low).sqrt()));
        spread(factor)
    };
    let height = unit_for(m.rms_height(), METRES);
    let mut rows = vec![
        key(
            "<i>m</i><sub>0</sub>",
            format!("{}{SPACE}{}²", significant(m.m0 / height.scale.powi(2), 3), height.name),
            format!("{}; rms height {}", ends(0), quantity(m.rms_height(), METRES, 3)),
        ),
        key(
            "<i>m</i><sub>2</sub>",
            significant(m.m2, 3),
            format!(
                "{}; rms gradient of the surface {}",
                ends(1),
                significant(m.rms_gradient(), 3)
            ),
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
        rows.push(key(
            "Summits",
            format!("{}{SPACE}mm⁻²", significant(a.density * 1e-6, 3)),
            format!(
                "radius {}, height deviation {}, of the isotropic Gaussian surface",
                quantity(a.radius, METRES, 3),
                quantity(a.height_std, METRES, 3)
            ),
        ));
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

pub(crate) fn roughness(study: &ProfileComparison) -> String {
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
    format!("<p>{}</p>\n{table}", crate::draw::svg::escape(&setting_words(s)))
}

pub(crate) fn sampling(study: &ProfileComparison) -> String {
    let s = &study.statistics;
    let Some((_, first)) = s.by_spacing.first() else { return String::new() };
    let ratio = |value: f64, of: f64| if of > 0.0 { percent(value / of) } else { "–".into() };
    let line = |(distance, m): &(f64, SpectralMoments)| {
        row(&quantity(*distance, METRES, 3), [ratio(m.m2, first.m2), ratio(m.m4, first.m4)], "")
    };
    let rows: String = s.by_spacing.iter().take(8).map(line).collect();
    let seen = s.seen.map_or(String::new(), |[m2, m4]| {
        format!(
            "Differences of neighbouring points recover {} of m₂ and {} of m₄ of the waves in the trace. ",
            percent(m2),
            percent(m4)
        )
    });
    let caption = "Differences over longer distances, against those of neighbours";
    let columns = "Distance|#<i>m</i><sub>2</sub>|#<i>m</i><sub>4</sub>";
    let table = table(r#"class="stat""#, caption, columns, &rows);
    format!(
        "<p>{seen}A stylus smooths what is narrower than its tip, which no number here can undo.</p>\n{table}"
    )
}
