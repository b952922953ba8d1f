//! The random fields that the families are made of.

use studies::maps::{Draw, Heights};

/// A field of unit rms height: shortest wave of 8 to 20 points, the longest 1/8 to 2/3 of the side.
pub(crate) fn rough(d: &Draw, stretch: f64, salt: u64) -> Heights {
    let cutoff = d.log(1, 8.0, 20.0);
    let rolloff = (d.n as f64 / d.log(2, 1.5, 10.0)).max(1.3 * cutoff);
    d.field(d.lin(0, 0.2, 1.0), cutoff, rolloff, stretch, salt)
}

/// A field finer than that, on top of others.
pub(crate) fn fine(d: &Draw, salt: u64) -> Heights {
    d.field(d.lin(0, 0.3, 0.9), 8.0, d.log(1, 12.0, 60.0), 1.0, salt)
}

/// Another number between 0 and 1 of the draw, as unlike its last as `times` makes it.
pub(crate) fn other(d: &Draw, times: f64) -> f64 {
    (times * d.t[3]) % 1.0
}
