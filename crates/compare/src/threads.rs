//! The threads of a study.

/// Stack of each (bytes): that of a main thread, as theories run on it that others bring.
const STACK: usize = 8 << 20;

/// Does the work on so many threads, which the solvers of a study share: what does not wait for a solver is done
/// beside it, and no more threads run than were granted. They are those that the caller is on, if it is on so many;
/// where there are none (WebAssembly), the caller's own. A study, the looks around it and its documents within one
/// such call start threads once.
pub fn on_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    let threads = threads.max(1);
    if rayon::current_thread_index().is_some() && rayon::current_num_threads() == threads {
        return work();
    }
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .thread_name(|i| format!("study {i}"))
        .stack_size(STACK)
        .build();
    match pool {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}
