//! The table of a surface's statistics.

use crate::numbers::{METRES, Unit, chosen, fixed, power_of_ten, quantity, significant, unit_for};
use contact_compare::SurfaceComparison;
use contact_types::AsperityStatistics;

/// One row: symbol (HTML), name with unit, value from the heights and by the spectrum.
type Quantity = (&'static str, String, Option<String>, Option<String>);

fn three(value: f64) -> String {
    significant(value, 3)
}

fn named(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.into() } else { format!("{name}, {unit}") }
}

fn length(symbol: &'static str, name: &str, value: f64) -> Quantity {
    let unit = unit_for(value, METRES);
    (symbol, named(name, unit.name), Some(three(value / unit.scale)), None)
}

/// A value and the same by the spectrum, in a power of ten of a power of a unit.
fn pair(
    symbol: &'static str,
    name: &str,
    values: [f64; 2],
    (unit, power): (Unit, i32),
) -> Quantity {
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
    let [value, spectral] = values.map(|v| Some(three(v / (base * 10f64.powi(e)))));
    let spectral = spectral.filter(|_| values[1].is_finite());
    (symbol, named(name, &text.join(" ")), value, spectral)
}

fn rows(surface: &SurfaceComparison) -> Vec<Quantity> {
    let s = &surface.statistics;
    let spectral = surface.spectral.moments;
    let height = unit_for(s.rms_height, METRES);
    let micrometre = METRES[3];
    let none = (Unit { scale: 1.0, name: "" }, 0);
    let signed = |v: f64| {
        let text = fixed(v, 2);
        if v > 0.005 { format!("+{text}") } else { text }
    };
    let mut rows = vec![
        length("<i>Sq</i>", "RMS height", s.rms_height),
        length("<i>Sa</i>", "Mean absolute height", s.mean_abs_height),
        ("<i>Ssk</i>", "Skewness".into(), s.skewness.map(signed), None),
        ("<i>Sku</i>", "Kurtosis".into(), s.kurtosis.map(three), None),
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
        let both =
            |pick: fn(&AsperityStatistics) -> f64| [pick(&a), b.as_ref().map_or(f64::NAN, pick)];
        let side = if a.density >= 1e6 { METRES[4] } else { METRES[5] };
        let name = "Summit density m₄/(6π√3m₂)";
        rows.push(pair("<i>η</i>", name, both(|a| a.density), (side, -2)));
        let (name, unit) = ("Summit radius ⅜√(π/m₄)", (unit_for(a.radius, METRES), 1));
        rows.push(pair("<i>R</i>", name, both(|a| a.radius), unit));
        let name = "Summit rms height √(m₀(1−0.8968/α))";
        let unit = (unit_for(a.height_std, METRES), 1);
        rows.push(pair("<i>σ</i><sub>s</sub>", name, both(|a| a.height_std), unit));
    }
    let anisotropy = s.anisotropy.map(three);
    rows.push(("<i>a</i><sub>2</sub>", "Slope anisotropy".into(), anisotropy, None));
    if let (Some(hurst), Some(range)) = (s.hurst, s.fractal_range) {
        let [short, long] = range.map(|l| quantity(l, METRES, 2));
        let name = format!("Hurst exponent, {short} to {long}");
        rows.push(("<i>H</i>", name, None, Some(significant(hurst, 2))));
        let dimension = s.dimension.map(three);
        let row = |d| ("<i>D</i>", "Fractal dimension".into(), None, Some(d));
        rows.extend(dimension.map(row));
    }
    let name = format!("Amplitude/wavelength, rows of {}", chosen(s.record_length, METRES));
    rows.push(("<i>B</i><sub>max</sub>", name, None, Some(three(s.max_amplitude_ratio))));
    rows
}

pub(crate) fn table(surface: &SurfaceComparison) -> String {
    let row = |(symbol, name, value, spectral): Quantity| {
        let [value, spectral] = [value, spectral].map(|text| text.unwrap_or_else(|| "–".into()));
        format!(
            "<tr><th scope=\"row\">{symbol}</th><td>{name}</td><td class=\"n\">{value}</td><td class=\"n alt\">{spectral}</td></tr>\n"
        )
    };
    let body: String = rows(surface).into_iter().map(row).collect();
    format!(
        "<div><table class=\"stat\"><caption>Levelled map</caption><thead><tr>\
         <th scope=\"col\" colspan=\"2\">Quantity</th><th scope=\"col\" class=\"n\">From heights</th><th scope=\"col\" \
         class=\"n\">By spectrum</th></tr></thead><tbody>\n{body}</tbody></table></div>\n"
    )
}
