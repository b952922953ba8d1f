//! Zygo MetroPro DAT. All numbers big endian.
//!
//! | byte | type | field |
//! |---|---|---|
//! | 0 | u32 | 0x881B036F (header 834 bytes), 0x881B0370 (834), 0x881B0371 (4096) |
//! | 6 | u32 | size of the header |
//! | 12 | 30 | date of the software |
//! | 48–56 | i16 i16 u16 u16 u16 | intensity: origin x, y; width, height, number of images |
//! | 60 | u32 | bytes of intensity data (u16), which come first |
//! | 64–70 | i16 i16 u16 u16 | phase: origin x, y; width, height |
//! | 72 | u32 | bytes of phase data (i32), which follow |
//! | 76, 80 | i32, 82 | time stamp, comment |
//! | 164, 168, 176 | f32 | interferometric scale factor S, wavelength W (m), obliquity factor O |
//! | 184 | f32 | lateral resolution (m per point, both directions; 0 if unknown) |
//! | 232 | i16 | sign: not 0 where heights are stored upside down |
//! | 218 | i16 | phase resolution: R = 4096, 32768 or 131072 for 0, 1, 2 |
//! | 246, 258 | 12, 40 | objective, part name |
//!
//! Height = phase × S W O / R; a phase of 2147483640 or more is a missing point.
//!
//! Exports as text:
//!
//! | line | content |
//! |---|---|
//! | 1 | `Zygo XYZ Data File - Format 1` or `Zygo ASCII Data File - Format 2` |
//! | 2 | software, version, date |
//! | 4 | phase: origin x, y; width, height |
//! | 5 to 7 | comment, serial number, part |
//! | 8 | source, interferometric scale factor S, wavelength W (m), aperture, obliquity factor O, 0, lateral resolution (m per point; 0 if unknown), time |
//! | 11 | phase resolution: R = 4096, 32768 or 131072 for 0, 1, 2; … |
//! | `#` | ends the header, and every block of data |
//!
//! Format 1 lists column, row and height in µm, `No Data` for a missing point. Format 2 has the
//! intensity, then the phase as whole numbers: height = phase × S W O / R, missing from
//! 2147483640 on, as above.
//!
//! Source: Zygo, *MetroPro Reference Guide* OMP-0347, appendix on the data format; public exports.
//! Format 2 was not checked against a real file.

use super::prelude::*;

pub(crate) fn is_text(bytes: &[u8]) -> bool {
    bytes.starts_with(b"Zygo XYZ Data File") || bytes.starts_with(b"Zygo ASCII Data File")
}

/// Steps of the phase in a wave.
fn resolution(code: f64) -> Result<f64, String> {
    match code {
        0.0 => Ok(4096.0),
        1.0 => Ok(32768.0),
        2.0 => Ok(131072.0),
        _ => Err(format!("phase resolution {code}, known are 0, 1, 2")),
    }
}

/// A phase in steps of a height.
fn height(raw: f64, step: f64) -> f64 {
    if raw >= 2147483640.0 { f64::NAN } else { raw * step }
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    if is_text(b.data) {
        return parse_text(b);
    }
    let b = Bytes { order: ByteOrder::Big, ..b };
    let header = b.u32(6)? as usize;
    if !matches!(header, 834 | 4096) {
        return Err(b.fault(6, format!("a header of {header} bytes, not 834 or 4096")));
    }
    let shape = [b.u16(70)?.into(), b.u16(68)?.into()];
    let resolution = resolution(b.i16(218)?.into()).map_err(|what| b.fault(218, what))?;
    let [scale, wavelength, obliquity] = [b.f32(164)?, b.f32(168)?, b.f32(176)?].map(f64::from);
    let lateral = f64::from(b.f32(184)?);
    let pixel = if lateral == 0.0 { Pixel::Unknown } else { Pixel::Metres([lateral; 2]) };

    let intensity_bytes = b.u32(60)? as usize;
    let raster = b.raster(header + intensity_bytes, shape, Sample::I32)?;
    let sign = if b.i16(232)? == 0 { 1.0 } else { -1.0 };
    let step = sign * scale * wavelength * obliquity / resolution;
    let convert = move |raw| height(raw, step);
    let mut channels = vec![Channel::raster("Height", "m", pixel, raster, convert)];

    let shape = [b.u16(54)?.into(), b.u16(52)?.into()];
    let images = usize::from(b.u16(56)?);
    let bytes = 2 * shape[0] * shape[1];
    for image in (0..images).take_while(|image| bytes > 0 && (image + 1) * bytes <= intensity_bytes)
    {
        b.check_items(image as u64)?;
        let name = format!("Intensity {}", image + 1);
        // The heights are there, whatever the size of a picture beside them.
        if let Ok(raster) = b.raster(header + image * bytes, shape, Sample::U16) {
            channels.push(Channel::raster(name, "counts", pixel, raster, |raw| raw));
        }
    }
    let mut contents = Contents { channels, ..Contents::default() };
    contents.note([
        ("software date", b.text(12, 30)?),
        ("comment", b.text(80, 82)?),
        ("objective", b.text(246, 12)?),
        ("part", b.text(258, 40)?),
        ("time stamp", format!("{} s since 1970-01-01", b.i32(76)?)),
        ("wavelength", format!("{wavelength:e} m")),
    ]);
    Ok(contents)
}

fn parse_text(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
    let text = text::decode(b.data);
    let lines: Vec<&str> = text::lines(&text).map(|(_, line)| line.trim()).collect();
    // A comment can hold any sign, a line of it only "#" between quotation marks.
    let ends: Vec<usize> = (0..lines.len()).filter(|&i| lines[i] == "#").collect();
    let place = |line: usize, what: String| b.line(line + 1, what);
    let (Some(&start), true) = (ends.first(), lines.len() > 10) else {
        return Err(place(lines.len(), "the header has no end".into()));
    };
    let number = |line: usize, column: usize| {
        let cell = lines[line].split_whitespace().nth(column).unwrap_or_default();
        cell.parse::<f64>().map_err(|_| place(line, format!("{cell:?} is no number")))
    };
    let whole = |column: usize| match number(3, column)? {
        n if (0.0..=1e9).contains(&n) && n.fract() == 0.0 => Ok(n as usize),
        n => Err(place(3, format!("{n} is no whole number of points"))),
    };
    let [x0, y0, nx, ny] = [whole(0)?, whole(1)?, whole(2)?, whole(3)?];
    b.check_points([ny, nx])?;
    let lateral = number(7, 6)?;
    let pixel = if lateral > 0.0 { Pixel::Metres([lateral; 2]) } else { Pixel::Unknown };
    let (values, unit) = if lines[0].contains("XYZ") {
        let end = ends.get(1).copied().unwrap_or(lines.len());
        let mut values = vec![f64::NAN; ny * nx];
        let mut listed = 0;
        let listed_lines = lines[..end].iter().enumerate().skip(start + 1);
        for (i, line) in listed_lines.filter(|(_, line)| !line.is_empty()) {
            let mut cells = line.splitn(3, char::is_whitespace).map(str::trim);
            let (Some(x), Some(y), Some(z)) = (cells.next(), cells.next(), cells.next()) else {
                return Err(place(i, format!("{line:?} is no x, y, height")));
            };
            let side = |text: &str, first: usize, count: usize| {
                let n = text.parse::<usize>().ok()?.checked_sub(first)?;
                (n < count).then_some(n)
            };
            let (Some(ix), Some(iy)) = (side(x, x0, nx), side(y, y0, ny)) else {
                return Err(place(i, format!("point {x}, {y} is not in the map of line 4")));
            };
            listed += 1;
            if z != "No Data" {
                values[iy * nx + ix] =
                    z.parse().map_err(|_| place(i, format!("{z:?} is no height")))?;
            }
        }
        if ends.len() < 2 && listed < nx * ny {
            return Err(place(end, "the list has no end: the file was cut off".into()));
        }
        (values, "um")
    } else {
        let phase = match ends[..] {
            [.., from, to] => from + 1..to,
            _ => return Err(place(lines.len(), "the phase has no end".into())),
        };
        let resolution = resolution(number(10, 0)?).map_err(|what| place(10, what))?;
        let step = number(7, 1)? * number(7, 2)? * number(7, 4)? / resolution;
        let mut values = Vec::new();
        for raw in phase.flat_map(|i| b.numbers((i + 1, lines[i]))) {
            values.push(height(raw?, step));
        }
        (values, "m")
    };
    if values.len() != nx * ny {
        let what = format!("{} heights for {ny} x {nx} points", values.len());
        return Err(b.field("phase", what));
    }
    let mut contents = Contents::default();
    let said = |line: usize| lines[line].trim_matches('"').trim().to_owned();
    let wavelength = format!("{:e} m", number(7, 2)?);
    contents.note([("comment", said(4)), ("part", said(6)), ("wavelength", wavelength)]);
    contents.channels.push(Channel::new("Height", Some(unit), [ny, nx], pixel, || Ok(values)));
    Ok(contents)
}
