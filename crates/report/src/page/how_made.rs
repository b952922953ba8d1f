//! How a report was made: program, inputs, material, solver, and how to repeat it.

use crate::draw::svg::escape;
use crate::messages::loads::loads_line;
use crate::messages::materials::material_line;
use crate::messages::pair::{bodies, lying, moments, of_body};
use crate::messages::plan as plan_messages;
use crate::numbers::{METRES, PASCALS, SPACE, chosen, counted, duration, points_of, significant};
use crate::page::shared::{levelled, terms, tolerance_words};
use crate::provenance::Provenance;
use contact_accuracy::{PERIMETER_CORRECTION, Reached};
use contact_compare::{Body, Comparison, FileOrigin, Origin, Recipe, Settings};
use contact_types::Named;
use surface_stats::Level;
use surface_stats::clean::Record;

pub(crate) fn section(comparison: &Comparison, made: &Provenance) -> String {
    let Comparison { surfaces, settings, .. } = comparison;
    let several = surfaces.len() > 1;
    let program = program_words(made, settings, comparison.seconds);
    let mut rows = vec![("Program".to_owned(), program)];
    for surface in surfaces {
        let (origin, points) = (origin_words(&surface.origin), points_of(surface.surface.grid()));
        let map = format!("{origin}. {points}; {}", levelled(surface));
        rows.push((if several { escape(&surface.name) } else { "Input".into() }, map));
        let cleaned = surface.origin.cleaned().iter().enumerate();
        let step =
            |(i, step): (usize, &Record)| format!("{}. {}", i + 1, escape(&step.to_string()));
        let steps: Vec<String> = cleaned.map(step).collect();
        if !steps.is_empty() {
            let term = if several { "its cleaning" } else { "Cleaning" };
            rows.push((term.into(), steps.join("<br>\n")));
        }
    }
    for refused in &comparison.refused {
        let reason = format!("no study: {}", escape(&refused.reason));
        rows.push((escape(&refused.name), reason));
    }
    let pair = surfaces.first().and_then(|s| s.origin.pair());
    let material = pair.map_or_else(
        || bodies_words(settings),
        |pair| {
            // Of several pairs each has its own names.
            let names = pair.names.each_ref().map(String::as_str);
            let names = if several { ["first body", "second body"] } else { names };
            escape(&bodies(names, &settings.bodies, settings.modulus))
        },
    );
    rows.push(("Material".into(), material + &materials_words(settings)));
    rows.extend(hardness_words(settings).map(|words| ("Hardness".to_owned(), words)));
    rows.extend(loads_line(settings).map(|words| ("Loads".to_owned(), words)));
    for surface in surfaces {
        let Some(plan) = &surface.plan else { continue };
        let several = several.then(|| format!("{}, accuracy", escape(&surface.name)));
        rows.push((several.unwrap_or_else(|| "Accuracy".into()), plan_messages(plan)));
    }
    rows.push(("Solver".into(), solver_words(comparison)));
    let (terms, repeat) = (terms(&rows), escape(&made.repeat));
    format!(
        "<h2>How this was made</h2>\n{terms}<pre>{repeat}</pre>\n<p class=\"why\">All numbers: <code>curves.csv</code>, \
         <code>results.json</code>; settings: <code>run.toml</code>.</p>\n"
    )
}

/// Program, machine and time.
pub(crate) fn program_words(made: &Provenance, settings: &Settings, seconds: f64) -> String {
    let [version, platform] = [&made.version, &made.platform].map(|text| escape(text));
    let (threads, time) = (counted(settings.threads, "thread"), duration(seconds));
    format!("rough-contact {version}, {platform}, {threads}, {time}")
}

pub(crate) fn materials_words(settings: &Settings) -> String {
    let line = |used| format!("<br>\n{}", escape(&material_line(used)));
    settings.materials.iter().map(line).collect()
}

pub(crate) fn hardness_words(settings: &Settings) -> Option<String> {
    let hardness = settings.hardness?;
    let poisson = significant(contact_compare::poisson(&settings.bodies), 2);
    let how = if settings.bodies.is_empty() { "assumes" } else { "takes" };
    Some(format!("<i>H</i> = {}; CEB {how} ν = {poisson}", chosen(hardness, PASCALS)))
}

/// The form taken off, of all maps.
pub(crate) fn level_words(level: Level) -> &'static str {
    match level {
        Level::Auto => "plane; mean where a map repeats and would not without its plane",
        named => named.name(),
    }
}

pub(crate) fn modulus_in_head(settings: &Settings) -> String {
    let other = match settings.bodies.len() {
        0 => "",
        1 => ", against a rigid flat",
        _ => ", of two elastic bodies",
    };
    format!("<i>E</i>* = {}{other}", chosen(settings.modulus, PASCALS))
}

/// E* and what it is made of. Contact is solved as that of one rough elastic half space and a rigid flat.
pub(crate) fn bodies_words(settings: &Settings) -> String {
    let one = |body: &Body| of_body(body).replacen('E', "<i>E</i>", 1);
    let bodies: Vec<String> = settings.bodies.iter().map(one).collect();
    let made_of = match &bodies[..] {
        [] => "as given".into(),
        [body] => format!("elastic half space ({body}) against a rigid flat"),
        many => format!("two elastic half spaces ({})", many.join("; ")),
    };
    format!("<i>E</i>* = {}, {made_of}", chosen(settings.modulus, PASCALS))
}

pub(crate) fn origin_words(origin: &Origin) -> String {
    match origin {
        Origin::File(file) => {
            let FileOrigin { sha256, format, fill, missing, crop, channel, .. } = file;
            let channel = channel.iter().map(|name| format!(", channel {}", escape(name)));
            let part = crop.map(|[y0, x0, ny, nx]| {
                format!(", cut to {ny} × {nx} points from column {x0}, row {y0}")
            });
            let points = counted(*missing, "missing point");
            let filled = (*missing > 0).then(|| format!(", {points} filled ({})", escape(fill)));
            let said: String = channel.chain(part).chain(filled).collect();
            let [name, format, hash] = [file.name(), format, sha256.as_str()].map(escape);
            format!("{name} ({format}){said}, SHA-256 <code>{hash}</code>")
        }
        Origin::Pair(pair) => {
            let cleaned = |step: &Record| format!("; cleaned: {}", escape(&step.to_string()));
            let bodies = pair.names.iter().zip(&*pair.bodies).map(|(name, origin)| {
                let steps: String = origin.cleaned().iter().map(cleaned).collect();
                format!("<b>{}</b>: {}{steps}", escape(name), origin_words(origin))
            });
            let mut lines: Vec<String> = bodies.collect();
            // The sentence after it ends with its own period.
            lines.extend(moments(pair).map(|text| format!("Moments: {}.", escape(&text))));
            lines.push(escape(&lying(pair)));
            lines.join("<br>\n")
        }
        Origin::Given(given) => {
            let filled = match given.missing {
                0 => String::new(),
                n => format!(", {} filled before", counted(n, "missing point")),
            };
            let (note, hash) = (escape(&given.note), escape(&given.sha256));
            format!(
                "{note} (heights handed over by a program{filled}), SHA-256 of the heights <code>{hash}</code>"
            )
        }
        Origin::Recipe(Recipe { hurst, rolloff, cutoff, seed, quantise, .. }) => {
            let [rolloff, cutoff] = [*rolloff, *cutoff].map(|wave| chosen(wave, METRES));
            let step = |q| format!(", height steps {}", chosen(q, METRES));
            let steps = quantise.map_or_else(String::new, step);
            format!(
                "Made from a recipe: self-affine, H = {hurst}, roll-off {rolloff}, cut-off {cutoff}{steps}, seed {seed}"
            )
        }
    }
}

fn plan_messages(plan: &Reached) -> String {
    let [ny, nx] = plan.given.shape();
    let order = if ny == nx { "" } else { " (rows × columns)" };
    let asked = plan.request.map_or("a fast answer".to_owned(), |request| {
        format!("{}{SPACE}% of the area", significant(100.0 * request.relative(), 2))
    });
    format!(
        "{asked} asked for at every load; chosen: {}{order}. Models were given the map as it is",
        escape(&plan_messages::explanation(plan))
    )
}

fn solver_words(Comparison { surfaces, settings, .. }: &Comparison) -> String {
    let points = || surfaces.iter().flat_map(|s| &s.deterministic);
    let answers = || points().filter_map(|p| p.answer.as_ref());
    let found = || answers().map(|a| &a.diagnostics);
    let methods: std::collections::BTreeSet<&str> = found().map(|d| d.method.name()).collect();
    let pairs: f64 = found().map(|d| d.transforms).sum();
    let seconds: f64 = found().map(|d| d.seconds).sum();
    let plan = surfaces.iter().find_map(|s| s.plan.as_ref());
    let (precision, tolerance) =
        plan.map_or((settings.precision, settings.tolerance), |p| (p.precision, p.tolerance));
    let methods = methods.into_iter().collect::<Vec<_>>().join(", ");
    let (tolerance, time) = (tolerance_words(tolerance), duration(seconds));
    let (loads, pairs) = (counted(answers().count(), "load"), significant(pairs, 3));
    let c = significant(PERIMETER_CORRECTION, 4);
    format!(
        "{methods}, {}, tolerance {tolerance}; {loads}, {pairs} FFT convolutions, {time}; perimeter correction c = {c}",
        precision.name()
    )
}
