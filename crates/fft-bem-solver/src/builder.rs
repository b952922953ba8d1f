//! The settings of a solver.

use crate::{Boundary, Maps, Method, Precision};

/// Settings of a [`Solver`](crate::Solver), each with a default.
#[derive(Debug, Clone)]
pub struct SolverBuilder {
    pub(crate) method: Method,
    /// As set with [`boundary`](Self::boundary).
    pub boundary: Boundary,
    /// As set with [`precision`](Self::precision).
    pub precision: Precision,
    /// As set with [`tolerance`](Self::tolerance).
    pub tolerance: f64,
    pub(crate) threads: Option<usize>,
    pub(crate) certified: bool,
    /// As set with [`maps`](Self::maps).
    pub maps: Maps,
    /// Pa; infinite for elastic bodies.
    pub(crate) hardness: f64,
    /// Whether the pressure answered is the one that the next step would try, without the convolution for its displacement:
    /// that is about ten times closer than the tolerance, and the gap no closer. Only with [`Method::Chord`]; default no.
    pub ends_on_trial: bool,
}

impl Default for SolverBuilder {
    fn default() -> Self {
        Self {
            method: Method::Chord,
            boundary: Boundary::Periodic,
            precision: Precision::Double,
            tolerance: 1e-4,
            threads: None,
            certified: false,
            maps: Maps::default(),
            hardness: f64::INFINITY,
            ends_on_trial: false,
        }
    }
}

impl SolverBuilder {
    /// How to solve; default [`Method::Auto`].
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.method = if method == Method::Auto { Method::Chord } else { method };
        self
    }

    /// What lies beyond the edges; default [`Boundary::Periodic`].
    #[must_use]
    pub fn boundary(mut self, boundary: Boundary) -> Self {
        self.boundary = boundary;
        self
    }

    /// Type of the fields during the iteration; default [`Precision::Double`].
    #[must_use]
    pub fn precision(mut self, precision: Precision) -> Self {
        self.precision = precision;
        self
    }

    /// Relative rms error of the pressure to reach, between 0 and 1 (excluded); default 1e-4.
    ///
    /// Every method reaches 1e-11 in double and 3e-5 in single precision. Where rounding ends an iteration earlier,
    /// that is [`SolverError::Rounding`](crate::SolverError), with the solution and the residual reached.
    #[must_use]
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// Threads to use, at least 1; default all there are. The results do not depend on it.
    ///
    /// Without a number a solver uses the pool of rayon on whose thread it is called, never the global one. Threads do
    /// not survive a `fork`: a child process builds its own solver.
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = Some(threads);
        self
    }

    /// Whether each solution comes with a rigorous bound of its error
    /// ([`Diagnostics::energy_bound`](crate::Diagnostics)), for one more FFT convolution; default no.
    #[must_use]
    pub fn certified(mut self, certified: bool) -> Self {
        self.certified = certified;
        self
    }

    /// Which maps each solution carries; default both.
    #[must_use]
    pub fn maps(mut self, maps: Maps) -> Self {
        self.maps = maps;
        self
    }

    /// Highest pressure the softer body bears before it yields (Pa): its hardness, the pressure of an
    /// indentation, about 2.8 times the yield stress. Infinite means elastic bodies, the default.
    ///
    /// The contact is then that of `0 <= p <= H`: where the pressure is H, the surface is flattened by as much as the
    /// gap of the [`Solution`](crate::Solution) is negative. H is constant, no material piles up beside what is
    /// flattened, loading only, only with [`Method::Chord`].
    #[must_use]
    pub fn hardness(mut self, pascals: f64) -> Self {
        self.hardness = pascals;
        self
    }
}
