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
    for i in 0..n {
        residual[i] = if nodes[i].is_in() { gap(i) as f32 } else { 0.0 };
    }
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
    centre(nodes, z);

    // Conjugate to the last direction, if that descends; else z; else the plain gradient.
    let pairs = &mut work.pairs;
    let (t, kt) = (&mut pairs.before.pressure, &mut pairs.before.displacement);
    let on = |i: usize| nodes[i].is_in();
    let mut direction = &mut pairs.trial.pressure;
    let mut is_descent = false;
    if !is_first {
        let beta = fields::sum_of(n, |i| f64::from(z[i]) * kt[i].wide()) / fields::dot(t, kt);
        let count = fields::sum_of(n, |i| if on(i) { 1.0 } else { 0.0 });
        let mean = fields::sum_of(n, |i| if on(i) { t[i].wide() } else { 0.0 }) / count;
        for i in 0..n {
            let d = if on(i) { t[i].wide() - mean } else { 0.0 };
            direction[i] = T::of(f64::from(z[i]) - beta * d);
        }
        is_descent = fields::sum_of(n, |i| direction[i].wide() * gap(i)) > 0.0;
    }
    if !is_descent {
        for i in 0..n {
            direction[i] = T::of(f64::from(z[i]));
        }
        is_descent = fields::sum_of(n, |i| direction[i].wide() * gap(i)) > 0.0;
    }
    if !is_descent {
        let count = fields::sum_of(n, |i| if on(i) { 1.0 } else { 0.0 });
        let mean = fields::sum_of(n, |i| if on(i) { gap(i) } else { 0.0 }) / count;
        for i in 0..n {
            direction[i] = T::of(if on(i) { gap(i) - mean } else { 0.0 });
        }
    }
    // Of mean zero to the last digit: the load must not drift.
    let count = fields::sum_of(n, |i| if on(i) { 1.0 } else { 0.0 });
    let mean = T::of(fields::sum(direction) / count);
    for i in 0..n {
        if on(i) {
            direction[i] -= mean;
        }
    }
    std::mem::swap(direction, t);
    direction = &mut pairs.trial.pressure;
    operator.apply(t, kt);
    let length = T::of(fields::sum_of(n, |i| t[i].wide() * gap(i)) / fields::dot(t, kt));
    for i in 0..n {
        direction[i] = p[i] - length * t[i];
    }
    if fields::min(direction) < 0.0 || ceiling.is_passed(1.0, direction) {
        project(ceiling, direction, load);
        operator.apply(direction, u);
        std::mem::swap(p, direction);
        return 2.0;
    }
    std::mem::swap(p, direction);
    for (u, kt) in u.iter_mut().zip(kt.iter()) {
        *u -= length * *kt;
    }
    1.0
}

/// Sets z to zero outside the contact and subtracts its mean inside.
fn centre(nodes: &[NodeState], z: &mut [f32]) {
    let on = |i: usize| nodes[i].is_in();
    let count = fields::sum_of(z.len(), |i| if on(i) { 1.0 } else { 0.0 });
    let mean = fields::sum_of(z.len(), |i| if on(i) { f64::from(z[i]) } else { 0.0 }) / count;
    for (i, z) in z.iter_mut().enumerate() {
        *z = if on(i) { *z - mean as f32 } else { 0.0 };
    }
}
