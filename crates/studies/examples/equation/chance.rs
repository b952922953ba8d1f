//! What one map differs from another of the same spectrum: the chance that no law for numbers can know.

use crate::measure::{self, LOADS};
use crate::table::one;
use contact_types::{HeightMap, SpectralMoments};
use multiscale_models::Equation;
use rayon::prelude::*;
use std::error::Error;
use std::fmt::Write as _;
use studies::maps::{scaled, self_affine};
use surface_stats::synthesis::Scale;

const POINTS: usize = 512;
const SEEDS: usize = 12;
/// Roll-offs over the side of the map.
const ROLLOFFS: [f64; 3] = [0.125, 0.25, 0.5];
/// Hurst exponents, shortest waves in points.
const SPECTRA: [[f64; 2]; 2] = [[0.3, 10.0], [0.8, 10.0]];
pub(crate) const HEADER: &str = "hurst,rolloff,seed,alpha,x,area";

fn map(hurst: f64, cutoff: f64, rolloff: f64, seed: u64) -> Result<HeightMap, Box<dyn Error>> {
    let waves = [hurst, cutoff, rolloff * POINTS as f64];
    scaled(&self_affine(POINTS, waves, 1.0, Scale::RmsHeight(1.0), seed)?, POINTS)
}

/// The rows of all maps: areas on the given points, corrected.
pub(crate) fn rows() -> Result<String, Box<dyn Error>> {
    let mut cases = Vec::new();
    for (i, rolloff) in ROLLOFFS.into_iter().enumerate() {
        for (j, [hurst, cutoff]) in SPECTRA.into_iter().enumerate() {
            for k in 0..SEEDS {
                cases.push((rolloff, hurst, cutoff, (900_000 + 1000 * i + 100 * j + k) as u64));
            }
        }
    }
    let row = |&(rolloff, hurst, cutoff, seed): &(f64, f64, f64, u64)| {
        let one = || -> Result<String, Box<dyn Error>> {
            let map = map(hurst, cutoff, rolloff, seed)?;
            let alpha = measure::moments(&map)?.bandwidth();
            let mut text = String::new();
            for (x, area) in LOADS.into_iter().zip(measure::areas(&map, &LOADS)?) {
                let _ = writeln!(text, "{hurst},{rolloff},{seed},{alpha:.5},{x},{area:.6}");
            }
            Ok(text)
        };
        one().map_err(|e| e.to_string())
    };
    let found: Vec<Result<String, String>> = cases.par_iter().map(row).collect();
    let mut text = format!("{HEADER}\n");
    for rows in found {
        text += &rows?;
    }
    Ok(text)
}

/// Whether a row is of this Hurst exponent, roll-off and load, which are printed and read to the last bit.
fn is_row(row: &[f64], keys: [f64; 3]) -> bool {
    [row[0], row[1], row[4]].iter().zip(keys).all(|(a, b)| a.total_cmp(&b).is_eq())
}

/// The table of the book: over the loads and roll-offs, between which two maps of one spectrum differ, and how far the law for
/// numbers is from the mean of them.
pub(crate) fn page(table: &str) -> Result<String, Box<dyn Error>> {
    let mut page = String::from(
        "\nChance: isotropic Gaussian maps, twelve of each spectrum. *Chance* is 1.96 standard deviations of ln A between maps of one \
         spectrum, *law* how far the law for numbers is from their mean, ± 1.96 standard errors of it, per cent:\n\n\
         | roll-off | | A ≈ 0.1 % | 0.4 % | 1 % | 3.5 % | 10 % | 25 % | 53 % | 85 % | 99 % |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let rows: Vec<Vec<f64>> = table
        .lines()
        .filter(|l| !l.starts_with('#') && *l != HEADER)
        .map(|l| l.split(',').map(str::parse).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()?;
    for rolloff in ROLLOFFS {
        let (mut chance, mut law) = (String::new(), String::new());
        for x in LOADS {
            let (mut between, mut off, mut spectra) = (0.0, 0.0, 0.0);
            for [hurst, _] in SPECTRA {
                let own = rows.iter().filter(|r| is_row(r, [hurst, rolloff, x]));
                let mut pairs = Vec::new();
                for r in own {
                    let moments = SpectralMoments { m0: 1.0, m2: 0.5, m4: 0.25 * r[3] };
                    let numbers = Equation::from_moments(moments, one()?)?.area_fraction(x)?;
                    pairs.push((r[5].ln(), numbers.ln()));
                }
                let n = pairs.len() as f64;
                let mean = pairs.iter().map(|p| p.0).sum::<f64>() / n;
                between += pairs.iter().map(|p| (p.0 - mean).powi(2)).sum::<f64>() / (n - 1.0);
                off += pairs.iter().map(|p| p.1 - p.0).sum::<f64>() / n;
                spectra += 1.0;
            }
            let deviation = (between / spectra).sqrt();
            let error = 1.96 * deviation / (SEEDS as f64 * spectra).sqrt();
            let off = off / spectra;
            let sign = if off < 0.0 { "−" } else { "+" };
            let _ = write!(chance, " {:.1} |", 196.0 * deviation);
            let _ = write!(law, " {sign}{:.1} ± {:.1} |", 100.0 * off.abs(), 100.0 * error);
        }
        let _ = writeln!(page, "| 1/{:.0} of the side | chance |{chance}", 1.0 / rolloff);
        let _ = writeln!(page, "| | law |{law}");
    }
    Ok(page)
}
