//! Forms of single formats beside the sample: sizes, scales and refusals as their files state them.

use crate::common::{assert_refused, replace, unaided};
use surface_io::Measurement;

/// Heights by their number (m).
type Heights = [(usize, f64)];

fn assert_read(found: &Measurement, shape: [usize; 2], pixel: [f64; 2], heights: &Heights) {
    assert_eq!(found.grid().shape(), shape);
    let heights = heights.iter().map(|(i, right)| (found.heights()[*i], *right));
    for (found, right) in found.grid().pixel().into_iter().zip(pixel).chain(heights) {
        assert!((found / right - 1.0).abs() < 1e-12, "{found:e}, not {right:e}");
    }
}

/// Panics unless the file with each first text replaced by the second is refused with the third.
fn assert_changes_refused(file: &str, changes: &[[&str; 3]]) {
    for [from, to, word] in changes {
        assert_refused(unaided(file.replace(from, to)), &[word]);
    }
}

/// 2 rows of 3 points: a line is a column.
#[test]
fn opd_as_text() {
    let file = "Wyko ASCII Data File Format 0\t0\t1\nX Size\t3\nY Size\t2\n\
                Block Name\tType\tLength\tValue\nPixel_size\t7\t4\t0.002\nAspect\t7\t4\t1.5\n\
                Wavelength\t7\t4\t500\nMult\t7\t4\t2\nRAW_DATA\t3\t24\t\n1\t4\n2\tBad\n3\t6\n";
    for (flag, unit) in [("0\t0\t1", 250e-9), ("0\t1\t1", 1e-9)] {
        let found = unaided(file.replace("0\t0\t1", flag)).unwrap();
        let heights =
            [(0, 1.0), (1, 2.0), (2, 3.0), (3, 4.0), (5, 6.0)].map(|(i, h)| (i, h * unit));
        assert_read(&found, [2, 3], [3e-6, 2e-6], &heights);
        assert_eq!(found.missing(), 1);
    }
    assert_changes_refused(
        file,
        &[["3\t6\n", "3\n", "line 12"], ["3\t6\n", "", "line 12"], ["500", "0", "Wavelength"]],
    );
}

#[test]
fn softgauge_in_xml() {
    let file = "<?xml version='1.0' encoding='UTF-8'?>\n<?xml-stylesheet type=\"text/xsl\" \
                href=\"data.xsl\"?>\n<!DOCTYPE DATA SYSTEM \"data.dtd\">\n<DATA><PART><PART_NAME>sine\
                </PART_NAME></PART><DATAFILE>\n<UNITS>um</UNITS><NUMPOINTS>4</NUMPOINTS>\
                <SPACING>0.5</SPACING>\n<KCAL>1um/mv</KCAL><DATA_TYPE>2D</DATA_TYPE>\n\
                <DATA_POINT_VALUES>0.0\n0.0079\n-1.0E-4\n2</DATA_POINT_VALUES></DATAFILE></DATA>\n";
    let found = unaided(file).unwrap();
    assert!(found.is_profile());
    assert_eq!(found.metadata["PART/PART_NAME"], "sine");
    let heights = [(1, 7.9e-9), (2, -1e-10), (3, 2e-6)];
    assert_read(&found, [1, 4], [0.5e-6; 2], &heights);
    assert_changes_refused(
        file,
        &[
            ["<NUMPOINTS>4", "<NUMPOINTS>5", "4 heights"],
            ["2D", "3D", "type 3D"],
            ["0.0079", "0.oo79", "point 2"],
            ["\"data.dtd\">", "\"data.dtd\" [<!ENTITY e \"1\">]>", "document type"],
        ],
    );
}

/// A list of columns and rows; intensity, then phase.
#[test]
fn zygo_as_text() {
    let header = |first: &str| {
        format!(
            "{first}\n0 9 2 0 \"date\"\n0 0 3 2 1 255\n10 20 3 2\n\"plate\"\n\"\"\n\"\"\n\
             0 0.5 6.4e-07 0.5 1 0 5.0e-06 1787677163\n1200 1200 0 0 1 0 \"\"\n0 0 1\n1 1 100\n\
             0 \"\"\n1 0.01\n"
        )
    };
    let head = header("Zygo XYZ Data File - Format 1");
    let list =
        format!("{head}#\n10 20 1.5\n11 20 2\n12 20 3\n10 21 4\n11 21 No Data\n12 21 -6\n#\n");
    let head = header("Zygo ASCII Data File - Format 2");
    let phase = format!("{head}\"\"\n#\n1 2 3\n4 5 6\n#\n32768 0 -65536\n2147483640 1 2\n#\n");
    for (file, heights) in
        [(&list, [(0, 1.5e-6), (5, -6e-6)]), (&phase, [(0, 3.2e-7), (2, -6.4e-7)])]
    {
        let found = unaided(file).unwrap();
        assert_read(&found, [2, 3], [5e-6; 2], &heights);
        assert_eq!(found.missing(), 1);
    }
    assert_changes_refused(
        &list,
        &[
            ["12 21", "13 21", "not in the map"],
            ["3\n10 21 4\n11 21 No Data\n12 21 -6\n#\n", "3\n", "cut off"],
            ["No Data", "nothing", "no height"],
        ],
    );
}

const NANOSCOPE: &str = "\\Bytes/pixel: 2\r\n\\Samps/line: 8\r\n\\Number of lines: 4\r\n";

/// An image of 8 x 4 points of 10 um along x in sections as a file of NanoScope has them.
fn nanoscope(scan: &str, image: &str, bytes: usize) -> Vec<u8> {
    let header = format!(
        "\\*File list\r\n\\Version: 0x05120000\r\n\\*Ciao scan list\r\n{scan}\
         \\@Sens. Zsens: V 10.0 nm/V\r\n\\*Ciao image list\r\n\\Data offset: 2048\r\n\
         {NANOSCOPE}{image}\\@2:Image Data: S [Height] \"Height\"\r\n\
         \\@2:Z scale: V [Sens. Zsens] (0.1 V/LSB) 6553.6 V\r\n\\*File list end\r\n\x1a"
    );
    let mut file = header.into_bytes();
    file.resize(2048, 0);
    file.extend((0..bytes).map(|i| if i % 2 == 0 { (i / 2) as u8 } else { 0 }));
    file
}

/// Sizes of 8 x 4 points: by aspect ratio, slow axis, two numbers, and of a part of a scan.
#[test]
fn nanoscope_along_the_slow_axis() {
    let [aspect, size] = ["\\Aspect Ratio: 2:1\r\n", "\\Scan Size: 10 10 ~m\r\n"];
    let lines = |n: usize| format!("\\Lines: {n}\r\n");
    let scan = |n: usize, more: &str| lines(n) + "\\Samps/line: 8\r\n" + more;
    for (scan, of_image, dy) in [
        (lines(4), format!("{aspect}{size}"), 10.0 / 8.0),
        (lines(4), format!("{aspect}\\Scan Size: 10 ~m\r\n"), 10.0 / 8.0),
        (String::new(), format!("{aspect}\\Scan Size: 10 5 ~m\r\n"), 10.0 / 8.0),
        (String::new(), format!("\\Aspect Ratio: 1:1\r\n{size}"), 10.0 / 4.0),
        (String::new(), "\\Scan Size: 10 7 ~m\r\n".into(), 7.0 / 4.0),
        (lines(4) + "\\Slow Axis Size: 3000 nm\r\n", size.into(), 3.0 / 4.0),
        // Stopped after 4 of 8 lines, of 16 lines.
        (scan(8, ""), size.into(), 10.0 / 8.0),
        (scan(8, ""), format!("{aspect}{size}"), 10.0 / 8.0),
        (scan(16, "\\Slow Axis Size: 4 ~m\r\n"), format!("\\Aspect Ratio: 10:1\r\n{size}"), 0.25),
        (scan(6, aspect), format!("\\Aspect Ratio: 3:1\r\n{size}"), 5.0 / 6.0),
    ] {
        let found = unaided(nanoscope(&scan, &of_image, 64)).unwrap();
        assert_read(&found, [4, 8], [1e-6 * dy, 1.25e-6], &[]);
    }
}

/// 3 of 4 lines are stored: they are read, with the spacing of the whole; the top line is the last.
/// Points of 4 bytes from version 9.2 are scaled as if they had 2.
#[test]
fn nanoscope_lines_and_bytes_that_are_there() {
    let image = "\\Data length: 48\r\n\\Scan Size: 10 10 ~m\r\n";
    let found = unaided(nanoscope("", image, 48)).unwrap();
    assert_read(&found, [3, 8], [2.5e-6, 1.25e-6], &[(0, 16e-9)]);
    assert!(unaided(nanoscope("", &image.replace("10 10 ~m", "10 V"), 48)).is_err());
    // Cut off on the way, which the stated length shows.
    assert!(unaided(nanoscope("", &image.replace("48", "64"), 48)).is_err());
    let mut wide = nanoscope("", &image.replace("48", "128"), 0);
    replace(&mut wide, b"0x0512", b"0x0920");
    wide.extend((0..32i32).flat_map(|i| (40_000 - 3_000 * i).to_le_bytes()));
    let found = unaided(&wide).unwrap();
    assert_read(&found, [4, 8], [2.5e-6, 1.25e-6], &[(7, -53e-6), (24, 40e-6)]);
}

#[test]
fn nanoscope_with_other_beginnings() {
    let image = "\\Scan Size: 10 10 ~m\r\n";
    let plain = nanoscope("", image, 64);
    let mut other = [b"\\*EC ", &plain[2..]].concat();
    replace(&mut other, b"2048", b"2051");
    assert_eq!(unaided(&other).unwrap().heights(), unaided(&plain).unwrap().heights());
    assert_refused(unaided([b"?", &plain[1..]].concat()), &["as text"]);
    let end = plain.iter().position(|byte| *byte == 0x1a).unwrap();
    let export = [&plain[..end], b"\r\nHeight(nm)\r\n1.5\r\n2\r\n1\r\n"].concat();
    assert_refused(unaided(&export), &["text: the file gives no pixel size ("]);
    // WSxM's are texts as well.
    let wsxm = "WSxM file copyright UAM\nWSxM ASCII XYZ file\nX[nm]\tY[nm]\tZ[nm]\n\n";
    let wsxm = format!("{wsxm}0\t0\t1\n2\t0\t2\n0\t3\t4\n2\t3\t5\n");
    assert_read(&unaided(wsxm).unwrap(), [2, 2], [3e-9, 2e-9], &[(3, 5e-9)]);
    let curve = nanoscope("\\Operating mode: Force\r\n", image, 64);
    assert_refused(unaided(&curve), &["force curve"]);
}

/// What marks a missing point in ISO is a height in BCR, and the other way round.
#[test]
fn sdf_of_both_standards() {
    let bcr = "aBCR-1.0 ; first\nNumPoints = 3\nNumProfiles = 2 ; of 3\nXscale = 2e-6\n; or not\n\
               Yscale = 3e-6\nZscale = 1e-9\nCompression = NULL\nDataType = INTEGER ; or 5\n* ; end\n\
               ; six points\n1 2 32767\n-32768 5 6 ; last\n*\nShift = 1\n*\n";
    let iso = bcr.replace("BCR", "ISO");
    for (file, height) in [(bcr, (3, -32_768e-9)), (&iso, (2, 32_767e-9))] {
        let found = unaided(file).unwrap();
        assert_read(&found, [2, 3], [3e-6, 2e-6], &[height, (5, 6e-9)]);
        assert_eq!(found.missing(), 1);
    }
}

#[test]
fn meshes_are_named_with_the_way_out() {
    let text = b"solid part\n  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n";
    let mut binary = vec![0; 84 + 2 * 50];
    binary[80] = 2;
    for mesh in [&text[..], b" SOLID\r\nFACET NORMAL 0 0 1\r\n", &binary] {
        assert_refused(unaided(mesh), &["an STL mesh", "grid"]);
    }
    binary.push(0);
    for other in [b"solid steel, measured\n1 2 3 4\n5 6 7 8\n", &binary[..]] {
        assert!(!unaided(other).unwrap_err().to_string().contains("STL"));
    }
}
