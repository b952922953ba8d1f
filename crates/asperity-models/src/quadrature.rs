//! The one integral of these models, over the summit curvature t:
//!
//! ```math
//! \int_0^\infty f(t)\, \varphi(t)\, s^n J_n\!\left(\frac{h - \rho t}{s}\right) dt
//! ```
//!
//! For h > 0 everything is measured in units of exp(-h²/2), which is where the answer lies: with
//! z = (h - ρt)/s and u = (t - ρh)/s,
//!
//! ```math
//! \varphi(t)\, J_n(z) = \tfrac{1}{\sqrt{2\pi}}\, e^{-h^2/2}\, e^{-u^2/2} \left[e^{z^2/2} J_n(z)\right]
//!                     = \tfrac{1}{\sqrt{2\pi}}\, e^{-h^2/2}\, e^{(h-t)(h+t)/2} J_n(z)
//! ```
//!
//! The first form serves summits below the flat on average (z large), the second the others.
//! Nothing underflows, whatever h.

use crate::gauss_legendre::GAUSS_32;
use gw_closed_form::partial_moments::{self, Order};

/// How summit height and curvature hang together: given the curvature t, heights (in units of σ)
/// have mean ρt and deviation s, ρ² + s² = 1, ρ² = 3/(2 bandwidth).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Correlation {
    pub(crate) rho: f64,
    pub(crate) s: f64,
}

/// One node of the rule: summits of curvature t and the overlap of their heights with the flat.
pub(crate) struct Summit {
    pub(crate) t: f64,
    s: f64,
    z: f64,
    /// Mean height above the flat, ρt - h.
    depth: f64,
    /// The Gaussian exp(-z²/2) is in the weight already.
    scaled: bool,
}

impl Summit {
    /// s^n J_n(z): mean n-th power of the overlap.
    pub(crate) fn overlap(&self, order: Order) -> f64 {
        let (width, z) = if self.z < SHARP {
            (self.depth, -1.0) // heights are as good as equal: (ρt - h)^n
        } else {
            (self.s, self.z)
        };
        let power = match order {
            Order::Zero => 1.0,
            Order::Half => width.sqrt(),
            Order::One => width,
            Order::ThreeHalves => width * width.sqrt(),
        };
        if self.z < SHARP {
            power
        } else if self.scaled {
            power * partial_moments::scaled(order, z)
        } else {
            power * partial_moments::value(order, z)
        }
    }
}

/// Below this z the spread of heights changes the overlap by less than rounding.
const SHARP: f64 = -1e9;
/// Half-width of the window in standard deviations: exp(-50) of the peak is left out.
const REACH: f64 = 10.0;
/// Widest panel in t; two standard deviations and a half, for 32 nodes.
const WIDEST: f64 = 2.5;

/// Where t is measured from, so that z and u come without cancellation.
#[derive(Clone, Copy, PartialEq)]
enum CurvatureFrame {
    /// From ρh, in units of s: few summits reach the flat.
    Tail,
    /// From c = h/ρ, where the mean summit of that curvature touches the flat.
    Touch,
    /// From 0.
    Plain,
}

impl Correlation {
    /// Sums `f` over the rule. The result is in units of exp(-h²/2) for h > 0.
    pub(crate) fn integrate<const N: usize>(
        self,
        h: f64,
        f: impl Fn(&Summit) -> [f64; N],
    ) -> [f64; N] {
        let Self { rho, s } = self;
        let frame = if h > 0.0 && h * s >= REACH * rho {
            CurvatureFrame::Tail
        } else if h > 0.0 && rho >= 0.5 {
            CurvatureFrame::Touch
        } else {
            CurvatureFrame::Plain
        };
        // Frame coordinate of t = 0.
        let origin = match frame {
            CurvatureFrame::Tail => -rho * h / s,
            CurvatureFrame::Touch if s > 0.0 => -h / rho,
            _ => 0.0, // for s = 0 there is one height per curvature: contact begins at c
        };
        let mut sum = [0.0; N];
        for [from, to] in self.breaks(frame, h).panels() {
            // Around an end where powers are fractional the variable is the square root.
            let root = from <= origin;
            let (low, high) = if root { (0.0, (to - from).sqrt()) } else { (from, to) };
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            for &[x, w] in &GAUSS_32 {
                for x in [-x, x] {
                    let y = middle + half * x;
                    let (at, jacobian) = if root { (from + y * y, 2.0 * y) } else { (y, 1.0) };
                    let (summit, weight) = self.summit(frame, h, at);
                    let values = f(&summit);
                    let weight = weight * w * half * jacobian;
                    for (total, value) in sum.iter_mut().zip(values) {
                        *total += weight * value;
                    }
                }
            }
        }
        sum
    }

    /// Node at frame coordinate `y`, with its Gaussian weight.
    fn summit(self, frame: CurvatureFrame, h: f64, y: f64) -> (Summit, f64) {
        let Self { rho, s } = self;
        let (t, z, u, depth, above, step) = match frame {
            CurvatureFrame::Tail => ((rho * h + s * y).max(0.0), h * s - rho * y, y, 0.0, 0.0, s),
            CurvatureFrame::Touch => {
                let t = (h / rho + y).max(0.0);
                // t - h without cancellation: c - h = h (1 - ρ)/ρ and 1 - ρ = s²/(1 + ρ)
                let above = h * (s / rho) * (s / (1.0 + rho)) + y;
                (t, -rho * y / s, h * s / rho + y / s, rho * y, above, 1.0)
            }
            CurvatureFrame::Plain => {
                let depth = rho * y - h;
                (y, -depth / s, (y - rho * h) / s, depth, y - h, 1.0)
            }
        };
        let scaled = frame == CurvatureFrame::Tail || h > 0.0 && z >= 8.0;
        let exponent = if scaled {
            -0.5 * u * u
        } else if h > 0.0 {
            -0.5 * above * (h + t)
        } else {
            -0.5 * t * t
        };
        let summit = Summit { t, s, z, depth, scaled };
        (summit, exponent.exp() * step * FRAC_1_SQRT_2PI)
    }

    /// Where panels must end, in frame coordinates.
    fn breaks(self, frame: CurvatureFrame, h: f64) -> Breaks {
        let Self { rho, s } = self;
        let (low, high, touch) = match frame {
            CurvatureFrame::Tail => ((-rho * h / s).max(-REACH), REACH, None),
            CurvatureFrame::Touch => {
                let c = h / rho;
                let low = if s > 0.0 { (-h * s * s / rho - REACH * s).max(-c) } else { 0.0 };
                let lag = h * s / rho;
                let to_tail = (REACH * REACH - lag * lag) / ((h * h + REACH * REACH).sqrt() + c);
                (low, to_tail.max(REACH * s - h * s * s / rho), Some(0.0))
            }
            CurvatureFrame::Plain if h > 0.0 => {
                let low = (rho * h - REACH * s).max(0.0);
                (low, (h * h + REACH * REACH).sqrt(), Some(h / rho))
            }
            CurvatureFrame::Plain => (0.0, REACH, None),
        };
        let mut breaks = Breaks { at: [0.0; MOST_BREAKS], count: 2 };
        breaks.at[..2].copy_from_slice(&[low, high]);
        if let Some(touch) = touch {
            // Overlap powers have their bend at `touch`, as sharp as w: panels grow away from it.
            let mut offset = 4.0 * s / rho;
            while offset > 0.0 && offset < high - low {
                for at in [touch - offset, touch + offset] {
                    if low < at && at < high {
                        breaks.at[breaks.count] = at;
                        breaks.count += 1;
                    }
                }
                offset *= 8.0;
            }
        }
        breaks.at[..breaks.count].sort_unstable_by(f64::total_cmp);
        breaks
    }
}

/// Most breaks there can be: s > 0 is at least 1e-8, so that its offsets reach the width of the
/// window, 30 at most, in eleven steps of 8.
const MOST_BREAKS: usize = 32;

/// Ends of panels. An array, because a question to a model allocates nothing.
struct Breaks {
    at: [f64; MOST_BREAKS],
    count: usize,
}

impl Breaks {
    /// The panels `[from, to]` between the breaks, none wider than `WIDEST` or a quarter of all.
    fn panels(&self) -> impl Iterator<Item = [f64; 2]> {
        let ends = &self.at[..self.count];
        let widest = WIDEST.min(0.25 * (ends[self.count - 1] - ends[0]));
        ends.windows(2).flat_map(move |pair| {
            let (from, width) = (pair[0], pair[1] - pair[0]);
            let parts = (width / widest).ceil().max(1.0) as u32;
            let end = move |k| match k {
                k if k == parts => pair[1],
                k => from + width * f64::from(k) / f64::from(parts),
            };
            (0..parts).map(move |k| [end(k), end(k + 1)])
        })
    }
}

/// 1/√(2π).
pub(crate) const FRAC_1_SQRT_2PI: f64 = 0.398_942_280_401_432_7;
