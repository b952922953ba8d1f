//! How a map and the rungs beside it are solved.

use contact_types::{Axis, ContactModulus};
use fft_bem_solver::{Maps, SolverBuilder};

/// Largest relative rms error of the pressure with which an uncertainty is known.
pub(crate) const LOOSEST: f64 = 1e-2;

/// How to solve.
#[derive(Debug, Clone)]
pub struct Setup {
    /// Settings of the solver.
    pub builder: SolverBuilder,
    /// Whether the map is continued by its mirror images rather than by itself.
    pub mirrored: bool,
    /// Contact modulus.
    pub modulus: ContactModulus,
    /// Whether a load is also solved on twice the points along each side: where the indicator exceeds its limit or the
    /// uncertainty 20 %, on maps of up to 1024² points.
    pub finer: bool,
    /// Whether the stiffness of the contact set is asked for.
    pub stiffness: bool,
    /// Length of the temperature jumps of a gas in the gap (m), if its conductance is asked for. With this or the next,
    /// pressure and gap are kept, for the stiffness the pressure.
    pub jump: Option<f64>,
    /// Axes along which the leak through the gap is asked for.
    pub leak: Vec<Axis>,
}

impl Setup {
    /// Of a map that repeats; twice the points where needed, no stiffness, nothing of the gap besides its mean.
    pub fn new(builder: SolverBuilder, modulus: ContactModulus) -> Self {
        Self {
            builder,
            mirrored: false,
            modulus,
            finer: true,
            stiffness: false,
            jump: None,
            leak: Vec::new(),
        }
    }

    /// The same as loosely as there is an uncertainty, to end on a trial, which is closer; as it is where a contact set or a gap is
    /// asked for and not area and mean gap alone.
    pub(crate) fn loose(mut self) -> Self {
        if self.maps() == Maps::None {
            self.builder.tolerance = self.builder.tolerance.max(LOOSEST);
            self.builder.ends_on_trial = true;
        }
        self
    }

    /// What the rungs beside the map keep of a solution.
    pub(crate) fn maps(&self) -> Maps {
        match self.jump.is_some() || !self.leak.is_empty() {
            true => Maps::PressureAndGap,
            false if self.stiffness => Maps::Pressure,
            false => Maps::None,
        }
    }
}
