//! A synthetic surface has the properties its recipe names.
use crate::recipe;
use approx::assert_relative_eq;
use contact_types::{Grid, HeightMap};
use proptest::prelude::*;
use std::f64::consts::TAU;
use surface_stats::spectrum::PowerSpectrum;
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, StatsError, StatsOptions, SurfaceStatistics};

fn waves(map: &HeightMap) -> PowerSpectrum {
    PowerSpectrum::of(map, Edges::Periodic).unwrap()
}

proptest! {
    /// Any shape and pixel: scale as asked for, mean zero, no wave beyond the cut-off.
    #[test]
    fn scale_and_band_hold_on_every_grid(
        ny in 20usize..60, nx in 20usize..60, dy in 0.5..2.0f64, hurst in 0.01..=1.0,
        seed in 0u64..1000, by_height in any::<bool>(),
    ) {
        let scale = if by_height { Scale::RmsHeight(3e-7) } else { Scale::RmsGradient(0.05) };
        let grid = Grid::new([ny, nx], [dy * 1e-6, 1e-6]).unwrap();
        let cutoff = 2.5e-6 * dy.max(1.0);
        let surface = SelfAffine { grid, hurst, cutoff, scale, seed, ..recipe([1, 1], [9.0, 9.0]) };
        let map = surface.generate().unwrap();
        let power = waves(&map);
        let moments = power.moments();
        match scale {
            Scale::RmsHeight(rms) => prop_assert!((moments.rms_height() / rms - 1.0).abs() < 1e-12),
            Scale::RmsGradient(g) => prop_assert!((moments.rms_gradient() / g - 1.0).abs() < 1e-12),
        }
        prop_assert!(map.mean().abs() < 1e-12 * moments.rms_height());
        for ring in power.rings() {
            let is_beyond = ring.wavenumber > TAU / cutoff * (1.0 + 1e-9);
            prop_assert!(!is_beyond || ring.variance < 1e-28 * moments.m0 * ring.waves as f64);
        }
    }
}

/// The PSD follows the recipe: over 16 maps each band of waves has its share of the variance to
/// four standard deviations, 4 sqrt(2 / waves).
#[test]
fn the_spectrum_is_the_one_asked_for() {
    let mut mean: Vec<[f64; 3]> = Vec::new();
    let maps = 16;
    for seed in 0..maps {
        let map = SelfAffine { seed, ..recipe([128; 2], [16.0, 8.0]) }.generate().unwrap();
        let rings = waves(&map).rings();
        mean.resize(rings.len(), [0.0; 3]);
        // The scale of each map is random; compare shapes relative to the plateau's exact share.
        for (sum, ring) in mean.iter_mut().zip(&rings) {
            sum[0] += ring.psd / maps as f64;
            sum[1] = sum[1].max(ring.wavenumber);
            sum[2] += ring.waves as f64;
        }
    }
    let (q0, q1, step) = (TAU / 16e-6, TAU / 8e-6, TAU / 128e-6);
    let shape = |q: f64| (q / q0).max(1.0).powf(-3.6);
    let inside: Vec<_> = mean.iter().filter(|[_, q, _]| *q < q1 - step).collect();
    let level = inside.iter().map(|[c, q, n]| n * c / shape(*q)).sum::<f64>()
        / inside.iter().map(|[.., n]| n).sum::<f64>();
    for [psd, q, waves] in inside {
        let limit = 4.0 * (2.0 / waves).sqrt() + 0.02; // 2 %: PSD bends within a ring
        assert_relative_eq!(psd / (level * shape(*q)), 1.0, epsilon = limit);
    }
}

#[test]
fn statistics_recover_the_recipe() {
    for (hurst, seed) in [(0.8, 1), (0.5, 2), (0.3, 3)] {
        let map = SelfAffine { hurst, seed, ..recipe([512; 2], [64.0, 4.0]) }.generate().unwrap();
        let options = StatsOptions { edges: Edges::Periodic, ..StatsOptions::default() };
        let s = SurfaceStatistics::of(&map, &options).unwrap();
        assert_relative_eq!(s.hurst.unwrap(), hurst, epsilon = 0.05);
        assert_relative_eq!(s.dimension.unwrap(), 2.0 - hurst, epsilon = 0.05);
        assert_relative_eq!(s.rolloff.unwrap(), 64e-6, max_relative = 0.15, epsilon = 0.0);
        assert_relative_eq!(s.cutoff.unwrap(), 4e-6, max_relative = 0.01, epsilon = 0.0);
        // Gaussian and isotropic: counted summits agree with Nayak's density within 5 %.
        let theory = s.asperities.unwrap();
        assert_relative_eq!(s.summits.density, theory.density, max_relative = 0.05, epsilon = 0.0);
        assert!(s.warnings.is_empty(), "{:?}", s.warnings);
    }
}

/// The generator's stream is part of the format: these values, the first of a map made by another program from the
/// definition of PCG XSL RR 128/64, must not change. All of the stream is in each.
#[test]
fn a_seed_means_the_same_map_for_ever() {
    let map = SelfAffine { seed: 42, ..recipe([6, 5], [3.0, 2.0]) };
    let heights = map.generate().unwrap().into_heights();
    let expected = [
        2.546709920871983e-07,
        1.450876624673854e-07,
        -1.960732680549053e-07,
        -3.777285990978708e-07,
        1.014618502575698e-07,
        3.953868879686559e-07,
    ];
    for (h, e) in heights.iter().zip(expected) {
        assert_relative_eq!(*h, e, epsilon = 1e-18);
    }
    let other = SelfAffine { seed: 43, ..map }.generate().unwrap();
    assert!(other.heights()[0].to_bits() != heights[0].to_bits());
}

#[test]
fn impossible_recipes_are_refused() {
    let good = recipe([64; 2], [8.0, 8.0]);
    let bad = [
        SelfAffine { hurst: 0.0, ..good },
        SelfAffine { hurst: 1.1, ..good },
        SelfAffine { hurst: f64::NAN, ..good },
        SelfAffine { rolloff: 0.0, ..good },
        SelfAffine { rolloff: f64::INFINITY, ..good },
        SelfAffine { rolloff: 7e-6, ..good },
        SelfAffine { cutoff: 1.9e-6, ..good },
        SelfAffine { scale: Scale::RmsHeight(0.0), ..good },
        SelfAffine { scale: Scale::RmsGradient(-1.0), ..good },
        SelfAffine { quantise: Some(0.0), ..good },
        SelfAffine { quantise: Some(1.0), ..good },
        SelfAffine { grid: Grid::new([1 << 20, 1 << 20], [1e-6, 1e-6]).unwrap(), ..good },
        SelfAffine { quantise: Some(f64::NAN), ..good },
    ];
    for recipe in bad {
        assert!(matches!(recipe.generate(), Err(StatsError::BadSetting { .. })), "{recipe:?}");
    }
    let empty = SelfAffine { cutoff: 65e-6, rolloff: 70e-6, ..good };
    assert!(matches!(empty.generate(), Err(StatsError::EmptyBand { .. })));
    let one = SelfAffine { grid: Grid::new([1, 1], [1e-6, 1e-6]).unwrap(), ..good };
    assert!(matches!(one.generate(), Err(StatsError::EmptyBand { .. })));
}

/// A joint is known by σ and slope: the map has both, whatever the seed, and what no roll-off gives is refused.
#[test]
fn a_map_with_rms_height_and_gradient_both() {
    let recipe = SelfAffine {
        hurst: 0.7,
        scale: Scale::RmsHeight(0.6e-6),
        seed: 5,
        ..recipe([128, 96], [8.0, 8.0])
    };
    for gradient in [0.12, 0.2] {
        let recipe = recipe.with_gradient(gradient).unwrap();
        let found = waves(&recipe.generate().unwrap()).moments();
        assert!((found.rms_height() / 0.6e-6 - 1.0).abs() < 1e-12);
        assert!((found.rms_gradient() / gradient - 1.0).abs() < 1e-10, "{found:?}");
        assert!((8e-6..128e-6).contains(&recipe.rolloff));
    }
    for wrong in [0.0, 1e-3, 10.0, f64::NAN] {
        assert!(recipe.with_gradient(wrong).is_err(), "{wrong}");
    }
}
