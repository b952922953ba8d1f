//! What pixel size, height steps and noise do to the inputs of contact models, on a surface whose
//! truth is known: 1 mm x 1 mm, rms height 0.6 µm, Hurst exponent 0.7, wavelengths 6 to 80 µm.
//!
//! Run with `cargo run --release -p surface-stats --example measurement_effects`.
#![allow(clippy::print_stdout, reason = "an example prints")]

use contact_types::{AsperityStatistics, Grid, HeightMap, SpectralMoments};
use std::f64::consts::FRAC_PI_4;
use surface_stats::sampling::{effect_of_steps, moments_by_interval};
use surface_stats::synthesis::{Scale, SelfAffine};
use surface_stats::{Edges, StatsError, StatsOptions, SurfaceStatistics};

fn main() -> Result<(), StatsError> {
    let um = 1e-6;
    let truth = SelfAffine {
        grid: Grid::new([1001, 1001], [um, um])?,
        hurst: 0.7,
        rolloff: 80.0 * um,
        cutoff: 6.0 * um,
        scale: Scale::RmsHeight(0.6 * um),
        seed: 2,
        quantise: None,
    };
    let map = truth.generate()?;
    let edges = Edges::Periodic;

    println!("Sampling interval (µm), rms gradient, bandwidth, asperities per mm², radius (µm)");
    for point in moments_by_interval(&map, edges)?.iter().take(4) {
        println!("{:>3} | {}", point.every, row(point.moments));
    }

    println!("\nHeight step (nm), the same, then counted summits per mm², flat tops per mm²");
    for effect in effect_of_steps(&map, &[1e-9, 5e-9, 10e-9, 20e-9, 50e-9], edges)? {
        let summits = effect.summits;
        println!(
            "{:>3.0} | {} | {:6.0} | {:5}",
            effect.step * 1e9,
            row(effect.moments),
            summits.density * 1e-6,
            summits.plateaus,
        );
    }

    println!("\nWhite noise (nm rms): as found from the spectrum alone, reliable wavelength (µm)");
    for rms in [1e-9, 5e-9, 20e-9] {
        // The recipe fills the circle of waves longer than two pixels, π/4 of all there are: this
        // is the spectrum of white noise of rms `rms` without its corners.
        let noise = SelfAffine {
            rolloff: 2.0 * um,
            cutoff: 2.0 * um,
            scale: Scale::RmsHeight(rms * FRAC_PI_4.sqrt()),
            seed: 3,
            ..truth
        };
        let noise = noise.generate()?;
        let heights = map.heights().iter().zip(noise.heights()).map(|(a, b)| a + b);
        let noisy = HeightMap::new(map.grid(), heights.collect())?;
        let options = StatsOptions::default().with_edges(edges);
        let statistics = SurfaceStatistics::of(&noisy, &options)?;
        println!(
            "{:>3.0} | {} | {:.2} nm | {:.1} µm",
            rms * 1e9,
            row(statistics.moments()),
            statistics.noise_rms.unwrap_or(0.0) * 1e9,
            statistics.reliable_wavelength.unwrap_or(f64::INFINITY) / um,
        );
    }
    Ok(())
}

fn row(moments: SpectralMoments) -> String {
    let asperities = AsperityStatistics::from_moments(moments).ok();
    let (density, radius) = asperities.map_or((0.0, 0.0), |a| (a.density, a.radius));
    format!(
        "{:.4} | {:6.2} | {:6.0} | {:6.2}",
        moments.rms_gradient(),
        moments.bandwidth(),
        density * 1e-6,
        radius * 1e6,
    )
}
