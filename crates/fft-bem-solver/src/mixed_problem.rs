//! How stiff a given contact set is, and how well it conducts: the mixed problem.
//!
//! Pressed a little deeper, every point of a frictionless contact set C goes down by the same amount, and
//! outside nothing presses: `K p = c` on C, `p = 0` elsewhere, `mean p = 1`. The incremental stiffness per
//! nominal area is `1/c`. A current through C obeys the same equations, with the potential in place of the
//! displacement and the current density in place of the pressure (Barber 2003). The stiffness of a
//! *loading curve* is that of C only while nothing yields.
//!
//! Conjugate gradients on the set, with the cheap inverse of the [chord iteration](crate::Method::Chord) as
//! preconditioner, from a uniform pressure swept onto it. `c = ⟨p, K p⟩ / ⟨p⟩²` is least for the answer, so that its error is
//! the energy `⟨r, K⁻¹ r⟩` of the residual `r = c - K p`, of second order: the preconditioner estimates it.
//!
//! Source: Barber (2003), *Proc. R. Soc. A* 459, 53–66.

use crate::methods::{Compliance, NodeState, SetInverse};
use crate::{Boundary, HalfSpace, fields};
use contact_types::Grid;

/// Estimated relative error of the stiffness at which the iteration ends.
const TOLERANCE: f64 = 1e-8;
/// Most iterations: rough contacts need about five.
const MOST_ITERATIONS: usize = 500;

/// The incremental answer of a contact set.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SetStiffness {
    /// Incremental normal stiffness per nominal area, dp over the approach (Pa/m), which is what the mean
    /// gap of a map that repeats falls by: 0 without contact, infinite where all of such a map is in contact.
    pub per_area: f64,
    /// Estimated relative error of the stiffness.
    pub residual: f64,
    /// FFT convolutions spent.
    pub transforms: f64,
    /// Iterations done.
    pub iterations: usize,
}

/// Solves the mixed problem for the pixels of `contact`. `operator` has the symbol `2/|q|` on the
/// `scaled` grid; `unit` is what a stiffness of 1 is there (Pa/m).
pub(crate) fn solve(
    scaled: Grid,
    operator: &mut HalfSpace<f64>,
    contact: &[bool],
    unit: f64,
) -> SetStiffness {
    let n = scaled.len();
    let nodes: Vec<NodeState> = contact.iter().map(|is_in| NodeState::of(*is_in)).collect();
    let size = nodes.iter().filter(|m| m.is_in()).count();
    let (residual, transforms, iterations) = (0.0, 0.0, 0);
    let exact = SetStiffness { per_area: 0.0, residual, transforms, iterations };
    if size == 0 {
        return exact;
    }
    if size == n && operator.boundary() == Boundary::Periodic {
        return SetStiffness { per_area: f64::INFINITY, ..exact };
    }
    let on: Vec<usize> = (0..n).filter(|i| nodes[*i].is_in()).collect();
    let mut inverse = SetInverse::new(scaled, nodes);
    // What a convolution takes and gives is on the map; all else is known and needed on the set alone.
    let mut field = vec![0.0; n];
    let [mut p, mut u, mut z, mut d, mut kd] = [(); 5].map(|()| vec![0.0; size]);
    let mean_of = |field: &[f64]| field.iter().sum::<f64>() / size as f64;
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut answer = |of: &[f64], to: &mut [f64]| {
        fields::scatter(of, &on, &mut field);
        operator.displace(&mut field);
        to.iter_mut().zip(&on).for_each(|(to, i)| *to = field[*i]);
    };

    inverse.sweep_uniform(&on, &mut p);
    let mean = p.iter().sum::<f64>() / n as f64;
    if mean > 0.0 && p.iter().all(|p| *p >= 0.0) {
        for p in &mut p {
            *p /= mean;
        }
    } else {
        p.fill(n as f64 / size as f64);
    }
    answer(&p, &mut u);
    let mut transforms = 1.0;
    let (mut iterations, mut has_direction) = (0, false);
    let (rise, residual) = loop {
        // The residual is what the potential lacks of a constant; a step changes no load.
        let mean = mean_of(&u);
        inverse.apply(&on, |k| mean - u[k], &mut z);
        transforms += inverse.cost();
        let excess = mean_of(&z);
        for z in &mut z {
            *z -= excess;
        }
        let energy = dot(&p, &u);
        let (rise, residual) = (energy / n as f64, (dot(&u, &z) / energy).abs());
        if residual <= TOLERANCE || iterations == MOST_ITERATIONS {
            break (rise, residual);
        }
        let beta = if has_direction { -dot(&z, &kd) / dot(&d, &kd) } else { 0.0 };
        for (d, z) in d.iter_mut().zip(&z) {
            *d = z + beta * *d;
        }
        let mean = mean_of(&d); // none, to the last digit
        for d in &mut d {
            *d -= mean;
        }
        answer(&d, &mut kd);
        transforms += 1.0;
        let length = -dot(&u, &d) / dot(&d, &kd);
        if !length.is_finite() {
            break (rise, residual); // nothing left but rounding
        }
        for ((p, u), (d, kd)) in p.iter_mut().zip(&mut u).zip(d.iter().zip(&kd)) {
            *p += length * d;
            *u += length * kd;
        }
        (iterations, has_direction) = (iterations + 1, true);
    };
    SetStiffness { per_area: unit / rise, residual, transforms, iterations }
}
