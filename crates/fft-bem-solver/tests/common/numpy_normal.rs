//! The standard normal numbers of `numpy.random.default_rng(1)`: PCG64 and the ziggurat on 256 levels. They agree to
//! 1e-13: numpy keeps the ziggurat as a printed table.

/// PCG XSL RR 128/64 (O'Neill, Harvey Mudd College HMC-CS-2014-0905, 2014).
pub(crate) struct Pcg64 {
    state: u128,
    increment: u128,
}

impl Pcg64 {
    /// `numpy.random.default_rng(1).bit_generator.state`, printed by numpy 2.4.
    pub(crate) const fn numpy_seed_1() -> Self {
        Self {
            state: 0x9c5b_484b_fedb_756c_2a6e_7d6f_320f_bc7e,
            increment: 0x922a_f2da_2645_f895_a198_57b9_5740_937b,
        }
    }

    /// The next 64 bits: a step of the congruential generator, its halves combined and rotated.
    pub(crate) fn next_bits(&mut self) -> u64 {
        const MULTIPLIER: u128 = 0x2360_ed05_1fc6_5da4_4385_df64_9fcc_f645;
        self.state = self.state.wrapping_mul(MULTIPLIER).wrapping_add(self.increment);
        let folded = (self.state >> 64) as u64 ^ self.state as u64;
        folded.rotate_right((self.state >> 122) as u32)
    }

    /// Uniform in 0..1, 53 bits.
    fn uniform(&mut self) -> f64 {
        (self.next_bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
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
            let bits = random.next_bits();
            let level = (bits & 0xff) as usize;
            let place = ((bits >> 9) & 0xf_ffff_ffff_ffff) as f64;
            let sign = if bits >> 8 & 1 == 1 { -1.0 } else { 1.0 };
            let x = place * (self.width[level] / SCALE);
            if place < (self.inner(level) / self.width[level] * SCALE).floor() {
                return sign * x;
            }
            if level == 0 {
                return tail(bits, random);
            }
            let [low, high] = [self.density[level], self.density[level - 1]];
            if low + (high - low) * random.uniform() < (-0.5 * x * x).exp() {
                return sign * x;
            }
        }
    }

    /// How far the density is above the whole box of a level.
    fn inner(&self, level: usize) -> f64 {
        match level {
            0 => TAIL,
            1 => 0.0,
            _ => self.width[level - 1],
        }
    }
}

/// Beyond [`TAIL`] (Marsaglia 1964). Numpy takes the sign from bit 8 of the place, not from the
/// sign bit.
fn tail(bits: u64, random: &mut Pcg64) -> f64 {
    loop {
        let beyond = -(-random.uniform()).ln_1p() / TAIL;
        let other = -(-random.uniform()).ln_1p();
        if 2.0 * other > beyond * beyond {
            return if bits >> 17 & 1 == 1 { -(TAIL + beyond) } else { TAIL + beyond };
        }
    }
}
