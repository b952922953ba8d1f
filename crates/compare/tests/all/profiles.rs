//! The study of profiles: what the length of a trace leaves open, and what is always said.
use contact_compare::{
    Fact, GivenOrigin, Grid, Origin, ProfileComparison, ProfileSurface, Settings, Weight, built_in,
};
use surface_stats::profile::Trace;

/// Rows of an isotropic map, one trace or several.
fn study(traces: usize) -> ProfileComparison {
    let grid = Grid::new([64, 4096], [1e-6, 1e-6]).unwrap();
    let map = crate::rough(grid, 0.8, [64e-6, 8e-6], 3);
    let rows = map.heights().chunks_exact(4096).step_by(8).take(traces);
    let traces = rows.map(|row| Trace::new(1e-6, row.to_vec()).unwrap()).collect();
    let origin = Origin::Given(GivenOrigin::of(&map, "rows of a made surface"));
    let surface = ProfileSurface { name: "made".into(), origin, traces, uneven: None };
    let settings = Settings { modulus: 1e11, ..Settings::default() };
    ProfileComparison::run(surface, settings, built_in()).unwrap()
}

/// Persson at light load: A = p sqrt(8/(2π m2))/E* … falls as m2^(-1/2), so that the interval of the
/// area is the root of that of m2; that of the surface's true gradient 0.1 is inside.
#[test]
fn the_interval_of_an_area_is_that_of_its_moments() {
    let found = study(1);
    let persson = found.models.iter().find(|m| m.card.name == "persson").unwrap();
    let [low, high] = persson.outcome.as_ref().unwrap().intervals[0].unwrap();
    let [m2_low, m2_high] = found.statistics.intervals[1].unwrap();
    let expected = (m2_high / m2_low).sqrt();
    assert!((high / low / expected - 1.0).abs() < 0.02, "{low} {high} {expected}");
    // p / (E* h') with the true h' = 0.1: erf(sqrt(2) p/(E* h')).
    let x = found.pressures[0] / (1e11 * 0.1);
    let truth = (8.0 / std::f64::consts::PI).sqrt() * x;
    assert!(low < truth && truth < high, "{low} {truth} {high}");
}

#[test]
fn more_traces_narrow_the_interval_and_isotropy_is_always_said() {
    let (one, eight) = (study(1), study(8));
    let width = |s: &ProfileComparison| {
        let ([low, high], count) = s.span(s.headline).unwrap();
        assert!(count >= 4, "{count}");
        let gw = s.models.iter().find(|m| m.card.name == "gw").unwrap();
        let [a, b] = gw.outcome.as_ref().unwrap().intervals[s.headline].unwrap();
        assert!(low <= a && b <= high);
        (b / a).ln()
    };
    assert!(width(&eight) < 0.6 * width(&one), "{} {}", width(&eight), width(&one));
    for study in [&one, &eight] {
        let said = study.findings();
        let found = said.iter().find(|f| matches!(f.fact, Fact::Sample { .. })).unwrap();
        assert_eq!(found.weight, Weight::Check);
    }
}
