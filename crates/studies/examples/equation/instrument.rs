//! Four families as an instrument gives them: with noise from point to point, and with what a threshold for
//! spikes leaves.

use crate::fields::{fine, other, rough};
use studies::maps::{Draw, Heights, gradient, mix, softmin};

/// White noise on top, of a part of the mean square gradient; on half of the maps smoothed along the scan.
fn noisy_as(d: &Draw, heights: &[f64]) -> Vec<f64> {
    let n = d.n;
    let share = d.lin(3, 0.05, 0.85);
    let thrice = d.uniform(3 * n * n, 71);
    let white: Vec<f64> = thrice.chunks_exact(3).map(|u| u.iter().sum::<f64>() - 1.5).collect();
    let noise: Vec<f64> = if other(d, 9.3) < 0.5 {
        let next = |i: usize| i / n * n + (i + 1) % n;
        (0..n * n).map(|i| 0.5 * (white[i] + white[next(i)])).collect()
    } else {
        white
    };
    let size = (share / (1.0 - share)).sqrt() * gradient(heights, n) / gradient(&noise, n);
    mix(heights, &noise, |z, w| z + size * w)
}

pub(crate) fn noisy(d: &Draw) -> Heights {
    Ok(noisy_as(d, &rough(d, 1.0, 0)?))
}

/// Worn, and measured with noise: it is steepest where the surface is flat.
pub(crate) fn noisy_worn(d: &Draw) -> Heights {
    let level = -0.5 + 1.7 * other(d, 9.3);
    let worn = mix(&rough(d, 1.0, 0)?, &fine(d, 1)?, |z, f| softmin(z, level, 0.15) + 0.05 * f);
    Ok(noisy_as(d, &worn))
}

/// With a lay, and measured with noise.
pub(crate) fn noisy_lay(d: &Draw) -> Heights {
    Ok(noisy_as(d, &rough(d, 1.2 * 5f64.powf(other(d, 9.3)), 0)?))
}

/// Points far off their neighbours, most of them below: holes where no light comes back.
pub(crate) fn spiked(d: &Draw) -> Heights {
    let count = (d.n as f64).powi(2) * 2e-4 * 30f64.powf(other(d, 9.3));
    let mut heights = noisy_lay(d)?;
    let size = 4.0 * gradient(&heights, d.n);
    let points = heights.len() as f64;
    for u in d.uniform(4 * count as usize, 73).chunks_exact(4) {
        let way = if u[1] < 0.25 { 0.3 } else { -1.0 };
        let first = (points * u[0]) as usize;
        // One to four points of a row.
        for i in first..(first + 1 + (4.0 * u[2]) as usize).min(heights.len()) {
            heights[i] += way * size * -(1.0 - u[3]).ln();
        }
    }
    Ok(heights)
}
