//! Inner loops in versions for several sets of vector instructions, chosen while the program runs.

/// Evaluates an expression in the version for the widest vectors that this processor has.
///
/// The versions differ in how many numbers one instruction handles and in nothing else: each
/// operation and the order of sums are those of the source, so that the results are the same to the
/// last bit. What the expression calls belongs to a version only if it is inlined.
macro_rules! vectorised {
    ($pass:expr) => {
        fearless_simd::dispatch!(fearless_simd::Level::new(), _vectors => $pass)
    };
}
pub(crate) use vectorised;
