//! Every warning comes when its cause is there, and a sound surface has none.
use contact_types::{Grid, HeightMap};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, StatsOptions, SurfaceStatistics, Warning};

const UM: f64 = 1e-6;

fn recipe() -> SelfAffine {
    let scale = Scale::RmsHeight(0.3 * UM);
    SelfAffine { hurst: 0.7, scale, seed: 2, ..crate::recipe([384; 2], [40.0, 6.0]) }
}

fn changed(map: &HeightMap, height: impl Fn(f64, f64, f64) -> f64) -> HeightMap {
    let nx = map.grid().shape()[1];
    let [dy, dx] = map.grid().pixel();
    let at = |(i, h): (usize, &f64)| height(*h, (i / nx) as f64 * dy, (i % nx) as f64 * dx);
    HeightMap::new(map.grid(), map.heights().iter().enumerate().map(at).collect()).unwrap()
}

fn warnings(map: &HeightMap, edges: Edges) -> Vec<Warning> {
    let options = StatsOptions { level: Level::Mean, edges, ..StatsOptions::default() };
    SurfaceStatistics::of(map, &options).unwrap().warnings
}

fn kinds(map: &HeightMap, edges: Edges) -> Vec<&'static str> {
    warnings(map, edges).iter().map(Warning::kind).collect()
}

#[test]
fn a_sound_surface_has_none() {
    let map = recipe().generate().unwrap();
    for edges in [Edges::Open, Edges::Periodic] {
        assert_eq!(kinds(&map, edges), [""; 0]);
    }
}

#[test]
fn a_tilt_is_named_until_it_is_taken_off() {
    let map = changed(&recipe().generate().unwrap(), |h, y, x| h + 0.002 * x - 0.003 * y);
    assert!(kinds(&map, Edges::Open).contains(&"tilted"));
    let options = StatsOptions { level: Level::Plane, ..StatsOptions::default() };
    assert_eq!(SurfaceStatistics::of(&map, &options).unwrap().warnings, []);
}

#[test]
fn steps_are_named_with_their_height() {
    let map = SelfAffine { quantise: Some(50e-9), ..recipe() }.generate().unwrap();
    let found = warnings(&map, Edges::Periodic);
    let Warning::Noisy { step: Some(step), m4_share, .. } = found[0] else { panic!("{found:?}") };
    assert!((step / 50e-9 - 1.0).abs() < 1e-9 && m4_share > 0.25);
    assert!(matches!(found[1], Warning::FlatTops { .. }), "{found:?}");
}

#[test]
fn every_cause_is_named() {
    let made = |recipe: SelfAffine| recipe.generate().unwrap();
    let map = made(recipe());
    let stretched = Grid::new([384, 384], [2.0 * UM, UM]).unwrap();
    let stretched = HeightMap::new(stretched, map.heights().to_vec()).unwrap();
    // Oblique lay has equal slopes along both axes: only the tensor sees it.
    let oblique = changed(&map, |h, y, x| h + 0.6 * UM * (0.5 * (x + y) / UM).sin());
    let scale = Scale::RmsHeight(20e-9);
    let noise =
        made(SelfAffine { rolloff: 2.0 * UM, cutoff: 2.0 * UM, scale, seed: 9, ..recipe() });
    let at = |y: f64, x: f64| noise.at((y / UM).round() as usize, (x / UM).round() as usize);
    let noisy = changed(&map, |h, y, x| h + at(y, x));
    let worn = changed(&map, |h, _, _| h.min(0.1 * UM));
    let fine = made(SelfAffine { cutoff: 2.0 * UM, ..recipe() });
    // One oblique wave: m0 m4 / m2² = 1, below any isotropic surface.
    let wave = changed(&map, |_, y, x| UM * (0.2 * (x + y) / UM).sin());
    let long = made(SelfAffine { rolloff: 1000.0 * UM, ..recipe() });
    let few = made(SelfAffine { rolloff: 110.0 * UM, ..recipe() });
    let crop = long.heights().chunks_exact(384).take(200).flat_map(|row| &row[..200]);
    let crop = crop.copied().collect();
    let crop = HeightMap::new(Grid::new([200, 200], [UM, UM]).unwrap(), crop).unwrap();
    for (map, edges, cause) in [
        (stretched, Edges::Periodic, "anisotropic"),
        (oblique, Edges::Open, "anisotropic"),
        (noisy, Edges::Open, "noisy"),
        (worn, Edges::Periodic, "not-gaussian"),
        (fine, Edges::Periodic, "unresolved"),
        (wave, Edges::Open, "narrow-band"),
        (long, Edges::Periodic, "no-rolloff"),
        (few, Edges::Periodic, "few-waves"),
        (crop, Edges::Open, "edge-jump"),
    ] {
        let found = kinds(&map, edges);
        assert!(found.contains(&cause), "{cause}: {found:?}");
    }
}
