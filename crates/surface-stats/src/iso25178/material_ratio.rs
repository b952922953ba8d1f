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

/// Parameters of the core line (ISO 25178-2:2021, 4.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CoreRoughness {
    /// Sk: height of the core (m).
    pub(crate) core_height: f64,
    /// Spk: height of the triangle with the area of the peaks above the core (m).
    pub(crate) reduced_peak_height: f64,
    /// Svk: depth of the triangle with the area of the valleys below the core (m).
    pub(crate) reduced_valley_depth: f64,
    /// Smr1: share of the surface that is peaks (-).
    pub(crate) peak_ratio: f64,
    /// Smr2: share of the surface that is not valleys (-).
    pub(crate) valley_ratio: f64,
}

/// Volumes per area between material ratios of 10 % and 80 % (ISO 25178-2:2021, 4.5); 1 m³/m² is
/// 10⁶ ml/m².
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Volumes {
    /// Vmp: material above the height of ratio 10 % (m).
    pub(super) peak_material: f64,
    /// Vmc: material between the heights of ratios 10 % and 80 % (m).
    pub(super) core_material: f64,
    /// Vvc: void between the heights of ratios 10 % and 80 % (m).
    pub(super) core_void: f64,
    /// Vvv: void below the height of ratio 80 % (m).
    pub(super) valley_void: f64,
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
    fn height(&self, ratio: f64) -> f64 {
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

    /// Sxp: height of ratio 2.5 % above that of ratio 50 % (m).
    pub(super) fn peak_extreme_height(&self) -> f64 {
        self.height(0.025) - self.height(0.5)
    }

    /// Vmp, Vmc, Vvc, Vvv at ratios 10 % and 80 %.
    pub(super) fn volumes(&self) -> Volumes {
        // Material above the height of a ratio, and void below it.
        let [[peak_material, void], [material, valley_void]] = [0.1, 0.8].map(|ratio| {
            let level = self.scaled_height(ratio);
            let above = self.area_above(ratio, level);
            [above, (above - self.area_above(1.0, level)).max(0.0)].map(|area| self.scale * area)
        });
        Volumes {
            peak_material,
            core_material: material - peak_material,
            core_void: void - valley_void,
            valley_void,
        }
    }

    /// Sk, Spk, Svk, Smr1, Smr2.
    ///
    /// The core line is the least-squares line through those 40 % of the points over which the secant is flattest (the first
    /// from the top if several are), read at ratios 0 and 1. Peaks and valleys are what lies above and below these heights,
    /// turned into triangles of equal area on Smr1 and 1 - Smr2.
    pub(crate) fn core(&self) -> CoreRoughness {
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
        let (peak_ratio, valley_ratio) =
            (self.ratio(self.scale * top), self.ratio(self.scale * bottom));
        let peaks = self.area_above(peak_ratio, top);
        let valleys = self.area_above(valley_ratio, bottom) - self.area_above(1.0, bottom);
        let triangle = |area: f64, base: f64| {
            if base > 0.0 { self.scale * 2.0 * area.max(0.0) / base } else { 0.0 }
        };
        CoreRoughness {
            core_height: self.scale * (top - bottom),
            reduced_peak_height: triangle(peaks, peak_ratio),
            reduced_valley_depth: triangle(valleys, 1.0 - valley_ratio),
            peak_ratio,
            valley_ratio,
        }
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
        let core = c.core();
        close(core.core_height, 1e-6, 1e-9);
        assert!(core.reduced_peak_height < 1e-12 && core.reduced_valley_depth < 1e-12);
        close(c.height(0.1), 0.4e-6, 1e-9);
        close(c.ratio(0.25e-6), 0.25, 1e-9);
        close(c.peak_extreme_height(), 0.475e-6, 1e-9);
        let v = c.volumes();
        close(v.peak_material, 0.005e-6, 1e-6); // 0.1² / 2
        close(v.core_material, 0.315e-6, 1e-6); // 0.8²/2 - 0.1²/2
        close(v.core_void, 0.385e-6, 1e-6); // 0.9²/2 - 0.2²/2
        close(v.valley_void, 0.02e-6, 1e-6);
    }

    /// Top and bottom of a sine are equally flat: the window is the one at the top, whatever rounding
    /// says, so that nothing stands above the core.
    #[test]
    fn equally_flat_windows_are_told_by_their_place() {
        for amplitude in [1e-6, -1e-6] {
            let wave = |t: f64| amplitude * (t * 40.0 * std::f64::consts::TAU).sin() + 0.3e-6;
            let core = curve(wave).core();
            assert!(core.reduced_peak_height < 0.03e-6, "{core:?}");
            close(core.reduced_valley_depth, 0.445e-6, 0.02);
        }
    }
}
