//! Whether rough bodies stick: numbers of the field, from the work of adhesion w (J/m²) and the distance over which
//! the surfaces attract. None of them models adhesion.
//!
//! # Sources
//! Fuller & Tabor (1975), doi:10.1098/rspa.1975.0138; Tabor (1977), doi:10.1016/0021-9797(77)90366-6; Pastewka & Robbins
//! (2014), doi:10.1073/pnas.1320846111, re-derived; their criterion is disputed: Ciavarella (2016), doi:10.1115/1.4034530.

use contact_types::{ModelError, require};
use std::f64::consts::PI;

const MODEL: &str = "adhesion";

/// Mean pressure of light contact is `E* g/κ` with this κ.
const KAPPA: f64 = 2.0;

/// A work of adhesion that acts between bodies with this contact modulus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attraction {
    modulus: f64,
    work: f64,
    range: f64,
}

impl Attraction {
    /// From the contact modulus E* (Pa), the work of adhesion (J/m²) and the distance over which the surfaces attract
    /// (m).
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless all are finite and positive.
    pub fn new(modulus: f64, work: f64, range: f64) -> Result<Self, ModelError> {
        require::positive(MODEL, "modulus", modulus)?;
        require::positive(MODEL, "work of adhesion", work)?;
        require::positive(MODEL, "range of attraction", range)?;
        Ok(Self { modulus, work, range })
    }

    /// Tabor's `μ = (R w²/(E*² z0³))^(1/3)` of a sphere of this radius (m) \[-\]: below 0.1 the attraction leaves its
    /// shape alone, above 5 it makes the contact of Johnson, Kendall and Roberts.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless the radius is finite and positive.
    pub fn tabor(&self, radius: f64) -> Result<f64, ModelError> {
        require::positive(MODEL, "radius", radius)?;
        let Self { modulus, work, range } = *self;
        Ok((radius * (work / modulus).powi(2) / range.powi(3)).cbrt())
    }

    /// Fuller and Tabor's `θ = E* σ_s^(3/2)/(w √R)` \[-\] of summits with this deviation of heights and radius (m): from
    /// 10 on nothing is left of the pull-off force.
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless both are finite and positive.
    pub fn fuller_tabor(&self, height_std: f64, radius: f64) -> Result<f64, ModelError> {
        require::positive(MODEL, "asperity height deviation", height_std)?;
        require::positive(MODEL, "asperity radius", radius)?;
        Ok(self.modulus * height_std.powf(1.5) / (self.work * radius.sqrt()))
    }

    /// Pastewka and Robbins's criterion for surfaces of this rms gradient g \[-\] and rms curvature h″ (1/m, half the
    /// rms Laplacian): `(g Δr/(κ l_a)) (g d/(4 Δr))^(2/3)` with `l_a = w/E*`, `d = 4 g/h″` and κ = 2. They stick below
    /// [`STICKY`].
    ///
    /// # Errors
    /// [`ModelError::InvalidInput`] unless both are finite and positive.
    pub fn pastewka_robbins(&self, gradient: f64, curvature: f64) -> Result<f64, ModelError> {
        let diameter = diameter(gradient, curvature)?;
        let Self { modulus, work, range } = *self;
        let strength = gradient * range * modulus / (KAPPA * work);
        Ok(strength * (gradient * diameter / (4.0 * range)).powf(2.0 / 3.0))
    }

    /// Area that attracts over the area of contact \[-\], by the geometry of that criterion: a rim of the width in which
    /// the gap beside a spot stays below the range, `π d_att/d` with `d_att = (3 Δr √d/(4 g))^(2/3)`.
    ///
    /// # Errors
    /// As [`pastewka_robbins`](Self::pastewka_robbins).
    pub fn attracting_area(&self, gradient: f64, curvature: f64) -> Result<f64, ModelError> {
        let diameter = diameter(gradient, curvature)?;
        let rim = (3.0 * self.range * diameter.sqrt() / (4.0 * gradient)).powf(2.0 / 3.0);
        Ok(PI * rim / diameter)
    }
}

/// `d = 4 g/h″` (m): of a spot, by rms gradient and rms curvature.
fn diameter(gradient: f64, curvature: f64) -> Result<f64, ModelError> {
    require::positive(MODEL, "rms gradient", gradient)?;
    require::positive(MODEL, "rms curvature", curvature)?;
    Ok(4.0 * gradient / curvature)
}

/// `π (3/16)^(2/3)`: where attraction and repulsion of light contact are equal.
pub const STICKY: f64 = 1.029_162_738_875_667_7;

/// Mean pressure of light contact over `E* g` \[-\].
pub const LIGHT: f64 = 1.0 / KAPPA;

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: f64, exact: f64) {
        assert!((found / exact - 1.0).abs() < 1e-13, "{found} instead of {exact}");
    }

    /// Rows of the project's reference tables, made with 45 digits: R, w, E*, z0, g, h'', σs, and Tabor, θ, criterion.
    #[test]
    fn are_those_of_the_tables() {
        let table = "
            0.00031316145287373955 0.03017478358816495 2584757.485625015 1.918085095933209e-09 \
            0.05144672069460214 2165275.3977548233 1.7149165689060298e-07 \
            182.19556612477516 0.3437605081224343 0.003129878400457994
            4.902202471508926e-06 0.013782219567085642 2760967111.607095 1.6813719721681738e-10 \
            0.05860153505716588 537818178.7178776 1.1660702327134426e-07 \
            2.9510182724420546 3602.7448825314314 0.11150576931455837
            1.754602300668074e-05 0.006460309869395171 17322307719.362267 2.121940607921931e-09 \
            0.021091569618284494 129298.29827432276 3.399208990454527e-07 \
            0.06344899403913452 126861.50307396267 82.8118286167053";
        for row in table.trim().lines() {
            let cells: Vec<f64> =
                row.split_whitespace().map(|cell| cell.parse().unwrap()).collect();
            let [r, w, e, z0, g, curvature, sigma, tabor, theta, criterion] = cells[..] else {
                panic!("{row}")
            };
            let found = Attraction::new(e, w, z0).expect("positive");
            close(found.tabor(r).expect("a radius"), tabor);
            close(found.fuller_tabor(sigma, r).expect("summits"), theta);
            close(found.pastewka_robbins(g, curvature).expect("slopes"), criterion);
            // At the threshold the rim pulls as hard as the spots push: π d_att/d (w/Δr) = E* g/κ.
            let pull = found.attracting_area(g, curvature).expect("slopes") * w / z0;
            close(pull / (e * g * LIGHT), STICKY / criterion);
        }
        close(STICKY, PI * (3.0f64 / 16.0).powf(2.0 / 3.0));
    }

    #[test]
    fn bad_input_is_refused() {
        for [e, w, z] in [[0.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, f64::NAN], [1.0, 1.0, 0.0]]
        {
            assert!(Attraction::new(e, w, z).is_err());
        }
        let one = Attraction::new(1.0, 1.0, 1.0).expect("positive");
        assert!(one.tabor(0.0).is_err() && one.fuller_tabor(1.0, -1.0).is_err());
        assert!(
            one.pastewka_robbins(0.0, 1.0).is_err() && one.attracting_area(1.0, f64::NAN).is_err()
        );
    }
}
