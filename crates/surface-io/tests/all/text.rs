//! Texts as programs and instruments write them: what is read, and what is refused with its readings.
#![allow(clippy::float_cmp, reason = "what is read is the number that was written")]

use crate::common::{self, SayMore as _, unaided, units};
use contact_types::Grid;
use std::fmt::Write as _;
use surface_io::HeightUnit::Always;
use surface_io::{
    DecimalMark, Fill, FillError, Layout, Measurement, Need, ReadError, ReadOptions, read_bytes,
    read_traces_bytes,
};

const GWYDDION: &str = "# Width: 4 um\n# Height: 3 um\n# Value units: nm\n";

/// With a pixel of 1 µm and heights in nm where the text is silent.
fn scaled() -> ReadOptions {
    common::scaled(1e-6, 1e-9)
}

fn read(text: &str) -> Measurement {
    unaided(text).unwrap()
}

/// Heights in nm of a text read with `options`.
fn heights(text: &str, options: &ReadOptions) -> Vec<f64> {
    let found = read_bytes(text.as_bytes(), options).unwrap_or_else(|e| panic!("{text}: {e}"));
    found.heights().iter().map(|z| (z * 1e12).round() / 1e3).collect()
}

fn refusal(text: &str, options: &ReadOptions) -> ReadError {
    read_bytes(text.as_bytes(), options).expect_err(text)
}

/// Twenty heights of 4 x 5 points, none of which rises along a row or a column.
fn height(i: usize) -> f64 {
    ((i * i + 10) % 23) as f64 * 0.25 - 2.5
}

/// Rows of 5 of them, `start` before each and `between` the numbers.
fn rows(start: &[&str], between: &str, write: impl Fn(f64) -> String) -> String {
    let mut text = String::new();
    for iy in 0..4 {
        let row: Vec<String> = (0..5).map(|ix| write(height(iy * 5 + ix))).collect();
        writeln!(text, "{}{}", start.get(iy).unwrap_or(&""), row.join(between)).unwrap();
    }
    text
}

fn all() -> Vec<f64> {
    (0..20).map(height).collect()
}

#[test]
fn concatenated_channels_are_channels() {
    for separator in ["", "\n", "\n\n"] {
        let text = format!(
            "# Channel: Height\n{GWYDDION}1 2\n3 4\n{separator}# Channel: Phase\n{}7 8\n9 1\n",
            GWYDDION.replace("nm", "deg")
        );
        let found = read(&text);
        assert_eq!((found.grid().shape(), found.grid().pixel()), ([2, 2], [1.5e-6, 2e-6]));
        assert_eq!(found.channels.len(), 2);
        let phase = refusal(&text, &ReadOptions::default().channel("Phase"));
        assert!(phase.to_string().contains("deg"), "{phase}");
        // Of another size, in a unit of length: by its name or its number.
        let text = format!("# Channel: A\n{GWYDDION}1 2\n3 4\n# Channel: B\n{GWYDDION}7 8 9\n");
        for name in ["B", "#2"] {
            assert_eq!(heights(&text, &ReadOptions::default().channel(name)), [7.0, 8.0, 9.0]);
        }
    }
    // Headers without a comment sign.
    let text = "Channel: A\nWidth: 2 um\nHeight: 2 um\nValue units: nm\n1 2\n3 4\n\
                Channel: B\nWidth: 2 um\nHeight: 2 um\nValue units: nm\n5 6\n7 8\n";
    assert_eq!(heights(text, &ReadOptions::default().channel("B")), [5.0, 6.0, 7.0, 8.0]);
    // Comments between the lines of a scan begin no channel.
    let list = "# y = 0\n0 0 1\n1 0 2\n2 0 3\n\n# y = 1\n0 1 4\n1 1 5\n2 1 6\n# y = 2\n0 2 7\n1 2 8\n2 2 9\n";
    let found = read_bytes(list.as_bytes(), &scaled().lateral(1e-6)).unwrap();
    assert_eq!((found.grid().shape(), found.channels.len()), ([3, 3], 1));
}

/// Tables of equal size with nothing but a line between them: one map, or several.
#[test]
fn tables_without_headers_are_one_or_several() {
    for line in ["\n", "# New slice\n"] {
        let text = format!("1 5 2 6\n4 3 8 1\n{line}9 5 1 2\n3 3 7 1\n");
        let error = refusal(&text, &scaled());
        assert_eq!(error.needs(), [Need::Channel, Need::Layout(Layout::Matrix)], "{error}");
        let whole = read_bytes(text.as_bytes(), &scaled().layout(Layout::Matrix)).unwrap();
        assert_eq!(whole.grid().shape(), [4, 4]);
        assert_eq!(heights(&text, &scaled().channel("#2"))[..4], [9.0, 5.0, 1.0, 2.0]);
    }
    assert_eq!(heights("1 5 2 6\n\n4 3 8 1\n\n9 5 1 2\n", &scaled()).len(), 12);
}

#[test]
fn a_row_and_a_column_of_coordinates_are_no_heights() {
    let with = |corner: &str, x: &str, y: [&str; 4]| {
        format!("{corner},{x}\n{}", rows(&y, ",", |z| format!("{z:.2}")))
    };
    let no_pixel = units(1e-6, 1e-9);
    for corner in ["", "y\\x", "0", "5"] {
        let text = with(corner, "0.0,0.5,1.0,1.5,2.0", ["0.0,", "1.5,", "3.0,", "4.5,"]);
        let found = read_bytes(text.as_bytes(), &no_pixel).unwrap();
        assert_eq!(found.grid(), Grid::new([4, 5], [1.5e-6, 0.5e-6]).unwrap(), "{text}");
        assert_eq!(heights(&text, &no_pixel), all());
        assert!(found.metadata["left out"].contains("coordinates"));
    }
    // Coordinates that fall are turned, as in a list; the row with the smallest y is the first.
    let text = with("", "0.0,0.5,1.0,1.5,2.0", ["4.5,", "3.0,", "1.5,", "0.0,"]);
    assert_eq!(heights(&text, &no_pixel)[..5], all()[15..]);
    // Running numbers give no pixel.
    for (x, y) in [("0,1,2,3,4", ["0,", "1,", "2,", "3,"]), ("1,2,3,4,5", ["1,", "2,", "3,", "4,"])]
    {
        let text = with("", x, y);
        assert_eq!(heights(&text, &scaled()), all());
        assert_eq!(refusal(&text, &ReadOptions::default()).needs()[0], Need::PixelSize);
    }
}

#[test]
fn a_first_row_that_counts_is_no_heights() {
    for x in ["0,1,2,3,4\n", "1,2,3,4,5\n"] {
        let text = format!("{x}{}", rows(&[], ",", |z| format!("{z:.2}")));
        assert_eq!(heights(&text, &scaled()), all());
        assert_eq!(heights(&text, &scaled().layout(Layout::Matrix)).len(), 25);
    }
    // Whole numbers all over: four in a row may be chance. A plane is none.
    let error = refusal("0 1 2 3\n5 3 9 8\n7 7 1 2\n", &scaled());
    assert_eq!(error.needs(), [Need::Layout(Layout::Matrix)]);
    assert_eq!(heights("0 1 2 3\n4 5 6 7\n8 9 10 11\n", &scaled()).len(), 12);
}

#[test]
fn a_first_column_that_rises_may_be_positions() {
    for (head, y) in [
        ("", ["0,", "1,", "2,", "3,"]),
        (GWYDDION, ["0,", "1,", "2,", "3,"]),
        ("", ["0.0,", "0.5,", "1.0,", "1.5,"]),
    ] {
        let text = head.to_owned() + &rows(&y, ",", |z| format!("{z:.2}"));
        let error = refusal(&text, &scaled().lateral(1e-6));
        let layouts = [Layout::Traces, Layout::Matrix].map(Need::Layout);
        assert_eq!(error.needs(), layouts, "{error}");
        let traces = scaled().layout(Layout::Traces);
        assert_eq!(read_traces_bytes(text.as_bytes(), &traces).unwrap().len(), 5);
        assert_eq!(heights(&text, &scaled().layout(Layout::Matrix)).len(), 24);
    }
    // x with two traces whose titles say so little.
    let text = "X(mm),Raw(um),Levelled(um)\n0.000,1,1\n0.001,2,3\n0.002,0,5\n0.003,4,1\n";
    let error = refusal(text, &ReadOptions::default());
    assert!(error.needs().contains(&Need::Layout(Layout::Traces)), "{error}");
    let traces = ReadOptions::default().layout(Layout::Traces).channel("Levelled");
    let found = read_bytes(text.as_bytes(), &traces).unwrap();
    assert!((found.grid().pixel()[1] - 1e-6).abs() < 1e-18 && found.is_profile());
    assert!((found.heights()[2] - 5e-6).abs() < 1e-18);
}

#[test]
fn lists_have_further_columns_and_any_order() {
    let list = |line: &dyn Fn(usize, usize, f64) -> String| {
        (0..20).map(|i| line(i % 5, i / 5, height(i)) + "\n").collect::<String>()
    };
    let options = units(1e-6, 1e-9);
    let x = |x: usize| x as f64 * 0.5;
    let fourth = |i: usize, y: usize, z: f64| format!("{} {} {z} {}", x(i), y * 2, 100 + i);
    let indexed = |i: usize, y: usize, z: f64| format!("{} {} {} {z}", y * 5 + i, x(i), y * 2);
    for (titles, text) in [
        ("", list(&fourth)),
        ("x y z intensity\n", list(&fourth)),
        ("index x y z\n", list(&indexed)),
        ("", list(&indexed)),
        ("y x z\n", list(&|i, y, z| format!("{} {} {z}", y * 2, x(i)))),
        ("z y x\n", list(&|i, y, z| format!("{z} {} {}", y * 2, x(i)))),
        ("y [um] x [um] z [nm]\n", list(&|i, y, z| format!("{} {} {z}", y * 2, x(i)))),
        ("x y intensity z\n", list(&|i, y, z| format!("{} {} {} {z}", x(i), y * 2, 100 + i))),
    ] {
        let text = format!("{titles}{text}");
        let found = read_bytes(text.as_bytes(), &options).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(found.grid(), Grid::new([4, 5], [2e-6, 0.5e-6]).unwrap(), "{text}");
        assert_eq!(heights(&text, &options), all(), "{text}");
    }
    // A stated spacing, size or value makes no heights and no units of coordinates.
    for head in
        ["Spacing: 2 nm\n", "Width: 2 nm\nHeight: 2 nm\n", "Resolution: 500 nm\n", "Lc 0.8 mm\n"]
    {
        for titles in ["x y z\n", "x intensity y h\n", ""] {
            let text = list(&|i, y, z| match titles.len() {
                17 => format!("{} {i} {} {z}", x(i), y * 2),
                _ => format!("{} {} {z}", x(i), y * 2),
            });
            let text = format!("{head}{titles}{text}");
            assert_eq!(heights(&text, &options), all(), "{text}");
        }
    }
    // By rows and columns.
    let text = format!("row col height\n{}", list(&|x, y, z| format!("{y} {x} {z}")));
    assert_eq!(heights(&text, &options), all());
    let text = list(&fourth);
    let found = read_bytes(text.as_bytes(), &options).unwrap();
    let names: Vec<&str> = found.channels.iter().map(|channel| channel.name.as_str()).collect();
    assert_eq!(names, ["default", "column 4"]);
    // Validity is no height, and a mask can be meant either way.
    let valid = |title: &str, ok: u8| {
        format!("x y z {title}\n0 0 1 {ok}\n1 0 2 {ok}\n0 1 3 {ok}\n1 1 4 {}\n", 1 - ok)
    };
    for (title, ok) in [("valid", 1), ("invalid", 0), ("masked", 0)] {
        let found = read_bytes(valid(title, ok).as_bytes(), &options).unwrap();
        assert_eq!((found.missing(), found.channels.len()), (1, 1), "{title}");
        assert!(found.heights()[3].is_nan());
    }
    let error = refusal(&valid("mask", 1), &options).to_string();
    assert!(error.contains("\"valid\" or \"invalid\""), "{error}");
}

#[test]
fn profiles_in_other_forms() {
    let um = common::scaled(0.5e-6, 1e-9);
    let found = read_bytes(b"SJ-210\nRa,0.123,um\n1.5\n-2\n0\n3\n", &um).unwrap();
    assert!(found.is_profile() && found.ambiguity.is_some());
    assert_eq!(found.grid().pixel()[1], 0.5e-6);
    assert_eq!(refusal("1.5\n-2\n0\n", &ReadOptions::default()).needs()[0], Need::PixelSize);
    for titles in ["Counter,X (um),Z (nm)\n", "No,x [um],z [nm]\n", ""] {
        let text = format!("{titles}0,0.0,1\n1,0.5,-2\n2,1.0,0\n3,1.5,3\n");
        let options = units(1e-6, 1e-9);
        let found = read_bytes(text.as_bytes(), &options).unwrap();
        assert!(found.is_profile(), "{text}");
        assert_eq!(found.grid().pixel()[1], 0.5e-6, "{text}");
        assert_eq!(heights(&text, &options), [1.0, -2.0, 0.0, 3.0]);
    }
}

/// Heights on a line stay on it; between 1 and 4 µm a straight line stands for the tent.
#[test]
fn points_lie_on_the_lines_between_their_neighbours() {
    let profile = read("x [um];z [nm]\n5.00;0\n6.00;1\n9.00;7\n10.00;9\n11.00;11\n");
    assert!(profile.uneven.is_some());
    assert_eq!(profile.positions.as_ref().unwrap().len(), 5);
    let (even, steps) = profile.evenly_spaced().unwrap();
    let (spacing, longest) = (even.grid().pixel()[1], steps.unwrap()[1]);
    assert!((spacing - 1.5e-6).abs() < 1e-18 && (longest - 3e-6).abs() < 1e-18);
    let map = even.fill(Fill::Refuse).unwrap();
    // 5, 6.5, 8, 9.5, 11 µm.
    for (z, nm) in map.heights().iter().zip([0.0, 2.0, 5.0, 8.0, 11.0]) {
        assert!((z - 1e-9 * nm).abs() < 1e-20, "{z:e} {nm}");
    }
}

/// Falling positions give the same; what is even is left as it is.
#[test]
fn either_direction_and_even_profiles() {
    let up = read("x [um];z [nm]\n0.00;1\n1.00;5\n4.00;2\n5.00;7\n").evenly_spaced().unwrap().0;
    let down = read("x [um];z [nm]\n5.00;7\n4.00;2\n1.00;5\n0.00;1\n").evenly_spaced().unwrap().0;
    assert_eq!(up.heights(), down.heights());
    assert!((up.heights()[1] - 13e-9 / 3.0).abs() < 1e-20, "{up:?}");
    let even = read("x [um];z [nm]\n0;1\n1;5\n2;2\n3;7\n");
    let (same, steps) = even.clone().evenly_spaced().unwrap();
    assert!(steps.is_none() && same == even);
}

#[test]
fn a_gap_is_not_bridged() {
    let mut text = String::from("x [um];z [nm]\n");
    for i in 0..30 {
        let x = if i < 15 { i } else { i + 100 };
        writeln!(text, "{x};{}", i % 3).unwrap();
    }
    let refused = read(&text).evenly_spaced();
    assert!(matches!(refused, Err(FillError::Gap { .. })), "{refused:?}");
}

#[test]
fn numbers_as_people_and_programs_write_them() {
    let read = |row: &str| heights(&format!("{GWYDDION}{row}\n{row}\n"), &ReadOptions::default());
    for row in [
        "1234.5\t-0.25\t1e3",
        "1.2345D+03\t-2.5d-01\t1.0D3",
        "1,234.5\t-0.25\t1,000",
        "1.234,5\t-0,25\t1.000",
        "1 234,5\t-0,25\t1 000",
        "1\u{a0}234,5 -0,25 1\u{202f}000",
        "1'234.5\t-0.25\t1\u{2019}000",
        "1234.5\t\u{2212}0.25\t1e3",
        "1234.5;\u{2013}0.25;1.0E+03",
        "\"1234,5\",\"-0,25\",\"1000,0\"",
        "\"1,234.5\",\"-0.25\",\"1,000.0\"",
        "\"1234,5\" \"-0,25\" \"1000,0\"",
        "1234.5nm;-0.25 nm;1000 nm",
    ] {
        assert_eq!(read(row)[..3], [1234.5, -0.25, 1000.0], "{row}");
    }
    // Zeros at the start show decimals wherever they stand.
    assert_eq!(read("1,855\t2,184\t0,853")[..3], [1.855, 2.184, 0.853]);
    assert_eq!(read("1.855\t2.184\t3.853")[..3], [1.855, 2.184, 3.853]);
}

#[test]
fn thousands_are_told_by_their_pattern_or_asked_for() {
    for mark in [",", "."] {
        let text = format!("{GWYDDION}34\t1{mark}855\t-291\n2{mark}184\t853\t-12{mark}034\n");
        let expected = [34.0, 1855.0, -291.0, 2184.0, 853.0, -12034.0];
        assert_eq!(heights(&text, &ReadOptions::default()), expected, "{text}");
    }
    // In every number: nothing tells.
    let text = format!("{GWYDDION}1,855\t2,184\n3,853\t4,291\n");
    let error = refusal(&text, &ReadOptions::default());
    assert_eq!(error.needs(), [Need::DecimalMark]);
    let said = error.to_string();
    assert!(said.contains("line 4") && said.contains("1.855") && said.contains("1855"), "{said}");
    let read = |mark| heights(&text, &ReadOptions::default().and(|o| o.decimal = Some(mark)))[0];
    assert_eq!((read(DecimalMark::Comma), read(DecimalMark::Point)), (1.855, 1855.0));
    // Both marks, each with three digits.
    assert_eq!(refusal("1,855;2\n3.853;4\n", &scaled()).needs(), [Need::DecimalMark]);
    // A mark of missing points among decimals is no thousands.
    let marked = format!("{GWYDDION}1.855 999\n2.184 3.853\n");
    assert_eq!(heights(&marked, &ReadOptions::default())[0], 1.855);
    // Whole coordinates beside heights with three decimals.
    let list = "0 0 1.855\n1 0 2.184\n2 0 3.853\n0 1 4.291\n1 1 5.125\n2 1 6.375\n";
    let options = scaled().lateral(1e-6);
    assert_eq!(heights(list, &options)[0], 1.855);
    let torn = refusal("0,034,1,855\n2,184,0,053\n", &scaled()).to_string();
    assert!(torn.contains("decimal commas"), "{torn}");
}

#[test]
fn marks_of_missing_points() {
    let marks = "1.#QNAN|-1.#IND|1.#QNAN00|-nan(ind)|-nan|NaN|No Data|NODATA|n.a.|#N/A|#NV|#VALUE!|BAD|\
                 null|3.40282346638529E+38|***|---|\u{2013}|";
    for mark in marks.split('|') {
        for separator in [";", "\t", ","] {
            let text =
                format!("{GWYDDION}1{separator}{mark}{separator}3\n4{separator}5{separator}6\n");
            let found = unaided(text.as_bytes());
            let found = found.unwrap_or_else(|e| panic!("{text}: {e}"));
            assert_eq!((found.grid().shape(), found.missing()), ([2, 3], 1), "{text}");
        }
    }
    let blanks = format!("{GWYDDION}1 No Data 3\n4 5 6\n");
    assert_eq!(read(&blanks).missing(), 1);
    // At the start of a line.
    assert_eq!(read(&format!("{GWYDDION}#N/A;2;3\n4;5;6\n")).missing(), 1);
    // Marks that are given: words, of several parts, numbers; not among coordinates.
    let given = |text: &str, mark: &str| {
        let options = ReadOptions::default().and(|o| o.missing.push(mark.into()));
        read_bytes(format!("{GWYDDION}{text}").as_bytes(), &options).unwrap().missing()
    };
    assert_eq!(given("1 x 3\n4 X 6\n", "x"), 2);
    assert_eq!(given("1 out of range 3\n4 5 6\n", "out of range"), 1);
    assert_eq!(given("1 -999 3\n4 -999.0 6\n", "-999"), 2);
    let list = "0 0 1\n1 0 0\n0 1 3\n1 1 4\n";
    let options = scaled().lateral(1e-6).and(|o| o.missing.push("0".into()));
    assert_eq!(read_bytes(list.as_bytes(), &options).unwrap().missing(), 1);
    // The mark that a header gives, in a list as well; what is no mark is a count.
    for (key, missing) in [
        ("nodata: -999", 1),
        ("No data value: -999", 1),
        ("NODATA_value -999", 1),
        ("nodata value -999", 1),
        ("_FillValue = -999", 1),
        ("Invalid: -999", 1),
        ("Missing points: 4", 0),
    ] {
        let list = format!("{key}\nx [um] y [um] z [nm]\n0 0 1\n1 0 -999\n0 1 3\n1 1 4\n");
        assert_eq!(read(&list).missing(), missing, "{key}");
    }
    // A column that no number stands in is missing, unless its cells are empty.
    assert_eq!(read(&format!("{GWYDDION}1,5,2,NaN\n4,3,7,NaN\n")).missing(), 2);
}

#[test]
fn what_is_not_understood_is_named() {
    for (text, place) in [
        ("1 2 x 4\n5 y 7 8\n9 8 7 6\n", "line 1, cell 3: \"x\""),
        ("1;2\n3;4\n5;6z\n", "line 3, cell 2: \"6z\""),
        ("# map\n1.0X-06;2.0X-06\n3.0X-06;4.0X-06\n", "line 2, cell 1: \"1.0X-06\""),
        ("1.2?\n1.3?\n1.4?\n", "line 1, cell 1: \"1.2?\""),
        ("1;1.#INF;3\n4;5;6\n7;8;9\n", "line 1, cell 2"),
    ] {
        let error = refusal(text, &scaled());
        assert!(error.to_string().contains(place), "{text}: {error}");
        assert_eq!(error.needs(), [Need::MissingMark], "{text}: {error}");
    }
}

#[test]
fn a_unit_that_is_overridden_need_not_be_known() {
    for unit in ["?m", "UM", "in", "a.u.", "V"] {
        let text = GWYDDION.replace("nm", unit) + "1 2\n3 4\n";
        let error = refusal(&text, &ReadOptions::default());
        assert_eq!(error.needs(), [Need::OtherHeightUnit], "{error}");
        assert!(error.to_string().contains(unit), "{error}");
        let options = ReadOptions::default().height(Always(1e-6));
        assert_eq!(heights(&text, &options)[0], 1000.0, "{unit}");
        let found = read_bytes(text.as_bytes(), &options).unwrap();
        assert_eq!(found.metadata["overridden height unit"], unit);
    }
    // Of two channels the one whose unit is a length.
    let text = format!(
        "# Channel: U\n{}1 2\n3 4\n# Channel: Z\n{GWYDDION}5 6\n7 8\n",
        GWYDDION.replace("nm", "V")
    );
    let options = ReadOptions::default().height(Always(1e-9));
    assert_eq!(heights(&text, &options)[0], 5.0);
}

#[test]
fn rows_that_the_header_declares_are_there() {
    for header in [
        "\"Horizontal\",\"3\"\n\"Vertical\",\"4\"\n",
        "ncols 3\nnrows 4\n",
        "# columns: 3\n# rows: 4\n",
    ] {
        let text = |rows: &str| format!("{header}{GWYDDION}{rows}");
        assert_eq!(read(&text("1,2,4\n4,5,9\n6,8,7\n1,3,2\n")).grid().shape(), [4, 3]);
        let error = refusal(&text("1,2,4\n4,5,9\n6,8,7\n"), &ReadOptions::default()).to_string();
        assert!(error.contains("4 rows of 3") && error.contains("3 are there"), "{error}");
    }
}

/// Headers, counts, borders and line ends do not change how many rows there are; a bad row does not pass for
/// a header, as it did in a real file.
#[test]
fn rows_begin_and_end_where_they_agree() {
    let matrix = scaled().layout(Layout::Matrix);
    for (text, shape) in [
        ("1;;\n2;;\n", [2, 3]), // a border of missing points
        (";;;\n1;;NaN;\n2;3;4;\n", [3, 3]),
        ("1;2;;\n2;3;;\n", [2, 2]),
        ("Title 5\n23\num um\n1 2\n3 4\n", [2, 2]),
        ("title\n3\n2\n1 2 3\n4 5 6\n", [2, 3]),
        ("Points 5 7\n1 2 3\n4 5 6\n", [2, 3]),
        ("5 7\na b\n1 2\n3 4\n", [2, 2]),
        ("\u{feff}1.5 2\r3 4.25\r\n\r\n", [2, 2]),
    ] {
        let found = read_bytes(text.as_bytes(), &matrix).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(found.grid().shape(), shape, "{text:?}");
    }
    for (text, words) in [
        ("1 2 x3 4\n5 6 7 8\n9 1 2 3\n", "line 1"),
        ("1 2 3 4\n5 6 7,,1 8\n9 1 2 3\n4 5 6 7\n", "line 2"),
        ("# map\n1 2 3 4\n@ @ @ @\n9 1 2 3\n4 5 6 7\n", "line 2"),
        ("1 2 3 4 5\n5 6 7 8\n9 1 2 3\n", "line 1"),
        ("0 0 1\n0.l 1 2\n1 0 3\n1 1 4\n", "line 2"),
        ("0.1;1.O\n0.2;2\n0.3;3\n", "line 1"),
        ("rows: 2\ncolumns: 2\n1\n2\n4\n3\n", "2 rows of 2"),
        ("nx: 8\nny: 2\n1 2 4 1\n4 5 9 2\n6 8 7 4\n1 3 2 3\n", "2 rows of 8"),
        ("nx: 2\nny: 3\n0 0 1\n1 0 3\n0 1 4\n1 1 5\n", "2 are there"),
        ("Width: 2 um\nHeight: 2 um\n1\n2\n4\n3\n", "not its rows"),
        ("1 2\n3 4\n5\n", "line 3"),
        ("1 2\n\n3 4\n5 x\n", "line 4"),
        ("1,5;2.5\n1;2\n", "both decimal points and decimal commas"),
    ] {
        let error = refusal(text, &scaled()).to_string();
        assert!(error.contains(words), "{text:?}: {error}");
    }
}

/// Coordinates that are rounded, repeated, uneven, or whose column is nowhere in the list.
#[test]
fn coordinates_form_a_grid() {
    let read = |text: &str| read_bytes(text.as_bytes(), &units(1.0, 1.0)).unwrap();
    let (mut sparse, mut rounded) = (String::new(), String::new());
    for (x, y) in [0, 1, 2, 4].into_iter().flat_map(|x| [-3, 1, 5].map(|y| (x, y))) {
        writeln!(sparse, "{x} {y} {}", 10 * x + y).unwrap();
    }
    let found = read(&sparse);
    assert_eq!((found.grid().shape(), found.grid().pixel()), ([3, 5], [4.0, 1.0]));
    assert_eq!((found.missing(), found.heights()[4]), (3, 37.0));
    for (iy, ix) in (0..20).flat_map(|iy| (0..30).map(move |ix| (iy, ix))) {
        let (x, y) = (0.156 * f64::from(ix), 0.31 * f64::from(iy));
        writeln!(rounded, "{x:.1} {y:.2} 1").unwrap();
    }
    let grid = read(&rounded).grid();
    assert!(grid.shape() == [20, 30] && (grid.pixel()[1] - 4.5 / 29.0).abs() < 1e-12, "{grid:?}");
    let error = refusal("0 0 1\n1 0 1\n0 1 1\n0 1 2\n", &units(1.0, 1.0)).to_string();
    assert!(error.contains("already in the list"), "{error}");
    for (x, is_even) in [
        (&["0.0", "0.2", "0.3", "0.5"][..], true),
        (&["0e-7", "2e-7", "3e-7", "5e-7"], true),
        (&["0", "1", "2", "4", "5"], false),
        (&["0", "1", "2.5", "3"], false),
    ] {
        let text = x.join(" 1\n") + " 1\n";
        assert_eq!(read(&text).uneven.is_none(), is_even, "{text}");
    }
}
