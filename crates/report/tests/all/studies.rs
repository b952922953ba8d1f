//! Real studies of small surfaces, each solved once.

use contact_compare::{
    Comparison, FileOrigin, Origin, Settings, Surface, built_in, built_in_recipes,
};
use contact_report::{Provenance, documents};
use contact_types::{Grid, HeightMap};
use std::ops::ControlFlow;
use std::sync::OnceLock;

pub(crate) fn run(surfaces: Vec<Surface>, settings: Settings) -> Comparison {
    Comparison::run(surfaces, settings, built_in(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// The built-in surfaces on 96 x 96 points.
pub(crate) fn small(names: &[&str]) -> Vec<Surface> {
    let mut recipes = built_in_recipes();
    recipes.retain(|r| names.contains(&r.name.as_str()));
    for recipe in &mut recipes {
        recipe.shape = [96, 96];
    }
    recipes.iter().map(|recipe| recipe.make().unwrap()).collect()
}

pub(crate) fn one() -> &'static Comparison {
    static ONE: OnceLock<Comparison> = OnceLock::new();
    ONE.get_or_init(|| {
        let mut study = run(small(&["ground"]), Settings::default());
        let mut iterations = 0;
        let mut go = |news: contact_compare::Progress<'_>| {
            iterations += usize::from(matches!(news, contact_compare::Progress::Iterated { .. }));
            ControlFlow::Continue(())
        };
        study.look_around(&mut go).unwrap();
        assert!(iterations > 0, "the listener hears of iterations");
        study
    })
}

pub(crate) fn three() -> &'static Comparison {
    static THREE: OnceLock<Comparison> = OnceLock::new();
    THREE.get_or_init(|| run(small(&["polished", "ground", "blasted"]), Settings::default()))
}

/// Names that would break a page if they were not escaped, heights that do not repeat.
pub(crate) fn hostile() -> &'static Comparison {
    static HOSTILE: OnceLock<Comparison> = OnceLock::new();
    HOSTILE.get_or_init(|| {
        let grid = Grid::new([40, 56], [2e-6, 1e-6]).unwrap();
        let heights =
            HeightMap::from_fn(grid, |y, x| 1e-7 * ((3e5 * x).sin() + (2e5 * y).cos()) + 1e-3 * x)
                .unwrap();
        let name = "</script><b>\"&'.x3p".to_owned();
        let (path, fill) = (name.clone(), "harmonic".into());
        let file = FileOrigin { path, fill, missing: 300, ..FileOrigin::default() };
        let surface = Surface { name, origin: Origin::File(file), heights };
        run(vec![surface], Settings { pressures: Some(vec![1e5, 1e7, 1e8]), ..Settings::default() })
    })
}

/// A ground metal that yields.
pub(crate) fn yielding() -> &'static Comparison {
    static YIELDING: OnceLock<Comparison> = OnceLock::new();
    YIELDING.get_or_init(|| {
        let settings = Settings {
            hardness: Some(5e9),
            conductivities: Some([400.0, 50.0]),
            ..Settings::default()
        };
        let mut study = run(small(&["ground"]), settings);
        study.look_around(&mut |_| ControlFlow::Continue(())).unwrap();
        study
    })
}

pub(crate) fn all() -> [&'static Comparison; 4] {
    [one(), three(), hostile(), yielding()]
}

/// The text of a file of a study.
pub(crate) fn file(comparison: &Comparison, name: &str) -> String {
    let [version, platform] = ["0", "test"].map(String::from);
    let repeat = "rough-contact compare <x> --out y".into();
    let made = Provenance { version, platform, unix_time: 0, repeat };
    documents(comparison, &made).into_iter().find(|f| f.0 == name).unwrap().1
}

pub(crate) fn html(comparison: &Comparison) -> String {
    file(comparison, "report.html")
}
