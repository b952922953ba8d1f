//! A study of two bodies: the sum of both, with what each was.

use contact_compare::{
    Comparison, Fact, Flip, GivenOrigin, Origin, Placing, RunFile, Settings, StudyError, Surface,
    built_in, built_in_recipes, findings,
};
use std::ops::ControlFlow;
use surface_stats::{Edges, Level};

fn pair(placing: &Placing) -> Surface {
    let body = |k: usize| {
        let mut recipe = built_in_recipes().swap_remove(k);
        recipe.shape = [96, 128];
        recipe.pixel = [1e-6; 2];
        (recipe.rolloff, recipe.cutoff, recipe.seed) = (24e-6, 8e-6, 7 + k as u64);
        recipe.make().expect("a surface")
    };
    body(0).against(&body(1), placing, Level::Mean).expect("a pair")
}

#[test]
fn the_models_get_the_moments_of_the_sum_and_it_is_said_how_they_add() {
    let surface = pair(&Placing::default());
    let (_, independence) = surface.origin.pair().and_then(|p| p.found).expect("laid");
    assert_eq!(surface.origin.edges(), Edges::Periodic, "as both were made");
    let settings = Settings {
        pressures: Some(vec![1e8]),
        level: Level::Mean,
        models: Some(vec!["gw".into()]),
        ..Settings::default()
    };
    let go = &mut |_: contact_compare::Progress<'_>| ControlFlow::Continue(());
    let study = Comparison::run(vec![surface], settings, built_in(), go).expect("runs");
    let one = &study.surfaces[0];
    assert_eq!(one.inputs.moments, Some(independence.composite));
    let (moments, sum) = (one.inputs.moments.expect("rough"), independence.sum());
    for (k, (own, sum)) in
        [(moments.m0, sum.m0), (moments.m2, sum.m2), (moments.m4, sum.m4)].into_iter().enumerate()
    {
        let off = own / sum - 1.0;
        let chance = independence.chance[k];
        assert!(off.abs() < 4.0 * chance, "m{}: {off} beside {chance}", 2 * k);
    }
    let said = findings(one);
    let passed = said.iter().find_map(|f| match &f.fact {
        Fact::Passed(passed) => passed.independence,
        _ => None,
    });
    assert_eq!(passed, Some(independence));
}

#[test]
fn a_run_file_with_heights_handed_over_is_refused() {
    let Surface { name, mut origin, heights } =
        pair(&Placing { flip: Flip::Rows, shift: [3e-6, -1e-6 / 3.0] });
    if let Origin::Pair(pair) = &mut origin {
        pair.bodies[1] = Origin::Given(GivenOrigin::of(&heights, "handed over"));
    }
    let run = RunFile::of(&Settings::default(), [(&name, &origin)]);
    let read = RunFile::parse(&run.to_toml().expect("text"));
    assert!(matches!(read, Err(StudyError::Given(_))));
}
