//! The threads of a study.

use crate::Settings;

/// Stack of each (bytes): that of a main thread, as theories run on it that others bring.
const STACK: usize = 8 << 20;

/// Does the work on the threads of the settings, which its solvers share: what does not wait for a solver is done
/// beside it, and no more threads run than were granted. Where there are no threads (WebAssembly), on the caller's.
pub(crate) fn on_threads<R: Send>(settings: &Settings, work: impl FnOnce() -> R + Send) -> R {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(settings.threads.max(1))
        .thread_name(|i| format!("study {i}"))
        .stack_size(STACK)
        .build();
    match pool {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}
