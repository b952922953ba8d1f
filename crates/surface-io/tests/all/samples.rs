//! Every format gives the same surface, from bytes and from a file.

use crate::common::instruments::netcdf;
use crate::common::{
    self, SayMore as _, assert_refused, assert_sample, replace, sample, samples, scaled, unaided,
    units,
};
use surface_io::HeightUnit::{Always, IfSilent};
use surface_io::{
    Cut, FORMATS, Fill, FillError, Layout, Need, ReadError, ReadOptions, read, read_bytes,
};

#[test]
fn every_sample_is_read_right() {
    for sample in samples() {
        let found = sample.read().unwrap_or_else(|e| panic!("{}: {e}", sample.name));
        assert_sample(sample.name, &found, sample.can_miss);
        assert!(!found.is_profile());
    }
}

/// What the file does not say is told; what it says is kept, or overridden.
#[test]
fn what_the_file_does_not_say_is_needed() {
    for sample in samples() {
        let Err(error) = unaided(&sample.bytes) else { continue };
        assert!(matches!(error, ReadError::MissingScale { .. }), "{}: {error}", sample.name);
        let text = error.to_string();
        assert!(error.needs().contains(&Need::PixelSize), "{text}");
        assert!(text.contains("1001 points over 1 mm") && !text.contains("--"), "{text}");
    }
    let text = b"# Width: 2 um\n# Height: 2 um\n# Value units: nm\n1 2\n3 4\n";
    let [kept, overridden] = ["height unit of the file, kept", "overridden height unit"];
    for (given, metres, noted) in [
        (IfSilent(1e-6), 1e-9f64, Some(kept)),
        (IfSilent(1e-9), 1e-9, None),
        (Always(1e-6), 1e-6, Some(overridden)),
    ] {
        let found = read_bytes(text, &ReadOptions::default().height(given)).unwrap();
        assert_eq!(found.heights()[3].to_bits(), (4.0 * metres).to_bits());
        for note in [kept, overridden] {
            let unit = found.metadata.get(note).map(String::as_str);
            assert_eq!(unit, (noted == Some(note)).then_some("nm"));
        }
    }
}

/// All are read, or the one asked for. A single column of heights is one trace.
#[test]
fn several_traces_stand_beside_their_positions() {
    use surface_io::read_traces_bytes;
    let text = b"X [mm];Z1 [um];Z2 [um];Z3 [um]\n0.000;1;4;7\n0.001;2;5;8\n0.002;3;6;9\n";
    let traces = read_traces_bytes(text, &ReadOptions::default()).unwrap();
    let names: Vec<&str> = traces.iter().map(|trace| trace.channel.as_str()).collect();
    assert_eq!(names, ["Z1", "Z2", "Z3"]);
    for (k, trace) in traces.iter().enumerate() {
        assert!(trace.is_profile() && trace.channels.len() == 3);
        assert!((trace.grid().pixel()[1] - 1e-6).abs() < 1e-15);
        let first = 1e-6 * (3 * k + 1) as f64;
        assert!((trace.heights()[0] - first).abs() < 1e-15, "{trace:?}");
    }
    let one = read_traces_bytes(text, &ReadOptions::default().channel("Z2")).unwrap();
    assert_eq!((one.len(), one[0].channel.as_str()), (1, "Z2"));
    let plain = b"0 1 4\n1 2 5\n2 3 6\n";
    let given = units(1e-6, 1e-9);
    let traces = read_traces_bytes(plain, &given.clone().layout(Layout::Traces)).unwrap();
    assert_eq!(traces.len(), 2);
    assert_eq!(traces[1].channel, "trace 2");
    let pair = read_traces_bytes(b"0 1\n1 2\n2 3\n", &given.clone().layout(Layout::Traces));
    assert_eq!(pair.unwrap().len(), 1);
    assert!(read_traces_bytes(b"1\n2\n3\n", &given.layout(Layout::Traces)).is_err());
}

/// A tester's workbook is a profile; another workbook is refused with its sheets.
#[test]
fn a_workbook_of_a_roughness_tester() {
    let file = common::microscopes::mitutoyo(&[]);
    let found = unaided(&file).unwrap();
    assert!(found.is_profile() && found.uneven.is_none());
    assert_eq!(found.grid().shape(), [1, 5]);
    assert!((found.grid().pixel()[1] / 1.5e-6 - 1.0).abs() < 1e-12);
    assert!((found.heights()[4] - 2e-6).abs() < 1e-18);
    for length in 0..file.len() {
        let _ = unaided(&file[..length]);
    }
    let shifted = common::microscopes::mitutoyo(&["E3", "F4"]);
    assert_refused(unaided(&shifted), &["4 positions in column E, 4 heights in F: every row"]);
    // A reference that is none stays as it is written.
    for (written, read) in [("R&amp;D", "R&D"), ("R&d", "R&d")] {
        let sheets =
            format!("<workbook><sheets><sheet name=\"{written}\" id=\"1\"/></sheets></workbook>");
        let other = common::binary::zip(&[
            ("xl/workbook.xml", sheets.as_bytes()),
            ("xl/_rels/workbook.xml.rels", b"<r><Relationship Id=\"1\" Target=\"a\"/></r>"),
        ]);
        assert_refused(unaided(&other), &["DATA", &format!("this has {read};"), "CSV"]);
    }
}

/// Channels are chosen by what they are, and one that cannot be read does not cost the others.
#[test]
fn the_topography_is_read_and_a_bad_channel_costs_nothing() {
    let jpk = sample("jpk");
    let found = jpk.read().unwrap();
    assert_eq!((found.channel.as_str(), found.channels.len()), ("Height (retrace)", 2));
    let other = jpk.options.clone().channel("error");
    assert_eq!(read_bytes(&jpk.bytes, &other).unwrap().channel, "Error (retrace)");
    let lext = sample("lext");
    let found = lext.read().unwrap();
    assert_eq!(found.channel.as_str(), "HEIGHT");
    // Two bytes a point become three: the channel of the thumbnail is at fault, no other.
    let mut broken = lext.bytes.clone();
    let bits = broken.windows(4).position(|w| w == [2, 1, 3, 0]).unwrap() + 8;
    broken[bits] = 24;
    let found = read_bytes(&broken, &lext.options).unwrap();
    assert!(found.channels[0].fault.as_ref().is_some_and(|fault| fault.contains("24 bits")));
    assert_refused(read_bytes(&broken, &lext.options.clone().channel("#1")), &["24 bits"]);
}

/// Of an OIR file the heights are read and not the picture, of a packed one also where another member is broken.
#[test]
fn heights_are_read_beside_pictures_and_broken_members() {
    let oir = sample("oir");
    let found = oir.read().unwrap();
    assert_eq!((found.channel.as_str(), found.channels.len()), ("HEIGHT", 2));
    assert!(found.channels[0].fault.as_ref().is_some_and(|fault| fault.contains("24 bits")));
    assert_eq!(found.metadata["date"], "2026-11-23");
    let packed = sample("oir, packed");
    let found = packed.read().unwrap();
    assert_eq!((found.channel.as_str(), found.channels.len()), ("a.oir: HEIGHT", 3));
    assert!(found.channels[2].fault.is_some());
    let mut short = oir.bytes.clone();
    replace(&mut short, b"c1_0", b"c1_5");
    let chosen = oir.options.clone().channel("HEIGHT");
    assert_refused(read_bytes(&short, &chosen), &["0 bytes in 0 pieces, 70 are needed"]);
    let mut other = oir.bytes;
    other[72..80].copy_from_slice(b"FLUOVIEW");
    assert_refused(read_bytes(&other, &oir.options), &["fluorescence"]);
}

#[test]
fn an_archive_without_its_end_is_called_one() {
    let whole = common::binary::zip(&[("map.txt", &[b'1'; 999])]);
    assert_eq!(unaided(&whole[..60]).unwrap_err().kind(), "malformed");
    assert_refused(unaided(&whole[..60]), &["ZIP"]);
}

/// A list without units has steps: the unit of x and y is needed, not the pixel.
#[test]
fn a_list_needs_the_unit_of_its_coordinates() {
    let list = b"x y z\n0 0 1\n1 0 2\n0 2 3\n1 2 4\n";
    let error = read_bytes(list, &ReadOptions::default().height(IfSilent(1e-3))).unwrap_err();
    assert_eq!(error.needs(), [Need::LateralUnit]);
    let error = unaided(list).unwrap_err();
    assert_eq!(error.needs(), [Need::LateralUnit, Need::HeightUnit]);
    let found = read_bytes(list, &units(1e-6, 1e-3)).unwrap();
    let [dy, dx] = found.grid().pixel();
    assert!((dy / 2e-6 - 1.0).abs() < 1e-12 && (dx / 1e-6 - 1.0).abs() < 1e-12);
}

#[test]
fn fill_is_refused_with_the_way_out() {
    let sample = &samples()[0];
    let found = sample.read().unwrap();
    let error = found.clone().fill(Fill::Refuse).unwrap_err();
    assert_eq!(error, FillError::Missing { missing: 1, points: 35, first: [1, 2] });
    assert_eq!(error.needs(), [Need::Fill]);
    // The surface is a plane, so the harmonic continuation is exact.
    let filled = found.clone().fill(Fill::Harmonic).unwrap();
    assert!((filled.at(1, 2) - 102e-9).abs() < 1e-18);
    assert!((found.clone().fill(Fill::Nearest).unwrap().at(1, 2) - 101e-9).abs() < 1e-18);
    // Away from the hole a crop is complete.
    let part = found.crop(Cut::Rectangle([2, 1, 3, 4])).unwrap();
    assert_eq!((part.missing(), part.grid().shape()), (0, [3, 4]));
    assert!((part.fill(Fill::Refuse).unwrap().at(0, 0) - 201e-9).abs() < 1e-18);
    for bad in [[0, 0, 0, 1], [0, 0, 6, 1], [4, 6, 1, 2], [usize::MAX, 0, 2, 2]] {
        assert!(matches!(found.crop(Cut::Rectangle(bad)), Err(ReadError::Crop { .. })));
    }
    // The hole is in row 1, column 2 of 5 x 7 points: below it are 3 x 7, right of it 5 x 4.
    assert_eq!(found.crop(Cut::Complete).unwrap().cropped, Some([2, 0, 3, 7]));
    // A part of a part is said as one of the map.
    let part = found.crop(Cut::Middle).unwrap();
    assert_eq!((part.cropped, part.missing()), (Some([1, 1, 3, 4]), 1));
    let inner = part.crop(Cut::Complete).unwrap();
    assert_eq!((inner.cropped, inner.missing()), (Some([2, 1, 2, 4]), 0));
    let line = found.crop(Cut::Rectangle([0, 0, 2, 3])).unwrap();
    let all_gone = line.crop(Cut::Rectangle([0, 1, 2, 2])).unwrap();
    assert!(matches!(all_gone.crop(Cut::Complete), Err(ReadError::NothingComplete([2, 2]))));
}

#[test]
fn profiles_know_their_spacing() {
    let even = b"X_(microns),z [nm]\n0.0,1\n0.2,2\n0.3,3\n0.5,4\n0.6,5\n";
    let found = unaided(even).unwrap();
    assert!(found.is_profile() && found.uneven.is_none());
    assert!((found.grid().pixel()[1] - 0.15e-6).abs() < 1e-20); // range / (N - 1)
    let uneven = b"x [um];z [nm];valid\n0.0;1;1\n1.0;2;0\n2.5;3;1\n3.0;4;1\n";
    let found = unaided(uneven).unwrap();
    assert_eq!((found.missing(), found.grid().shape()), (1, [1, 4]));
    assert!(matches!(found.fill(Fill::Nearest), Err(FillError::Uneven { .. })));
    let falling = b"x [um]\tz [nm]\n3\t1\n2\t2\n1\t3\n";
    let found = unaided(falling).unwrap();
    assert!((found.heights()[0] - 3e-9).abs() < 1e-20); // sorted by x
}

#[test]
fn a_pixel_against_the_coordinates_is_refused() {
    let list = b"0 0 1\n1 0 2\n0 2 3\n1 2 4\n0 4 5\n1 4 6\n";
    let error = read_bytes(list, &scaled(1e-6, 1.0)).unwrap_err();
    assert!(matches!(error, ReadError::PixelContradicts { .. }), "{error}");
    let options = scaled(1e-6, 1.0).and(|o| o.pixel = Some([2e-6, 1e-6]));
    assert_eq!(read_bytes(list, &options).unwrap().grid().shape(), [3, 2]);
}

/// What they are taken for is said unless it is plain, and a refusal names both readings.
#[test]
fn three_bare_columns_are_a_list_unless_told_otherwise() {
    let scaled = |layout| scaled(1e-6, 1.0).and(|o| o.layout = layout);
    let shape = |text: &str, layout| {
        let found = read_bytes(text.as_bytes(), &scaled(layout)).unwrap();
        (found.grid().shape(), found.ambiguity.is_some())
    };
    // Two points a side may be heights; three, all there, are not by chance.
    let small = "0 0 5\n0 1 6\n1 0 7\n1 1 8\n";
    assert_eq!(shape(small, None), ([2, 2], true));
    assert_eq!(shape(small, Some(Layout::List)), ([2, 2], false));
    assert_eq!(shape(small, Some(Layout::Matrix)), ([4, 3], false));
    assert_eq!(shape(&format!("x y z\n{small}"), None), ([2, 2], false));
    let list = "0 0 0\n0 1 1\n0 2 2\n1 0 3\n1 1 4\n1 2 5\n2 0 6\n2 1 7\n2 2 8\n";
    assert_eq!(shape(list, None), ([3, 3], false));
    assert_eq!(shape(list.rsplit_once("2 2").unwrap().0, None), ([3, 3], true));
    let heights = read_bytes(small.as_bytes(), &scaled(Some(Layout::Matrix))).unwrap();
    assert_eq!(heights.heights()[9..], [1.0, 1.0, 8.0]);

    for text in ["1 2 3\n4 5 6\n7 8 9\n", "0.3 0.1 7\n0.7 0.2 1\n0.9 1.5 3\n", "1 1 0\n1 1 2\n"] {
        let error = read_bytes(text.as_bytes(), &scaled(None)).unwrap_err();
        assert!(error.to_string().contains("list x y z"), "{error}");
        assert_eq!(error.needs().last(), Some(&Need::Layout(Layout::Matrix)), "{error}");
        assert_eq!(shape(text, Some(Layout::Matrix)).0, [text.lines().count(), 3]);
        assert!(read_bytes(text.as_bytes(), &scaled(Some(Layout::List))).is_err());
    }
    // Columns that are named are what their names say.
    let error = read_bytes(b"x [um] y [um] z [um]\n1 2 3\n4 5 6\n7 8 9\n", &scaled(None));
    assert!(error.unwrap_err().needs().is_empty());
    assert_eq!(shape("1 5\n2 3\n", None), ([1, 2], true));
    assert_eq!(shape("1 5\n2 3\n", Some(Layout::Matrix)), ([2, 2], false));
    let four = read_bytes(b"1 2 3 4\n5 6 7 8\n", &scaled(Some(Layout::List))).unwrap();
    assert_eq!((four.missing(), four.channels.len()), (2, 2));
    let map = sample("npy");
    let error = read_bytes(&map.bytes, &scaled(Some(Layout::Matrix))).unwrap_err();
    assert!(matches!(error, ReadError::BadLayout { .. }), "{error}");
}

#[test]
fn files_that_are_none() {
    let options = ReadOptions::default();
    assert!(matches!(read_bytes(b"", &options), Err(ReadError::Empty)));
    assert!(matches!(read_bytes(b"\0\x01junk", &options), Err(ReadError::UnknownFormat { .. })));
    assert!(matches!(read_bytes(b"no numbers", &options), Err(ReadError::UnknownFormat { .. })));
    let column = read_bytes(b"1\n2\n3\n", &options).unwrap_err();
    assert_eq!(column.needs(), [Need::PixelSize, Need::HeightUnit], "{column}");
    let error = read_bytes(b"\x89HDF\r\n\x1a\n\0\0\0\0", &options).unwrap_err();
    assert!(matches!(error, ReadError::Malformed { .. }), "{error}");
    assert_refused(read_bytes(b"OLYMPUSRAWFORMAT\x0c\0\0\0", &options), &["OIR", "byte 72"]);
    assert_refused(unaided(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1\0\0"), &["SUR"]);
    let several =
        common::binary::zip(&[("a/one.txt", b"1 2"), ("a/two.txt", b"3"), ("__MACOSX/x", b"")]);
    assert_refused(read_bytes(&several, &options), &["2 files (a/one.txt, a/two.txt)"]);
    let here = env!("CARGO_MANIFEST_DIR");
    assert_refused(read(here, &options), &["directory"]);
    let error = read(format!("{here}/none.x3p"), &options).unwrap_err();
    assert!(error.to_string().contains("none.x3p") && error.kind() == "io");
    // Infinite heights are no marks for missing points in text.
    let infinite = b"# Width: 2 um\n# Height: 2 um\n# Value units: nm\n1 inf\n3 4\n";
    assert!(matches!(read_bytes(infinite, &options), Err(ReadError::Malformed { .. })));
    for pixel in [[0.0, 1.0], [1.0, -1.0], [f64::NAN, 1.0], [f64::INFINITY, 1.0]] {
        let options = ReadOptions::default().and(|o| o.pixel = Some(pixel));
        let error = read_bytes(&samples()[0].bytes, &options).unwrap_err();
        assert!(matches!(error, ReadError::BadOption { .. }), "{error}");
    }
}

/// Seeds for the fuzz targets, one folder per format: `fuzz/seeds/<format>/`.
#[test]
#[ignore = "writes files: seeds for cargo fuzz"]
fn write_fuzz_seeds() {
    let seeds = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds");
    for (number, sample) in samples().into_iter().enumerate() {
        let found = sample.read().unwrap();
        let spec = FORMATS.iter().find(|spec| spec.name == found.format).unwrap();
        let folder = seeds.join(spec.extensions[0]);
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join(number.to_string()), &sample.bytes).unwrap();
    }
}

/// A profile of SUR whose lines have neither a spacing nor a unit of it; data sets and variables of
/// one axis, at positions that are even and uneven.
#[test]
fn profiles_of_formats_for_maps() {
    let mut sur = sample("sur").bytes;
    sur[108..116].copy_from_slice(&[35i32, 1].map(i32::to_le_bytes).concat());
    sur[124..128].fill(0);
    sur[196..212].fill(b' ');
    let found = unaided(&sur).unwrap();
    assert!(found.is_profile());
    assert_eq!((found.grid().shape(), found.grid().pixel()[1]), ([1, 35], 2e-6));

    let line = common::microscopes::hdf5(include_bytes!("../data/line.h5.gz"));
    let found = unaided(line).unwrap();
    assert_eq!((found.channel.as_str(), found.grid().shape()), ("z", [1, 5]));
    assert!((found.grid().pixel()[1] / 0.5e-6 - 1.0).abs() < 1e-12 && found.is_profile());

    let mut jpk = common::microscopes::hdf5(include_bytes!("../data/packed.h5.gz"));
    replace(&mut jpk, b"scale_factor", b"jpkspm_versi");
    assert_refused(unaided(jpk), &["JPK", "export"]);

    // A line scan as contact.engineering writes it, packed; the last height is missing.
    let packing =
        [("scale_factor", Err(0.5)), ("add_offset", Err(100.0)), ("_FillValue", Err(-1.0))];
    let x = ("x", &[0][..], &[("unit", Ok("um"))][..], vec![0.0, 1.0, 2.5, 3.0]);
    let heights = ("heights", &[0][..], &packing[..], vec![0.0, 10.0, 20.0, -1.0]);
    let found = unaided(netcdf(1, &[("n", 4)], &[x, heights])).unwrap();
    assert_eq!((found.channel.as_str(), found.missing()), ("heights", 1));
    assert!(found.is_profile() && found.uneven.is_some());
    // Stored 10, in steps of 0.5 from 100, in the unit of x.
    assert!((found.heights()[1] / 105e-6 - 1.0).abs() < 1e-12);
    assert!((found.positions.unwrap()[2] / 2.5e-6 - 1.0).abs() < 1e-12);
}

/// Coordinates of NetCDF without values, texts: their attributes give the size and the unit.
#[test]
fn coordinates_of_text_have_a_length() {
    let um = |length: f64| [("units", Ok("um")), ("length", Err(length))];
    let (of_y, of_x) = (um(6.0), um(2.0));
    let y = ("y", &[0][..], &of_y[..], vec![0.0; 3]);
    let x = ("x", &[1][..], &of_x[..], vec![0.0; 4]);
    let heights = ("heights", &[0, 1][..], &[][..], (0..12).map(f64::from).collect());
    let mut file = netcdf(1, &[("y", 3), ("x", 4)], &[y, x, heights]);
    let is_type = |k: &usize| file[*k..*k + 8] == [0, 0, 0, 6, 0, 0, 0, 0];
    let types: Vec<usize> = (0..1016).filter(is_type).collect();
    assert_eq!(types.len(), 3);
    for k in &types[..2] {
        file[k + 3] = 2; // text in the place of f64
    }
    let found = unaided(&file).unwrap();
    for (found, wanted) in found.grid().pixel().into_iter().zip([2e-6, 0.5e-6]) {
        assert!((found / wanted - 1.0).abs() < 1e-12, "{found:e}");
    }
    assert!((found.heights()[11] / 11e-6 - 1.0).abs() < 1e-12);
}

#[test]
fn old_igor_waves_are_called_so() {
    for (version, size) in [(1i16, 134), (2, 142), (3, 146)] {
        let mut wave = vec![0; size + 32];
        wave[..2].copy_from_slice(&version.to_be_bytes());
        (wave[9], wave[size - 1]) = (7, 5);
        let sum = wave[..size].chunks(2).map(|pair| i16::from_be_bytes([pair[0], pair[1]]));
        let sum = sum.fold(0i16, i16::wrapping_add);
        wave[2..4].copy_from_slice(&sum.wrapping_neg().to_be_bytes());
        assert_refused(unaided(&wave), &[&format!("wave of version {version}")]);
    }
}

/// Numbers beside a map that may be its pixel are named where one is asked for.
#[test]
fn numbers_beside_a_map_are_named() {
    let head =
        |shape: &str, value: f64| common::binary::npy("<f8", false, shape, &value.to_le_bytes());
    let map: Vec<u8> = (0..4).flat_map(|i| f64::from(i).to_le_bytes()).collect();
    let map = common::binary::npy("<f8", false, "(2, 2)", &map);
    let file = common::binary::zip(&[
        ("z.npy", &map),
        ("dx.npy", &head("()", 0.5)),
        ("pixel_size.npy", &head("(1,)", 2.0)),
        ("speed.npy", &head("()", 3.0)),
    ]);
    assert_refused(unaided(&file), &["says dx = 0.5; pixel_size = 2, which was not used"]);
    assert_eq!(read_bytes(&file, &scaled(1e-6, 1.0)).unwrap().channels.len(), 1);
}
