//! Error of the grid: contact lines cut pixels, peaks stand between points.
//!
//! The bar of the area is [`AreaAccuracy`](super::AreaAccuracy)'s. Gap and stiffness converge faster;
//! their bars are parts of the same measure of resolution, the share of the contact line,
//! `0.118 S_d / A`.

use super::bend::Bend;
use super::between::Between;
use super::map::Map;
use contact_types::Grid;
use fft_bem_solver::{BOUNDARY_CORRECTION, Solution};

/// Gap error over (rms height times share of the contact line), on a map that repeats.
const GAP: f64 = 0.016;
/// The same on a map whose edges do not match.
const GAP_AT_SEAM: f64 = 0.08;
/// Relative error of the stiffness over the share of the contact line.
const STIFFNESS: f64 = 0.2;
/// The same on a map whose edges do not match.
const STIFFNESS_AT_SEAM: f64 = 0.33;

/// Half width of the gap over the height of the jumps between edges that do not match.
const SEAM_GAP: f64 = 0.5;
/// Half width of the area over the share of the points along them, as `A⁴`.
const SEAM_AREA: f64 = 0.25;
/// Share of a pixel's worth of deformation from which the gap errs by all of the difference of the
/// interpolants.
const EVENED_OUT: f64 = 0.125;
/// Relative error of the gap over the share of the line in the open places, and the same at a seam.
const OPEN_GAP: f64 = 0.33;
const OPEN_GAP_AT_SEAM: f64 = 2.2;
/// What all waves beyond eight points in line differ from a cubic by, over what those eight do.
const TAIL: f64 = 2.0;
/// Half width of the area over the share of points in light contact.
const LIGHT: f64 = 1.5;
/// The same over the square of the doubt inside the contact.
const SHARP: f64 = 7.0;
/// Half width of the area over the share of points under little pressure, where valleys are creased.
const SLITS: f64 = 0.35;
/// By how much the parts of gap and stiffness from the grid are wider, over the root of the blocks that carry the load: the peaks of few
/// spots stand beside the points by chance, those of many in the mean.
const FEW: f64 = 1.5;
/// By how much more that of the stiffness is, over the blocks that carry the load.
const VERY_FEW: f64 = 2.0;
/// Gap error over (rms second difference of the heights where something touches, times share of the contact line), on
/// smooth peaks and where some of them may be creases.
const PEAK: [f64; 2] = [0.1, 0.3];
/// [Growth](Bend::growth) below which that may be.
const SMOOTH_GROWTH: f64 = 3.5;
/// Half width of the area on creases over the correction of the finer grid.
const CREASED: f64 = 2.0;
/// Relative half width of the stiffness on creases over the share of the line of the finer grid.
const CREASED_STIFFNESS: f64 = 2.5;
/// Half width of the gap on creases over the rms second difference there.
const CREASED_GAP: f64 = 0.12;
/// Share of the contact line above which a finer grid does not resolve creases.
const CREASED_SHARE: f64 = 0.1;
/// Open share of the surface below which the error of the stiffness is counted against it.
const OPEN: f64 = 0.6;
/// Relative error of the stiffness over the share of the line in the open places, and what it has on top in the few that
/// are left near full contact, as `A³⁰`.
const OPEN_STIFFNESS: [f64; 2] = [0.25, 0.85];

/// Bars of area, mean gap and stiffness over those of elastic contact, where part of the contact has yielded.
///
/// Of 144 solutions of random surfaces (256², H = 0.4 and 0.8, 6 to 12 points to the shortest wave, E\* g/H = 1 to
/// 10, p/(E\* g) = 0.005 to 0.3) the bars of elastic contact held 143, 136 and 122, the farthest at 1.05, 1.98 and
/// 2.14 of them: the edges of what has yielded are sharp, and not taken off the area. So much wider, all hold
/// (`examples/yielding_bar.rs`).
pub const YIELDING: [f64; 3] = [1.5, 3.0, 3.0];

/// The contact line of a solution.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Line {
    /// Corrected area fraction (-).
    pub area: f64,
    /// Edges per point, S_d (-).
    pub edges: f64,
}

impl Line {
    /// Of a solution.
    pub fn of(solution: &Solution) -> Self {
        let found = &solution.diagnostics;
        Self { area: found.area_fraction_corrected, edges: found.contact_perimeter }
    }

    /// Correction over corrected area, 0 without a line (-).
    pub fn share(self) -> f64 {
        let correction = BOUNDARY_CORRECTION * self.edges;
        if correction > 0.0 { correction / self.area } else { 0.0 }
    }
}

/// By how much the half widths of mean gap and stiffness widen where so many blocks carry the load.
pub fn of_few_spots(carrying: f64) -> [f64; 2] {
    let few = 1.0 + FEW / carrying.sqrt();
    [few, few + VERY_FEW / carrying]
}

/// Half width of the mean gap (m) at this contact line. Where its edges run alike, on a lay or a
/// regular pattern, it widens as that of the area does.
pub fn gap_half_width(map: &Map, line: Line) -> f64 {
    let part = if map.repeats { GAP } else { GAP_AT_SEAM };
    part * map.rms_height * line.share() * map.accuracy.widened(line.edges)
}

/// Half width of a mean gap (m) that lives in few open places: of it the share of their own line,
/// `0.118 S_d / (1 - A)`, counts, the more the fewer they are, as `A²`. Along a seam all of the gap is
/// one point wide.
pub fn gap_of_open_places(map: &Map, line: Line, gap: f64) -> f64 {
    let part = if map.repeats { OPEN_GAP } else { OPEN_GAP_AT_SEAM };
    let share = BOUNDARY_CORRECTION * line.edges / (1.0 - line.area).max(f64::MIN_POSITIVE);
    part * gap.max(0.0) * share.min(1.0) * line.area * line.area
}

/// Half width of the mean gap (m) beside jumps between edges that do not match: a pixel is as wide as a jump is on the grid, and
/// the finer it is the steeper they are. Half of their [height](Map::seam), less where much touches.
pub fn gap_of_seam(map: &Map, line: Line) -> f64 {
    SEAM_GAP * (1.0 - 0.5 * line.area) * map.seam
}

/// Half width of the area beside such jumps, where little is open: a quarter of the points along them.
pub fn area_of_seam(map: &Map, line: Line) -> f64 {
    let [ny, nx] = map.accuracy.grid().shape();
    if map.repeats || line.edges <= 0.0 {
        return 0.0;
    }
    SEAM_AREA * (1.0 / ny as f64 + 1.0 / nx as f64) * line.area.powi(4)
}

/// Half width of the mean gap (m) that ways to interpolate leave: at the contact a part of their
/// difference, the smaller the more the load evens them out; at open places what they differ by.
pub fn gap_between(found: &Between) -> f64 {
    let touching = found.height * (found.height / found.deformed) / EVENED_OUT;
    touching.max(TAIL * found.open.abs())
}

/// Half width of the mean gap (m) that peaks leave which stand beside the points, of a surface that touches with its
/// sharpest ones only: a part of their second difference, times the share of the line. Elsewhere that of
/// [`gap_half_width`], which knows the rms height alone, is more.
pub fn gap_of_peaks(bend: &Bend) -> f64 {
    let [smooth, sharp] = PEAK;
    let part = if bend.growth < SMOOTH_GROWTH { sharp } else { smooth };
    part * bend.height * bend.share
}

/// Relative half width of the stiffness at this contact line. Near full contact the gap is that of
/// the few places left open, whose line is of their area and not of the contact.
pub fn stiffness_half_width(map: &Map, line: Line) -> f64 {
    let part = if map.repeats { STIFFNESS } else { STIFFNESS_AT_SEAM };
    let open = (1.0 - line.area).max(OPEN * 1e-9);
    let of_contact = part * line.share() * (OPEN / open).max(1.0);
    let [most, near_full] = OPEN_STIFFNESS;
    let of_open = (most + near_full * line.area.powi(30)) * BOUNDARY_CORRECTION * line.edges / open;
    of_contact.max(of_open) * map.accuracy.widened(line.edges)
}

/// Half width of the area that ways to interpolate leave where the doubt is small and much touches: points in light
/// contact that what lies between the points could take off, and slits beside sharp crests and in creased valleys that the points do
/// not show. At light load the bar of the contact line covers them.
pub fn area_between(found: &Between, area: f64) -> f64 {
    let crests = SHARP * (found.height / found.deformed).powi(2);
    ((LIGHT * found.light).hypot(crests) * area * area).hypot(area_of_slits(found))
}

/// Half width of the area for the slits in creased valleys alone: they stay open on no grid that does not resolve them.
pub fn area_of_slits(found: &Between) -> f64 {
    SLITS * found.slits
}

/// What a solution on twice as many points along each side says of the one on the given grid.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Finer {
    /// Its corrected area fraction.
    pub area: f64,
    /// Its correction for the contact line, 0.118 S_d.
    pub correction: f64,
    /// Its mean gap (m).
    pub gap: Option<f64>,
    /// Its mean pressure (Pa).
    pub pressure: f64,
    /// Half width of the area that its own contact line leaves, as on a map inside the gate.
    pub bar: f64,
    /// The same of the mean gap (m).
    pub gap_bar: f64,
    /// Its stiffness (Pa/m) with the half width that its own contact line leaves, if it was asked for.
    pub stiffness: Option<[f64; 2]>,
    /// Further doublings of the points until what lies between them decides no more, if each halves the
    /// doubt; 0 where it does not on this grid.
    pub doublings: f64,
    /// Area fraction, mean gap (m) and mean pressure (Pa) of a surface through the same points that
    /// does not overshoot them, where what lies between them decides.
    pub monotone: Option<(f64, Option<f64>, f64)>,
}

impl Finer {
    /// From the solution on `grid`, twice as fine as that of `map`.
    pub fn of(solution: &Solution, map: &Map, grid: Grid) -> Self {
        let found = &solution.diagnostics;
        let correction = BOUNDARY_CORRECTION * found.contact_perimeter;
        let own = map.accuracy.on(grid).with_boundary(found.boundary);
        Self {
            area: found.area_fraction_corrected,
            correction,
            gap: solution.state.mean_gap,
            pressure: solution.state.mean_pressure,
            bar: own.line_left_over(found.contact_perimeter),
            gap_bar: {
                let line = Line::of(solution);
                let open =
                    solution.state.mean_gap.map_or(0.0, |gap| gap_of_open_places(map, line, gap));
                gap_half_width(&map.on(grid), line).max(open).max(0.5 * gap_of_seam(map, line))
            },
            stiffness: None,
            doublings: 0.0,
            monotone: None,
        }
    }

    /// The same with what is known of the contact on the given grid: few spots that carry the load, by which gap and
    /// stiffness widen ([`of_few_spots`]), and how sharply the heights bend there.
    ///
    /// What touches of a crease is a point or two wide on every grid until one resolves it, and less on each finer one:
    /// while the line takes more than a tenth of the area here, what is left is not a part of the correction
    /// but about twice of it.
    #[must_use]
    pub fn at_contact(mut self, [gap, stiffness]: [f64; 2], bend: &Bend) -> Self {
        // On the finer grid a fourth of the bend where it is smooth, half on a crease; and half of the share.
        let times = if bend.growth < SMOOTH_GROWTH { 4.0 } else { 8.0 };
        let peaks = gap_of_peaks(bend) / times;
        self.gap_bar = gap * self.gap_bar.max(peaks);
        let is_thin = bend.is_creased() && self.correction > CREASED_SHARE * self.area;
        if is_thin {
            self.bar = self.bar.max(CREASED * self.correction);
            self.gap_bar = self.gap_bar.max(CREASED_GAP * bend.height);
        }
        if let Some([value, half]) = &mut self.stiffness {
            *half *= stiffness;
            if is_thin {
                *half = half.max(CREASED_STIFFNESS * *value * self.correction / self.area);
            }
        }
        self
    }

    /// Half width around the area on the given grid: what refining moved, and what is left on the
    /// finer grid, as much again (and for every doubling until the doubt is gone) or the bar of the finer
    /// grid, whichever is larger; and not less than holds the answer of the monotone surface.
    pub fn area_half_width(&self, given: f64) -> f64 {
        let other = self.monotone.map_or(0.0, |(area, ..)| (area - given).abs() + self.bar);
        let moved = (self.area - given).abs();
        self.with_rest(moved, self.bar).max(other)
    }

    /// What refining moved, and what is still to come.
    fn with_rest(&self, moved: f64, bar: f64) -> f64 {
        moved + ((1.0 + self.doublings) * moved).max(bar)
    }

    /// Half width around the mean gap on the given grid (m), in the same way.
    pub fn gap_half_width(&self, given: f64) -> Option<f64> {
        self.gap.map(|gap| {
            let other = self.monotone.and_then(|(_, gap, _)| gap);
            let other = other.map_or(0.0, |gap| (gap - given).abs() + self.gap_bar);
            let moved = (gap - given).abs();
            self.with_rest(moved, self.gap_bar).max(other)
        })
    }

    /// Half width around the stiffness on the given grid (Pa/m), in the same way.
    pub fn stiffness_half_width(&self, given: f64) -> Option<f64> {
        self.stiffness.map(|[stiffness, bar]| {
            let moved = (stiffness - given).abs();
            self.with_rest(moved, bar)
        })
    }

    /// Half width around the mean pressure that belongs to a given gap (Pa): twice what refining
    /// moved.
    pub fn pressure_half_width(&self, given: f64) -> f64 {
        let other = self.monotone.map_or(0.0, |(_, _, pressure)| (pressure - given).abs());
        (2.0 * (self.pressure - given).abs()).max(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_refined_bar_covers_both_areas_and_what_is_left() {
        let finer = Finer {
            area: 0.023,
            correction: 0.01,
            gap: Some(2.5e-7),
            pressure: 3e6,
            bar: 0.003,
            gap_bar: 1e-9,
            stiffness: Some([1e13, 1e11]),
            doublings: 0.0,
            monotone: None,
        };
        assert!((finer.area_half_width(0.020) - (0.003 + 0.003)).abs() < 1e-15);
        assert!((finer.area_half_width(0.0225) - (0.0005 + 0.003)).abs() < 1e-15);
        assert!((finer.gap_half_width(2e-7).unwrap() - 1e-7).abs() < 1e-18);
        assert!((finer.gap_half_width(2.5e-7).unwrap() - 1e-9).abs() < 1e-18);
        assert!((finer.stiffness_half_width(1.2e13).unwrap() - 4e12).abs() < 1.0);
        assert!((finer.pressure_half_width(2.9e6) - 2e5).abs() < 1e-6);
        // Two more doublings until the doubt is gone: twice more what refining moved.
        let doubtful = Finer { doublings: 2.0, ..finer };
        assert!((doubtful.area_half_width(0.020) - 4.0 * 0.003).abs() < 1e-15);
        let flat = Finer { monotone: Some((0.04, Some(1e-7), 4e6)), ..finer };
        assert!((flat.area_half_width(0.020) - 0.023).abs() < 1e-15);
        assert!((flat.gap_half_width(2.5e-7).unwrap() - 1.51e-7).abs() < 1e-18);
        assert!((flat.pressure_half_width(2.9e6) - 1.1e6).abs() < 1e-6);
    }
}
