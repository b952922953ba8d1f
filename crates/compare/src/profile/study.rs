//! The study of a surface of which only profiles are known: statistics and every model.

use crate::ask::{at_pressure, curve_of};
use crate::finding::{Finding, Pressed, Unevenness};
use crate::inputs::{Inputs, MomentSource};
use crate::profile::findings::profile_findings;
use crate::reason::Verdict;
use crate::result::{DeterministicPoint, ModelCurve};
use crate::scene::Scene;
use crate::study::{check_models, check_pressures, loads, named};
use crate::theory::{BuildError, Card, Theory};
use crate::verdict::{Judged, verdict};
use crate::{Origin, Registry, Settings, StudyError};
use contact_types::{Clock, ContactModulus, ContactState, SpectralMoments};
use surface_stats::StatsError;
use surface_stats::profile::{ProfileOptions, ProfileStatistics, Trace, TraceSpectrum};

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
    /// The traces, of the same length and spacing, before they are levelled and filtered.
    pub traces: Vec<Trace>,
    /// How their points were put at equal distances, if they were not.
    pub uneven: Option<Unevenness>,
}

impl ProfileSurface {
    /// How statistics of it are taken in a study.
    pub(crate) fn options(&self, settings: &Settings) -> ProfileOptions {
        let (short, cutoff, height_step) = match &self.origin {
            Origin::File(file) => {
                (file.cleaning.s_filter, file.cleaning.l_filter, file.height_step)
            }
            Origin::Recipe(_) | Origin::Given(_) | Origin::Pair(_) => (None, None, None),
        };
        ProfileOptions {
            degree: settings.level.degree().unwrap_or(0),
            short,
            cutoff,
            fractal_range: settings.fractal_range,
            height_step,
        }
    }
}

/// A finished study of profiles.
#[derive(Debug)]
pub struct ProfileComparison {
    /// What was asked for; what concerns the solver is not used.
    pub settings: Settings,
    /// What the report calls it.
    pub name: String,
    /// Where it came from.
    pub origin: Origin,
    /// How the points were put at equal distances, if they were not.
    pub uneven: Option<Unevenness>,
    /// The traces as their moments are taken: levelled, and filtered if that was asked for.
    pub traces: Vec<Trace>,
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
    /// Every model asked.
    pub models: Vec<ProfileModel>,
    /// Wall-clock time of all of it (s).
    pub seconds: f64,
}

/// A model's answers for the isotropic surface with the moments of the traces.
#[derive(Debug)]
pub struct ProfileModel {
    /// What it is.
    pub card: Card,
    /// Its answers at the loads, or why it has none on this surface.
    pub outcome: Result<ModelCurve, BuildError>,
    /// 95 % interval of the area fraction at each load over traces like these; `None` where the model
    /// does not answer, is not made of moments, or the traces are too short to tell.
    pub intervals: Vec<Option<[f64; 2]>>,
    /// Whether its theory covers this surface, if it is isotropic.
    pub verdict: Verdict,
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
        source: MomentSource::FiniteDifferences,
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
        let state = at_pressure(&theory.card().title, model.as_ref(), mean_pressure).ok()?;
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
        surface: ProfileSurface,
        settings: Settings,
        registry: &Registry,
    ) -> Result<Self, StudyError> {
        let start = Clock::now();
        let modulus = ContactModulus::from_pascals(settings.modulus)?;
        check_pressures(&settings)?;
        check_models(&settings, registry)?;
        if settings.conducts() {
            return Err(StudyError::NoConductance);
        }
        if settings.adhesion.is_some() {
            return Err(StudyError::NoAdhesion);
        }
        if settings.hardness.is_some() {
            return Err(StudyError::YieldingProfiles);
        }
        let options = surface.options(&settings);
        let ProfileSurface { name, origin, traces, uneven } = surface;
        let refused = |source| StudyError::Statistics { surface: name.clone(), source };
        let (statistics, traces, spectrum) =
            ProfileStatistics::of(&traces, &options).map_err(refused)?;
        let mut inputs = profile_inputs(&statistics, &spectrum, modulus).map_err(refused)?;
        inputs.surface = Some(name.clone());
        let pressures = loads(&settings, modulus, inputs.rms_gradient());
        let headline = headline(&settings, &pressures, modulus.pascals() * inputs.rms_gradient())?;
        let points: Vec<DeterministicPoint> = pressures
            .iter()
            .map(|&mean_pressure| DeterministicPoint { mean_pressure, answer: None, trouble: None })
            .collect();
        let models = settings
            .asked_models(registry)
            .map(|theory| ask(theory, &inputs, &points, &statistics))
            .collect();
        Ok(Self {
            settings,
            name,
            origin,
            uneven,
            traces,
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
        profile_findings(&self.statistics, self.uneven, &self.origin, &self.scene())
    }

    /// Pressure of the headline (Pa).
    pub fn headline_pressure(&self) -> f64 {
        self.pressures[self.headline]
    }

    /// Lowest and highest area at a load among the models that answer, with their intervals, and how
    /// many they are; models that are not made of moments are not counted.
    pub fn span(&self, load: usize) -> Option<([f64; 2], usize)> {
        let answers = self.models.iter().filter_map(|m| m.intervals[load]);
        let ends = |[a, b]: [f64; 2], [low, high]: [f64; 2]| [a.min(low), b.max(high)];
        let count = answers.clone().count();
        Some((answers.reduce(ends)?, count))
    }

    /// What is asked of elasticity: of the answers, those of the first model that has some.
    fn scene(&self) -> Scene {
        let answers = self.models.iter().find_map(|m| m.outcome.as_ref().ok());
        let pressed = |state: &ContactState| {
            let mean = state.real_pressure()?;
            Some(Pressed { nominal: state.mean_pressure, mean, highest: None })
        };
        Scene {
            modulus: self.inputs.modulus.pascals(),
            gradient: self.inputs.moments.map(|m| m.rms_gradient()),
            rms_height: self.inputs.moments.map(|m| m.rms_height()),
            radius: self.inputs.asperities().map(|a| a.radius),
            pressed: answers
                .map(|c| c.points.iter().flatten().filter_map(pressed).collect())
                .unwrap_or_default(),
            ..Scene::default()
        }
    }
}

/// The load asked for, or the one nearest to where 2 % usually touch.
fn headline(settings: &Settings, pressures: &[f64], scale: f64) -> Result<usize, StudyError> {
    if let Some(value) = settings.headline {
        let found = pressures.iter().position(|p| named(*p, value));
        return found.ok_or(StudyError::HeadlineNotComputed { value });
    }
    let distance = |p: &f64| (p / (TYPICAL_LOAD * scale)).ln().abs();
    let nearest = (0..pressures.len())
        .min_by(|a, b| distance(&pressures[*a]).total_cmp(&distance(&pressures[*b])));
    Ok(nearest.unwrap_or(0))
}

fn ask(
    theory: &dyn Theory,
    inputs: &Inputs,
    loads: &[DeterministicPoint],
    statistics: &ProfileStatistics,
) -> ProfileModel {
    let card = theory.card().clone();
    let pressures: Vec<f64> = loads.iter().map(|p| p.mean_pressure).collect();
    let outcome = curve_of(theory, inputs, &pressures);
    let intervals = match &outcome {
        Ok(curve) => loads
            .iter()
            .zip(&curve.points)
            .map(|(load, point)| {
                point.as_ref().ok()?;
                area_interval(theory, inputs, statistics, load.mean_pressure)
            })
            .collect(),
        Err(_) => vec![None; loads.len()],
    };
    let judged = Judged {
        gradient: inputs.rms_gradient(),
        rows_jump: None,
        anisotropy: None,
        skewness: statistics.skewness,
        kurtosis: statistics.kurtosis,
        fractal_range: statistics.fractal_range,
        excess: None,
    };
    let verdict = verdict(&card, inputs, &outcome, loads, &judged);
    ProfileModel { card, outcome, intervals, verdict }
}
