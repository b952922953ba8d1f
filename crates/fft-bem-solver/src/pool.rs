//! The threads of a solver.

use crate::SolverError;

/// Threads of one solver alone, or those of the pool of rayon in which it is used. Rayon's global threads are never
/// started: a forked child that asks for them would wait for ever.
pub(crate) struct Pool {
    #[cfg(all(feature = "parallel", not(target_family = "wasm")))]
    own: std::sync::OnceLock<rayon::ThreadPool>,
}

#[cfg(all(feature = "parallel", not(target_family = "wasm")))]
impl Pool {
    /// So many threads. Without a number those of the pool that the caller is in; outside of any, as many
    /// as the machine runs at the same time.
    pub(crate) fn new(threads: Option<usize>) -> Result<Self, SolverError> {
        let pool = Self { own: std::sync::OnceLock::new() };
        if threads.is_some() || rayon::current_thread_index().is_none() {
            pool.start(threads)?;
        }
        Ok(pool)
    }

    /// Does the work on one of the threads, where parallel loops neither allocate nor wait to be let in.
    pub(crate) fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> Result<R, SolverError> {
        match self.own.get() {
            Some(own) => Ok(own.install(work)),
            None if rayon::current_thread_index().is_some() => Ok(work()),
            None => Ok(self.start(None)?.install(work)),
        }
    }

    fn start(&self, threads: Option<usize>) -> Result<&rayon::ThreadPool, SolverError> {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
        let builder = builder.thread_name(|i| format!("fft-bem-solver {i}"));
        let pool = builder.build().map_err(|_| SolverError::BadSetting {
            setting: "threads",
            value: threads.unwrap_or(0) as f64,
            limit: "the system does not grant that many threads",
        })?;
        Ok(self.own.get_or_init(|| pool))
    }
}

#[cfg(any(not(feature = "parallel"), target_family = "wasm"))]
#[expect(clippy::unnecessary_wraps, clippy::unused_self, reason = "as where there are threads")]
impl Pool {
    /// The thread of the caller: WebAssembly has no other.
    pub(crate) fn new(_threads: Option<usize>) -> Result<Self, SolverError> {
        Ok(Self {})
    }

    pub(crate) fn run<R>(&self, work: impl FnOnce() -> R) -> Result<R, SolverError> {
        Ok(work())
    }
}
