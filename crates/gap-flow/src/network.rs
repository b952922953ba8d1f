//! Reynolds' equation on a map of the gap.

use crate::channel::Bottleneck;
use crate::conjugate_gradients::{Network, NotSolved, Symbolic};
use crate::gap::Gap;
use contact_types::Axis;

/// The flow through a gap along an axis.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Flow {
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
    /// Size of the flux at each point over the mean along the axis; empty where no channel is open.
    pub flux: Vec<f64>,
}

/// Mean of g³ over the face between two points, so that the flow through both halves is one.
const HARMONIC: fn(f64, f64) -> f64 = |a, b| 2.0 * a * b / (a + b);
const ARITHMETIC: fn(f64, f64) -> f64 = |a, b| 0.5 * (a + b);

/// The points that carry a flow along an axis, and their links.
struct Mesh {
    /// Place on the map of each point.
    points: Vec<usize>,
    links: Vec<[usize; 2]>,
    /// Of each link: whether it goes along y, and the way from its first point to its second, 1 or −1 over the edge of the map.
    ways: Vec<(usize, f64)>,
    /// Width of a face over distance of the points, along x and along y.
    shape: [f64; 2],
    /// g³ of each point, in units of the highest, so that none underflows.
    cubes: Vec<f64>,
    ends: Vec<[f64; 2]>,
    /// Permeability over conductance (m³).
    scale: f64,
}

impl Mesh {
    fn network(&self, face: fn(f64, f64) -> f64) -> Network<'_> {
        let of = |(&[a, b], &(k, _)): (&[usize; 2], &(usize, f64))| {
            self.shape[k] * face(self.cubes[a], self.cubes[b])
        };
        let conductances = self.links.iter().zip(&self.ways).map(of).collect();
        Network { links: &self.links, conductances, ends: &self.ends }
    }
}

impl Gap<'_> {
    fn mesh(&self, axis: Axis, open: &[bool]) -> Mesh {
        let [dy, dx] = self.grid.pixel();
        let [height, length] = self.grid.size();
        let shape = [dy / dx, dx / dy];
        let (along, squares) = match axis {
            Axis::X => (shape[0], length / height),
            Axis::Y => (shape[1], height / length),
        };
        let points: Vec<usize> = (0..open.len()).filter(|&i| open[i]).collect();
        let mut unknown = vec![usize::MAX; open.len()];
        points.iter().enumerate().for_each(|(k, &i)| unknown[i] = k);
        let highest = points.iter().map(|&i| self.heights[i]).fold(0.0, f64::max);
        let cubes: Vec<f64> = points.iter().map(|&i| (self.heights[i] / highest).powi(3)).collect();
        let (mut links, mut ways) = (Vec::new(), Vec::new());
        for (k, &i) in points.iter().enumerate() {
            // Before and after along x, then along y.
            let next = self.neighbours(i, axis).map(|n| n.map_or(usize::MAX, |n| unknown[n]));
            for (step, b) in next.into_iter().enumerate() {
                if b != usize::MAX && b > k {
                    links.push([k, b]);
                    ways.push((step / 2, if step % 2 == 0 { -1.0 } else { 1.0 }));
                }
            }
        }
        let to_ends = |(&i, cube): (&usize, &f64)| {
            self.at_ends(i, axis).map(|at| if at { 2.0 * along * cube } else { 0.0 })
        };
        let ends = points.iter().zip(&cubes).map(to_ends).collect();
        Mesh { points, links, ways, shape, cubes, ends, scale: squares * highest.powi(3) }
    }

    /// Size of the flux at each point over the mean along the axis, from the flows through its faces.
    fn flux(&self, axis: Axis, mesh: &Mesh, network: &Network<'_>, pressures: &[f64]) -> Vec<f64> {
        let mut through = vec![[0.0; 2]; pressures.len()];
        for ((&[a, b], c), &(k, way)) in
            network.links.iter().zip(&network.conductances).zip(&mesh.ways)
        {
            let half = 0.5 * way * c * (pressures[a] - pressures[b]);
            through[a][k] += half;
            through[b][k] += half;
        }
        let total = network.dissipation(pressures);
        let along = axis as usize;
        for ((through, [inlet, outlet]), p) in through.iter_mut().zip(network.ends).zip(pressures) {
            through[along] += 0.5 * (inlet * (1.0 - p) + outlet * p);
        }
        let ([dy, dx], [height, length]) = (self.grid.pixel(), self.grid.size());
        let mean = total / [height, length][along];
        let mut flux = vec![0.0; self.heights.len()];
        for (&i, [x, y]) in mesh.points.iter().zip(&through) {
            flux[i] = (x / dy).hypot(y / dx) / mean;
        }
        flux
    }

    /// [`Flow::permeability`] alone, for half of the work.
    ///
    /// # Errors
    /// [`NotSolved`].
    pub fn permeability(&self, axis: Axis) -> Result<f64, NotSolved> {
        let Some((open, _)) = self.channel(axis) else { return Ok(0.0) };
        let mesh = self.mesh(axis, &open);
        let network = mesh.network(HARMONIC);
        Ok(mesh.scale * network.dissipation(&network.solve(&mut Symbolic::default())?))
    }

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
        let (bottleneck, flux) = (None, Vec::new());
        let closed = Flow { permeability: 0.0, arithmetic: 0.0, imbalance: 0.0, bottleneck, flux };
        let Some((open, bottleneck)) = self.channel(axis) else { return Ok(closed) };
        let mesh = self.mesh(axis, &open);
        let mut symbolic = Symbolic::default();
        let arithmetic = mesh.network(ARITHMETIC);
        let arithmetic = arithmetic.dissipation(&arithmetic.solve(&mut symbolic)?);
        let harmonic = mesh.network(HARMONIC);
        let pressures = harmonic.solve(&mut symbolic)?;
        let permeability = harmonic.dissipation(&pressures);
        let through = |end: usize, at: f64| -> f64 {
            mesh.ends.iter().zip(&pressures).map(|(ends, p)| ends[end] * (p - at).abs()).sum()
        };
        let (inflow, outflow) = (through(0, 1.0), through(1, 0.0));
        Ok(Flow {
            permeability: permeability * mesh.scale,
            arithmetic: arithmetic * mesh.scale,
            imbalance: (inflow - outflow).abs() / permeability,
            bottleneck: Some(bottleneck),
            flux: self.flux(axis, &mesh, &harmonic, &pressures),
        })
    }
}
