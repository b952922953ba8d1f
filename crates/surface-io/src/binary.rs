//! Checked access to bytes: every read either lies inside the file or is an error with its offset.

use crate::encoding::decode;
use crate::{ReadError, ReadOptions};
use std::borrow::Cow;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ByteOrder {
    Little,
    Big,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sample {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Sample {
    pub(crate) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    pub(crate) fn whole(bytes: usize, is_signed: bool) -> Option<Self> {
        Some(match (bytes, is_signed) {
            (1, true) => Self::I8,
            (1, false) => Self::U8,
            (2, true) => Self::I16,
            (2, false) => Self::U16,
            (4, true) => Self::I32,
            (4, false) => Self::U32,
            (8, true) => Self::I64,
            (8, false) => Self::U64,
            _ => return None,
        })
    }

    /// As NumPy calls them: `u1`, `i4`, `f8`.
    pub(crate) fn called(name: &str) -> Option<Self> {
        match name.split_at_checked(1)? {
            ("f", "4") => Some(Self::F32),
            ("f", "8") => Some(Self::F64),
            (kind @ ("i" | "u"), bytes) => Self::whole(bytes.parse().ok()?, kind == "i"),
            _ => None,
        }
    }

    /// The one of a number, which counts these names from 0.
    pub(crate) fn of_number(number: usize, names: &str) -> Option<Self> {
        Self::called(names.split(' ').nth(number)?)
    }

    /// Whole numbers of 8, 16 or 32 bits.
    pub(crate) fn of_bits(bits: usize, is_signed: bool) -> Option<Self> {
        Self::whole(bits / 8, is_signed).filter(|_| matches!(bits, 8 | 16 | 32))
    }

    /// All numbers in `bytes`, as `f64`; a last incomplete one is left out.
    pub(crate) fn decode(self, bytes: &[u8], order: ByteOrder) -> Vec<f64> {
        macro_rules! numbers {
            ($t:ty) => {
                bytes
                    .chunks_exact(size_of::<$t>())
                    .map(|raw| {
                        let raw = raw.try_into().expect("chunks_exact gives this length");
                        (match order {
                            ByteOrder::Little => <$t>::from_le_bytes(raw),
                            ByteOrder::Big => <$t>::from_be_bytes(raw),
                        }) as f64
                    })
                    .collect()
            };
        }
        #[allow(clippy::cast_lossless, reason = "one macro serves types of all widths")]
        match self {
            Self::I8 => numbers!(i8),
            Self::U8 => numbers!(u8),
            Self::I16 => numbers!(i16),
            Self::U16 => numbers!(u16),
            Self::I32 => numbers!(i32),
            Self::U32 => numbers!(u32),
            Self::I64 => numbers!(i64),
            Self::U64 => numbers!(u64),
            Self::F32 => numbers!(f32),
            Self::F64 => numbers!(f64),
        }
    }
}

/// A file in memory: its format (for messages), the order of its numbers, and what the caller says.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bytes<'a> {
    pub(crate) data: &'a [u8],
    pub(crate) format: &'static str,
    pub(crate) order: ByteOrder,
    pub(crate) options: &'a ReadOptions,
}

/// A map of stored numbers in rows, all of which are in the file.
#[derive(Clone, Copy)]
pub(crate) struct Raster<'a> {
    data: &'a [u8],
    order: ByteOrder,
    pub(crate) sample: Sample,
    /// `[ny, nx]`
    pub(crate) shape: [usize; 2],
    /// The byte behind it.
    pub(crate) end: usize,
}

impl Raster<'_> {
    pub(crate) fn values(self) -> Vec<f64> {
        self.sample.decode(self.data, self.order)
    }
}

macro_rules! getter {
    ($($name:ident -> $t:ty),*) => {$(
        pub(crate) fn $name(&self, at: usize) -> Result<$t, ReadError> {
            let raw = self.slice(at, size_of::<$t>())?;
            let raw = raw.try_into().expect("slice has this length");
            Ok(match self.order {
                ByteOrder::Little => <$t>::from_le_bytes(raw),
                ByteOrder::Big => <$t>::from_be_bytes(raw),
            })
        }
    )*};
}

impl<'a> Bytes<'a> {
    pub(crate) fn little(data: &'a [u8], format: &'static str, options: &'a ReadOptions) -> Self {
        Self { data, format, order: ByteOrder::Little, options }
    }

    /// Other bytes of the same file: unpacked, or a part.
    pub(crate) fn with(self, data: &'a [u8]) -> Self {
        Self { data, ..self }
    }

    getter!(u8 -> u8, i16 -> i16, u16 -> u16, i32 -> i32, u32 -> u32, u64 -> u64, f32 -> f32, f64 -> f64);

    pub(crate) fn slice(&self, at: usize, length: usize) -> Result<&'a [u8], ReadError> {
        at.checked_add(length).and_then(|end| self.data.get(at..end)).ok_or_else(|| {
            let size = self.data.len();
            self.fault(at, format!("{length} bytes expected here, the data end at byte {size}"))
        })
    }

    /// Text of at most `length` bytes from `at`: up to the first NUL, UTF-8 or else Latin-1.
    pub(crate) fn text(&self, at: usize, length: usize) -> Result<String, ReadError> {
        Ok(text(self.slice(at, length)?))
    }

    pub(crate) fn samples(
        &self,
        at: usize,
        count: usize,
        sample: Sample,
    ) -> Result<Vec<f64>, ReadError> {
        let length = count
            .checked_mul(sample.size())
            .ok_or_else(|| self.fault(at, format!("{count} numbers cannot be addressed")))?;
        Ok(sample.decode(self.slice(at, length)?, self.order))
    }

    /// `ny` rows of `nx` numbers from `at`, each `stride` bytes behind the one before.
    pub(crate) fn rows(
        &self,
        at: usize,
        [ny, nx]: [usize; 2],
        stride: usize,
        sample: Sample,
    ) -> Result<Vec<f64>, ReadError> {
        let mut values = Vec::with_capacity(ny * nx);
        for iy in 0..ny {
            values.extend(self.samples(at + iy * stride, nx, sample)?);
        }
        Ok(values)
    }

    /// The map of `shape` points from `at`.
    pub(crate) fn raster(
        &self,
        at: usize,
        shape: [usize; 2],
        sample: Sample,
    ) -> Result<Raster<'a>, ReadError> {
        self.check_points(shape)?;
        let length = self.map_length(at, shape, sample)?;
        let data = self.slice(at, length)?;
        Ok(Raster { data, order: self.order, sample, shape, end: at + length })
    }

    /// Bytes of a map of `shape` points, after checking that they lie inside the file.
    pub(crate) fn map_length(
        &self,
        at: usize,
        [ny, nx]: [usize; 2],
        sample: Sample,
    ) -> Result<usize, ReadError> {
        let length = ny.checked_mul(nx).and_then(|n| n.checked_mul(sample.size()));
        let length = length.ok_or_else(|| {
            self.fault(at, format!("{ny} x {nx} points are more than can be addressed"))
        })?;
        self.slice(at, length).map_err(|_| {
            let size = self.data.len();
            let what = format!(
                "{ny} x {nx} points need {length} bytes from here, the data end at byte {size}"
            );
            self.fault(at, what)
        })?;
        Ok(length)
    }

    /// The rest from byte `at`, as a file of its own.
    pub(crate) fn from(&self, at: usize) -> Result<Self, ReadError> {
        let data = self.data.get(at..).ok_or_else(|| self.fault(at, "the file ends before"))?;
        Ok(self.with(data))
    }

    pub(crate) fn check_points(&self, shape: [usize; 2]) -> Result<(), ReadError> {
        self.options.limits.check_points(self.format, shape)
    }

    pub(crate) fn check_items(&self, count: u64) -> Result<(), ReadError> {
        self.options.limits.check_items(self.format, count)
    }

    pub(crate) fn fault(&self, at: usize, what: impl Into<Cow<'static, str>>) -> ReadError {
        self.field(format!("byte {at}"), what)
    }

    pub(crate) fn line(&self, line: usize, what: impl Into<Cow<'static, str>>) -> ReadError {
        self.field(format!("line {line}"), what)
    }

    /// The numbers in a line of text, NaN where it says `BAD`.
    pub(crate) fn numbers(
        &self,
        (line, text): (usize, &str),
    ) -> impl Iterator<Item = Result<f64, ReadError>> {
        let number = move |word: &str| match word.parse::<f64>() {
            Ok(value) => Ok(value),
            Err(_) if word.eq_ignore_ascii_case("bad") => Ok(f64::NAN),
            Err(_) => {
                let word: String = word.chars().take(40).collect();
                Err(self.line(line, format!("{word:?} is no number")))
            }
        };
        text.split_whitespace().map(number)
    }

    pub(crate) fn field(
        &self,
        name: impl Into<Cow<'static, str>>,
        what: impl Into<Cow<'static, str>>,
    ) -> ReadError {
        ReadError::at(self.format, name, what)
    }

    pub(crate) fn unsupported(&self, feature: impl Into<Cow<'static, str>>) -> ReadError {
        ReadError::unsupported(self.format, feature)
    }
}

/// A place in a file, behind what was read last.
#[derive(Clone, Copy)]
pub(crate) struct Cursor<'a> {
    pub(crate) b: Bytes<'a>,
    pub(crate) at: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) fn take(&mut self, length: usize) -> Result<&'a [u8], ReadError> {
        let raw = self.b.slice(self.at, length)?;
        self.at += length;
        Ok(raw)
    }

    pub(crate) fn number(&mut self, sample: Sample) -> Result<f64, ReadError> {
        let raw = self.take(sample.size())?;
        Ok(sample.decode(raw, self.b.order)[0])
    }

    pub(crate) fn word(&mut self) -> Result<usize, ReadError> {
        let word = self.b.u32(self.at)?;
        self.at += 4;
        Ok(word as usize)
    }

    /// A text behind its length.
    pub(crate) fn text(&mut self) -> Result<String, ReadError> {
        let length = self.word()?;
        Ok(text(self.take(length)?))
    }
}

/// Text up to the first NUL, trimmed: UTF-8, or Latin-1 where that fails.
pub(crate) fn text(raw: &[u8]) -> String {
    let end = raw.iter().position(|&b| b == 0).unwrap_or(raw.len());
    decode(&raw[..end]).trim().to_owned()
}

pub(crate) fn find(hay: &[u8], needle: &[u8]) -> Option<usize> {
    hay.windows(needle.len()).position(|w| w == needle)
}
