//! What Python imports.

use pyo3::prelude::pymodule;

/// Private: use the package `rough_contact`.
#[pymodule]
mod _rough_contact {
    use crate::failure::{bug, raise};
    use contact_front_end::bodies::{BothBodies, known};
    use contact_front_end::quantity::{parse as one, parse_list as several};
    use contact_front_end::units::Dimension;
    use contact_front_end::{Failure, leak_request};
    use contact_report::numbers::plain;
    use contact_types::Named;
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::again::{run_file, run_file_in, validate};
    #[pymodule_export]
    use crate::failure::Refused;
    #[pymodule_export]
    use crate::model::{Closed, model};
    #[pymodule_export]
    use crate::profile::{profile, profile_model, profile_study};
    #[pymodule_export]
    use crate::solve::{Keep, displacement, solve, spots};
    #[pymodule_export]
    use crate::statistics::{psd, statistics};
    #[pymodule_export]
    use crate::study::{model_inputs, models, study, study_pressures};
    #[pymodule_export]
    use crate::summary::{digest, summary};
    #[pymodule_export]
    use crate::surface::{encode, given, info, read, reshape, synth};

    /// Quantities as people type them, in SI units: one, or a list of them and of ranges.
    #[pyfunction]
    fn parse(text: &str, dimension: &str, many: bool) -> PyResult<Vec<f64>> {
        let dimension: Dimension = serde_json::from_value(dimension.into()).map_err(|e| bug(&e))?;
        let found =
            if many { several(text, dimension) } else { one(text, dimension).map(|v| vec![v]) };
        found.map_err(|e| raise(&Failure::refused("unit", e.message)))
    }

    /// A fraction and the ends between which it lies, in per cent.
    #[pyfunction]
    fn percent_within(fraction: f64, interval: Option<[f64; 2]>) -> String {
        plain(&contact_report::numbers::percent_within(fraction, interval))
    }

    /// A pressure (Pa) and the ends between which it lies; a dash where there is none.
    #[pyfunction]
    fn pressure_within(pascals: Option<f64>, interval: Option<[f64; 2]>) -> String {
        use contact_report::numbers::{PASCALS, quantity_within};
        pascals.map_or("–".to_owned(), |p| plain(&quantity_within(p, interval, PASCALS)))
    }

    /// E* (Pa), and which bodies press on each other.
    #[pyfunction]
    fn bodies_line(modulus: f64, bodies: &str) -> PyResult<String> {
        let bodies: Vec<contact_compare::Body> =
            serde_json::from_str(bodies).map_err(|e| bug(&e))?;
        Ok(contact_report::bodies_line(modulus, &bodies))
    }

    /// Contact modulus, elastic bodies, hardness and what was taken from the table of materials, as JSON.
    #[pyfunction]
    fn bodies(given: &str) -> PyResult<String> {
        let given: BothBodies = serde_json::from_str(given).map_err(|e| bug(&e))?;
        let nothing = || Failure::refused("material", "no body is given");
        let found = given.resolve().and_then(|found| found.ok_or_else(nothing));
        let found = found.map_err(|e| raise(&e))?;
        Ok(serde_json::json!({
            "modulus": found.modulus.pascals(), "bodies": found.bodies, "hardness": found.hardness,
            "materials": found.materials,
        })
        .to_string())
    }

    /// What is asked of the leak along `x`, `y` or `both`, as JSON; of the seal viscosity, pressure drop, length and width.
    #[pyfunction]
    #[pyo3(signature = (along, seal))]
    fn leak(along: Option<&str>, seal: [Option<f64>; 4]) -> PyResult<String> {
        let found = leak_request(along, seal).map_err(|e| raise(&e))?;
        Ok(serde_json::json!(found).to_string())
    }

    /// A material of the table, or the names of all, as JSON.
    #[pyfunction]
    fn material(name: Option<&str>) -> PyResult<String> {
        let Some(name) = name else {
            let names: Vec<&str> = contact_compare::materials().iter().map(|m| m.name).collect();
            return Ok(serde_json::json!(names).to_string());
        };
        let found = known(name).map_err(|e| raise(&e))?;
        Ok(contact_report::material_json(found, contact_compare::Property::all()).to_string())
    }

    #[pymodule_init]
    fn init(m: &Bound<'_, PyModule>) -> PyResult<()> {
        m.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
