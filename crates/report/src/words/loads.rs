//! Loads that were given as forces.

use crate::numbers::{METRES, NEWTONS, PASCALS, SPACE, quantity, significant, unit_for};
use compare::Settings;

/// Forces, the area they press on and the pressures that gives, in plain text; `None` if the loads of
/// the study were not given as forces.
pub fn loads_line(settings: &Settings) -> Option<String> {
    loads_words(settings).map(|words| words.replace(SPACE, " "))
}

/// The same for the page.
pub(crate) fn loads_words(settings: &Settings) -> Option<String> {
    let area = settings.load_area?;
    let one =
        |p: &f64| format!("{} is {}", quantity(p * area, NEWTONS, 3), quantity(*p, PASCALS, 3));
    let all: Vec<String> = settings.pressures.iter().flatten().map(one).collect();
    let side = unit_for(area.sqrt(), METRES);
    let area = significant(area / side.scale.powi(2), 4);
    let loads = if all.is_empty() { String::new() } else { format!(": {}", all.join(", ")) };
    Some(format!("on {area}{SPACE}{}²{loads}", side.name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn force_area_and_pressure_are_said_together() {
        let settings = Settings {
            pressures: Some(vec![5e6, 10e6]),
            load_area: Some(2e-6),
            ..Settings::default()
        };
        let line = loads_line(&settings).unwrap();
        assert_eq!(line, "on 2.000 mm²: 10.0 N is 5.00 MPa, 20.0 N is 10.0 MPa");
        assert_eq!(loads_line(&Settings { load_area: None, ..settings }), None);
    }
}
