//! Real studies of small surfaces, each solved once.

use contact_compare::{
    Comparison, FileOrigin, Origin, Settings, Surface, built_in, built_in_recipes,
};
use contact_report::{Provenance, documents};
use contact_types::{Grid, HeightMap};
use std::ops::ControlFlow;
use std::sync::LazyLock;

pub(crate) fn run(surfaces: Vec<Surface>, settings: Settings) -> Comparison {
    Comparison::run(surfaces, settings, built_in(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The built-in surfaces on 100 x 100 points.
pub(crate) fn small(names: &[&str]) -> Vec<Surface> {
    let mut recipes = built_in_recipes();
    recipes.retain(|r| names.contains(&r.name.as_str()));
    for recipe in &mut recipes {
        recipe.shape = [100, 100];
    }
    recipes.iter().map(|recipe| recipe.make().unwrap()).collect()
}

pub(crate) static ONE: LazyLock<Comparison> = LazyLock::new(|| {
    let mut study = run(small(&["ground"]), Settings::default());
    let mut iterations = 0;
    let mut go = |news: contact_compare::Progress<'_>| {
        iterations += usize::from(matches!(news, contact_compare::Progress::Iterated { .. }));
        ControlFlow::Continue(())
    };
    study.look_around(&mut go).unwrap();
    assert!(iterations > 0, "the listener hears of iterations");
    study
});

pub(crate) static THREE: LazyLock<Comparison> =
    LazyLock::new(|| run(small(&["polished", "ground", "blasted"]), Settings::default()));

/// Names that would break a page if they were not escaped, heights that do not repeat.
pub(crate) static HOSTILE: LazyLock<Comparison> = LazyLock::new(|| {
    let grid = Grid::new([40, 56], [2e-6, 1e-6]).unwrap();
    let heights =
        HeightMap::from_fn(grid, |y, x| 1e-7 * ((3e5 * x).sin() + (2e5 * y).cos()) + 1e-3 * x)
            .unwrap();
    let name = "</script><b>\"&'.x3p".to_owned();
    let (path, fill) = (name.clone(), "harmonic".into());
    let file = FileOrigin { path, fill, missing: 300, ..FileOrigin::default() };
    let surface = Surface { name, origin: Origin::File(file), heights };
    run(vec![surface], Settings { pressures: Some(vec![1e5, 1e7, 1e8]), ..Settings::default() })
});

/// A ground metal that yields.
pub(crate) static YIELDING: LazyLock<Comparison> = LazyLock::new(|| {
    let settings = Settings {
        hardness: Some(5e9),
        conductivities: Some([400.0, 50.0]),
        ..Settings::default()
    };
    let mut study = run(small(&["ground"]), settings);
    study.look_around(&mut |_| ControlFlow::Continue(())).unwrap();
    study
});

pub(crate) fn all() -> [&'static Comparison; 4] {
    [&ONE, &THREE, &HOSTILE, &YIELDING]
}

/// The text of a file of a study.
pub(crate) fn file(comparison: &Comparison, name: &str) -> String {
    let (version, platform) = ("0".into(), "test".into());
    let repeat = "rough-contact compare <x> --out y".into();
    let made = Provenance { version, platform, unix_time: 0, repeat };
    let files = documents(comparison, &made);
    files.into_iter().find(|f| f.0 == name).unwrap().1
}

pub(crate) fn html(comparison: &Comparison) -> String {
    file(comparison, "report.html")
}
