//! Samples of the formats of microscopes and profilers that came later than the others.

use super::binary::{
    Writer, counted, doubles, floats, gzip, shorts, upside_down, utf16, words, zip, zlib,
};
use super::{DX, DY, NX, NY, SampleFile, points};
use std::io::Read as _;

/// Header, conditions at 84, a height image at 500; 1 pm is a tenth of the step.
fn vk4() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("VK4_").to(12).u32([84]).to(36).u32([500]);
    w.to(84).u32([664, 2026, 11, 22, 1, 2, 3]);
    w.to(84 + 168).u32([2_000_000, 3_000_000]);
    w.u32([100]);
    w.to(500).u32([NX as u32, NY as u32, 32, 0, 4 * (NX * NY) as u32]);
    let stored: Vec<f64> = points(102.0).iter().map(|h| 10.0 * h).collect();
    w.to(500 + 796).put(words(&stored));
    w.0
}

fn vk6() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("VK6").u32([8]).put("BMBMBMBM").put(zip(&[("Vk4File", &vk4())]));
    w.0
}

fn plux() -> Vec<u8> {
    let index = "<?xml version=\"1.0\"?><xml><GENERAL><DATE>2026</DATE><IMAGE_SIZE_X>7</IMAGE_SIZE_X>\
                 <IMAGE_SIZE_Y>5</IMAGE_SIZE_Y><FOV_X>2</FOV_X><FOV_Y>3</FOV_Y></GENERAL>\
                 <LAYER_0><FILENAME_Z>LAYER_0.raw</FILENAME_Z></LAYER_0></xml>";
    let data: Vec<f64> = points(f64::NAN).iter().map(|h| h * 1e-3).collect();
    zip(&[
        ("index.xml", index.as_bytes()),
        ("recipe.txt", b"<xml/>"),
        ("LAYER_0.raw", &floats(&data)),
    ])
}

fn zmg() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("Zeta-Instruments").to(85).u32([NX as u32, NY as u32]);
    w.to(97).put(floats(&[2.0, 3.0, 1e-3])).to(117).u32([4]).to(205).put("note");
    w.put(shorts(&points(102.0)));
    w.0
}

fn os3d() -> Vec<u8> {
    let mut w = Writer::default();
    w.put("OmniSurf3D").put([1i32, 0, 2].map(i32::to_le_bytes).concat()).put("id");
    w.put(4i32.to_le_bytes()).put("2026");
    w.put([NX as i32, NY as i32].map(i32::to_le_bytes).concat());
    w.put(doubles(&[2.0, 3.0, 0.0, 0.0]));
    let data: Vec<f64> = points(-3.4e41).iter().map(|h| h * 1e-3).collect();
    w.put(floats(&data)).put([0]);
    w.0
}

/// The backward pass of the current first, then z, both ways.
fn sxm() -> Vec<u8> {
    let header = ":NANONIS_VERSION:\n2\n:SCANIT_TYPE:\n    FLOAT    MSBFIRST\n:SCAN_PIXELS:\n   7   5\n\
                  :SCAN_RANGE:\n  1.4E-5   1.5E-5\n:SCAN_DIR:\nup\n:DATA_INFO:\n\
                  \tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n\
                  \t0\tCurrent\tA\tbackward\t1\t0\n\t14\tZ\tm\tboth\t-3E-9\t0\n\n:SCANIT_END:\n\n\n";
    let rows = upside_down(&points(f64::NAN));
    let data: Vec<u8> = rows.iter().flat_map(|h| ((h * 1e-9) as f32).to_be_bytes()).collect();
    let mut w = Writer::default();
    w.put(header).put([0x1a, 4]).put(&data).put(&data).put(&data);
    w.0
}

/// A TIFF file of directories of entries (tag, type, count, value), each with the strip of its picture if
/// it has one; strips and values longer than 4 bytes stand behind all directories.
fn tiff(pages: Vec<(Vec<TiffEntry>, Vec<u8>)>) -> Vec<u8> {
    let of_strip = |strip: &[u8]| if strip.is_empty() { 0 } else { 2 };
    let lengths = pages.iter().map(|(page, strip)| 6 + 12 * (page.len() + of_strip(strip)));
    let (behind, count) = (8 + lengths.sum::<usize>(), pages.len());
    let (mut head, mut tail) = (Writer::default(), Vec::new());
    head.put(b"II*\0").u32([8]);
    for (i, (mut page, strip)) in pages.into_iter().enumerate() {
        if !strip.is_empty() {
            page.push(long(273, (behind + tail.len()) as u32));
            page.push(long(279, strip.len() as u32));
            tail.extend(strip);
        }
        page.sort_by_key(|entry| entry.0);
        head.u16([page.len() as u16]);
        for (tag, kind, count, mut value) in page {
            head.u16([tag, kind]).u32([count]);
            if value.len() > 4 {
                let at = ((behind + tail.len()) as u32).to_le_bytes().to_vec();
                tail.extend(std::mem::replace(&mut value, at));
            }
            value.resize(4, 0);
            head.put(value);
        }
        let next = if i + 1 < count { head.0.len() as u32 + 4 } else { 0 };
        head.u32([next]);
    }
    head.put(tail);
    head.0
}

type TiffEntry = (u16, u16, u32, Vec<u8>);

fn short(tag: u16, value: u16) -> TiffEntry {
    (tag, 3, 1, value.to_le_bytes().to_vec())
}

fn long(tag: u16, value: u32) -> TiffEntry {
    (tag, 4, 1, value.to_le_bytes().to_vec())
}

fn text(tag: u16, value: &str) -> TiffEntry {
    (tag, 2, value.len() as u32 + 1, [value.as_bytes(), b"\0"].concat())
}

fn double(tag: u16, value: f64) -> TiffEntry {
    (tag, 12, 1, value.to_le_bytes().to_vec())
}

/// Entries of a picture in one strip.
fn picture(bits: u16, kind: u16, compression: u16, predictor: u16) -> Vec<TiffEntry> {
    vec![
        long(256, NX as u32),
        long(257, NY as u32),
        short(258, bits),
        short(259, compression),
        short(277, 1),
        long(278, NY as u32),
        short(317, predictor),
        short(339, kind),
    ]
}

fn tiff_floats() -> Vec<u8> {
    tiff(vec![(picture(32, 3, 1, 1), floats(&points(f64::NAN)))])
}

/// Differences along the rows, packed by deflate.
fn tiff_differences() -> Vec<u8> {
    let mut data = Vec::new();
    for row in points(102.0).chunks(NX) {
        let mut before = 0i16;
        for value in row {
            data.extend((*value as i16).wrapping_sub(before).to_le_bytes());
            before = *value as i16;
        }
    }
    tiff(vec![(picture(16, 2, 8, 2), zlib(&data))])
}

fn jpk() -> Vec<u8> {
    let grid =
        vec![double(0x8042, NX as f64 * DX), double(0x8043, NY as f64 * DY), text(0x8003, "2026")];
    let channel = |name: &str, unit: &str| {
        let mut page = picture(32, 2, 1, 1);
        page.extend([
            text(0x8050, name),
            long(0x8051, 1),
            text(0x8052, name),
            long(0x8080, 2),
            text(0x8081, "calibrated"),
            text(0x8090, "raw"),
            text(0x80A3, "NullScaling"),
            text(0x80C0, "calibrated"),
            text(0x80D2, unit),
            text(0x80D3, "LinearScaling"),
            double(0x80D4, -0.5e-9),
            double(0x80D5, 1e-6),
        ]);
        page
    };
    // h = 1 um - 0.5 nm * stored
    let stored: Vec<f64> = upside_down(&points(102.0)).iter().map(|h| (1000.0 - h) * 2.0).collect();
    let data = words(&stored);
    let channels = [(channel("Error", "m"), data.clone()), (channel("Height", "m"), data)];
    tiff([(grid, Vec::new())].into_iter().chain(channels).collect())
}

fn park() -> Vec<u8> {
    let mut h = Writer::default();
    h.to(4).put(utf16("Z Height")).to(100).u32([NX as u32, NY as u32]);
    h.to(140).put(doubles(&[14.0, 15.0])).to(220).put(doubles(&[0.5, 2e-3, 7.0])).put(utf16("um"));
    h.to(348).u32([2]).to(580);
    let data = floats(&upside_down(&points(f64::NAN)));
    let entries = vec![
        (50432, 4, 1, 0x0E03_1301u32.to_le_bytes().to_vec()),
        (50433, 4, 1, 0x0100_0002u32.to_le_bytes().to_vec()),
        (50434, 1, data.len() as u32, data),
        (50435, 7, 580, h.0),
    ];
    tiff(vec![(entries, Vec::new())])
}

fn lext() -> Vec<u8> {
    let xml = "<TiffTagDescData><HeightInfo><HeightDataPerPixelX>1000000</HeightDataPerPixelX>\
               <HeightDataPerPixelY>3000000</HeightDataPerPixelY><HeightDataPerPixelZ>500\
               </HeightDataPerPixelZ></HeightInfo></TiffTagDescData>";
    // The Exif directory is the last one in the file; it is no page of its own.
    let exif = "<ExifTagDescData><ImageCommonSettingsInfo><MakerCalibrationValueX>2\
                </MakerCalibrationValueX><MakerCalibrationValueZ>2</MakerCalibrationValueZ>\
                </ImageCommonSettingsInfo></ExifTagDescData>";
    let mut height = picture(16, 1, 1, 1);
    height.push(text(270, "HEIGHT"));
    let mut first = picture(8, 1, 1, 1);
    first.extend([text(270, xml), long(34665, 0)]);
    let mut file = tiff(vec![(first, vec![0; NX * NY]), (height, shorts(&points(102.0)))]);
    let at = file.len() as u32;
    let place = file.windows(4).position(|w| w == [0x69, 0x87, 4, 0]).unwrap() + 8;
    file[place..place + 4].copy_from_slice(&at.to_le_bytes());
    let mut w = Writer(file);
    w.u16([1, 41995, 7]);
    w.u32([exif.len() as u32]).put((at + 18).to_le_bytes()).u32([0]);
    w.put(exif);
    w.0
}

fn mdt_file(frames: &[Vec<u8>]) -> Vec<u8> {
    let mut w = Writer::default();
    w.put([1, 0xb0, 0x93, 0xff]).to(12).u16([frames.len() as u16 - 1]).to(33);
    for frame in frames {
        w.put(frame);
    }
    w.0
}

/// A frame of an unknown kind, then a scan.
fn mdt_scan() -> Vec<u8> {
    let frame = |kind: u16, variables: u16, content: &[u8]| {
        let mut w = Writer::default();
        w.u32([22 + content.len() as u32]).put(kind.to_le_bytes()).to(20);
        w.put(variables.to_le_bytes()).put(content);
        w.0
    };
    let axis = |offset: f32, step: f32, unit: i16| {
        [&offset.to_le_bytes()[..], &step.to_le_bytes(), &unit.to_le_bytes()].concat()
    };
    let mut w = Writer::default();
    w.put(axis(0.0, 2.0, -2)).put(axis(0.0, -3.0, -2)).put(axis(100.0, 0.5, -1)).put([0]).to(77);
    w.put([0, 0]).u16([NX as u16, NY as u16, 0]);
    let stored: Vec<f64> = upside_down(&points(102.0)).iter().map(|h| (h - 100.0) * 2.0).collect();
    w.put(shorts(&stored)).u32([5]).put("title");
    mdt_file(&[frame(3, 0, b"text"), frame(0, 77, &w.0)])
}

fn mdt_map() -> Vec<u8> {
    let calibration = |unit: &str, bias: f64, scale: f64, last: u64, kind: i32| {
        let mut w = Writer::default();
        w.u32([88 + unit.len() as u32, 80]);
        w.to(16).u32([unit.len() as u32]).to(44).put(doubles(&[bias, scale]));
        w.to(68).put(last.to_le_bytes()).put(kind.to_le_bytes()).to(88).put(unit);
        w.0
    };
    let mut w = Writer::default();
    w.to(4).u16([106]).to(66).u32([4]).to(98).put("Topo").to(106);
    w.u32([20]).to(122).u32([2, 1]);
    w.put(calibration("um", 0.0, 2.0, NX as u64 - 1, -8));
    w.put(calibration("um", 0.0, 3.0, NY as u64 - 1, -8));
    w.put(calibration("nm", 100.0, 0.5, 0, -5892));
    let data_at = 33 + w.0.len() as u32;
    w.put(floats(
        &upside_down(&points(f64::NAN)).iter().map(|h| (h - 100.0) * 2.0).collect::<Vec<_>>(),
    ));
    let mut frame = w.0;
    let size = frame.len() as u32;
    frame[..4].copy_from_slice(&size.to_le_bytes());
    frame[90..94].copy_from_slice(&data_at.to_le_bytes());
    mdt_file(&[frame])
}

/// With members as they are, or each packed with zstd.
fn zon(is_packed: bool) -> Vec<u8> {
    let matrix = |size: u32, data: Vec<u8>| {
        let head = [NX as u32, NY as u32, size, size * NX as u32].map(u32::to_le_bytes).concat();
        [head, data].concat()
    };
    let heights = matrix(4, words(&points(-7.0)));
    let mask = points(f64::NAN).iter().map(|h| if h.is_nan() { 2 } else { 0 }).collect();
    let mask = matrix(1, mask);
    let xml = "\u{feff}<?xml version=\"1.0\"?><Calibration><XYCalibration><MeterPerPixel>3E-06\
               </MeterPerPixel></XYCalibration><ZCalibration><MeterPerUnit>1E-09</MeterPerUnit>\
               </ZCalibration></Calibration>";
    let pack = |data: &[u8]| {
        if is_packed {
            use ruzstd::encoding::{CompressionLevel, compress_to_vec};
            compress_to_vec(data, CompressionLevel::Fastest)
        } else {
            data.to_vec()
        }
    };
    let archive = zip(&[
        ("4cdb0c75-5706-48cc-a9a1-adf395d609ae", &pack(&heights)),
        ("9e7ca6dd-0e6a-4d7b-8986-f0a7b773c916", &pack(&mask)),
        ("686613b8-27b5-4a29-8ffc-438c2780873e", &pack(xml.as_bytes())),
    ]);
    let mut w = Writer::default();
    w.put(if is_packed { "KPK1" } else { "KPK0" }).u32([6]).put("BMBMBM").put(archive);
    w.0
}

/// Made by h5py 3 from the sample surface, packed to keep them small.
pub fn hdf5(packed: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    flate2::read::GzDecoder::new(packed).read_to_end(&mut file).unwrap();
    file
}

/// A workbook as Mitutoyo's testers write it: a profile of five points, with these cells empty.
pub fn mitutoyo(empty: &[&str]) -> Vec<u8> {
    let cell = |place: &str, value: &str| {
        let value = if empty.contains(&place) { "" } else { value };
        format!("<c r=\"{place}\"><v>{value}</v></c>")
    };
    let mut rows = String::from("<row r=\"1\"><c r=\"A1\" t=\"s\"><v>0</v></c>");
    for i in 0..5 {
        if i > 0 {
            rows += &format!("<row r=\"{}\">", i + 1);
        }
        rows += &cell(&format!("E{}", i + 1), &format!("{}", 0.0015 * f64::from(i + 1)));
        rows += &cell(&format!("F{}", i + 1), &format!("{}", 0.5 * f64::from(i)));
        rows += "</row>";
    }
    let data = format!("<worksheet><sheetData>{rows}</sheetData></worksheet>");
    let certificate = "<worksheet><sheetData><row r=\"48\"><c r=\"E48\" t=\"s\"><v>1</v></c></row>\
                       </sheetData></worksheet>";
    zip(&[
        ("[Content_Types].xml", b"<Types/>"),
        (
            "xl/workbook.xml",
            b"<workbook xmlns:r=\"r\"><sheets><sheet name=\"Certificate\" r:id=\"rId1\"/>\
              <sheet name=\"DATA\" r:id=\"rId2\"/></sheets></workbook>",
        ),
        (
            "xl/_rels/workbook.xml.rels",
            b"<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/>\
              <Relationship Id=\"rId2\" Target=\"worksheets/sheet2.xml\"/></Relationships>",
        ),
        (
            "xl/sharedStrings.xml",
            "<sst><si><t>Ra     3.308  \u{b5}m</t></si><si><r><t>2.5</t></r><r><t>mm</t></r></si></sst>"
                .as_bytes(),
        ),
        ("xl/worksheets/sheet1.xml", certificate.as_bytes()),
        ("xl/worksheets/sheet2.xml", data.as_bytes()),
    ])
}

fn u32_of(value: usize) -> [u8; 4] {
    (value as u32).to_le_bytes()
}

fn block(kind: usize, content: &[u8]) -> Vec<u8> {
    [&u32_of(kind), &[1u8; 32][..], content].concat()
}

fn chunk(kind: usize, content: &[u8]) -> Vec<u8> {
    [&u32_of(content.len()), &u32_of(kind), content].concat()
}

fn piece(name: &str, data: &[u8]) -> Vec<u8> {
    let head = [&u32_of(0)[..], &u32_of(data.len()), &counted(name)].concat();
    [&chunk(3, &head)[..], &u32_of(data.len()), &u32_of(4), data].concat()
}

fn oir_channel(id: &str, kind: &str, bits: usize) -> String {
    let axes = |name: &str, inner: &str, [x, y, z]: [&str; 3]| {
        format!(
            "<commonphase:{name}><{inner}:x>{x}</{inner}:x><{inner}:y>{y}</{inner}:y>\
             <{inner}:z>{z}</{inner}:z></commonphase:{name}>"
        )
    };
    format!(
        "<commonphase:channel id=\"{id}\" order=\"1\"><commonphase:imageDefinition>\
         <commonphase:imageType>{kind}</commonphase:imageType>\
         <commonphase:bitCounts>{bits}</commonphase:bitCounts></commonphase:imageDefinition>{}{}\
         </commonphase:channel>",
        axes("length", "commonparam", ["1.0", "3", "1.0"]),
        axes("pixelUnit", "commonphase", ["MICRO_METER", "um", "NANO_METER"])
    )
}

/// With a picture beside the heights and these in two pieces.
fn oir() -> Vec<u8> {
    let properties = format!(
        "<?xml version=\"1.0\"?><lsmimage:imageProperties><commonimage:general>\
         <base:creationDateTime>2026-11-23</base:creationDateTime></commonimage:general>\
         <commonimage:imageInfo><commonimage:width>{NX}</commonimage:width>\
         <commonimage:height>{NY}</commonimage:height><commonimage:phase><commonphase:group>\
         {}{}</commonphase:group></commonimage:phase></commonimage:imageInfo>\
         <commonimage:acquisition><commonimage:microscopeConfiguration>\
         <commonimage:pixelCalibration><commonparam:x>2</commonparam:x>\
         </commonimage:pixelCalibration></commonimage:microscopeConfiguration>\
         </commonimage:acquisition></lsmimage:imageProperties>",
        oir_channel("c0", "COLOR", 24),
        oir_channel("c1", "HEIGHT", 16)
    );
    let list = |entries: &[&[u8]]| [&u32_of(entries.len())[..], &entries.concat()].concat();
    let name = |name: &str| [&counted(name)[..], &u32_of(0)].concat();
    let blocks = [
        block(1, &counted("<version/>")),
        block(2, &counted(&properties)),
        block(5, &list(&[&[counted("t"), counted("<lut/>")].concat()])),
        block(6, &list(&[&name("t001_0_1")])),
        block(8, &list(&[&name("c0"), &name("c1")])),
        block(9, &list(&[&[&u32_of(7)[..], &counted("a"), &counted("b")].concat()])),
        block(10, &list(&[&[&name("u")[..], &counted("<x/>"), &counted("<y/>")].concat()])),
        block(14, &counted("<events/>")),
    ];
    let data = shorts(&points(102.0));
    let mut w = Writer::default();
    w.put("OLYMPUSRAWFORMAT").to(72).put("UNKNOWN").to(96);
    w.put(chunk(0, &blocks.concat())).put(chunk(1, &block(1, &counted("<frame/>"))));
    w.put(chunk(2, b"BMP\0BM")).put(chunk(5, &[]));
    w.put(piece("t001_0_1_c1_1", &data[28..])).put(piece("t001_0_1_c1_0", &data[..28]));
    w.put([0xff; 4]).put([0; 8]);
    w.0
}

pub fn samples() -> Vec<SampleFile> {
    let packed = zip(&[("about.txt", b"no image"), ("a.oir", &oir()), ("b.oir", &oir()[..300])]);
    vec![
        SampleFile::new("oir", oir()).complete(),
        SampleFile::new("oir, packed", packed).complete(),
        SampleFile::new("vk4", vk4()).complete(),
        SampleFile::new("vk6", vk6()).complete(),
        SampleFile::new("vk6, gzip", gzip(&vk6())).complete(),
        SampleFile::new("plux", plux()),
        SampleFile::new("zmg", zmg()).complete(),
        SampleFile::new("os3d", os3d()),
        SampleFile::new("sxm", sxm()),
        SampleFile::new("tiff, f32", tiff_floats()).bare(),
        SampleFile::new("tiff, i16 differences", tiff_differences()).bare().complete(),
        SampleFile::new("jpk", jpk()).complete(),
        SampleFile::new("park", park()),
        SampleFile::new("lext", lext()).complete(),
        SampleFile::new("mdt, scan", mdt_scan()).complete(),
        SampleFile::new("mdt, general map", mdt_map()),
        // The format has square pixels; the sample has not.
        SampleFile::new("zon", zon(false)).with_pixel(),
        SampleFile::new("zon, zstd", zon(true)).with_pixel(),
        SampleFile::new("hdf5", hdf5(include_bytes!("../data/contiguous.h5.gz"))).with_pixel(),
        SampleFile::new("hdf5, chunks", hdf5(include_bytes!("../data/chunked.h5.gz"))).with_pixel(),
        SampleFile::new("hdf5, newest", hdf5(include_bytes!("../data/latest.h5.gz"))).with_pixel(),
        SampleFile::new("hdf5, packed", hdf5(include_bytes!("../data/packed.h5.gz"))).with_pixel(),
        SampleFile::new("hdf5, MATLAB", hdf5(include_bytes!("../data/matlab.h5.gz"))).bare(),
        SampleFile::new("hdf5, one chunk", hdf5(include_bytes!("../data/single_chunk.h5.gz")))
            .with_pixel(),
        SampleFile::new("datx", hdf5(include_bytes!("../data/made.datx.gz"))),
    ]
}
