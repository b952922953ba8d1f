//! The text exports of Zygo's MetroPro: "XYZ Data File - Format 1", "ASCII Data File - Format 2".
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
//! 2147483640 on, as in the [binary format](super::zygo).
//!
//! Source: Zygo, *MetroPro Reference Guide* OMP-0347, appendix on the data format; public exports.
//! Format 2 was not checked against a real file.

use super::prelude::*;
use crate::text;

pub(crate) fn sniff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"Zygo XYZ Data File") || bytes.starts_with(b"Zygo ASCII Data File")
}

pub(crate) fn parse(b: Bytes<'_>) -> Result<Contents<'_>, ReadError> {
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
    let mut origin = [0usize; 4];
    for (column, value) in origin.iter_mut().enumerate() {
        let found = number(3, column)?;
        if !(0.0..=1e9).contains(&found) || found.fract() != 0.0 {
            return Err(place(3, format!("{found} is no whole number of points")));
        }
        *value = found as usize;
    }
    let [x0, y0, nx, ny] = origin;
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
        let resolution = match number(10, 0)? {
            0.0 => 4096.0,
            1.0 => 32768.0,
            2.0 => 131_072.0,
            code => return Err(place(10, format!("phase resolution {code}, known are 0, 1, 2"))),
        };
        let step = number(7, 1)? * number(7, 2)? * number(7, 4)? / resolution;
        let mut values = Vec::new();
        for i in phase {
            let height = |raw| if raw >= 2_147_483_640.0 { f64::NAN } else { raw * step };
            for raw in b.numbers((i + 1, lines[i])) {
                values.push(height(raw?));
            }
        }
        (values, "m")
    };
    if values.len() != nx * ny {
        let what = format!("{} heights for {ny} x {nx} points", values.len());
        return Err(b.field("phase", what));
    }
    let mut contents = Contents::default();
    for (key, line) in [("comment", 4), ("part", 6)] {
        contents.note(key, Some(lines[line].trim_matches('"').trim()));
    }
    contents.metadata.insert("wavelength".into(), format!("{:e} m", number(7, 2)?));
    contents.channels.push(Channel::new("Height", Some(unit), [ny, nx], pixel, || Ok(values)));
    Ok(contents)
}
