//! Loads as forces: the same answers as the pressures they are.

use crate::cli::{ROUGH, TestFolder, UNITS, close, folder, has, number, surface};
use std::f64::consts::TAU;

const SOLVE: &str = "solve a.txt --pixel 1um --height-unit um --modulus 100GPa";

fn wavy() -> TestFolder {
    let at = folder();
    let wave = |i: usize| 0.1 * (TAU * i as f64 / 16.0).cos();
    at.matrix("a.txt", 32, 32, |iy, ix| wave(iy) + wave(ix));
    at
}

/// 32 x 32 points of 1 um are 1.024e-9 m2: 1.024 N is 1 GPa, on 2 mm2 it is 512 kPa.
#[test]
fn a_force_is_its_pressure_on_the_area() {
    let at = &wavy();
    let by = |loads: &str| at.answer(&format!("{SOLVE} {loads}"));
    let forces = by("--load 0.1024N,1.024N");
    let pressures = by("--pressure 100MPa,1GPa");
    for (i, force) in [0.1024, 1.024].into_iter().enumerate() {
        let (point, p) = (&forces["points"][i], &pressures["points"][i]);
        close(number(&point["load"]), force, 1e-12);
        for key in ["mean_pressure", "area_fraction", "mean_gap", "approach"] {
            close(number(&point[key]), number(&p[key]), 1e-6);
        }
    }
    assert!((number(&forces["load_area"]) - 1.024e-9).abs() < 1e-21);
    assert!(pressures["load_area"].is_null());
    let wide = by("--load 1.024N --area 2mm2");
    assert!((number(&wide["points"][0]["mean_pressure"]) - 512e3).abs() < 1e-6);

    let text = at.run(&format!("{SOLVE} --load 1.024N")).out;
    has(&text, &["1.02 N", "1.00 GPa", "load: over 1024 µm², the area of the map"]);
}

#[test]
fn models_and_studies_take_forces() {
    let at = &wavy();
    let typed = "model gw --m0 1um2 --m2 1e-3 --m4 1e9m-2 --modulus 110GPa --load 10N";
    let said = at.answer(&format!("{typed} --area 2mm2"));
    assert!((number(&said["points"][0]["mean_pressure"]) - 5e6).abs() < 1e-6);
    assert!((number(&said["points"][0]["load"]) - 10.0).abs() < 1e-12);
    at.refuses(typed, &["--area 2mm2", "--pressure"]);

    let study = "compare a.txt --modulus 100GPa --models Persson,GW --load 0.1024N --out one";
    let first = at.done(&format!("{study} {UNITS}"));
    has(&first.out, &["load: on 1024 µm²: 102 mN is 100 MPa"]);
    assert!(at.read("one/report.html").contains("is 100\u{202F}MPa"), "no pressure by the force");
    let found = at.results("one");
    close(number(&found["settings"]["load_area"]), 1.024e-9, 1e-12);
    let point = &found["surfaces"][0]["deterministic"]["points"][0];
    close(number(&point["mean_pressure"]), 100e6, 1e-12);
}

#[test]
fn loads_that_make_no_sense_are_refused() {
    let at = &wavy();
    at.matrix("b.txt", 16, 16, |iy, ix| 0.01 * ((iy * ix) % 7) as f64);
    at.refuses_each(
        SOLVE,
        &[
            ("--load 0N", &["load 0 N must be greater than 0"]),
            ("--load 1N --area 0mm2", &["nominal area 0"]),
            ("--load 1N --pressure 1MPa", &["--pressure", "--load"]),
            ("--load 1N --gap 1nm", &["--gap", "--load"]),
            ("--load 10", &["10N or 10kN"]),
            ("--load 10kg", &["did you mean kgf?"]),
            ("--pressure 1MPa --area 2mm2", &["--load"]),
            ("--load 1e300N --area 1e-20m2", &["no pressure"]),
        ],
    );
    let maps = format!("compare a.txt b.txt {UNITS} --modulus 1GPa --load 1N --out x");
    at.refuses(&maps, &["1024 µm²", "256.0 µm²", "--area"]);
}

/// With forces the headline, the axes, the read-out and the table are in newtons; the table of numbers always has both.
#[test]
fn a_study_at_forces_reads_in_newtons() {
    let at = &surface(ROUGH);
    let page = |study: &str| at.read(&format!("{study}/report.html")).replace('\u{202f}', " ");
    let study = |maps: &str, rest: &str| {
        at.done(&format!("compare {maps} --modulus 110GPa --headline 10MPa {rest}")).out
    };
    let forces = "--load 10N,20N --area 1mm2";
    has(&study("a.x3p", &format!("{forces} --out n")), &["at 10 N (10 MPa) "]);
    has(&at.read("n/area.svg"), &["Load (N)"]);
    has(&at.read("n/pressure.svg"), &["Load (N)"]);
    has(&page("n"), &["<h1>At 10 N (10 MPa), ", "20 N (20 MPa): area"]);
    has(&study("a.x3p", "--pressure 10MPa,20MPa --out p"), &["at 10 MPa "]);
    has(&at.read("p/area.svg"), &["Nominal pressure (MPa)"]);
    // 10 MPa on 64² µm², in the read-out.
    has(&page("p"), &["10 MPa (41.0 mN on this map): area"]);
    // A page with a section each, and one of many maps.
    std::fs::copy(at.join("a.x3p"), at.join("b.x3p")).expect("a copy");
    let cell = "<td class=\"n\">10 N (10 MPa)</td>";
    study("a.x3p b.x3p", &format!("{forces} --out several"));
    has(&page("several"), &[cell]);
    has(&study("a.x3p b.x3p", &format!("{forces} --summary --out many")), &["10.0 N"]);
    has(&page("many"), &["Load (N)", cell, "the same for every map"]);
    for (folder, area) in [("n", 1e-6), ("p", 4096e-12)] {
        let [pressures, forces] = ["mean_pressure", "load [N]"]
            .map(|heading| at.column(&format!("{folder}/curves.csv"), heading));
        for (force, pressure) in forces.iter().zip(pressures) {
            close(*force, pressure * area, 1e-12);
        }
    }
}
