//! The fields that a chord iteration works on.

use super::memory::Kind;
use crate::methods::cheap_compliance::CheapCompliance;
use crate::methods::extension::Pyramid;
use crate::methods::extrapolation::Earlier;
use crate::methods::node::Node;
use crate::methods::passes;
use crate::methods::stiffness::Stiffness;
use crate::methods::sweep::Sweep;
use crate::methods::thin_pixels;
use crate::row_work::Partial;
use crate::{HalfSpace, Real};
use contact_types::Grid;

/// Most steps with the cheap compliance before the first trial.
const GUESSES: u8 = 6;

/// The method with its memory: the trial and the iterate before (pressure and displacement each),
/// one field in single precision, the contact set, the pyramid and the coarse grids.
pub(crate) struct Chord<T: Real> {
    pub(super) grid: Grid,
    pub(crate) shape: [usize; 2],
    pub(crate) rows: usize,
    /// Longer over shorter side of a pixel, and of the map.
    pub(super) elongation: f64,
    pub(super) slenderness: f64,
    /// Longer side of the map.
    pub(super) longest: f64,
    pub(crate) nodes: Vec<Node>,
    pub(crate) residual: Vec<f32>,
    pub(crate) pyramid: Pyramid,
    pub(crate) stiffness: Stiffness,
    pub(crate) sweep: Sweep,
    pub(crate) trial: Vec<T>,
    pub(crate) response: Vec<T>,
    pub(crate) before: Vec<T>,
    pub(crate) before_response: Vec<T>,
    pub(crate) partial: Vec<Partial>,
    /// On a load curve.
    pub(super) earlier: Option<Box<Earlier<T>>>,
    /// Once a first trial has been looked for.
    pub(super) cheap: Option<CheapCompliance>,
    /// Most steps with it before the first trial.
    pub(crate) guesses: u8,
    /// Tests: make every step of this kind.
    pub(crate) force: Option<Kind>,
    /// Which fallbacks were taken, and at which iteration.
    pub(crate) events: Vec<(usize, Kind)>,
}

impl<T: Real> Chord<T> {
    /// Memory for a grid whose finer pixel side is 1.
    pub(crate) fn new(scaled: Grid) -> Self {
        let ([_, nx], n) = (scaled.shape(), scaled.len());
        let pyramid = Pyramid::new(scaled.shape(), scaled.pixel());
        let rows = passes::rows_per_task(&pyramid, scaled.shape());
        let pieces = passes::tasks(n, rows, nx).max(HalfSpace::<T>::pieces(scaled.shape()));
        Self {
            grid: scaled,
            shape: scaled.shape(),
            rows,
            elongation: thin_pixels::ratio(scaled),
            slenderness: thin_pixels::ratio_of_sides(scaled),
            longest: (0..2)
                .map(|a| scaled.shape()[a] as f64 * scaled.pixel()[a])
                .fold(1.0, f64::max),
            nodes: vec![Node::Gap; n],
            residual: vec![0.0; n],
            stiffness: Stiffness::new(scaled.shape(), scaled.pixel()),
            sweep: Sweep::new(pyramid.levels.first()),
            pyramid,
            trial: vec![T::zero(); n],
            response: vec![T::zero(); n],
            before: vec![T::zero(); n],
            before_response: vec![T::zero(); n],
            partial: vec![Partial::default(); pieces],
            earlier: None,
            cheap: None,
            guesses: GUESSES,
            force: None,
            events: Vec::new(),
        }
    }
}

/// Room for a field in single precision until the displacement of the trial is computed: its place,
/// or, if that holds the lead, the place of the step before the first.
pub(crate) fn room<'a, T: Real>(
    response: &'a mut [T],
    before_response: &'a mut [T],
    is_lead: bool,
) -> &'a mut [f32] {
    let free = if is_lead { before_response } else { response };
    let n = free.len();
    &mut T::as_single(free)[..n]
}
