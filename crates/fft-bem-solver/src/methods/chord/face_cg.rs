//! Conjugate gradients on the face of the nodes in contact, preconditioned by the cheap `S`: the
//! last resort of the chord iteration.

use super::run::{Run, project};
use crate::methods::ceiling::Ceiling;
use crate::methods::node::NodeState;
use crate::{Real, fields};

/// One step from the iterate; returns the convolutions spent. The direction and its displacement are kept in
/// the place of the iterate before, once there is one.
pub(super) fn step<T: Real, C: Ceiling<T>>(run: &mut Run<'_, T, C>, level: f64) -> f64 {
    let (h, load, is_first) = (run.heights, run.load, !run.memory.has_before);
    let ceiling = run.ceiling;
    let (work, operator) = (&mut *run.work, &mut *run.operator);
    work.pairs.make_room();
    let n = h.len();
    let (p, u) = (&mut run.iterate.pressure, &mut run.iterate.displacement);
    let gap = |i: usize| (u[i] - h[i]).wide() - level;
    let nodes = &mut work.nodes;
    let residual = work.pairs.trial_and_spare().1;
    fields::write(residual, |i, _| if nodes[i].is_in() { gap(i) as f32 } else { 0.0 });
    work.stiffness.apply(residual, &mut work.residual);
    let z = &mut work.residual;
    centre(nodes, z);
    // A node without load that the step would pull on does not take part, nor one at the ceiling that it
    // would press.
    for i in 0..n {
        if nodes[i].is_in() && p[i] <= T::zero() && z[i] > 0.0 {
            nodes[i] = NodeState::Gap;
        }
        if C::IS_FINITE && nodes[i].is_in() && ceiling.is_reached(p[i]) && z[i] < 0.0 {
            nodes[i] = NodeState::Full;
        }
    }
    let count = centre(nodes, z);

    // Conjugate to the last direction, if that descends; else z; else the plain gradient.
    let pairs = &mut work.pairs;
    let (t, kt) = (&mut pairs.before.pressure, &mut pairs.before.displacement);
    let on = |i: usize, x: f64| if nodes[i].is_in() { x } else { 0.0 };
    let sum_on = |x: &(dyn Fn(usize) -> f64 + Sync)| fields::sum_of(n, |i| on(i, x(i)));
    let descends = |d: &[T]| fields::sum_of(n, |i| d[i].wide() * gap(i)) > 0.0;
    let direction = &mut pairs.trial.pressure;
    let mut is_descent = false;
    if !is_first {
        let beta = fields::sum_of(n, |i| f64::from(z[i]) * kt[i].wide()) / fields::dot(t, kt);
        let mean = sum_on(&|i| t[i].wide()) / count;
        let conjugate = |i: usize| f64::from(z[i]) - beta * on(i, t[i].wide() - mean);
        fields::write(direction, |i, _| T::of(conjugate(i)));
        is_descent = descends(direction);
    }
    if !is_descent {
        fields::write(direction, |i, _| T::of(f64::from(z[i])));
        is_descent = descends(direction);
    }
    if !is_descent {
        let mean = sum_on(&gap) / count;
        fields::write(direction, |i, _| T::of(on(i, gap(i) - mean)));
    }
    // Of mean zero to the last digit: the load must not drift.
    let mean = T::of(fields::sum(direction) / count);
    fields::write(direction, |i, d| if nodes[i].is_in() { d - mean } else { d });
    std::mem::swap(direction, t);
    operator.apply(t, kt);
    let length = T::of(fields::sum_of(n, |i| t[i].wide() * gap(i)) / fields::dot(t, kt));
    fields::write(direction, |i, _| p[i] - length * t[i]);
    std::mem::swap(p, direction);
    if fields::min(p) < 0.0 || ceiling.is_passed(1.0, p) {
        project(ceiling, p, load);
        operator.apply(p, u);
        return 2.0;
    }
    fields::write(u, |i, u| u - length * kt[i]);
    1.0
}

/// Sets z to zero outside the contact and subtracts its mean inside; returns the nodes there.
fn centre(nodes: &[NodeState], z: &mut [f32]) -> f64 {
    let on = |i: usize| nodes[i].is_in();
    let count = fields::sum_of(z.len(), |i| if on(i) { 1.0 } else { 0.0 });
    let mean = fields::sum_of(z.len(), |i| if on(i) { f64::from(z[i]) } else { 0.0 }) / count;
    fields::write(z, |i, z| if on(i) { z - mean as f32 } else { 0.0 });
    count
}
