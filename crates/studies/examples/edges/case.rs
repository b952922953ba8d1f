//! One crop, solved in its surroundings and alone.

use compare::EdgeShare;

/// Mean pressure over E* h'rms.
pub(crate) const LOADS: [f64; 5] = [0.003, 0.01, 0.03, 0.1, 0.3];

/// Side of the crop over the roll-off wavelength.
pub(crate) const WAVES: [f64; 3] = [8.0, 2.0, 0.5];

/// One crop at one load.
pub(crate) struct Case {
    /// Number of the large map, from 1: its seed.
    pub(crate) surface: usize,
    pub(crate) hurst: f64,
    pub(crate) waves: f64,
    /// Of [`LOADS`], the nearest to what the crop carried.
    pub(crate) load: usize,
    /// What the crop carried, over E* h'rms.
    pub(crate) carried: f64,
    pub(crate) truth: Contact,
    /// One per [`Treatment`](crate::treatment::Treatment).
    pub(crate) alone: Vec<Contact>,
    /// Periodic at the load of the whole map, over the area of the whole map.
    pub(crate) as_sample: f64,
}

/// The contact of a crop.
pub(crate) struct Contact {
    /// Corrected area fraction.
    pub(crate) area: f64,
    pub(crate) edge: EdgeShare,
    /// FFT pairs of the size of the crop.
    pub(crate) transforms: f64,
    pub(crate) seconds: f64,
}
