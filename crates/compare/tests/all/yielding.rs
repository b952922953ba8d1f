//! Studies of bodies that yield: what stands beside what, and what is not answered.

use contact_compare::{
    Applies, BULK_YIELD, Comparison, DeterministicPoint, Fact, ModelComparison, Reason, Recipe,
    Settings, StudyError, Surface, SurfaceComparison, built_in, elastic_holds, findings,
};
use std::ops::ControlFlow;

const MODULUS: f64 = 100e9;
const GRADIENT: f64 = 0.1;

fn surface() -> Surface {
    let recipe = Recipe {
        name: "rough".into(),
        description: String::new(),
        shape: [96, 96],
        pixel: [1e-6, 1e-6],
        hurst: 0.8,
        rolloff: 32e-6,
        cutoff: 8e-6,
        rms_height: None,
        rms_gradient: Some(GRADIENT),
        seed: 3,
        quantise: None,
    };
    recipe.make().unwrap()
}

fn study(settings: Settings) -> Result<Comparison, StudyError> {
    let settings = Settings { modulus: MODULUS, tolerance: 1e-6, ..settings };
    let go = &mut |_: contact_compare::Progress<'_>| ControlFlow::Continue(());
    Comparison::run(vec![surface()], settings, built_in(), go)
}

fn at(hardness: Option<f64>, pressures: &[f64]) -> SurfaceComparison {
    let pressures = (!pressures.is_empty()).then(|| pressures.to_vec());
    let mut found = study(Settings { hardness, pressures, ..Settings::default() }).unwrap();
    found.surfaces.remove(0)
}

fn area(point: &DeterministicPoint) -> f64 {
    point.answer.as_ref().unwrap().area_fraction
}

fn model<'a>(surface: &'a SurfaceComparison, name: &str) -> &'a ModelComparison {
    surface.models.iter().find(|m| m.card.name == name).unwrap()
}

const LOADS: [f64; 3] = [20e6, 100e6, 500e6];

/// Bodies that yield and elastic ones on one grid.
#[test]
fn a_fast_study_stands_beside_the_fast_elastic_one() {
    let fast = |hardness| {
        let pressures = Some(LOADS.to_vec());
        let settings = Settings { hardness, pressures, fast: true, ..Settings::default() };
        study(settings).unwrap().surfaces.remove(0)
    };
    let (yielding, elastic) = (fast(Some(4e9)), fast(None));
    for (beside, alone) in yielding.elastic.iter().zip(&elastic.deterministic) {
        assert!((area(beside) / area(alone) - 1.0).abs() < 1e-3);
    }
}

/// Theories of elastic bodies are judged by the elastic study.
#[test]
fn the_elastic_study_stands_beside_that_of_bodies_that_yield() {
    let (yielding, elastic) = (at(Some(4e9), &LOADS), at(None, &LOADS));
    assert!(elastic.elastic.is_empty() && elastic_holds(&elastic) && !elastic_holds(&yielding));
    for i in 0..LOADS.len() {
        let [a, b, c] =
            [&yielding.deterministic[i], &yielding.elastic[i], &elastic.deterministic[i]].map(area);
        assert!((b / c - 1.0).abs() < 1e-3, "{b} {c}");
        assert!(a > b && a >= (1.0 - 1e-12) * LOADS[i] / 4e9, "{a} {b}");
        let answer = yielding.deterministic[i].answer.as_ref().unwrap();
        let yielded = answer.diagnostics.yielded.unwrap();
        let carried = yielded.area_fraction * 4e9 / LOADS[i];
        assert!((yielded.load_share / carried - 1.0).abs() < 1e-9);
        assert!(answer.diagnostics.max_pressure <= 4e9);
    }
    assert!(yielding.models.iter().any(|model| model.card.name == "ceb"));
    for name in ["gw", "persson", "bgt"] {
        let (here, there) = (model(&yielding, name), model(&elastic, name));
        let [here_curve, there_curve] = [here, there].map(|m| m.outcome.as_ref().unwrap());
        for i in 0..LOADS.len() {
            let [of_elastic, alone] =
                [here_curve.errors[i].unwrap(), there_curve.errors[i].unwrap()];
            assert!((of_elastic - alone).abs() < 1e-3, "{name}: {of_elastic} {alone}");
        }
        let is_told = |r: &Reason| matches!(r, Reason::Elastic { everywhere: true, most, .. } if *most > 0.02);
        assert_eq!(here.verdict.answer, Applies::Caution);
        assert!(here.verdict.reasons.iter().any(is_told));
        assert!(!there.verdict.reasons.iter().any(|r| matches!(r, Reason::Elastic { .. })));
    }
    // Persson with yield keeps to its wall, and is nearer to the contact that yields than Persson without.
    let [with, without] =
        ["persson-yield", "persson"].map(|name| model(&yielding, name).outcome.as_ref().unwrap());
    for (i, point) in yielding.deterministic.iter().enumerate() {
        let off = |points: &[Result<_, _>]| {
            let state: &contact_types::ContactState = points[i].as_ref().unwrap();
            (state.area_fraction / area(point) - 1.0).abs()
        };
        assert!(off(&with.points) < off(&without.points), "at {:e}", point.mean_pressure);
        let own = with.errors[i].unwrap();
        assert!((own.abs() - off(&with.points)).abs() < 1e-12, "judged by the contact that yields");
    }
    let said = findings(&yielding);
    let found = said.iter().find_map(|f| match &f.fact {
        Fact::Yielding { headline, .. } => *headline,
        _ => None,
    });
    let found = found.unwrap();
    let ratio = found.over_elastic.unwrap();
    assert!((ratio / (MODULUS * yielding.inputs.rms_gradient() / 4e9) - 1.0).abs() < 1e-12);
    assert!(found.elastic_area.unwrap() < found.area && found.share > 0.1, "{found:?}");
    // What presses elastic bodies too hard does not press these.
    assert!(!said.iter().any(|f| matches!(f.fact, Fact::Yield { .. })));
}

/// A hardness that no pressure reaches is no other study, but for the two theories.
#[test]
fn a_hardness_out_of_reach_changes_nothing() {
    let (hard, elastic) = (at(Some(900e9), &LOADS), at(None, &LOADS));
    assert!(elastic_holds(&hard));
    for (a, b) in hard.deterministic.iter().zip(&elastic.deterministic) {
        assert!((area(a) / area(b) - 1.0).abs() < 1e-6);
    }
    // Where nothing yields the elastic answer is that answer: nothing was solved for it.
    assert_eq!(hard.deterministic, hard.elastic);
    let reasons = &model(&hard, "gw").verdict.reasons;
    assert!(!reasons.iter().any(|r| matches!(r, Reason::Elastic { .. })));
    assert!(!findings(&hard).iter().any(|f| matches!(f.fact, Fact::Yielding { .. })));
}

/// Loads that are chosen leave the bodies something to bear; loads that are asked may not.
#[test]
fn no_load_above_the_hardness_is_chosen_and_one_that_is_asked_has_no_answer() {
    for hardness in [5e9, 0.5e9, 1e6] {
        let chosen = at(Some(hardness), &[]);
        let loads: Vec<f64> = chosen.deterministic.iter().map(|p| p.mean_pressure).collect();
        assert!(loads.len() > 10 && loads.iter().all(|p| *p <= BULK_YIELD * hardness), "{loads:?}");
        let least = |p: &DeterministicPoint| (1.0 - 1e-12) * p.mean_pressure / hardness;
        assert!(chosen.deterministic.iter().all(|p| area(p) >= least(p)), "{hardness:e}");
    }
    let asked = at(Some(1e9), &[100e6, 2e9]);
    assert!(asked.deterministic[0].answer.is_some() && asked.deterministic[1].answer.is_none());
    let trouble = asked.deterministic[1].trouble.as_ref().unwrap();
    assert!(trouble.contains("hardness"), "{trouble}");
    assert!(asked.elastic[1].answer.is_some(), "elastic bodies bear anything");
}

#[test]
fn what_has_no_answer_is_refused_before_any_work() {
    let with = |hardness| Settings { hardness: Some(hardness), ..Settings::default() };
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(study(with(bad)), Err(StudyError::BadHardness { .. })), "{bad}");
    }
    // Named without a hardness, a theory of yield says what it lacks.
    let named = Settings { models: Some(vec!["ceb".into()]), ..Settings::default() };
    let found = study(named).unwrap();
    let [ceb] = &found.surfaces[0].models[..] else { panic!("one model") };
    assert!(ceb.outcome.as_ref().is_err_and(|e| e.to_string().contains("hardness")), "{ceb:?}");
}
