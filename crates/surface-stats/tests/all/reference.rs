//! Against values computed elsewhere, with more digits or by another program.
use approx::assert_relative_eq;
use contact_types::{Grid, HeightMap};
use serde_json::Value;
use std::f64::consts::TAU;
use surface_stats::spectrum::amplitudes;
use surface_stats::{Edges, Level, StatsOptions, SurfaceStatistics};

fn fixture(name: &str) -> Value {
    let path = format!("{}/../../fixtures/reference/{name}", env!("CARGO_MANIFEST_DIR"));
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_str().map_or_else(|| value.as_f64().unwrap(), |text| text.parse().unwrap())
}

fn sum_of_cosines(case: &Value) -> HeightMap {
    let (n, m) = (case["N"].as_i64().unwrap(), case["M"].as_i64().unwrap());
    let pixel = [number(&case["dy"]), number(&case["dx"])];
    let grid = Grid::new([m as usize, n as usize], pixel).unwrap();
    // Whole turns taken off in integers, so that the phase keeps all its digits.
    let turns = |waves: i64, at: i64, of: i64| (waves * at).rem_euclid(of) as f64 / of as f64;
    let wave = |c: &Value, i: i64, j: i64| {
        let (kx, ky) = (c["kx"].as_i64().unwrap(), c["ky"].as_i64().unwrap());
        let phase = TAU * (turns(kx, i, n) + turns(ky, j, m)) + number(&c["phase"]);
        number(&c["amp"]) * phase.cos()
    };
    let components = case["components"].as_array().unwrap();
    let heights = (0..m * n)
        .map(|index| components.iter().map(|c| wave(c, index % n, index / n)).sum())
        .collect();
    HeightMap::new(grid, heights).unwrap()
}

/// `½ Σ ½ a² (qx⁴ + qy⁴)` of the cosines.
fn m4_of_axes(case: &Value) -> f64 {
    let [n, m] = ["N", "M"].map(|key| number(&case[key]));
    let [dx, dy] = ["dx", "dy"].map(|key| number(&case[key]));
    let q = |c: &Value, key: &str, length: f64| TAU * number(&c[key]) / length;
    let of = |c: &Value| {
        let axes = q(c, "kx", n * dx).powi(4) + q(c, "ky", m * dy).powi(4);
        0.25 * number(&c["amp"]).powi(2) * axes
    };
    case["components"].as_array().unwrap().iter().map(of).sum()
}

fn statistics(map: &HeightMap, edges: Edges) -> SurfaceStatistics {
    let options = StatsOptions { level: Level::Mean, edges, ..StatsOptions::default() };
    SurfaceStatistics::of(map, &options).unwrap()
}

/// Moments by open and wrapped differences and by the spectrum, Nayak's asperities, amplitudes.
#[test]
fn sums_of_cosines_to_13_digits() {
    for case in fixture("surface_statistics.json")["surfaces"].as_array().unwrap() {
        let map = sum_of_cosines(case);
        let expected = |key: &str| number(&case["expected"][key]);
        let close = |found: f64, key: &str| {
            assert_relative_eq!(found, expected(key), max_relative = 1e-13, epsilon = 0.0);
        };
        for (edges, suffix) in [(Edges::Open, "open"), (Edges::Periodic, "periodic")] {
            let key = |name: &str| format!("{name}_{suffix}");
            let s = statistics(&map, edges);
            close(s.m2_x, &key("m2_fwd_x"));
            close(s.m2_y, &key("m2_fwd_y"));
            close(s.m4_x, &key("m4_x"));
            close(s.m4_y, &key("m4_y"));
            close(s.m0, "m0");
            close(s.m0_spectral, "m0");
            close(s.m2_spectral, "m2_spectral");
            let m4 = m4_of_axes(case);
            assert_relative_eq!(s.m4_spectral, m4, max_relative = 1e-13, epsilon = 0.0);
        }
        let s = statistics(&map, Edges::Open);
        close(s.bandwidth.unwrap(), "alpha");
        let asperities = s.asperities.unwrap();
        close(asperities.density, "eta");
        close(asperities.radius, "R");
        close(asperities.height_std, "sigma_s");
        close(asperities.mean_offset, "ys");
        close(s.max_amplitude_ratio, "B_max");
        let spectrum = amplitudes(&map).unwrap();
        let rms = expected("m0").sqrt();
        let list = case["expected"]["amp_rows_x"].as_array().unwrap();
        assert_eq!(list.len(), spectrum.waves().len() + 1);
        for (wave, value) in spectrum.waves().iter().zip(&list[1..]) {
            assert_relative_eq!(wave.amplitude, number(value), epsilon = 1e-14 * rms);
        }
    }
}

/// Two crossed sines, 200 x 320 points of 0.8 um x 0.5 um, against an independent program.
#[test]
fn two_sines_agree_with_another_program() {
    let values = &fixture("two_sines.json")["values"];
    let um = 1e-6;
    let grid = Grid::new([200, 320], [0.8 * um, 0.5 * um]).unwrap();
    let heights = (0..grid.len())
        .map(|i| {
            let (y, x) = ((i / 320) as f64 / 200.0, (i % 320) as f64 / 320.0);
            um * (0.5 * (TAU * 8.0 * x).sin() + 0.2 * (TAU * 5.0 * y).sin())
        })
        .collect();
    let map = HeightMap::new(grid, heights).unwrap();
    let s = statistics(&map, Edges::Open);
    let close = |found: f64, unit: f64, key: &str| {
        let expected = number(&values[key]);
        assert_relative_eq!(found / unit, expected, max_relative = 1e-10, epsilon = 0.0);
    };
    close(s.rms_height, um, "Sq");
    close(s.mean_abs_height, um, "Sa");
    close(s.kurtosis.unwrap(), 1.0, "Sku");
    close(s.peak_height, um, "Sp");
    close(s.pit_depth, um, "Sv");
    close(s.m2_x, 1.0, "m2x_fd");
    close(s.m2_y, 1.0, "m2y_fd");
    close(s.m4_x, um.powi(-2), "m4x_fd");
    close(s.m4_y, um.powi(-2), "m4y_fd");
    close(s.rms_gradient, 1.0, "Sdq_fwd");
    close((2.0 * s.m2_spectral).sqrt(), 1.0, "hrms_grad_spec");
    close(s.bandwidth.unwrap(), 1.0, "alpha_nayak_fd");
    assert_eq!(s.summits.count, 40);
    close(s.summits.density, um.powi(-2), "summit_density8");
    close(s.summits.curvature_mean.unwrap(), um.recip(), "summit_mean_curv8");
    close(s.summits.height_mean.unwrap(), um, "summit_mean_height8");
    assert_relative_eq!(s.summits.height_std.unwrap() / um, 0.0, epsilon = 1e-10);
    assert_relative_eq!(s.skewness.unwrap(), 0.0, epsilon = 1e-10);
}
