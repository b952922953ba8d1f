//! What a contact conducts.

use crate::failure::Failure;
use contact_types::ContactModulus;
use fft_bem_solver::{Conductors, SetStiffness};
use serde_json::{Value, json};

/// What is asked of the conduction: numbers of both bodies.
#[derive(Clone, Copy, Debug, Default)]
pub struct Conduction {
    /// Resistivities of both bodies (Ω m).
    pub resistivities: Option<[f64; 2]>,
    /// Thermal conductivities of both bodies (W/m/K).
    pub conductivities: Option<[f64; 2]>,
}

/// What the contact of one load conducts.
#[derive(Clone, Copy, Debug)]
pub struct Conducted {
    /// Stiffness per nominal area (Pa/m); infinite where everything touches.
    pub stiffness: f64,
    /// Electrical conductance per nominal area (S/m²), if it was asked for.
    pub electrical: Option<f64>,
    /// Thermal conductance per nominal area (W/m²/K), if it was asked for.
    pub thermal: Option<f64>,
}

impl Conduction {
    /// True if anything is asked.
    pub fn is_asked(&self) -> bool {
        self.resistivities.is_some() || self.conductivities.is_some()
    }

    /// Adds what the contact of the last solution conducts to a point. `area` is that of the map (m²).
    pub(crate) fn add(
        &self,
        point: &mut Value,
        set: &SetStiffness,
        modulus: ContactModulus,
        area: f64,
    ) -> Result<Option<Conducted>, Failure> {
        if !self.is_asked() {
            return Ok(None);
        }
        point["stiffness"] = finite(set.per_area);
        point["contact_set"] = json!(match set.per_area {
            k if k <= 0.0 => "none",
            k if k.is_finite() => "part",
            _ => "everything",
        });
        point["conduction"] = json!({
            "residual": set.residual, "transforms": set.transforms, "iterations": set.iterations,
        });
        let of = |pair: Option<[f64; 2]>, kind: fn([f64; 2]) -> Conductors| {
            pair.map(|values| conductance(set, modulus, kind(values))).transpose()
        };
        let electrical = of(self.resistivities, Conductors::Resistivities)?;
        let thermal = of(self.conductivities, Conductors::Conductivities)?;
        for (key, found) in [("electrical", electrical), ("thermal", thermal)] {
            let Some(found) = found else { continue };
            point[format!("{key}_conductance")] = finite(found);
            // A conductance is the stiffness times what only the materials know: so are its ends.
            for interval in ["interval", "prediction_interval"] {
                let ends = ends(&point[format!("stiffness_{interval}")]);
                let scaled = ends.map(|ends| ends.map(|k| k * found / set.per_area));
                point[format!("{key}_conductance_{interval}")] =
                    json!(scaled.filter(|ends| ends.iter().all(|x| x.is_finite())));
            }
            point[format!("{key}_conductance_of_map")] = finite(found * area);
        }
        Ok(Some(Conducted { stiffness: set.per_area, electrical, thermal }))
    }
}

fn conductance(
    set: &SetStiffness,
    modulus: ContactModulus,
    conductors: Conductors,
) -> Result<f64, Failure> {
    set.conductance(modulus, conductors).map_err(|e| Failure::from_error(&e))
}

/// Both ends of an interval.
fn ends(interval: &Value) -> Option<[f64; 2]> {
    Some([interval.get(0)?.as_f64()?, interval.get(1)?.as_f64()?])
}

/// A number of JSON, which has no infinity: `contact_set` says what `null` is.
fn finite(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}
