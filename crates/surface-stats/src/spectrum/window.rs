//! Windows for maps that do not repeat.

use contact_types::Grid;
use std::f64::consts::PI;

/// What a map is multiplied with before it is transformed.
///
/// A map that does not repeat has a jump at its edges, whose spectrum falls only as q⁻² and hides a steeper one. A window
/// that goes to zero there removes it. The result is divided by the mean square of the window, which keeps the variance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Window {
    /// None: right for maps that repeat.
    #[default]
    None,
    /// Hann: `sin²(π (i + 1/2) / n)` along both axes. Resolution is two waves per map length.
    Hann,
}

impl Window {
    /// Weights of `n` samples along one axis, with mean square 1.
    pub(crate) fn weights(self, n: usize) -> Vec<f64> {
        match self {
            Self::None => vec![1.0; n],
            Self::Hann => {
                let w: Vec<f64> =
                    (0..n).map(|i| (PI * (i as f64 + 0.5) / n as f64).sin().powi(2)).collect();
                let mean_square = w.iter().map(|w| w * w).sum::<f64>() / n as f64;
                w.iter().map(|w| w / mean_square.sqrt()).collect()
            }
        }
    }

    /// Replaces heights by their distance from the (weighted) mean, times the window.
    pub(crate) fn apply(self, grid: Grid, heights: &mut [f64]) {
        let [ny, nx] = grid.shape();
        let (wy, wx) = (self.weights(ny), self.weights(nx));
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
        if self != Self::None {
            for (row, wy) in heights.chunks_exact_mut(nx).zip(&wy) {
                for (h, wx) in row.iter_mut().zip(&wx) {
                    *h *= wy * wx;
                }
            }
        }
    }
}
