//! Findings in words: plain text, the same on the page, on the terminal and in files.

use crate::messages::adhesion;
use crate::messages::edges::seam_effect;
use crate::messages::pair;
use crate::messages::plan;
use crate::messages::profile;
use crate::messages::spikes::spikes;
use crate::messages::yielding;
use crate::numbers::{METRES, PASCALS, SPACE, counted, fixed, percent, quantity, significant};
use contact_accuracy::{INDICATOR_LIMIT, NoUncertainty, Reached};
use contact_compare::{EdgesName, Fact, Finding, Passed, Seam, Yield};
use surface_stats::clean::{FormParameters, Record};

/// Claim and text.
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
        Fact::Yield(found) => beyond_yield(found),
        Fact::Yielding(found) => yielding::headline(found),
        Fact::BulkYield { highest, hardness } => yielding::bulk(*highest, *hardness),
        Fact::Adhesion(found) => adhesion::verdict(found),
        Fact::Steep { gradient, is_over } => steep(*gradient, *is_over),
        Fact::Spikes { count, of, largest, share, taken } => {
            spikes([*count, *taken, *of], *largest, *share)
        }
        Fact::PlanUnmet(outcome) => unmet(outcome),
        Fact::Interpolation { indicator, loads, of, .. } => words(
            format!(
                "Result depends on interpolation between points (indicator {}, limit {INDICATOR_LIMIT}).",
                significant(*indicator, 2)
            ),
            format!(
                "{}The uncertainty covers both ways to interpolate. Measure on a finer grid.",
                if of > loads {
                    format!("At {loads} of {}. ", counted(*of, "load"))
                } else {
                    String::new()
                },
            ),
        ),
        Fact::BelowPoint { loads, of } => words(
            format!(
                "At {loads} of {} the contact is smaller than a point of the map.",
                counted(*of, "load")
            ),
            "Its area, real pressure and stiffness there are those of a point, not of the surface. Is the \
             unit of the load right? Raise the load, or measure finer.",
        ),
        Fact::NoUncertainty { why, loads, of } => no_uncertainty(*why, *loads, *of),
        Fact::OneDirection => profile::one_direction(),
        Fact::Sample { traces, length, factors, between } => {
            profile::sample(*traces, *length, *factors, *between)
        }
        Fact::Uneven(uneven) => profile::unevenly(*uneven),
        Fact::NoRoughness { why } => words(
            "There are no roughness parameters.",
            format!("{}. Moments and models are of all waves of the trace.", capital(why)),
        ),
        Fact::Filter { wavelength, limit, ra: Some(ra) } => {
            profile::coarser_class(*wavelength, *ra, *limit)
        }
        Fact::Filter { wavelength, limit, ra: None } => profile::no_short(*wavelength, *limit),
        Fact::Warned(found) => found.message(),
        Fact::EdgeJump { ratio, edges, seam } => edge_jump(*ratio, *edges, seam.as_ref()),
        Fact::Cleaned { steps, filled, how } => cleaned(steps, *filled, how),
        Fact::Pair { names, moments } => pair::dependent(names, moments),
        Fact::Laid { names, pixels, shares } => {
            let pixels = pixels.map(|pixels| pair::pixels_differ(names, pixels));
            let shares = shares.map(|shares| pair::common_part(names, shares));
            together(pixels, shares)
        }
        Fact::Passed(passed) => tested(passed),
    }
}

fn unit([gradient, rms_height, radius]: [Option<f64>; 3]) -> Words {
    let found = [
        gradient.map(|g| format!("an rms gradient of {}", significant(g, 3))),
        rms_height.map(|h| format!("an rms height of {}", quantity(h, METRES, 3))),
        radius.map(|r| format!("asperities of radius {}", quantity(r, METRES, 3))),
    ];
    let found: Vec<String> = found.into_iter().flatten().collect();
    words(
        "Is the unit right?",
        format!(
            "No rough surface has {}. Look at the unit of the heights and at the point spacing; \
             until they are right, no number here means anything.",
            found.join(" and ")
        ),
    )
}

fn steep(gradient: f64, is_over: bool) -> Words {
    let gradient = significant(gradient, 2);
    if is_over {
        words(
            format!("Slopes are too steep: the rms gradient is {gradient}."),
            "Small-slope elasticity ends near 0.5. Solver and models still answer, but for a flat \
             half-space, which this surface is not.",
        )
    } else {
        words(
            format!("Slopes are steep: the rms gradient is {gradient}."),
            "Small-slope elasticity strains from 0.3 and ends near 0.5.",
        )
    }
}

fn beyond_yield(found: &Yield) -> Words {
    let show = |p: f64| quantity(p, PASCALS, 2);
    let [low, high] = found.hardness;
    let highest = found
        .at
        .highest
        .map_or_else(String::new, |p| format!(", {} at the highest point", show(p)));
    let is_known = low >= high;
    let claim = if is_known {
        "These bodies yield under these pressures."
    } else if found.at.mean > high {
        "No usual solid bears these pressures."
    } else {
        "These pressures make many solids yield."
    };
    let bear = if is_known {
        format!("their hardness is {}", show(low))
    } else {
        format!("solids of this modulus have a hardness of {} to {}", show(low), show(high))
    };
    let ends = found.full.map_or_else(String::new, |full| {
        if found.at.mean > full && found.at.nominal > 0.5 * found.at.mean {
            return format!(" That is more than E* g = {}: the surface is pressed flat.", show(full));
        }
        if found.at.mean > full {
            return format!(
                " That is more than E* g = {}: a few points far steeper than the rest carry the load.",
                show(full)
            );
        }
        format!(
            " The elastic area holds for a hardness H of at least {} (E* h′rms).",
            show(full)
        )
    });
    words(
        claim,
        format!(
            "At {} the mean real pressure is {}{highest}; {bear}.{ends} Where the contact yields, the area is \
             larger.",
            show(found.at.nominal),
            show(found.at.mean)
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

/// Both claims and both texts, of what there is.
fn together(first: Option<Words>, second: Option<Words>) -> Words {
    let all: Vec<Words> = first.into_iter().chain(second).collect();
    [0, 1].map(|k| all.iter().map(|words| words[k].as_str()).collect::<Vec<_>>().join(" "))
}

fn cleaned(records: &[Record], filled: f64, how: &str) -> Words {
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
            format!(
                "They were filled ({how}) from their neighbours, which makes them smoother than \
                 the surface; contact there is a guess."
            ),
        )
    });
    together(filled, steps)
}

/// The steps of cleaning in a few words.
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
                "They are without uncertainty estimate. Raise the number of iterations or loosen \
                 the tolerance.",
            );
        }
        NoUncertainty::NotConverged { at_rounding: true } => {
            return words(
                format!("{loads} of {} stopped at rounding.", counted(of, "load")),
                "Their numbers are as good as this floating-point type gives them, short of the \
                 tolerance; they are without uncertainty estimate. Ask for a larger tolerance, or for \
                 double precision.",
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

/// What was tested and is fine, in one entry.
fn tested(passed: &Passed) -> Words {
    let mut claims: Vec<&str> = Vec::new();
    let mut texts: Vec<String> = Vec::new();
    if let Some(bandwidth) = passed.bandwidth {
        claims.push("bandwidth");
        texts.push(format!("α = {} (≥{SPACE}1.5 needed)", significant(bandwidth, 3)));
    }
    if let Some([skewness, kurtosis]) = passed.heights {
        claims.push("height distribution");
        texts.push(format!(
            "skewness {}, kurtosis {}",
            fixed(skewness, 2),
            significant(kurtosis, 3)
        ));
    }
    if let Some(anisotropy) = passed.anisotropy {
        claims.push("isotropy");
        texts.push(format!("slope anisotropy {}", significant(anisotropy, 3)));
    }
    if let Some(resolved) = passed.resolved {
        claims.push("resolution");
        texts.push(format!(
            "finite differences recover {} of the spectral rms gradient",
            percent(resolved)
        ));
    }
    if let Some(found) = &passed.independence {
        claims.push("independence");
        texts.push(pair::independent(found));
    }
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
}
