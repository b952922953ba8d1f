//! What a contact conducts, as numbers.

use serde::Serialize;

/// Of the change of the area, as a logarithm, the part below which that of the conductance is "hardly any".
const HARDLY: f64 = 0.2;

/// What a contact conducts.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Conduction {
    /// Electrical conductance over stiffness, `2/(E* (ρ1 + ρ2))` (S/N); 0 with an insulator, infinite
    /// between superconductors. `None` if no resistivity was given.
    pub electrical: Option<f64>,
    /// The same of the thermal conductance (m/s/K · W/N, that is W/m²/K over Pa/m).
    pub thermal: Option<f64>,
    /// Stiffness of the contact set at each load (Pa/m): 0 without contact, infinite in full contact. `None`
    /// without a converged solution.
    pub stiffness: Vec<Option<f64>>,
    /// Stiffness of theories of elastic contact at each load (Pa/m), -dp/d(separation): by the same factors their
    /// conductance. `None` where they have no answer.
    pub theories: Vec<TheoryStiffness>,
    /// Mikic's correlation for elastic bodies, as a stiffness (Pa/m); `None` outside its domain.
    pub mikic: Vec<Option<f64>>,
    /// Cooper, Mikic and Yovanovich's for bodies that yield, if a hardness was given.
    pub yovanovich: Vec<Option<f64>>,
    /// The headline load on the map without its shortest octaves, the whole map first; empty unless asked
    /// for, see [`Comparison::remove_octaves`](crate::Comparison::remove_octaves).
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
    /// At each load (Pa/m).
    pub stiffness: Vec<Option<f64>>,
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
    /// By what factor area and conductance change at most when the shortest octaves are taken off, each the
    /// larger over the smaller; `None` without octaves.
    pub fn changes(&self) -> Option<[f64; 2]> {
        let first = self.octaves.first()?;
        let rest = self.octaves.get(1..).filter(|rest| !rest.is_empty())?;
        let most = |of: fn(&Octave) -> f64| {
            let ratio = |o: &Octave| (of(o) / of(first)).max(of(first) / of(o));
            rest.iter().map(ratio).fold(1.0, f64::max)
        };
        let found = [most(|o| o.area), most(|o| o.stiffness)];
        found.iter().all(|f| f.is_finite()).then_some(found)
    }

    /// Whether the conductance hardly depends on the shortest waves, while the area does.
    pub fn is_sturdy(&self) -> Option<bool> {
        self.changes().map(|[area, conductance]| conductance.ln() <= HARDLY * area.ln())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(octaves: &[[f64; 2]]) -> Conduction {
        let octave = |[area, stiffness]: &[f64; 2]| Octave {
            shortest: 1.0,
            area: *area,
            stiffness: *stiffness,
        };
        Conduction {
            electrical: None,
            thermal: None,
            stiffness: Vec::new(),
            theories: Vec::new(),
            mikic: Vec::new(),
            yovanovich: Vec::new(),
            octaves: octaves.iter().map(octave).collect(),
            seconds: 0.0,
        }
    }

    /// ENDUSE A.1, check 5: area .0243 to .0736 and conductance 1.892 to 1.881 from all waves to the longest.
    #[test]
    fn the_sentence_follows_the_numbers() {
        let rough = of(&[[0.0243, 1.881], [0.05, 1.9], [0.0736, 1.892]]);
        let [area, conductance] = rough.changes().expect("octaves");
        assert!(
            (area - 0.0736 / 0.0243).abs() < 1e-12 && (conductance - 1.9 / 1.881).abs() < 1e-12
        );
        assert_eq!(rough.is_sturdy(), Some(true));
        // Both change alike; only the conductance does; nothing was taken off.
        assert_eq!(of(&[[0.02, 2.0], [0.03, 1.3]]).is_sturdy(), Some(false));
        assert_eq!(of(&[[0.02, 2.0], [0.02, 1.3]]).is_sturdy(), Some(false));
        assert_eq!(of(&[[0.02, 2.0]]).is_sturdy(), None);
        assert_eq!(of(&[]).changes(), None);
    }
}
