//! Reynolds' equation on a map of the gap.

use crate::channel::Bottleneck;
use crate::conjugate_gradients::Network;
use crate::gap::{Axis, Gap};

/// The flow through a gap along an axis.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Flow {
    /// The axis.
    pub axis: Axis,
    /// Permeability K (m³): `Q = K W Δp/(12 η L)` through a width W over a length L. 0 exactly where no channel is
    /// open.
    pub permeability: f64,
    /// The same with the arithmetic mean of g³ between neighbouring points instead of the harmonic: the two differ by
    /// what the grid leaves open.
    pub arithmetic: f64,
    /// What flows in less what flows out, over either.
    pub imbalance: f64,
    /// The narrowest place of the best channel; `None` where no channel is open.
    pub bottleneck: Option<Bottleneck>,
    /// Flow per width through each point times length over pressure drop and 1/12η (m³), row-major: the mean of its part along the axis
    /// is K.
    pub flux: Vec<f64>,
}

/// The iteration did not converge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "the flow through the gap is not solved after {iterations} iterations; take every second point of the map"
)]
pub struct NotSolved {
    /// Iterations done.
    pub iterations: usize,
}

impl Gap<'_> {
    /// Solves Reynolds' equation with the pressure drop along an axis:
    ///
    /// ```math
    /// \nabla\cdot(g^3\,\nabla p) = 0
    /// ```
    ///
    /// Finite volumes: one pressure for each point, g³ between two the harmonic mean of theirs, half a point to inlet
    /// and outlet. Clusters of open points that do not reach from one to the other carry nothing and are left out.
    ///
    /// # Errors
    /// [`NotSolved`].
    pub fn flow(&self, axis: Axis) -> Result<Flow, NotSolved> {
        let Some(channel) = self.channel(axis) else {
            let flux = vec![0.0; self.heights.len()];
            let (permeability, arithmetic, imbalance) = (0.0, 0.0, 0.0);
            return Ok(Flow { axis, permeability, arithmetic, imbalance, bottleneck: None, flux });
        };
        let [dy, dx] = self.grid.pixel();
        let [height, length] = self.grid.size();
        // Conductance of a square of gap 1 along x and along y.
        let aspect = [dy / dx, dx / dy];
        let (along, squares, length) = match axis {
            Axis::X => (aspect[0], length / height, length),
            Axis::Y => (aspect[1], height / length, height),
        };
        let points: Vec<usize> = (0..channel.open.len()).filter(|&i| channel.open[i]).collect();
        let mut unknown = vec![usize::MAX; channel.open.len()];
        points.iter().enumerate().for_each(|(k, &i)| unknown[i] = k);
        // In units of the highest gap, so that no cube underflows.
        let highest = points.iter().map(|&i| self.heights[i]).fold(0.0, f64::max);
        let unit = highest.powi(3);
        let cubes: Vec<f64> = points.iter().map(|&i| (self.heights[i] / highest).powi(3)).collect();
        // The neighbour that a link leads to: before or after along x, along y.
        let (mut links, mut steps) = (Vec::new(), Vec::new());
        for (k, &i) in points.iter().enumerate() {
            let next = self.neighbours(i, axis).map(|n| n.map_or(usize::MAX, |n| unknown[n]));
            for (step, b) in next.into_iter().enumerate() {
                if b != usize::MAX && b > k {
                    links.push([k, b]);
                    steps.push(step);
                }
            }
        }
        let to_ends = |(&i, cube): (&usize, &f64)| {
            self.at_ends(i, axis).map(|at| if at { 2.0 * along * cube } else { 0.0 })
        };
        let ends: Vec<[f64; 2]> = points.iter().zip(&cubes).map(to_ends).collect();
        let network = |face: fn(f64, f64) -> f64| {
            let of = |(&[a, b], step): (&[usize; 2], &usize)| {
                aspect[step / 2] * face(cubes[a], cubes[b])
            };
            let conductances = links.iter().zip(&steps).map(of).collect();
            Network { links: &links, conductances, ends: ends.clone() }
        };
        let mut symbolic = None;
        let mut solved = |network: &Network<'_>| {
            network.solve(&mut symbolic).map_err(|iterations| NotSolved { iterations })
        };
        let arithmetic = network(|a, b| 0.5 * (a + b));
        let arithmetic = arithmetic.dissipation(&solved(&arithmetic)?);
        let harmonic = network(|a, b| 2.0 * a * b / (a + b));
        let pressures = solved(&harmonic)?;
        let permeability = harmonic.dissipation(&pressures);
        let through = |end: usize, at: f64| -> f64 {
            ends.iter().zip(&pressures).map(|(ends, p)| ends[end] * (p - at).abs()).sum()
        };
        let (inflow, outflow) = (through(0, 1.0), through(1, 0.0));
        // Both components of the flow of each point: the mean of its two faces.
        let mut flows = vec![[0.0; 2]; points.len()];
        for ((&[a, b], c), step) in links.iter().zip(&harmonic.conductances).zip(&steps) {
            let flow = 0.5 * c * (pressures[a] - pressures[b]);
            let signed = if step.is_multiple_of(2) { -flow } else { flow };
            flows[a][step / 2] += signed;
            flows[b][step / 2] += signed;
        }
        let component = usize::from(axis == Axis::Y);
        let mut flux = vec![0.0; channel.open.len()];
        for (k, &i) in points.iter().enumerate() {
            let [inlet, outlet] = ends[k];
            flows[k][component] += 0.5 * (inlet * (1.0 - pressures[k]) + outlet * pressures[k]);
            let [x, y] = flows[k];
            flux[i] = unit * length * (x / dy).hypot(y / dx);
        }
        Ok(Flow {
            axis,
            permeability: permeability * squares * unit,
            arithmetic: arithmetic * squares * unit,
            imbalance: (inflow - outflow).abs() / permeability,
            bottleneck: Some(channel.bottleneck),
            flux,
        })
    }
}
