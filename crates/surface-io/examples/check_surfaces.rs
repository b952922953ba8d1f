//! Checks every file of a folder against expected values and prints one line each.
//!
//! `cargo run --release -p surface-io --example check_surfaces -- --dir DIR --expected FILE`
//!
//! FILE is JSON: an object of entries by path (or `{"files": {...}}`), each with `expected`: an
//! object with `rows`, `cols`, `n_undefined`, `min`, `max`, `mean`, `Sa`, `Sq`, slopes, `dx_m`,
//! `dy_m` (SI units) for a map, with `n` and `Rq` for a profile, or a text for a file that must
//! be refused. A `file_unit` of null or "" says that the expected values are the bare numbers of
//! the file; it is then read with `--height-unit m` and the expected pixel.
//!
//! In place of statistics, `truth` names an NPY file in DIR whose numbers, in units of `unit_m`, are the
//! heights point by point. `read` of an entry says what the file does not: `channel`, `layout`, `pixel`,
//! `lateral_unit`, `height_unit`, `override_height_unit` (m), `missing`.
//!
//! Exit status 1 if any line is wrong.
#![allow(clippy::print_stdout, reason = "the table is the output")]

use contact_types::Named;
use serde_json::Value;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use surface_io::{Format, HeightUnit, Layout, Measurement, ReadError, ReadOptions, read};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str| {
        arguments.iter().position(|a| a == name).and_then(|i| arguments.get(i + 1)).cloned()
    };
    let (Some(dir), Some(expected)) = (value("--dir"), value("--expected")) else {
        println!("usage: check_surfaces --dir DIR --expected FILE");
        return ExitCode::from(2);
    };
    let parsed = std::fs::read_to_string(&expected)
        .map_err(|e| e.to_string())
        .and_then(|text| serde_json::from_str::<Value>(&text).map_err(|e| e.to_string()));
    let table = match &parsed {
        Ok(json) => json.get("files").unwrap_or(json).as_object(),
        Err(e) => {
            println!("cannot read {expected}: {e}");
            return ExitCode::from(2);
        }
    };
    let Some(table) = table.filter(|t| !t.is_empty()) else {
        println!("{expected} holds no entries");
        return ExitCode::from(2);
    };
    let (mut wrong, mut not_read) = (0, 0);
    for (name, entry) in table {
        let start = Instant::now();
        let (verdict, text) = match check(Path::new(&dir), name, entry) {
            Ok(text) if text.starts_with(NOT_READ) => {
                not_read += 1;
                ("-    ", text)
            }
            Ok(text) => ("ok   ", text),
            Err(text) => {
                wrong += 1;
                ("WRONG", text)
            }
        };
        println!("{verdict} {name:44} {:7.1} ms  {text}", 1e3 * start.elapsed().as_secs_f64());
    }
    println!("{} entries, {wrong} wrong, {not_read} of formats that are not read", table.len());
    ExitCode::from(u8::from(wrong > 0))
}

/// A format that is recognised and refused: neither right nor wrong.
const NOT_READ: &str = "not read";

fn check(dir: &Path, name: &str, entry: &Value) -> Result<String, String> {
    let (file, channel) = match name.split_once('#') {
        Some((file, channel)) => (file, Some(channel.to_owned())),
        None => (name, None),
    };
    let path = dir.join(file);
    if !path.is_file() {
        return Err("the file is not there".into());
    }
    let mut options = ReadOptions::default();
    let mut given = String::new();
    options.channel = channel
        .or_else(|| entry.pointer("/expected/channel").and_then(Value::as_str).map(str::to_owned));
    if let Some(said) = entry.get("read") {
        options = reading(said, options);
    }
    let first = read(&path, &options);
    let expected = match &entry["expected"] {
        Value::String(_) => {
            return match first {
                Ok(m) => Err(format!("read as {} although it must be refused", m.format)),
                Err(e) => Ok(format!("refused: {e}")),
            };
        }
        expected => expected,
    };
    if let Err(ReadError::Unsupported { format: Format::Mnt, .. }) = &first {
        return Ok(format!("{NOT_READ}: {}", first.err().map_or(String::new(), |e| e.to_string())));
    }
    if expected.get("truth").is_some() || entry.get("read").is_some() {
        let measurement = first.map_err(|e| e.to_string())?;
        if let Some(truth) = expected.get("truth").and_then(Value::as_str) {
            point_by_point(&measurement, &dir.join(truth), expected)?;
        }
        return compare(&measurement, expected, "");
    }
    let number = |key: &str| expected.get(key).and_then(Value::as_f64);
    let is_bare = expected.get("file_unit").is_some_and(|u| u.as_str().is_none_or(str::is_empty));
    let missing_scale = matches!(first, Err(ReadError::MissingScale { .. }));
    if !is_bare && !missing_scale {
        return compare(&first.map_err(|e| e.to_string())?, expected, "");
    }
    if missing_scale {
        given += "the file gives no scale; ";
    }
    let dx = number("dx_m").unwrap_or(1.0);
    options.pixel = Some([number("dy_m").unwrap_or(dx), dx]);
    let mut result = Err(String::new());
    for (unit, name) in [(1.0, "m"), (1e-6, "um"), (1e-9, "nm"), (1e-3, "mm")] {
        options.height_unit = Some(HeightUnit::Always(unit));
        let measurement = read(&path, &options).map_err(|e| e.to_string())?;
        let note = format!("{given}with --pixel and --height-unit {name}; ");
        result = compare(&measurement, expected, &note);
        if result.is_ok() || is_bare {
            break;
        }
    }
    result
}

/// What is said of a file.
fn reading(said: &Value, mut options: ReadOptions) -> ReadOptions {
    let number = |key: &str| said.get(key).and_then(Value::as_f64);
    let word = |key: &str| said.get(key).and_then(Value::as_str);
    options.channel = word("channel").map(str::to_owned).or(options.channel);
    options.layout = word("layout").and_then(Layout::of_name);
    options.pixel = number("pixel").map(|pixel| [pixel; 2]);
    options.lateral_unit = number("lateral_unit");
    options.height_unit = match number("override_height_unit") {
        Some(metres) => Some(HeightUnit::Always(metres)),
        None => number("height_unit").map(HeightUnit::IfSilent),
    };
    options.missing.extend(word("missing").map(str::to_owned));
    options
}

/// Compares every height with those of an NPY file.
fn point_by_point(m: &Measurement, truth: &Path, expected: &Value) -> Result<(), String> {
    let unit = expected.get("unit_m").and_then(Value::as_f64).unwrap_or(1.0);
    let options = ReadOptions {
        pixel: Some([1.0; 2]),
        height_unit: Some(HeightUnit::IfSilent(unit)),
        ..ReadOptions::default()
    };
    let truth = read(truth, &options).map_err(|e| e.to_string())?;
    if truth.grid().shape() != m.grid().shape() {
        return Err(format!("{:?} points, expected {:?}", m.grid().shape(), truth.grid().shape()));
    }
    let undefined = expected.get("n_undefined").and_then(Value::as_u64).unwrap_or(0);
    if undefined != m.missing() as u64 {
        return Err(format!("{} points missing, expected {undefined}", m.missing()));
    }
    let range = truth.height_summary().map_or(0.0, |(low, high, _)| high - low);
    // What is not in the file to its last digit says so.
    let digits = expected.get("rounding").and_then(Value::as_f64).unwrap_or(0.0);
    let tolerance = TOLERANCE * range + half_quantum(m).max(digits);
    let pairs = m.heights().iter().zip(truth.heights());
    match pairs.enumerate().find(|(_, (found, wanted))| (*found - *wanted).abs() > tolerance) {
        Some((i, (found, wanted))) => {
            Err(format!("point {i} is {found:e} m, expected {wanted:e} m"))
        }
        None => Ok(()),
    }
}

/// Compares everything the expected values hold; the first difference is the error.
fn compare(m: &Measurement, expected: &Value, note: &str) -> Result<String, String> {
    let number = |key: &str| expected.get(key).and_then(Value::as_f64);
    let mut note = format!("{}: {note}", m.format);
    let [ny, nx] = m.grid().shape();
    let [dy, dx] = m.grid().pixel();
    let (min, max, mean) = m.height_summary().unwrap_or((f64::NAN, f64::NAN, f64::NAN));
    let valid = || m.heights().iter().filter(|h| !h.is_nan()).map(|h| h - mean);
    let n = valid().count() as f64;
    let mean_abs = valid().map(f64::abs).sum::<f64>() / n;
    let rms = (valid().map(|h| h * h).sum::<f64>() / n).sqrt();
    for (key, value) in [("rows", ny), ("cols", nx), ("n", ny * nx), ("n_undefined", m.missing())] {
        if let Some(wanted) = number(key)
            && wanted as usize != value
        {
            return Err(format!("{note}{key} = {value}, expected {wanted}"));
        }
    }
    let range = max - min;
    // f64 rounding of the sums, on top of 1e-9 of the relief; f32 files say so in their note.
    let rounding = 8.0 * f64::EPSILON * max.abs().max(min.abs());
    // The scale of SUR is an f32.
    let scale = if m.format == Format::Sur { f64::from(f32::EPSILON) / 2.0 } else { TOLERANCE };
    let tolerance = (scale * range).max(half_quantum(m)) + rounding;
    let mut worst: f64 = 0.0;
    for (key, value) in
        [("min", min), ("max", max), ("mean", mean), ("Sa", mean_abs), ("Sq", rms), ("Rq", rms)]
    {
        if let Some(wanted) = number(key) {
            let error = (value - wanted).abs();
            if error > tolerance {
                return Err(format!("{note}{key} = {value:e}, expected {wanted:e}"));
            }
            worst = worst.max(if range > 0.0 { error / range } else { 0.0 });
        }
    }
    let is_profile = expected.get("rows").is_none() && expected.get("truth").is_none();
    if is_profile != m.is_profile() {
        return Err(format!("{note}profile: {}, expected {is_profile}", m.is_profile()));
    }
    for (key, value) in [("dx_m", dx), ("dy_m", dy)] {
        let Some(wanted) = number(key) else { continue };
        // Expected profiles list the range divided by N; the distance of points is range/(N - 1).
        let n = nx as f64;
        let by_range = is_profile && (value * (n - 1.0) / (wanted * n) - 1.0).abs() < 1e-9;
        if by_range {
            let _ = write!(note, "dx = range/(N-1) = {value:e} (listed: range/N); ");
        } else if (value / wanted - 1.0).abs() > scale.max(1e-9) {
            return Err(format!("{note}{key} = {value:e}, expected {wanted:e}"));
        }
    }
    if !is_profile {
        for (key, step, pitch) in [("rms_slope_x_fwd", 1, dx), ("rms_slope_y_fwd", nx, dy)] {
            let Some(wanted) = number(key) else { continue };
            let value = rms_slope(m, step, pitch);
            if (value - wanted).abs() > 1e-8 * wanted + 2.0 * tolerance / dx.min(dy) {
                return Err(format!("{note}{key} = {value:e}, expected {wanted:e}"));
            }
        }
    }
    if let Some(uneven) = m.uneven {
        let _ = write!(note, "uneven by {uneven:.2} steps; ");
    }
    let missing = m.missing();
    Ok(format!("{note}{ny} x {nx}, {missing} missing, pixel {dx:e} x {dy:e} m, error {worst:.0e}"))
}

/// Of the range of heights: far below the quantum of any of the files.
const TOLERANCE: f64 = 1e-9;

/// Half the smallest step between printed heights: text is rounded. 0 for binary formats.
fn half_quantum(m: &Measurement) -> f64 {
    if m.format != Format::Text {
        return 0.0;
    }
    let mut heights: Vec<f64> = m.heights().iter().copied().filter(|h| !h.is_nan()).collect();
    heights.sort_by(f64::total_cmp);
    let range = heights.last().zip(heights.first()).map_or(0.0, |(a, b)| a - b);
    let steps = heights.windows(2).map(|p| p[1] - p[0]).filter(|step| *step > 1e-9 * range);
    steps.fold(range, f64::min) / 2.0
}

/// Root mean square of the forward differences over pairs of valid points `step` apart.
fn rms_slope(m: &Measurement, step: usize, pitch: f64) -> f64 {
    let (h, [_, nx]) = (m.heights(), m.grid().shape());
    let (mut sum, mut count) = (0.0, 0.0);
    for i in 0..h.len().saturating_sub(step) {
        let difference = (h[i + step] - h[i]) / pitch;
        if (step > 1 || (i + 1) % nx != 0) && !difference.is_nan() {
            sum += difference * difference;
            count += 1.0;
        }
    }
    f64::sqrt(sum / count)
}
