//! The areal material ratio curve (Abbott–Firestone) and what is read off it.

use crate::StatsError;
use contact_types::HeightMap;

/// Share of the points that the core line is fitted to (ISO 25178-2:2021, 4.5).
const CORE_SHARE: f64 = 0.4;

/// Drops over a window that differ by less are equal: what rounding leaves of heights of at most 1.
const ROUNDING: f64 = 1e-9;

/// Height against the share of the surface that is higher.
///
/// The highest has material ratio 0, the lowest 1, with equal steps and straight lines between them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MaterialRatioCurve {
    /// Heights about their mean in units of `scale`, highest first.
    falling: Vec<f64>,
    /// The largest distance from the mean (m), or 1 for a flat map.
    scale: f64,
}

impl MaterialRatioCurve {
    /// Sorts the heights of a map of 10 points at least.
    pub(crate) fn of(map: &HeightMap) -> Result<Self, StatsError> {
        if map.heights().len() < 10 {
            let (what, found) = ("a material ratio curve", map.heights().len());
            return Err(StatsError::TooFewPoints { what, needed: 10, found });
        }
        let mean = map.mean();
        let mut falling: Vec<f64> = map.heights().iter().map(|h| h - mean).collect();
        falling.sort_unstable_by(|a, b| b.total_cmp(a));
        let reach = falling[0].abs().max(falling[falling.len() - 1].abs());
        let scale = if reach > 0.0 { reach } else { 1.0 };
        for z in &mut falling {
            *z /= scale;
        }
        Ok(Self { falling, scale })
    }

    /// Smc: height above the mean (m) that a share `ratio` (0 to 1, clamped) of the surface
    /// exceeds.
    pub(super) fn height(&self, ratio: f64) -> f64 {
        self.scale * self.scaled_height(ratio)
    }

    /// Smr: share of the surface higher than `height` (m above the mean).
    fn ratio(&self, height: f64) -> f64 {
        let (z, last) = (height / self.scale, self.falling.len() - 1);
        let above = self.falling.partition_point(|&h| h > z);
        if above == 0 || above > last {
            return if above == 0 { 0.0 } else { 1.0 };
        }
        let (high, low) = (self.falling[above - 1], self.falling[above]);
        ((above - 1) as f64 + (high - z) / (high - low)) / last as f64
    }

    /// Volumes per area (ISO 25178-2:2021, 4.5; m, of which 1 is 10⁶ ml/m²): Vmp, material above the height of ratio
    /// 10 %; Vmc and Vvc, material and void between the heights of ratios 10 % and 80 %; Vvv, void below that of 80 %.
    pub(super) fn volumes(&self) -> [f64; 4] {
        // Material above the height of a ratio, and void below it.
        let [[vmp, void], [material, vvv]] = [0.1, 0.8].map(|ratio| {
            let level = self.scaled_height(ratio);
            let above = self.area_above(ratio, level);
            [above, (above - self.area_above(1.0, level)).max(0.0)].map(|area| self.scale * area)
        });
        [vmp, material - vmp, void - vvv, vvv]
    }

    /// Sk, height of the core (m); Spk and Svk, height and depth of the triangles with the areas of the peaks above and of
    /// the valleys below it (m); Smr1 and Smr2, shares of the surface that are peaks and that are not valleys (-).
    ///
    /// The core line is the least-squares line through those 40 % of the points over which the secant is flattest (the first
    /// from the top if several are), read at ratios 0 and 1. Peaks and valleys are what lies above and below these heights,
    /// turned into triangles of equal area on Smr1 and 1 - Smr2.
    pub(crate) fn core(&self) -> [f64; 5] {
        let n = self.falling.len();
        let window = ((CORE_SHARE * (n - 1) as f64).round() as usize).max(1);
        let drops = || (0..n - window).map(move |i| self.falling[i] - self.falling[i + window]);
        let flattest = drops().fold(f64::INFINITY, f64::min);
        let start = drops().position(|drop| drop <= flattest + ROUNDING).unwrap_or(0);
        let core = &self.falling[start..=start + window];
        // Least squares over equally spaced ratios, centred.
        let (centre, last) = (window as f64 / 2.0, (n - 1) as f64);
        let mean = core.iter().sum::<f64>() / core.len() as f64;
        let (mut product, mut square) = (0.0, 0.0);
        for (i, z) in core.iter().enumerate() {
            let x = i as f64 - centre;
            product += x * (z - mean);
            square += x * x;
        }
        let slope = product / square; // per point, not positive
        let top = mean - slope * (start as f64 + centre);
        let bottom = top + slope * last;
        let [mr1, mr2] = [top, bottom].map(|height| self.ratio(self.scale * height));
        let peaks = self.area_above(mr1, top);
        let valleys = self.area_above(mr2, bottom) - self.area_above(1.0, bottom);
        let triangle = |area: f64, base: f64| {
            if base > 0.0 { self.scale * 2.0 * area.max(0.0) / base } else { 0.0 }
        };
        let (peak, valley) = (triangle(peaks, mr1), triangle(valleys, 1.0 - mr2));
        [self.scale * (top - bottom), peak, valley, mr1, mr2]
    }

    fn scaled_height(&self, ratio: f64) -> f64 {
        let last = self.falling.len() - 1;
        let position = ratio.clamp(0.0, 1.0) * last as f64;
        let i = (position.floor() as usize).min(last - 1);
        self.falling[i] + (position - i as f64) * (self.falling[i + 1] - self.falling[i])
    }

    /// `∫_0^ratio (z - level) d(ratio)` along the piecewise straight curve.
    fn area_above(&self, ratio: f64, level: f64) -> f64 {
        let last = self.falling.len() - 1;
        let position = ratio * last as f64;
        let whole = (position.floor() as usize).min(last);
        let trapezium = |a: f64, b: f64| 0.5 * (a + b) - level;
        let full: f64 = self.falling[..=whole].windows(2).map(|z| trapezium(z[0], z[1])).sum();
        let rest = position - whole as f64;
        let part = rest * trapezium(self.falling[whole], self.scaled_height(ratio));
        (full + part) / last as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;
    use contact_types::Grid;

    fn curve(z: impl Fn(f64) -> f64) -> MaterialRatioCurve {
        let n = 40_001;
        let heights = (0..n).map(|i| z(i as f64 / (n - 1) as f64)).collect();
        let grid = Grid::new([1, n], [1e-6, 1e-6]).unwrap();
        MaterialRatioCurve::of(&HeightMap::new(grid, heights).unwrap()).unwrap()
    }

    /// Heights spread evenly over 1 um: a straight curve, all core.
    #[test]
    fn a_straight_curve_is_all_core() {
        let c = curve(|t| 1e-6 * t);
        let [core, peak, valley, ..] = c.core();
        close(core, 1e-6, 1e-9);
        assert!(peak < 1e-12 && valley < 1e-12);
        close(c.height(0.1), 0.4e-6, 1e-9);
        close(c.ratio(0.25e-6), 0.25, 1e-9);
        close(c.height(0.025) - c.height(0.5), 0.475e-6, 1e-9);
        // 0.1²/2; 0.8²/2 - 0.1²/2; 0.9²/2 - 0.2²/2; 0.2²/2
        for (volume, exact) in c.volumes().into_iter().zip([0.005e-6, 0.315e-6, 0.385e-6, 0.02e-6])
        {
            close(volume, exact, 1e-6);
        }
    }

    /// Of top and bottom of a sine the window is at the top: nothing stands above the core.
    #[test]
    fn equally_flat_windows_are_told_by_their_place() {
        for amplitude in [1e-6, -1e-6] {
            let wave = |t: f64| amplitude * (t * 40.0 * std::f64::consts::TAU).sin() + 0.3e-6;
            let [_, peak, valley, ..] = curve(wave).core();
            assert!(peak < 0.03e-6, "{peak:e}");
            close(valley, 0.445e-6, 0.02);
        }
    }
}
