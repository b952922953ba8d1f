//! Loops over pieces of fields, on several threads with the feature `parallel`, else on one.
//!
//! `use grid_fft::parallel::prelude::*;` brings `par_chunks`, `par_chunks_mut` and `par_iter_mut`. Without
//! the feature they are the sequential iterators of the standard library, so the same code serves
//! both. A piece is a fixed number of elements whatever the number of threads, and sums are taken
//! piece by piece, so that results do not depend on it.

/// Index of the running thread among those that share the work; 0 outside a pool.
pub fn thread_index() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_thread_index().unwrap_or(0);
    #[cfg(not(feature = "parallel"))]
    0
}

/// How many threads share the work of the code that runs now.
pub fn threads() -> usize {
    #[cfg(feature = "parallel")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "parallel"))]
    1
}

/// Calls `work` with every index below `count`.
pub fn for_each_index(count: usize, work: impl Fn(usize) + Sync + Send) {
    #[cfg(feature = "parallel")]
    {
        use rayon::iter::{IntoParallelIterator, ParallelIterator};
        (0..count).into_par_iter().for_each(work);
    }
    #[cfg(not(feature = "parallel"))]
    (0..count).for_each(work);
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

/// The slice methods of rayon, or the same names run by the standard library on one thread.
pub mod prelude {
    #[cfg(not(feature = "parallel"))]
    pub use super::sequential::SequentialSlice;
    #[cfg(feature = "parallel")]
    pub use rayon::prelude::{
        IndexedParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator,
        ParallelIterator, ParallelSlice, ParallelSliceMut,
    };
}

#[cfg(not(feature = "parallel"))]
mod sequential {
    use std::slice::{Chunks, ChunksMut, IterMut};

    /// Sequential stand-in for `rayon::slice::ParallelSlice` and `IntoParallelRefMutIterator`.
    pub trait SequentialSlice<T> {
        /// `chunks`.
        fn par_chunks(&self, size: usize) -> Chunks<'_, T>;
        /// `chunks_mut`.
        fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T>;
        /// `iter_mut`.
        fn par_iter_mut(&mut self) -> IterMut<'_, T>;
    }

    impl<T> SequentialSlice<T> for [T] {
        fn par_chunks(&self, size: usize) -> Chunks<'_, T> {
            self.chunks(size)
        }
        fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T> {
            self.chunks_mut(size)
        }
        fn par_iter_mut(&mut self) -> IterMut<'_, T> {
            self.iter_mut()
        }
    }
}
