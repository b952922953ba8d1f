//! MDT of NT-MDT (Nova, Solver, NTEGRA): frames one after the other. All numbers little endian.
//!
//! | byte | type | content |
//! |---|---|---|
//! | 0 | 4 | 01 B0 93 FF |
//! | 12 | u16 | number of frames − 1 |
//! | 33 | | the frames |
//! | frame + 0, 4 | u32, u16 | its size; its kind: 0 scan, 106 general map, others are left out |
//! | frame + 8 … 18 | 6 × u16 | year, month, day, hour, minute, second |
//! | frame + 20 | u16 | length V of the variables |
//!
//! A scan: the variables from byte 22 are, for x, y, z, f32 offset, f32 step, i16 unit; u8 channel at
//! byte 52. Behind them, at 22 + V: u16 mode, points along x, along y, number of single points
//! (their data are refused); the heights as i16; u32 length and text of the title.
//! Unit: −5 m, −4 cm, −3 mm, −2 µm, −1 nm, 0 Å; others are no lengths.
//!
//! A general map, from byte 22: u32 length of its header; 44 bytes; u32 lengths of name, XML, view,
//! special and source data; u32; u32 offset of the data in the file; u32 their size. The texts
//! follow, 4 bytes, u32 length of a structure whose bytes 12 and 16 are the u32 numbers of
//! dimensions and of quantities, then one calibration for each of them: u32 length, u32 length L of
//! the numbers; these (u32 lengths of name, comment, unit; u64; f64; u64; f64 bias, f64 scale, u64
//! first and last index, i32 type); the texts.
//! Type: −1, −2, −4, −8 signed, 1, 2, 4, 8 unsigned integers of that many bytes, −5892 f32, −13320 f64.
//!
//! Height = stored number × step (scale) + offset (bias). The first row is the bottom one.
//!
//! Sources: NT-MDT's description as read by several open readers; a file of general maps of a current
//! (no height among them). Scans were not checked against a real file.

use super::prelude::*;

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let frames = u64::from(b.u16(12)?) + 1;
    b.check_items(frames)?;
    let mut contents = Contents::default();
    let mut at = 33;
    for number in 1..=frames {
        let size = b.u32(at)? as usize;
        if size < 22 {
            return Err(b.fault(at, format!("a frame of {size} bytes; its header has 22")));
        }
        let frame = b.with(b.slice(at, size)?);
        at += size;
        let channel = match frame.u16(4)? {
            0 => scan(frame, number),
            106 => map(b, frame, number),
            _ => continue,
        };
        contents.add(&format!("Frame {number}"), channel);
    }
    Ok(contents)
}

fn scan(f: Bytes<'_>, number: u64) -> Result<Channel<'_>, ReadError> {
    let axis = |at: usize| Ok::<_, ReadError>((f.f32(at)?, f.f32(at + 4)?, f.i16(at + 8)?));
    let (x, y, z) = (axis(22)?, axis(32)?, axis(42)?);
    let mode = 22 + usize::from(f.u16(20)?);
    let shape = [f.u16(mode + 4)?.into(), f.u16(mode + 2)?.into()];
    f.check_points(shape)?;
    if f.u16(mode + 6)? > 0 {
        return Err(f.unsupported("a scan with spectra at single points"));
    }
    let steps = [y.1.abs(), x.1.abs()].map(f64::from);
    let pixel = Pixel::in_units(steps, [unit(y.2), unit(x.2)]);
    let (offset, step) = (f64::from(z.0), f64::from(z.1));
    if step == 0.0 {
        return Err(f.fault(46, "the step of the heights is 0"));
    }
    let raster = f.raster(mode + 8, shape, Sample::I16)?;
    let title = f.u32(raster.end).and_then(|n| f.text(raster.end + 4, n as usize));
    let title = title.ok().filter(|title| !title.is_empty());
    let kind = if f.u8(52)? == 0 { "Height" } else { "Scan" };
    let name = format!("{} (frame {})", title.as_deref().unwrap_or(kind), number);
    let convert = move |raw: f64| offset + raw * step;
    Ok(Channel::raster(name, unit(z.2), pixel, raster, convert).flipped())
}

/// The data of a general map stand anywhere in the file.
fn map<'a>(b: Bytes<'a>, f: Bytes<'_>, number: u64) -> Result<Channel<'a>, ReadError> {
    let mut texts = 0usize;
    for i in 0..5 {
        texts = texts.saturating_add(f.u32(66 + 4 * i)? as usize);
    }
    let name = f.text(98, f.u32(66)? as usize)?;
    let data = f.u32(90)? as usize;
    let head = 98usize.saturating_add(texts).saturating_add(4);
    let structure = f.u32(head)? as usize;
    let counts = [f.u32(head + 4 + 12)?, f.u32(head + 4 + 16)?];
    let [2, 1] = counts else {
        let [dimensions, quantities] = counts;
        return Err(f.unsupported(format!(
            "{quantities} quantities over {dimensions} dimensions (one over two is)"
        )));
    };
    let mut at = (head + 4).saturating_add(structure);
    let x = Calibration::at(f, &mut at)?;
    let y = Calibration::at(f, &mut at)?;
    let z = Calibration::at(f, &mut at)?;
    let shape = [y.count, x.count];
    let sample = match z.kind {
        -5892 => Some(Sample::F32),
        -13320 => Some(Sample::F64),
        kind => Sample::whole(kind.unsigned_abs() as usize, kind < 0),
    };
    let sample = sample.ok_or_else(|| f.fault(at, format!("numbers of type {}", z.kind)))?;
    let pixel = Pixel::in_units([y.scale.abs(), x.scale.abs()], [&y.unit, &x.unit]);
    let name = format!("{name} (frame {number})");
    let raster = b.raster(data, shape, sample)?;
    let convert = move |raw: f64| z.bias + raw * z.scale;
    Ok(Channel::raster(name, &z.unit, pixel, raster, convert).flipped())
}

fn unit(code: i16) -> &'static str {
    match code {
        -5 => "m",
        -4 => "cm",
        -3 => "mm",
        -2 => "\u{b5}m",
        -1 => "nm",
        0 => "\u{c5}",
        _ => "no length",
    }
}

/// What an axis or a quantity of a general map means.
struct Calibration {
    unit: String,
    bias: f64,
    scale: f64,
    count: usize,
    kind: i32,
}

impl Calibration {
    /// The one at byte `at`, which then is the byte behind it.
    fn at(f: Bytes<'_>, at: &mut usize) -> Result<Self, ReadError> {
        let start = *at;
        let c = f.from(start)?;
        let lengths = [c.u32(8)?, c.u32(12)?, c.u32(16)?].map(|n| n as usize);
        let texts = 8usize.saturating_add(c.u32(4)? as usize);
        let unit = texts.saturating_add(lengths[0]).saturating_add(lengths[1]);
        let (first, last) = (c.u64(60)?, c.u64(68)?);
        let count = last.wrapping_sub(first).wrapping_add(1);
        *at = start.saturating_add(c.u32(0)? as usize);
        Ok(Self {
            unit: c.text(unit, lengths[2])?,
            bias: c.f64(44)?,
            scale: c.f64(52)?,
            count: usize::try_from(count).unwrap_or(usize::MAX),
            kind: c.i32(76)?,
        })
    }
}
