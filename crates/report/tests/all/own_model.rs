//! An own model and a curve computed elsewhere, on a map handed over in memory: each appears in the
//! study, the page and the files, with its citation, and none claims what it is not.

use contact_compare::{
    BuildError, Card, Comparison, CurvePoint, Inputs, Progress, Registry, Settings, StudyError,
    Surface, Tabulated, Theory, built_in,
};
use contact_report::{Provenance, documents};
use contact_types::{Citation, ContactModel, ContactState, Grid, HeightMap, ModelError};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

fn citation(authors: &str) -> Citation {
    let of_all = Citation::new("", 2031, "Half & half", "J. 1, 1", "10.1000/own");
    Citation { authors: authors.to_owned().into(), ..of_all }
}

/// Half of everything touches.
struct HalfTouches(Card);

impl Theory for HalfTouches {
    fn card(&self) -> &Card {
        &self.0
    }

    fn build(&self, _: &Inputs) -> Result<Box<dyn ContactModel>, BuildError> {
        Ok(Box::new(HalfTouches(self.0.clone())))
    }
}

impl ContactModel for HalfTouches {
    fn citation(&self) -> Citation {
        self.0.citation.clone()
    }

    fn at_pressure(&self, mean_pressure: f64) -> Result<ContactState, ModelError> {
        let (area_fraction, separation, mean_gap, caveat) = (0.5, None, None, None);
        Ok(ContactState { mean_pressure, area_fraction, separation, mean_gap, caveat })
    }
}

fn registry() -> Registry {
    let half = Card::new("half", "Half <b>& half</b>", citation("Own & Author"));
    let point = |mean_pressure| CurvePoint { mean_pressure, area_fraction: 0.25, mean_gap: None };
    let elsewhere = Card::new("elsewhere", "Elsewhere", citation("Another"));
    let mut curve = Tabulated::new(elsewhere, vec![point(1e5), point(1e9)]).unwrap();
    curve.surface = Some("waves".into());
    built_in().with(HalfTouches(half)).unwrap().with(curve).unwrap()
}

fn surface() -> Surface {
    let grid = Grid::new([32, 32], [1e-6, 1e-6]).unwrap();
    let wave = |k: f64, s: f64| (TAU * k * s / 32e-6).cos();
    let height = |y: f64, x: f64| 1e-7 * (wave(2.0, y) + wave(3.0, x));
    Surface::given("waves", HeightMap::from_fn(grid, height).unwrap(), "made by a <test>")
}

fn settings() -> Settings {
    let models = ["half", "elsewhere", "gw"].map(str::to_owned);
    let (pressures, models) = (Some(vec![1e7, 3e7]), Some(models.into()));
    Settings { pressures, models, ..Settings::default() }
}

#[test]
fn an_own_model_stands_in_study_page_and_files() {
    let mut iterations = Vec::new();
    let study = Comparison::run(vec![surface()], settings(), &registry(), &mut |news| {
        if let Progress::Iterated { index, .. } = news {
            iterations.push(index);
        }
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(iterations.contains(&0) && iterations.contains(&1));
    let models = &study.surfaces[0].models;
    let names: Vec<&str> = models.iter().map(|m| m.card.name.as_ref()).collect();
    assert_eq!(names, ["gw", "half", "elsewhere"], "in the order of the registry");
    let of = |name: &str| models.iter().find(|m| m.card.name == name).unwrap();
    let area =
        |name: &str| of(name).outcome.as_ref().unwrap().points[0].as_ref().unwrap().area_fraction;
    assert!((area("half") - 0.5).abs() < 1e-15 && (area("elsewhere") - 0.25).abs() < 1e-15);

    let made = Provenance::here("none");
    let files = documents(&study, &made);
    let [(_, page), (_, json), (_, csv), ..] = &files[..] else { panic!("five files") };
    assert!(page.contains("Half &lt;b&gt;&amp; half&lt;/b&gt;") && !page.contains("Half <b>&"));
    assert!(page.contains("Own &amp; Author") && page.contains("10.1000/own"));
    assert!(page.contains("made by a &lt;test&gt;"));
    // The hash shown is that of the heights, and none is empty.
    assert!(!page.contains("SHA-256 <code></code>"));
    let json: serde_json::Value = serde_json::from_str(json).unwrap();
    let surface = &json["surfaces"][0];
    let hash = surface["origin"]["given"]["sha256"].as_str().unwrap();
    assert!(hash.len() == 64 && page.contains(hash), "{hash}");
    let own = surface["models"].as_array().unwrap().iter().find(|m| m["model"] == "half");
    assert_eq!(own.unwrap()["citation"]["authors"], "Own & Author");
    let head = csv.lines().next().unwrap();
    assert!(head.contains("area_fraction_half [-]"), "{head}");
    assert!(head.contains("area_fraction_elsewhere [-]"), "{head}");
}

#[test]
fn a_study_stops_within_a_load() {
    let mut told = 0;
    let stopped = Comparison::run(vec![surface()], settings(), &registry(), &mut |news| {
        told += usize::from(matches!(news, Progress::Iterated { .. }));
        if told == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert!(matches!(stopped, Err(StudyError::Stopped)), "{told}");
    assert_eq!(told, 1);
}
