//! The sample surface of every format, made by code: 5 x 7 points, h = 1 nm ix + 100 nm iy, the
//! point (1, 2) missing, pixel 2 um x 3 um. A flip, a transposition, a lost unit or a lost mask
//! all show.
#![allow(dead_code, unreachable_pub, reason = "every test file uses a part of it")]
#![allow(
    clippy::unwrap_used,
    clippy::format_push_string,
    clippy::cast_possible_wrap,
    reason = "builds test input"
)]

pub mod binary;
pub mod instruments;
pub mod microscopes;
pub mod mountains;

use surface_io::{HeightUnit, Layout, Measurement, ReadError, ReadOptions, read_bytes};

pub const NY: usize = 5;
pub const NX: usize = 7;
pub const DX: f64 = 2e-6;
pub const DY: f64 = 3e-6;
pub const MISSING: (usize, usize) = (1, 2);

/// Height in nm.
pub fn nanometres(iy: usize, ix: usize) -> f64 {
    (ix + 100 * iy) as f64
}

/// All points, row-major; `missing` at the missing one.
pub fn points(missing: f64) -> Vec<f64> {
    let mut values = Vec::new();
    for iy in 0..NY {
        for ix in 0..NX {
            values.push(if (iy, ix) == MISSING { missing } else { nanometres(iy, ix) });
        }
    }
    values
}

/// One file of one format.
pub struct SampleFile {
    pub name: &'static str,
    pub bytes: Vec<u8>,
    pub options: ReadOptions,
    /// The format has a mark for missing points.
    pub can_miss: bool,
    /// A prefix of a text file can be a sound smaller file.
    pub is_text: bool,
}

impl SampleFile {
    pub fn new(name: &'static str, bytes: Vec<u8>) -> Self {
        let options = ReadOptions::default();
        Self { name, bytes, options, can_miss: true, is_text: false }
    }

    pub fn text(name: &'static str, text: &str) -> Self {
        Self { is_text: true, ..Self::new(name, text.as_bytes().to_vec()) }
    }

    pub fn read(&self) -> Result<Measurement, ReadError> {
        read_bytes(&self.bytes, &self.options)
    }

    pub fn complete(mut self) -> Self {
        self.can_miss = false;
        self
    }

    pub fn with_pixel(mut self) -> Self {
        self.options.pixel = Some([DY, DX]);
        self
    }

    /// Neither pixel nor unit is in the file, and the heights are in nm.
    pub fn bare(mut self) -> Self {
        self.options.height_unit = Some(HeightUnit::IfSilent(1e-9));
        self.with_pixel()
    }
}

/// Options that say more.
pub trait SayMore: Sized {
    fn and(self, say: impl FnOnce(&mut ReadOptions)) -> Self;

    fn channel(self, name: &str) -> Self {
        self.and(|options| options.channel = Some(name.into()))
    }

    fn layout(self, layout: Layout) -> Self {
        self.and(|options| options.layout = Some(layout))
    }

    fn lateral(self, metres: f64) -> Self {
        self.and(|options| options.lateral_unit = Some(metres))
    }

    fn height(self, unit: HeightUnit) -> Self {
        self.and(|options| options.height_unit = Some(unit))
    }
}

impl SayMore for ReadOptions {
    fn and(mut self, say: impl FnOnce(&mut ReadOptions)) -> Self {
        say(&mut self);
        self
    }
}

/// What is read with nothing said.
pub fn unaided(bytes: impl AsRef<[u8]>) -> Result<Measurement, ReadError> {
    read_bytes(bytes.as_ref(), &ReadOptions::default())
}

/// Panics unless a reading is refused with all these words.
pub fn assert_refused(reading: Result<Measurement, ReadError>, words: &[&str]) {
    let error = reading.expect_err("refused").to_string();
    assert!(words.iter().all(|word| error.contains(word)), "{error}, not {words:?}");
}

/// With this pixel and height unit (m) where the file is silent.
pub fn scaled(pixel: f64, height: f64) -> ReadOptions {
    let height_unit = Some(HeightUnit::IfSilent(height));
    ReadOptions { pixel: Some([pixel; 2]), height_unit, ..ReadOptions::default() }
}

/// With these units of x and y and of the heights (m) where the file is silent.
pub fn units(lateral: f64, height: f64) -> ReadOptions {
    let height_unit = Some(HeightUnit::IfSilent(height));
    ReadOptions { lateral_unit: Some(lateral), height_unit, ..ReadOptions::default() }
}

/// Panics unless `found` is the sample surface, as exactly as an f32 can say it.
pub fn assert_sample(name: &str, found: &Measurement, can_miss: bool) {
    assert_eq!(found.grid().shape(), [NY, NX], "{name}: shape");
    let [dy, dx] = found.grid().pixel();
    assert!((dx / DX - 1.0).abs() < 1e-7, "{name}: dx = {dx:e}");
    assert!((dy / DY - 1.0).abs() < 1e-7, "{name}: dy = {dy:e}");
    assert_eq!(found.missing(), usize::from(can_miss), "{name}: missing");
    let expected = points(if can_miss { f64::NAN } else { nanometres(1, 2) });
    for (i, (h, e)) in found.heights().iter().zip(&expected).enumerate() {
        let is_equal = (h.is_nan() && e.is_nan()) || (h - e * 1e-9).abs() < 1e-13;
        assert!(is_equal, "{name}: row {}, column {}: {h:e}, not {e} nm", i / NX, i % NX);
    }
}

/// Matrix in nm with a separator, decimal mark and mark for the missing point.
fn matrix(separator: &str, comma: bool, missing: &str, end: &str) -> String {
    let mut text = String::new();
    for row in points(f64::NAN).chunks(NX) {
        let cells: Vec<String> = row
            .iter()
            .map(|h| match (h.is_nan(), comma) {
                (true, _) => missing.to_owned(),
                (false, true) => format!("{h:.2}").replace('.', ","),
                (false, false) => format!("{h:.2}"),
            })
            .collect();
        text += &cells.join(separator);
        text += end;
    }
    text
}

/// As a table program writes it, with running numbers.
fn framed() -> String {
    let mut text = String::from(",0,1,2,3,4,5,6\n");
    for (iy, row) in matrix(",", false, "", "\n").lines().enumerate() {
        text += &format!("{iy},{row}\n");
    }
    text
}

/// x y z in um, um, nm, with the missing point left out.
fn list(order: fn(usize) -> (usize, usize)) -> String {
    let mut text = String::from("X [um]\tY [um]\tZ [nm]\n");
    for i in 0..NY * NX {
        let (iy, ix) = order(i);
        if (iy, ix) != MISSING {
            let (x, y) = (10.0 + 2.0 * ix as f64, -4.0 + 3.0 * iy as f64);
            text += &format!("{x}\t{y}\t{}\n", nanometres(iy, ix));
        }
    }
    text
}

/// The sample of this name.
pub fn sample(name: &str) -> SampleFile {
    samples().into_iter().find(|sample| sample.name == name).unwrap()
}

/// Every sample.
pub fn samples() -> Vec<SampleFile> {
    let header = "# Channel: Z\n# Width: 14 \u{b5}m\n# Height: 15 um\n# Value units: nm\n";
    let latin1 = binary::latin1(&format!("{header}{}", matrix("\t", false, "NaN", "\r\n")));
    let utf16 = binary::utf16(&format!("\u{feff}{header}{}", matrix(";", true, "", "\n")));
    let mut samples = vec![
        SampleFile::text("text, tabs", &format!("{header}{}", matrix("\t", false, "", "\n"))),
        SampleFile::text(
            "text, blanks",
            &format!("{header}{}", matrix("  ", false, "bad", "\r\n")),
        ),
        SampleFile::text("text, data frame", &framed()).bare(),
        SampleFile::text("text, commas", &format!("{header}{}", matrix(",", false, "", ",\n"))),
        SampleFile::text("text, semicolons", &matrix(";", true, "", "\n")).bare(),
        SampleFile::text("text, decimal comma", &matrix(" ", true, "---", "\r")).bare(),
        SampleFile { is_text: true, ..SampleFile::new("text, Latin-1", latin1) },
        SampleFile { is_text: true, ..SampleFile::new("text, UTF-16", utf16) },
        SampleFile::text("list, rows", &list(|i| (i / NX, i % NX))),
        SampleFile::text("list, any order", &list(|i| ((i * 12 % 35) / NX, (i * 12 % 35) % NX))),
    ];
    samples.extend(binary::samples());
    samples.extend(instruments::samples());
    samples.extend(microscopes::samples());
    samples.extend(mountains::samples());
    samples
}

/// Writes over the first place where `from` stands.
pub fn replace(file: &mut [u8], from: &[u8], to: &[u8]) {
    let at = file.windows(from.len()).position(|w| w == from).unwrap();
    file[at..at + to.len()].copy_from_slice(to);
}
