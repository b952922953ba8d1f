//! Findings in words: plain text, the same on the page, on the terminal and in files.

use crate::messages::adhesion;
use crate::messages::pair;
use crate::messages::plan;
use crate::messages::profile;
use crate::messages::yielding;
use crate::numbers::{
    METRES, PASCALS, SPACE, counted, fixed, percent, quantity, signed_percent, significant,
};
use contact_accuracy::{INDICATOR_LIMIT, NoUncertainty, Reached};
use contact_compare::{
    EdgesName, Fact, Finding, Origin, Passed, Pressed, SPIKE_THRESHOLD, Seam, SurfaceComparison,
    seam,
};
use surface_stats::Edges;
use surface_stats::clean::{FormParameters, Record};

pub(crate) type Words = [String; 2];

fn words(claim: impl Into<String>, text: impl Into<String>) -> Words {
    [claim.into(), text.into()]
}

/// A finding as plain text: the claim, what was found with its number; and its effect with what to do.
pub fn finding(finding: &Finding) -> [String; 2] {
    let [claim, text] = of_fact(&finding.fact);
    match &finding.body {
        Some(body) => [format!("{body}: {claim}"), text],
        None => [claim, text],
    }
}

pub(crate) fn of_fact(fact: &Fact) -> Words {
    match fact {
        Fact::Unit { hardness: Some(hardness), .. } => yielding::odd(*hardness),
        Fact::Unit { gradient, rms_height, radius, .. } => unit([*gradient, *rms_height, *radius]),
        Fact::Yield { at, hardness, full, .. } => beyond_yield(*at, *hardness, *full),
        Fact::Yielding { hardness, headline, highest } => together([
            headline.map(|found| yielding::headline(&found, *hardness)),
            highest.map(|highest| yielding::bulk(highest, *hardness)),
        ]),
        Fact::Adhesion(found) => adhesion::verdict(found),
        Fact::Steep { gradient, is_over } => steep(*gradient, *is_over),
        Fact::Spikes { count, of, largest, share, taken } => {
            spikes([*count, *taken, *of], *largest, *share)
        }
        Fact::PlanUnmet(outcome) => unmet(outcome),
        Fact::Interpolation { indicator, loads, of, .. } => {
            let indicator = significant(*indicator, 2);
            let some = (of > loads).then(|| format!("At {loads} of {}. ", counted(*of, "load")));
            let some = some.unwrap_or_default();
            let claim = format!(
                "Result depends on interpolation between points (indicator {indicator}, limit {INDICATOR_LIMIT})."
            );
            let text = "An uncertainty that is stated covers both ways to interpolate. Measure on a finer grid.";
            words(claim, some + text)
        }
        Fact::BelowPoint { loads, of } => words(
            format!(
                "At {loads} of {} the contact is smaller than a point of the map.",
                counted(*of, "load")
            ),
            "Its area, real pressure and stiffness there are those of a point, not of the surface. Is the \
             unit of the load right? Raise the load, or measure finer.",
        ),
        Fact::NoUncertainty { why, loads, of } => no_uncertainty(*why, *loads, *of),
        Fact::Sample { traces, length, factors, between } => {
            profile::sample(*traces, *length, *factors, *between)
        }
        Fact::Roughness { none_because, short_cutoff, no_s_filter } => together([
            none_because.as_deref().map(|why| {
                let text = "Moments and models are of all waves of the trace.";
                words("There are no roughness parameters.", format!("{}. {text}", capital(why)))
            }),
            short_cutoff.map(profile::coarser_class),
            no_s_filter.map(profile::no_short),
        ]),
        Fact::Warned(found) => found.message(),
        Fact::EdgeJump { ratio, edges, seam } => edge_jump(*ratio, *edges, seam.as_ref()),
        Fact::Cleaned { steps, filled, how, uneven } => {
            let [filled, steps] = cleaned(steps, *filled, how);
            together([uneven.map(profile::unevenly), filled, steps])
        }
        Fact::Pair { names, moments, pixels, shares } => together([
            moments.as_ref().map(|found| pair::dependent(names, found)),
            pixels.map(|pixels| pair::pixels_differ(names, pixels)),
            shares.map(|shares| pair::common_part(names, shares)),
        ]),
        Fact::Passed(passed) => tested(passed),
    }
}

fn unit([gradient, rms_height, radius]: [Option<f64>; 3]) -> Words {
    let found = [
        gradient.map(|g| format!("an rms gradient of {}", significant(g, 3))),
        rms_height.map(|h| format!("an rms height of {}", quantity(h, METRES, 3))),
        radius.map(|r| format!("asperities of radius {}", quantity(r, METRES, 3))),
    ];
    let found = found.into_iter().flatten().collect::<Vec<_>>().join(" and ");
    words(
        "Is the unit right?",
        format!(
            "No rough surface has {found}. Look at the unit of the heights and at the point spacing; \
             until they are right, no number here means anything."
        ),
    )
}

fn steep(gradient: f64, is_over: bool) -> Words {
    let text = if is_over {
        "Small-slope elasticity ends near 0.5. Solver and models still answer, but for a flat \
         half-space, which this surface is not."
    } else {
        "Small-slope elasticity strains from 0.3 and ends near 0.5."
    };
    let (too, gradient) = (if is_over { "too " } else { "" }, significant(gradient, 2));
    words(format!("Slopes are {too}steep: the rms gradient is {gradient}."), text)
}

fn beyond_yield(at: Pressed, [low, high]: [f64; 2], full: Option<f64>) -> Words {
    let show = |p: f64| quantity(p, PASCALS, 2);
    let highest = at.highest.map(|p| format!(", {} at the highest point", show(p)));
    let highest = highest.unwrap_or_default();
    let is_known = low >= high;
    let claim = if is_known {
        "These bodies yield under these pressures."
    } else if at.mean > high {
        "No usual solid bears these pressures."
    } else {
        "These pressures make many solids yield."
    };
    let bear = if is_known {
        format!("their hardness is {}", show(low))
    } else {
        format!("solids of this modulus have a hardness of {} to {}", show(low), show(high))
    };
    let (nominal, mean) = (at.nominal, at.mean);
    let ends = full.map_or_else(String::new, |full| {
        let shown = show(full);
        if mean <= full {
            return format!(" The elastic area holds for H ≥ {shown} (E* h′rms).");
        }
        let why = if nominal > 0.5 * mean {
            "the surface is pressed flat"
        } else {
            "a few points far steeper than the rest carry the load"
        };
        format!(" That is more than E* h′rms = {shown}: {why}.")
    });
    let (nominal, mean) = (show(nominal), show(mean));
    words(
        claim,
        format!(
            "At {nominal} the mean real pressure is {mean}{highest}; {bear}.{ends} Where the contact yields, the area is \
             larger."
        ),
    )
}

fn unmet(outcome: &Reached) -> Words {
    let asked = outcome.request.map_or_else(String::new, |request| percent(request.relative()));
    words(
        format!("The accuracy of {asked} asked for is not met at every load."),
        plan::reason(outcome).map_or_else(String::new, |why| format!("{}.", capital(&why))),
    )
}

fn edge_jump(ratio: f64, edges: EdgesName, seam: Option<&Seam>) -> Words {
    let done = match edges {
        EdgesName::Periodic => {
            "The map was repeated as it is, jump included; with mirrored edges there is no jump."
        }
        EdgesName::Mirrored => {
            "The map was continued by its mirror images, which leave a kink and no jump."
        }
    };
    words(
        format!("Edges do not match: they jump {} times the inner step.", significant(ratio, 2)),
        seam.map_or_else(|| done.to_owned(), |s| format!("{done} {}", seam_effect(s))),
    )
}

fn treatment(surface: &SurfaceComparison) -> &'static str {
    match (surface.edges, &surface.origin) {
        (EdgesName::Mirrored, _) => "Continued by its mirror images.",
        (EdgesName::Periodic, Origin::Recipe(_)) => "Periodic, as made.",
        (EdgesName::Periodic, Origin::Given(given)) if given.repeats == Some(true) => {
            "Periodic, as given."
        }
        (EdgesName::Periodic, Origin::Pair(_)) if surface.origin.edges() == Edges::Periodic => {
            "Periodic, as both bodies were made."
        }
        (EdgesName::Periodic, Origin::File(_) | Origin::Given(_) | Origin::Pair(_)) => {
            "Repeated periodically as it is."
        }
    }
}

/// The treatment, and for a map whose edges were made up its effect.
pub(crate) fn edge_words(surface: &SurfaceComparison) -> String {
    let done = treatment(surface);
    if done.starts_with("Periodic") {
        return done.to_owned();
    }
    seam(surface).map_or(done.to_owned(), |s| format!("{done} {}", seam_effect(&s)))
}

fn seam_effect(seam: &Seam) -> String {
    let effect = signed_percent(seam.share.direct_effect());
    format!("The strip along the edges moves the area by {effect}.")
}

/// Part of the points from which spikes of an instrument are not the likely reading.
const MANY_SPIKES: f64 = 0.01;

/// Claim and text: what `count` spikes of `of` points say, after `taken` were taken out.
fn spikes([count, taken, of]: [usize; 3], largest: f64, share: Option<f64>) -> Words {
    let (who, stand) = if count == 1 { ("It carries", "stands") } else { ("They carry", "stand") };
    let carried = share.map_or_else(String::new, |s| format!("{who} {} of the load. ", percent(s)));
    let (part, up_to) = (count as f64 / of.max(1) as f64, quantity(largest, METRES, 2));
    let points = if count == 1 { "1 point".to_owned() } else { format!("{count} points") };
    match (taken > 0, part > MANY_SPIKES) {
        (true, _) => [
            format!(
                "{points} still {stand} far from the neighbours, up to {up_to}, after {taken} {} taken out.",
                if taken == 1 { "was" } else { "were" }
            ),
            format!(
                "{carried}Another round would find others again: rims of wide spikes, peaks and edges of the surface \
                 itself. Look at the map; what is an error of the instrument can be made a missing point in the file."
            ),
        ],
        (false, true) => [
            format!(
                "{} of the points stand far from their neighbours, up to {up_to}.",
                percent(part)
            ),
            format!(
                "{carried}So many are seldom spikes of an instrument: a surface of smooth ground with peaks, grains or \
                 walls on it looks so too. Look at the map before you take all out."
            ),
        ],
        (false, false) => [
            format!("{points} {stand} far from the neighbours, up to {up_to}."),
            format!(
                "{carried}If they are errors of the instrument, take them out and fill: outliers {SPIKE_THRESHOLD}, \
                 fill harmonic."
            ),
        ],
    }
}

/// The claims and the texts of what there is.
fn together<const N: usize>(all: [Option<Words>; N]) -> Words {
    let all: Vec<Words> = all.into_iter().flatten().collect();
    [0, 1].map(|k| all.iter().map(|words| words[k].as_str()).collect::<Vec<_>>().join(" "))
}

fn cleaned(records: &[Record], filled: f64, how: &str) -> [Option<Words>; 2] {
    let steps = (!records.is_empty()).then(|| {
        words(
            format!("The heights were cleaned: {}.", steps(records)),
            "What was taken off is in no answer here.",
        )
    });
    let is_spike = |r: &Record| matches!(r, Record::Outliers { count, .. } if *count > 0);
    let spikes = if records.iter().any(is_spike) { "missing or spikes" } else { "missing" };
    let filled = (filled > 0.0).then(|| {
        words(
            format!("{} of the points were {spikes}.", percent(filled)),
            format!("They were filled ({how}) from their neighbours; contact there is a guess."),
        )
    });
    [filled, steps]
}

fn steps(cleaned: &[Record]) -> String {
    let step = |record: &Record| match *record {
        Record::Rows { jump, .. } => {
            format!("rows put in line (they jumped {} rms)", quantity(jump, METRES, 2))
        }
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

/// The text with a capital letter; a symbol stays what it is, Α is not α.
pub(crate) fn capital(text: &str) -> String {
    let mut text = text.to_owned();
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

fn no_uncertainty(why: NoUncertainty, loads: usize, of: usize) -> Words {
    let advice = match why {
        NoUncertainty::NotConverged { at_rounding: false } => {
            return words(
                format!("{loads} of {} did not converge.", counted(of, "load")),
                "There is no uncertainty estimate. Use a larger tolerance or another method.",
            );
        }
        NoUncertainty::NotConverged { at_rounding: true } => {
            return words(
                format!("{loads} of {} stopped at rounding.", counted(of, "load")),
                "The numbers are as good as this floating-point type gives them, short of the tolerance, \
                 without uncertainty estimate. Ask for a larger tolerance, or for double precision.",
            );
        }
        NoUncertainty::TooFewPoints { .. } => " Measure on a finer grid.",
        NoUncertainty::TooLooselySolved { .. } => " Solve to a smaller tolerance.",
        _ => "",
    };
    let at = if loads < of { format!(" at {loads} of {of} loads") } else { String::new() };
    words(
        format!("The area is without uncertainty estimate{at}."),
        format!("{}.{advice}", capital(&why.to_string())),
    )
}

fn tested(passed: &Passed) -> Words {
    let tests = [
        passed.bandwidth.map(|bandwidth| {
            ("bandwidth", format!("α = {} (≥{SPACE}1.5 needed)", significant(bandwidth, 3)))
        }),
        passed.heights.map(|[skewness, kurtosis]| {
            let (skewness, kurtosis) = (fixed(skewness, 2), significant(kurtosis, 3));
            ("height distribution", format!("skewness {skewness}, kurtosis {kurtosis}"))
        }),
        passed
            .anisotropy
            .map(|ratio| ("isotropy", format!("slope anisotropy {}", significant(ratio, 3)))),
        passed.resolved.map(|resolved| {
            let share = percent(resolved);
            let text = format!("finite differences recover {share} of the spectral rms gradient");
            ("resolution", text)
        }),
        passed.independence.as_ref().map(|found| {
            ("independence", format!("moments of the two bodies add ({})", pair::excess(found)))
        }),
    ];
    let (claims, texts): (Vec<&str>, Vec<String>) = tests.into_iter().flatten().unzip();
    words(format!("{}.", capital(&claims.join(", "))), format!("{}.", capital(&texts.join("; "))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_keep_their_case() {
        assert_eq!(capital("skewness 0.1"), "Skewness 0.1");
        assert_eq!(capital("α = 15"), "α = 15");
        assert_eq!(capital(""), "");
    }

    #[test]
    fn half_a_map_is_no_spike() {
        let told = |count, taken| {
            let [claim, text] = spikes([count, taken, 1000], 1e-6, None);
            (claim + " " + &text).replace(SPACE, " ")
        };
        assert!(told(9, 0).contains("9 points stand far") && told(9, 0).contains("fill harmonic"));
        let half = told(500, 0);
        assert!(half.contains("50 % of the points"), "{half}");
        // What was done is not advised again.
        for left in [told(1, 8), told(9, 1), told(500, 40)] {
            assert!(left.contains("still stand") && !left.contains("fill harmonic"), "{left}");
        }
        assert!(told(9, 1).contains("Another round"));
        assert!(told(9, 40).contains("peaks and edges of the surface itself"));
    }
}
