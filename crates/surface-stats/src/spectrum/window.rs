//! The window for maps that do not repeat.

use crate::Edges;
use contact_types::HeightMap;
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

/// Writes one row of a map, by its index, about its (weighted) mean, times the window if it does not repeat.
pub(crate) fn window(map: &HeightMap, edges: Edges) -> impl Fn(usize, &mut [f64]) {
    let is_open = edges == Edges::Open;
    let weights = |n: usize| if is_open { hann(n) } else { vec![1.0; n] };
    let ([ny, nx], heights) = (map.grid().shape(), map.heights());
    let (wy, wx) = (weights(ny), weights(nx));
    let weight = wy.iter().sum::<f64>() * wx.iter().sum::<f64>();
    let mean_above = |origin: f64| {
        let rows = heights.chunks_exact(nx).zip(&wy);
        let sum = |row: &[f64]| row.iter().zip(&wx).map(|(h, wx)| wx * (h - origin)).sum::<f64>();
        rows.map(|(row, wy)| wy * sum(row)).sum::<f64>() / weight
    };
    let mean = heights[0] + mean_above(heights[0]);
    // What rounding left of a mean far above the relief.
    let rest = mean_above(mean);
    move |iy, out| {
        let row = &heights[iy * nx..(iy + 1) * nx];
        for ((out, h), wx) in out.iter_mut().zip(row).zip(&wx) {
            *out = (h - mean - rest) * (wy[iy] * wx);
        }
    }
}
