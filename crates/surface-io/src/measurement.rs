//! What a file contains, before and after a channel is chosen.

use crate::binary::Raster;
use crate::cells::is_mark;
use crate::cut::Cut;
use crate::error::ReadError;
use crate::meaning::{self, UNUSED};
use crate::need::Ambiguity;
use crate::units::metres_per;
use contact_types::{Grid, HeightMap, SurfaceError};
use std::collections::BTreeMap;

/// One channel of a file.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ChannelInfo {
    /// Name as the file gives it.
    pub name: String,
    /// Unit as the file writes it; `None` if it gives none.
    pub unit: Option<String>,
    /// False if the unit says that the channel is not a height. A channel without a unit may be
    /// one.
    pub is_height: bool,
    /// `[ny, nx]`.
    pub shape: [usize; 2],
    /// `[dy, dx]` in metres; `None` if the file does not give it.
    pub pixel: Option<[f64; 2]>,
    /// One of several traces of the same surface, whose points stand at the same places.
    pub is_trace: bool,
    /// Why this channel cannot be read, if it cannot; the others can.
    pub fault: Option<String>,
}

/// What a file says about the distance of its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Pixel {
    /// `[dy, dx]` in metres.
    Metres([f64; 2]),
    /// `[dy, dx]` in a unit that the file does not name.
    Steps([f64; 2]),
    Unknown,
}

impl Pixel {
    /// `[dy, dx]` in units of so many metres; steps unless both are known.
    pub(crate) fn scaled(steps: [f64; 2], metres: [Option<f64>; 2]) -> Self {
        match metres {
            [Some(y), Some(x)] => Self::Metres([steps[0] * y, steps[1] * x]),
            _ => Self::Steps(steps),
        }
    }

    /// `[dy, dx]` in these units; unknown unless both are lengths.
    pub(crate) fn in_units([dy, dx]: [f64; 2], [y, x]: [&str; 2]) -> Self {
        match (metres_per(y), metres_per(x)) {
            (Some(y), Some(x)) => Self::Metres([dy * y, dx * x]),
            _ => Self::Unknown,
        }
    }
}

/// A channel as a reader hands it over.
pub(crate) struct Channel<'a> {
    pub(crate) info: ChannelInfo,
    /// Metres per unit; `None` if the file does not say or it is no length.
    pub(crate) scale: Option<f64>,
    pub(crate) pixel: Pixel,
    /// Largest deviation from even spacing, where it cannot be neglected, and distances of the points of such a profile
    /// from the first one; in steps.
    pub(crate) uneven: Option<(f64, Vec<f64>)>,
    /// How it was read, where the file could mean something else.
    pub(crate) ambiguity: Option<Ambiguity>,
    /// Why it cannot be read.
    pub(crate) fault: Option<ReadError>,
    /// Produces the heights in the unit of the file; NaN where a point is missing.
    pub(crate) decode: Box<dyn FnOnce() -> Result<Vec<f64>, ReadError> + 'a>,
}

impl<'a> Channel<'a> {
    /// A height map in `unit`; whether that is a length decides [`ChannelInfo::is_height`].
    pub(crate) fn new(
        name: impl Into<String>,
        unit: Option<&str>,
        shape: [usize; 2],
        pixel: Pixel,
        decode: impl FnOnce() -> Result<Vec<f64>, ReadError> + 'a,
    ) -> Self {
        let unit = unit.map(str::trim).filter(|u| !u.is_empty());
        let scale = unit.and_then(metres_per);
        let is_profile = shape[0] == 1 && shape[1] > 1;
        // The spacing of the lines of a single line is nothing, and often stored as 0.
        let is_none = |dy: f64| is_profile && !(dy > 0.0 && dy.is_finite());
        let pixel = match pixel {
            Pixel::Metres([dy, dx]) if is_none(dy) => Pixel::Metres([dx; 2]),
            Pixel::Steps([dy, dx]) if is_none(dy) => Pixel::Steps([dx; 2]),
            other => other,
        };
        let info = ChannelInfo {
            name: name.into(),
            unit: unit.map(str::to_owned),
            is_height: unit.is_none() || scale.is_some(),
            shape,
            pixel: if let Pixel::Metres(pixel) = pixel { Some(pixel) } else { None },
            is_trace: false,
            fault: None,
        };
        Self {
            info,
            scale,
            pixel,
            uneven: None,
            ambiguity: None,
            fault: None,
            decode: Box::new(decode),
        }
    }

    /// A map of stored numbers; `convert` brings one to `unit`, or to NaN if it marks a missing
    /// point.
    pub(crate) fn raster(
        name: impl Into<String>,
        unit: &str,
        pixel: Pixel,
        raster: Raster<'a>,
        convert: impl Fn(f64) -> f64 + 'a,
    ) -> Self {
        let decode = move || Ok(raster.values());
        Self::new(name, Some(unit), raster.shape, pixel, decode).converted(convert)
    }

    fn then(self, change: impl FnOnce(&mut [f64]) -> Result<(), ReadError> + 'a) -> Self {
        let decode = self.decode;
        let changed = move || {
            let mut heights = decode()?;
            change(&mut heights)?;
            Ok(heights)
        };
        Self { decode: Box::new(changed), ..self }
    }

    /// Makes the points missing that hold this mark.
    pub(crate) fn without(self, mark: Option<f64>) -> Self {
        let Some(mark) = mark else { return self };
        self.converted(move |z| if is_mark(z, mark) { f64::NAN } else { z })
    }

    /// Brings every stored number to the unit, or to NaN if it marks a missing point.
    pub(crate) fn converted(self, convert: impl Fn(f64) -> f64 + 'a) -> Self {
        self.then(move |heights| {
            for height in heights {
                *height = convert(*height);
            }
            Ok(())
        })
    }

    /// Makes the points missing whose mark is above 0.
    pub(crate) fn masked(self, marks: impl FnOnce() -> Result<Vec<f64>, ReadError> + 'a) -> Self {
        self.then(move |heights| {
            let marked = heights.iter_mut().zip(marks()?).filter(|(_, mark)| *mark > 0.0);
            marked.for_each(|(height, _)| *height = f64::NAN);
            Ok(())
        })
    }

    /// Turns the map upside down: for formats that store the bottom row first.
    pub(crate) fn flipped(self) -> Self {
        let [_, nx] = self.info.shape;
        self.then(move |heights| {
            let ny = heights.len() / nx.max(1);
            for iy in 0..ny / 2 {
                let (top, bottom) = heights.split_at_mut((ny - 1 - iy) * nx);
                top[iy * nx..(iy + 1) * nx].swap_with_slice(&mut bottom[..nx]);
            }
            Ok(())
        })
    }

    /// Turns every row around: for formats that store some of them from right to left.
    pub(crate) fn mirrored(self) -> Self {
        let [_, nx] = self.info.shape;
        self.then(move |heights| {
            heights.chunks_mut(nx.max(1)).for_each(<[f64]>::reverse);
            Ok(())
        })
    }
}

#[derive(Default)]
pub(crate) struct Contents<'a> {
    pub(crate) channels: Vec<Channel<'a>>,
    pub(crate) metadata: BTreeMap<String, String>,
}

impl<'a> Contents<'a> {
    /// Channels, and what the file says of instrument, date and settings.
    pub(crate) fn new<const N: usize>(
        channels: Vec<Channel<'a>>,
        metadata: [(&str, String); N],
    ) -> Self {
        Self { channels, metadata: metadata.map(|(key, text)| (key.to_owned(), text)).into() }
    }

    /// Keeps what the file says, unless that is nothing.
    pub(crate) fn note<T: Into<Option<String>>, const N: usize>(&mut self, said: [(&str, T); N]) {
        for (key, text) in said {
            if let Some(text) = text.into().filter(|text| !text.is_empty()) {
                self.metadata.insert(key.into(), text);
            }
        }
    }

    /// Adds a channel. One that cannot be read must not cost the others.
    pub(crate) fn add(&mut self, name: &str, channel: Result<Channel<'a>, ReadError>) {
        self.channels.push(channel.unwrap_or_else(|fault| {
            let mut channel = Channel::new(name, None, [0, 0], Pixel::Unknown, || Ok(Vec::new()));
            (channel.info.is_height, channel.info.fault) = (false, Some(fault.to_string()));
            channel.fault = Some(fault);
            channel
        }));
    }

    /// Keeps an entry that no reader understands if it looks like a size, a scale or a unit.
    pub(crate) fn not_used(&mut self, key: &str, value: &str) {
        let name = key.rsplit('/').next().unwrap_or(key);
        if meaning::is_scale(name, value) {
            let list = self.metadata.entry(UNUSED.into()).or_default();
            if list.len() < 512 {
                let separator = if list.is_empty() { "" } else { "; " };
                *list += &[separator, key, " = ", value].concat();
            }
        }
    }
}

/// A measured surface: heights in metres, some of which may be missing.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Measurement {
    pub(crate) grid: Grid,
    pub(crate) heights: Vec<f64>,
    /// Name of the format it was read from.
    pub format: &'static str,
    /// Name of the channel.
    pub channel: String,
    /// All channels of the file.
    pub channels: Vec<ChannelInfo>,
    /// What the file says of instrument, date and settings.
    pub metadata: BTreeMap<String, String>,
    /// Largest deviation of a profile's points from even spacing, in steps; `None` if they are
    /// evenly spaced as far as the digits of the file can tell.
    pub uneven: Option<f64>,
    /// Distances from the first point (m), rising, of a profile whose points are not evenly spaced.
    pub positions: Option<Vec<f64>>,
    /// How the file was read, where its numbers could as well mean something else.
    pub ambiguity: Option<Ambiguity>,
    /// `[y0, x0, ny, nx]` of what was cut out of the map of the file; `None` for all of it.
    pub cropped: Option<[usize; 4]>,
}

impl Measurement {
    /// Heights (m) of a program rather than a file, NaN where a point is missing; one row is a profile.
    ///
    /// # Errors
    /// [`SurfaceError`] of another number of heights, or of infinite ones.
    pub fn new(grid: Grid, heights: Vec<f64>) -> Result<Self, SurfaceError> {
        let known = heights.iter().map(|h| if h.is_nan() { 0.0 } else { *h }).collect();
        HeightMap::new(grid, known)?;
        Ok(Self::bare(grid, heights, "NPY"))
    }

    /// Nothing but these heights (m), as many as the grid has points.
    pub(crate) fn bare(grid: Grid, heights: Vec<f64>, format: &'static str) -> Self {
        Self {
            grid,
            heights,
            format,
            channel: String::new(),
            channels: Vec::new(),
            metadata: BTreeMap::new(),
            uneven: None,
            positions: None,
            ambiguity: None,
            cropped: None,
        }
    }

    /// The grid: `[ny, nx]` points, `[dy, dx]` metres. A profile has one row, and dy = dx.
    pub fn grid(&self) -> Grid {
        self.grid
    }

    /// Heights in metres, row-major; NaN where a point is missing. Row 0 is the first stored
    /// line of an image format, and the smallest y of a coordinate list.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Number of missing points.
    pub fn missing(&self) -> usize {
        self.heights.iter().filter(|h| h.is_nan()).count()
    }

    /// True for a single line of points, which is not a surface.
    pub fn is_profile(&self) -> bool {
        let [ny, nx] = self.grid.shape();
        ny == 1 && nx > 1
    }

    /// Lowest, highest and mean height of the points that are there, in metres; `None` if none is.
    pub fn height_summary(&self) -> Option<(f64, f64, f64)> {
        let mut valid = self.heights.iter().copied().filter(|h| !h.is_nan());
        let origin = valid.next()?;
        let (mut low, mut high, mut sum, mut count) = (origin, origin, 0.0, 1.0);
        for h in valid {
            low = h.min(low);
            high = h.max(high);
            sum += h - origin; // about one height: a common offset costs no digits
            count += 1.0;
        }
        Some((low, high, origin + sum / count))
    }

    /// Lets `change` work on the grid and the heights (m, NaN = missing), as cleaning does before
    /// missing points are filled.
    ///
    /// # Errors
    /// That of `change`.
    ///
    /// # Panics
    /// If `change` leaves another number of heights.
    pub fn edit<T, E>(
        mut self,
        change: impl FnOnce(Grid, &mut Vec<f64>) -> Result<T, E>,
    ) -> Result<(Self, T), E> {
        let answer = change(self.grid, &mut self.heights)?;
        assert_eq!(self.heights.len(), self.grid.len(), "the grid has not changed");
        Ok((self, answer))
    }

    /// Cuts out a part; [`cropped`](Self::cropped) says where it lies.
    ///
    /// # Errors
    /// [`ReadError::Crop`] unless a rectangle has points and lies inside; [`ReadError::NothingComplete`].
    pub fn crop(&self, cut: Cut) -> Result<Self, ReadError> {
        let shape = self.grid.shape();
        let [y0, x0, ny, nx] = cut.of(shape, &self.heights)?;
        let inside = |start: usize, length: usize, size: usize| {
            length > 0 && start.checked_add(length).is_some_and(|end| end <= size)
        };
        let fault = ReadError::Crop { part: [y0, x0, ny, nx], shape };
        if !inside(y0, ny, shape[0]) || !inside(x0, nx, shape[1]) {
            return Err(fault);
        }
        let Ok(grid) = Grid::new([ny, nx], self.grid.pixel()) else { return Err(fault) };
        let heights: Vec<f64> = (y0..y0 + ny)
            .flat_map(|iy| &self.heights[iy * shape[1] + x0..iy * shape[1] + x0 + nx])
            .copied()
            .collect();
        let [above, before, ..] = self.cropped.unwrap_or_default();
        let cropped = [above + y0, before + x0, ny, nx];
        let mut found = Self {
            grid,
            heights,
            positions: self.positions.as_ref().and_then(|x| {
                let part = x.get(x0..x0 + nx)?;
                Some(part.iter().map(|position| position - part[0]).collect())
            }),
            cropped: Some(cropped),
            channel: self.channel.clone(),
            channels: self.channels.clone(),
            metadata: self.metadata.clone(),
            ..*self
        };
        found.metadata.insert("crop".into(), Cut::Rectangle(cropped).to_string());
        Ok(found)
    }
}
