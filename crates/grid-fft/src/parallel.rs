//! Loops over pieces of fields, on several threads with the feature `parallel`, else on one.
//!
//! `use grid_fft::parallel::prelude::*;` brings `par_chunks`, `par_chunks_mut` and `par_iter_mut` of slices, with
//! `zip`, `enumerate` and `for_each` of what they give. A piece is a fixed number of elements whatever the number of
//! threads, and sums are taken piece by piece, so that results do not depend on it.

/// Index of the running thread among those that share the work; 0 outside a pool.
pub(crate) fn thread_index() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_thread_index().unwrap_or(0);
    #[cfg(not(feature = "parallel"))]
    0
}

/// How many threads share the work of the code that runs now.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    1
}

/// Calls both functions, at the same time if a thread is free.
pub fn join<A: Send, B: Send>(
    a: impl FnOnce() -> A + Send,
    b: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "parallel")]
    return rayon::join(a, b);
    #[cfg(not(feature = "parallel"))]
    (a(), b())
}

/// What `make` makes of each item, in order.
pub fn map<T: Sync, R: Send>(items: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    use prelude::*;
    let mut made: Vec<Option<R>> = items.iter().map(|_| None).collect();
    made.par_iter_mut().enumerate().for_each(|(i, made)| *made = Some(make(&items[i])));
    made.into_iter().flatten().collect()
}

/// Does the work on so many threads: those that the caller is on, if it is on so many; where there are none
/// (WebAssembly, without the feature `parallel`), the caller's own. Their stacks are as large as that of a main thread.
pub fn on_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    #[cfg(feature = "parallel")]
    if rayon::current_thread_index().is_none() || rayon::current_num_threads() != threads.max(1) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.max(1));
        if let Ok(pool) = pool.thread_name(|i| format!("study {i}")).stack_size(8 << 20).build() {
            return pool.install(work);
        }
    }
    #[cfg(not(feature = "parallel"))]
    let _ = threads;
    work()
}

/// Pieces of slices, and what is done with them.
#[cfg(feature = "parallel")]
pub mod prelude {
    pub use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator};
    pub use rayon::slice::{ParallelSlice, ParallelSliceMut};

    /// Pieces, in order.
    pub trait Pieces: IndexedParallelIterator {
        /// Calls `work` with each. Through a reference, so that the code that shares work between threads is
        /// compiled for each kind of pieces and not for each loop.
        fn for_each(self, work: impl Fn(Self::Item) + Sync) {
            let work: &(dyn Fn(Self::Item) + Sync) = &work;
            rayon::iter::ParallelIterator::for_each(self, work);
        }
    }

    impl<P: IndexedParallelIterator> Pieces for P {}
}

/// Pieces of slices, one after the other.
#[cfg(not(feature = "parallel"))]
pub mod prelude {
    /// Pieces of a slice.
    pub trait Slice<T> {
        /// Of `size` elements each, the last of what is left.
        fn par_chunks(&self, size: usize) -> std::slice::Chunks<'_, T>;
        /// The same, to be written.
        fn par_chunks_mut(&mut self, size: usize) -> std::slice::ChunksMut<'_, T>;
        /// Every element, to be written.
        fn par_iter_mut(&mut self) -> std::slice::IterMut<'_, T>;
    }

    impl<T> Slice<T> for [T] {
        fn par_chunks(&self, size: usize) -> std::slice::Chunks<'_, T> {
            self.chunks(size)
        }
        fn par_chunks_mut(&mut self, size: usize) -> std::slice::ChunksMut<'_, T> {
            self.chunks_mut(size)
        }
        fn par_iter_mut(&mut self) -> std::slice::IterMut<'_, T> {
            self.iter_mut()
        }
    }
}
