//! Archard's levels, Jackson and Streator's waves and the fractal distributions of spots.

use crate::quadrature::{geometric_integral, integral};
use crate::{close, pascals};
use contact_types::{AmplitudeSpectrum, ContactModel, FractalParameters, Wave};
use multiscale_models::{
    Archard, JacksonStreator, MajumdarBhushan, PlasticSpots, SphereLevel, YanKomvopoulos,
};
use std::f64::consts::PI;

/// Two levels: the area of the features under the Hertz pressure of the smooth sphere.
#[test]
fn archard_is_the_integral_over_the_hertz_spot() {
    let (k, fine, m, load) = (0.7, 0.3, 50.0, 3.0);
    let spot = k * f64::powf(load, 2.0 / 3.0);
    let peak = 1.5 * load / spot;
    // Over r^2/a^2 = s: area = spot int_0^1 m fine (p(s)/m)^(2/3) ds, p = peak sqrt(1 - s)
    let expected =
        spot * integral(0.0, 1.0, |s| m * fine * (peak * (1.0 - s).sqrt() / m).powf(2.0 / 3.0));
    // k = pi (3R/(4E*))^(2/3) with E* = 1
    let level = |k: f64, density| SphereLevel { radius: 4.0 / 3.0 * (k / PI).powf(1.5), density };
    let model = Archard::new(&[level(k, 1.0), level(fine, m)], pascals(1.0)).unwrap();
    close(model.at_pressure(load).unwrap().area_fraction, expected, 1e-12);
}

/// A short wave of no amplitude changes nothing; a steep one takes over.
#[test]
fn short_waves_count_by_their_slope() {
    let area = |short: &[f64]| {
        let short = short.iter().map(|&amplitude| Wave { frequency: 1e6, amplitude });
        let waves = std::iter::once(Wave { frequency: 1e4, amplitude: 1e-7 }).chain(short);
        let spectrum = AmplitudeSpectrum::new(waves.collect(), 1e-3).unwrap();
        JacksonStreator::new(spectrum, pascals(1e9)).at_pressure(1e5).unwrap().area_fraction
    };
    close(area(&[0.0]), area(&[]), 1e-15);
    close(area(&[1e-14]), area(&[]), 1e-15);
    assert!(area(&[1e-7]) < 0.1 * area(&[]));
}

#[test]
fn fractal_loads_are_the_integrals_over_the_spots() {
    let e = 2e10;
    for d in [1.1, 1.49999, 1.5, 1.5 + 1e-12, 1.9] {
        let (g, area, critical) = (1e-9, 1e-4, 1e-13);
        let surface = FractalParameters { dimension: d, roughness: g };
        let plastic = PlasticSpots::Below(critical);
        let model = MajumdarBhushan::new(surface, area, pascals(e), plastic).unwrap();
        let fraction = 0.02;
        let largest = (2.0 - d) / d * fraction * area;
        let number = |a: f64| 0.5 * d * largest.powf(0.5 * d) * a.powf(-0.5 * d - 1.0);
        let load = |a: f64| 4.0 * PI.sqrt() / 3.0 * e * g.powf(d - 1.0) * a.powf((3.0 - d) / 2.0);
        let expected = geometric_integral(critical, largest, 8.0, |a| number(a) * load(a)) / area;
        let found = model.at_pressure(expected).unwrap().area_fraction;
        close(found, fraction, 1e-12);
    }
    for d in [2.1, 2.5, 2.5 - 1e-12, 2.8] {
        let (g, area, critical) = (1e-9, 1e-4, 1e-13);
        let plastic = PlasticSpots::Below(critical);
        let model = YanKomvopoulos::new(d, g, area, pascals(e), plastic).unwrap();
        let largest: f64 = 1e-8;
        let s = 0.5 * (d - 1.0);
        let number = |a: f64| s * largest.powf(s) * a.powf(-s - 1.0);
        let load = |a: f64| {
            ((11.0 - 2.0 * d) / 2.0).exp2() / (3.0 * PI.powf((4.0 - d) / 2.0))
                * 1.5_f64.ln().sqrt()
                * g.powf(d - 2.0)
                * e
                * a.powf((4.0 - d) / 2.0)
        };
        let expected = geometric_integral(critical, largest, 8.0, |a| number(a) * load(a)) / area;
        // Real area: half of each elastic spot, all of each plastic one.
        let elastic = geometric_integral(critical, largest, 8.0, |a| 0.5 * number(a) * a);
        let plastic = s / (1.0 - s) * largest.powf(s) * critical.powf(1.0 - s);
        let state = model.at_pressure(expected).unwrap();
        close(state.area_fraction, (elastic + plastic) / area, 1e-12);
    }
}

#[test]
fn hardness_makes_small_spots_plastic() {
    let (e, hardness) = (2e10, 4e8);
    let surface = FractalParameters { dimension: 1.4, roughness: 1e-9 };
    let plastic = PlasticSpots::OfHardness(hardness);
    let hard = MajumdarBhushan::new(surface, 1e-4, pascals(e), plastic).unwrap();
    // At a_c the deformation G^(D-1) a^(1-D/2) is (pi H/2E*)^2 times the radius a^(D/2)/(pi^2 G^(D-1)).
    let critical = 1e-9_f64.powi(2) * (2.0 * e / hardness).powf(2.0 / 0.4);
    let g = 1e-9_f64.powf(0.4);
    let radius = critical.powf(0.7) / (PI * PI * g);
    close(g * critical.powf(0.3), (PI * hardness / (2.0 * e)).powi(2) * radius, 1e-13);
    // While all spots are plastic the real pressure is the hardness.
    let all_plastic = hardness * 1.4 / 0.6 * critical / 1e-4;
    let real_pressure = |p: f64| hard.at_pressure(p).unwrap().real_pressure().unwrap();
    close(real_pressure(0.999 * all_plastic), hardness, 1e-14);
    // A spot that is just elastic carries 2 sqrt(pi)/3 of that.
    assert!(real_pressure(1.01 * all_plastic) > hardness * (1.0 + 1e-4));
    // Above, elastic and plastic loads add up.
    let fraction = 0.01;
    let largest: f64 = 0.6 / 1.4 * fraction * 1e-4;
    let coefficient = 4.0 * PI.sqrt() / 3.0 * e * g;
    let bracket = (largest.powf(0.1) - critical.powf(0.1)) / 0.1;
    let elastic = coefficient * 0.7 * largest.powf(0.7) * bracket / 1e-4;
    let plastic = hardness * 1.4 / 0.6 * largest.powf(0.7) * critical.powf(0.3) / 1e-4;
    let area = hard.at_pressure(elastic + plastic).unwrap().area_fraction;
    close(area, fraction, 1e-13);
}
