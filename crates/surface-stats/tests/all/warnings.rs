//! Every warning comes when its cause is there, and a sound surface has none.
use contact_types::{Grid, HeightMap};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, Level, StatsOptions, SurfaceStatistics, Warning};

const UM: f64 = 1e-6;

fn recipe() -> SelfAffine {
    SelfAffine {
        grid: Grid::new([384, 384], [UM, UM]).unwrap(),
        hurst: 0.7,
        rolloff: 40.0 * UM,
        cutoff: 6.0 * UM,
        scale: Scale::RmsHeight(0.3 * UM),
        seed: 2,
        quantise: None,
    }
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
    let Warning::Stepped { step, m4_share, .. } = found[0] else { panic!("{found:?}") };
    assert!((step / 50e-9 - 1.0).abs() < 1e-9 && m4_share > 0.25);
    assert!(matches!(found[1], Warning::FlatTops { .. }), "{found:?}");
}

/// Noise of 20 nm under waves that end at 6 um: level, and where the reliable band ends.
#[test]
fn noise_is_named_with_its_level_and_where_it_begins() {
    let noise = SelfAffine {
        rolloff: 2.0 * UM,
        cutoff: 2.0 * UM,
        scale: Scale::RmsHeight(20e-9),
        seed: 9,
        ..recipe()
    };
    let clean = recipe().generate().unwrap();
    let noise = noise.generate().unwrap();
    let heights = clean.heights().iter().zip(noise.heights()).map(|(a, b)| a + b).collect();
    let noisy = HeightMap::new(clean.grid(), heights).unwrap();
    for edges in [Edges::Open, Edges::Periodic] {
        let found = warnings(&noisy, edges);
        let Some(Warning::Noisy { rms, reliable, .. }) =
            found.iter().find(|w| w.kind() == "noisy").copied()
        else {
            panic!("{found:?}")
        };
        // The recipe fills the circle of the wavenumber plane only: white noise of 20 nm √(4/π).
        assert!((rms / 22.57e-9 - 1.0).abs() < 0.03, "{rms:e}");
        assert!((reliable.unwrap() / (6.0 * UM) - 1.0).abs() < 0.06, "{reliable:?}");
    }
    let alone = warnings(&noise, Edges::Periodic);
    let nothing = |w: &Warning| matches!(w, Warning::Noisy { reliable: None, .. });
    assert!(alone.iter().any(nothing), "{alone:?}");
}

#[test]
fn every_cause_is_named() {
    let made = |recipe: SelfAffine| recipe.generate().unwrap();
    let map = made(recipe());
    let stretched = Grid::new([384, 384], [2.0 * UM, UM]).unwrap();
    let stretched = HeightMap::new(stretched, map.heights().to_vec()).unwrap();
    // Oblique lay has equal slopes along both axes: only the tensor sees it.
    let oblique = changed(&map, |h, y, x| h + 0.6 * UM * (0.5 * (x + y) / UM).sin());
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
