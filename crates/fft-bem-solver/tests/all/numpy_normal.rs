//! The standard normal numbers of `numpy.random.default_rng(1)`: PCG64 and the ziggurat on 256 levels. They agree to
//! 1e-13: numpy keeps the ziggurat as a printed table.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng as _;

/// The generator of the seed 1, from `SeedSequence(1).generate_state(4, uint64)`.
pub(crate) fn numpy_seed_1() -> Pcg64 {
    Pcg64::new(0x672d_8ee5_6d67_91ff_8ae1_9ca1_4eb1_072c, 0x4915_796d_1322_fc4a_d0cc_2bdc_aba0_49bd)
}

/// Uniform in 0..1, 53 bits.
fn uniform(random: &mut Pcg64) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// Levels of the ziggurat.
const LEVELS: usize = 256;
/// Where its tail begins.
const TAIL: f64 = 3.654_152_885_361_008_8;
/// Bits of a number within a level.
const SCALE: f64 = (1_u64 << 52) as f64;

/// The half of `exp(-x²/2)` right of 0 covered by 256 pieces of equal area: 255 boxes of width
/// `x[i]`, and at 0 a box with the tail (Marsaglia & Tsang 2000, doi:10.18637/jss.v005.i08).
pub(crate) struct Ziggurat {
    /// Widths of the boxes from level 1 to 255. Level 0 is as wide as a box of its height with its whole area.
    width: [f64; LEVELS],
    /// `exp(-x²/2)` at their right ends; 1 at level 0, for the top of level 1.
    density: [f64; LEVELS],
}

impl Ziggurat {
    /// The widths follow from the lowest upwards: each box has the same area.
    pub(crate) fn new() -> Self {
        let density_at = |x: f64| (-0.5 * x * x).exp();
        // Box and tail of level 0: r f(r) + sqrt(pi/2) erfc(r/sqrt 2).
        let area = 0.004_928_673_233_974_655;
        let (mut width, mut density) = ([0.0; LEVELS], [1.0; LEVELS]);
        (width[LEVELS - 1], density[LEVELS - 1]) = (TAIL, density_at(TAIL));
        for i in (1..LEVELS - 1).rev() {
            let top = area / width[i + 1] + density[i + 1];
            width[i] = (-2.0 * top.ln()).sqrt();
            density[i] = density_at(width[i]);
        }
        width[0] = area / density[LEVELS - 1];
        Self { width, density }
    }

    /// The next standard normal number, `Generator.standard_normal()`.
    pub(crate) fn normal(&self, random: &mut Pcg64) -> f64 {
        loop {
            // From the lowest bit: 8 of the level, 1 of the sign, 52 of the place in the level.
            let bits = random.next_u64();
            let level = (bits & 0xff) as usize;
            let place = ((bits >> 9) & 0xf_ffff_ffff_ffff) as f64;
            let sign = if bits >> 8 & 1 == 1 { -1.0 } else { 1.0 };
            let x = place * (self.width[level] / SCALE);
            // How far the density is above the whole box.
            let inner = match level {
                0 => TAIL,
                1 => 0.0,
                _ => self.width[level - 1],
            };
            if place < (inner / self.width[level] * SCALE).floor() {
                return sign * x;
            }
            if level == 0 {
                return tail(bits, random);
            }
            let [low, high] = [self.density[level], self.density[level - 1]];
            if low + (high - low) * uniform(random) < (-0.5 * x * x).exp() {
                return sign * x;
            }
        }
    }
}

/// Beyond [`TAIL`] (Marsaglia 1964). Numpy takes the sign from bit 8 of the place, not from the
/// sign bit.
fn tail(bits: u64, random: &mut Pcg64) -> f64 {
    loop {
        let beyond = -(-uniform(random)).ln_1p() / TAIL;
        let other = -(-uniform(random)).ln_1p();
        if 2.0 * other > beyond * beyond {
            return if bits >> 17 & 1 == 1 { -(TAIL + beyond) } else { TAIL + beyond };
        }
    }
}
