//! Profiles: what every command says of the traces of a stylus, and `rough-contact stats` of them.

use crate::outcome::{Failure, Reply, unfit};
use crate::text::{self, Columns, TwoColumns, plain};
use rough_contact::compare::{Level, Origin, ProfileSurface, Unevenness};
use rough_contact::surface_stats::profile::{ProfileStatistics, Trace};
use rough_contact::{SpectralMoments, front_end, report};
use std::fmt::Write as _;
use std::path::Path;

/// Takes the traces of another file of the same surface in, unless they are of another length or spacing.
pub(crate) fn add(
    all: &mut ProfileSurface,
    other: ProfileSurface,
    first: &Path,
    file: &Path,
) -> Result<(), Failure> {
    if let (Some(a), Some(b)) = (all.traces.first(), other.traces.first()) {
        let same = (b.spacing() / a.spacing() - 1.0).abs() < 1e-6;
        if a.heights().len() != b.heights().len() || !same {
            let shown = |trace: &Trace| {
                format!("{} points {} apart", trace.heights().len(), text::length(trace.spacing()))
            };
            let why = format!(
                "{}, and {} has {}; traces of one sample are alike: cut them to one length with --crop \
                 0,X0,1,NX, or leave --pool out",
                shown(b),
                first.display(),
                shown(a)
            );
            return Err(unfit(file, "profile", why));
        }
    }
    all.traces.extend(other.traces);
    if let (Origin::File(all), Origin::File(other)) = (&mut all.origin, other.origin) {
        all.missing += other.missing;
        all.height_step = all.height_step.into_iter().chain(other.height_step).reduce(f64::max);
    }
    all.uneven = all.uneven.or(other.uneven);
    Ok(())
}

/// A line for every trace that was put at equal distances.
pub(crate) fn uneven_line(uneven: Option<Unevenness>) -> String {
    uneven.map_or_else(String::new, |u| {
        let [least, most, now] = [u.steps[0], u.steps[1], u.spacing].map(text::length);
        format!("points {least} to {most} apart were put {now} apart, on straight lines between neighbours\n")
    })
}

pub(crate) fn statistics(
    path: &Path,
    traces: &ProfileSurface,
    level: Level,
) -> Result<Reply, Failure> {
    let (s, json) = front_end::profile_statistics(path, traces, level)?;
    let text = text::cleaning(traces.origin.cleaned())
        + &uneven_line(traces.uneven)
        + &describe(&s, traces.origin.missing());
    Ok(Reply::new(text, json))
}

fn describe(s: &ProfileStatistics, missing: usize) -> String {
    let length = |x: Option<f64>| text::or_dash(x, text::length);
    let mut t = TwoColumns::default();
    let traces = if s.traces == 1 { "one trace".into() } else { format!("{} traces", s.traces) };
    t.row("profile", format!("{traces} of {} points, {missing} filled in", s.points));
    t.row("spacing, length", format!("{}, {}", text::length(s.spacing), text::length(s.length)));
    let form = match s.options.degree {
        0 => "mean".to_owned(),
        1 => "line".to_owned(),
        n => format!("polynomial of degree {n}"),
    };
    t.row("form taken off", form);
    let mut out = t.to_string();
    let _ = writeln!(out, "\nISO 21920-2. {}", plain(&report::setting_words(s)));
    out.push_str(&parameters(s));
    let mut t = TwoColumns::default();
    let between = |k: usize, value: String| match s.intervals[k] {
        Some([low, high]) => format!("{value}, 95 % {low:.2e} to {high:.2e}"),
        None => format!("{value}, interval not known: too few waves"),
    };
    let m = s.moments;
    t.row("m0", between(0, format!("{:.4e} m²", m.m0)));
    t.row("m2", between(1, format!("{:.4e}", m.m2)));
    t.row("m4", between(2, format!("{:.4e} m⁻²", m.m4)));
    let SpectralMoments { m0, m2, m4 } = s.spectral;
    t.row("m0, m2, m4 spectral", format!("{m0:.4e} m², {m2:.4e}, {m4:.4e} m⁻²"));
    if let Some([m2, m4]) = s.seen {
        let seen = format!("{} of m2, {} of m4", text::percent(m2), text::percent(m4));
        t.row("seen by differences", seen);
    }
    t.row("if isotropic: rms gradient", text::number(m.rms_gradient()));
    t.row("bandwidth m0 m4/m2²", text::or_dash(s.bandwidth, text::number));
    t.asperities(s.asperities);
    let hurst = text::or_dash(s.hurst.zip(s.fractal_range), |(h, [short, long])| {
        format!("{}, {} to {}", text::number(h), text::length(long), text::length(short))
    });
    t.row("Hurst exponent H", hurst);
    t.row("roll-off, cut-off", format!("{}, {}", length(s.rolloff), length(s.cutoff)));
    let _ = write!(out, "\nMoments of {}, finite differences\n{t}", filtered(s));
    if s.by_spacing.len() > 1 {
        let mut columns = Columns::new(&["differences over", "m2", "m4"]);
        for (distance, m) in s.by_spacing.iter().take(6) {
            let [m2, m4] = [m.m2, m.m4].map(|m| format!("{m:.3e}"));
            columns.row([text::length(*distance), m2, m4 + " m⁻²"]);
        }
        let _ = write!(out, "\n{columns}");
    }
    for warning in &s.warnings {
        let _ = writeln!(out, "warning: {warning}");
    }
    out
}

/// Which waves the moments are of.
fn filtered(s: &ProfileStatistics) -> String {
    match (s.options.short, s.options.cutoff) {
        (None, None) => "all waves".to_owned(),
        (Some(short), None) => format!("the waves longer than {}", text::length(short)),
        (None, Some(cutoff)) => format!("the waves shorter than {}", text::length(cutoff)),
        (Some(short), Some(cutoff)) => {
            format!("the waves between {} and {}", text::length(short), text::length(cutoff))
        }
    }
}

/// Roughness beside the whole trace.
fn parameters(s: &ProfileStatistics) -> String {
    let shown = |symbol: &str, value: Option<f64>| match (value, &symbol[1..]) {
        (None, _) => "–".to_owned(),
        (Some(value), "sk" | "ku" | "dq") => text::number(value),
        (Some(value), "mr1" | "mr2") => text::percent(value),
        (Some(value), _) => text::length(value),
    };
    // Of one trace there is no deviation.
    let most = if s.traces > 1 { 2 } else { 1 };
    let heads = [["roughness R", "s"], ["whole trace P", "s"]];
    let heads = heads.iter().flat_map(|pair| &pair[..most]).copied();
    let mut columns = Columns::new(&[""].into_iter().chain(heads).collect::<Vec<_>>());
    for (k, whole) in s.primary.iter().enumerate() {
        let symbol = whole.symbol.as_str();
        let rough = s.roughness.as_ref().ok().map(|found| &found.parameters[k]);
        let mut cells = vec![symbol[1..].to_owned()];
        let rough = [rough.and_then(|r| r.mean), rough.and_then(|r| r.deviation)];
        for pair in [rough, [whole.mean, whole.deviation]] {
            cells.extend(pair[..most].iter().map(|value| shown(symbol, *value)));
        }
        columns.row(cells);
    }
    columns.to_string()
}
