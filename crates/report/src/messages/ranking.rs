//! The closed forms and coarser grids by their error at the reference load.

use crate::draw::palette::{DETERMINISTIC_STYLE, INK2, Style};
use crate::draw::svg::escape;
use crate::figures::cost::CostRoute;
use crate::lines::WANTED;
use crate::messages::finding::capital;
use crate::numbers::{SPACE, duration, signed_percent};
use contact_compare::{
    Applies, Coarser, DeterministicAnswer, ModelComparison, SurfaceComparison, elastic_holds,
};

/// A model within a sentence, its article small; escaped.
pub(crate) fn named(model: &ModelComparison) -> String {
    let title = &model.card.title;
    match title.strip_prefix("The ") {
        Some(rest) => format!("the {}", escape(rest)),
        None => escape(title),
    }
}

/// A closed form with its error at the reference load.
pub(crate) struct Ranked<'a> {
    pub model: &'a ModelComparison,
    /// Its place among the models of the study.
    pub place: usize,
    /// Signed relative error at the reference load.
    pub error: f64,
    /// Seconds to its first answer.
    pub seconds: f64,
    /// Seconds of an answer from typed numbers, if it can be asked so.
    pub typed: Option<f64>,
}

/// The closed forms that answer at the reference load, nearest first; of bodies that yield those made for them.
pub(crate) fn ranked<'a>(surface: &'a SurfaceComparison) -> Vec<Ranked<'a>> {
    let elastic = elastic_holds(surface);
    let rank = |(place, model): (usize, &'a ModelComparison)| {
        let curve = model.outcome.as_ref().ok().filter(|_| model.card.yields || elastic)?;
        let error = (*curve.errors.get(surface.headline)?)?;
        let typed = (!model.card.inputs.is_empty()).then_some(curve.seconds);
        Some(Ranked { model, place, error, seconds: curve.preparation + curve.seconds, typed })
    };
    let mut list: Vec<Ranked<'a>> = surface.models.iter().enumerate().filter_map(rank).collect();
    list.sort_by(|a, b| a.error.abs().total_cmp(&b.error.abs()));
    list
}

/// The published closed form nearest at the reference load: its name, "−19 %, 610 µs".
pub(crate) fn published(surface: &SurfaceComparison) -> [String; 2] {
    if !is_known(surface) {
        return ["not ranked".into(), format!("the area is not known to 10{SPACE}%")];
    }
    let is_published = |r: &Ranked<'_>| r.model.card.formula.is_empty();
    let kind = if elastic_holds(surface) { "" } else { " of elastic–plastic contact" };
    match ranked(surface).into_iter().find(is_published) {
        Some(r) => way(&r),
        None => ["none".into(), format!("no closed form{kind} answers at this load")],
    }
}

/// A closed form as an answer, with its domain where that is strained.
fn way(r: &Ranked<'_>) -> [String; 2] {
    let name = capital(&named(r.model));
    let strained = r.model.verdict.answer == Applies::Caution && r.model.verdict.at_every_load;
    let caution = if strained { ", domain strained" } else { "" };
    [name, format!("{}, {}{caution}", signed_percent(r.error), duration(r.seconds))]
}

/// The cheapest way to an area within 10 %: a closed form, else a coarser grid, else this solution.
pub(crate) fn cheapest(surface: &SurfaceComparison) -> Option<[String; 2]> {
    let answer = surface.headline_answer().filter(|_| is_known(surface))?;
    let forms = ranked(surface).into_iter().filter(|r| r.error.abs() <= WANTED);
    let form = forms.min_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let grid = |grid: &Coarser| {
        let ([ny, nx], error) = (grid.shape, signed_percent(grid.error));
        [format!("Solver on {nx} × {ny} points"), format!("{error}, {}", duration(grid.seconds))]
    };
    Some(
        form.map(|r| way(&r))
            .or_else(|| cheapest_of(&surface.coarser).map(grid))
            .unwrap_or_else(|| ["This solution".into(), duration(answer.diagnostics.seconds)]),
    )
}

/// The closed form nearest at the reference load, where the area is known well enough to tell.
pub(crate) fn nearest(surface: &SurfaceComparison) -> Option<Ranked<'_>> {
    if is_known(surface) { ranked(surface).into_iter().next() } else { None }
}

/// Whether the area at the reference load is known well enough to rank closed forms by it.
pub(crate) fn is_known(surface: &SurfaceComparison) -> bool {
    let known = |a: &DeterministicAnswer| {
        Some(a.budget.area.half_width().ok()? <= WANTED * a.area_fraction)
    };
    surface.headline_answer().and_then(known).unwrap_or(false)
}

/// A filled dot as the deterministic solution has, in the grey of notes.
const LOOK: Style = Style { colour: INK2, ..DETERMINISTIC_STYLE };

/// "½ grid": half as many points along each side.
fn label(factor: usize) -> String {
    match factor {
        2 => "½ grid".into(),
        4 => "¼ grid".into(),
        8 => "⅛ grid".into(),
        other => format!("1/{other} grid"),
    }
}

pub(crate) fn coarser_routes(surface: &SurfaceComparison) -> impl Iterator<Item = CostRoute> {
    surface.coarser.iter().map(|c| CostRoute::new(label(c.factor), LOOK, c.seconds, c.error))
}

/// The coarsest grid that is within the wanted error together with all finer ones: a coarse grid
/// that is near while a finer one is not is near by chance.
fn cheapest_of(grids: &[Coarser]) -> Option<&Coarser> {
    grids.iter().take_while(|c| c.error.abs() <= WANTED).last()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_that_is_near_by_chance_is_not_recommended() {
        let chosen = |errors: [f64; 3]| {
            let (touching_fraction, area_fraction, seconds) = (0.02, 0.02, 1.0);
            let grids = [2, 4, 8].into_iter().zip(errors).map(|(factor, error)| {
                let shape = [512 / factor; 2];
                Coarser { factor, shape, touching_fraction, area_fraction, error, seconds }
            });
            cheapest_of(&grids.collect::<Vec<_>>()).map(|c| c.factor)
        };
        assert_eq!(chosen([0.01, 0.05, 0.30]), Some(4));
        assert_eq!(chosen([-0.01, -0.05, 0.09]), Some(8));
        assert_eq!(chosen([0.12, 0.05, 0.02]), None);
    }
}
