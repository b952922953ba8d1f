//! The table of a surface's statistics.

use crate::draw::svg::escape;
use crate::numbers::{METRES, Unit, chosen, fixed, power_of_ten, quantity, significant, unit_for};
use compare::SurfaceComparison;
use contact_types::AsperityStatistics;

/// One row: symbol (HTML), definition, name with unit, value, and the value by the spectrum.
struct Row {
    symbol: &'static str,
    definition: &'static str,
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
fn length(symbol: &'static str, definition: &'static str, name: &str, value: f64) -> Row {
    let unit = unit_for(value, METRES);
    Row {
        symbol,
        definition,
        name: named(name, unit.name),
        value: three(value / unit.scale),
        spectral: None,
    }
}

/// A number without unit.
fn plain(symbol: &'static str, definition: &'static str, name: &str, value: Option<f64>) -> Row {
    Row {
        symbol,
        definition,
        name: name.into(),
        value: value.map_or("–".into(), three),
        spectral: None,
    }
}

/// A value and the same by the spectrum, in a power of ten of a power of a unit.
fn pair(
    symbol: &'static str,
    definition: &'static str,
    name: &str,
    values: [f64; 2],
    (unit, power): (Unit, i32),
) -> Row {
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
    Row {
        symbol,
        definition,
        name: named(name, &text.join(" ")),
        value: three(values[0] / scale),
        spectral: Some(three(values[1] / scale)),
    }
}

fn rows(surface: &SurfaceComparison) -> Vec<Row> {
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
        length(
            "<i>Sq</i>",
            "Root mean square height about the mean (ISO 25178-2)",
            "RMS height",
            s.rms_height,
        ),
        length(
            "<i>Sa</i>",
            "Mean absolute height about the mean (ISO 25178-2)",
            "Mean absolute height",
            s.mean_abs_height,
        ),
        Row {
            value: signed.unwrap_or_else(|| "–".into()),
            ..plain("<i>Ssk</i>", "Third moment / Sq³; 0 for a normal surface", "Skewness", None)
        },
        plain("<i>Sku</i>", "Fourth moment / Sq⁴; 3 for a normal surface", "Kurtosis", s.kurtosis),
        pair(
            "<i>Sdq</i>",
            "Root mean square of |∇z|, equal to √(2 m₂)",
            "RMS gradient",
            [s.rms_gradient, spectral.rms_gradient()],
            none,
        ),
        pair(
            "<i>m</i><sub>0</sub>",
            "Mean square height",
            "Height variance",
            [s.m0, spectral.m0],
            (height, 2),
        ),
        pair(
            "<i>m</i><sub>2</sub>",
            "Mean square slope of profiles, mean of both axes",
            "Slope variance",
            [s.m2, spectral.m2],
            none,
        ),
        pair(
            "<i>m</i><sub>4</sub>",
            "Mean square second derivative of profiles, mean of both axes",
            "Curvature variance",
            [s.m4, spectral.m4],
            (micrometre, -2),
        ),
    ];
    if let Some(bandwidth) = s.bandwidth {
        rows.push(pair(
            "<i>α</i>",
            "m₀ m₄ / m₂²; at least 1.5 for any isotropic Gaussian surface",
            "Nayak bandwidth",
            [bandwidth, spectral.bandwidth()],
            none,
        ));
    }
    if let Some(a) = s.asperities {
        let b = AsperityStatistics::from_moments(spectral).ok();
        let other = |pick: fn(&AsperityStatistics) -> f64| b.as_ref().map_or(f64::NAN, pick);
        let side = if a.density >= 1e6 { METRES[4] } else { METRES[5] };
        rows.push(pair(
            "<i>η</i>",
            "(m₄/m₂)/(6π√3)",
            "Summit density",
            [a.density, other(|b| b.density)],
            (side, -2),
        ));
        rows.push(pair(
            "<i>R</i>",
            "(3/8)√(π/m₄)",
            "Summit radius",
            [a.radius, other(|b| b.radius)],
            (unit_for(a.radius, METRES), 1),
        ));
        rows.push(pair(
            "<i>σ</i><sub>s</sub>",
            "√((1 − 0.8968/α) m₀)",
            "Summit deviation",
            [a.height_std, other(|b| b.height_std)],
            (unit_for(a.height_std, METRES), 1),
        ));
    }
    rows.push(plain(
        "<i>a</i><sub>2</sub>",
        "Largest over smallest mean square slope over all directions; 1 if isotropic",
        "Anisotropy of slopes",
        s.anisotropy,
    ));
    if let (Some(hurst), Some([short, long])) = (s.hurst, s.fractal_range) {
        let name = format!(
            "Hurst exponent, {} to {}",
            quantity(short, METRES, 2),
            quantity(long, METRES, 2)
        );
        rows.push(Row {
            spectral: Some(significant(hurst, 2)),
            ..plain(
                "<i>H</i>",
                "From the slope −2 − 2H of the radial PSD over the fit range",
                &name,
                None,
            )
        });
        if let Some(dimension) = s.dimension {
            rows.push(Row {
                spectral: Some(three(dimension)),
                ..plain(
                    "<i>D</i>",
                    "Fractal dimension of a profile, from profile PSDs over the fit range",
                    "Fractal dimension",
                    None,
                )
            });
        }
    }
    let name = format!("Amplitude ratio, rows of {}", chosen(s.record_length, METRES));
    rows.push(Row {
        spectral: Some(significant(s.max_amplitude_ratio, 3)),
        ..plain(
            "<i>B</i><sub>max</sub>",
            "Largest mean amplitude over wavelength of the rows; depends on their length",
            &name,
            None,
        )
    });
    rows
}

/// Statistics of the levelled map; beside each moment the one by the spectrum.
pub(crate) fn table(surface: &SurfaceComparison) -> String {
    let rows = rows(surface);
    let body: String = rows
        .iter()
        .map(|r| {
            format!(
                "<tr><th scope=\"row\"><abbr tabindex=\"0\" title=\"{}\">{}</abbr></th><td>{}</td>\
                 <td class=\"n\">{}</td><td class=\"n alt\">{}</td></tr>\n",
                escape(r.definition),
                r.symbol,
                r.name,
                r.value,
                r.spectral.as_deref().filter(|t| !t.contains("NaN")).unwrap_or("–")
            )
        })
        .collect();
    let definitions: Vec<String> =
        rows.iter().map(|r| format!("{}: {}", r.symbol, escape(r.definition))).collect();
    format!(
        "<div><table class=\"stat\"><caption>Statistics of the levelled map</caption><thead><tr>\
         <th scope=\"col\" colspan=\"2\">Hover or tap a symbol for its definition</th><th \
         scope=\"col\" class=\"n\">From heights</th><th scope=\"col\" class=\"n\">By \
         spectrum</th></tr></thead><tbody>\n{body}</tbody></table>\n<p class=\"why \
         printonly\">Definitions. {}.</p></div>\n",
        definitions.join("; ")
    )
}
