//! The fitted equation: limits, monotony, its definition at 60 digits.

use crate::common::reference_rows;
use crate::pascals;
use multiscale_models::{ContactModel, Equation, ModelError, SpectralMoments};
use std::f64::consts::PI;

/// Gradient 1 and this bandwidth: with a modulus of 1 Pa, pressures are loads p/(E* g).
fn moments(bandwidth: f64) -> SpectralMoments {
    SpectralMoments { m0: 1.0, m2: 0.5, m4: 0.25 * bandwidth }
}

fn law(bandwidth: f64) -> Equation {
    Equation::from_moments(moments(bandwidth), pascals(1.0)).expect("a law")
}

/// Loads over ten decades.
fn loads() -> impl Iterator<Item = f64> {
    (0..600).map(|k| 10f64.powf(-9.0 + f64::from(k) / 60.0))
}

#[test]
fn area_rises_strictly() {
    for bandwidth in [1.5, 5.0, 30.0, 1000.0] {
        let law = law(bandwidth);
        let mut before = 0.0;
        for x in loads() {
            let area = law.at_pressure(x).unwrap().area_fraction;
            assert!(area > before || before > 1.0 - 1e-13, "{x}: {area} after {before}");
            assert!(area <= 1.0);
            before = area;
        }
    }
}

#[test]
fn limits_are_right() {
    let law = law(10.0);
    let area = |x: f64| law.at_pressure(x).unwrap().area_fraction;
    assert!(area(0.0) <= 0.0);
    // In proportion under light load, by a constant between Persson's and the summit theories'; it comes to it as
    // the root of the load.
    let slope = area(1e-14) / 1e-14;
    assert!((area(1e-15) / 1e-15 / slope - 1.0).abs() < 1e-6);
    assert!(((8.0 / PI).sqrt()..(2.0 * PI).sqrt()).contains(&slope), "{slope}");
    assert!((area(20.0) - 1.0).abs() < 1e-15);
    assert!(matches!(law.at_pressure(-1.0), Err(ModelError::InvalidInput { .. })));
    assert!(matches!(law.at_pressure(f64::NAN), Err(ModelError::InvalidInput { .. })));
    assert!(Equation::from_moments(moments(0.0), pascals(1.0)).is_err());
}

/// Its five numbers, typed into the formula, give the area; it is cited as this program's.
#[test]
fn the_printed_formula_is_the_law() {
    let law = law(10.0);
    let line = law.formula().unwrap().replace("− ", "-").replace('−', "-");
    let w = line.split("w = ").nth(1).unwrap().split(',').next().unwrap();
    let numbers: Vec<f64> = w
        .split(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
        .filter_map(|t| t.parse().ok())
        .collect();
    let [c0, c1, c2, c3, c4] = numbers[..] else { panic!("{line}") };
    for x in [1e-3, 0.03, 0.4] {
        let t = libm::erf(2f64.sqrt() * x);
        let w = c0 + c1 * t.sqrt() + c2 * t * t + (c3 + c4 * t) * 10f64.ln();
        let area = libm::erf(2f64.sqrt() * x * w.exp());
        assert!((law.at_pressure(x).unwrap().area_fraction / area - 1.0).abs() < 1e-12, "{line}");
    }
    let citation = law.citation();
    assert!(citation.doi.is_empty() && citation.authors.contains("rough-contact"));
}

/// Beyond what it was fitted on it says so.
#[test]
fn a_caveat_outside_the_range() {
    let caveat = |bandwidth: f64, x: f64| {
        let law = law(bandwidth);
        law.at_pressure(x).unwrap().caveat
    };
    // The gradient of these moments is 1: not steep.
    assert!(caveat(10.0, 0.1).is_none());
    for (bandwidth, x) in [(1.2, 0.1), (400.0, 0.1), (10.0, 1e-5), (10.0, 1.6)] {
        assert!(caveat(bandwidth, x).is_some(), "{bandwidth} {x}");
    }
}

/// The law against its definition at 60 digits.
#[test]
fn evaluation_is_exact_to_rounding() {
    let mut worst = 0.0f64;
    for row in reference_rows("equation.csv") {
        let [x, bandwidth, wanted] = row.numbers(["x", "alpha", "area"]);
        let law = law(bandwidth);
        let error = (law.at_pressure(x).expect("an area").area_fraction / wanted - 1.0).abs();
        assert!(error <= 1e-14, "x = {x}, α = {bandwidth}: {error:e}");
        worst = worst.max(error);
    }
    assert!(worst > 0.0); // to every digit would be the definition asked of itself
}
