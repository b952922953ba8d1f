//! Do the error bars hold? The area of a map against that of its Fourier interpolation to four
//! times as many points along each side, which stands for the continuum.

#![allow(clippy::unwrap_used, reason = "a check that cannot be made has failed")]

use compare::{Comparison, Registry, Settings, built_in_recipes};
use contact_types::ContactModulus;
use fft_bem_solver::{Load, Solver};
use std::ops::ControlFlow;
use surface_stats::Edges;
use surface_stats::clean::resample;

/// Of the areas that carry a bar, how many are asked, how many bars hold the refined area, the
/// largest distance in half widths, and the widest bar as a share of its area.
#[derive(Debug, Default)]
struct Coverage {
    asked: usize,
    held: usize,
    farthest: f64,
    widest: f64,
}

/// Maps of 128 x 128 points with these shortest wavelengths (points), their heights in steps of
/// `step` times pixel and rms gradient, each at three loads.
fn coverage(cutoffs: &[f64], step: Option<f64>) -> Coverage {
    let mut found = Coverage::default();
    for (seed, &cutoff) in cutoffs.iter().enumerate() {
        let mut recipe = built_in_recipes().unwrap().remove(0);
        recipe.shape = [128, 128];
        recipe.pixel = [1e-6, 1e-6];
        recipe.rolloff = 32e-6;
        recipe.cutoff = cutoff * 1e-6;
        recipe.seed = 40 + seed as u64;
        recipe.quantise = step.map(|q| q * 0.1 * 1e-6);
        (recipe.rms_height, recipe.rms_gradient) = (None, Some(0.1));
        let scale = 1e9 * 0.1;
        let settings = Settings {
            modulus: 1e9,
            pressures: Some([0.004, 0.02, 0.1].map(|x| x * scale).to_vec()),
            headline: Some(0.02 * scale),
            ..Settings::default()
        };
        let surface = recipe.make().unwrap();
        let mut go = |_: compare::Progress<'_>| ControlFlow::Continue(());
        let comparison =
            Comparison::run(vec![surface], settings, &Registry::built_in(), &mut go).unwrap();
        let study = &comparison.surfaces[0];

        let fine = resample(&study.surface, [512, 512], Edges::Periodic).unwrap();
        let modulus = ContactModulus::from_pascals(1e9).unwrap();
        let mut solver = Solver::builder().build(fine.grid(), modulus).unwrap();
        for point in &study.deterministic {
            let answer = point.answer.as_ref().unwrap();
            let Some(half) = answer.uncertainty() else { continue };
            let truth = solver.solve(&fine, Load::MeanPressure(point.mean_pressure)).unwrap();
            let area = answer.area_fraction_corrected;
            let distance = (truth.diagnostics.area_fraction_corrected - area).abs() / half;
            found.asked += 1;
            found.held += usize::from(distance <= 1.0);
            found.farthest = found.farthest.max(distance);
            found.widest = found.widest.max(half / area);
        }
    }
    found
}

/// A resolved map: every load has a bar, from that solution alone.
#[test]
fn bars_of_resolved_maps_hold() {
    let found = coverage(&[4.0, 6.0, 8.0, 12.0], None);
    assert_eq!((found.asked, found.held), (12, 12), "{found:?}");
    // Widest where a few round spots carry the lightest load: chance.
    assert!(found.widest < 0.09, "{found:?}");
}

/// Waves of two points, and heights in coarse steps: only the headline has a bar, from one more
/// solution on a twice finer grid.
#[test]
fn bars_of_unresolved_maps_hold() {
    for step in [None, Some(0.7), Some(1.0), Some(2.0)] {
        let found = coverage(&[2.0, 2.1, 2.3], step);
        assert!(found.asked >= 3 && found.held == found.asked, "{step:?} {found:?}");
    }
}
