//! What a map tells of the part of it that touches.

/// Levels of the curves over the highest part.
pub const CURVE_LEVELS: usize = 23;
/// Shares of the map of [`ContactCurves::flattened`].
pub const CURVE_SHARES: usize = 20;

/// A curve over the highest parts `2^(-k/2)` of a map, k = 0 to 22: from all of it to the highest 1/2048.
pub type PartCurve = [f64; CURVE_LEVELS];

/// How steep, how curved and how much pressed the highest parts of a map are, and the distribution of the pressure that
/// presses all of it flat. All without units.
///
/// The square of the gradient at a point is the mean over its neighbours along each axis, by single
/// differences; g² is its mean over the map. By central differences, from neighbour to neighbour, it is less where
/// waves or crests are narrower than a few points. Curvature is positive on a summit; second differences take the neighbours of
/// a point, at an open edge those of the next point inside. The full-contact pressure is E\* |q| h(q)/2 for
/// each wave of the map as it repeats (Johnson, *Contact Mechanics*, 1985, section 13.2), of mean 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactCurves {
    /// Rms gradient of the part over that of the map, by central differences: 1 at all levels for a Gaussian surface
    /// without end, below 1 where summits are smoother than flanks and valleys.
    pub slope: PartCurve,
    /// Mean gradient over rms gradient, both of the part: (π/4)^½ for an isotropic Gaussian surface, less where
    /// flat places lie between steep ones.
    pub evenness: PartCurve,
    /// Rms gradient by central differences over that by single ones, both of the part: 1 where the points are dense
    /// to its waves, towards 0 where its crests lie between two points.
    pub resolved: PartCurve,
    /// Mean full-contact pressure of the part over E\* g.
    pub pressure: PartCurve,
    /// Mean over rms full-contact pressure, both of the part.
    pub pressure_evenness: PartCurve,
    /// Share of the part whose full-contact pressure is positive: that would not be let go.
    pub pressed: PartCurve,
    /// Rms gradient there over that of the map, by central differences; where there is hardly any such point, towards 1.
    pub pressed_slope: PartCurve,
    /// Mean over rms curvature, sum of both directions, both of the part: towards 1 where all of it is alike round,
    /// near 0 where it is as often hollow.
    pub curvature_evenness: PartCurve,
    /// Rms difference of the principal curvatures over the rms of their sum, both of the part: 0 on a ball, 1 on a ridge,
    /// above on saddles.
    pub curvature_difference: PartCurve,
    /// Mean product of the principal curvatures over the mean square of their sum, both of the part: 1/4 on a ball, 0 on a
    /// ridge, below 0 on saddles.
    pub curvature_product: PartCurve,
    /// Share of the part whose neighbours are all as high as it: 0 of a smooth map, much where heights come in few steps.
    pub level: PartCurve,
    /// Quantiles of the size of the full-contact pressure over E\* g, at the shares (k + ½)/20 of the map.
    pub flattened: [f64; CURVE_SHARES],
}
