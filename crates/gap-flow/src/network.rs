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
    /// Flow through the row or column of points across the axis with the most less that with the least, over the mean.
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
    /// Place on the map of each point; with ends the one beyond them is the last.
    points: Vec<usize>,
    links: Vec<[usize; 2]>,
    /// Of each link: whether it goes along y, and the way from its first point to its second, 1 or −1 over the edge of the map.
    ways: Vec<(usize, f64)>,
    /// Of each link: the drop of pressure from the map to the copy that its second point is on.
    drops: Vec<f64>,
    /// Infinite where the pressure is held at 0, the deepest point of each cluster or that beyond the ends; 0 elsewhere.
    ground: Vec<f64>,
    /// Width of a face over distance of the points, along x and along y.
    shape: [f64; 2],
    /// g³ of each point, in units of the highest, so that none underflows.
    cubes: Vec<f64>,
    /// Permeability over conductance (m³).
    scale: f64,
}

impl Mesh {
    fn network(&self, face: fn(f64, f64) -> f64) -> Network<'_> {
        let of = |(&[a, b], &(k, _)): (&[usize; 2], &(usize, f64))| {
            let [a, b] = [self.cubes[a], self.cubes[b]];
            self.shape[k] * if b.is_finite() { face(a, b) } else { 2.0 * a }
        };
        let conductances = self.links.iter().zip(&self.ways).map(of).collect();
        Network { links: &self.links, conductances, drops: &self.drops, ground: &self.ground }
    }
}

impl Gap<'_> {
    fn mesh(&self, axis: Axis, deepest: &[Option<usize>]) -> Mesh {
        let [dy, dx] = self.grid.pixel();
        let [height, length] = self.grid.size();
        let shape = [dy / dx, dx / dy];
        let squares = [length / height, height / length][axis as usize];
        let points: Vec<usize> = (0..deepest.len()).filter(|&i| deepest[i].is_some()).collect();
        let mut unknown = vec![0; deepest.len()];
        points.iter().enumerate().for_each(|(k, &i)| unknown[i] = k);
        let heights = points.iter().map(|&i| self.heights.get(i).copied());
        let highest = heights.clone().flatten().fold(0.0, f64::max);
        let cubes = heights.map(|h| h.map_or(f64::INFINITY, |h| (h / highest).powi(3))).collect();
        let (mut links, mut ways, mut drops) = (Vec::new(), Vec::new(), Vec::new());
        for (k, &i) in points.iter().enumerate().filter(|(_, i)| **i < self.heights.len()) {
            // Before and after along x, then along y.
            for (step, next) in self.neighbours(i, axis).into_iter().enumerate() {
                if let Some((next, copies)) = next.filter(|(next, _)| unknown[*next] > k) {
                    links.push([k, unknown[next]]);
                    ways.push((step / 2, if step % 2 == 0 { -1.0 } else { 1.0 }));
                    drops.push(copies as f64);
                }
            }
        }
        let ground = points
            .iter()
            .map(|&i| if deepest[i] == Some(i) { f64::INFINITY } else { 0.0 })
            .collect();
        let scale = squares * highest.powi(3);
        Mesh { points, links, ways, drops, ground, shape, cubes, scale }
    }

    /// Size of the flux at each point over the mean along the axis, from the flows through its faces; and the imbalance.
    fn flux(&self, axis: Axis, mesh: &Mesh, of: &Network<'_>, p: &[f64]) -> (Vec<f64>, f64) {
        let mut through = vec![[0.0; 2]; p.len()];
        for ((&[a, b], [c, fall]), &(k, way)) in of.links.iter().zip(of.falls(p)).zip(&mesh.ways) {
            let half = 0.5 * way * c * fall;
            through[a][k] += half;
            through[b][k] += half;
        }
        let (along, total) = (axis as usize, of.dissipation(p));
        let ([dy, dx], [height, length]) = (self.grid.pixel(), self.grid.size());
        let mean = total / [height, length][along];
        let [ny, nx] = self.grid.shape();
        let (mut flux, mut sections) = (vec![0.0; ny * nx], vec![0.0; [nx, ny][along]]);
        for (&i, through) in mesh.points.iter().zip(&through).filter(|(i, _)| **i < ny * nx) {
            flux[i] = (through[0] / dy).hypot(through[1] / dx) / mean;
            sections[[i % nx, i / nx][along]] += through[along];
        }
        let most = sections.iter().copied().fold(f64::MIN, f64::max);
        let least = sections.iter().copied().fold(f64::MAX, f64::min);
        (flux, (most - least) / total)
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
    /// Finite volumes: one pressure for each point, g³ between two the harmonic mean of theirs. From a map that repeats along
    /// the flow to its next copy the pressure falls by the drop; else it is half a point to inlet and outlet. Clusters of
    /// open points that reach neither themselves on the next copy nor an end carry nothing and are left out.
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
        let (flux, imbalance) = self.flux(axis, &mesh, &harmonic, &pressures);
        Ok(Flow {
            permeability: permeability * mesh.scale,
            arithmetic: arithmetic * mesh.scale,
            imbalance,
            bottleneck: Some(bottleneck),
            flux,
        })
    }
}
