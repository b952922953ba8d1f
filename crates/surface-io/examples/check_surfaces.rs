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
use surface_io::{HeightUnit, Layout, Measurement, ReadError, ReadOptions, read};

fn main() -> ExitCode {
    match run() {
        Ok(wrong) => ExitCode::from(u8::from(wrong > 0)),
        Err(what) => {
            println!("{what}");
            ExitCode::from(2)
        }
    }
}

/// Checks every file and counts those that are wrong.
fn run() -> Result<usize, String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let value = |name: &str| {
        let place = arguments.iter().position(|a| a == name);
        let value = place.and_then(|i| arguments.get(i + 1));
        value.ok_or("usage: check_surfaces --dir DIR --expected FILE")
    };
    let (dir, expected) = (value("--dir")?, value("--expected")?);
    let unread = |e: &dyn std::error::Error| format!("cannot read {expected}: {e}");
    let text = std::fs::read_to_string(expected).map_err(|e| unread(&e))?;
    let json: Value = serde_json::from_str(&text).map_err(|e| unread(&e))?;
    let table = json.get("files").unwrap_or(&json).as_object();
    let table =
        table.filter(|t| !t.is_empty()).ok_or_else(|| format!("{expected} holds no entries"))?;
    let mut wrong = 0;
    for (name, entry) in table {
        let start = Instant::now();
        let found = check(Path::new(dir), name, entry);
        wrong += usize::from(found.is_err());
        let verdict = if found.is_ok() { "ok   " } else { "WRONG" };
        let text = found.unwrap_or_else(|what| what);
        println!("{verdict} {name:44} {:7.1} ms  {text}", 1e3 * start.elapsed().as_secs_f64());
    }
    println!("{} entries, {wrong} wrong", table.len());
    Ok(wrong)
}

fn check(dir: &Path, name: &str, entry: &Value) -> Result<String, String> {
    let (file, channel) = name.split_once('#').map_or((name, None), |(f, c)| (f, Some(c)));
    let path = dir.join(file);
    let expected = &entry["expected"];
    let number = |key: &str| expected.get(key).and_then(Value::as_f64);
    let word = |key: &str| expected.get(key).and_then(Value::as_str);
    let channel = channel.or_else(|| word("channel")).map(str::to_owned);
    let mut options = ReadOptions { channel, ..ReadOptions::default() };
    if let Some(said) = entry.get("read") {
        options = reading(said, options);
    }
    let first = read(&path, &options);
    if expected.is_string() {
        return match first {
            Err(e @ ReadError::Io { .. }) => Err(e.to_string()),
            Err(e) => Ok(format!("refused: {e}")),
            Ok(m) => Err(format!("read as {} although it must be refused", m.format)),
        };
    }
    let is_bare = expected.get("file_unit").is_some_and(|u| u.as_str().is_none_or(str::is_empty));
    let missing_scale = matches!(first, Err(ReadError::MissingScale { .. }));
    if word("truth").is_some() || entry.get("read").is_some() || !is_bare && !missing_scale {
        let measurement = first.map_err(|e| e.to_string())?;
        if let Some(truth) = word("truth") {
            point_by_point(&measurement, &dir.join(truth), expected)?;
        }
        return compare(&measurement, expected, "");
    }
    let dx = number("dx_m").unwrap_or(1.0);
    options.pixel = Some([number("dy_m").unwrap_or(dx), dx]);
    let mut result = Err(String::new());
    for (unit, name) in [(1.0, "m"), (1e-6, "um"), (1e-9, "nm"), (1e-3, "mm")] {
        options.height_unit = Some(HeightUnit::Always(unit));
        let measurement = read(&path, &options).map_err(|e| e.to_string())?;
        let note = format!("with --pixel and --height-unit {name}; ");
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
    let mut pairs = pairs.enumerate();
    let far = pairs.find(|(_, (found, wanted))| (*found - *wanted).abs() > tolerance);
    far.map_or(Ok(()), |(i, (found, wanted))| {
        Err(format!("point {i} is {found:e} m, expected {wanted:e} m"))
    })
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
    let is_profile = expected.get("rows").is_none() && expected.get("truth").is_none();
    if is_profile != m.is_profile() {
        return Err(format!("{note}profile: {}, expected {is_profile}", m.is_profile()));
    }
    // f64 rounding of the sums, on top of 1e-9 of the relief; f32 files say so in their note.
    let rounding = 8.0 * f64::EPSILON * max.abs().max(min.abs());
    // The scale of SUR is an f32.
    let is_sur = m.format == "Digital Surf SUR";
    let scale = if is_sur { f64::from(f32::EPSILON) / 2.0 } else { TOLERANCE };
    let of_heights = (scale * (max - min)).max(half_quantum(m)) + rounding;
    let of_slopes = |slope: f64| 1e-8 * slope + 2.0 * of_heights / dx.min(dy);
    let [slope_x, slope_y] = [(1, dx), (nx, dy)].map(|(step, pitch)| rms_slope(m, step, pitch));
    // Expected profiles list the range divided by N; the distance of points is range/(N - 1).
    let listed = if is_profile { dx * (nx as f64 - 1.0) / nx as f64 } else { dx };
    let is_listed = number("dx_m").is_some_and(|wanted| (listed / wanted - 1.0).abs() < 1e-9);
    for (key, value, tolerance) in [
        ("rows", ny as f64, 0.0),
        ("cols", nx as f64, 0.0),
        ("n", (ny * nx) as f64, 0.0),
        ("n_undefined", m.missing() as f64, 0.0),
        ("min", min, of_heights),
        ("max", max, of_heights),
        ("mean", mean, of_heights),
        ("Sa", mean_abs, of_heights),
        ("Sq", rms, of_heights),
        ("Rq", rms, of_heights),
        ("dx_m", if is_listed { listed } else { dx }, scale.max(1e-9) * dx),
        ("dy_m", if is_listed && is_profile { listed } else { dy }, scale.max(1e-9) * dy),
        ("rms_slope_x_fwd", slope_x, of_slopes(slope_x)),
        ("rms_slope_y_fwd", slope_y, of_slopes(slope_y)),
    ] {
        let wanted = number(key).filter(|_| !(is_profile && key.starts_with("rms_slope")));
        let is_near = |wanted: f64| (value - wanted).abs() <= tolerance;
        if let Some(wanted) = wanted.filter(|wanted| !is_near(*wanted)) {
            return Err(format!("{note}{key} = {value:e}, expected {wanted:e}"));
        }
    }
    if let Some(uneven) = m.uneven {
        let _ = write!(note, "uneven by {uneven:.2} steps; ");
    }
    Ok(format!("{note}{ny} x {nx}, {} missing, pixel {dx:e} x {dy:e} m", m.missing()))
}

/// Of the range of heights: far below the quantum of any of the files.
const TOLERANCE: f64 = 1e-9;

/// Half the smallest step between printed heights: text is rounded. 0 for binary formats.
fn half_quantum(m: &Measurement) -> f64 {
    if m.format != "text" {
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
