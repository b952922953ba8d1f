//! What may change a conclusion drawn from profiles.

use crate::finding::{Fact, Finding, Weight};
use crate::findings::{cleaned, filled};
use crate::profile::fact::{ProfileFact, Unevenness};
use crate::scene::Scene;
use crate::{FileOrigin, Origin};
use surface_stats::profile::{ProfileStatistics, SettingSource};

/// Half width of the interval of m2 beyond which the traces are too few or too short.
const LOOSE: f64 = 0.2;

/// The findings of profiles, worst first. `scene` is what is asked of elasticity, `origin` where the
/// traces come from.
pub fn profile_findings(
    statistics: &ProfileStatistics,
    uneven: Option<Unevenness>,
    origin: &Origin,
    scene: &Scene,
) -> Vec<Finding> {
    let of = |weight: Weight, fact: ProfileFact| Finding { weight, fact: Fact::Profile(fact) };
    let mut found = scene.findings();
    found.push(of(Weight::Check, ProfileFact::OneDirection));
    found.push(sample(statistics));
    found.extend(statistics.warnings.iter().copied().map(Finding::warned));
    found.extend(uneven.map(|uneven| of(Weight::Note, ProfileFact::Uneven(uneven))));
    match &statistics.roughness {
        Err(error) => {
            found.push(of(Weight::Note, ProfileFact::NoRoughness { why: error.to_string() }));
        }
        Ok(all) => {
            let setting = all[0].setting;
            // The first parameter is Ra.
            let ra = statistics.roughness_mean().and_then(|means| means[0].mean);
            if let (SettingSource::Longest(_), Some(ra)) = (setting.source, ra) {
                let (cutoff, length) = (setting.cutoff, statistics.length);
                let fact = ProfileFact::CoarserClass { cutoff, ra, length };
                found.push(of(Weight::Note, fact));
            }
            if let Some(short) = setting.short_unresolved {
                let fact = ProfileFact::NoShort { short, spacing: statistics.spacing };
                found.push(of(Weight::Note, fact));
            }
        }
    }
    if statistics.rolloff.is_none() && statistics.options.cutoff.is_none() {
        found.push(of(Weight::Note, ProfileFact::NoRolloff { length: statistics.length }));
    }
    if let Origin::File(FileOrigin { missing, fill, cleaned, .. }) = origin {
        found.extend(filled(*missing, statistics.points * statistics.traces, fill, cleaned));
    }
    found.extend(cleaned(origin.cleaned()));
    found.sort_by_key(|f| f.weight);
    found
}

fn sample(statistics: &ProfileStatistics) -> Finding {
    let factors = [0, 1, 2].map(|k| {
        let [low, high] = statistics.interval(k)?;
        (low > 0.0).then(|| (high / low).sqrt())
    });
    let is_loose = factors[1].is_none_or(|factor| factor > 1.0 + LOOSE);
    let fact = ProfileFact::Sample {
        traces: statistics.traces,
        length: statistics.length,
        factors,
        between: statistics.scatter.between,
    };
    let weight = if is_loose { Weight::Check } else { Weight::Note };
    Finding { weight, fact: Fact::Profile(fact) }
}
