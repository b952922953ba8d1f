//! Whether the bodies stick: a verdict, where a work of adhesion was given. Nothing here solves a contact that does.

use crate::needs::Inputs;
use asperity_models::adhesion::{LIGHT, STICKY, Stickiness};
use serde::{Deserialize, Serialize};

/// Fuller and Tabor's parameter from which nothing is left of the pull-off force.
pub const NO_PULL_OFF: f64 = 10.0;

/// Share of the load that attraction may have and still be called negligible.
pub(crate) const NEGLIGIBLE_ATTRACTION: f64 = 0.05;

/// A work of adhesion, and how far it reaches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WorkOfAdhesion {
    /// w (J/m²); 0 for none.
    pub work: f64,
    /// Distance over which the surfaces attract (m).
    pub range: f64,
}

impl WorkOfAdhesion {
    /// Distance of atoms, over which van der Waals forces act on clean surfaces (m); the verdict goes with its third
    /// root.
    pub const RANGE: f64 = 0.3e-9;
}

/// Numbers of adhesion, and the verdict.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Adhesion {
    /// What was given.
    pub given: WorkOfAdhesion,
    /// Fuller and Tabor's θ \[-\]: no pull-off above [`NO_PULL_OFF`]. `None` without summits.
    pub fuller_tabor: Option<f64>,
    /// Tabor's μ of the summits \[-\].
    pub tabor: Option<f64>,
    /// Pastewka and Robbins's criterion \[-\]: they stick below [`Self::sticky`]. `None` for a flat map.
    pub pastewka_robbins: Option<f64>,
    /// The threshold of that.
    pub sticky: f64,
    /// Elastic energy of full contact per area (J/m²).
    pub full_contact_energy: Option<f64>,
    /// Persson and Tosatti's work of adhesion left in full contact (J/m²): w less that energy.
    pub effective_work: Option<f64>,
    /// Attraction over load \[-\], the largest of the loads; of any light load where none was solved.
    pub attraction: Option<f64>,
    /// The load at which it is (Pa).
    pub at: Option<f64>,
    /// Rms gradient \[-\].
    pub gradient: f64,
    /// Shortest wave (m).
    pub shortest: Option<f64>,
    /// The verdict: no pull-off, not sticky, and little attraction beside the load; or no work of adhesion at all.
    pub negligible: bool,
}

impl Adhesion {
    /// Of a surface, its shortest wave (m) and the contacts on it, `[mean pressure (Pa), area fraction]`. Everything depends
    /// on the shortest wave that was measured.
    pub fn of(
        given: WorkOfAdhesion,
        inputs: &Inputs,
        shortest: Option<f64>,
        contacts: &[[f64; 2]],
    ) -> Self {
        let (modulus, gradient) = (inputs.modulus.pascals(), inputs.rms_gradient());
        // Half the Laplacian of an isotropic surface: <(h_xx + h_yy)²> = 8/3 m4.
        let curvature = (2.0 / 3.0 * inputs.moments.map_or(0.0, |m| m.m4)).sqrt();
        let Stickiness { fuller_tabor, tabor, pastewka_robbins, attracting_area: rim } =
            Stickiness::of(
                modulus,
                [given.work, given.range],
                [gradient, curvature],
                inputs.asperities(),
            );
        let shells = inputs.spectrum.as_ref().map(|s| s.shells().iter());
        let first_moment = shells.map(|all| all.map(|s| s.variance * s.wavenumber).sum::<f64>());
        let energy = first_moment.map(|m1| 0.25 * modulus * m1);
        let solved = contacts.iter().filter(|[p, area]| *p > 0.0 && *area > 0.0);
        let shares = solved.filter_map(|[p, area]| {
            // No more of the surface can attract than there is.
            let attracting = (area * rim?).min(1.0 - area);
            Some([given.work / given.range * attracting / p, *p])
        });
        let worst = shares.max_by(|a, b| a[0].total_cmp(&b[0]));
        let light = || Some(given.work / given.range * rim? / (modulus * gradient * LIGHT));
        let attraction = worst.map(|[share, _]| share).or_else(light);
        let is_none = given.work <= 0.0;
        Self {
            given,
            fuller_tabor,
            tabor,
            pastewka_robbins,
            sticky: STICKY,
            full_contact_energy: energy,
            effective_work: energy.map(|u| given.work - u),
            attraction: if is_none { Some(0.0) } else { attraction },
            at: worst.map(|[_, p]| p),
            gradient,
            shortest,
            negligible: is_none
                || (fuller_tabor.is_some_and(|theta| theta > NO_PULL_OFF)
                    && pastewka_robbins.is_some_and(|c| c > STICKY)
                    && attraction.is_some_and(|share| share < NEGLIGIBLE_ATTRACTION)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use contact_types::{
        AsperityStatistics, ContactModulus, RoughnessSpectrum, Shell, SpectralMoments,
    };
    use std::f64::consts::{PI, TAU};

    /// Gradient 0.1.
    fn rough(modulus: f64) -> Inputs {
        Inputs {
            moments: Some(SpectralMoments { m0: 0.0, m2: 0.005, m4: 1e10 }),
            asperities: Some(AsperityStatistics {
                density: 1e10,
                radius: 10e-6,
                height_std: 0.5e-6,
                mean_offset: 0.0,
            }),
            ..Inputs::new(ContactModulus::from_pascals(modulus).unwrap())
        }
    }

    fn verdict(inputs: &Inputs, work: f64, contacts: &[[f64; 2]]) -> Adhesion {
        let given = WorkOfAdhesion { work, range: WorkOfAdhesion::RANGE };
        Adhesion::of(given, inputs, Some(1e-6), contacts)
    }

    /// The adhesion paradox: rough metal does not stick, rubber does; and no work of adhesion sticks nothing.
    #[test]
    fn steel_does_not_stick_and_rubber_does() {
        let (steel, rubber) = (rough(115e9), rough(1e6));
        assert!(verdict(&steel, 0.05, &[]).negligible);
        let sticks = verdict(&rubber, 0.05, &[]);
        assert!(!sticks.negligible && sticks.fuller_tabor.is_some_and(|t| t < NO_PULL_OFF));
        let nothing = verdict(&rubber, 0.0, &[[1e5, 0.1]]);
        assert!(nothing.negligible && nothing.attraction == Some(0.0));
        // A flat map, and one without summits: nothing says that adhesion is negligible.
        assert!(!verdict(&Inputs { moments: None, ..steel.clone() }, 0.05, &[]).negligible);
        assert!(!verdict(&Inputs { asperities: None, ..steel }, 0.05, &[]).negligible);
    }

    /// With light contact solved, A = 2 p/(E* g), the share is that of light contact; the worst load counts.
    #[test]
    fn the_share_follows_the_area() {
        let (p, steel) = (1e6, rough(115e9));
        let area = 2.0 * p / (115e9 * 0.1);
        let light = verdict(&steel, 0.05, &[]).attraction.expect("a share");
        let solved = verdict(&steel, 0.05, &[[p, area], [10.0 * p, 3.0 * area]]);
        assert!((solved.attraction.expect("a share") / light - 1.0).abs() < 1e-12);
        assert_eq!(solved.at, Some(p));
    }

    /// A sinusoid of amplitude Δ and wavelength λ takes `π E* Δ²/(4 λ)` to close (Johnson 1995).
    #[test]
    fn a_wave_takes_its_energy_to_close() {
        let (amplitude, length) = (1e-7, 1e-5);
        let wave = Shell { wavenumber: TAU / length, variance: amplitude * amplitude / 2.0 };
        let spectrum = RoughnessSpectrum::new(vec![wave]).ok();
        let found = verdict(&Inputs { spectrum, ..rough(115e9) }, 0.05, &[]);
        let exact = PI * 115e9 * amplitude * amplitude / (4.0 * length);
        assert!((found.full_contact_energy.expect("an energy") / exact - 1.0).abs() < 1e-12);
        assert!((found.effective_work.expect("a work") - (0.05 - exact)).abs() < 1e-12 * exact);
    }
}
