//! Documents of Mountains (MNT), and the OLE compound documents that hold them.

use super::binary::{Writer, utf16, zlib};
use super::{DX, DY, NX, NY, SampleFile, points};

const FREE: u32 = 0xffff_ffff;
const END: u32 = 0xffff_fffe;

/// A compound document of these streams, with sectors of 2^`shift` bytes: table, directory, then
/// the streams. Streams below 4096 bytes are in small sectors, as the form wants it.
pub fn ole(streams: &[(&str, &[u8])], shift: u16) -> Vec<u8> {
    let size = 1usize << shift;
    let entry = |name: &str, kind: u8, start: u32, length: usize| {
        let mut w = Writer::default();
        let name = utf16(&format!("{name}\0"));
        w.put(&name).to(64).u16([name.len() as u16]).put([kind, 1]);
        w.u32([FREE; 3]);
        w.to(116).put(start.to_le_bytes()).put((length as u64).to_le_bytes());
        w.0
    };
    let mut table = vec![0xffff_fffd, END];
    let mut data = Writer::default();
    let mut sectors = |content: &[u8]| {
        let first = table.len() as u32;
        let count = content.len().div_ceil(size) as u32;
        table.extend((1..count).map(|i| first + i).chain([END]));
        let end = (data.0.len() + content.len()).next_multiple_of(size);
        data.put(content).to(end);
        first
    };
    let (mut pool, mut small) = (Writer::default(), Vec::new());
    let mut entries = Vec::new();
    for (name, content) in streams {
        if content.len() >= 4096 {
            entries.push(entry(name, 2, sectors(content), content.len()));
        } else {
            let first = small.len() as u32;
            let count = content.len().div_ceil(64) as u32;
            small.extend((1..count).map(|i| first + i).chain([END]));
            let end = (pool.0.len() + content.len()).next_multiple_of(64);
            pool.put(content).to(end);
            entries.push(entry(name, 2, first, content.len()));
        }
    }
    let words = |words: &[u32]| words.iter().flat_map(|w| w.to_le_bytes()).collect::<Vec<u8>>();
    let (mut first_small, mut first_pool) = (END, END);
    if !small.is_empty() {
        small.resize(small.len().next_multiple_of(size / 4), FREE);
        first_small = sectors(&words(&small));
        first_pool = sectors(&pool.0);
    }
    entries.insert(0, entry("Root Entry", 5, first_pool, pool.0.len()));
    assert!(table.len() <= size / 4 && entries.len() <= size / 128);
    table.resize(size / 4, FREE);
    let mut w = Writer::default();
    w.put(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1").to(24);
    w.u16([0x3e, if shift == 9 { 3 } else { 4 }, 0xfffe, shift, 6]);
    w.to(44).put(words(&[1, 1, 0, 4096, first_small, u32::from(!small.is_empty()), END, 0, 0]));
    w.put(words(&[FREE; 108])).to(size);
    w.put(words(&table)).put(entries.concat()).to(3 * size).put(data.0);
    w.0
}

fn record(tag: u16, content: impl AsRef<[u8]>) -> Vec<u8> {
    let content = content.as_ref();
    [&tag.to_le_bytes()[..], &(content.len() as u64).to_le_bytes(), content].concat()
}

fn number(tag: u16, value: i32) -> Vec<u8> {
    record(tag, value.to_le_bytes())
}

fn text(text: &str) -> Vec<u8> {
    [vec![4], utf16(text)].concat()
}

fn object(class: i32, content: &[u8]) -> Vec<u8> {
    [record(1, number(1, class)), record(2, content)].concat()
}

fn axis(unit: &str, step: f64, shown: &str, ratio: f64, offset: f64) -> Vec<u8> {
    let double = |tag, value: f64| record(tag, value.to_le_bytes());
    let parts = [double(1, step), record(2, text(unit)), record(3, text(shown))];
    record(0xffff, [parts.concat(), double(4, ratio), double(5, offset), number(6, 1)].concat())
}

fn lateral(step: f64, count: i32) -> Vec<u8> {
    let axis = axis("\u{b5}m", 1e6 * step, "mm", 1000.0, 3.5);
    record(0xffff, [axis, number(1, count), number(2, 0), number(3, count - 1)].concat())
}

/// Two blocks of points of `width` bytes, the later one first.
fn blob(raw: &[u8], width: usize) -> Vec<u8> {
    let half = raw.len() / width / 2;
    let mut blob = (raw.len() as u64).to_le_bytes().to_vec();
    for (first, block) in [(half, &raw[half * width..]), (0, &raw[..half * width])] {
        let packed = zlib(block);
        blob.extend((first as u64).to_le_bytes());
        blob.extend([block.len() / width, packed.len()].map(|n| (n as u32).to_le_bytes()).concat());
        blob.extend(packed);
    }
    blob
}

/// What the stream `ScopedContents` of a document with the sample surface is; `marks` are those of
/// points that are there and of those that are not.
pub fn contents(class: i32, marks: Option<[u8; 2]>, highest: i32) -> Vec<u8> {
    let stored = points(f64::NAN);
    let fill = if marks.is_some() { 0.0 } else { 102.0 };
    let stored: Vec<i32> =
        stored.iter().map(|h| if h.is_nan() { fill } else { *h } as i32 - 100).collect();
    let heights: Vec<u8> = stored.iter().flat_map(|h| h.to_le_bytes()).collect();
    let mask = if let Some([there, missing]) = marks {
        let mut raw = vec![there; (NY + 2) * (NX + 2)];
        raw[2 * (NX + 2) + 3] = missing;
        let count = number(1, raw.len() as i32);
        let inner = object(9048, &[count, record(2, blob(&raw, 1))].concat());
        let content = [number(1, NX as i32), number(2, NY as i32), record(5, inner)].concat();
        object(9056, &content)
    } else {
        record(1, number(1, 0))
    };
    let name = record(0xffff, record(0xffff, record(1, text("Probe \u{b5}"))));
    let across =
        [record(1, lateral(DX, NX as i32)), record(2, lateral(DY, NY as i32)), record(3, mask)];
    let base = record(0xffff, [name, across.concat()].concat());
    let heights =
        object(9049, &[number(1, stored.len() as i32), record(2, blob(&heights, 4))].concat());
    // 1 nm a step, number -100 is height 0.
    let z = [
        axis("nm", 1.0, "\u{b5}m", 1000.000_000_000_000_1, 0.1),
        number(1, -100),
        number(2, highest),
    ];
    let surface = record(0xffff, [base, record(1, heights), record(2, z.concat())].concat());
    let data = object(9012, &record(1, object(class, &surface)));
    let result = object(9013, &number(1, 7));
    let parts = [result, data].map(|part| {
        let part = record(1, part);
        [(part.len() as u64).to_le_bytes().to_vec(), part].concat()
    });
    let document = record(0x02bd, [record(1, [2]), record(2, record(1, parts.concat()))].concat());
    let whole = [number(2, 5), record(1, [number(0x00c9, 21), document].concat())].concat();
    [(whole.len() as u64).to_le_bytes().to_vec(), whole].concat()
}

/// A document; with large sectors the streams are padded so that they are in them.
pub fn document(contents: &[u8], shift: u16) -> Vec<u8> {
    let mut contents = contents.to_vec();
    if shift == 12 {
        contents.extend(record(0x0190, [0; 4096]));
    }
    ole(&[("ImagePreview", b"\xff\xd8\xff"), ("ScopedContents", &contents)], shift)
}

pub fn samples() -> Vec<SampleFile> {
    vec![
        SampleFile::new("mnt", document(&contents(9062, None, 306), 9)).complete(),
        SampleFile::new(
            "mnt, mask, large sectors",
            document(&contents(9062, Some([9, 22]), 306), 12),
        ),
    ]
}
