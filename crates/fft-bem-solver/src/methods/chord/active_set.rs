//! Step 1: what is wrong with the iterate. The level, the contact set F, the residual gap g on it, `E g`.

use super::memory::Known;
use super::run::Run;
use crate::methods::ceiling::Ceiling;
use crate::methods::contract::State;
use crate::methods::passes::{self, ContactSet, GapSource};
use crate::{Real, fields};
use std::f64::consts::FRAC_PI_2;

/// After a poor step, nodes with less pressure than this times their gap are let go; as much less as
/// pixels are longer than wide, where a line of them may stand off as a whole for a lack of little load.
pub(super) const RELEASE: f64 = 0.1;

/// Below this part of what the softest wave of the grid would make of the residual gap, an estimate is
/// not believed.
const INCREDIBLE: f64 = 0.01;

/// When F is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum When {
    /// As it is: nodes that carry load or overlap.
    Now,
    /// After the step that the last `E g` stands for: nodes that it would make overlap as well.
    Ahead,
}

impl<T: Real, C: Ceiling<T>> Run<'_, T, C> {
    /// The level of the iterate, from which the residual gap g is counted; its contact set F; and `E g`.
    ///
    /// The level is the plain mean of `u - h` in contact, so that g has no mean there, which no
    /// pressure could remove. (The [contract](crate::methods::contract) wants that of the answer
    /// weighted with the pressure. Both are the same once g is zero.)
    pub(crate) fn look(&mut self, known: Known, release: f64) -> (f64, ContactSet) {
        let (level, excess) = match known {
            Known::Level(level) if !C::IS_FINITE => (level, None),
            Known::Gap { level, counted_from: c } if !C::IS_FINITE => (level, Some(level - c)),
            _ => (self.level_of_iterate(), None),
        };
        (level, self.contact_set(level, excess, release, When::Now))
    }

    /// The level of the iterate.
    pub(super) fn level_of_iterate(&mut self) -> f64 {
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        if C::IS_FINITE {
            let fields = [&p[..], &u[..], self.heights];
            return passes::level_under(self.ceiling, fields, &mut self.work.partial);
        }
        if let (true, Some(level)) = (self.memory.is_first, self.first_level) {
            return level;
        }
        passes::level(p, u, self.heights, &mut self.work.partial)
    }

    /// Looks again, a step ahead: `E g` is what the step will take from the gap, in contact and
    /// beside it. A node with a smaller gap would overlap after the step and belongs to F now. Call
    /// it after [`look`](Self::look) with the level found there.
    pub(super) fn look_ahead(&mut self, level: f64, release: f64) -> ContactSet {
        self.contact_set(level, None, release, When::Ahead)
    }

    /// F, the residual on it and `E g`. With `excess`, the residual field holds the gap but for that.
    fn contact_set(
        &mut self,
        level: f64,
        excess: Option<f64>,
        release: f64,
        when: When,
    ) -> ContactSet {
        let work = &mut *self.work;
        let size = [work.rows, work.columns];
        let State { pressure: p, displacement: u, .. } = &*self.iterate;
        let extended = work.pairs.spare();
        let gap = match excess {
            Some(excess) => GapSource::Known { excess },
            None => GapSource::Of { u, h: self.heights, level },
        };
        let found = passes::residual(
            self.ceiling,
            p,
            gap,
            release,
            (when == When::Ahead).then_some(&*extended),
            size,
            &mut work.nodes,
            &mut work.residual,
            &mut work.pyramid,
            &mut work.partial,
        );
        work.pyramid.extend_above();
        let (pyramid, stiffness) = (&work.pyramid, &mut work.stiffness);
        passes::push(&work.nodes, &work.residual, pyramid, size[1], stiffness, extended);
        found
    }

    /// Where the level is prescribed: scales everything to a load that should bring it there. `level`
    /// is where it is now, and `E g` says where it will settle.
    pub(super) fn towards_level(&mut self, level: f64) {
        let Some(control) = &mut self.control else { return };
        let pairs = &mut self.work.pairs;
        let State { pressure, displacement, .. } = &*self.iterate;
        control.guess([pressure, displacement], self.memory.residual);
        let rise = fields::mean(pairs.spare());
        let factor = control.factor(level + rise, self.load, self.memory.residual);
        pairs.scale(factor, self.iterate);
        self.load *= factor;
        self.memory.dkd *= factor * factor;
    }

    /// The estimate, unless even the softest wave of the grid would resist the residual gap more: then
    /// the preconditioner is at fault, and the stiffest wave bounds the error instead.
    pub(super) fn credible(&mut self, estimate: &passes::StepEstimate, level: f64) -> f64 {
        let work = &mut *self.work;
        let fields = [&self.iterate.displacement[..], self.heights];
        let gap2 = passes::residual_norm2(fields, level, &work.nodes, &mut work.partial);
        let stiffest = FRAC_PI_2 * (gap2 / estimate.p2).sqrt(); // |q|/2 at pi per finer pixel
        let softest = 2.0 / work.longest * stiffest;
        if estimate.residual < INCREDIBLE * softest { stiffest } else { estimate.residual }
    }

    /// Whether the residual gap of the iterate is no more than the rounding of what it is made of.
    pub(super) fn is_rounding(&mut self, level: f64) -> bool {
        let fields = [&self.iterate.displacement[..], self.heights];
        let work = &mut *self.work;
        self.memory.residual < T::EPSILON.sqrt()
            && passes::is_rounding(fields, level, &work.nodes, &mut work.partial)
    }
}
