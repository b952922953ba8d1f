//! Whether a theory covers a surface, in words.

use crate::messages::finding::of_fact;
use crate::numbers::{PASCALS, SPACE, chosen, counted, length, significant};
use contact_compare::{Assumes, BuildError, Card, Caveat, Fact, ModelError, Reason, Verdict};
use surface_stats::Warning;

/// What steep slopes strain.
pub(crate) const SMALL_SLOPES: &str = "small-slope elasticity ends near 0.5";

/// Why a model applies to a surface, or only with caution, or not.
pub(crate) fn reason_of(card: &Card, verdict: &Verdict) -> String {
    if verdict.reasons.is_empty() {
        return within(card).into();
    }
    verdict.reasons.iter().map(words).collect::<Vec<_>>().join("; ")
}

fn within(card: &Card) -> &str {
    match card.assumes {
        Assumes::Summits => "light contact on an isotropic Gaussian surface",
        Assumes::Gaussian => &card.domain,
        Assumes::Amplitudes | Assumes::Fractal => "",
        Assumes::Unstated => "its assumptions are not known here; it names none that is strained",
    }
}

fn words(reason: &Reason) -> String {
    match reason {
        Reason::Surface(fact) => of_surface(fact),
        Reason::Refused { dimension: Some(d), .. } => {
            format!("fitted D = {}: no profile dimension between 1 and 2", plain(*d))
        }
        Reason::Refused { error: BuildError::Model(error), .. } => refusal(error),
        Reason::Refused { error: BuildError::Missing { needs, .. }, .. } => {
            format!("needs {needs}")
        }
        Reason::Strained { caveat: None, from } => {
            format!("asperities interact from {} (area 5{SPACE}%)", chosen(*from, PASCALS))
        }
        Reason::Band { dimension: Some(d), short, long } => {
            let short = short.map_or("–".into(), length);
            format!("D = {} depends on the fit range, {short} to {}", plain(*d), length(*long))
        }
        Reason::Band { dimension: None, long, .. } => {
            format!("B_max depends on the record length ({})", length(*long))
        }
        Reason::Strained {
            caveat: Some(Caveat::BeyondModel { quantity, value, limit, reason }),
            ..
        } => {
            format!("{quantity} {} beyond {}: {reason}", plain(*value), plain(*limit))
        }
        Reason::Strained { from, .. } => format!("full contact from {}", chosen(*from, PASCALS)),
        Reason::Elastic { .. } => "elastic bodies only".to_owned(),
        Reason::NoAnswer { loads, of } => {
            format!("no answer at {loads} of {}", counted(*of, "load"))
        }
    }
}

/// What of a surface strains a theory, in the words of a table.
fn of_surface(fact: &Fact) -> String {
    match fact {
        Fact::Steep { gradient, .. } => {
            format!("rms gradient {}: {SMALL_SLOPES}", significant(*gradient, 2))
        }
        Fact::Warned(Warning::RowsJump { .. }) => "rows of the map jump".to_owned(),
        Fact::Warned(Warning::Anisotropic { ratio }) => {
            format!("the surface has a lay (slopes {ratio:.1} : 1)")
        }
        Fact::Warned(Warning::NotGaussian { .. }) => "heights not normal".to_owned(),
        other => of_fact(other)[0].clone(),
    }
}

fn refusal(error: &ModelError) -> String {
    match error {
        ModelError::OutsideDomain { quantity, value, domain, reason, .. } => {
            let bound = if value < domain.start() {
                format!("< {}", plain(*domain.start()))
            } else {
                format!("≥ {}", plain(*domain.end()))
            };
            // A study gives a model the map and nothing else: what else it could be given is no
            // way out here.
            let reason = reason.split("; give ").next().unwrap_or_default();
            format!("{quantity} = {} {bound}: {reason}", plain(*value))
        }
        other => other.to_string(),
    }
}

fn plain(value: f64) -> String {
    format!("{value:.2}").trim_end_matches('0').trim_end_matches('.').replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_study_advises_nothing_it_cannot_be_given() {
        let error = ModelError::OutsideDomain {
            model: "Majumdar-Bhushan".into(),
            quantity: "D".into(),
            value: 1.623_456_789_012_345,
            domain: 1.0..=1.5,
            reason: "the load diverges; give a critical area, below which spots are plastic".into(),
        };
        assert_eq!(refusal(&error), "D = 1.62 ≥ 1.5: the load diverges");
    }
}
