//! Damaged and hostile files: a typed error or a right answer, never a panic, within the limits.

use crate::common::binary::{gzip, npy, x3p_main, zip};
use crate::common::{SampleFile, SayMore as _, assert_refused, assert_sample, samples, unaided};
use std::fmt::Write as _;
use surface_io::{FORMATS, Layout, Limits, ReadError, ReadOptions, read_bytes};

/// Where the heights of an X3P file are.
const LINK: &str = "<DataLink><PointDataLink>d</PointDataLink></DataLink>";

/// Small limits: a file of a few kilobytes has no business asking for more.
fn tight() -> Limits {
    Limits { file_bytes: 1 << 20, unpacked_bytes: 1 << 20, points: 1 << 16, items: 1 << 10 }
}

/// In the midst of zeros that fill a file up: one such byte is as good as the next.
fn is_padding(bytes: &[u8], at: usize) -> bool {
    let around = bytes.get(at.saturating_sub(8)..(at + 8).min(bytes.len()));
    at >= 8 && around.is_some_and(|around| around.iter().all(|&byte| byte == 0))
}

#[test]
fn every_prefix_is_refused_or_right() {
    for sample in samples() {
        let mut options = sample.options.clone();
        options.limits = tight();
        for length in (0..sample.bytes.len()).filter(|&at| !is_padding(&sample.bytes, at)) {
            let found = read_bytes(&sample.bytes[..length], &options);
            // The end of a text file and of some trailers cannot be missed by anyone.
            if let Ok(found) = found
                && !sample.is_text
            {
                assert_sample(sample.name, &found, sample.can_miss);
            }
        }
    }
}

#[test]
fn every_single_byte_corruption_is_survived() {
    let corrupt = |sample: &SampleFile| {
        let mut options = sample.options.clone();
        options.limits = tight();
        let mut bytes = sample.bytes.clone();
        for at in (0..bytes.len()).filter(|&at| !is_padding(&sample.bytes, at)) {
            let original = bytes[at];
            for value in [0, 0xff, 0x7f, original ^ 0x80, original ^ 1, b'9', b'-'] {
                bytes[at] = value;
                if let Ok(found) = read_bytes(&bytes, &options) {
                    let [ny, nx] = found.grid().shape();
                    let [dy, dx] = found.grid().pixel();
                    assert_eq!(ny * nx, found.heights().len(), "{}, byte {at}", sample.name);
                    assert!((ny * nx) as u64 <= tight().points, "{}, byte {at}", sample.name);
                    assert!(dy > 0.0 && dx > 0.0);
                    assert!(!found.heights().iter().any(|h| h.is_infinite()));
                }
            }
            bytes[at] = original;
        }
    };
    let samples = samples();
    std::thread::scope(|scope| {
        for first in [0, 1] {
            let half = samples.iter().skip(first).step_by(2);
            scope.spawn(move || half.for_each(corrupt));
        }
    });
}

/// Whole and cut. Fuzzing found a reader that failed on a file shorter than its magic number.
#[test]
fn every_reader_survives_every_file() {
    for spec in FORMATS {
        for sample in samples() {
            for length in [0, 1, 3, 4, 5, 8, 17, 33, 100, 400, sample.bytes.len()] {
                let bytes = &sample.bytes[..length.min(sample.bytes.len())];
                for layout in [None, Some(Layout::Matrix), Some(Layout::List), Some(Layout::Traces)]
                {
                    let mut options = sample.options.clone().and(|o| o.limits = tight());
                    options.layout = layout;
                    if let Ok(found) = spec.read(bytes, &options) {
                        let [ny, nx] = found.grid().shape();
                        assert_eq!(found.heights().len(), ny * nx);
                    }
                }
            }
        }
    }
}

#[test]
fn sizes_that_claim_terabytes() {
    let over = npy("<f8", false, "(18446744073709551615, 2)", &[0; 64]);
    assert!(matches!(unaided(&over), Err(ReadError::Limit { .. } | ReadError::Malformed { .. })));
    let main = x3p_main("D", "", LINK).replace("<SizeX>7", "<SizeX>70000000000");
    let x3p = zip(&[("main.xml", main.as_bytes()), ("d", &[0; 64])]);
    for file in [npy("<f8", false, "(1000000, 1000000)", &[0; 64]), x3p] {
        let error = unaided(&file).unwrap_err();
        assert!(matches!(error, ReadError::Limit { .. }), "{error}");
    }
}

#[test]
fn a_mask_that_is_not_there() {
    let link = LINK.replace("</DataLink>", "<ValidPointsLink>m</ValidPointsLink></DataLink>");
    let file = zip(&[("main.xml", x3p_main("D", "", &link).as_bytes()), ("d", &[0; 280])]);
    assert_refused(unaided(&file), &["ValidPointsLink: the archive has no member \"m\""]);
}

/// 64 MiB of zeros in 64 KiB: refused at the limit, not unpacked.
#[test]
fn decompression_bomb() {
    let zeros = vec![0u8; 64 << 20];
    let member = zip(&[("main.xml", x3p_main("D", "", LINK).as_bytes()), ("d", &zeros)]);
    let options = ReadOptions::default().and(|o| o.limits = tight());
    for file in [member, gzip(&zeros), zip(&[("d.txt", &zeros)])] {
        assert!(file.len() < 1 << 17);
        let error = read_bytes(&file, &options).unwrap_err();
        assert!(matches!(error, ReadError::Limit { quantity: "unpacked bytes", .. }), "{error}");
    }
}

#[test]
fn xml_with_entities_is_refused() {
    let main = x3p_main("D", "", "<DataList><Datum>&e;</Datum></DataList>");
    let laughs = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY e \"&a;&a;&a;&a;\">]>";
    let external = "<!DOCTYPE x [<!ENTITY e SYSTEM \"file:///etc/passwd\">]>";
    for declaration in [laughs, external, ""] {
        let main = main.replace("\n<p:", &format!("{declaration}\n<p:"));
        let error = unaided(zip(&[("main.xml", main.as_bytes())])).unwrap_err().to_string();
        assert!(error.contains("document type") || error.contains("not expanded"), "{error}");
    }
    let deep = format!("{}{}", "<a>".repeat(100_000), "</a>".repeat(100_000));
    assert_refused(unaided(zip(&[("main.xml", deep.as_bytes())])), &["deeper than 32"]);
}

#[test]
fn spacings_that_are_none() {
    for bad in ["0", "-1e-6", "nan", "1e400", ""] {
        let main = x3p_main("D", "", LINK).replace("<Increment>2e-6", &format!("<Increment>{bad}"));
        let file = zip(&[("main.xml", main.as_bytes()), ("d", &[0; 280])]);
        let error = unaided(&file).unwrap_err();
        assert!(matches!(error, ReadError::Malformed { .. }), "{bad}: {error}");
    }
    let text = b"# Width: -2 um\n# Height: 2 um\n# Value units: nm\n1 2\n3 4\n";
    assert!(matches!(unaided(text), Err(ReadError::Malformed { .. })));
}

/// In proportion to its length: what is asserted is that the text is read within the time of the
/// test run; a quadratic reader would need hours.
#[test]
fn long_text_is_read_in_linear_time() {
    let mut text = String::from("x [um] y [um] z [nm]\n");
    let n = 700;
    for iy in 0..n {
        for ix in 0..n {
            writeln!(text, "{ix} {iy} {}", ix * iy).unwrap();
        }
    }
    let found = unaided(text.as_bytes()).unwrap();
    assert_eq!(found.grid().shape(), [n, n]);
    // One line of a million numbers, and a million lines of header.
    let long = format!("{}\n{}\n", "1 ".repeat(1_000_000), "2 ".repeat(1_000_000));
    let error = unaided(long.as_bytes()).unwrap_err();
    assert!(matches!(error, ReadError::MissingScale { .. }), "{error}");
    let header = "# nothing\n".repeat(1_000_000);
    let error = unaided(header.as_bytes()).unwrap_err();
    assert!(matches!(error, ReadError::Limit { .. } | ReadError::UnknownFormat { .. }), "{error}");
}
