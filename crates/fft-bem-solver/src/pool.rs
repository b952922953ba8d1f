//! The threads of a solver.

use crate::SolverError;

/// Threads that belong to one solver alone. Those that rayon shares between all its users are never
/// touched: where they were started, a forked child that asks for them waits for ever.
pub(crate) struct Pool {
    #[cfg(feature = "parallel")]
    own: rayon::ThreadPool,
}

impl Pool {
    /// So many threads; without a number as many as the machine runs at the same time.
    #[cfg(feature = "parallel")]
    pub(crate) fn new(threads: Option<usize>) -> Result<Self, SolverError> {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0));
        let builder = builder.thread_name(|i| format!("fft-bem-solver {i}"));
        let own = builder.build().map_err(|_| SolverError::BadSetting {
            setting: "threads",
            value: threads.unwrap_or(0) as f64,
            limit: "the system does not grant that many threads",
        })?;
        Ok(Self { own })
    }

    #[cfg(not(feature = "parallel"))]
    pub(crate) fn new(_threads: Option<usize>) -> Result<Self, SolverError> {
        Ok(Self {})
    }

    /// Does the work on one of the threads, where parallel loops neither allocate nor wait to be let in.
    pub(crate) fn run<R: Send>(&self, work: impl FnOnce() -> R + Send) -> R {
        #[cfg(feature = "parallel")]
        return self.own.install(work);
        #[cfg(not(feature = "parallel"))]
        work()
    }
}
