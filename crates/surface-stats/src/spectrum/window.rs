//! The window for maps that do not repeat.

use crate::Edges;
use contact_types::Grid;
use std::f64::consts::PI;

/// Hann's window `sin²(π (i + 1/2) / n)`, with mean square 1, which keeps the variance.
///
/// A map that does not repeat has a jump at its edges, whose spectrum falls only as q⁻² and hides a steeper one. A window
/// that goes to zero there removes it. Resolution is two waves per map length.
pub(crate) fn hann(n: usize) -> Vec<f64> {
    let w: Vec<f64> = (0..n).map(|i| (PI * (i as f64 + 0.5) / n as f64).sin().powi(2)).collect();
    let mean_square = w.iter().map(|w| w * w).sum::<f64>() / n as f64;
    w.iter().map(|w| w / mean_square.sqrt()).collect()
}

/// Replaces heights by their distance from the (weighted) mean, times the window if they do not repeat.
pub(crate) fn apply_window(grid: Grid, heights: &mut [f64], edges: Edges) {
    let is_open = edges == Edges::Open;
    let weights = |n: usize| if is_open { hann(n) } else { vec![1.0; n] };
    let [ny, nx] = grid.shape();
    let (wy, wx) = (weights(ny), weights(nx));
    let row_weight: f64 = wx.iter().sum();
    // Twice: the second pass takes off what rounding left of a mean far above the relief.
    for _ in 0..2 {
        let origin = heights[0];
        let (mut sum, mut weight) = (0.0, 0.0);
        for (row, wy) in heights.chunks_exact(nx).zip(&wy) {
            sum += wy * row.iter().zip(&wx).map(|(h, wx)| wx * (h - origin)).sum::<f64>();
            weight += wy * row_weight;
        }
        let mean = origin + sum / weight;
        for h in heights.iter_mut() {
            *h -= mean;
        }
    }
    if is_open {
        for (row, wy) in heights.chunks_exact_mut(nx).zip(&wy) {
            for (h, wx) in row.iter_mut().zip(&wx) {
                *h *= wy * wx;
            }
        }
    }
}
