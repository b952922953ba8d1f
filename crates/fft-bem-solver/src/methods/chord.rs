//! Extension-preconditioned chord iteration: about one FFT pair per step and one digit per step.
//!
//! Each step asks for the pressure that would close the residual gap `g` on the contact set F,
//! `z = E^T S E g`; subtracts it; sweeps the tension that results onto the nodes that stay
//! ([`Sweep`]); computes the displacement of that trial with one FFT pair; and goes along the
//! chord from the present pressure to the trial as far as the energy falls. A chord of a convex
//! set stays in the set: pressures stay positive and carry the load without projection. The size
//! of z estimates the error of the pressure.
//!
//! ```text
//! loop
//!   g = u - h - mean of it in contact;  F = {p > release g+} or {g < 0}
//!   z = E^T S E g on F, less its mean;  |z on F, p off F| <= tolerance |p|: stop
//!   trial = p - tau z on F, swept, clipped, scaled to the load;  K trial     (the one pair)
//!   theta = -<g,s>/<s,Ks> along the chord s = trial - p
//!   p += theta s, or all of s near theta = 1; better, the minimum over s and the step before
//! ```
//!
//! Two fallbacks guarantee convergence: projected gradients where a chord does not descend or the
//! estimate stalls, and conjugate gradients on the face where that does not help.

use super::coarse_lead::CoarseLead;
use super::extension::Pyramid;
use super::extrapolation::Earlier;
use super::passes::{self, Estimate, Partial, Products};
use super::stiffness::Stiffness;
use super::sweep::{self, Sweep};
use super::{
    Compliance, ContactMethod, End, Outcome, Start, State, Step, Target, Task, Watch, face_cg,
    level_control::LevelControl,
};
use crate::problem::Problem;
use crate::{Boundary, HalfSpace, Real, certificate, fields, projection};
use contact_types::Grid;
use std::f64::consts::FRAC_PI_2;

/// Below this chord length the step was a poor guess: take it as it is, and release nodes.
const FULL: f64 = 0.7;
/// After a poor step, nodes with less pressure than this times their gap are let go.
const RELEASE: f64 = 0.1;
/// Range of the length of the preconditioned step.
const TAU: [f64; 2] = [0.3, 1.1];
/// Iterations without halving the estimate before another kind of step is tried.
const STALL: usize = 8;

/// How the trial of a step is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Chord,
    Gradient,
    FaceCg,
}

/// The method with its memory: the trial and the iterate before (pressure and displacement each),
/// one field in single precision, the contact set, the pyramid and the coarse grids.
pub(crate) struct Chord<T: Real> {
    grid: Grid,
    pub(crate) shape: [usize; 2],
    pub(crate) rows: usize,
    /// Longer side of the map.
    longest: f64,
    pub(crate) mask: Vec<u8>,
    pub(crate) residual: Vec<f32>,
    pub(crate) pyramid: Pyramid,
    pub(crate) stiffness: Stiffness,
    pub(crate) sweep: Sweep,
    pub(crate) trial: Vec<T>,
    pub(crate) response: Vec<T>,
    pub(crate) before: Vec<T>,
    pub(crate) before_response: Vec<T>,
    pub(crate) partial: Vec<Partial>,
    /// On a load curve.
    earlier: Option<Box<Earlier<T>>>,
    /// Tests: make every step of this kind.
    pub(crate) force: Option<Kind>,
    /// Which fallbacks were taken, and at which iteration.
    pub(crate) events: Vec<(usize, Kind)>,
}

/// What a step needs to know of the ones before.
struct Memory {
    /// Length of the next preconditioned step and of the next gradient step.
    tau: f64,
    alpha: f64,
    /// Chord length of the last step.
    a: f64,
    /// Whether `before` holds the iterate before this one, and `<d, K d>` of the step from it.
    has_before: bool,
    dkd: f64,
    /// Sum over the contact of `u - h` and the number of its nodes, if known.
    sums: Option<[f64; 2]>,
    /// Smallest estimate that was a halving, and the iterations since.
    best: f64,
    since: usize,
    kind: Kind,
}

impl<T: Real> Chord<T> {
    /// Memory for a grid whose finer pixel side is 1.
    pub(crate) fn new(scaled: Grid) -> Self {
        let ([_, nx], n) = (scaled.shape(), scaled.len());
        let pyramid = Pyramid::new(scaled.shape(), scaled.pixel());
        let rows = passes::rows_per_task(&pyramid, scaled.shape());
        let pieces = passes::tasks(n, rows, nx).max(HalfSpace::<T>::pieces(scaled.shape()));
        Self {
            grid: scaled,
            shape: scaled.shape(),
            rows,
            longest: (0..2)
                .map(|a| scaled.shape()[a] as f64 * scaled.pixel()[a])
                .fold(1.0, f64::max),
            mask: vec![0; n],
            residual: vec![0.0; n],
            stiffness: Stiffness::new(scaled.shape(), scaled.pixel()),
            sweep: Sweep::new(pyramid.levels.first()),
            pyramid,
            trial: vec![T::zero(); n],
            response: vec![T::zero(); n],
            before: vec![T::zero(); n],
            before_response: vec![T::zero(); n],
            partial: vec![Partial::default(); pieces],
            earlier: None,
            force: None,
            events: Vec::new(),
        }
    }

    fn iterate(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome {
        let h = &task.problem.heights[..];
        let (mut load, mut control) = match task.target {
            Target::Pressure(p) => (p, None),
            Target::Level(level, guess) => {
                let mean_height = task.problem.mean_height;
                (guess, Some(LevelControl::new(level, mean_height, operator.boundary())))
            }
        };
        self.events.clear();
        let mut is_lead = false; // the trial fields hold a guess that is not feasible
        let mut transforms = 0.0;
        if start == Start::Warm {
            let guess = [&mut self.trial[..], &mut self.response[..]];
            if let (Some(earlier), Target::Pressure(load)) = (&mut self.earlier, task.target) {
                is_lead = earlier.guess(load, state, guess);
            }
            load = rescale(control.as_ref().map_or(Some(load), |_| None), state);
        } else {
            if let Some(earlier) = &mut self.earlier {
                earlier.forget();
            }
            // Its memory is needed for the first trial alone.
            if let Some(mut lead) = CoarseLead::new(self.grid) {
                let guess = (&mut self.trial[..], &mut self.response[..]);
                let found = lead.find(task, load, guess);
                transforms += found.transforms;
                is_lead = found.load.is_some();
                load = found.load.unwrap_or(load);
            }
            transforms += begin_constant(load, operator, state);
        }
        let is_guess = start == Start::Cold && !is_lead;
        let mut now = Memory {
            tau: 1.0,
            alpha: 1.5,
            a: if is_guess { 1.0 } else { 0.0 },
            has_before: false,
            dkd: 0.0,
            sums: None,
            best: f64::INFINITY,
            since: 0,
            kind: self.force.unwrap_or(Kind::Chord),
        };
        let (mut iteration, mut residual) = (0, f64::INFINITY);
        let end = loop {
            // Residual gap and contact set; with the level prescribed, once more at a better load.
            let release = if now.a < FULL { RELEASE } else { 0.0 };
            let sums = now.sums.take().filter(|_| !is_lead);
            let (mut level, mut found) = self.look(h, sums, release, is_lead, state);
            if let Some(control) = &mut control {
                let factor = self.towards_level(control, level, load, residual, is_lead, state);
                load *= factor;
                now.dkd *= factor * factor;
                (level, found) = self.look(h, None, RELEASE, is_lead, state);
            }

            // Preconditioned residual, and the trial it leads to.
            self.precondition(is_lead);
            transforms += self.stiffness.cost;
            let base = (!is_lead).then_some(&state.pressure[..]);
            let estimate = self.make_trial(base, now.tau, &found);
            residual = estimate.residual;
            if !is_lead && residual <= task.tolerance {
                let fields = [&state.displacement[..], h];
                residual = self.credible(&estimate, fields, level);
            }
            let error = control.as_ref().map_or(0.0, |c| c.error.abs());
            let step = Step { iteration, transforms, residual: residual.max(error), state };
            if watch(&step).is_break() {
                break End::Stopped;
            }
            if !is_lead {
                let is_rounding = residual < T::EPSILON.sqrt() && {
                    let fields = [&state.displacement[..], h];
                    passes::is_rounding(fields, level, &self.mask, &mut self.partial)
                };
                // A single pixel leaves no residual at any level: the level must be right as well.
                if error <= task.tolerance && (residual <= task.tolerance || is_rounding) {
                    break End::Converged;
                }
                if iteration >= task.max_iterations {
                    break End::Exhausted;
                }
            }

            // Another kind of step if the estimate has not been halved for long.
            now.watch_progress(residual, iteration, self.force.is_some(), &mut self.events);
            if now.kind == Kind::FaceCg && !is_lead {
                let first = !now.has_before;
                transforms += face_cg::step(self, operator, h, level, load, first, state);
                now.has_before = true;
                iteration += 1;
                continue;
            }

            // Trial, its displacement, and how far to go along the chord.
            let base_level = if is_lead {
                let (p, u) = (&state.pressure, &state.displacement);
                let [sum, contact] = passes::level_sums(p, u, h, &mut self.partial);
                sum / contact
            } else {
                level
            };
            let mut kind = now.kind;
            let (products, scale) = loop {
                let scale = match kind {
                    Kind::Chord => self.sweep_trial(&found, load),
                    Kind::Gradient | Kind::FaceCg => {
                        self.gradient_trial(h, base_level, now.alpha, load, state);
                        Some(1.0)
                    }
                };
                if let Some(scale) = scale {
                    let products = self.respond(operator, scale, h, base_level, &now, state);
                    transforms += 1.0;
                    if products.theta() > 0.0 || kind != Kind::Chord {
                        break (products, scale);
                    }
                }
                kind = Kind::Gradient; // the chord does not descend: projected gradients always do
                self.events.push((iteration, kind));
            };
            is_lead = false;
            self.advance(kind, &products, scale, &mut now, h, state);
            iteration += 1;
        };
        state.level = certificate::level(state, h);
        let error = control.map_or(0.0, |c| c.error.abs());
        Outcome { end, iterations: iteration, transforms, residual: residual.max(error) }
    }

    /// The residual gap g of the state, or of the lead, its contact set F, and `E g`. Returns the
    /// level, the mean of `u - h` in contact; `sums` if it is known already.
    pub(crate) fn look(
        &mut self,
        h: &[T],
        sums: Option<[f64; 2]>,
        release: f64,
        is_lead: bool,
        state: &State<T>,
    ) -> (f64, passes::Residual) {
        let size = [self.rows, self.shape[1]];
        let (p, u) = if is_lead {
            (&self.trial[..], &self.response[..])
        } else {
            (&state.pressure[..], &state.displacement[..])
        };
        let [sum, contact] = sums.unwrap_or_else(|| passes::level_sums(p, u, h, &mut self.partial));
        let level = sum / contact.max(1.0);
        let found = passes::residual(
            [p, u, h],
            level,
            release,
            size,
            &mut self.mask,
            &mut self.residual,
            &mut self.pyramid,
            &mut self.partial,
        );
        self.pyramid.extend_above();
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        passes::push(&self.mask, &self.residual, &self.pyramid, size, extended);
        (level, found)
    }

    /// Scales everything to a load that should bring the level to its target; returns the factor.
    /// `level` is where it is now, and `E g` says where it will settle.
    fn towards_level(
        &mut self,
        control: &mut LevelControl,
        level: f64,
        load: f64,
        residual: f64,
        is_lead: bool,
        state: &mut State<T>,
    ) -> f64 {
        let (p, u) = (&mut state.pressure, &mut state.displacement);
        if control.wants_guess(residual) {
            if is_lead {
                control.guess(&self.trial, &self.response);
            } else {
                control.guess(p, u);
            }
        }
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        let rise = fields::sum(extended) / extended.len() as f64;
        let factor = control.factor(level + rise, load, residual);
        passes::scale(factor, p);
        passes::scale(factor, u);
        if is_lead {
            passes::scale(factor, &mut self.trial);
            passes::scale(factor, &mut self.response);
        } else {
            // The step before must stay one that changes no load.
            passes::scale(factor, &mut self.before);
            passes::scale(factor, &mut self.before_response);
        }
        factor
    }

    /// `y = S E r`, in place of the residual, and all of `z = E^T y` but the last step down to the
    /// finest grid, which [`make_trial`](Self::make_trial) does.
    pub(crate) fn precondition(&mut self, is_lead: bool) {
        let extended = room(&mut self.response, &mut self.before_response, is_lead);
        self.stiffness.apply(extended, &mut self.residual);
        passes::gather(&self.mask, &self.residual, &mut self.pyramid);
        self.pyramid.restrict_above();
    }

    /// `trial = p - tau z` on F, `p` elsewhere; without `p`, the trial field holds it.
    pub(crate) fn make_trial(
        &mut self,
        p: Option<&[T]>,
        tau: f64,
        found: &passes::Residual,
    ) -> Estimate {
        passes::trial(
            p,
            &self.residual,
            tau,
            &self.mask,
            found.active,
            [self.rows, self.shape[1]],
            &self.pyramid,
            &mut self.trial,
            &mut self.sweep,
            &mut self.partial,
        )
    }

    /// The estimate, unless even the softest wave of the grid would resist the residual gap more: then
    /// the preconditioner is at fault, and the stiffest wave bounds the error instead.
    fn credible(&mut self, estimate: &Estimate, fields: [&[T]; 2], level: f64) -> f64 {
        let gap2 = passes::residual_norm2(fields, level, &self.mask, &mut self.partial);
        let stiffest = FRAC_PI_2 * (gap2 / estimate.p2).sqrt(); // |q|/2 at pi per finer pixel
        let softest = 2.0 / self.longest * stiffest;
        if estimate.residual < 0.01 * softest { stiffest } else { estimate.residual }
    }

    /// Sweeps and clips the trial. Returns the factor that gives it the load: the trial is that many
    /// times the field. `None` if nothing is left of it.
    pub(crate) fn sweep_trial(&mut self, found: &passes::Residual, load: f64) -> Option<f64> {
        let total = load * self.trial.len() as f64;
        self.sweep.run(
            &mut self.pyramid,
            &self.trial,
            &mut self.mask,
            found.active,
            found.has_released,
            total,
        );
        let sum = passes::finish_trial(
            &self.mask,
            &self.sweep,
            &self.pyramid,
            [self.rows, self.shape[1]],
            &mut self.trial,
            &mut self.partial,
        );
        if sum <= 0.0 || !sum.is_finite() {
            return None;
        }
        if sum > (1.0 + 2.0 * sweep::NEGLIGIBLE) * total {
            // Much was clipped: the contact is far from settled, and small loads do not belong.
            projection::onto_admissible(&mut self.trial, load);
            return Some(1.0);
        }
        Some(total / sum)
    }

    /// `trial = p - alpha g`, projected on the pressures that are positive and carry the load.
    fn gradient_trial(&mut self, h: &[T], level: f64, alpha: f64, load: f64, state: &State<T>) {
        let (p, u) = (&state.pressure, &state.displacement);
        for (i, t) in self.trial.iter_mut().enumerate() {
            *t = p[i] - T::of(alpha) * (u[i] - h[i] - T::of(level));
        }
        projection::onto_admissible(&mut self.trial, load);
    }

    /// `K trial`, the one pair, and the inner products along the chord to `scale` times the trial.
    fn respond(
        &mut self,
        operator: &mut dyn Compliance<T>,
        scale: f64,
        h: &[T],
        level: f64,
        now: &Memory,
        state: &State<T>,
    ) -> Products {
        let (p, u, q) = (&state.pressure[..], &state.displacement[..], &self.trial[..]);
        let before = if now.has_before { &self.before[..] } else { p }; // without one, d = 0
        let sums = |from: usize, v: &[T]| {
            let piece = from..from + v.len();
            let [p, u, h, q, b] = [p, u, h, q, before].map(|x| &x[piece.clone()]);
            passes::inner_products([p, u, h], level, [q, v], scale, b)
        };
        let sums = operator.apply_and_sum(q, &mut self.response, &sums, &mut self.partial);
        Products::new(sums, if now.has_before { now.dkd } else { 0.0 })
    }

    /// Goes along the chord, or to the minimum over the chord and the step before.
    fn advance(
        &mut self,
        kind: Kind,
        k: &Products,
        scale: f64,
        now: &mut Memory,
        h: &[T],
        state: &mut State<T>,
    ) {
        let theta = k.theta();
        if kind == Kind::Chord {
            now.a = if theta < FULL { theta } else { 1.0 };
            if theta > 1.0 && !k.has_dropped {
                now.a = theta.min(passes::reach(&state.pressure, &self.trial, scale).max(1.0));
            }
            now.tau = (now.tau * theta.clamp(0.7, 1.4)).clamp(TAU[0], TAU[1]);
        } else {
            now.a = theta.clamp(0.0, 1.0);
            if k.sks > 0.0 {
                now.alpha = k.ss / k.sks; // Barzilai & Borwein (1988), doi:10.1093/imanum/8.1.141
            }
        }
        // A node that the trial drops would keep a part of its load: then only the chord will do.
        let is_searchable = now.has_before && kind == Kind::Chord && !k.has_dropped;
        let plane = k.plane_minimum().filter(|_| is_searchable);
        let step = plane.and_then(|b| Some((b, self.combine(scale, b, true, h, state)?)));
        let (b, sums) = if let Some((b, sums)) = step {
            now.a = 1.0;
            (b, Some(sums))
        } else if (now.a - 1.0).abs() < f64::EPSILON {
            let fields = [&mut self.trial[..], &mut self.response[..]];
            let sums = passes::settle(fields, scale, h, &mut self.partial);
            std::mem::swap(&mut self.before, &mut self.trial);
            std::mem::swap(&mut self.before_response, &mut self.response);
            ([1.0, 0.0], Some(sums))
        } else {
            let b = [now.a, 0.0];
            (b, self.combine(scale, b, false, h, state))
        };
        // `before` holds the new iterate: exchange it with the old one.
        std::mem::swap(&mut state.pressure, &mut self.before);
        std::mem::swap(&mut state.displacement, &mut self.before_response);
        now.has_before = true;
        now.dkd = k.curvature(b);
        now.sums = sums;
    }

    /// `before = p + b1 s + b2 d`, see [`passes::combine`].
    fn combine(
        &mut self,
        scale: f64,
        b: [f64; 2],
        must_fit: bool,
        h: &[T],
        state: &State<T>,
    ) -> Option<[f64; 2]> {
        passes::combine(
            [&state.pressure, &state.displacement],
            [&self.trial, &self.response],
            scale,
            b,
            must_fit,
            h,
            [&mut self.before, &mut self.before_response],
            &mut self.partial,
        )
    }
}

impl Memory {
    /// The ladder of fallbacks: chords, then gradients, then conjugate gradients on the face; back
    /// to chords when the estimate has been halved.
    fn watch_progress(
        &mut self,
        residual: f64,
        iteration: usize,
        is_forced: bool,
        events: &mut Vec<(usize, Kind)>,
    ) {
        if residual <= 0.5 * self.best {
            self.best = residual;
            self.since = 0;
        } else {
            self.since += 1;
        }
        if is_forced {
            return;
        }
        let kind = match self.since {
            0 => Kind::Chord,
            n if n < STALL => return,
            _ => {
                self.since = 0;
                self.has_before &= self.kind == Kind::Chord; // conjugate directions start anew
                if self.kind == Kind::Chord { Kind::Gradient } else { Kind::FaceCg }
            }
        };
        if kind != self.kind {
            // Conjugate gradients keep their direction in the place of the step before.
            self.has_before = self.has_before && kind == Kind::Gradient;
            if kind != Kind::Chord {
                events.push((iteration, kind));
            }
        }
        self.kind = kind;
        if kind == Kind::FaceCg {
            self.a = 1.0; // a node that is let go would keep its pressure: this step only moves F
        }
    }
}

/// Room for a field in single precision until the displacement of the trial is computed: its place,
/// or, if that holds the lead, the place of the step before the first.
pub(crate) fn room<'a, T: Real>(
    response: &'a mut [T],
    before_response: &'a mut [T],
    is_lead: bool,
) -> &'a mut [f32] {
    let free = if is_lead { before_response } else { response };
    let n = free.len();
    &mut T::as_single(free)[..n]
}

/// The constant pressure; its displacement is zero on a periodic half space. Returns the pairs.
fn begin_constant<T: Real>(
    load: f64,
    operator: &mut dyn Compliance<T>,
    state: &mut State<T>,
) -> f64 {
    passes::fill(load, &mut state.pressure);
    if operator.boundary() == Boundary::Periodic {
        passes::fill(0.0, &mut state.displacement);
        return 0.0;
    }
    operator.apply(&state.pressure, &mut state.displacement);
    1.0
}

/// Scales a solution to another load: K is linear. Without a load, leaves it. Returns the load.
fn rescale<T: Real>(load: Option<f64>, state: &mut State<T>) -> f64 {
    let present = fields::sum(&state.pressure) / state.pressure.len() as f64;
    if let Some(load) = load {
        passes::scale(load / present, &mut state.pressure);
        passes::scale(load / present, &mut state.displacement);
    }
    load.unwrap_or(present)
}

impl<T: Real> ContactMethod<T> for Chord<T> {
    fn solve(
        &mut self,
        task: &Task<'_, T>,
        operator: &mut dyn Compliance<T>,
        start: Start,
        state: &mut State<T>,
        watch: &mut Watch<'_, T>,
    ) -> Outcome {
        self.iterate(task, operator, start, state, watch)
    }

    fn extrapolate(&mut self, is_on: bool) {
        let n = self.trial.len();
        self.earlier = is_on.then(|| Box::new(Earlier::new(n)));
    }

    fn controls_level(&self) -> bool {
        true
    }

    /// Asks the cheap `S`: `p = P + S (h - mean h)` would be nearly positive.
    fn suspects_full_contact(&mut self, problem: &Problem<T>, mean_pressure: f64) -> (bool, f64) {
        let heights = room(&mut self.response, &mut self.before_response, false);
        passes::narrow(&problem.heights, problem.mean_height, heights);
        self.stiffness.apply(heights, &mut self.residual);
        let least = fields::min(&self.residual);
        (mean_pressure + least >= -0.1 * mean_pressure, self.stiffness.cost)
    }
}
