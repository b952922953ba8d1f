//! The table of a surface's statistics.

use crate::numbers::{METRES, Unit, chosen, fixed, power_of_ten, quantity, significant, unit_for};
use contact_compare::SurfaceComparison;
use contact_types::AsperityStatistics;

/// One row: symbol (HTML), name with unit, value, and the value by the spectrum.
struct StatisticsRow {
    symbol: &'static str,
    name: String,
    value: String,
    spectral: Option<String>,
}

fn three(value: f64) -> String {
    significant(value, 3)
}

fn named(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.into() } else { format!("{name}, {unit}") }
}

/// A length in the multiple that suits it.
fn length(symbol: &'static str, name: &str, value: f64) -> StatisticsRow {
    let unit = unit_for(value, METRES);
    StatisticsRow {
        symbol,
        name: named(name, unit.name),
        value: three(value / unit.scale),
        spectral: None,
    }
}

/// A number without unit.
fn plain(symbol: &'static str, name: &str, value: Option<f64>) -> StatisticsRow {
    StatisticsRow {
        symbol,
        name: name.into(),
        value: value.map_or("–".into(), three),
        spectral: None,
    }
}

/// A value and the same by the spectrum, in a power of ten of a power of a unit.
fn pair(
    symbol: &'static str,
    name: &str,
    values: [f64; 2],
    (unit, power): (Unit, i32),
) -> StatisticsRow {
    let base = unit.scale.powi(power);
    let e = (values[0].abs() / base).max(f64::MIN_POSITIVE).log10().floor() as i32;
    let e = if (-1..4).contains(&e) { 0 } else { e };
    let unit_name = match power {
        0 => String::new(),
        1 => unit.name.into(),
        _ => format!("{}{}", unit.name, power_of_ten(power).trim_start_matches("10")),
    };
    let factor = if e == 0 { String::new() } else { power_of_ten(e) };
    let text: Vec<String> = [factor, unit_name].into_iter().filter(|t| !t.is_empty()).collect();
    let scale = base * 10f64.powi(e);
    StatisticsRow {
        symbol,
        name: named(name, &text.join(" ")),
        value: three(values[0] / scale),
        spectral: Some(three(values[1] / scale)),
    }
}

fn rows(surface: &SurfaceComparison) -> Vec<StatisticsRow> {
    let s = &surface.statistics;
    let spectral = surface.spectral.moments;
    let height = unit_for(s.rms_height, METRES);
    let micrometre = METRES[3];
    let none = (Unit { scale: 1.0, name: "" }, 0);
    let signed = s.skewness.map(|v| {
        let text = fixed(v, 2);
        if v > 0.005 { format!("+{text}") } else { text }
    });
    let mut rows = vec![
        length("<i>Sq</i>", "RMS height", s.rms_height),
        length("<i>Sa</i>", "Mean absolute height", s.mean_abs_height),
        StatisticsRow {
            value: signed.unwrap_or_else(|| "–".into()),
            ..plain("<i>Ssk</i>", "Skewness", None)
        },
        plain("<i>Sku</i>", "Kurtosis", s.kurtosis),
        pair("<i>Sdq</i>", "RMS gradient √(2m₂)", [s.rms_gradient, spectral.rms_gradient()], none),
        pair("<i>m</i><sub>0</sub>", "Height variance", [s.m0, spectral.m0], (height, 2)),
        pair("<i>m</i><sub>2</sub>", "Slope variance", [s.m2, spectral.m2], none),
        pair("<i>m</i><sub>4</sub>", "Curvature variance", [s.m4, spectral.m4], (micrometre, -2)),
    ];
    if let Some(bandwidth) = s.bandwidth {
        let both = [bandwidth, spectral.bandwidth()];
        rows.push(pair("<i>α</i>", "Bandwidth m₀m₄/m₂²", both, none));
    }
    if let Some(a) = s.asperities {
        let b = AsperityStatistics::from_moments(spectral).ok();
        let other = |pick: fn(&AsperityStatistics) -> f64| b.as_ref().map_or(f64::NAN, pick);
        let side = if a.density >= 1e6 { METRES[4] } else { METRES[5] };
        let both = [a.density, other(|b| b.density)];
        rows.push(pair("<i>η</i>", "Summit density m₄/(6π√3m₂)", both, (side, -2)));
        let both = [a.radius, other(|b| b.radius)];
        let unit = (unit_for(a.radius, METRES), 1);
        rows.push(pair("<i>R</i>", "Summit radius ⅜√(π/m₄)", both, unit));
        let both = [a.height_std, other(|b| b.height_std)];
        let unit = (unit_for(a.height_std, METRES), 1);
        rows.push(pair("<i>σ</i><sub>s</sub>", "Summit rms height √(m₀(1−0.8968/α))", both, unit));
    }
    rows.push(plain("<i>a</i><sub>2</sub>", "Slope anisotropy", s.anisotropy));
    if let (Some(hurst), Some([short, long])) = (s.hurst, s.fractal_range) {
        let [short, long] = [short, long].map(|l| quantity(l, METRES, 2));
        rows.push(StatisticsRow {
            spectral: Some(significant(hurst, 2)),
            ..plain("<i>H</i>", &format!("Hurst exponent, {short} to {long}"), None)
        });
        rows.extend(s.dimension.map(|dimension| StatisticsRow {
            spectral: Some(three(dimension)),
            ..plain("<i>D</i>", "Fractal dimension", None)
        }));
    }
    let name = format!("Amplitude/wavelength, rows of {}", chosen(s.record_length, METRES));
    rows.push(StatisticsRow {
        spectral: Some(significant(s.max_amplitude_ratio, 3)),
        ..plain("<i>B</i><sub>max</sub>", &name, None)
    });
    rows
}

/// Statistics of the levelled map; beside each moment the one by the spectrum.
pub(crate) fn table(surface: &SurfaceComparison) -> String {
    let row = |r: &StatisticsRow| {
        let spectral = r.spectral.as_deref().filter(|t| !t.contains("NaN")).unwrap_or("–");
        format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"n\">{}</td><td class=\"n alt\">{spectral}</td></tr>\n",
            r.symbol, r.name, r.value
        )
    };
    let body: String = rows(surface).iter().map(row).collect();
    format!(
        "<div><table class=\"stat\"><caption>Levelled map</caption><thead><tr>\
         <th scope=\"col\" colspan=\"2\">Quantity</th><th scope=\"col\" class=\"n\">From heights</th><th scope=\"col\" \
         class=\"n\">By spectrum</th></tr></thead><tbody>\n{body}</tbody></table></div>\n"
    )
}
