//! The uncertainty of one solution: what halving the points moves, what its contact line leaves, and, where the
//! answer depends on what lies between the points, what doubling them moves.
//!
//! ```math
//! U_A^2 = (F D_A)^2 + (a\, c\, S_d)^2 + 4 \cdot 0.0845\, S_d\, n / N + (F \Delta_A)^2
//! ```
//! ```math
//! (U_K/K)^2 = (F D_K/K)^2 + \left(\frac{k\, U_A}{\min(A, 1-A)}\right)^2 + (F \Delta_K/K)^2, \qquad
//! U_G^2 = (F D_G)^2 + \left(\frac{g\, G\, U_A}{1-A}\right)^2 + (F \Delta_G)^2
//! ```
//!
//! `D` is the rms of what each of the two [thinned](crate::thinned) maps moves, `Δ` what the map with twice the
//! points moves, `c S_d` the perimeter correction, `0.0845 S_d N` the variance of the number of points inside
//! contact lines at random places; `n` copies of one cell count as one. To each is added what stopping the iteration leaves.
//!
//! A method of first order leaves as much again as the last halving moved: `F` is that with a margin, as in
//! the grid convergence index (Roache 1994, doi:10.1115/1.2910291). The four constants were fixed on the
//! training half of the families of `examples/coverage` and judged on the other half.

use crate::coarser::Numbers;
use crate::estimate::{Estimate, NoUncertainty, Parts};
use crate::sampling::Map;
use crate::setup::LOOSEST;
use fft_bem_solver::{Diagnostics, PERIMETER_CORRECTION, Solution};

/// F: uncertainty over what halving the points moves.
const MOVED: f64 = 2.0;
/// a: part of the perimeter correction that stays uncertain.
const LINE: f64 = 0.1;
/// k: relative uncertainty of the stiffness over that of the area or of the open area.
const STIFFNESS: f64 = 0.5;
/// g: relative uncertainty of the gap over that of the open area.
const GAP: f64 = 0.1;
/// Variance of the number of points inside lines at random places, per edge: circles of any radius, from the
/// points of a square lattice inside them.
const INSIDE: f64 = 0.0845;
/// Relative error of the area, and error of the gap over the rms height, per relative rms error of the pressure.
const ITERATION: [f64; 2] = [9.0, 0.6];

/// Relative error of the area at this relative rms error of the pressure.
pub(crate) fn iteration_of_area(residual: f64) -> f64 {
    ITERATION[0] * residual.max(0.0)
}

/// What the rungs beside a solution say.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beside<'a> {
    /// Of the thinned maps, or why there is none.
    pub coarser: Result<&'a [Numbers], NoUncertainty>,
    /// Of the map with twice the points, if that was solved.
    pub finer: Option<&'a Numbers>,
}

/// Uncertainties of the numbers of one solution.
pub(crate) struct Uncertain<'a> {
    beside: Beside<'a>,
    line: f64,
    counting: f64,
    iteration: Result<[f64; 2], NoUncertainty>,
}

impl<'a> Uncertain<'a> {
    pub(crate) fn of(solution: &Solution, map: &Map, beside: Beside<'a>) -> Self {
        let found = &solution.diagnostics;
        let edges = found.contact_perimeter;
        Self {
            beside,
            line: LINE * PERIMETER_CORRECTION * edges,
            counting: 2.0
                * (INSIDE * edges * map.copies as f64 / solution.grid.len() as f64).sqrt(),
            iteration: iteration(found, map.rms_height),
        }
    }

    /// Of the area `value`, held between `least` and 1.
    pub(crate) fn area(&self, value: f64, least: f64) -> Estimate {
        let uncertainty = self.iteration.and_then(|[iteration, _]| {
            let moved = self.moved(value, |n| Some(n.area))?;
            let (contact_line, counting) = (self.line, self.counting);
            Ok(Parts { contact_line, counting, iteration: iteration * value, ..moved })
        });
        Estimate { least: [least; 2], most: 1.0, ..Estimate::above_zero(value, uncertainty) }
    }

    /// What the other rungs move of `value`, times F.
    fn moved(
        &self,
        value: f64,
        of: impl Fn(&Numbers) -> Option<f64>,
    ) -> Result<Parts, NoUncertainty> {
        let Beside { coarser, finer } = self.beside;
        let coarser = coarser?;
        let others: Option<Vec<f64>> = coarser.iter().map(&of).collect();
        let others = others.ok_or(NoUncertainty::Undefined)?;
        let squares = others.iter().map(|other| (other - value).powi(2)).sum::<f64>();
        let moved = (squares / others.len().max(1) as f64).sqrt();
        let finer = finer.map(|n| of(n).ok_or(NoUncertainty::Undefined)).transpose()?;
        let finer = finer.map_or(0.0, |other| MOVED * (other - value).abs());
        Ok(Parts { coarser: MOVED * moved, finer, ..Parts::default() })
    }

    /// Of another number, with that of the area: the contact line brings `line` times the uncertainty of the area over `part`,
    /// relative and at most `most`; stopping the `iteration` brings what is said of its errors of area and gap.
    fn other(
        &self,
        value: f64,
        (area, [line, part, most]): (&Estimate, [f64; 3]),
        number: impl Fn(&Numbers) -> Option<f64>,
        iteration: impl Fn([f64; 2]) -> f64,
    ) -> Estimate {
        let uncertainty = self.iteration.and_then(|left| {
            let moved = self.moved(value, number)?;
            let relative = line * area.half_width()? / part.max(f64::MIN_POSITIVE);
            let contact_line = relative.min(most) * value;
            Ok(Parts { contact_line, iteration: iteration(left), ..moved })
        });
        Estimate::above_zero(value, uncertainty)
    }

    /// Of the mean gap, with that of the area.
    pub(crate) fn gap(&self, value: f64, area: &Estimate) -> Estimate {
        let line = (area, [GAP, 1.0 - area.value, 1.0]);
        let found = self.other(value, line, |n| n.mean_gap, |[_, gap]| gap);
        Estimate { value: value.max(0.0), ..found } // rounding may leave it just below
    }

    /// Of the gas in the gap, with that of the gap: where the gap is wide beside the temperature jumps it is as its inverse.
    /// What the contact line `cut` conducts too.
    pub(crate) fn gas(
        &self,
        value: f64,
        gap: Option<&Estimate>,
        (area, cut): (&Estimate, f64),
    ) -> Estimate {
        let of_gap = gap.filter(|gap| gap.value > 0.0);
        let of_gap = of_gap.and_then(|gap| Some(gap.uncertainty.ok()?.iteration / gap.value));
        let line = (area, [GAP, 1.0 - area.value, 1.0]);
        let mut found = self.other(value, line, |n| n.gas, |_| of_gap.unwrap_or(0.0) * value);
        if let Ok(parts) = &mut found.uncertainty {
            parts.contact_line = parts.contact_line.hypot(cut);
        }
        found
    }

    /// Of the stiffness of the contact set, known to `residual` (-), with that of the area.
    pub(crate) fn stiffness(&self, value: f64, residual: f64, area: &Estimate) -> Estimate {
        let line = (area, [STIFFNESS, area.value.min(1.0 - area.value), f64::INFINITY]);
        // The set is that of an iterate: the stiffness moves no more than its area does.
        self.other(value, line, |n| n.stiffness, |[of_area, _]| (of_area + residual) * value)
    }

    /// Of the mean pressure at a given gap, which follows the area.
    pub(crate) fn pressure(&self, value: f64, area: &Estimate) -> Estimate {
        let line = (area, [GAP, area.value.min(1.0 - area.value), 1.0]);
        self.other(value, line, |n| Some(n.mean_pressure), |[of_area, _]| of_area * value)
    }
}

/// Of the area, relative, and of the gap (m).
fn iteration(found: &Diagnostics, rms_height: f64) -> Result<[f64; 2], NoUncertainty> {
    let residual = found.residuals.preconditioned.max(0.0);
    if residual > LOOSEST {
        return Err(NoUncertainty::TooLooselySolved { residual, limit: LOOSEST });
    }
    let [area, gap] = ITERATION;
    let is_exact = found.exact.is_some();
    Ok(if is_exact { [0.0; 2] } else { [area * residual, gap * residual * rms_height] })
}
