//! What the answers of all models share: caveats, and the state where the area alone is known.

use contact_types::{Caveat, ContactState};

/// Above this rms gradient a half-space with small slopes is no longer meant.
const STEEP: f64 = 1.0;

/// The caveat of a surface that is too steep.
pub(crate) fn steep(rms_gradient: f64) -> Option<Caveat> {
    let reason = "a half-space deforms like this only under small slopes";
    (rms_gradient > STEEP)
        .then(|| beyond("rms gradient", rms_gradient.min(f64::MAX), STEEP, reason))
}

/// The caveat of a strained assumption.
pub(crate) fn beyond(
    quantity: &'static str,
    value: f64,
    limit: f64,
    reason: &'static str,
) -> Caveat {
    Caveat::BeyondModel { quantity: quantity.into(), value, limit, reason: reason.into() }
}

/// The caveat of an area fraction that is 0 in doubles under a load.
pub(crate) fn underflow(mean_pressure: f64, area_fraction: f64) -> Option<Caveat> {
    let is_lost = mean_pressure > 0.0 && area_fraction <= 0.0;
    is_lost.then(|| Caveat::Underflow { quantity: "area fraction".into() })
}

/// The caveat of complete contact.
pub(crate) fn saturated() -> Caveat {
    Caveat::Saturated { quantity: "area fraction".into() }
}

/// The answer of a model of the area alone that knows complete contact.
pub(crate) fn up_to_complete(mean_pressure: f64, area_fraction: f64) -> ContactState {
    let is_complete = area_fraction >= 1.0;
    let caveat =
        if is_complete { Some(saturated()) } else { underflow(mean_pressure, area_fraction) };
    ContactState { mean_pressure, area_fraction, caveat, ..ContactState::default() }
}
