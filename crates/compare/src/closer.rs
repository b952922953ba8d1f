//! A closer look at the headline, for a report: proof of its iteration error, its stiffness, and what other
//! choices in preparing the map would have made of its area.

use crate::coarser::solve_coarser;
use crate::conduction::remove_octaves;
use crate::progress::LoadListener;
use crate::result::{ChoiceKind, Comparison, SurfaceComparison};
use crate::{EdgesName, Listener, Origin, Settings, StudyError};
use contact_accuracy::{Ladder, Setup, regrid};
use contact_types::HeightMap;
use fft_bem_solver::{Load, Maps, Solution, Solver};
use grid_fft::parallel::on_threads;
use std::borrow::Cow;
use surface_stats::clean::mirrored;
use surface_stats::{Level, level};

/// Points a side above which the choices are compared on a coarser grid.
const MOST_POINTS: usize = 1024;

/// What is asked of a surface beside its loads.
type Ask = fn(&mut SurfaceComparison, &Settings, &mut LoadListener<'_, '_>);

impl Comparison {
    /// What a report asks beside the loads, at the converged headline of every surface: coarser grids, unless the grid was
    /// chosen for an accuracy; the map without its shortest octaves, if its conductance was asked for, since what of
    /// that and of the area is a property of the shortest wave that was measured; and a closer look, for a map whose
    /// edges do not match about nine solutions.
    ///
    /// # Errors
    /// Which of `coarser_grids`, `octaves` and `closer_look` is not finished, and [`StudyError::Stopped`] if the listener
    /// breaks: what was found until then is kept.
    pub fn look_around(
        &mut self,
        progress: &mut Listener<'_>,
    ) -> Result<(), (&'static str, StudyError)> {
        let all: [(_, Ask); 3] = [
            ("coarser_grids", solve_coarser),
            ("octaves", remove_octaves),
            ("closer_look", look_closer),
        ];
        let Self { settings, surfaces, .. } = self;
        on_threads(settings.threads, || {
            all.into_iter().try_for_each(|(stage, ask)| {
                surfaces.iter_mut().try_for_each(|surface| {
                    let mut watch = LoadListener::new(progress, surface.headline);
                    ask(surface, settings, &mut watch);
                    watch.go_on().map_err(|why| (stage, why))
                })
            })
        })
    }
}

impl SurfaceComparison {
    /// The headline load on another map, from nothing, and the solver of it.
    pub(crate) fn solve_headline(
        &self,
        map: &HeightMap,
        settings: &Settings,
        watch: &mut LoadListener<'_, '_>,
    ) -> Option<(Solver, Solution)> {
        watch.go_on().ok()?;
        let whole = settings.edges.around(map).ok()?;
        let builder = settings.solver().maps(Maps::None);
        let mut solver = builder.build(whole.grid(), self.inputs.modulus).ok()?;
        let load = Load::MeanPressure(self.headline_pressure());
        let found = solver.solve_observed(&whole, load, |now| watch.iteration(now));
        Some((solver, found.ok()?))
    }
}

fn look_closer(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) {
    let is_solved = surface.headline_answer().is_some_and(|a| a.converged);
    if surface.plan.is_some() || !is_solved || surface.map.rms_height <= 0.0 {
        return;
    }
    let area = certify(surface, settings, watch);
    if watch.go_on().is_ok() {
        let choices = choices(surface, settings, area, watch);
        surface.choices = watch.go_on().is_ok().then_some(choices);
    }
}

/// Solves the headline once more with the rigorous bound and the stiffness of its contact set. Answers with the
/// area of this solution, if there is one.
fn certify(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) -> Option<f64> {
    let load = Load::MeanPressure(surface.headline_pressure());
    let builder = settings.solver().certified(true).maps(Maps::Pressure);
    let setup = Setup {
        mirrored: settings.edges == EdgesName::Mirrored,
        stiffness: true,
        ..Setup::new(builder, surface.inputs.modulus)
    };
    let mut ladder = Ladder::new(surface.surface.clone(), setup).ok()?;
    let found = ladder.solve(load, |now| watch.iteration(now)).ok()?;
    let area = found.solution.state.area_fraction;
    let answer = surface.deterministic.get_mut(surface.headline).and_then(|p| p.answer.as_mut());
    if let Some(answer) = answer {
        answer.diagnostics.energy_bound = found.solution.diagnostics.energy_bound;
        // With its conductance the stiffness was found already.
        answer.budget.stiffness = answer.budget.stiffness.or(found.budget.stiffness);
    }
    Some(area)
}

/// What other choices do to the area, which is `known` of the map as it is; those that cannot be tried on this map
/// are left out.
fn choices(
    surface: &SurfaceComparison,
    settings: &Settings,
    known: Option<f64>,
    watch: &mut LoadListener<'_, '_>,
) -> Vec<(ChoiceKind, f64)> {
    let mut area = |map: &HeightMap| {
        let (_, solution) = surface.solve_headline(map, settings, watch)?;
        Some(solution.state.area_fraction).filter(|a| *a > 0.0)
    };
    let repeats = surface.map.repeats;
    let on = |map: &HeightMap, shape: [usize; 2]| regrid(map, shape, repeats).ok();
    let shape = surface.surface.grid().shape();
    if shape[0].min(shape[1]) < 16 {
        return Vec::new(); // profiles, and maps too small to lose a wave
    }
    let factor = shape[0].max(shape[1]).div_ceil(MOST_POINTS);
    let used = if factor > 1 {
        on(&surface.surface, shape.map(|n| (n / factor).max(16))).map(Cow::Owned)
    } else {
        Some(Cow::Borrowed(&surface.surface))
    };
    let Some(used) = used.as_deref() else { return Vec::new() };
    let known = known.filter(|area| factor == 1 && *area > 0.0);
    let Some(reference) = known.or_else(|| area(used)) else { return Vec::new() };
    let mut list = Vec::new();
    let mut add = |kind, effect: Option<f64>| {
        list.extend(effect.map(|effect| (kind, effect)));
    };
    let mut effect = |map: Option<HeightMap>| Some(area(&map?)? / reference - 1.0);
    // Spikes of the map as given: a coarser grid smears them.
    let spikes = surface.spikes.indices.len();
    if spikes > 0 {
        let clean = surface.spikes.without(&surface.surface);
        let clean = match factor {
            1 => clean,
            _ => clean.and_then(|clean| on(&clean, used.grid().shape())),
        };
        add(ChoiceKind::WithoutSpikes(spikes), effect(clean));
    }
    let is_levelled = matches!(surface.statistics.level, Level::Plane);
    if !matches!(surface.origin, Origin::Recipe(_)) && is_levelled {
        add(ChoiceKind::Paraboloid, effect(level(used, Level::Quadratic).ok()));
    }
    let [dy, dx] = used.grid().pixel();
    let shortest = surface.statistics.cutoff.unwrap_or(0.0).max(2.0 * dy.max(dx));
    let waves = used.grid().size().map(|side| (side / shortest).floor() as usize);
    if waves[0].min(waves[1]) >= 16 {
        let smooth = on(used, waves).and_then(|coarse| on(&coarse, used.grid().shape()));
        add(ChoiceKind::Cutoff(2.0 * shortest), effect(smooth));
    }
    if !repeats && settings.edges == EdgesName::Periodic {
        // Half the points a side: its mirror images have as many as the map.
        let half = on(used, used.grid().shape().map(|n| n / 2));
        let as_it_is = half.as_ref().and_then(&mut area);
        let among_images = half.and_then(|map| area(&mirrored(&map).ok()?));
        let both = as_it_is.zip(among_images);
        add(ChoiceKind::Mirrored, both.map(|(as_it_is, mirrored)| mirrored / as_it_is - 1.0));
    }
    list
}
