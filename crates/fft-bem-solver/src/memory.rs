//! How much memory a solver takes, asked before it takes any.

use crate::{Boundary, Maps, Method, Precision, SolverError};
use contact_types::Grid;

/// What decides how much it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Needs {
    pub(crate) method: Method,
    pub(crate) boundary: Boundary,
    pub(crate) precision: Precision,
    pub(crate) certified: bool,
    pub(crate) maps: Maps,
    /// Whether each pixel has a hardness of its own.
    pub(crate) ceilings: bool,
}

impl Needs {
    /// Bytes per pixel at the peak, the maps of one solution included; counted array by array in
    /// `docs/src/solver/method.md`, within a tenth of what an allocator counts.
    fn per_pixel(self) -> f64 {
        let t = match self.precision {
            Precision::Double => 8.0,
            Precision::Single => 4.0,
        };
        let maps = match self.maps {
            Maps::None => 0.0,
            Maps::Pressure => 8.0,
            Maps::PressureAndGap => 16.0,
        };
        // As given, and as the iteration has it.
        let ceilings = if self.ceilings { 8.0 + t } else { 0.0 };
        let (heights, iterate) = (t, 2.0 * t);
        let solving = ceilings + heights + iterate + self.method(t) + self.half_space(t);
        let answering = maps + if self.certified { t } else { 0.0 };
        // The coefficients of the free half space are transformed on a doubled grid in f64.
        let building = match self.boundary {
            Boundary::Periodic => 0.0,
            Boundary::Free => 64.0 - (self.half_space(t) - t) - heights - iterate,
        };
        solving + answering.max(building)
    }

    /// Of the operator.
    fn half_space(self, t: f64) -> f64 {
        match self.boundary {
            Boundary::Periodic => t, // half spectrum
            // Kernel and half spectrum on a doubled grid, and a field for its inverse.
            Boundary::Free => t + 2.0 * t + t,
        }
    }

    /// Of the method.
    fn method(self, t: f64) -> f64 {
        // Residual, nodes, pyramid, sweep, grids of S: in single precision whatever the fields are.
        let preconditioner = 4.0 + 1.0 + 2.7 + 1.1 + 0.6;
        match (self.method, self.boundary) {
            // Trial and iterate before.
            (Method::Auto | Method::Chord, Boundary::Periodic) => 4.0 * t + preconditioner,
            // On a grid a quarter larger each way, heights and iterate there as well; and a pair.
            (Method::Auto | Method::Chord, Boundary::Free) => {
                1.5625 * (7.0 * t + preconditioner) + 2.0 * t
            }
            (Method::PolonskyKeer | Method::StanleyKato, _) => 3.0 * t,
        }
    }

    /// Bytes for a grid, about.
    pub(crate) fn bytes(self, grid: Grid) -> u128 {
        (self.per_pixel() * grid.len() as f64) as u128
    }

    /// Whether the machine grants as much.
    ///
    /// # Errors
    /// [`SolverError::Memory`] if not.
    pub(crate) fn check(self, grid: Grid) -> Result<(), SolverError> {
        let bytes = self.bytes(grid);
        if bytes < SMALL {
            return Ok(());
        }
        let refused = Err(SolverError::Memory { shape: grid.shape(), bytes });
        if installed().is_some_and(|installed| bytes > installed) {
            return refused;
        }
        // Systems that promise more than they have say no to one request for all of it, if they ever do.
        match usize::try_from(bytes) {
            Ok(size) if Vec::<u8>::new().try_reserve_exact(size).is_ok() => Ok(()),
            _ => refused,
        }
    }
}

/// Memory that any machine has which can run this (bytes): less is not asked for beforehand.
const SMALL: u128 = 1 << 28;

/// Memory and swap of the machine (bytes), where the system says so.
fn installed() -> Option<u128> {
    if !cfg!(target_os = "linux") {
        return None;
    }
    let table = std::fs::read_to_string("/proc/meminfo").ok()?;
    let kibibytes = |name: &str| -> Option<u128> {
        let line = table.lines().find_map(|line| line.strip_prefix(name))?;
        line.split_whitespace().next()?.parse().ok()
    };
    Some(1024 * (kibibytes("MemTotal:")? + kibibytes("SwapTotal:").unwrap_or(0)))
}
