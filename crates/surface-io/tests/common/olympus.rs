//! Sample of OIR, with a picture beside the heights and these in two pieces; and packed.

use super::binary::{Writer, zip};
use super::{NX, NY, SampleFile, points};

fn word(value: usize) -> [u8; 4] {
    (value as u32).to_le_bytes()
}

fn text(text: &str) -> Vec<u8> {
    [&word(text.len()), text.as_bytes()].concat()
}

fn block(kind: usize, content: &[u8]) -> Vec<u8> {
    [&word(kind), &[1u8; 32][..], content].concat()
}

fn chunk(kind: usize, content: &[u8]) -> Vec<u8> {
    [&word(content.len()), &word(kind), content].concat()
}

fn piece(name: &str, data: &[u8]) -> Vec<u8> {
    let head = [&word(0)[..], &word(data.len()), &text(name)].concat();
    [&chunk(3, &head)[..], &word(data.len()), &word(4), data].concat()
}

fn channel(id: &str, kind: &str, bits: usize) -> String {
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
        channel("c0", "COLOR", 24),
        channel("c1", "HEIGHT", 16)
    );
    let list = |entries: &[&[u8]]| [&word(entries.len())[..], &entries.concat()].concat();
    let name = |name: &str| [&text(name)[..], &word(0)].concat();
    let blocks = [
        block(1, &text("<version/>")),
        block(2, &text(&properties)),
        block(5, &list(&[&[text("t"), text("<lut/>")].concat()])),
        block(6, &list(&[&name("t001_0_1")])),
        block(8, &list(&[&name("c0"), &name("c1")])),
        block(9, &list(&[&[&word(7)[..], &text("a"), &text("b")].concat()])),
        block(10, &list(&[&[&name("u")[..], &text("<x/>"), &text("<y/>")].concat()])),
        block(14, &text("<events/>")),
    ];
    let data: Vec<u8> = points(102.0).iter().flat_map(|h| (*h as u16).to_le_bytes()).collect();
    let mut w = Writer::default();
    w.put("OLYMPUSRAWFORMAT").to(72).put("UNKNOWN").to(96);
    w.put(chunk(0, &blocks.concat())).put(chunk(1, &block(1, &text("<frame/>"))));
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
    ]
}
