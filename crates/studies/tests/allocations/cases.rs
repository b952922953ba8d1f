//! What representative calls of every crate allocate; shared by the test and by
//! `examples/costs.rs`, which prints the table.

use allocation_counter::{AllocationInfo, measure};
use asperity_models::{SummitLaw, SummitModel};
use contact_compare::{Comparison, Settings, Surface, built_in, built_in_recipes};
use contact_types::{
    ContactModel, ContactModulus, FractalParameters, Grid, HeightMap, SeparationModel,
    SpectralMoments,
};
use fft_bem_solver::{Load, Maps, Solver};
use grid_fft::GridFft;
use gw_closed_form::GreenwoodWilliamson;
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, PlasticSpots, SelfAffineSpectrum,
    SphereLevel, Stacked,
};
use std::hint::black_box;
use std::io::Cursor;
use std::ops::ControlFlow;
use surface_io::{Fill, HeightUnit, ReadOptions};
use surface_stats::spectrum::{amplitudes, radial};
use surface_stats::{Edges, StatsOptions, SurfaceStatistics, moments, spectral_scales};

/// One call and what it took from the allocator, on one thread.
pub(crate) struct Case {
    pub(crate) package: &'static str,
    pub(crate) call: &'static str,
    /// Bytes of the map of heights the call works on, and how many maps it may hold at once beyond what was there before;
    /// `None` for a call without a map. Small tables and plans of transforms are the decimals.
    pub(crate) map: Option<(usize, f64)>,
    pub(crate) found: AllocationInfo,
}

impl Case {
    fn of(package: &'static str, call: &'static str, work: impl FnOnce()) -> Self {
        Self { package, call, map: None, found: measure(work) }
    }

    fn on(
        package: &'static str,
        call: &'static str,
        (map, most): (&HeightMap, f64),
        work: impl FnOnce(),
    ) -> Self {
        let map = Some((8 * map.heights().len(), most));
        Self { package, call, map, found: measure(work) }
    }

    /// Peak in arrays of the size of the map: what is held at once beyond what was there.
    pub(crate) fn arrays(&self) -> Option<f64> {
        self.map.map(|(bytes, _)| self.found.bytes_max as f64 / bytes as f64)
    }
}

/// Every case, with maps of about `side` x `side` points. All on the calling thread: inside a
/// pool of one thread, because the counter is one per thread.
pub(crate) fn all(side: usize) -> Vec<Case> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("one thread");
    pool.install(|| {
        let mut cases = closed_forms();
        cases.extend(on_a_map(&map(side)));
        cases.extend(studies());
        cases
    })
}

fn steel() -> ContactModulus {
    ContactModulus::from_pascals(115e9).expect("a modulus")
}

/// Waves of eight points and longer: what a well-sampled surface looks like.
fn map(side: usize) -> HeightMap {
    use surface_stats::synthesis::{Scale, SelfAffine};
    let recipe = SelfAffine {
        grid: Grid::new([side, side], [1e-6, 1e-6]).expect("a grid"),
        hurst: 0.8,
        rolloff: side as f64 / 8.0 * 1e-6,
        cutoff: 8e-6,
        scale: Scale::RmsGradient(0.1),
        seed: 1,
        quantise: None,
    };
    recipe.generate().expect("a surface")
}

fn at_pressure(package: &'static str, call: &'static str, model: &dyn ContactModel) -> Case {
    Case::of(package, call, || {
        black_box(model.at_pressure(black_box(5e7)).expect("an answer"));
    })
}

fn at_separation(package: &'static str, call: &'static str, model: &dyn SeparationModel) -> Case {
    Case::of(package, call, || {
        black_box(model.at_separation(black_box(2e-7)).expect("an answer"));
    })
}

fn closed_forms() -> Vec<Case> {
    let moments = SpectralMoments { m0: 1e-14, m2: 1e-3, m4: 1e9 };
    let spectrum = SelfAffineSpectrum::from_wavelengths(0.8, 1e-4, 1e-6, 1e-14).expect("in range");
    let waves = spectrum.profile_amplitudes(1e-3).expect("in range");
    let fractal = FractalParameters { dimension: 1.3, roughness: 1e-10 };
    let spheres = [1e-3, 1e-4, 1e-5].map(|r| SphereLevel { radius: r, density: 0.1 / (r * r) });
    let expected = "inputs inside the domain";

    let gw = GreenwoodWilliamson::from_moments(moments, steel()).expect(expected);
    let bgt = SummitModel::new(SummitLaw::BushGibsonThomas, moments, steel()).expect(expected);
    let elliptical =
        SummitModel::new(SummitLaw::GreenwoodElliptical, moments, steel()).expect(expected);
    let persson = Persson::from_moments(moments, steel()).expect(expected);
    let with_gap = Persson::from_self_affine(spectrum, steel());
    let stacked = Stacked::new(waves.max_amplitude_ratio(), steel()).expect(expected);
    let multiscale = JacksonStreator::new(waves, steel());
    let archard = Archard::new(&spheres, steel()).expect(expected);
    let bhushan = MajumdarBhushan::new(fractal, 1e-6, steel(), PlasticSpots::None).expect(expected);
    let (asperity, multi) = ("asperity-models", "multiscale-models");
    vec![
        Case::of("gw-closed-form", "GW from moments", || {
            black_box(GreenwoodWilliamson::from_moments(black_box(moments), steel()).ok());
        }),
        at_pressure("gw-closed-form", "GW at a pressure", &gw),
        at_separation("gw-closed-form", "GW at a separation", &gw),
        at_pressure(asperity, "BGT at a pressure", &bgt),
        at_separation(asperity, "BGT at a separation", &bgt),
        at_pressure(asperity, "elliptical at a pressure", &elliptical),
        at_pressure(multi, "Persson at a pressure", &persson),
        at_pressure(multi, "Persson with mean gap at a pressure", &with_gap),
        at_pressure(multi, "stacked at a pressure", &stacked),
        at_pressure(multi, "Jackson–Streator at a pressure", &multiscale),
        at_pressure(multi, "Archard at a pressure", &archard),
        at_pressure(multi, "Majumdar–Bhushan at a pressure", &bhushan),
    ]
}

fn on_a_map(map: &HeightMap) -> Vec<Case> {
    let mut cases = vec![transforms(map)];
    cases.extend(files(map));
    cases.extend(statistics(map));
    cases.extend(solves(map));
    cases
}

fn transforms(map: &HeightMap) -> Case {
    let mut fft = GridFft::new(map.grid().shape());
    let (mut spectrum, mut field) = (fft.new_spectrum(), vec![0.0; map.heights().len()]);
    Case::on("grid-fft", "transform and back, planned", (map, 0.0), || {
        fft.forward(map.heights(), &mut spectrum);
        fft.inverse(&mut spectrum, &mut field);
    })
}

fn files(map: &HeightMap) -> [Case; 2] {
    let (mut npy, mut x3p) = (Vec::new(), Cursor::new(Vec::new()));
    surface_io::write::npy(&mut npy, map.grid().shape(), map.heights())
        .expect("memory takes everything");
    surface_io::write::x3p(&mut x3p, map, "").expect("memory takes everything");
    let height_unit = Some(HeightUnit::IfSilent(1.0));
    let options =
        ReadOptions { pixel: Some(map.grid().pixel()), height_unit, ..ReadOptions::default() };
    let read = |bytes: &[u8], options: &ReadOptions| {
        let measurement = surface_io::read_bytes(bytes, options).expect("what was written");
        black_box(measurement.fill(Fill::Refuse).expect("nothing is missing"));
    };
    [
        Case::on("surface-io", "read NPY", (map, 1.1), || read(&npy, &options)),
        Case::on("surface-io", "read X3P", (map, 2.1), || {
            read(x3p.get_ref(), &ReadOptions::default());
        }),
    ]
}

fn statistics(map: &HeightMap) -> Vec<Case> {
    let package = "surface-stats";
    let all = |edges| {
        let options = StatsOptions { edges, ..StatsOptions::default() };
        black_box(SurfaceStatistics::of(map, &options).expect("a surface"));
    };
    vec![
        Case::on(package, "m2 and m4 (for GW, BGT, elliptical)", (map, 0.01), || {
            black_box(moments(map, Edges::Open).expect("a surface"));
        }),
        Case::on(package, "radial spectrum (for Persson)", (map, 1.2), || {
            black_box(radial(map).expect("a surface"));
        }),
        Case::on(package, "amplitudes of rows (for stacked)", (map, 0.1), || {
            black_box(amplitudes(map).expect("a surface"));
        }),
        Case::on(package, "scales and power law (for Majumdar–Bhushan)", (map, 1.2), || {
            black_box(spectral_scales(map, Edges::Open).expect("a surface"));
        }),
        Case::on(package, "all statistics, periodic", (map, 2.2), || all(Edges::Periodic)),
        Case::on(package, "all statistics, open", (map, 2.2), || all(Edges::Open)),
    ]
}

fn solves(map: &HeightMap) -> Vec<Case> {
    let package = "fft-bem-solver";
    let load = Load::MeanPressure(0.01 * 115e9 * 0.1);
    let with =
        |maps| Solver::builder().maps(maps).build(map.grid(), steel()).expect("good settings");
    let heavier = Load::MeanPressure(0.02 * 115e9 * 0.1);
    let mut warm = [Maps::None, Maps::PressureAndGap].map(with);
    for solver in &mut warm {
        black_box(solver.solve(map, load).expect("converges"));
    }
    let [bare, full] = &mut warm;
    vec![
        Case::on(package, "build and solve one load", (map, 11.0), || {
            black_box(with(Maps::None).solve(map, load).expect("converges"));
        }),
        Case::on(package, "build and solve one load, with maps", (map, 13.0), || {
            black_box(with(Maps::PressureAndGap).solve(map, load).expect("converges"));
        }),
        Case::on(package, "one more load", (map, 0.1), || {
            black_box(bare.solve(map, heavier).expect("converges"));
        }),
        Case::on(package, "one more load, with maps", (map, 2.1), || {
            black_box(full.solve(map, heavier).expect("converges"));
        }),
    ]
}

/// The study of a built-in surface on few points at three loads, with the solvers of all rungs, which work on the same
/// thread: the lightest load is solved on twice the points, which are four times the map.
fn studies() -> Vec<Case> {
    let mut recipe = built_in_recipes().remove(1);
    recipe.shape = [128, 128];
    let surface = recipe.make().expect("a surface");
    let map = surface.heights.clone();
    let run =
        |surface: Surface| {
            let settings = Settings { pressures: Some(vec![1e7, 1e8, 1e9]), ..Settings::default() };
            let study = Comparison::run(vec![surface], settings, built_in(), &mut |_| {
                ControlFlow::Continue(())
            });
            black_box(study.expect("a study"));
        };
    let call = "study of 128 × 128 points at three loads, with its solvers";
    vec![Case::on("compare", call, (&map, 63.6), || run(surface.clone()))]
}
