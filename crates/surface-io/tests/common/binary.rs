//! Samples of the binary formats, written byte by byte after the layout tables of the readers.

use super::{DX, DY, NX, NY, SampleFile, points};
use contact_types::{Grid, HeightMap};
use std::io::{Cursor, Write as _};

/// Bytes put together field by field.
#[derive(Default)]
pub struct Writer(pub Vec<u8>);

impl Writer {
    pub fn put(&mut self, bytes: impl AsRef<[u8]>) -> &mut Self {
        self.0.extend_from_slice(bytes.as_ref());
        self
    }

    pub fn u16<const N: usize>(&mut self, values: [u16; N]) -> &mut Self {
        self.put(values.map(u16::to_le_bytes).concat())
    }

    pub fn u32<const N: usize>(&mut self, values: [u32; N]) -> &mut Self {
        self.put(values.map(u32::to_le_bytes).concat())
    }

    pub fn f32<const N: usize>(&mut self, values: [f32; N]) -> &mut Self {
        self.put(values.map(f32::to_le_bytes).concat())
    }

    /// Zeros up to offset `at`.
    pub fn to(&mut self, at: usize) -> &mut Self {
        assert!(self.0.len() <= at, "offset {at} is behind {}", self.0.len());
        self.0.resize(at, 0);
        self
    }
}

/// A ZIP archive of these members.
pub fn zip(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        archive.start_file(*name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(content).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

pub fn npy(descr: &str, is_fortran: bool, shape: &str, data: &[u8]) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let header = format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}\n");
    let mut w = Writer::default();
    w.put(b"\x93NUMPY\x01\x00").u16([header.len() as u16]).put(header).put(data);
    w.0
}

/// `main.xml` of an X3P file with z of type `kind` and `record3` as its data.
pub fn x3p_main(kind: &str, z_axis: &str, record3: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1>\
         <Revision>ISO5436 \u{2013} 2000</Revision><FeatureType>SUR</FeatureType><Axes>\
         <CX><AxisType>I</AxisType><DataType>D</DataType><Increment>{DX:e}</Increment></CX>\
         <CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{DY:e}</Increment></CY>\
         <CZ><AxisType>A</AxisType><DataType>{kind}</DataType>{z_axis}</CZ></Axes></Record1>\
         <Record2><Creator>A &amp; B</Creator></Record2><Record3><MatrixDimension>\
         <SizeX>7</SizeX><SizeY>5</SizeY><SizeZ>1</SizeZ></MatrixDimension>{record3}\
         </Record3></p:ISO5436_2>"
    )
}

pub fn floats(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| (*v as f32).to_le_bytes()).collect()
}

pub fn shorts(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| (*v as i16).to_le_bytes()).collect()
}

pub fn words(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| (*v as i32).to_le_bytes()).collect()
}

/// Rows from the bottom upwards.
pub fn upside_down(values: &[f64]) -> Vec<f64> {
    values.chunks(NX).rev().flatten().copied().collect()
}

pub fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|v| v.to_le_bytes()).collect()
}

fn x3p_samples() -> Vec<SampleFile> {
    let metres: Vec<f64> = points(f64::NAN).iter().map(|h| h * 1e-9).collect();
    let link = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
    let masked = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>\
                  <ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>";
    let steps: Vec<u8> = points(0.0).iter().flat_map(|h| (*h as i16 - 50).to_le_bytes()).collect();
    let scale = "<Increment>1e-9</Increment><Offset>50e-9</Offset>";
    let mut mask = vec![0xff; 5];
    mask[9 / 8] &= !(1 << (9 % 8)); // point (1, 2) is number 9
    let data: String = points(f64::NAN)
        .iter()
        .map(|h| if h.is_nan() { "<Datum/>".into() } else { format!("<Datum>{h}e-9</Datum>") })
        .collect();
    let list = format!("<DataList>{data}</DataList>");
    vec![
        SampleFile::new(
            "x3p, binary",
            zip(&[
                ("main.xml", x3p_main("D", "", link).as_bytes()),
                ("bindata/data.bin", &doubles(&metres)),
            ]),
        ),
        SampleFile::new(
            "x3p, mask, in a folder, beside __MACOSX",
            zip(&[
                ("__MACOSX/._main.xml", b"junk"),
                ("scan/main.xml", x3p_main("I", scale, masked).as_bytes()),
                ("scan/bindata/data.bin", &steps),
                ("scan/bindata/valid.bin", &mask),
            ]),
        ),
        SampleFile::new("x3p, list", zip(&[("main.xml", x3p_main("D", "", &list).as_bytes())])),
    ]
}

/// Bytes after their number.
pub fn counted(bytes: impl AsRef<[u8]>) -> Vec<u8> {
    [&(bytes.as_ref().len() as u32).to_le_bytes()[..], bytes.as_ref()].concat()
}

/// A zlib stream.
pub fn zlib(content: &[u8]) -> Vec<u8> {
    let mut pack = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    pack.write_all(content).unwrap();
    pack.finish().unwrap()
}

pub fn latin1(text: &str) -> Vec<u8> {
    text.chars().map(|c| c as u8).collect()
}

pub fn utf16(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_le_bytes).collect()
}

pub fn gzip(content: &[u8]) -> Vec<u8> {
    let mut pack = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::default());
    pack.write_all(content).unwrap();
    pack.finish().unwrap()
}

/// The sample surface without its missing point.
pub fn complete_map() -> HeightMap {
    let heights = points(102.0).iter().map(|h| h * 1e-9).collect();
    HeightMap::new(Grid::new([NY, NX], [DY, DX]).unwrap(), heights).unwrap()
}

pub fn samples() -> Vec<SampleFile> {
    let values = points(f64::NAN);
    let columns: Vec<u8> = (0..NX)
        .flat_map(|ix| (0..NY).map(move |iy| (iy, ix)))
        .flat_map(|(iy, ix)| (points(f64::NAN)[iy * NX + ix] as f32).to_be_bytes())
        .collect();
    let integers = shorts(&points(102.0));
    let mut samples = vec![
        SampleFile::new("npy", npy("<f8", false, "(5, 7)", &doubles(&values)))
            .bare(),
        SampleFile::new("npy, Fortran, big endian", npy(">f4", true, "(5, 7)", &columns))
            .bare(),
        SampleFile::new("npy, integers", npy("<u2", false, "(5, 7)", &integers))
            .bare()
            .complete(),
        SampleFile::new("zipped text", zip(&[("map.txt", b"# Width: 14 um\n# Height: 15 um\n# Value units: nm\n0 1 2 3 4 5 6\n100 101 NaN 103 104 105 106\n200 201 202 203 204 205 206\n300 301 302 303 304 305 306\n400 401 402 403 404 405 406")])),
    ];
    let plain = npy("<f8", false, "(5, 7)", &doubles(&values));
    samples.push(SampleFile::new("gzipped npy", gzip(&plain)).bare());
    let member = npy("<f8", false, "(5, 7)", &doubles(&values));
    let text = npy("<U3", false, "()", b"abcdefghijkl");
    let archive = zip(&[("note.npy", &text), ("height.npy", &member)]);
    samples.push(SampleFile::new("npz", archive).bare());
    samples.extend(x3p_samples());
    samples
}
