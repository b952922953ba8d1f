//! Loops over pieces of fields, on several threads with the feature `parallel`, else on one.
//!
//! `use grid_fft::parallel::prelude::*;` brings `par_chunks`, `par_chunks_mut` and `par_iter_mut`, with `zip`,
//! `enumerate` and `for_each` of what they give. A piece is a fixed number of elements whatever the number of threads,
//! and sums are taken piece by piece, so that results do not depend on it.
//!
//! The loops are those of rayon in all but one thing: what is done with a piece is called through a reference, so that
//! the code that shares work between threads is compiled for each kind of pieces and not for each loop.

use std::ops::Range;

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
    join_told(|_| a(), |_| b())
}

/// The same, each told whether another thread took it.
fn join_told<A: Send, B: Send>(
    a: impl FnOnce(bool) -> A + Send,
    b: impl FnOnce(bool) -> B + Send,
) -> (A, B) {
    let (mut a, mut b) = (Some(a), Some(b));
    let (mut from_a, mut from_b) = (None, None);
    both(&mut |is_taken| from_a = a.take().map(|a| a(is_taken)), &mut |is_taken| {
        from_b = b.take().map(|b| b(is_taken));
    });
    from_a.zip(from_b).expect("both were called")
}

type Told<'a> = &'a mut (dyn FnMut(bool) + Send);

fn both(a: Told<'_>, b: Told<'_>) {
    #[cfg(feature = "parallel")]
    rayon::join_context(|context| a(context.migrated()), |context| b(context.migrated()));
    #[cfg(not(feature = "parallel"))]
    let ((), ()) = (a(false), b(false));
}

/// What `make` makes of each item, in order.
pub fn map<T: Sync, R: Send>(items: &[T], make: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let mut made: Vec<(&T, Option<R>)> = items.iter().map(|item| (item, None)).collect();
    made.as_mut_slice().for_each(|(item, made)| *made = Some(make(item)));
    made.into_iter().filter_map(|(_, made)| made).collect()
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

/// What is cut into pieces.
pub mod prelude {
    pub use super::{Pieces, Slice};
}

/// Pieces, in order.
pub trait Pieces: IntoIterator + Sized + Send {
    /// How many there are.
    fn count(&self) -> usize;

    /// The first `count` of them, and the others.
    fn split(self, count: usize) -> (Self, Self);

    /// Pieces of both, as long as there are some.
    fn zip<P: Pieces>(self, other: P) -> impl Pieces<Item = (Self::Item, P::Item)> {
        Zip(self, other)
    }

    /// With the index of each.
    fn enumerate(self) -> impl Pieces<Item = (usize, Self::Item)> {
        Zip(0..self.count(), self)
    }

    /// Calls `work` with each.
    fn for_each(self, work: impl Fn(Self::Item) + Sync) {
        share(self, threads(), &work);
    }
}

/// Halves the pieces as long as halves are wanted: as many times as there are threads, and again by each that takes one.
fn share<P: Pieces>(pieces: P, halves: usize, work: &(dyn Fn(P::Item) + Sync)) {
    let count = pieces.count();
    if halves == 0 || count < 2 {
        return pieces.into_iter().for_each(work);
    }
    let (a, b) = pieces.split(count / 2);
    let half = |pieces, is_taken| {
        share(pieces, if is_taken { threads() } else { halves / 2 }, work);
    };
    join_told(|is_taken| half(a, is_taken), |is_taken| half(b, is_taken));
}

impl Pieces for Range<usize> {
    fn count(&self) -> usize {
        self.len()
    }
    fn split(self, count: usize) -> (Self, Self) {
        let middle = self.start + count;
        (self.start..middle, middle..self.end)
    }
}

/// Pieces of two, as long as both have some.
struct Zip<A, B>(A, B);

impl<A: IntoIterator, B: IntoIterator> IntoIterator for Zip<A, B> {
    type Item = (A::Item, B::Item);
    type IntoIter = std::iter::Zip<A::IntoIter, B::IntoIter>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter().zip(self.1)
    }
}

impl<A: Pieces, B: Pieces> Pieces for Zip<A, B> {
    fn count(&self) -> usize {
        self.0.count().min(self.1.count())
    }
    fn split(self, count: usize) -> (Self, Self) {
        let ((a, after_a), (b, after_b)) = (self.0.split(count), self.1.split(count));
        (Self(a, b), Self(after_a, after_b))
    }
}

/// Slices of so many elements, the last of what is left.
struct Chunks<S>(S, usize);

impl<'a, T> IntoIterator for Chunks<&'a [T]> {
    type Item = &'a [T];
    type IntoIter = std::slice::Chunks<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.chunks(self.1)
    }
}

impl<T: Sync> Pieces for Chunks<&[T]> {
    fn count(&self) -> usize {
        self.0.len().div_ceil(self.1)
    }
    fn split(self, count: usize) -> (Self, Self) {
        let (a, b) = self.0.split_at((count * self.1).min(self.0.len()));
        (Self(a, self.1), Self(b, self.1))
    }
}

impl<'a, T> IntoIterator for Chunks<&'a mut [T]> {
    type Item = &'a mut [T];
    type IntoIter = std::slice::ChunksMut<'a, T>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.chunks_mut(self.1)
    }
}

impl<T: Send> Pieces for Chunks<&mut [T]> {
    fn count(&self) -> usize {
        self.0.len().div_ceil(self.1)
    }
    fn split(self, count: usize) -> (Self, Self) {
        let (a, b) = self.0.split_at_mut((count * self.1).min(self.0.len()));
        (Self(a, self.1), Self(b, self.1))
    }
}

/// Single elements.
impl<T: Send> Pieces for &mut [T] {
    fn count(&self) -> usize {
        self.len()
    }
    fn split(self, count: usize) -> (Self, Self) {
        self.split_at_mut(count)
    }
}

/// Pieces of a slice.
pub trait Slice<T> {
    /// Of `size` elements each, the last of what is left.
    fn par_chunks<'a>(&'a self, size: usize) -> impl Pieces<Item = &'a [T]>
    where
        T: Sync + 'a;
    /// The same, to be written.
    fn par_chunks_mut<'a>(&'a mut self, size: usize) -> impl Pieces<Item = &'a mut [T]>
    where
        T: Send + 'a;
    /// Every element, to be written.
    fn par_iter_mut(&mut self) -> &mut [T];
}

impl<T> Slice<T> for [T] {
    fn par_chunks<'a>(&'a self, size: usize) -> impl Pieces<Item = &'a [T]>
    where
        T: Sync + 'a,
    {
        Chunks(self, size)
    }
    fn par_chunks_mut<'a>(&'a mut self, size: usize) -> impl Pieces<Item = &'a mut [T]>
    where
        T: Send + 'a,
    {
        Chunks(self, size)
    }
    fn par_iter_mut(&mut self) -> &mut [T] {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::prelude::*;

    #[test]
    fn every_piece_is_met_once_with_its_index() {
        for (length, size) in [(0, 3), (1, 3), (7, 3), (64, 1), (1000, 7)] {
            let from: Vec<usize> = (0..length).collect();
            let mut to = vec![usize::MAX; length];
            let mut sums = vec![0; length.div_ceil(size) + 2];
            let pieces = to.par_chunks_mut(size).zip(from.par_chunks(size));
            pieces.zip(sums.par_iter_mut()).enumerate().for_each(|(k, ((to, from), sum))| {
                assert_eq!(from.first(), Some(&(k * size)));
                to.copy_from_slice(from);
                *sum = from.iter().sum::<usize>();
            });
            assert_eq!(to, from);
            assert_eq!(sums.iter().sum::<usize>(), from.iter().sum::<usize>());
        }
    }
}
