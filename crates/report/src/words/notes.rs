//! "Read before use": what may change a conclusion, worst first, then what was tested and is fine.

use crate::draw::svg::escape;
use crate::numbers::{METRES, SPACE, percent, quantity, significant};
use crate::words::note::{Note, Weight, note};
use crate::words::plan as plan_words;
use compare::Origin;
use compare::SurfaceComparison;
use contact_accuracy::NoAreaInterval;
use surface_stats::Warning;
use surface_stats::clean::{FormParameters, Record};

/// At most this many notes are shown.
const MOST: usize = 5;

/// The notes for a surface, worst first.
pub(crate) fn notes(surface: &SurfaceComparison) -> Vec<Note> {
    let mut notes: Vec<Note> = Vec::new();
    let unsolved = surface
        .deterministic
        .iter()
        .filter(|p| p.answer.as_ref().is_none_or(|a| !a.converged))
        .count();
    if unsolved > 0 {
        notes.push(note(
            Weight::Check,
            format!("{unsolved} of {} loads did not converge.", surface.deterministic.len()),
            "Their numbers are marked and carry no ±. Raise the number of iterations or loosen \
             the tolerance.",
        ));
    }
    if let Some(plan) = &surface.plan
        && let Some(reason) = plan_words::reason(plan)
    {
        let asked = percent(plan.request.relative());
        let claim = format!("The accuracy of {asked} asked for is not met at every load.");
        notes.push(note(Weight::Check, claim, format!("{}.", capital(&escape(&reason)))));
    }
    let flat = surface.statistics.rms_height <= 0.0;
    let gate = surface.map.accuracy.gate();
    let headline = surface.headline_answer();
    if let (Err(reason), false, Some(finer)) = (gate, flat, headline.and_then(|a| a.finer)) {
        let others = surface.deterministic.iter().filter_map(|p| p.answer.as_ref()?.finer).count();
        let text = format!(
            "{}. The ± is that of one more solution on a twice finer interpolation, whose area is \
             {}{SPACE}%; {}.",
            capital(&reason.to_string()),
            significant(100.0 * finer.area, 3),
            if others > 1 { "so are those of the other loads" } else { "other loads carry none" }
        );
        notes.push(note(Weight::Check, "The grid does not resolve the contact.", text));
    } else if let Err(reason) = gate
        && !flat
    {
        notes.push(note(Weight::Check, "The area carries no ±.", no_bar(reason)));
    } else if let Some(Err(reason)) = headline.map(|a| a.budget.area.comparison_half_width())
        && !flat
        && unsolved == 0
    {
        notes.push(note(Weight::Check, "The area at this load carries no ±.", no_bar(reason)));
    }
    let said = matches!(gate, Err(NoAreaInterval::Unresolved { .. }));
    let rest = surface.statistics.warnings.iter();
    let rest = rest.filter(|w| !(said && matches!(w, Warning::Unresolved { .. })));
    let rest = rest.filter(|w| !matches!(w, Warning::EdgeJump { .. })); // needs the solution
    notes.extend(rest.map(warning));
    notes.extend(crate::words::edges::edge_note(surface));
    if let Origin::File(file) = &surface.origin
        && file.missing > 0
    {
        let share = file.missing as f64 / surface.surface.grid().len() as f64;
        notes.push(note(
            if share > 0.05 { Weight::Check } else { Weight::Note },
            format!("{} of the points were {}.", percent(share), gone(&file.cleaned)),
            format!(
                "They were filled ({}) from their neighbours, which makes them smoother than the \
                 surface; contact there is a guess.",
                escape(&file.fill)
            ),
        ));
    }
    let cleaned = surface.origin.cleaned();
    if !cleaned.is_empty() {
        notes.push(note(
            Weight::Note,
            format!("The heights were cleaned: {}.", steps(cleaned)),
            "What was taken off is in no answer here; “How this was made” says what each step did.",
        ));
    }
    notes.sort_by_key(|n| n.weight);
    if let Some(passed) = passed(surface) {
        notes.truncate(MOST - 1);
        notes.push(passed);
    }
    notes.truncate(MOST);
    notes
}

/// What filled points were before.
fn gone(cleaned: &[Record]) -> &'static str {
    let spikes = |r: &Record| matches!(r, Record::Outliers { count, .. } if *count > 0);
    if cleaned.iter().any(spikes) { "missing or spikes" } else { "missing" }
}

/// The steps of cleaning in a few words.
fn steps(cleaned: &[Record]) -> String {
    let step = |record: &Record| match *record {
        Record::Outliers { count: 0, .. } => "no spikes found".to_owned(),
        Record::Outliers { count: 1, .. } => "1 spike".to_owned(),
        Record::Outliers { count, .. } => format!("{count} spikes"),
        Record::Form { parameters: FormParameters::Polynomial { degree: 1 }, .. } => "plane".into(),
        Record::Form { parameters: FormParameters::Polynomial { degree }, .. } => {
            format!("polynomial of degree {degree}")
        }
        Record::Form { parameters: FormParameters::Sphere { .. }, .. } => "sphere".into(),
        Record::Form { parameters: FormParameters::Cylinder { .. }, .. } => "cylinder".into(),
        Record::SFilter { nesting_index } => {
            format!("S-filter {}", quantity(nesting_index, METRES, 3))
        }
        Record::LFilter { nesting_index } => {
            format!("L-filter {}", quantity(nesting_index, METRES, 3))
        }
    };
    cleaned.iter().map(step).collect::<Vec<_>>().join(", ")
}

/// The text, escaped, with a capital letter.
fn capital(text: &str) -> String {
    let mut text = escape(text);
    if let Some(first) = text.get(..1).map(str::to_uppercase) {
        text.replace_range(..1, &first);
    }
    text
}

fn no_bar(reason: NoAreaInterval) -> String {
    let text = capital(&reason.to_string());
    let advice = match reason {
        NoAreaInterval::Unresolved { .. } | NoAreaInterval::SpotsTooSmall { .. } => {
            " Measure finer, or remove short wavelengths and quote the cut-off."
        }
        NoAreaInterval::Stepped { .. } => " Measure with finer steps.",
        _ => "",
    };
    format!(
        "{text}. Outside this limit the error of the area has reached tens of per cent.{advice}"
    )
}

fn warning(warning: &Warning) -> Note {
    use Weight::{Check, Note as Info};
    let ratio = |x: f64| significant(x, 2);
    match *warning {
        Warning::Rounding { rms_height, spacing } => note(
            Check,
            format!("The rms height of {} is rounding.", quantity(rms_height, METRES, 2)),
            format!(
                "The heights are stored to {}; what is left after levelling is no roughness.",
                quantity(spacing, METRES, 1)
            ),
        ),
        Warning::Flat => note(
            Check,
            "The map is flat.",
            "There is no roughness: any load closes the contact, and the models have no input.",
        ),
        Warning::Tilted { explained } => note(
            Check,
            format!("A plane explains {} of the height variance.", percent(explained)),
            "A tilt left in moves the gap by 3 to 14\u{202F}% and the summit models by −7 to \
             −11\u{202F}%. Level the map, unless the tilt belongs to the contact.",
        ),
        Warning::Anisotropic { ratio: r } => note(
            Check,
            format!("The surface has a lay: mean square slopes differ {} times.", ratio(r)),
            "The closed forms assume an isotropic surface; beyond 2 none of them is safe.",
        ),
        Warning::NotGaussian { skewness, kurtosis } => note(
            Check,
            format!(
                "Heights are not normal: skewness {}, kurtosis {}.",
                significant(skewness, 2).replace('-', "\u{2212}"),
                ratio(kurtosis)
            ),
            "The closed forms assume 0 and 3; beyond ±0.2 and ±0.3 none of them is safe.",
        ),
        Warning::NarrowBand { bandwidth } => note(
            Check,
            format!("Bandwidth α = {} is below 1.5.", ratio(bandwidth)),
            "No isotropic Gaussian surface has that; the summit models do not apply.",
        ),
        Warning::Unresolved { ratio: r } => note(
            Check,
            format!("Finite differences see {} of the rms gradient.", percent(r)),
            "The shortest waves are near two points, so <i>m</i><sub>2</sub>, \
             <i>m</i><sub>4</sub> and every area depend on the point spacing. Measure finer, or \
             remove short wavelengths and quote the cut-off.",
        ),
        Warning::Stepped { step, m2_share, m4_share } => note(
            Check,
            format!(
                "Height steps of {} make {} of <i>m</i><sub>2</sub> and {} of \
                 <i>m</i><sub>4</sub>.",
                quantity(step, METRES, 2),
                percent(m2_share),
                percent(m4_share)
            ),
            "Models made of them describe the instrument. Measure with finer steps, or remove \
             short wavelengths.",
        ),
        Warning::Noisy { rms, m2_share, m4_share, reliable } => note(
            Check,
            format!(
                "{} of <i>m</i><sub>4</sub> and {} of <i>m</i><sub>2</sub> are noise of {} rms.",
                percent(m4_share),
                percent(m2_share),
                quantity(rms, METRES, 2)
            ),
            format!(
                "Every model made of them describes the instrument, and so does the area at light \
                 load.{}",
                reliable.map_or(String::new(), |l| format!(
                    " Waves longer than {} stand out of the noise: remove shorter ones and quote \
                     the cut-off.",
                    quantity(l, METRES, 2)
                ))
            ),
        ),
        Warning::FlatTops { plateaus, summits } => note(
            Info,
            format!("{plateaus} flat tops beside {summits} summits."),
            "Height steps hide summits; the count depends on the step.",
        ),
        Warning::NoRolloff => note(
            Info,
            "No roll-off within the map.",
            "Its longest waves are not sampled: rms height and everything made of it grow with \
             the size of the map.",
        ),
        Warning::FewWaves { count } => note(
            Info,
            format!("Only {} of the longest waves fit the map.", ratio(count)),
            "Another map of the same surface will give other numbers: the ± here does not cover \
             that.",
        ),
        Warning::NotSelfAffine { hurst } => note(
            Info,
            format!("The spectrum fits H = {}.", significant(hurst, 2)),
            "That is not between 0 and 1: not a self-affine surface over this range, and fractal \
             parameters have no meaning.",
        ),
        ref other => note(Info, String::new(), escape(&other.to_string())),
    }
}

fn gate_is_open(surface: &SurfaceComparison) -> bool {
    surface.map.accuracy.gate().is_ok()
}

/// What was tested and is fine, in one entry.
fn passed(surface: &SurfaceComparison) -> Option<Note> {
    let warned = |test: fn(&Warning) -> bool| surface.statistics.warnings.iter().any(test);
    let s = &surface.statistics;
    if s.rms_height <= 0.0 {
        return None;
    }
    let mut claims: Vec<&str> = Vec::new();
    let mut texts: Vec<String> = Vec::new();
    if let Some(bandwidth) = s.bandwidth.filter(|b| *b >= 1.5) {
        claims.push("bandwidth");
        texts.push(format!("α = {} (≥{SPACE}1.5 needed)", significant(bandwidth, 3)));
    }
    if let (Some(skewness), Some(kurtosis)) = (s.skewness, s.kurtosis)
        && !warned(|w| matches!(w, Warning::NotGaussian { .. }))
    {
        claims.push("height distribution");
        texts.push(format!(
            "skewness {}, kurtosis {}",
            crate::numbers::fixed(skewness, 2),
            significant(kurtosis, 3)
        ));
    }
    if let Some(anisotropy) = s.anisotropy.filter(|a| *a <= 2.0) {
        claims.push("isotropy");
        texts
            .push(format!("slopes differ {} times between directions", significant(anisotropy, 3)));
    }
    if gate_is_open(surface) {
        claims.push("resolution");
        texts.push(format!(
            "finite differences see {} of the rms gradient",
            percent(surface.spectral.resolved)
        ));
    }
    let mut claim = claims.join(", ");
    let first = claim.get(..1)?.to_uppercase();
    claim.replace_range(..1, &first);
    let mut text = texts.join("; ");
    if let Some(first) = text.get(..1).map(str::to_uppercase) {
        text.replace_range(..1, &first);
    }
    Some(note(Weight::Passed, format!("{claim}."), format!("{text}.")))
}
