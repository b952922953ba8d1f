//! The numbers every figure over the load draws: the same that `curves.csv` lists.

use crate::draw::palette::{ELASTIC_LOOK, Style};
use crate::numbers::{NEWTONS, PASCALS, Unit, signed_range, significant, unit_for};
use crate::plot_styles::plot_style;
use contact_compare::{Card, DeterministicPoint, ModelComparison, ModelCurve, SurfaceComparison};

/// Error within which a closed form counts as an answer.
pub(crate) const WANTED: f64 = 0.10;

/// One closed form over the loads.
pub(crate) struct LoadLine {
    /// The series of the study it is, see [`Canvas::series`](crate::draw::svg::Canvas::series); may be empty.
    pub name: String,
    pub label: String,
    pub look: Style,
    /// Number at each load, of a model its area fraction; `None` where there is none.
    pub values: Vec<Option<f64>>,
}

pub(crate) struct LoadLines {
    /// Nominal pressures (Pa), rising.
    pub pressures: Vec<f64>,
    /// Deterministic area fraction at each; `None` where there is none.
    pub area: Vec<Option<f64>>,
    /// Its interval as that of this map.
    pub interval: Vec<Option<[f64; 2]>>,
    /// The closed forms of these bodies that answer at one load at least; before them the solution of elastic
    /// bodies, where that of bodies that yield is the reference.
    pub models: Vec<LoadLine>,
    /// Nominal area of the loads (m²), if they are read as forces.
    pub load_area: Option<f64>,
    /// Index of the load read off.
    pub headline: usize,
    /// Which bodies they are of, where a study is of two kinds; else empty.
    pub of: &'static str,
}

/// What theories are judged by: the solution for the bodies that they are about.
#[derive(Debug)]
#[non_exhaustive]
pub struct Reference<'a> {
    /// Which bodies, where a study is of two kinds; else empty.
    pub of: &'static str,
    /// The solution at each load.
    pub points: &'a [DeterministicPoint],
    /// The theories of these bodies, each with its place in the list.
    pub models: Vec<(usize, &'a ModelComparison)>,
}

/// With the pressure limited by the hardness, and theories of that.
pub(crate) const YIELDING: &str = "elastic–plastic contact";
/// Beside it.
pub(crate) const ELASTIC: &str = "elastic contact";

/// What the theories of a study are judged by: one solution, or of bodies that yield two, theirs first.
pub fn references(surface: &SurfaceComparison) -> Vec<Reference<'_>> {
    let two = !surface.elastic.is_empty();
    let kinds = if two { vec![YIELDING, ELASTIC] } else { vec![""] };
    let of_kind = |of: &'static str| {
        let points = if of == ELASTIC { &surface.elastic } else { &surface.deterministic };
        let models = surface.models.iter().enumerate();
        let models = models.filter(|(_, m)| !two || m.card.yields == (of == YIELDING));
        Reference { of, points, models: models.collect() }
    };
    kinds.into_iter().map(of_kind).collect()
}

impl LoadLine {
    pub(crate) fn new(name: &str, label: &str, look: Style, values: Vec<Option<f64>>) -> Self {
        Self { name: name.into(), label: label.into(), look, values }
    }

    /// Of a model that answers; its `place` in the study.
    pub(crate) fn of(card: &Card, place: usize, curve: &ModelCurve) -> Self {
        let look = plot_style(&card.name, place);
        let points = curve.points.iter();
        let values = points.map(|p| p.as_ref().ok().map(|s| s.area_fraction)).collect();
        Self::new(&card.name, &card.label, look, values)
    }
}

impl LoadLines {
    /// The numbers of a surface; of bodies that yield those of the elastic ones apart, so that each theory is
    /// beside the solution of the bodies it is about.
    pub(crate) fn panels(surface: &SurfaceComparison) -> Vec<Self> {
        references(surface).into_iter().map(|reference| Self::of(surface, reference)).collect()
    }

    fn of(surface: &SurfaceComparison, reference: Reference<'_>) -> Self {
        let Reference { of, points, models } = reference;
        let answers = || points.iter().map(|p| p.answer.as_ref());
        let models = models
            .into_iter()
            .filter_map(|(place, m)| Some(LoadLine::of(&m.card, place, m.outcome.as_ref().ok()?)));
        let elastic = (of == YIELDING).then(|| {
            let areas = surface.elastic.iter().map(|p| Some(p.answer.as_ref()?.area_fraction));
            LoadLine::new("elastic", "Elastic", ELASTIC_LOOK, areas.collect())
        });
        Self {
            pressures: points.iter().map(|p| p.mean_pressure).collect(),
            area: answers().map(|a| a.map(|a| a.area_fraction)).collect(),
            interval: answers().map(|a| a?.budget.area.interval().ok()).collect(),
            models: elastic.into_iter().chain(models).collect(),
            load_area: surface.load_area,
            headline: surface.headline,
            of,
        }
    }

    /// ", elastic contact": which bodies these are of, where a study is of two kinds.
    pub(crate) fn whose(&self) -> String {
        if self.of.is_empty() { String::new() } else { format!(", {}", self.of) }
    }

    pub(crate) fn errors(&self, model: &LoadLine) -> Vec<Option<f64>> {
        let error =
            |(m, d): (&Option<f64>, &Option<f64>)| Some((*m)? / d.filter(|d| *d > 0.0)? - 1.0);
        model.values.iter().zip(&self.area).map(error).collect()
    }
}

/// Unit in which loads are read, as a scale of the pressure, and the title of their axis: pressures, or
/// forces if their area (m²) is given.
pub(crate) fn load_axis(pressures: &[f64], area: Option<f64>) -> (Unit, String) {
    let middle = (pressures[0] * pressures[pressures.len() - 1]).sqrt();
    let Some(area) = area else {
        let unit = unit_for(middle, PASCALS);
        return (unit, format!("Nominal pressure ({})", unit.name));
    };
    let unit = unit_for(middle * area, NEWTONS);
    (Unit { scale: unit.scale / area, ..unit }, format!("Load ({})", unit.name))
}

/// Ends of an axis over the loads; of one load around it.
pub(crate) fn load_ends(first: f64, last: f64) -> [f64; 2] {
    if last > first { [first, last] } else { [first / 3.0, last * 3.0] }
}

pub(crate) fn min_max(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let is_below = |a: f64, b: f64| a.total_cmp(&b).is_lt(); // NaN is the upper end, and seen
    let wider = |(lo, hi), (v, _)| {
        (if is_below(v, lo) { v } else { lo }, if is_below(hi, v) { v } else { hi })
    };
    values.map(|v| (v, v)).reduce(wider)
}

pub(crate) fn range_words(values: &[Option<f64>], unit: &str) -> String {
    min_max(values.iter().flatten().copied()).map_or("none".into(), |(lo, hi)| {
        format!("{} to {}{unit}", significant(lo, 3), significant(hi, 3))
    })
}

/// "GW −38 to −4.3 %; Persson …": the finding, for the text alternative of a figure.
pub(crate) fn compared(lines: &LoadLines) -> String {
    let errors = |m: &LoadLine| {
        let (lo, hi) = min_max(lines.errors(m).into_iter().flatten())?;
        Some(format!("{} {}", m.label, signed_range(lo, hi)))
    };
    let parts: Vec<String> = lines.models.iter().filter_map(errors).collect();
    match parts.join("; ") {
        none if none.is_empty() => "No closed form answers.".into(),
        all => format!("Errors over the loads: {all}."),
    }
}
