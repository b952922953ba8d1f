//! Every model against tables of 18 to 22 digits. `cargo test -- --nocapture` prints the worst
//! error of each.

use crate::common::{ReferenceRow, Worst, reference_rows};
use crate::pascals;
use contact_types::{
    AmplitudeSpectrum, ContactModel, ContactModulus, FractalParameters, SpectralMoments, Wave,
};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, Persson, PerssonWithYield, PlasticSpots,
    SelfAffineSpectrum, SphereLevel, Stacked,
};
use std::f64::consts::{PI, SQRT_2};

/// E* = 1 Pa: the tables are in units of E*.
fn unit() -> ContactModulus {
    pascals(1.0)
}

#[test]
fn persson_area() {
    // g_rms = 1: m2 = 1/2.
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let model = Persson::from_moments(moments, unit()).unwrap();
    at_loads("Persson area", &model, ("persson_area.csv", "A"));
}

/// Areas at loads `x`, to 1e-15.
fn at_loads(name: &str, model: &impl ContactModel, (table, column): (&str, &str)) {
    let mut worst = Worst::of(name);
    for row in reference_rows(table) {
        let x = row.number("x");
        let area = model.at_pressure(x).expect("an answer").area_fraction;
        worst.compare(area, row.number(column), || format!("x = {x}"));
    }
    worst.at_most(1e-15);
}

/// H = 1: the area, elastic and plastic, to 1e-15, absolutely.
#[test]
fn persson_with_yield() {
    let mut worst = Worst::of("Persson area with yield");
    for row in reference_rows("persson_yield.csv") {
        let [p, ratio, elastic, plastic] =
            row.numbers(["p_over_H", "V_over_H2", "A_elastic", "A_plastic"]);
        let model = PerssonWithYield::new(2.0 * ratio.sqrt(), unit(), 1.0).unwrap();
        let area = model.at_pressure(p).unwrap().area_fraction;
        worst.see((area - (elastic + plastic)).abs(), || format!("p/H = {p}, V/H² = {ratio}"));
        assert!(area >= p * (1.0 - 1e-12));
    }
    worst.at_most(1e-15);
    let model = PerssonWithYield::new(1.0, unit(), 0.5).unwrap();
    assert!(model.at_pressure(0.5).is_err() && model.at_pressure(f64::NAN).is_err());
    assert!(PerssonWithYield::new(1.0, unit(), 0.0).is_err());
    // Hard bodies: Persson's own law.
    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 1.0 };
    let elastic = Persson::from_moments(moments, unit()).unwrap().at_pressure(0.3).unwrap();
    let hard = PerssonWithYield::new(1.0, unit(), 1e3).unwrap().at_pressure(0.3).unwrap();
    assert!((hard.area_fraction - elastic.area_fraction).abs() < 1e-15);
}

#[test]
fn persson_gap() {
    let (mut area, mut gap) = (Worst::of("Persson area of a spectrum"), Worst::of("mean gap"));
    for row in reference_rows("persson_gap.csv") {
        let q = [row.number("qL"), row.number("qr"), row.number("qs")];
        let spectrum =
            SelfAffineSpectrum::from_wavenumbers(row.number("H"), q, row.number("m0")).unwrap();
        let moments = spectrum.moments();
        let place = || format!("H = {}, p/(E* g) = {}", row.text("H"), row.text("p_over_E_grms"));
        area.compare(2.0 * moments.m2, row.number("grad2"), place);
        area.compare(8.0 / 3.0 * moments.m4, row.number("lap2"), place);
        let p = row.number("p_over_E");
        for (gamma, column) in [(1.0, "gap_over_hrms_gamma1"), (0.45, "gap_over_hrms_gamma0.45")] {
            let model = Persson::from_self_affine(spectrum, unit()).with_gamma(gamma).unwrap();
            let state = model.at_pressure(p).unwrap();
            area.compare(state.area_fraction, row.number("area"), place);
            gap.compare(state.mean_gap.unwrap(), row.number(column), place);
        }
    }
    area.at_most(1e-14);
    gap.at_most(5e-14);
}

/// The rows of a model in the table of areas.
fn areas(model: &str, of: impl Fn(&ReferenceRow) -> Box<dyn ContactModel>, limit: f64) {
    let mut worst = Worst::of(model);
    let rows = reference_rows("multiscale_areas.csv");
    for row in rows.iter().filter(|row| row.text("model") == model) {
        let area = of(row).at_pressure(row.number("p")).expect("an answer").area_fraction;
        worst.compare(area, row.number("A"), || format!("p/E* = {}", row.text("p")));
    }
    worst.at_most(limit);
}

#[test]
fn stacked() {
    areas("stacked", |row| Box::new(Stacked::new(row.number("B_max"), unit()).unwrap()), 1e-15);
}

#[test]
fn jackson_streator_recursion() {
    let amplitudes = reference_rows("multiscale_amplitudes.csv");
    let of = |row: &ReferenceRow| -> Box<dyn ContactModel> {
        let waves = amplitudes.iter().filter(|w| w.text("surface") == row.text("surface"));
        let wave = |w: &ReferenceRow| Wave {
            frequency: w.number("k") / w.number("length"),
            amplitude: w.number("amplitude"),
        };
        let spectrum = AmplitudeSpectrum::new(waves.map(wave).collect(), 1.0).unwrap();
        Box::new(JacksonStreator::new(spectrum, unit()))
    };
    areas("multiscale", of, 1e-14);
}

/// Area at a load, without and with a critical area.
#[test]
fn majumdar_bhushan() {
    // The load has the factor 1/(3 - 2D): at D = 1.4999 the rounding of the decimal D to a double
    // (2^-53 at most) is worth 1e-12, and no evaluation can undo it.
    let is_near = |row: &ReferenceRow| row.text("D") == "1.4999";
    let [plain, with_area] = ["majumdar_bhushan.csv", "majumdar_bhushan_critical_area.csv"];
    for (table, column, near, limit) in [
        (plain, "F_over_EAn", false, 1e-14),
        (plain, "F_over_EAn", true, 1e-12),
        (with_area, "Fe_over_EAn", false, 3e-14),
    ] {
        let mut worst = Worst::of(format!("{table}, D = 1.4999: {near}"));
        for row in reference_rows(table).iter().filter(|row| is_near(row) == near) {
            let [dimension, roughness, a, pressure] =
                row.numbers(["D", "G_over_sqrtAn", "Ar_over_An", column]);
            let surface = FractalParameters { dimension, roughness };
            let plastic = if table == with_area {
                PlasticSpots::Below(row.number("ac_over_An"))
            } else {
                PlasticSpots::None
            };
            let model = MajumdarBhushan::new(surface, 1.0, unit(), plastic).unwrap();
            let place = || format!("D = {}, A = {a}", row.text("D"));
            worst.compare(model.at_pressure(pressure).unwrap().area_fraction, a, place);
        }
        worst.at_most(limit);
    }
}

/// One wave is the sinusoid itself; complete contact at 1 Pa.
#[test]
fn published_fit_of_the_sinusoid() {
    let waves = AmplitudeSpectrum::new(vec![Wave { frequency: 1.0, amplitude: 1.0 }], 1.0).unwrap();
    let model = JacksonStreator::new(waves, pascals((SQRT_2 * PI).recip()));
    at_loads("published sinusoid fit", &model, ("sinusoid_fit.csv", "g"));
}

#[test]
fn archard() {
    let mut worst = Worst::of("Archard area");
    for row in reference_rows("archard.csv") {
        let list = |column| -> Vec<f64> {
            row.text(column)
                .split(';')
                .filter(|s| !s.is_empty())
                .map(|s| s.parse().unwrap())
                .collect()
        };
        let densities = std::iter::once(1.0).chain(list("m"));
        // k = pi (3R/(4E*))^(2/3) with E* = 1
        let radius = |k: f64| 4.0 / 3.0 * (k / PI).powf(1.5);
        let level = |(k, density)| SphereLevel { radius: radius(k), density };
        let levels: Vec<_> = list("k").into_iter().zip(densities).map(level).collect();
        let model = Archard::new(&levels, unit()).unwrap();
        let place = || format!("k = {}, m = {}", row.text("k"), row.text("m"));
        // One coarse sphere per square metre: pressure is load, area fraction is area, C that at 1 N.
        for (load, area) in [(1.0, "C"), (row.number("W"), "A")] {
            let found = model.at_pressure(load).unwrap().area_fraction;
            worst.compare(found, row.number(area), place);
        }
    }
    worst.at_most(2e-15);
}
