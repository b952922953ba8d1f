//! A closer look at the headline, for a report: what a coarser grid would have cost in accuracy, its stiffness, and what
//! other choices in preparing the map would have made of its area.

use crate::conduction::{FEWEST_POINTS, remove_octaves, without_shorter};
use crate::progress::LoadListener;
use crate::result::{ChoiceKind, Coarser, Comparison, SurfaceComparison};
use crate::{EdgesName, Listener, Origin, Settings, StudyError};
use contact_accuracy::{Estimate, Ladder, Setup, regrid, thinned, with_images};
use contact_types::HeightMap;
use fft_bem_solver::{Load, Maps, Solution, Solver};
use grid_fft::parallel::on_threads;
use std::borrow::Cow;
use surface_stats::Level;
use surface_stats::clean::mirrored;

/// Point spacings tried, in spacings of the map. Together they have
/// 1/4 + 1/16 + 1/64 = 33 % of its points.
const COARSER: [usize; 3] = [2, 4, 8];

/// Points a side above which the choices are compared on a coarser grid.
const MOST_POINTS: usize = 1024;

/// What is asked of a surface beside its loads.
type Ask = fn(&mut SurfaceComparison, &Settings, &mut LoadListener<'_, '_>);

impl Comparison {
    /// What a report asks beside the loads, at the converged headline of every surface: coarser grids, unless the grid was
    /// chosen for an accuracy; the map without its shortest octaves, if its conductance was asked for, since what of
    /// that and of the area is a property of the shortest wave that was measured; and a closer look, for a map whose
    /// edges do not match about four solutions.
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
                    let (listener, index) = (&mut *progress, surface.headline);
                    let mut watch = LoadListener { listener, index, is_stopped: false };
                    ask(surface, settings, &mut watch);
                    if watch.is_stopped { Err((stage, StudyError::Stopped)) } else { Ok(()) }
                })
            })
        })
    }
}

impl SurfaceComparison {
    /// The headline load on another map, and the solver of it; from its pressure if there are as many points.
    pub(crate) fn solve_headline(
        &self,
        map: &HeightMap,
        settings: &Settings,
        watch: &mut LoadListener<'_, '_>,
    ) -> Option<(Solver, Solution)> {
        if watch.is_stopped {
            return None;
        }
        let is_mirrored = settings.edges == EdgesName::Mirrored;
        let whole = with_images(Cow::Borrowed(map), is_mirrored).ok()?;
        let builder = settings.solver().maps(Maps::Pressure);
        let mut solver = builder.build(whole.grid(), self.inputs.modulus).ok()?;
        let load = Load::MeanPressure(self.headline_pressure());
        solver.take_surface(&whole).ok()?;
        let start = |i: usize| self.pressure[i];
        let is_one = whole.grid() == self.solved_map().grid() && !self.pressure.is_empty();
        let start = is_one.then_some(&start as &(dyn Fn(usize) -> f64 + Sync));
        let found = solver.solve_again(load, start, |now| watch.iteration(now));
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
    let stiffness = stiffness(surface, settings, watch);
    if let Some(answer) = &mut surface.deterministic[surface.headline].answer {
        answer.budget.stiffness = stiffness;
    }
    if !watch.is_stopped {
        let choices = choices(surface, settings, watch);
        surface.choices = (!watch.is_stopped).then_some(choices);
    }
}

/// The stiffness of the headline's contact set: that of its conductance, if it was asked for.
fn stiffness(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) -> Option<Estimate> {
    if let Some(known) = surface.headline_answer()?.budget.stiffness {
        return Some(known);
    }
    let setup = Setup {
        mirrored: settings.edges == EdgesName::Mirrored,
        stiffness: true,
        ..Setup::new(settings.solver().maps(Maps::Pressure), surface.inputs.modulus)
    };
    let mut solution = surface.solution.take()?;
    let mut ladder = Ladder::new(surface.surface.clone(), setup).ok()?;
    solution.pressure.clone_from(&surface.pressure);
    let load = Load::MeanPressure(surface.headline_pressure());
    ladder.answer(load, solution, |now| watch.iteration(now)).ok()?.budget.stiffness
}

/// What other choices do to the area; those that cannot be tried on this map are left out.
fn choices(
    surface: &SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) -> Vec<(ChoiceKind, f64)> {
    let mut area = |map: &HeightMap| {
        let (_, solution) = surface.solve_headline(map, settings, watch)?;
        Some(solution.state.area_fraction).filter(|a| *a > 0.0)
    };
    let repeats = surface.map.repeats;
    let on = |map: &HeightMap, shape: [usize; 2]| regrid(map, shape, repeats).ok();
    let shape = surface.surface.grid().shape();
    if shape[0].min(shape[1]) < FEWEST_POINTS {
        return Vec::new(); // profiles, and maps too small to lose a wave
    }
    let factor = shape[0].max(shape[1]).div_ceil(MOST_POINTS);
    let used = if factor > 1 {
        on(&surface.surface, shape.map(|n| (n / factor).max(FEWEST_POINTS))).map(Cow::Owned)
    } else {
        Some(Cow::Borrowed(&surface.surface))
    };
    let Some(used) = used.as_deref() else { return Vec::new() };
    let known = surface.headline_answer().map(|a| a.area_fraction);
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
        add(
            ChoiceKind::Paraboloid,
            effect(Level::Quadratic.taken_off(used.clone()).ok().map(|found| found.1)),
        );
    }
    let [dy, dx] = used.grid().pixel();
    let shortest = surface.statistics.cutoff.unwrap_or(0.0).max(2.0 * dy.max(dx));
    let octave = surface.conduction.as_ref().and_then(|c| c.octaves.get(1));
    let known = octave.filter(|_| factor == 1).map(|octave| octave.area / reference - 1.0);
    let smooth = || effect(without_shorter(used, 2.0 * shortest, repeats));
    add(ChoiceKind::Cutoff(2.0 * shortest), known.or_else(smooth));
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

/// The headline load on every coarser grid. One without a converged solution, or with fewer than 16 points a side, is left out;
/// a grid that was chosen for an accuracy says itself what a coarser one would leave.
fn solve_coarser(
    surface: &mut SurfaceComparison,
    settings: &Settings,
    watch: &mut LoadListener<'_, '_>,
) {
    if surface.plan.is_some() {
        return;
    }
    let [ny, nx] = surface.surface.grid().shape();
    let (mut map, mut found) = (Cow::Borrowed(&surface.surface), Vec::new());
    for factor in COARSER.into_iter().filter(|factor| ny.min(nx) / factor >= FEWEST_POINTS) {
        let Ok(every_second) = thinned(&map, [0, 0]) else { break };
        found.extend(solve(surface, settings, (factor, &every_second), watch));
        map = Cow::Owned(every_second);
    }
    surface.coarser = found;
}

fn solve(
    surface: &SurfaceComparison,
    settings: &Settings,
    (factor, map): (usize, &HeightMap),
    watch: &mut LoadListener<'_, '_>,
) -> Option<Coarser> {
    let truth = surface.headline_answer().filter(|a| a.converged)?.area_fraction;
    let (_, solution) = surface.solve_headline(map, settings, watch)?;
    (truth > 0.0).then(|| Coarser {
        factor,
        shape: map.grid().shape(),
        touching_fraction: solution.touching_fraction(),
        area_fraction: solution.state.area_fraction,
        error: solution.state.area_fraction / truth - 1.0,
        seconds: solution.diagnostics.seconds,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{built_in, built_in_recipes};
    use std::ops::ControlFlow;

    /// The error is against the map's own answer. A map whose shortest wave is 8 points long has 4 at half the points:
    /// what that moves is in the uncertainty.
    #[test]
    fn half_the_points_are_off_by_as_much_as_the_uncertainty_says() {
        let mut recipe = built_in_recipes().remove(0);
        (recipe.shape, recipe.quantise) = ([128, 128], None);
        let [dy, dx] = recipe.pixel;
        recipe.cutoff = 8.0 * dy.max(dx);
        let settings = Settings::default();
        let mut go = |_: crate::Progress<'_>| ControlFlow::Continue(());
        let mut study =
            Comparison::run(vec![recipe.make().unwrap()], settings, built_in(), &mut go).unwrap();
        assert!(study.surfaces[0].coarser.is_empty(), "not asked for, not computed");
        let mut stop = |_: crate::Progress<'_>| ControlFlow::Break(());
        let stopped = study.look_around(&mut stop);
        assert!(matches!(stopped, Err(("coarser_grids", StudyError::Stopped))));
        assert!(study.surfaces[0].coarser.is_empty() && study.surfaces[0].choices.is_none());
        study.look_around(&mut go).unwrap();
        let surface = &study.surfaces[0];
        let shapes: Vec<[usize; 2]> = surface.coarser.iter().map(|c| c.shape).collect();
        assert_eq!(shapes, [[64, 64], [32, 32], [16, 16]]);
        let area = surface.headline_answer().unwrap().budget.area;
        for c in &surface.coarser {
            assert!((c.error - (c.area_fraction / area.value - 1.0)).abs() < 1e-15);
            assert!(c.touching_fraction > c.area_fraction && c.seconds > 0.0);
        }
        let half = &surface.coarser[0];
        assert!((half.error * area.value).abs() < area.half_width().unwrap(), "{half:?}");
    }
}
