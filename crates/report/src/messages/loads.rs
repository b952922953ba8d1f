//! Loads that were given as forces.

use crate::numbers::{METRES, NEWTONS, PASCALS, SPACE, chosen, quantity, significant, unit_for};
use contact_compare::{Settings, SurfaceComparison};

/// Forces, the area they press on and the pressures that gives; `None` if the loads of
/// the study were not given as forces.
pub fn loads_line(settings: &Settings) -> Option<String> {
    let area = settings.load_area?;
    let one =
        |p: &f64| format!("{} is {}", quantity(p * area, NEWTONS, 3), quantity(*p, PASCALS, 3));
    let all: Vec<String> = settings.pressures.iter().flatten().map(one).collect();
    let side = unit_for(area.sqrt(), METRES);
    let area = significant(area / side.scale.powi(2), 4);
    let loads = if all.is_empty() { String::new() } else { format!(": {}", all.join(", ")) };
    Some(format!("on {area}{SPACE}{}²{loads}", side.name))
}

/// A nominal pressure (Pa) as its load is read: as a force on this area (m²) with the pressure behind it, or as it is.
pub(crate) fn load(pressure: f64, area: Option<f64>) -> String {
    let pascals = chosen(pressure, PASCALS);
    match area {
        None => pascals,
        Some(area) => format!("{} ({pascals})", chosen(pressure * area, NEWTONS)),
    }
}

/// That of the headline.
pub(crate) fn headline_load(surface: &SurfaceComparison) -> String {
    load(surface.headline_pressure(), surface.load_area)
}
