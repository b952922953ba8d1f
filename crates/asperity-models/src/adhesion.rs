//! Whether rough bodies stick: numbers of the field, from the work of adhesion w (J/m²) and the distance over which
//! the surfaces attract. None of them models adhesion.
//!
//! # Sources
//! Fuller & Tabor (1975), doi:10.1098/rspa.1975.0138; Tabor (1977), doi:10.1016/0021-9797(77)90366-6; Pastewka & Robbins
//! (2014), doi:10.1073/pnas.1320846111, re-derived; their criterion is disputed: Ciavarella (2016), doi:10.1115/1.4034530.

use contact_types::AsperityStatistics;
use std::f64::consts::PI;

/// Mean pressure of light contact is `E* g/κ` with this κ.
const KAPPA: f64 = 2.0;

/// What a work of adhesion does on a surface; each is `None` where one of its numbers is not finite and positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stickiness {
    /// Fuller and Tabor's `θ = E* σ_s^(3/2)/(w √R)` of summits with deviation σ_s of heights and radius R \[-\]: from 10 on
    /// nothing is left of the pull-off force.
    pub fuller_tabor: Option<f64>,
    /// Tabor's `μ = (R w²/(E*² z0³))^(1/3)` of a summit \[-\]: below 0.1 the attraction leaves its shape alone, above 5 it
    /// makes the contact of Johnson, Kendall and Roberts.
    pub tabor: Option<f64>,
    /// Pastewka and Robbins's criterion `(g Δr/(κ l_a)) (g d/(4 Δr))^(2/3)` with `l_a = w/E*`, `d = 4 g/h″` and κ = 2:
    /// surfaces stick below [`STICKY`].
    pub pastewka_robbins: Option<f64>,
    /// Area that attracts over the area of contact \[-\], by the geometry of that criterion: a rim of the width in which
    /// the gap beside a spot stays below the range, `π d_att/d` with `d_att = (3 Δr √d/(4 g))^(2/3)`.
    pub attracting_area: Option<f64>,
}

impl Stickiness {
    /// Of bodies with the contact modulus E* (Pa), the work of adhesion w (J/m²) and the distance z0 or Δr over which they
    /// attract (m), on a surface of this rms gradient g \[-\] and rms curvature h″ (1/m, half the rms Laplacian).
    pub fn of(
        modulus: f64,
        [work, range]: [f64; 2],
        [gradient, curvature]: [f64; 2],
        summits: Option<AsperityStatistics>,
    ) -> Self {
        let usable = |numbers: &[f64]| {
            let attraction = [modulus, work, range];
            attraction.iter().chain(numbers).all(|number| number.is_finite() && *number > 0.0)
        };
        let of_summits = summits.filter(|s| usable(&[s.radius]));
        let of_heights = of_summits.filter(|s| usable(&[s.height_std]));
        let diameter = usable(&[gradient, curvature]).then(|| 4.0 * gradient / curvature);
        Self {
            fuller_tabor: of_heights
                .map(|s| modulus * s.height_std.powf(1.5) / (work * s.radius.sqrt())),
            tabor: of_summits.map(|s| (s.radius * (work / modulus).powi(2) / range.powi(3)).cbrt()),
            pastewka_robbins: diameter.map(|d| {
                let strength = gradient * range * modulus / (KAPPA * work);
                strength * (gradient * d / (4.0 * range)).powf(2.0 / 3.0)
            }),
            attracting_area: diameter.map(|d| {
                let rim = (3.0 * range * d.sqrt() / (4.0 * gradient)).powf(2.0 / 3.0);
                PI * rim / d
            }),
        }
    }
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
            let summits = Some(AsperityStatistics {
                density: 1.0,
                radius: r,
                height_std: sigma,
                mean_offset: 0.0,
            });
            let found = Stickiness::of(e, [w, z0], [g, curvature], summits);
            close(found.tabor.expect("a radius"), tabor);
            close(found.fuller_tabor.expect("summits"), theta);
            close(found.pastewka_robbins.expect("slopes"), criterion);
            // At the threshold the rim pulls as hard as the spots push: π d_att/d (w/Δr) = E* g/κ.
            let pull = found.attracting_area.expect("slopes") * w / z0;
            close(pull / (e * g * LIGHT), STICKY / criterion);
        }
        close(STICKY, PI * (3.0f64 / 16.0).powf(2.0 / 3.0));
    }

    #[test]
    fn bad_input_has_no_numbers() {
        let summits = |radius, height_std| {
            Some(AsperityStatistics { density: 1.0, radius, height_std, mean_offset: 0.0 })
        };
        let nothing = Stickiness {
            fuller_tabor: None,
            tabor: None,
            pastewka_robbins: None,
            attracting_area: None,
        };
        for [e, w, z] in [[0.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, f64::NAN], [1.0, 1.0, 0.0]]
        {
            assert_eq!(Stickiness::of(e, [w, z], [1.0; 2], summits(1.0, 1.0)), nothing);
        }
        for [g, curvature] in [[0.0, 1.0], [1.0, f64::NAN]] {
            assert_eq!(Stickiness::of(1.0, [1.0; 2], [g, curvature], summits(0.0, 1.0)), nothing);
        }
        let found = Stickiness::of(1.0, [1.0; 2], [1.0; 2], summits(1.0, -1.0));
        assert!(found.fuller_tabor.is_none() && found.tabor.is_some());
    }
}
