//! How stiff a given contact set is, and how well it conducts: the mixed problem.
//!
//! Pressed a little deeper, every point of a frictionless contact set C goes down by the same amount, and
//! outside nothing presses: `K p = c` on C, `p = 0` elsewhere, `mean p = 1`. The incremental stiffness per
//! nominal area is `1/c`. Two half spaces that touch on C and carry a current obey the same equations, with
//! the potential in place of the displacement and the current density in place of the pressure (Barber
//! 2003): one solution serves stiffness, electrical and thermal conductance, and the pressure is the map
//! of the current density. That holds for any set C, however it came about; the stiffness of a
//! *loading curve* is that of C only while nothing yields.
//!
//! The equations are those of an energy to be minimised on a fixed set: conjugate gradients, with the
//! cheap inverse of the [chord iteration](crate::Method::Chord) as preconditioner, from a uniform pressure
//! swept onto the set.
//!
//! Source: Barber (2003), *Proc. R. Soc. A* 459, 53–66.

use crate::methods::{Compliance, NodeState, SetInverse};
use crate::{Boundary, SolverError, fields};
use contact_types::{ContactModulus, Grid};

/// Largest difference of potential on the set, relative to its mean, at which the iteration ends.
const TOLERANCE: f64 = 1e-8;
/// Most iterations: rough contacts need about ten.
const MOST_ITERATIONS: usize = 500;

/// The incremental answer of a contact set.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct SetStiffness {
    /// Incremental normal stiffness per nominal area, `-dp/dg` with the mean gap g (Pa/m): 0 without contact,
    /// infinite where everything is in contact and the map repeats.
    pub per_area: f64,
    /// Pressure over mean pressure, and current density over mean current density, row-major; 0 outside
    /// the set. Empty without contact.
    pub density: Vec<f64>,
    /// Largest difference of the displacement on the set from its mean, relative to that.
    pub residual: f64,
    /// FFT convolutions spent.
    pub transforms: f64,
    /// Iterations done.
    pub iterations: usize,
}

/// Conducting bodies, per pair: each number is one body's.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Conductors {
    /// Electrical resistivities (Ω m); 0 is a superconductor, infinity an insulator.
    Resistivities([f64; 2]),
    /// Thermal conductivities (W/(m K)); infinity keeps its temperature, 0 insulates.
    Conductivities([f64; 2]),
}

impl SetStiffness {
    /// Contact conductance per nominal area between half spaces, beyond the column of bulk material:
    ///
    /// ```math
    /// h = \frac{2 k}{E^* (\rho_1 + \rho_2)} \quad\text{or}\quad h = \frac{2 k}{E^* (1/k_1 + 1/k_2)}
    /// ```
    ///
    /// in S/m² or W/(m² K), with `modulus` the one this stiffness was found with. No film, no current
    /// through the gap, spots much larger than the free path of what carries the current.
    ///
    /// # Errors
    /// [`SolverError::BadSetting`] if a number is negative or no number.
    pub fn conductance(
        &self,
        modulus: ContactModulus,
        conductors: Conductors,
    ) -> Result<f64, SolverError> {
        let (setting, values) = match conductors {
            Conductors::Resistivities(values) => ("resistivity", values),
            Conductors::Conductivities(values) => ("conductivity", values),
        };
        if let Some(value) = values.into_iter().find(|v| v.is_nan() || *v < 0.0) {
            let limit = "it must not be negative";
            return Err(SolverError::BadSetting { setting, value, limit });
        }
        let resistance: f64 = match conductors {
            Conductors::Resistivities([a, b]) => a + b,
            Conductors::Conductivities([a, b]) => 1.0 / a + 1.0 / b,
        };
        let spots = 2.0 * self.per_area / modulus.pascals();
        Ok(match (spots > 0.0, resistance > 0.0) {
            (false, _) => 0.0, // no contact
            (true, false) => f64::INFINITY,
            // An insulator lets nothing through, even in full contact.
            (true, true) if resistance.is_infinite() => 0.0,
            (true, true) => spots / resistance,
        })
    }
}

/// Solves the mixed problem for the pixels where `is_in` holds. `operator` has the symbol `2/|q|` on the
/// `scaled` grid; `unit` is what a stiffness of 1 is there (Pa/m).
pub(crate) fn solve(
    scaled: Grid,
    operator: &mut dyn Compliance<f64>,
    is_in: impl Fn(usize) -> bool,
    unit: f64,
) -> SetStiffness {
    let n = scaled.len();
    let nodes: Vec<NodeState> = (0..n).map(|i| NodeState::of(is_in(i))).collect();
    let size = nodes.iter().filter(|m| m.is_in()).count();
    let exact = |per_area, density| SetStiffness {
        per_area,
        density,
        residual: 0.0,
        transforms: 0.0,
        iterations: 0,
    };
    if size == 0 {
        return exact(0.0, Vec::new());
    }
    if size == n && operator.boundary() == Boundary::Periodic {
        return exact(f64::INFINITY, vec![1.0; n]);
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
        operator.apply_in_place(&mut field);
        fields::gather(&field, &on, to);
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
        let rise = mean_of(&u);
        let worst = u.iter().fold(0.0_f64, |worst, u| worst.max((u - rise).abs()));
        let residual = worst / rise.abs();
        if residual <= TOLERANCE || iterations == MOST_ITERATIONS {
            break (rise, residual);
        }
        // The residual is what the potential lacks of a constant; a step changes no load.
        inverse.apply(&on, |k| rise - u[k], &mut z);
        transforms += inverse.cost();
        let mean = mean_of(&z);
        for z in &mut z {
            *z -= mean;
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
        let descent: f64 = u.iter().zip(&d).map(|(u, d)| (rise - u) * d).sum();
        let length = descent / dot(&d, &kd);
        if !length.is_finite() {
            break (rise, residual); // nothing left but rounding
        }
        for ((p, u), (d, kd)) in p.iter_mut().zip(&mut u).zip(d.iter().zip(&kd)) {
            *p += length * d;
            *u += length * kd;
        }
        (iterations, has_direction) = (iterations + 1, true);
    };
    fields::scatter(&p, &on, &mut field);
    SetStiffness { per_area: unit / rise, density: field, residual, transforms, iterations }
}
