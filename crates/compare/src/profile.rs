//! The study of a surface of which only profiles are known: statistics and every model, with what the assumption of
//! isotropy and the length of the traces leave of them. No contact is solved.

use crate::ask::{curve_of, possible};
use crate::finding::{Fact, Finding, Unevenness};
use crate::findings::cleaned;
use crate::needs::Inputs;
use crate::result::{ModelComparison, ModelCurve};
use crate::scene::Scene;
use crate::study::{check_request, headline, loads, nearest};
use crate::theory::Theory;
use crate::verdict::{Judged, verdict};
use crate::{Origin, Registry, Settings, StudyError};
use contact_types::{Clock, ContactModulus, SpectralMoments};
use surface_stats::profile::{
    ProfileOptions, ProfileStatistics, SettingSource, Trace, TraceSpectrum,
};
use surface_stats::{StatsError, Warning};

/// Load over E* h'rms at which about 2 % of a surface touches.
const TYPICAL_LOAD: f64 = 0.01;
/// Step of the logarithm of a moment by which the answer of a model is differentiated.
const STEP: f64 = 0.05;

/// Traces of one surface, with a name and where they came from.
#[derive(Debug, Clone)]
pub struct ProfileSurface {
    /// What the report calls it.
    pub name: String,
    /// Where it came from; the filters of its cleaning are λs and λc here.
    pub origin: Origin,
    /// The traces, of the same length and spacing; of a study as their moments are taken: levelled, and filtered if that was
    /// asked for.
    pub traces: Vec<Trace>,
    /// How their points were put at equal distances, if they were not.
    pub uneven: Option<Unevenness>,
}

impl ProfileSurface {
    /// How statistics of it are taken in a study.
    pub fn options(&self, settings: &Settings) -> ProfileOptions {
        let file = self.origin.file();
        ProfileOptions {
            degree: settings.level.degree().unwrap_or(0),
            short: file.and_then(|file| file.cleaning.s_filter),
            cutoff: file.and_then(|file| file.cleaning.l_filter),
            fractal_range: settings.fractal_range,
            height_step: file.and_then(|file| file.height_step),
        }
    }
}

/// A finished study of profiles.
#[derive(Debug)]
pub struct ProfileComparison {
    /// What was asked for; what concerns the solver is not used.
    pub settings: Settings,
    /// Name, origin, and the traces as their moments are taken.
    pub surface: ProfileSurface,
    /// Their statistics.
    pub statistics: ProfileStatistics,
    /// Their spectrum.
    pub spectrum: TraceSpectrum,
    /// What the models were given.
    pub inputs: Inputs,
    /// Nominal pressures (Pa), rising.
    pub pressures: Vec<f64>,
    /// Index of the pressure of the headline.
    pub headline: usize,
    /// Every model asked, of the isotropic surface with the moments of the traces.
    pub models: Vec<ModelComparison>,
    /// Wall-clock time of all of it (s).
    pub seconds: f64,
}

/// What the models are given of profiles: moments by finite differences, amplitudes of waves from the
/// smoothed PSD, D and G of its power law, and as nominal area the square of the length.
///
/// # Errors
/// [`StatsError::Surface`] for traces without waves.
pub fn profile_inputs(
    statistics: &ProfileStatistics,
    spectrum: &TraceSpectrum,
    modulus: ContactModulus,
) -> Result<Inputs, StatsError> {
    let is_rough = |m: &SpectralMoments| m.m2 > 0.0 && m.m4 > 0.0;
    Ok(Inputs {
        moments: Some(statistics.moments).filter(is_rough),
        is_measured: true,
        amplitudes: Some(spectrum.amplitudes()?),
        fractal: statistics.fractal,
        dimension: statistics.hurst.map(|hurst| 2.0 - hurst),
        nominal_area: Some(statistics.length * statistics.length),
        ..Inputs::new(modulus)
    })
}

/// 95 % interval of a model's area fraction at a pressure (Pa) over traces like these: the scatter of
/// the moments through the derivatives of the logarithm of the area by theirs. `None` if the model
/// does not follow from the moments, or does not answer beside them.
pub fn area_interval(
    theory: &dyn Theory,
    inputs: &Inputs,
    statistics: &ProfileStatistics,
    mean_pressure: f64,
) -> Option<[f64; 2]> {
    let moments = inputs.moments?;
    let area = |moments: SpectralMoments| -> Option<f64> {
        let beside = Inputs { moments: Some(moments), ..inputs.clone() };
        let model = theory.build(&beside).ok()?;
        let state = model.at_pressure(mean_pressure).ok()?;
        let state = possible(&theory.card().title, state).ok()?;
        Some(state.area_fraction).filter(|a| *a > 0.0)
    };
    let middle = area(moments)?;
    let mut exponents = [0.0; 3];
    for (k, exponent) in exponents.iter_mut().enumerate() {
        let beside = |sign: f64| {
            let mut all = [moments.m0, moments.m2, moments.m4];
            all[k] *= (sign * STEP).exp();
            let [m0, m2, m4] = all;
            area(SpectralMoments { m0, m2, m4 })
        };
        *exponent = (beside(1.0)? / beside(-1.0)?).ln() / (2.0 * STEP);
    }
    // An answer that no moment moves is made of something else.
    if exponents.iter().all(|e| e.abs() < 1e-9) {
        return None;
    }
    let factor = statistics.factor_of(exponents)?;
    Some([middle / factor, (middle * factor).min(1.0)])
}

impl ProfileComparison {
    /// Takes the statistics and asks the theories of `registry` that the settings ask.
    ///
    /// # Errors
    /// [`StudyError`]. A model that does not apply is a result, not an error.
    pub fn run(
        mut surface: ProfileSurface,
        settings: Settings,
        registry: &Registry,
    ) -> Result<Self, StudyError> {
        let start = Clock::now();
        let modulus = ContactModulus::from_pascals(settings.modulus)?;
        check_request(&settings, registry)?;
        if settings.joint().is_asked() {
            return Err(StudyError::NoConductance);
        }
        if settings.adhesion.is_some() {
            return Err(StudyError::NoAdhesion);
        }
        if settings.hardness.is_some() {
            return Err(StudyError::YieldingProfiles);
        }
        let options = surface.options(&settings);
        let refused = |source| StudyError::Statistics { surface: surface.name.clone(), source };
        let (statistics, spectrum);
        (statistics, surface.traces, spectrum) =
            ProfileStatistics::of(&surface.traces, &options).map_err(refused)?;
        let mut inputs = profile_inputs(&statistics, &spectrum, modulus).map_err(refused)?;
        inputs.surface = Some(surface.name.clone());
        let pressures = loads(&settings, modulus, inputs.rms_gradient());
        let typical = TYPICAL_LOAD * modulus.pascals() * inputs.rms_gradient();
        let headline =
            headline(&settings, &pressures)?.unwrap_or_else(|| nearest(&pressures, typical));
        let models = settings
            .asked_models(registry)
            .map(|theory| ask(theory, &inputs, &pressures, &statistics))
            .collect();
        Ok(Self {
            settings,
            surface,
            statistics,
            spectrum,
            inputs,
            pressures,
            headline,
            models,
            seconds: start.elapsed().as_secs_f64(),
        })
    }

    /// What may change a conclusion, worst first.
    pub fn findings(&self) -> Vec<Finding> {
        let ProfileSurface { origin, uneven, .. } = &self.surface;
        profile_findings(&self.statistics, *uneven, origin, &self.scene())
    }

    /// Lowest and highest area at a load among the models that answer, with their intervals, and how
    /// many they are; models that are not made of moments are not counted.
    pub fn span(&self, load: usize) -> Option<([f64; 2], usize)> {
        let answers = self.models.iter().filter_map(|m| m.outcome.as_ref().ok()?.intervals[load]);
        let ends = |[a, b]: [f64; 2], [low, high]: [f64; 2]| [a.min(low), b.max(high)];
        let count = answers.clone().count();
        Some((answers.reduce(ends)?, count))
    }

    /// What is asked of elasticity: of the answers, those of the first model that has some.
    fn scene(&self) -> Scene {
        let answers = self.models.iter().find_map(|m| m.outcome.as_ref().ok());
        let states = answers.into_iter().flat_map(|curve| curve.points.iter().flatten());
        Scene::of(&self.inputs, states)
    }
}

fn ask(
    theory: &dyn Theory,
    inputs: &Inputs,
    pressures: &[f64],
    statistics: &ProfileStatistics,
) -> ModelComparison {
    let card = theory.card().clone();
    let outcome = curve_of(theory, inputs, pressures).map(|curve| {
        let interval = |(point, pressure): (&Result<_, _>, &f64)| {
            point.as_ref().ok().and_then(|_| area_interval(theory, inputs, statistics, *pressure))
        };
        let intervals = curve.points.iter().zip(pressures).map(interval).collect();
        ModelCurve { intervals, ..curve }
    });
    let judged = Judged {
        gradient: inputs.rms_gradient(),
        heights: statistics.skewness.zip(statistics.kurtosis),
        fractal_range: statistics.fractal_range,
        ..Judged::default()
    };
    let verdict = verdict(&card, inputs, &outcome, pressures, &judged);
    ModelComparison { card, outcome, verdict }
}

/// The findings of profiles, worst first. `scene` is what is asked of elasticity, `origin` where the
/// traces come from.
pub fn profile_findings(
    statistics: &ProfileStatistics,
    uneven: Option<Unevenness>,
    origin: &Origin,
    scene: &Scene,
) -> Vec<Finding> {
    let mut found = scene.findings();
    found.push(sample(statistics));
    found.extend(statistics.warnings.iter().copied().map(Finding::warned));
    found.extend(roughness(statistics));
    if statistics.rolloff.is_none() && statistics.options.cutoff.is_none() {
        found.push(Finding::warned(Warning::FewWaves { count: None }));
    }
    let points = statistics.points * statistics.traces;
    let file = origin.file();
    let (missing, fill) = file.map_or((0, ""), |file| (file.missing, file.fill.as_str()));
    found.extend(cleaned(origin.cleaned(), [missing, points], fill, uneven));
    found.sort_by_key(|f| f.weight);
    found
}

/// That there are no roughness parameters, or that a filter of them is not the standard's.
fn roughness(statistics: &ProfileStatistics) -> Option<Finding> {
    let (mut none_because, mut short_cutoff, mut no_s_filter) = (None, None, None);
    match &statistics.roughness {
        Err(error) => none_because = Some(error.to_string()),
        Ok(roughness) => {
            let setting = roughness.setting;
            let is_longest = matches!(setting.source, SettingSource::Longest(_));
            let ra = roughness.parameters[0].mean.filter(|_| is_longest); // the first parameter
            short_cutoff = ra.map(|ra| [ra, setting.cutoff, statistics.length]);
            no_s_filter = setting.short_unresolved.map(|short| [short, statistics.spacing]);
        }
    }
    let any = none_because.is_some() || short_cutoff.is_some() || no_s_filter.is_some();
    any.then(|| Finding::note(Fact::Roughness { none_because, short_cutoff, no_s_filter }))
}

fn sample(statistics: &ProfileStatistics) -> Finding {
    let factors = [0, 1, 2].map(|k| {
        let [low, high] = statistics.intervals[k]?;
        (low > 0.0).then(|| (high / low).sqrt())
    });
    Finding::check(Fact::Sample {
        traces: statistics.traces,
        length: statistics.length,
        factors,
        between: statistics.between,
    })
}
