//! A number and its uncertainty, by source.

/// Why a number has no uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub enum NoUncertainty {
    /// Half the points are too few to be solved.
    #[error(
        "{} × {} points: an uncertainty takes at least {} along each side, since every second point is solved \
         as well",
        shape[0], shape[1], 2 * crate::coarser::FEWEST
    )]
    TooFewPoints {
        /// Points of the map.
        shape: [usize; 2],
    },
    /// On another rung the number does not exist: the load was not solved there, or the contact is full.
    #[error(
        "with every second point, or twice the points, the load was not solved, or the contact is full or empty"
    )]
    Undefined,
    /// The iteration stopped too early.
    #[error(
        "the pressure is known to {residual:.1e} only; an uncertainty needs a tolerance of {limit:.0e}"
    )]
    TooLooselySolved {
        /// Estimated relative rms error of the pressure.
        residual: f64,
        /// What it must not exceed.
        limit: f64,
    },
    /// The iteration did not reach its tolerance.
    #[error(
        "{}",
        if *at_rounding {
            "rounding stopped the solver before its tolerance"
        } else {
            "the solver did not converge"
        }
    )]
    NotConverged {
        /// Whether rounding kept it from there, and not the number of iterations.
        at_rounding: bool,
    },
    /// Nothing touches.
    #[error("nothing touches")]
    NoContact,
}

/// What makes an uncertainty: half widths in the unit of the number.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Parts {
    /// From what halving the points moves.
    pub coarser: f64,
    /// What the contact line leaves: of the area a part of its perimeter correction, of the others what the
    /// uncertainty of the area brings.
    pub contact_line: f64,
    /// Chance of points to fall inside the contact line.
    pub counting: f64,
    /// From what doubling the points moves, where that was solved.
    pub finer: f64,
    /// Left by stopping the iteration.
    pub iteration: f64,
}

impl Parts {
    /// Of each source what `of` makes of this half width and the `other`.
    fn with(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            coarser: of(self.coarser, other.coarser),
            contact_line: of(self.contact_line, other.contact_line),
            counting: of(self.counting, other.counting),
            finer: of(self.finer, other.finer),
            iteration: of(self.iteration, other.iteration),
        }
    }

    /// Half width: the root of the squares, and the iteration on top.
    pub(crate) fn half_width(&self) -> f64 {
        let squares = [self.coarser, self.contact_line, self.counting, self.finer];
        squares.into_iter().fold(0.0, f64::hypot) + self.iteration
    }
}

/// A number with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its uncertainty as the number of this map, or why there is none.
    pub uncertainty: Result<Parts, NoUncertainty>,
    /// Sampling variability: 95 % half width over maps of the same surface, if this map can tell.
    pub sampling: Option<f64>,
    /// Half width from the spread of the materials' numbers.
    pub materials: f64,
    /// Smallest value that it can have, as a number of this map and of these materials.
    pub(crate) least: [f64; 2],
    /// Largest value that it can have.
    pub(crate) most: f64,
}

/// A number that falls as an [`Estimate`] rises: infinite where that may be 0, and 0 where it has no end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inverse {
    /// The number.
    pub value: f64,
    /// `[low, high]` as the number of this map, if it has an uncertainty.
    pub interval: Option<[f64; 2]>,
    /// `[low, high]` as a number of the surface, if the map can tell.
    pub prediction: Option<[f64; 2]>,
}

impl Estimate {
    pub(crate) fn above_zero(value: f64, uncertainty: Result<Parts, NoUncertainty>) -> Self {
        let (sampling, materials, least) = (None, 0.0, [0.0; 2]);
        Self { value, uncertainty, sampling, materials, least, most: f64::INFINITY }
    }

    /// A number that was prescribed.
    pub(crate) fn exact(value: f64) -> Self {
        Self { sampling: Some(0.0), ..Self::above_zero(value, Ok(Parts::default())) }
    }

    /// Half width of the uncertainty as the number of this map.
    ///
    /// # Errors
    /// Why there is none.
    pub fn half_width(&self) -> Result<f64, NoUncertainty> {
        Ok(self.uncertainty?.half_width())
    }

    /// The same as a number of the surface and its materials, of which the map is a sample. Sampling variability and
    /// materials are independent of the rest: squares add. `None` if neither is known.
    fn prediction_half_width(&self) -> Option<f64> {
        let beside = self.sampling.or((self.materials > 0.0).then_some(0.0))?;
        Some(self.half_width().ok()?.hypot(beside).hypot(self.materials))
    }

    /// The same in another unit.
    #[must_use]
    pub fn times(self, factor: f64) -> Self {
        Self {
            value: self.value * factor,
            uncertainty: self.uncertainty.map(|parts| parts.with(parts, |part, _| part * factor)),
            sampling: self.sampling.map(|half| half * factor),
            materials: self.materials * factor,
            least: self.least.map(|least| least * factor),
            most: self.most * factor,
        }
    }

    /// Two numbers of one map added: what is uncertain of both may be so in the same direction.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let both = |a: Option<f64>, b: Option<f64>| Some(a? + b?);
        let low = |ends: Option<[f64; 2]>| ends.map_or(0.0, |[low, _]| low);
        let [own, others] = [self, other].map(|e| [low(e.interval().ok()), low(e.prediction())]);
        Self {
            value: self.value + other.value,
            uncertainty: self
                .uncertainty
                .and_then(|a| Ok(a.with(other.uncertainty?, |a, b| a + b))),
            sampling: both(self.sampling, other.sampling),
            materials: self.materials + other.materials,
            least: [0, 1].map(|i| own[i] + others[i]),
            most: self.most + other.most,
        }
    }

    /// `[low, high]` as the number of this map.
    ///
    /// # Errors
    /// Why there is none.
    pub fn interval(&self) -> Result<[f64; 2], NoUncertainty> {
        Ok(self.around(self.half_width()?, self.least[0]))
    }

    /// `[low, high]` as a number of the surface and its materials.
    pub fn prediction(&self) -> Option<[f64; 2]> {
        Some(self.around(self.prediction_half_width()?, self.least[1]))
    }

    /// The interval that is stated with the number: of the surface where the map can tell, else of this map.
    pub fn stated(&self) -> Option<[f64; 2]> {
        self.prediction().or_else(|| self.interval().ok())
    }

    fn around(&self, half: f64, least: f64) -> [f64; 2] {
        // Rounding may leave a number just below the least, where no end may follow.
        let low = (self.value - half).max(least).min(self.most);
        [low, (self.value + half).min(self.most).max(low)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where one of two may be nothing, the other is still there.
    #[test]
    fn a_sum_is_at_least_its_parts() {
        let of = |value, coarser| {
            let parts = Parts { coarser, ..Parts::default() };
            Estimate { sampling: Some(0.0), ..Estimate::above_zero(value, Ok(parts)) }
        };
        for both in [of(1.0, 3.0).plus(of(10.0, 2.0)), of(10.0, 2.0).plus(of(1.0, 3.0))] {
            assert_eq!(both.interval(), Ok([8.0, 16.0]));
            assert_eq!(both.prediction(), Some([8.0, 16.0]));
        }
    }
}
