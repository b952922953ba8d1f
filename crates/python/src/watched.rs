//! Work on a thread of its own while the calling thread looks out for Ctrl-C.
//!
//! Python tells of a signal on its main thread only, so work that went on there would not hear of it. And
//! the threads that rayon shares between all its users are never started: a forked child would wait for them for ever.

use crate::failure::{Refused, bug};
use contact_compare::Iteration;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How often the calling thread looks up.
const LOOK: Duration = Duration::from_millis(50);

/// How long work that is stopped, and has nothing to lose, is waited for.
const PATIENCE: Duration = Duration::from_millis(400);

/// Stack of the thread (bytes): that of a main thread.
const STACK: usize = 8 << 20;

#[derive(Debug, Clone, Default, IntoPyObject)]
pub(crate) struct News {
    pub(crate) stage: &'static str,
    pub(crate) surface: String,
    pub(crate) index: usize,
    pub(crate) count: usize,
    pub(crate) iteration: usize,
    pub(crate) residual: f64,
    pub(crate) tolerance: f64,
    pub(crate) mean_pressure: Option<f64>,
    pub(crate) area_fraction: Option<f64>,
}

impl News {
    /// An iteration on a load.
    pub(crate) fn iteration(index: usize, count: usize, now: &Iteration<'_>) -> Self {
        Self {
            stage: "iteration",
            index,
            count,
            iteration: now.number,
            residual: now.residual,
            tolerance: now.tolerance,
            ..Self::default()
        }
    }
}

/// The end of the work that talks.
pub(crate) struct Reporter {
    stop: Arc<AtomicBool>,
    to: Sender<News>,
    last: Mutex<Instant>,
}

impl Reporter {
    pub(crate) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// Tells, whatever came just before.
    pub(crate) fn tell(&self, news: News) {
        // Who does not listen any more does not want it.
        let _ = self.to.send(news);
    }

    /// Tells, unless something was told in the last twentieth of a second.
    pub(crate) fn tell_at_times(&self, news: impl FnOnce() -> News) {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.elapsed() >= LOOK {
            *last = Instant::now();
            self.tell(news());
        }
    }
}

/// Does the work on `threads` threads that are its own: what it came to, `None` if it was left behind and ends by itself where
/// it next looks up; and why it was to end before, if it was. `progress` is called with what it tells, on this thread.
///
/// Work that is stopped is waited for if a load was done, which is not to be lost; else for a moment only.
pub(crate) fn watched<T: Send + 'static>(
    py: Python<'_>,
    threads: usize,
    progress: Option<Py<PyAny>>,
    work: impl FnOnce(&Reporter) -> T + Send + 'static,
) -> PyResult<(Option<T>, Option<PyErr>)> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.max(1))
        .stack_size(STACK)
        .build()
        .map_err(|e| bug(&e))?;
    let stop = Arc::new(AtomicBool::new(false));
    let (to, from) = channel();
    let reporter = Reporter { stop: Arc::clone(&stop), to, last: Mutex::new(Instant::now()) };
    let worker = std::thread::Builder::new()
        .spawn(move || pool.install(move || work(&reporter)))
        .map_err(|e| bug(&e))?;
    py.detach(move || {
        let mut stopped: Option<(PyErr, Instant)> = None;
        let mut has_load = false;
        loop {
            let news = match from.recv_timeout(LOOK) {
                Ok(news) => Some(news),
                Err(RecvTimeoutError::Timeout) => None,
                Err(RecvTimeoutError::Disconnected) => break,
            };
            has_load |= news.as_ref().is_some_and(|n| n.stage == "load");
            if let Some((_, since)) = &stopped {
                if !has_load && since.elapsed() > PATIENCE {
                    return Ok((None, stopped.map(|s| s.0)));
                }
                continue;
            }
            let heard = Python::attach(|py| {
                py.check_signals()?;
                match (news, &progress) {
                    (Some(news), Some(told)) => told.call1(py, (news,)).map(drop),
                    _ => Ok(()),
                }
            });
            if let Err(why) = heard {
                stop.store(true, Ordering::Relaxed);
                stopped = Some((why, Instant::now()));
            }
        }
        match worker.join() {
            Ok(value) => Ok((Some(value), stopped.map(|s| s.0))),
            Err(panic) => Err(panicked(panic.as_ref())),
        }
    })
}

pub(crate) fn quietly<T: Send + 'static>(
    py: Python<'_>,
    threads: usize,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (value, stopped_by) = watched(py, threads, None, |_| work())?;
    stopped_by.map_or_else(|| value.ok_or_else(|| bug(&"work without an end")), Err)
}

fn panicked(panic: &(dyn std::any::Any + Send)) -> PyErr {
    let text = panic
        .downcast_ref::<String>()
        .map(String::as_str)
        .or_else(|| panic.downcast_ref::<&str>().copied())
        .unwrap_or("no message");
    Refused::new_err(("panic".to_owned(), text.to_owned(), 3))
}
