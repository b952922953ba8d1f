//! What may change a conclusion drawn from profiles.

use crate::finding::{Fact, Finding, Unevenness};
use crate::findings::{cleaned, filled};
use crate::scene::Scene;
use crate::{FileOrigin, Origin};
use surface_stats::Warning;
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
    let mut found = scene.findings();
    found.push(Finding::check(Fact::OneDirection));
    found.push(sample(statistics));
    found.extend(statistics.warnings.iter().copied().map(Finding::warned));
    found.extend(uneven.map(|uneven| Finding::note(Fact::Uneven(uneven))));
    match &statistics.roughness {
        Err(error) => {
            found.push(Finding::note(Fact::NoRoughness { why: error.to_string() }));
        }
        Ok(roughness) => {
            let setting = roughness.setting;
            // The first parameter is Ra.
            if let (SettingSource::Longest(_), Some(ra)) =
                (setting.source, roughness.parameters[0].mean)
            {
                let (cutoff, length) = (setting.cutoff, statistics.length);
                found.push(Finding::note(Fact::CoarserClass { cutoff, ra, length }));
            }
            if let Some(short) = setting.short_unresolved {
                let fact = Fact::NoShort { short, spacing: statistics.spacing };
                found.push(Finding::note(fact));
            }
        }
    }
    if statistics.rolloff.is_none() && statistics.options.cutoff.is_none() {
        found.push(Finding::warned(Warning::NoRolloff));
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
        let [low, high] = statistics.intervals[k]?;
        (low > 0.0).then(|| (high / low).sqrt())
    });
    let is_loose = factors[1].is_none_or(|factor| factor > 1.0 + LOOSE);
    let fact = Fact::Sample {
        traces: statistics.traces,
        length: statistics.length,
        factors,
        between: statistics.between,
    };
    Finding::check_if(is_loose, fact)
}
