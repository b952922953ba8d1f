//! Loads: forces made pressures, the order in which they are solved, how they are called.

use crate::failure::Failure;
use crate::shown;
use fft_bem_solver::Load;

/// Forces over the nominal area that carries them.
#[derive(Clone, Debug)]
pub struct Spread {
    /// Mean pressures in the order given (Pa).
    pub pressures: Vec<f64>,
    /// The nominal area (m²).
    pub area: f64,
    /// True if that is the area of the map.
    pub is_of_map: bool,
}

impl Spread {
    /// Forces (N) over the area given (m²), or that of the map.
    ///
    /// # Errors
    /// [`Failure`] of a force or an area that does not press; `check` is what to look at where their ratio is no
    /// pressure.
    pub fn of(
        forces: &[f64],
        given: Option<f64>,
        of_map: f64,
        check: &str,
    ) -> Result<Self, Failure> {
        positive("load", forces, "N", "at which something touches")?;
        positive("nominal area", given.as_slice(), "m^2", "that carries the load")?;
        let area = given.unwrap_or(of_map);
        let pressures: Vec<f64> = forces.iter().map(|force| force / area).collect();
        match pressures.iter().find(|pressure| !(**pressure > 0.0 && pressure.is_finite())) {
            Some(pressure) => {
                let message =
                    format!("load over area is {pressure} Pa, which is no pressure; {check}");
                Err(Failure::refused("usage", message))
            }
            None => Ok(Self { pressures, area, is_of_map: given.is_none() }),
        }
    }
}

/// Refuses a load that is not greater than 0.
///
/// # Errors
/// [`Failure`] of kind `bad_load`.
pub fn positive(what: &str, values: &[f64], unit: &str, hint: &str) -> Result<(), Failure> {
    let is_bad = |value: &&f64| value.is_nan() || **value <= 0.0;
    let Some(value) = values.iter().find(is_bad) else { return Ok(()) };
    let message = format!("{what} {value} {unit} must be greater than 0; give a {what} {hint}");
    Err(Failure::refused("bad_load", message))
}

/// Indices from the lightest load to the heaviest.
pub fn rising(loads: &[Load]) -> Vec<usize> {
    let weight = |load: &Load| match *load {
        Load::MeanGap(gap) => -gap,
        Load::MeanPressure(load) => load,
        _ => 0.0,
    };
    let mut order: Vec<usize> = (0..loads.len()).collect();
    order.sort_by(|&i, &j| weight(&loads[i]).total_cmp(&weight(&loads[j])));
    order
}

/// "2 MPa", "gap 30 nm".
pub fn shown(load: Load) -> String {
    match load {
        Load::MeanPressure(p) => shown::pressure(p),
        Load::MeanGap(g) => format!("gap {}", shown::length(g)),
        other => format!("{other:?}"),
    }
}
