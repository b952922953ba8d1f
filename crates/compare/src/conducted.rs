//! What a contact conducts, as numbers.

use crate::GapGas;
use contact_accuracy::{Estimate, Inverse};
use contact_types::{ModelError, require};
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Of the change of the area, as a logarithm, the part below which that of the conductance is "hardly any".
const HARDLY: f64 = 0.2;

/// What is asked of the conduction of a joint. SI units.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Joint {
    /// Resistivities of both bodies (Ω m).
    pub resistivities: Option<[f64; 2]>,
    /// Thermal conductivities of both bodies (W/m/K).
    pub conductivities: Option<[f64; 2]>,
    /// Gas in the gap; vacuum without.
    pub gas: Option<GapGas>,
    /// Nominal area of the part (m²), if it is known.
    pub area: Option<f64>,
    /// Hardness of the softer body (Pa), if it is known: of Holm's single spot.
    pub hardness: Option<f64>,
}

impl Joint {
    /// Whether anything is asked.
    pub fn is_asked(&self) -> bool {
        self.resistivities.is_some() || self.conductivities.is_some()
    }

    /// Sums of the resistivities of both bodies, for current and for heat (Ω m and m K/W).
    fn sums(&self) -> [Option<f64>; 2] {
        [
            self.resistivities.map(|[a, b]| a + b),
            self.conductivities.map(|[a, b]| 1.0 / a + 1.0 / b),
        ]
    }

    /// Conductance over conductance by harmonic mean conductivity: `2/(ρ₁ + ρ₂)` and `2/(1/k₁ + 1/k₂)`; 0 with an
    /// insulator.
    pub(crate) fn factors(&self) -> [Option<f64>; 2] {
        self.sums().map(|sum| sum.map(|sum| 2.0 / sum))
    }

    /// Refuses what conducts nothing that is known.
    ///
    /// # Errors
    /// [`ModelError`] of a conductivity or an area that is not positive, of resistivities that are negative or both 0, of
    /// the gas.
    pub fn check(&self) -> Result<(), ModelError> {
        const MODEL: &str = "conduction";
        for value in self.conductivities.into_iter().flatten() {
            require::positive(MODEL, "conductivity", value)?;
        }
        // A superconductor or an insulator on one side is a limit that is allowed.
        for value in self.resistivities.into_iter().flatten().filter(|v| *v != f64::INFINITY) {
            require::not_negative(MODEL, "resistivity", value)?;
        }
        let sum = self.sums()[0].filter(|sum| sum.is_finite());
        sum.map_or(Ok(0.0), |sum| require::positive(MODEL, "resistivity of both bodies", sum))?;
        self.area.map_or(Ok(0.0), |area| require::positive(MODEL, "nominal area", area))?;
        self.gas.map_or(Ok(()), |gas| gas.check())
    }

    /// From the conductances over conductivity of the contact and of the gas (1/m), at a mean pressure (Pa).
    pub(crate) fn conducted(
        &self,
        contact: Conductance,
        gas: Option<Conductance>,
        pressure: f64,
    ) -> Conducted {
        let [electrical, thermal] = self.factors().map(|f| f.map(|f| contact.times(f)));
        let gas = self.gas.and_then(|of| Some(gas?.times(of.conductivity())));
        let joint = thermal.zip(gas).map(|(contact, gas)| contact.plus(gas));
        // Of one spot as large as the hardness makes it, π a² H = F: (ρ₁ + ρ₂)/(4a).
        let radius = |(area, h): (f64, f64)| (pressure * area / (PI * h)).sqrt();
        let radius = self.area.zip(self.hardness).map(radius);
        let one_spot = self.sums().map(|sum| Some(sum? / (4.0 * radius?)));
        Conducted { electrical, thermal, gas, joint, area: self.area, one_spot }
    }
}

/// A conductance, which may be nothing or have no end; with its uncertainty where it is neither and that is known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Conductance {
    /// The number.
    pub value: f64,
    /// The same with its uncertainty.
    pub estimate: Option<Estimate>,
}

impl From<Estimate> for Conductance {
    fn from(estimate: Estimate) -> Self {
        Self { value: estimate.value, estimate: Some(estimate) }
    }
}

impl Conductance {
    /// A number alone.
    pub(crate) fn of(value: f64) -> Self {
        Self { value, estimate: None }
    }

    /// Nothing without contact or with an insulator.
    #[must_use]
    pub(crate) fn times(self, factor: f64) -> Self {
        if self.value <= 0.0 || factor <= 0.0 {
            return Self::of(0.0);
        }
        let estimate = self.estimate.map(|e| e.times(factor));
        Self { value: self.value * factor, estimate }
    }

    /// One beside another.
    #[must_use]
    pub(crate) fn plus(self, other: Self) -> Self {
        let both = self.estimate.zip(other.estimate).map(|(a, b)| a.plus(b));
        let one = if other.value <= 0.0 { self.estimate } else { other.estimate };
        let is_alone = self.value <= 0.0 || other.value <= 0.0;
        let estimate = both.or(one.filter(|_| is_alone));
        Self { value: self.value + other.value, estimate }
    }
}

/// What a joint conducts per nominal area.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Conducted {
    /// Current through the contact (S/m²), if it was asked for.
    pub electrical: Option<Conductance>,
    /// Heat through the contact (W/m²/K), if it was asked for.
    pub thermal: Option<Conductance>,
    /// Heat through the gas (W/m²/K), if there is one.
    pub gas: Option<Conductance>,
    /// Heat through both.
    pub joint: Option<Conductance>,
    /// Nominal area of the part (m²), if it is known.
    pub area: Option<f64>,
    /// Holm's resistances of one spot of the same load and hardness (Ω and K/W).
    pub one_spot: [Option<f64>; 2],
}

impl Conducted {
    /// Resistance of the part to current (Ω), and to heat by all ways there are (K/W).
    pub fn resistances(&self) -> [Option<Inverse>; 2] {
        let of = |h: Option<Conductance>| {
            let (Conductance { value, estimate }, area) = (h?, self.area?);
            let inverted = |[low, high]: [f64; 2]| [high, low].map(|h| 1.0 / (h * area));
            Some(Inverse {
                value: 1.0 / (value * area),
                interval: estimate.and_then(|e| e.interval().ok()).map(inverted),
                prediction: estimate.and_then(|e| e.prediction()).map(inverted),
            })
        };
        [of(self.electrical), of(self.joint.or(self.thermal))]
    }
}

/// What a contact conducts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Conduction {
    /// What was asked.
    pub joint: Joint,
    /// Electrical conductance over stiffness, `2/(E* (ρ1 + ρ2))` (S/N), and thermal (W/m²/K over Pa/m); 0 with an insulator.
    /// `None` if it was not asked for.
    pub factors: [Option<f64>; 2],
    /// Stiffness of the contact set at each load (Pa/m): 0 without contact, infinite in full contact. `None`
    /// without a converged solution.
    pub stiffness: Vec<Option<f64>>,
    /// Stiffness of theories of elastic contact at each load (Pa/m), -dp/d(separation): by the same factors their
    /// conductance; of correlations of the conductance the stiffness that it stands for.
    pub theories: Vec<TheoryStiffness>,
    /// The headline load on the map without its shortest octaves, the whole map first; empty unless asked
    /// for, see [`Comparison::look_around`](crate::Comparison::look_around).
    pub octaves: Vec<Octave>,
    /// Wall-clock time of the octaves (s).
    pub seconds: f64,
}

/// Stiffness of a theory over the loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TheoryStiffness {
    /// Its key in the registry.
    pub name: String,
    /// What figures call it.
    pub label: String,
    /// γ of the mean gap that it was taken from, if it has one \[-\].
    pub gamma: Option<f64>,
    /// At each load (Pa/m); `None` where it has no answer.
    pub stiffness: Vec<Option<f64>>,
    /// Gas between Gaussian heights at its separation, conductance over conductivity at each load (1/m); empty without gas.
    pub gas: Vec<Option<f64>>,
}

/// The headline load on the waves of the map that are longer than one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Octave {
    /// The shortest wave left (m).
    pub shortest: f64,
    /// Corrected area fraction \[-\].
    pub area: f64,
    /// Stiffness of the contact set (Pa/m).
    pub stiffness: f64,
}

impl Conduction {
    /// Whether the conductance hardly depends on the shortest waves, while the area does; `None` without octaves.
    pub fn is_sturdy(&self) -> Option<bool> {
        let [area, conductance] = changes(&self.octaves)?;
        Some(conductance.ln() <= HARDLY * area.ln())
    }
}

/// By what factor area and conductance change at most when the shortest octaves are taken off, each the larger over the
/// smaller.
fn changes(octaves: &[Octave]) -> Option<[f64; 2]> {
    let (first, rest) = octaves.split_first().filter(|(_, rest)| !rest.is_empty())?;
    let most = |of: fn(&Octave) -> f64| {
        let ratio = |o: &Octave| (of(o) / of(first)).max(of(first) / of(o));
        rest.iter().map(ratio).fold(1.0, f64::max)
    };
    let found = [most(|o| o.area), most(|o| o.stiffness)];
    found.iter().all(|f| f.is_finite()).then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ENDUSE A.1, check 5: area .0243 to .0736 and conductance 1.892 to 1.881 from all waves to the longest. Both change alike;
    /// only the conductance does; nothing was taken off.
    #[test]
    fn the_sentence_follows_the_numbers() {
        for (octaves, expected) in [
            (&[[0.0243, 1.881], [0.05, 1.9], [0.0736, 1.892]][..], Some(true)),
            (&[[0.02, 2.0], [0.03, 1.3]], Some(false)),
            (&[[0.02, 2.0], [0.02, 1.3]], Some(false)),
            (&[[0.02, 2.0]], None),
            (&[], None),
        ] {
            let octave = |[area, stiffness]: &[f64; 2]| Octave {
                shortest: 1.0,
                area: *area,
                stiffness: *stiffness,
            };
            let found = Conduction {
                joint: Joint::default(),
                factors: [None; 2],
                stiffness: Vec::new(),
                theories: Vec::new(),
                octaves: octaves.iter().map(octave).collect(),
                seconds: 0.0,
            };
            assert_eq!(found.is_sturdy(), expected, "{octaves:?}");
        }
    }
}
