//! Identities of the theories, each against quadrature done here and not by the crate.

use approx::assert_relative_eq;
use contact_types::{
    AmplitudeSpectrum, ContactModel, ContactModulus, FractalParameters, RoughnessSpectrum, Shell,
    SpectralMoments, Wave,
};
use multiscale_models::special::{erf, erf_inv, erfc, erfc_inv, half_e1_of_square};
use multiscale_models::{
    Archard, AreaLaw, JacksonStreator, MajumdarBhushan, Persson, SelfAffineSpectrum, SinusoidLaw,
    YanKomvopoulos,
};
use std::f64::consts::PI;

fn pascals(e: f64) -> ContactModulus {
    ContactModulus::from_pascals(e).expect("a modulus")
}

/// Double-exponential quadrature of a smooth function over [a, b]: `x = m + h tanh(pi/2 sinh t)`.
fn integral(a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (half, step) = (0.5 * (b - a), 1.0 / 32.0);
    (-130..=130)
        .map(|i| {
            let t = f64::from(i) * step;
            let u = 0.5 * PI * t.sinh();
            let weight = 0.5 * PI * t.cosh() / u.cosh().powi(2);
            // Distance to the nearer end without cancellation: half (1 - tanh u)
            let near = half * (-u.abs()).exp() / u.abs().cosh();
            let x = if u < 0.0 { a + near } else { b - near };
            if weight > 1e-300 { step * weight * f(x) } else { 0.0 }
        })
        .sum::<f64>()
        * half
}

/// The same over panels that rise by a factor.
fn geometric_integral(a: f64, b: f64, factor: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut sum, mut lo) = (0.0, a);
    while lo < b {
        let hi = (lo * factor).min(b);
        sum += integral(lo, hi, &f);
        lo = hi;
    }
    sum
}

/// A self-affine spectrum written out as in the definition.
struct Definition {
    hurst: f64,
    q: [f64; 3],
    c0: f64,
}

impl Definition {
    fn new(hurst: f64, q: [f64; 3], m0: f64) -> Self {
        let mut definition = Self { hurst, q, c0: 1.0 };
        definition.c0 = m0 / (2.0 * PI * definition.moment(1, q[2]));
        definition
    }

    fn psd(&self, q: f64) -> f64 {
        let [lower, rolloff, cutoff] = self.q;
        if q < lower || q > cutoff {
            0.0
        } else if q <= rolloff {
            self.c0
        } else {
            self.c0 * (q / rolloff).powf(-2.0 - 2.0 * self.hurst)
        }
    }

    /// `int q^n C dq` up to `q`, by quadrature on both sides of the kink.
    fn moment(&self, n: i32, q: f64) -> f64 {
        let f = |k: f64| k.powi(n) * self.psd(k);
        let [lower, rolloff, _] = self.q;
        geometric_integral(lower, q.min(rolloff), 4.0, f)
            + if q > rolloff { geometric_integral(rolloff, q, 4.0, f) } else { 0.0 }
    }

    /// The mean gap as printed, `sqrt(pi) int q^2 C w I(w p/E*) dq`, with I by its series and
    /// asymptotics replaced by plain quadrature.
    fn mean_gap(&self, p_over_e: f64, gamma: f64) -> f64 {
        let f = |q: f64| {
            let w = (PI * self.moment(3, q)).powf(-0.5);
            let x = w * p_over_e;
            if x > 9.0 {
                return 0.0;
            }
            let kernel =
                |y: f64| (gamma + 3.0 * (1.0 - gamma) * erf(y).powi(2)) * (-y * y).exp() / y;
            q * q * self.psd(q) * w * geometric_integral(x, x + 9.0, 4.0, kernel)
        };
        let [lower, rolloff, cutoff] = self.q;
        let mut sum = geometric_integral(rolloff, cutoff, 3.0, f);
        if rolloff > lower {
            sum += geometric_integral(lower, rolloff, 3.0, f);
        }
        PI.sqrt() * sum
    }
}

/// The four kinds of spectrum: with plateau, without, H = 1 (logarithm in m2), H = 0 (in m0).
const SPECTRA: [(f64, [f64; 3]); 4] = [
    (0.8, [1.0, 4.0, 90.0]),
    (0.3, [2.0, 2.0, 50.0]),
    (1.0, [1.0, 1.0, 30.0]),
    (0.0, [1.0, 1.5, 8.0]),
];

#[test]
fn moments_of_the_self_affine_spectrum() {
    for (hurst, q) in SPECTRA {
        let definition = Definition::new(hurst, q, 2.5);
        let moments = SelfAffineSpectrum::from_wavenumbers(hurst, q, 2.5).unwrap().moments();
        assert_relative_eq!(moments.m0, 2.5, max_relative = 1e-15);
        assert_relative_eq!(moments.m2, PI * definition.moment(3, q[2]), max_relative = 1e-13);
        assert_relative_eq!(
            moments.m4,
            0.75 * PI * definition.moment(5, q[2]),
            max_relative = 1e-13
        );
    }
}

#[test]
fn mean_gap_is_the_printed_integral() {
    for (hurst, q) in SPECTRA {
        let definition = Definition::new(hurst, q, 1.0);
        let spectrum = SelfAffineSpectrum::from_wavenumbers(hurst, q, 1.0).unwrap();
        let slope = spectrum.moments().m2.sqrt();
        for gamma in [1.0, 0.45] {
            let model = Persson::from_self_affine(spectrum, pascals(1.0))
                .unwrap()
                .with_gamma(gamma)
                .unwrap();
            for x in [0.01, 0.3, 1.7] {
                let expected = definition.mean_gap(x * slope, gamma);
                assert_relative_eq!(
                    model.mean_gap(x * slope).unwrap(),
                    expected,
                    max_relative = 1e-11
                );
            }
        }
    }
}

/// On a shell q is constant, and for gamma = 1 the integrals over it are elementary:
/// `int_0^r E1(P^2/s^2)/2 ds = r [E1(x^2)/2 - e^{-x^2} + x sqrt(pi) erfc x]`, x = P/r, and so on.
#[test]
fn shells_have_their_closed_forms() {
    let shells: Vec<_> = (1..40)
        .map(f64::from)
        .map(|i| Shell {
            wavenumber: 1e4 * i,
            variance: 1e-14 * (0.5 + (7.0 * i).sin().powi(2)) / i,
        })
        .collect();
    let e = 3e9;
    let spectrum = RoughnessSpectrum::new(shells.clone()).unwrap();
    let model = Persson::from_spectrum(&spectrum, pascals(e)).unwrap();
    for load in [1e-8, 1e-3, 0.1, 0.9] {
        let x_all = load * spectrum.moments().m2.sqrt();
        let x = |r: f64| x_all / r;
        let gap = |r: f64| {
            let x = x(r);
            r * (half_e1_of_square(x) - (-x * x).exp() + x * PI.sqrt() * erfc(x))
        };
        let slope = |r: f64| r * ((-x(r) * x(r)).exp() - x(r) * PI.sqrt() * erfc(x(r)));
        let energy = |r: f64| 0.5 * r * r * erf(x(r)) + x_all / PI.sqrt() * slope(r);
        let sum = |f: &dyn Fn(f64) -> f64| {
            let (mut m2, mut below, mut sum) = (0.0, 0.0, 0.0);
            for shell in &shells {
                m2 += 0.5 * shell.variance * shell.wavenumber.powi(2);
                let above = f(m2.sqrt());
                sum += (above - below) / shell.wavenumber;
                below = above;
            }
            sum
        };
        let p = x_all * e;
        let two = 2.0 / PI.sqrt();
        assert_relative_eq!(model.mean_gap(p).unwrap(), two * sum(&gap), max_relative = 1e-12);
        assert_relative_eq!(
            model.stiffness(p).unwrap(),
            p / (two * sum(&slope)),
            max_relative = 1e-12
        );
        assert_relative_eq!(
            model.elastic_energy(p).unwrap(),
            e * sum(&energy),
            max_relative = 1e-12
        );
    }
}

/// Shells thin enough to stand for a continuous spectrum: the error falls with their square.
#[test]
fn shells_converge_to_the_continuous_spectrum() {
    let q = [1.0, 3.0, 40.0];
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.7, q, 1.0).unwrap();
    let definition = Definition::new(0.7, q, 1.0);
    let p = 0.1 * spectrum.moments().m2.sqrt();
    let exact = Persson::from_self_affine(spectrum, pascals(1.0)).unwrap().mean_gap(p).unwrap();
    let error = |n: i32| {
        let edge = |i: i32| (f64::from(i) / f64::from(n) * (40.0_f64).ln()).exp();
        let shells = (0..n)
            .map(|i| {
                let (lo, hi) = (edge(i), edge(i + 1));
                // Variance and slope of the shell both right: its wavenumber is their ratio.
                let part = |m| 2.0 * PI * (definition.moment(m, hi) - definition.moment(m, lo));
                Shell { variance: part(1), wavenumber: (part(3) / part(1)).sqrt() }
            })
            .collect();
        let shells = RoughnessSpectrum::new(shells).unwrap();
        let gap = Persson::from_spectrum(shells, pascals(1.0)).unwrap().mean_gap(p).unwrap();
        (gap / exact - 1.0).abs()
    };
    let (coarse, fine) = (error(40), error(80));
    assert!(fine < 1e-3, "{fine:.1e}");
    assert!((coarse / fine).log2() > 1.5, "order {:.2}", (coarse / fine).log2());
}

#[test]
fn energy_balances_the_work_of_the_load() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1e4, 3e4, 1e6], 1e-13).unwrap();
    let e = 7e10;
    let scale = e * spectrum.moments().m2.sqrt();
    for gamma in [1.0, 0.45] {
        let model =
            Persson::from_self_affine(spectrum, pascals(e)).unwrap().with_gamma(gamma).unwrap();
        for x in [0.05, 0.6, 2.5] {
            let p = x * scale;
            // int_0^p u dp' with dp' = p' d ln p'; u grows only as ln(1/p).
            let work = geometric_integral(1e-17 * p, p, 4.0, |p| model.mean_gap(p).unwrap());
            let stored = model.elastic_energy(p).unwrap() + p * model.mean_gap(p).unwrap();
            assert_relative_eq!(work, stored, max_relative = 1e-13);
        }
    }
}

#[test]
fn energy_of_full_contact() {
    // E*/4 int |q| C d^2q = (pi E*/2) int q^2 C dq
    let q = [1e4, 3e4, 1e6];
    let definition = Definition::new(0.8, q, 1e-13);
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, q, 1e-13).unwrap();
    let model = Persson::from_self_affine(spectrum, pascals(7e10)).unwrap();
    let full = model.elastic_energy(1e3 * 7e10).unwrap();
    let expected = 0.5 * PI * 7e10 * definition.moment(2, q[2]);
    assert_relative_eq!(full, expected, max_relative = 1e-13);
}

#[test]
fn stiffness_is_the_slope_of_the_gap() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.6, [1.0, 2.0, 200.0], 1.0).unwrap();
    let scale = spectrum.moments().m2.sqrt();
    for gamma in [1.0, 0.45] {
        let model =
            Persson::from_self_affine(spectrum, pascals(1.0)).unwrap().with_gamma(gamma).unwrap();
        for x in [1e-6, 0.02, 0.5, 2.0] {
            let p = x * scale;
            // Five-point difference in ln p: error of order h^4, rounding eps/h.
            let gap = |d: f64| model.mean_gap(p * d.exp()).unwrap();
            let h = 1e-3 / (1.0 + x * x);
            let slope = (gap(-2.0 * h) - 8.0 * gap(-h) + 8.0 * gap(h) - gap(2.0 * h)) / (12.0 * h);
            assert_relative_eq!(model.stiffness(p).unwrap(), -p / slope, max_relative = 2e-10);
        }
    }
}

#[test]
fn light_load_constants_are_the_limit() {
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, [1.0, 1.0, 100.0], 1.0).unwrap();
    for gamma in [1.0, 0.45] {
        let model =
            Persson::from_self_affine(spectrum, pascals(3.0)).unwrap().with_gamma(gamma).unwrap();
        let [u0, b] = model.light_load().unwrap();
        for p in [1e-12, 1e-100, 1e-306] {
            let limit = u0 * ((3.0 * b).ln() - f64::ln(p));
            assert_relative_eq!(model.mean_gap(p).unwrap(), limit, max_relative = 1e-12);
            assert_relative_eq!(model.stiffness(p).unwrap(), p / u0, max_relative = 1e-11);
        }
    }
    // u0 = sqrt(pi) int q^2 C w dq, a number found independently: MODELS table of the theory.
    let model = Persson::from_self_affine(spectrum, pascals(1.0)).unwrap();
    assert_relative_eq!(model.light_load().unwrap()[0], 1.05357529, max_relative = 1e-8);
}

#[test]
fn pressure_distribution_has_its_moments() {
    let (e, m2) = (5e9, 0.013);
    let model =
        Persson::from_moments(SpectralMoments { m0: 1.0, m2, m4: 1.0 }, pascals(e)).unwrap();
    let deviation = e * f64::sqrt(m2 / 2.0);
    for x in [1e-6, 0.1, 1.0, 4.0] {
        let p = x * deviation;
        let distribution = model.pressure_distribution(p).unwrap();
        let moment = |n: i32| {
            let top = p + 12.0 * deviation;
            integral(0.0, top, |s| (s / p).powi(n) * distribution.density(s))
        };
        let area = model.at_pressure(p).unwrap().area_fraction;
        assert_relative_eq!(moment(0), area, max_relative = 1e-13);
        assert_relative_eq!(moment(1), 1.0, max_relative = 1e-13);
        let mean_square = distribution.mean_square().unwrap() / (p * p);
        assert_relative_eq!(moment(2), mean_square, max_relative = 1e-13);
        assert_relative_eq!(distribution.open_fraction(), 1.0 - area, epsilon = 1e-15);
    }
}

#[test]
fn light_load_slope_of_the_area() {
    // A E* g_rms / p -> sqrt(8/pi); with the reduced diffusion sqrt(8/(pi gamma)).
    let moments = SpectralMoments { m0: 1.0, m2: 0.02, m4: 1.0 };
    let model = Persson::from_moments(moments, pascals(1e9)).unwrap();
    let slope = |model: &Persson| {
        let state = model.at_pressure(1.0).unwrap();
        state.area_fraction * 1e9 * moments.rms_gradient() / 1.0
    };
    assert_relative_eq!(slope(&model), (8.0 / PI).sqrt(), max_relative = 1e-14);
    let reduced = model.with_gamma(0.45).unwrap().with_area_law(AreaLaw::ReducedDiffusion);
    assert_relative_eq!(slope(&reduced), (8.0 / (0.45 * PI)).sqrt(), max_relative = 1e-6);
}

/// The reduced diffusion as the differential equation it is, integrated from the full-contact
/// end, where `V_eff = V`, with Runge's fourth-order rule in ln V.
#[test]
fn reduced_diffusion_solves_its_equation() {
    let gamma = 0.45;
    let model = Persson::from_moments(SpectralMoments { m0: 1.0, m2: 1.0, m4: 1.0 }, pascals(1.0))
        .unwrap()
        .with_gamma(gamma)
        .unwrap()
        .with_area_law(AreaLaw::ReducedDiffusion);
    let rate = |ln_v: f64, v_eff: f64| {
        let area = erf((2.0 * v_eff).powf(-0.5)); // p = 1
        ln_v.exp() * (gamma + (1.0 - gamma) * area * area)
    };
    let (start, steps) = ((0.5 / 36.0_f64).ln(), 20_000);
    for x in [1.0, 0.1, 0.01] {
        let end = (0.5 / f64::powi(x, 2)).ln();
        let h = (end - start) / f64::from(steps);
        let (mut t, mut v) = (start, start.exp());
        for _ in 0..steps {
            let k1 = rate(t, v);
            let k2 = rate(t + 0.5 * h, v + 0.5 * h * k1);
            let k3 = rate(t + 0.5 * h, v + 0.5 * h * k2);
            let k4 = rate(t + h, v + h * k3);
            v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
            t += h;
        }
        // p/(E* sqrt m2) = x with E* = m2 = 1.
        let area = model.area_fraction(x).unwrap();
        assert_relative_eq!(area, erf((2.0 * v).powf(-0.5)), max_relative = 1e-11);
        assert_relative_eq!(model.pressure_at_area(area).unwrap(), x, max_relative = 1e-13);
    }
    let plain = model.clone().with_gamma(1.0).unwrap();
    assert_relative_eq!(plain.area_fraction(0.3).unwrap(), erf(0.3), max_relative = 1e-15);
}

#[test]
fn magnification_cuts_the_spectrum() {
    let q = [2.0, 5.0, 60.0];
    let definition = Definition::new(0.8, q, 1.0);
    let spectrum = SelfAffineSpectrum::from_wavenumbers(0.8, q, 1.0).unwrap();
    let model = Persson::from_self_affine(spectrum, pascals(1.0)).unwrap();
    for zeta in [1.5, 2.4, 7.0, 29.0] {
        let m2 = PI * definition.moment(3, zeta * q[0]);
        let area = model.area_fraction_at_magnification(0.5, zeta).unwrap();
        assert_relative_eq!(area, erf(0.5 / m2.sqrt()), max_relative = 1e-13);
    }
    let all = model.area_fraction(0.5).unwrap();
    for (zeta, expected) in [(0.5, 1.0), (1.0, 1.0), (30.0, all), (1e9, all)] {
        let area = model.area_fraction_at_magnification(0.5, zeta).unwrap();
        assert_relative_eq!(area, expected, max_relative = 1e-15);
    }
    // Shells: a wavenumber on a shell includes it.
    let shells =
        vec![Shell { wavenumber: 1.0, variance: 2.0 }, Shell { wavenumber: 3.0, variance: 2.0 }];
    let model =
        Persson::from_spectrum(RoughnessSpectrum::new(shells).unwrap(), pascals(1.0)).unwrap();
    assert_relative_eq!(
        model.area_fraction_up_to(0.5, 2.9).unwrap(),
        erf(0.5),
        max_relative = 1e-15
    );
    assert_relative_eq!(
        model.area_fraction_up_to(0.5, 3.0).unwrap(),
        erf(0.5 / f64::sqrt(10.0)),
        max_relative = 1e-15
    );
}

#[test]
fn inverse_error_functions() {
    // erf(1/2), erfc(5), erfc(26): 20 digits by mpmath.
    for (y, a) in [(1e-12, 1.1283791670955125739e-12), (0.5, 0.52049987781304653768)] {
        assert_relative_eq!(erf_inv(a), y, max_relative = 3e-16);
    }
    for (y, b) in [
        (0.5, 0.47950012218695346232),
        (5.0, 1.5374597944280348502e-12),
        (20.0, 5.3958656116079009289e-176),
        (26.0, 5.6631924088561428465e-296),
    ] {
        assert_relative_eq!(erfc_inv(b), y, max_relative = 3e-16);
    }
    assert!(erf_inv(1.0).is_infinite() && erfc_inv(0.0).is_infinite());
    assert!(erf_inv(-0.1).is_nan() && erfc_inv(1.1).is_nan());
}

fn one_wave(amplitude: f64) -> JacksonStreator {
    let waves = vec![Wave { frequency: 1e4, amplitude }];
    let spectrum = AmplitudeSpectrum::new(waves, 1e-3).expect("one wave");
    JacksonStreator::new(spectrum, pascals(1e9)).expect("a model")
}

#[test]
fn recursion_has_its_limits() {
    // One wave is the sinusoid law itself.
    let complete = 2.0_f64.sqrt() * PI * 1e9 * 1e-7 * 1e4;
    for law in [SinusoidLaw::PublishedFit, SinusoidLaw::NumericalTable] {
        for x in [1e-9, 0.03, 0.5, 0.95, 1.0, 3.0] {
            let area =
                one_wave(1e-7).with_law(law).at_pressure(x * complete).unwrap().area_fraction;
            assert_relative_eq!(area, law.area_fraction(x), max_relative = 1e-14);
        }
        // Hertz at light load: both crests of a cell.
        let x = 1e-15;
        let hertz = PI * (3.0 * x / (8.0 * PI)).powf(2.0 / 3.0);
        assert_relative_eq!(law.area_fraction(x), hertz, max_relative = 1e-9);
    }
    // A short wave of no amplitude changes nothing; a steep one takes over.
    let two = |amplitude| {
        let waves =
            vec![Wave { frequency: 1e4, amplitude: 1e-7 }, Wave { frequency: 1e6, amplitude }];
        JacksonStreator::new(AmplitudeSpectrum::new(waves, 1e-3).unwrap(), pascals(1e9)).unwrap()
    };
    let area = |model: &JacksonStreator| model.at_pressure(1e5).unwrap().area_fraction;
    assert_relative_eq!(area(&two(0.0)), area(&one_wave(1e-7)), max_relative = 1e-15);
    assert_relative_eq!(area(&two(1e-14)), area(&one_wave(1e-7)), max_relative = 1e-15);
    assert!(area(&two(1e-7)) < 0.1 * area(&one_wave(1e-7)));
}

/// Two levels: the area of the features under the Hertz pressure of the smooth sphere.
#[test]
fn archard_is_the_integral_over_the_hertz_spot() {
    let (k, fine, m, load) = (0.7, 0.3, 50.0, 3.0);
    let spot = k * f64::powf(load, 2.0 / 3.0);
    let peak = 1.5 * load / spot;
    // Over r^2/a^2 = s: area = spot int_0^1 m fine (p(s)/m)^(2/3) ds, p = peak sqrt(1 - s)
    let expected =
        spot * integral(0.0, 1.0, |s| m * fine * (peak * (1.0 - s).sqrt() / m).powf(2.0 / 3.0));
    let model = Archard::from_constants(vec![k, fine], vec![1.0, m]).unwrap();
    assert_relative_eq!(model.area(load).unwrap(), expected, max_relative = 1e-12);
}

#[test]
fn fractal_loads_are_the_integrals_over_the_spots() {
    let e = 2e10;
    for d in [1.1, 1.49999, 1.5, 1.5 + 1e-12, 1.9] {
        let (g, area, critical) = (1e-9, 1e-4, 1e-13);
        let surface = FractalParameters { dimension: d, roughness: g };
        let model = MajumdarBhushan::new(surface, area, pascals(e))
            .unwrap()
            .with_critical_area(critical)
            .unwrap();
        let fraction = 0.02;
        let largest = (2.0 - d) / d * fraction * area;
        assert_relative_eq!(model.largest_spot(fraction).unwrap(), largest, max_relative = 1e-15);
        let number = |a: f64| 0.5 * d * largest.powf(0.5 * d) * a.powf(-0.5 * d - 1.0);
        let load = |a: f64| 4.0 * PI.sqrt() / 3.0 * e * g.powf(d - 1.0) * a.powf((3.0 - d) / 2.0);
        let expected = geometric_integral(critical, largest, 8.0, |a| number(a) * load(a)) / area;
        assert_relative_eq!(
            model.pressure_at_area(fraction).unwrap(),
            expected,
            max_relative = 1e-13
        );
        let back = model.at_pressure(expected).unwrap().area_fraction;
        assert_relative_eq!(back, fraction, max_relative = 1e-12);
    }
    for d in [2.1, 2.5, 2.5 - 1e-12, 2.8] {
        let (g, area, critical) = (1e-9, 1e-4, 1e-13);
        let model = YanKomvopoulos::new(d, g, area, pascals(e))
            .unwrap()
            .with_critical_area(critical)
            .unwrap();
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
        let found = model.pressure_at_largest_spot(largest).unwrap();
        assert_relative_eq!(found, expected, max_relative = 1e-13);
        // Real area: half of each elastic spot, all of each plastic one.
        let elastic = geometric_integral(critical, largest, 8.0, |a| 0.5 * number(a) * a);
        let plastic = geometric_integral(1e-80 * critical, critical, 1e4, |a| number(a) * a);
        let state = model.at_pressure(expected).unwrap();
        assert_relative_eq!(state.area_fraction, (elastic + plastic) / area, max_relative = 1e-7);
    }
}

#[test]
fn hardness_makes_small_spots_plastic() {
    let (e, hardness) = (2e10, 4e8);
    let surface = FractalParameters { dimension: 1.4, roughness: 1e-9 };
    let model = MajumdarBhushan::new(surface, 1e-4, pascals(e)).unwrap();
    let hard = model.with_hardness(hardness).unwrap();
    let critical = hard.critical_area();
    // At a_c the deformation G^(D-1) a^(1-D/2) is (pi H/2E*)^2 times the radius a^(D/2)/(pi^2 G^(D-1)).
    let g = 1e-9_f64.powf(0.4);
    let radius = critical.powf(0.7) / (PI * PI * g);
    assert_relative_eq!(
        g * critical.powf(0.3),
        (PI * hardness / (2.0 * e)).powi(2) * radius,
        max_relative = 1e-13
    );
    // While all spots are plastic the real pressure is the hardness.
    let light = 0.5 * hardness * 1.4 / 0.6 * critical / 1e-4;
    let state = hard.at_pressure(light).unwrap();
    assert_relative_eq!(state.real_pressure().unwrap(), hardness, max_relative = 1e-14);
    // Above, elastic and plastic loads add up.
    let fraction = 0.01;
    let elastic = model.with_critical_area(critical).unwrap().pressure_at_area(fraction).unwrap();
    let largest = model.largest_spot(fraction).unwrap();
    let plastic = hardness * 1.4 / 0.6 * largest.powf(0.7) * critical.powf(0.3) / 1e-4;
    let total = hard.pressure_at_area(fraction).unwrap();
    assert_relative_eq!(total, elastic + plastic, max_relative = 1e-14);
    assert_relative_eq!(
        hard.at_pressure(total).unwrap().area_fraction,
        fraction,
        max_relative = 1e-13
    );
}
