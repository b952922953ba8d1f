//! Samples of instrument formats.

use super::binary::{
    Writer, counted, doubles, floats, latin1, shorts, upside_down, utf16, words, zlib,
};
use super::{DX, DY, NX, NY, SampleFile, points};

fn sur(is_compressed: bool, bits: u16) -> Vec<u8> {
    // Stored value v is v - 1000 nm; the smallest is 1000, so a missing point is 998.
    let stored: Vec<f64> = points(-2.0).iter().map(|h| h + 1000.0).collect();
    let data = if bits == 16 { shorts(&stored) } else { words(&stored) };
    let mut w = Writer::default();
    w.put(if is_compressed { b"DSCOMPRESSED" } else { b"DIGITAL SURF" });
    w.to(14).u16([1]).to(18).u16([2]).put("plate");
    w.to(86).u16([1]).to(98).put(bits.to_le_bytes());
    w.put(1000i32.to_le_bytes()).put(1406i32.to_le_bytes());
    w.u32([NX as u32, NY as u32]);
    w.to(120).f32([2.0, 3.0, 1.0]);
    w.to(164).put("Z").to(180).put(b"\xb5m").to(196).put("um").to(212).put("nm");
    w.to(306).u16([1, 2, 3, 4, 5, 2024]);
    w.to(334).u16([6, 3]);
    w.to(474).f32([-1000.0]).to(512).put("remark").put("own");
    if is_compressed {
        let packed = zlib(&data);
        w.u32([1, data.len() as u32, packed.len() as u32]).put(packed);
    } else {
        w.put(data);
    }
    w.0
}

fn sdf_binary(version: u8, code: u8, z_scale: f64, data: &[u8]) -> Vec<u8> {
    let mut w = Writer::default();
    w.put(format!("bISO-{version}.0maker")).to(18).put("210120260000").to(30).put("210120260000");
    if version == 1 {
        w.u16([NX as u16, NY as u16]);
    } else {
        w.u32([NX as u32, NY as u32]);
    }
    w.put(doubles(&[DX, DY, z_scale, 0.0])).put([0, code, 0]).put(data);
    w.0
}

fn sdf_text() -> String {
    let data: Vec<String> = points(f64::NAN)
        .iter()
        .map(|h| if h.is_nan() { "BAD".into() } else { format!("{h}") })
        .collect();
    let data: Vec<String> = data.chunks(4).map(|line| line.join(" ")).collect();
    format!(
        "aISO-1.0\r\nManufacID = me\r\nNumPoints = 7\r\nNumProfiles = 5\r\nXscale = {DX:e}\r\n\
         Yscale = {DY:e}\r\nZscale = 1e-9\r\nDataType = 7\r\n*\r\n{}\r\n*\r\nend\r\n*",
        data.join("\r\n")
    )
}

/// Square pixels only: the sample has 3 um both ways, and the test gives the pixel.
fn zygo() -> Vec<u8> {
    let mut w = Writer::default();
    w.put([0x88, 0x1b, 0x03, 0x6f]).to(6).put(834u32.to_be_bytes());
    w.to(52).put(2u16.to_be_bytes()).put(1u16.to_be_bytes()).put(1u16.to_be_bytes());
    w.to(60).put(4u32.to_be_bytes());
    w.to(68).put((NX as u16).to_be_bytes()).put((NY as u16).to_be_bytes());
    w.to(80).put("remark").to(164).put(0.5f32.to_be_bytes());
    w.put((32768e-9f32 * 2.0).to_be_bytes()).to(176).put(1f32.to_be_bytes());
    w.to(184).put(3e-6f32.to_be_bytes()).to(218).put(1i16.to_be_bytes());
    w.to(232).put(1i16.to_be_bytes()).to(834).put([1, 2, 3, 4]);
    for h in points(-2147483640.0) {
        w.put((-h as i32).to_be_bytes());
    }
    w.0
}

fn opd() -> Vec<u8> {
    let mut data = Writer::default();
    data.u16([NX as u16, NY as u16, 4]);
    let values = points(1e38);
    for ix in 0..NX {
        for iy in (0..NY).rev() {
            // Waves of 500 nm, Mult = 2: nm / 250.
            data.f32([(values[iy * NX + ix] / 250.0) as f32]);
        }
    }
    let blocks: [(&str, Vec<u8>); 5] = [
        ("RAW_DATA", data.0),
        ("Wavelength", 500f32.to_le_bytes().into()),
        ("Mult", 2i16.to_le_bytes().into()),
        ("Aspect", 1.5f32.to_le_bytes().into()),
        ("Pixel_size", 0.002f32.to_le_bytes().into()),
    ];
    let mut w = Writer::default();
    w.put([1, 0]);
    let length = 24 * (blocks.len() as i32 + 1);
    let directory = ("Directory", length);
    let entries = blocks.iter().map(|(name, block)| (*name, block.len() as i32));
    for (i, (name, length)) in std::iter::once(directory).chain(entries).enumerate() {
        w.put(name).to(2 + 24 * i + 18).put(length.to_le_bytes()).to(2 + 24 * (i + 1));
    }
    for (_, block) in blocks {
        w.put(block);
    }
    w.0
}

fn gwy(has_mask: bool) -> Vec<u8> {
    let object = |name: &str, items: Vec<u8>| {
        [name.as_bytes(), b"\0", &(items.len() as u32).to_le_bytes(), &items].concat()
    };
    let unit = |text: &str| {
        let items = [b"unitstr\0s", text.as_bytes(), b"\0"].concat();
        [b"o".to_vec(), object("GwySIUnit", items)].concat()
    };
    let field = |values: Vec<f64>| {
        let items = [
            &b"xres\0i"[..],
            &(NX as i32).to_le_bytes(),
            b"yres\0i",
            &(NY as i32).to_le_bytes(),
            b"xreal\0d",
            &(NX as f64 * DX).to_le_bytes(),
            b"yreal\0d",
            &(NY as f64 * DY).to_le_bytes(),
            b"si_unit_xy\0",
            &unit("m"),
            b"si_unit_z\0",
            &unit("m"),
            b"data\0D",
            &((NX * NY) as u32).to_le_bytes(),
            &doubles(&values),
        ]
        .concat();
        [b"o".to_vec(), object("GwyDataField", items)].concat()
    };
    let missing = if has_mask { 7.0 } else { f64::NAN };
    let metres: Vec<f64> = points(missing).iter().map(|h| h * 1e-9).collect();
    let mask: Vec<f64> = points(-1.0).iter().map(|h| if *h < 0.0 { 1.0 } else { 0.0 }).collect();
    let mut items = [&b"/0/data/title\0sZ\0/0/data\0"[..], &field(metres)].concat();
    if has_mask {
        items.extend([&b"/0/mask\0"[..], &field(mask)].concat());
    }
    items.extend(b"/filename\0sx\0/q\0q\x01\0\0\0\0\0\0\0/n\0S\x01\0\0\0a\0/c\0C\x02\0\0\0ab");
    [b"GWYP".to_vec(), object("GwyContainer", items)].concat()
}

fn nanoscope(bytes_per_pixel: usize) -> Vec<u8> {
    let values = upside_down(&points(102.0));
    let data = if bytes_per_pixel == 2 { shorts(&values) } else { words(&values) };
    // 1 nm per step: 65536 steps of 2 or 4 bytes, 10 nm/V.
    let hard = if bytes_per_pixel == 2 { 6553.6 } else { 429496729.6 };
    let header = format!(
        "\\*File list\r\n\\Version: 0x09010201\r\n\\*Ciao scan list\r\n\\@Sens. Zsens: V 10.0 nm/V\
         \r\n\\@Sens. Phase: V 1.0 \r\n\\*Ciao image list\r\n\\Data offset: 1024\r\n\
         \\Bytes/pixel: {bytes_per_pixel}\r\n\\Samps/line: 7\r\n\\Number of lines: 5\r\n\
         \\Scan Size: 14 15 ~m\r\n\\@2:Image Data: S [Phase] \"Phase\"\r\n\
         \\@2:Z scale: V [Sens. Phase] (0.005 \u{ba}/LSB) 360.0 \u{ba}\r\n\
         \\*Ciao image list\r\n\\Data offset: 1024\r\n\\Bytes/pixel: {bytes_per_pixel}\r\n\
         \\Samps/line: 7\r\n\\Number of lines: 5\r\n\\Scan Size: 14 15 ~m\r\n\
         \\@2:Image Data: S [Height] \"Height\"\r\n\
         \\@2:Z scale: V [Sens. Zsens] (0.1 V/LSB) {hard} V\r\n\\*File list end\r\n\x1a"
    );
    let mut w = Writer::default();
    w.put(latin1(&header)).to(1024).put(data);
    w.0
}

fn al3d() -> Vec<u8> {
    let mut w = Writer::default();
    w.put(b"AliconaImaging\0\r\n");
    let tags = [
        ("Version", "1"),
        ("TagCount", "7"),
        ("Cols", "7"),
        ("Rows", "5"),
        ("DepthImageOffset", "512"),
        ("TextureImageOffset", "672"),
        ("InvalidPixelValue", "3.00000028082e+15"),
        ("PixelSizeXMeter", "2e-06"),
        ("PixelSizeYMeter", "3e-06"),
    ];
    for (i, (key, value)) in tags.iter().enumerate() {
        let at = 17 + 52 * i;
        w.put(key).to(at + 20).put(value).to(at + 50).put("\r\n");
    }
    w.to(512);
    for row in points(3.00000028082e15 * 1e9).chunks(NX) {
        let metres: Vec<f64> = row.iter().map(|h| h * 1e-9).collect();
        w.put(floats(&metres)).put([0; 4]); // rows padded to 8 bytes
    }
    w.put([0; 40]);
    w.0
}

fn plu() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("21/11/2026 02:00").to(388);
    w.u32([NY as u32, NX as u32]);
    w.to(404).f32([2.0, 3.0]).to(428).u32([3]);
    w.to(489).put([1]).to(500).u32([NY as u32, NX as u32]);
    let um: Vec<f64> =
        points(f64::NAN).iter().map(|h| if h.is_nan() { 1000001.0 } else { h * 1e-3 }).collect();
    w.put(floats(&um)).put([0; 8]);
    w.0
}

fn nms() -> Vec<u8> {
    let mut w = Writer::default();
    w.to(16).put(doubles(&[0.0, 65.534])).put("OM_MS_2.0").to(1368);
    w.u32([NX as u32, NY as u32]);
    w.put(doubles(&[2000.0, 3000.0])).to(3468).put(shorts(&points(102.0)));
    w.0
}

fn tmd() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("Binary TrueMap Data File v2.0\r\n").to(32).put("a comment of its own length\0");
    w.u32([NX as u32, NY as u32]);
    w.put(floats(&[0.014, 0.015, 0.0, 0.0]));
    let mm: Vec<f64> = points(f64::NAN).iter().map(|h| h * 1e-6).collect();
    w.put(floats(&mm));
    w.0
}

fn bcrf(kind: &str) -> Vec<u8> {
    let is_float = kind.starts_with("bcrf");
    let void = if is_float { "3.402823E+38" } else { "32767" };
    let mut header = format!(
        "fileformat = {kind}\n% remark = none\nheadersize = 256\nxpixels = 7\nypixels = 5\n\
         xlength = 14000\nylength = 15\nyunit = \u{b5}m\nxunit = nm\nzunit = nm\nbit2nm = 0.5\n\
         intelmode = 0\nvoidpixels = {void}\n"
    );
    while header.chars().count() < 256 {
        header.push(' ');
    }
    let mut w = Writer::default();
    w.put(if kind.ends_with("unicode") { utf16(&header) } else { latin1(&header) });
    for h in points(f64::NAN) {
        let stored = 2.0 * h;
        if is_float {
            let raw = if h.is_nan() { f32::MAX } else { stored as f32 };
            w.put(raw.to_be_bytes());
        } else {
            w.put(if h.is_nan() { 32767 } else { stored as i16 }.to_be_bytes());
        }
    }
    w.0
}

/// A variable of f64 in NetCDF classic: name, numbers of its dimensions, attributes, which are texts or numbers, values.
pub type StoredVariable<'v> =
    (&'v str, &'v [usize], &'v [(&'v str, Result<&'v str, f64>)], Vec<f64>);

/// A file of these dimensions and variables, whose data begin at byte 1024.
pub fn netcdf(version: u8, sides: &[(&str, usize)], variables: &[StoredVariable<'_>]) -> Vec<u8> {
    let count = |n: usize| match version {
        5 => (n as u64).to_be_bytes().to_vec(),
        _ => (n as u32).to_be_bytes().to_vec(),
    };
    let name = |text: &str| {
        let mut raw = count(text.len());
        raw.extend(text.bytes());
        raw.resize(raw.len().next_multiple_of(4), 0);
        raw
    };
    let [of_text, of_double, of_dimensions, of_variables, of_attributes] =
        [2, 6, 10, 11, 12].map(u32::to_be_bytes);
    let mut w = Writer::default();
    w.put(b"CDF").put([version]).put(count(0)).put(of_dimensions).put(count(sides.len()));
    for (side, n) in sides {
        w.put(name(side)).put(count(*n));
    }
    w.put([0; 4]).put(count(0)).put(of_variables).put(count(variables.len()));
    let mut at = 1024;
    for (variable, dimensions, attributes, values) in variables {
        w.put(name(variable)).put(count(dimensions.len()));
        for dimension in *dimensions {
            w.put(count(*dimension));
        }
        w.put(of_attributes).put(count(attributes.len()));
        for (key, value) in *attributes {
            w.put(name(key));
            match value {
                Ok(text) => w.put(of_text).put(name(text)),
                Err(number) => w.put(of_double).put(count(1)).put(number.to_be_bytes()),
            };
        }
        w.put(of_double).put(count(0));
        match version {
            1 => w.put((at as u32).to_be_bytes()),
            _ => w.put((at as u64).to_be_bytes()),
        };
        at += 8 * values.len();
    }
    w.to(1024);
    for value in variables.iter().flat_map(|variable| &variable.3) {
        w.put(value.to_be_bytes());
    }
    w.0
}

/// Heights as (y, x), or as (x, y).
fn netcdf_map(version: u8, is_x_slow: bool) -> Vec<u8> {
    let line = |n: usize, step: f64| (0..n).map(|k| 5.0 + step * k as f64).collect::<Vec<_>>();
    let mut axes = [("y", NY, line(NY, 3.0)), ("x", NX, line(NX, 2.0))];
    let mut heights = points(f64::NAN);
    if is_x_slow {
        axes.reverse();
        let stored = heights.clone();
        heights = (0..NX * NY).map(|i| stored[i % NY * NX + i / NY]).collect();
    }
    let [slow, fast] = axes;
    let (um, nm) = ([("units", Ok("um"))], [("units", Ok("nm"))]);
    let variables = [
        (slow.0, &[0][..], &um[..], slow.2),
        (fast.0, &[1], &um, fast.2),
        ("heights", &[0, 1], &nm, heights),
    ];
    netcdf(version, &[(slow.0, slow.1), (fast.0, fast.1)], &variables)
}

/// In steps of 0.5 Å and beside a log, as GXSM writes it.
fn netcdf_gxsm() -> Vec<u8> {
    let angstrom = [("var_unit", Ok("Ang")), ("unit", Ok("nm"))];
    let number = |name, value| (name, &[][..], &angstrom[..], vec![value]);
    let log = ("Event_User", &[2, 1][..], &[][..], vec![0.0; NY]);
    let heights = points(f64::NAN).iter().map(|h| 20.0 * h).collect();
    let heights = ("FloatField", &[0, 1, 2, 3][..], &[("unit", Ok("nm"))][..], heights);
    let scales = [number("dz", 0.5), number("dy", 1e10 * DY), number("dx", 1e10 * DX)];
    let sides = [("time", 1), ("value", 1), ("dimy", NY), ("dimx", NX)];
    netcdf(1, &sides, &[&[log, heights][..], &scales].concat())
}

fn ibw() -> Vec<u8> {
    let mut w = Writer::default();
    w.put(5i16.to_le_bytes()).to(12).put(8i32.to_le_bytes()).to(44).put(96i32.to_le_bytes());
    w.to(80).put(2i16.to_le_bytes()).to(92).put("scan0001").to(132);
    for n in [NX as i32, NY as i32, 2, 0] {
        w.put(n.to_le_bytes());
    }
    w.put(doubles(&[DX, DY, 1.0, 1.0])).to(212).put("m").to(216).put("m").to(220).put("m").to(384);
    let metres: Vec<f64> = upside_down(&points(f64::NAN)).iter().map(|h| h * 1e-9).collect();
    w.put(floats(&points(0.0))).put(floats(&metres)).put("Rate: 1\r");
    for label in ["", "PhaseTrace", "HeightTrace"] {
        let end = w.0.len() + 32;
        w.put(label).to(end);
    }
    let sum = w.0[..384].chunks(2).map(|pair| i16::from_le_bytes([pair[0], pair[1]]));
    let sum = sum.fold(0i16, i16::wrapping_add);
    w.0[2..4].copy_from_slice(&sum.wrapping_neg().to_le_bytes());
    w.0
}

fn frt() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("FRTM_GLIDERV1.00").u16([4]);
    let mut block = |tag: u16, content: &[u8]| {
        w.put(tag.to_le_bytes()).u32([content.len() as u32]).put(content);
    };
    block(0x66, &[NX as u32, NY as u32, 16].map(u32::to_le_bytes).concat());
    block(0x67, &doubles(&[NX as f64 * DX, NY as f64 * DY]));
    block(0x6c, &[&5u32.to_le_bytes()[..], &0.5e-9f64.to_le_bytes()].concat());
    let stored: Vec<f64> = upside_down(&points(0.5)).iter().map(|h| 2.0 * h).collect(); // 1 marks the missing
    block(0x0b, &shorts(&stored));
    w.0
}

fn mi() -> Vec<u8> {
    let header = "fileType      Image\nxPixels       7\nyPixels       5\nxLength       1.4e-5\n\
                  yLength       1.5e-5\nbufferLabel   Deflection\nbufferUnit    V\n\
                  bufferRange   10\nbufferLabel   Topography\nbufferUnit    \u{b5}m\n\
                  bufferRange   32.768\ndata          BINARY\n";
    let values = upside_down(&points(102.0));
    let mut w = Writer::default();
    w.put(header).put(shorts(&values)).put(shorts(&values));
    w.0
}

fn nid() -> Vec<u8> {
    let section = |name: &str, unit: &str| {
        format!(
            "Points=7\r\nLines=5\r\nFrame=Scan forward\r\nDim0Unit=m\r\nDim0Range=1.4e-5\r\n\
             Dim1Unit=m\r\nDim1Range=1.5e-5\r\nDim2Name={name}\r\nDim2Unit={unit}\r\n\
             Dim2Range=6.5536e-5\r\nDim2Min=-3.2768e-5\r\nSaveMode=Binary\r\nSaveBits=16\r\n\
             SaveSign=Signed\r\nSaveOrder=Intel\r\n\r\n"
        )
    };
    let header = format!(
        "[DataSet]\r\nVersion=2\r\nGroupCount=1\r\nGr0-Count=2\r\nGr0-Ch0=DataSet-0:0\r\n\
         Gr0-Ch1=DataSet-0:1\r\n\r\n[DataSet-Info]\r\nDate=03-11-2022\r\n\r\n[DataSet-0:0]\r\n{}\
         [DataSet-0:1]\r\n{}#!",
        section("Deflection", "N"),
        section("Z-Axis", "m")
    );
    let values = shorts(&upside_down(&points(102.0)));
    let mut w = Writer::default();
    w.put(header).put(&values).put(&values);
    w.0
}

fn wsxm() -> Vec<u8> {
    let header = "WSxM file copyright UAM\r\nSxM Image file\r\nImage header size: 512\r\n\r\n\
                  [Control]\r\n\r\n    X Amplitude: 14000 nm\r\n    Y Amplitude: 15 \u{b5}m\r\n\r\n\
                  [General Info]\r\n\r\n    Image Data Type: double\r\n    Number of columns: 7\
                  \r\n    Number of rows: 5\r\n    Z Amplitude: 406.001 nm\r\n\r\n[Header end]\r\n";
    let mut w = Writer::default();
    w.put(latin1(header)).put(doubles(&points(102.0)));
    w.0
}

fn opdx() -> Vec<u8> {
    let item = |name: &str, kind: u8, value: Vec<u8>| [counted(name), vec![kind], value].concat();
    // The three widths of a length, all of them.
    let sized = |value: Vec<u8>| match value.len() {
        n @ 0..100 => [vec![1, n as u8], value].concat(),
        n @ 100..200 => [vec![2], (n as u16).to_le_bytes().to_vec(), value].concat(),
        n => [vec![4], (n as u32).to_le_bytes().to_vec(), value].concat(),
    };
    let quantity = |value: f64, symbol: &str| {
        let value = value.to_le_bytes().to_vec();
        sized([value, counted("unit"), counted(symbol), vec![0; 12]].concat())
    };
    let container = |items: Vec<Vec<u8>>| {
        sized([items.concat(), item("", 127, vec![]), vec![0xff, 0xff]].concat())
    };
    let sides = [NY as u32, NX as u32].map(u32::to_le_bytes).concat();
    let matrix = [counted("Matrix<float>"), sized([sides, floats(&points(f64::NAN))].concat())];
    let raw = container(vec![
        item("Matrix", 69, matrix.concat()),
        item("Dimension1Extent", 19, quantity(12.0, "\u{b5}m")),
        item("Dimension2Extent", 19, quantity(0.012, "mm")),
        item("DataScale", 19, quantity(1.0, "nm")),
        item("DataKind", 18, sized(b"Height".to_vec())),
    ]);
    let names = [counted("List"), sized([counted("Raw")].concat())].concat();
    let about = container(vec![
        item("Date", 18, sized(b"2026".to_vec())),
        item("Count", 7, 5u32.to_le_bytes().to_vec()),
        item("Channels", 66, names),
        item("Time", 21, vec![0; 9]),
    ]);
    let data = container(vec![item("Raw", 71, raw)]);
    let items = [item("MetaData", 125, about), item("2D_Data", 125, data)];
    let mut w = Writer::default();
    w.put(b"VCA DATA\x01\0\0\x55").put(items.concat()).put(item("", 127, vec![]));
    w.0
}

pub fn samples() -> Vec<SampleFile> {
    let bytes: Vec<u8> = points(f64::NAN)
        .iter()
        .flat_map(|h| if h.is_nan() { i16::MIN } else { *h as i16 }.to_le_bytes())
        .collect();
    vec![
        SampleFile::new("sur", sur(false, 32)),
        SampleFile::new("sur, 16 bits", sur(false, 16)),
        SampleFile::new("sur, compressed", sur(true, 32)),
        SampleFile::new("sdf, f64", sdf_binary(1, 7, 1e-9, &doubles(&points(f64::NAN)))),
        SampleFile::new("sdf, i16", sdf_binary(1, 5, 1e-9, &bytes)),
        SampleFile::new(
            "sdf 2.0, f32",
            sdf_binary(2, 3, 1e-9, &floats(&points(f64::from(f32::MIN)))),
        ),
        SampleFile::text("sdf, text", &sdf_text()),
        SampleFile::new("zygo", zygo()).with_pixel(),
        SampleFile::new("opd", opd()),
        SampleFile::new("gwy", gwy(false)),
        SampleFile::new("gwy, mask", gwy(true)),
        SampleFile::new("nanoscope, 2 bytes", nanoscope(2)).complete(),
        SampleFile::new("nanoscope, 4 bytes", nanoscope(4)).complete(),
        SampleFile::new("al3d", al3d()),
        SampleFile::new("plu", plu()),
        SampleFile::new("nms", nms()).complete(),
        SampleFile::new("tmd", tmd()),
        SampleFile::new("bcrf, UTF-16", bcrf("bcrf_unicode")),
        SampleFile::new("bcrstm", bcrf("bcrstm")),
        SampleFile::new("netcdf 1", netcdf_map(1, false)),
        SampleFile::new("netcdf 2, x slow", netcdf_map(2, true)),
        SampleFile::new("netcdf 5", netcdf_map(5, false)),
        SampleFile::new("netcdf, GXSM", netcdf_gxsm()),
        SampleFile::new("ibw", ibw()),
        SampleFile::new("opdx", opdx()),
        SampleFile::new("frt", frt()),
        SampleFile::new("mi", mi()).complete(),
        SampleFile::new("nid", nid()).complete(),
        SampleFile::new("wsxm", wsxm()).complete(),
    ]
}
