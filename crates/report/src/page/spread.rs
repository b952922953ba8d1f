//! What captions say of the distributions at each load.

use crate::numbers::{AREAS, METRES, PASCALS, percent, quantity};
use contact_compare::{Distributions, SurfaceComparison};

/// Touching points below which classes say little.
pub(crate) const LEAST: usize = 200;

/// What the captions say of a load: the key of a cell of the slider, and its words; `None` where there are none.
pub(crate) type Say = (&'static str, fn(&Distributions) -> Option<String>);

pub(crate) const HIGHEST: Say =
    ("d-highest", |d| Some(quantity(*d.pressure.edges.last()?, PASCALS, 2)));
pub(crate) const SPOTS: Say = ("d-spots", |d| Some(d.spots.count.to_string()));
pub(crate) const HALF: Say = ("d-half", |d| {
    let half = d.spots.area_share.iter().rposition(|s| *s >= 0.5).unwrap_or(0);
    Some(quantity(d.spots.areas[half], AREAS, 2))
});
pub(crate) const TOUCHES: Say = ("d-touches", |d| Some(percent(1.0 - d.pressure.apart)));
pub(crate) const MEAN_GAP: Say = ("d-mean", |d| Some(quantity(d.gap.as_ref()?.mean, METRES, 2)));
pub(crate) const MOST_GAP: Say =
    ("d-most", |d| Some(quantity(*d.gap.as_ref()?.gaps.last()?, METRES, 2)));

/// Distributions of a load of which enough points touch.
pub(crate) fn at(surface: &SurfaceComparison, load: usize) -> Option<&Distributions> {
    let answer = surface.deterministic.get(load)?.answer.as_ref()?;
    let found = surface.distributions.get(load)?.as_ref()?;
    (answer.contact_pixels >= LEAST).then_some(found)
}

/// What the slider writes into the captions at each load.
pub(crate) fn cells(surface: &SurfaceComparison) -> impl Iterator<Item = (&str, Vec<String>)> {
    let all = [HIGHEST, SPOTS, HALF, TOUCHES, MEAN_GAP, MOST_GAP];
    all.into_iter().map(|(key, words)| {
        let of = |load| at(surface, load).and_then(words).unwrap_or_else(|| "–".into());
        (key, (0..surface.deterministic.len()).map(of).collect())
    })
}
