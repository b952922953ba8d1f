//! Loads as forces: the same answers as the pressures they are.

use crate::cli;

use cli::{folder, matrix, number, refused, rough_contact};
use std::f64::consts::TAU;
use std::path::Path;

const SOLVE: &str = "solve a.txt --pixel 1um --height-unit um --modulus 100GPa";

fn wavy(folder: &Path) {
    let wave = |i: usize| 0.1 * (TAU * i as f64 / 16.0).cos();
    matrix(folder, "a.txt", 32, 32, |iy, ix| wave(iy) + wave(ix));
}

/// 32 x 32 points of 1 um are 1.024e-9 m2: 1.024 N is 1 GPa, on 2 mm2 it is 512 kPa.
#[test]
fn a_force_is_its_pressure_on_the_area() {
    let folder = folder();
    wavy(folder.path());
    let by =
        |loads: &str| rough_contact(folder.path(), &format!("{SOLVE} --json {loads}")).answered();
    let forces = by("--load 0.1024N,1.024N");
    let pressures = by("--pressure 100MPa,1GPa");
    for (i, force) in [0.1024, 1.024].into_iter().enumerate() {
        let point = &forces["points"][i];
        assert!((number(&point["load"]) / force - 1.0).abs() < 1e-12, "{point}");
        let p = &pressures["points"][i];
        for key in ["mean_pressure", "area_fraction", "mean_gap", "approach"] {
            let (a, b) = (number(&point[key]), number(&p[key]));
            assert!((a / b - 1.0).abs() < 1e-6, "{key}: {a} {b}");
        }
    }
    assert!((number(&forces["load_area"]) - 1.024e-9).abs() < 1e-21);
    assert!(pressures["load_area"].is_null());
    let wide = by("--load 1.024N --area 2mm2");
    assert!((number(&wide["points"][0]["mean_pressure"]) - 512e3).abs() < 1e-6);

    let text = rough_contact(folder.path(), &format!("{SOLVE} --load 1.024N")).out;
    assert!(text.contains("1.02 N") && text.contains("1.00 GPa"), "{text}");
    assert!(text.contains("load: over 1024 µm², the area of the map"), "{text}");
}

#[test]
fn models_and_studies_take_forces() {
    let folder = folder();
    wavy(folder.path());
    let typed = "model gw --m0 1um2 --m2 1e-3 --m4 1e9m-2 --modulus 110GPa --load 10N";
    let said = rough_contact(folder.path(), &format!("{typed} --area 2mm2 --json")).answered();
    assert!((number(&said["points"][0]["mean_pressure"]) - 5e6).abs() < 1e-6);
    assert!((number(&said["points"][0]["load"]) - 10.0).abs() < 1e-12);
    refused(folder.path(), typed, 2, &["--area 2mm2", "--pressure"]);

    let study = "compare a.txt --pixel 1um --height-unit um --modulus 100GPa --models Persson,GW \
                 --load 0.1024N --out";
    let first = rough_contact(folder.path(), &format!("{study} one"));
    assert!(
        first.out.contains("load: on 1024 µm²: 102 mN is 100 MPa"),
        "{}{}",
        first.out,
        first.err
    );
    let page = std::fs::read_to_string(folder.path().join("one/report.html")).unwrap();
    assert!(page.contains("is 100\u{202F}MPa"), "no pressure beside the force");
    let again =
        rough_contact(folder.path(), "compare --from one/run.toml --out two --json").answered();
    assert!((number(&again["settings"]["load_area"]) / 1.024e-9 - 1.0).abs() < 1e-12);
    let p = number(&again["surfaces"][0]["deterministic"]["points"][0]["mean_pressure"]);
    assert!((p / 100e6 - 1.0).abs() < 1e-12);
}

#[test]
fn loads_that_make_no_sense_are_refused() {
    let folder = folder();
    wavy(folder.path());
    matrix(folder.path(), "b.txt", 16, 16, |iy, ix| 0.01 * ((iy * ix) % 7) as f64);
    let solve = |rest: &str, parts: &[&str]| {
        refused(folder.path(), &format!("{SOLVE} {rest}"), 2, parts);
    };
    solve("--load 0N", &["load 0 N must be greater than 0"]);
    solve("--load 1N --area 0mm2", &["nominal area 0"]);
    solve("--load 1N --pressure 1MPa", &["--pressure", "--load"]);
    solve("--load 1N --gap 1nm", &["--gap", "--load"]);
    solve("--load 10", &["10N or 10kN"]);
    solve("--load 10kg", &["did you mean kgf?"]);
    solve("--pressure 1MPa --area 2mm2", &["--load"]);
    solve("--load 1e300N --area 1e-20m2", &["no pressure"]);
    refused(
        folder.path(),
        "compare a.txt b.txt --pixel 1um --height-unit um --modulus 1GPa --load 1N --out x",
        2,
        &["1024 µm²", "256.0 µm²", "--area"],
    );
}

/// With forces the headline, the axes, the read-out and the table are in newtons; the table of numbers always has both.
#[test]
fn a_study_at_forces_reads_in_newtons() {
    let dir = folder();
    let at = dir.path();
    let synth = "synth --shape 64,64 --pixel 1um --hurst 0.8 --rolloff 32um --cutoff 8um \
                 --rms-gradient 0.1 --seed 4 --out a.x3p";
    assert_eq!(rough_contact(at, synth).status, 0);
    let read = |name: &str| std::fs::read_to_string(at.join(name)).expect(name);
    let forces = rough_contact(
        at,
        "compare a.x3p --modulus 110GPa --load 10N,20N --area 1mm2 --headline 10MPa --out n",
    );
    assert_eq!(forces.status, 0, "{}", forces.err);
    assert!(forces.out.contains("at 10 N (10 MPa) "), "{}", forces.out);
    assert!(read("n/area.svg").contains("Load (N)") && read("n/pressure.svg").contains("Load (N)"));
    let page = read("n/report.html").replace('\u{202f}', " ");
    assert!(page.contains("<h1>At 10 N (10 MPa), ") && page.contains("20 N (20 MPa): area"));
    let pressures = rough_contact(
        at,
        "compare a.x3p --modulus 110GPa --pressure 10MPa,20MPa --headline 10MPa --out p",
    );
    assert!(pressures.status == 0 && pressures.out.contains("at 10 MPa "), "{}", pressures.out);
    assert!(read("p/area.svg").contains("Nominal pressure (MPa)"));
    // 10 MPa on 64² µm².
    let page = read("p/report.html").replace('\u{202f}', " ");
    assert!(page.contains("10 MPa (41.0 mN on this map): area"), "the read-out");
    // A page with a section each, and one of many maps.
    std::fs::copy(at.join("a.x3p"), at.join("b.x3p")).expect("a copy");
    let both = "compare a.x3p b.x3p --modulus 110GPa --load 10N,20N --area 1mm2 --headline 10MPa";
    let said = rough_contact(at, &format!("{both} --out several"));
    assert_eq!(said.status, 0, "{}", said.err);
    let page = read("several/report.html").replace('\u{202f}', " ");
    assert!(page.contains("<td class=\"n\">10 N (10 MPa)</td>"), "the first table");
    let said = rough_contact(at, &format!("{both} --summary --out many"));
    assert!(said.status == 0 && said.out.contains("10.0 N"), "{}{}", said.out, said.err);
    let page = read("many/report.html").replace('\u{202f}', " ");
    for words in ["Load (N)", "<td class=\"n\">10 N (10 MPa)</td>", "the same for every map"] {
        assert!(page.contains(words), "{words}");
    }
    for (folder, area) in [("n", 1e-6), ("p", 4096e-12)] {
        let csv = read(&format!("{folder}/curves.csv"));
        let mut rows = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let place =
            rows.next().expect("a header").iter().position(|h| *h == "load [N]").expect("a column");
        for row in rows {
            let [p, force] =
                [row[1], row[place]].map(|cell| cell.parse::<f64>().expect("a number"));
            assert!((force / (p * area) - 1.0).abs() < 1e-12, "{row:?}");
        }
    }
}
