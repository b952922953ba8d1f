//! What may change a conclusion: decided here once, for page, terminal and files alike.

use crate::adhesion::Adhesion;
use crate::finding::{
    Fact, Finding, Passed, Pressed, Seam, Unevenness, Weight, Yielding, is_unsolved,
};
use crate::result::{DeterministicPoint, SurfaceComparison};
use crate::scene::{BULK_YIELD, Scene, hardness_of, is_steep};
use crate::{Independence, PairOrigin, Spikes};
use contact_accuracy::{EdgeShare, INDICATOR_LIMIT, NoUncertainty, Reached};
use fft_bem_solver::End;
use surface_stats::clean::Record;
use surface_stats::{SurfaceStatistics, Warning};

/// Error of the area from which the edges may change a conclusion.
const EDGES_MATTER: f64 = 0.05;
/// Part of filled points from which they may.
const FILLED_MATTER: f64 = 0.05;

/// The findings of a study on one surface, worst first.
pub fn findings(surface: &SurfaceComparison) -> Vec<Finding> {
    let points = &surface.deterministic;
    let answers = || points.iter().filter_map(|p| p.answer.as_ref());
    let file = surface.origin.file();
    let solved = Solved {
        scene: scene(surface),
        spikes: surface.spikes.clone(),
        spike_share: surface.spikes.share(&surface.pressure),
        loads: without_uncertainty(surface),
        indicators: answers()
            .map(|a| (a.budget.indicator, a.finer.as_ref().map(|n| n.area)))
            .collect(),
        plan: surface.plan.as_ref(),
        touching: answers()
            .map(|a| [a.touching_fraction, a.diagnostics.contact_perimeter])
            .collect(),
        missing: file.map_or(0, |file| file.missing),
        points: surface.surface.grid().len(),
        fill: file.map_or("", |file| &file.fill),
        cleaned: surface.origin.cleaned(),
        pair: surface.origin.pair(),
        adhesion: surface.adhesion,
    };
    let warned = |warning: &Warning| match *warning {
        Warning::EdgeJump { ratio } => edge_jump(ratio, surface),
        other => Finding::warned(other),
    };
    let warned = surface.statistics.warnings.iter().map(warned);
    solved.with(hardness(surface), warned.chain(passed(surface)))
}

/// Why the area of each load has no uncertainty. Of those that converged it is that of the headline, and none where the
/// headline has one, the map is flat or another load did not converge. A load that was refused is said to be elsewhere.
fn without_uncertainty(surface: &SurfaceComparison) -> Vec<Option<NoUncertainty>> {
    let of = |point: &DeterministicPoint| {
        let answer = point.answer.as_ref()?;
        let at_rounding = answer.diagnostics.end == End::Rounding;
        let short = NoUncertainty::NotConverged { at_rounding };
        if answer.converged { answer.budget.area.half_width().err() } else { Some(short) }
    };
    let all: Vec<_> = surface.deterministic.iter().map(of).collect();
    let is_told = surface.statistics.rms_height > 0.0 && !all.iter().flatten().any(is_unsolved);
    let headline = all.get(surface.headline).copied().flatten().filter(|_| is_told);
    let told = |why: NoUncertainty| if is_unsolved(&why) { Some(why) } else { headline };
    all.into_iter().map(|why| why.and_then(told)).collect()
}

/// Whether the bodies stick: good to know if that is negligible, a thing to look at if not.
fn sticking(adhesion: Adhesion) -> Finding {
    Finding::check_if(!adhesion.negligible, Fact::Adhesion(Box::new(adhesion)))
}

/// What the statistics of a map alone say, worst first; `spikes` are its own, it may be that of a pair, and whether bodies stick
/// may have been asked.
pub fn measured(
    s: &SurfaceStatistics,
    spikes: &Spikes,
    pair: Option<&PairOrigin>,
    adhesion: Option<Adhesion>,
) -> Vec<Finding> {
    let mut found = Scene::of_map(s).findings();
    found.extend(spiky(spikes, None));
    found.extend(s.warnings.iter().copied().map(Finding::warned));
    found.extend(pair.map(of_pair).into_iter().flatten());
    found.extend(adhesion.map(sticking));
    found.sort_by_key(|f| f.weight);
    found
}

/// What a hardness does to the headline, and whether it can be one.
fn hardness(surface: &SurfaceComparison) -> Vec<Finding> {
    let Some(given) = hardness_of(surface) else { return Vec::new() };
    let pascals = given.pascals;
    let odd = |[low, high]: [f64; 2]| {
        let hardness = Some([pascals, low, high]);
        Finding::check(Fact::Unit { gradient: None, rms_height: None, radius: None, hardness })
    };
    let mut found: Vec<Finding> = given.unusual().map(odd).into_iter().collect();
    let solved = surface.deterministic.iter().filter(|p| p.answer.is_some());
    let highest = solved.map(|p| p.mean_pressure).fold(0.0, f64::max);
    let highest = Some(highest).filter(|load| *load > BULK_YIELD * pascals);
    let headline = surface.headline_answer().and_then(|answer| {
        let yielded = answer.diagnostics.yielded.filter(|y| y.area_fraction > 0.0)?;
        let elastic = surface.elastic.get(surface.headline).and_then(|p| p.answer.as_ref());
        Some(Yielding {
            over_elastic: given.indices(None).modulus_gradient_over_hardness,
            load: surface.headline_pressure(),
            share: (yielded.area_fraction / answer.touching_fraction).min(1.0),
            load_share: yielded.load_share,
            area: answer.area_fraction,
            elastic_area: elastic.map(|a| a.area_fraction),
        })
    });
    if headline.is_some() || highest.is_some() {
        found.push(Finding::note(Fact::Yielding { hardness: pascals, headline, highest }));
    }
    found
}

/// What a study asks of elasticity, with the answers that converged; with a hardness no pressure is beyond
/// what the bodies bear.
fn scene(surface: &SurfaceComparison) -> Scene {
    let is_elastic = surface.inputs.hardness.is_none();
    let answers = surface.deterministic.iter().filter(|_| is_elastic).filter_map(|p| {
        let answer = p.answer.as_ref().filter(|a| a.converged)?;
        let mean = answer.budget.real_pressure()?.value;
        Some(Pressed::of(p.mean_pressure, mean, answer.diagnostics.max_pressure))
    });
    let (modulus, pressed) = (surface.inputs.modulus.pascals(), answers.collect());
    Scene { modulus, pressed, ..Scene::of_map(&surface.statistics) }
}

/// What is known of loads that were solved on one map, without a study.
#[derive(Debug, Clone, Default)]
pub struct Solved<'a> {
    /// What is asked of elasticity, with its answers.
    pub scene: Scene,
    /// Single points far from their neighbours.
    pub spikes: Spikes,
    /// Largest share of the load that they carry \[-\], if it is known.
    pub spike_share: Option<f64>,
    /// Of each load: why its area has no uncertainty, if it has none.
    pub loads: Vec<Option<NoUncertainty>>,
    /// Of each load: its indicator, and the area on twice the points if it was solved.
    pub indicators: Vec<(Option<f64>, Option<f64>)>,
    /// The rung that was reached, if an accuracy was asked for.
    pub plan: Option<&'a Reached>,
    /// Of each load with a solution: touching fraction, and edges of touching points over all points.
    pub touching: Vec<[f64; 2]>,
    /// Points that were filled.
    pub missing: usize,
    /// Points of the map.
    pub points: usize,
    /// The rule they were filled by.
    pub fill: &'a str,
    /// Steps of cleaning.
    pub cleaned: &'a [Record],
    /// The two bodies, if it is a pair; they say themselves what was filled and cleaned.
    pub pair: Option<&'a PairOrigin>,
    /// Whether they stick, if a work of adhesion was given.
    pub adhesion: Option<Adhesion>,
}

impl Solved<'_> {
    /// The findings, worst first.
    pub fn findings(&self) -> Vec<Finding> {
        self.with(Vec::new(), [])
    }

    /// The same with what a hardness does to the headline, and what the statistics say.
    fn with(
        &self,
        hardness: Vec<Finding>,
        statistics: impl IntoIterator<Item = Finding>,
    ) -> Vec<Finding> {
        let of = self.loads.len();
        let mut found = self.scene.findings();
        found.extend(hardness);
        found.extend(self.adhesion.map(sticking));
        found.extend(spiky(&self.spikes, self.spike_share));
        for at_rounding in [false, true] {
            let why = NoUncertainty::NotConverged { at_rounding };
            let loads = self.loads.iter().filter(|load| **load == Some(why)).count();
            found.extend(
                (loads > 0).then(|| Finding::check(Fact::NoUncertainty { why, loads, of })),
            );
        }
        let small = self.touching.iter().filter(|touching| is_below_a_point(touching)).count();
        if small > 0 {
            found.push(Finding::check(Fact::BelowPoint { loads: small, of }));
        }
        let unmet = self.plan.filter(|plan| plan.unmet.is_some());
        found.extend(unmet.map(|plan| Finding::check(Fact::PlanUnmet(Box::new(plan.clone())))));
        let bare: Vec<_> = self.loads.iter().flatten().filter(|why| !is_unsolved(why)).collect();
        if let Some(&&why) = bare.first() {
            found.push(Finding::check(Fact::NoUncertainty { why, loads: bare.len(), of }));
        }
        found.extend(interpolation(&self.indicators));
        found.extend(statistics);
        found.extend(cleaned(self.cleaned, [self.missing, self.points], self.fill, None));
        found.extend(self.pair.map(of_pair).into_iter().flatten());
        found.sort_by_key(|f| f.weight);
        found
    }
}

/// Larger over smaller distance of points from which waves of one body are missing in the sum.
const PIXELS_MATTER: f64 = 1.5;

/// What two bodies say of each other, and what was done to each.
fn of_pair(pair: &PairOrigin) -> Vec<Finding> {
    let Some((placed, independence)) = &pair.found else { return Vec::new() };
    let moments = (!independence.holds()).then_some(*independence);
    let pixels = placed.resampled.contains(&true).then(|| placed.grids.map(|grid| grid.pixel()));
    // Less than a point in a thousand is no part.
    let shares = Some(placed.shares).filter(|shares| shares.iter().any(|share| *share < 0.999));
    let mut found = Vec::new();
    if moments.is_some() || pixels.is_some() || shares.is_some() {
        let matters =
            moments.is_some() || (pixels.is_some() && placed.pixel_ratio >= PIXELS_MATTER);
        let fact = Fact::Pair { names: pair.names.clone(), moments, pixels, shares };
        found.push(Finding::check_if(matters, fact));
    }
    for ((body, origin), grid) in pair.names.iter().zip(&*pair.bodies).zip(placed.grids) {
        let Some(file) = origin.file() else { continue };
        let own = cleaned(&file.cleaned, [file.missing, grid.len()], &file.fill, None);
        found.extend(own.map(|f| Finding { body: Some(body.clone()), ..f }));
    }
    found
}

/// Spikes; they may change a conclusion where they carry a twentieth of the load, and none where they carry
/// a thousandth.
fn spiky(spikes: &Spikes, share: Option<f64>) -> Option<Finding> {
    let count = spikes.indices.len();
    let Spikes { points: of, largest, taken, .. } = *spikes;
    let fact = Fact::Spikes { count, of, largest, share, taken };
    let matters = count > 0 && share.is_none_or(|s| s >= 1e-3);
    matters.then(|| Finding::check_if(share.is_some_and(|s| s > 0.05), fact))
}

/// Whether every touching point stands alone, with four edges of the contact line: the contacts are smaller than a point
/// of the map, and no number of them is one of the surface.
fn is_below_a_point([touching, perimeter]: &[f64; 2]) -> bool {
    *touching > 0.0 && *perimeter > 3.999 * touching
}

/// Whether an answer depends on what lies between the points: of each load its indicator, and its area on twice the
/// points.
fn interpolation(all: &[(Option<f64>, Option<f64>)]) -> Option<Finding> {
    let known = all.iter().filter_map(|(indicator, finer)| Some(((*indicator)?, *finer)));
    let beyond = known.filter(|(indicator, _)| *indicator > INDICATOR_LIMIT);
    let (loads, of) = (beyond.clone().count(), all.len());
    let (indicator, finer) = beyond.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Finding::check(Fact::Interpolation { indicator, finer, loads, of }))
}

fn edge_jump(ratio: f64, surface: &SurfaceComparison) -> Finding {
    let seam = seam(surface);
    let matters = seam.is_some_and(|s| s.share.direct_effect().abs() > EDGES_MATTER);
    Finding::check_if(matters, Fact::EdgeJump { ratio, edges: surface.edges, seam })
}

/// What the strip along the edges does at the headline; `None` without a solution.
pub fn seam(surface: &SurfaceComparison) -> Option<Seam> {
    let grid = surface.solved_map().grid();
    let share = EdgeShare::of(&surface.pressure, grid)?;
    let strip = grid.pixel().map(|d| share.width as f64 * d);
    Some(Seam { share, strip })
}

/// What was done to the heights of `all` points, `missing` of which were filled. Many may change a conclusion.
pub(crate) fn cleaned(
    steps: &[Record],
    [missing, all]: [usize; 2],
    how: &str,
    uneven: Option<Unevenness>,
) -> Option<Finding> {
    if missing == 0 && steps.is_empty() && uneven.is_none() {
        return None;
    }
    let filled = missing as f64 / all.max(1) as f64;
    let fact = Fact::Cleaned { steps: steps.to_vec(), filled, how: how.to_owned(), uneven };
    Some(Finding::check_if(filled > FILLED_MATTER, fact))
}

/// That rows stand at heights of their own, if they do.
pub(crate) fn rows_jump(s: &SurfaceStatistics) -> Option<Warning> {
    s.warnings.iter().find(|w| matches!(w, Warning::RowsJump { .. })).copied()
}

/// What was tested and is fine.
fn passed(surface: &SurfaceComparison) -> Option<Finding> {
    let s = &surface.statistics;
    // Nothing is fine on a surface whose slopes the theory does not cover.
    if s.rms_height <= 0.0 || is_steep(s.rms_gradient) {
        return None;
    }
    let is_normal = !s.warnings.iter().any(|w| matches!(w, Warning::NotGaussian { .. }));
    let passed = Passed {
        bandwidth: s.bandwidth.filter(|b| *b >= 1.5),
        heights: s.skewness.zip(s.kurtosis).filter(|_| is_normal).map(|(a, b)| [a, b]),
        anisotropy: s.anisotropy.filter(|a| *a <= 2.0 && rows_jump(s).is_none()),
        resolved: resolves(surface).then_some(surface.spectral.resolved),
        independence: independence(surface),
    };
    let any = passed != Passed::default();
    any.then(|| Finding::of(Weight::Passed, Fact::Passed(passed)))
}

/// Moments of two bodies, if they add.
fn independence(surface: &SurfaceComparison) -> Option<Independence> {
    let (_, found) = *surface.origin.pair()?.found.as_ref()?;
    // Of a flat body there is nothing to test.
    let is_rough = found.bodies.iter().all(|body| body.m0 > 0.0);
    (is_rough && found.holds()).then_some(found)
}

/// Whether the grid resolves the slopes and, at the headline, the contacts.
fn resolves(surface: &SurfaceComparison) -> bool {
    let interval = surface.headline_answer().and_then(|a| a.budget.area.interval().ok());
    nothing_against(&surface.statistics.warnings, interval)
}

/// No warning of the slopes, and a bar of the area that has a lower end.
fn nothing_against(warnings: &[Warning], interval: Option<[f64; 2]>) -> bool {
    !warnings.iter().any(|w| matches!(w, Warning::Unresolved { .. }))
        && interval.is_some_and(|[low, _]| low > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(solved: &Solved<'_>) -> Vec<(Weight, Fact)> {
        solved.findings().into_iter().map(|f| (f.weight, f.fact)).collect()
    }

    #[test]
    fn a_grid_that_is_warned_of_has_not_passed() {
        let warned = [Warning::Unresolved { ratio: 0.93 }];
        assert!(nothing_against(&[], Some([0.01, 0.02])));
        assert!(!nothing_against(&warned, Some([0.01, 0.02])));
        // "This map does not resolve its contacts."
        assert!(!nothing_against(&[], Some([0.0, 0.02])));
        assert!(!nothing_against(&[], None));
    }

    #[test]
    fn the_worst_comes_first_and_counts_its_loads() {
        let clean = Solved { loads: vec![None; 3], points: 100, ..Solved::default() };
        assert_eq!(facts(&clean), []);
        let short = NoUncertainty::NotConverged { at_rounding: false };
        let rounded = NoUncertainty::NotConverged { at_rounding: true };
        let bare = NoUncertainty::NoContact;
        let loads = vec![None, Some(bare), Some(short), Some(rounded)];
        let solved = Solved { loads, missing: 2, fill: "nearest", ..clean };
        let check = |why| (Weight::Check, Fact::NoUncertainty { why, loads: 1, of: 4 });
        let how = "nearest".to_owned();
        let filled = Fact::Cleaned { steps: vec![], filled: 0.02, how, uneven: None };
        let expected = [check(short), check(rounded), check(bare), (Weight::Note, filled)];
        assert_eq!(facts(&solved), expected);
        let light = Solved { touching: vec![[0.1, 0.4], [0.2, 0.8], [0.2, 0.7]], ..solved.clone() };
        assert!(facts(&light).contains(&(Weight::Check, Fact::BelowPoint { loads: 2, of: 4 })));
        // More than a twentieth of guessed points may change a conclusion.
        let many = Solved { missing: 6, ..solved };
        assert_eq!(many.findings().last().map(|f| f.weight), Some(Weight::Check));
    }
}
