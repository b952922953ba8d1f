//! How much memory a solver takes, asked before it takes any.

use crate::{Boundary, Maps, Method, Precision, SolverBuilder, SolverError};
use contact_types::Grid;

/// Points from which on memory is what limits, 8192 x 8192.
const LARGE: usize = 1 << 26;

/// Whether a grid of so many points is to be solved without the step before: two fields of nine.
pub(crate) fn is_large(points: usize) -> bool {
    points >= LARGE
}

/// Bytes that a solver for a grid takes at its peak, the maps of one solution included; within a tenth of
/// what an allocator counts.
pub(crate) fn bytes(settings: &SolverBuilder, grid: Grid) -> u128 {
    let t = match settings.precision {
        Precision::Double => 8.0,
        Precision::Single => 4.0,
    };
    let maps = match settings.maps {
        Maps::None => 0.0,
        Maps::Pressure => 8.0,
        Maps::PressureAndGap => 16.0,
    };
    let (heights, iterate) = (t, 2.0 * t);
    let points = match settings.boundary {
        Boundary::Periodic => grid.len(),
        Boundary::Free => grid.len() * 25 / 16,
    };
    let trial_and_before = if is_large(points) { 2.0 * t } else { 4.0 * t };
    // Residual, nodes, pyramid, sweep, grids of S: in single precision whatever the fields are.
    let preconditioner = 4.0 + 1.0 + 2.7 + 1.1 + 0.6;
    let method = match (settings.method, settings.boundary) {
        (Method::PolonskyKeer | Method::StanleyKato, _) => 3.0 * t,
        (_, Boundary::Periodic) => trial_and_before + preconditioner,
        // On a grid a quarter larger each way, heights and iterate there as well; and a pair.
        (_, Boundary::Free) => {
            1.5625 * (heights + iterate + trial_and_before + preconditioner) + 2.0 * t
        }
    };
    // The coefficients of the free half space are transformed on a doubled grid in f64.
    let (half_space, building) = match settings.boundary {
        Boundary::Periodic => (t, 0.0), // half spectrum
        Boundary::Free => (3.0 * t, 64.0 - 2.0 * t - heights - iterate), // on a doubled grid
    };
    let solving = heights + iterate + method + half_space;
    let answering = maps + if settings.certified { t } else { 0.0 };
    ((solving + f64::max(answering, building)) * grid.len() as f64) as u128
}

/// Whether the machine grants what the mixed problem of a set of so many pixels takes: a field, half a
/// spectrum and the preconditioner on the map, six numbers for each pixel of the set.
pub(crate) fn check_set(grid: Grid, boundary: Boundary, pixels: usize) -> Result<(), SolverError> {
    let half_space = match boundary {
        Boundary::Periodic => 8.0,
        Boundary::Free => 64.0, // while it is built; and a copy of the field
    };
    // Residual, its extension, nodes and who is in contact, pyramid, grids of S.
    let preconditioner = 4.0 + 4.0 + 2.0 + 2.7 + 0.6;
    let on_map = (8.0 + half_space + preconditioner) * grid.len() as f64;
    check(grid, (on_map + 48.0 * pixels as f64) as u128)
}

/// Whether the machine grants so many bytes for a grid.
pub(crate) fn check(grid: Grid, bytes: u128) -> Result<(), SolverError> {
    if bytes < SMALL {
        return Ok(());
    }
    // What the system reckons as free it does not quite give.
    let free = free();
    let refused = Err(SolverError::Memory { shape: grid.shape(), bytes, free });
    if free.is_some_and(|free| bytes > free / 20 * 19) {
        return refused;
    }
    // Systems that promise more than they have refuse at most one request for all of it.
    match usize::try_from(bytes) {
        Ok(size) if Vec::<u8>::new().try_reserve_exact(size).is_ok() => Ok(()),
        _ => refused,
    }
}

/// Memory that any machine has which can run this (bytes): less is not asked for beforehand.
const SMALL: u128 = 1 << 28;

/// Memory and swap that nobody holds (bytes), or what the group of processes that this one belongs to (a job on a
/// cluster, a container) may still take, where the system says so (Linux).
fn free() -> Option<u128> {
    if !cfg!(target_os = "linux") {
        return None;
    }
    let kibibytes = |table: &str, name: &str| -> Option<u128> {
        let line = table.lines().find_map(|line| line.strip_prefix(name))?;
        Some(1024 * line.split_whitespace().next()?.parse::<u128>().ok()?)
    };
    let of_machine = std::fs::read_to_string("/proc/meminfo").ok().and_then(|table| {
        let swap = kibibytes(&table, "SwapFree:").unwrap_or(0);
        Some(kibibytes(&table, "MemAvailable:")? + swap)
    });
    let held = std::fs::read_to_string("/proc/self/status").ok();
    let held = held.and_then(|table| kibibytes(&table, "VmRSS:")).unwrap_or(0);
    let of_group = limit_of_group().map(|limit| limit.saturating_sub(held));
    [of_machine, of_group].into_iter().flatten().min()
}

/// The limit of memory of the control group of this process (bytes), of either version.
fn limit_of_group() -> Option<u128> {
    let groups = std::fs::read_to_string("/proc/self/cgroup").ok()?;
    let limits = groups.lines().filter_map(|line| {
        let [_, controllers, path] = *line.splitn(3, ':').collect::<Vec<_>>() else { return None };
        let (root, file) = match controllers {
            "" => ("/sys/fs/cgroup", "memory.max"),
            "memory" => ("/sys/fs/cgroup/memory", "memory.limit_in_bytes"),
            _ => return None,
        };
        // In a container the path is as the host sees it, and the group at the root of the files.
        let at = |path: &str| std::fs::read_to_string(format!("{root}{path}/{file}")).ok();
        at(path).or_else(|| at(""))?.trim().parse().ok() // "max" is no limit
    });
    limits.min()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What no machine has is refused, and the error says what there is; what every machine has is not asked for.
    #[test]
    fn a_set_that_does_not_fit_is_refused() {
        let grid = |side| Grid::new([side, side], [1e-6, 1e-6]).unwrap();
        for boundary in [Boundary::Periodic, Boundary::Free] {
            check_set(grid(512), boundary, 512 * 512).unwrap();
            let refused = check_set(grid(1 << 20), boundary, 0).unwrap_err();
            let SolverError::Memory { bytes, free, .. } = refused else { panic!("{refused}") };
            assert!(free.is_some() || !cfg!(target_os = "linux"), "how much there is was not read");
            assert!(bytes > 29 << 40 && free.is_none_or(|free| free < bytes), "{refused}");
            let more = bytes + (48 << 40);
            let refused = check_set(grid(1 << 20), boundary, 1 << 40).unwrap_err();
            assert!(matches!(refused, SolverError::Memory { bytes, .. } if bytes == more));
        }
    }
}
