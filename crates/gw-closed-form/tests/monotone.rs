//! Neighbouring doubles never come out in the wrong order.

use gw_closed_form::partial_moments::{Order, value};

/// A fixed sequence of 64-bit numbers (Marsaglia's xorshift, doi:10.18637/jss.v008.i14).
struct Sequence(u64);

impl Sequence {
    fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn uniform(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Half a million pairs for each order and kind of place: anywhere in use, around 0, at every
/// magnitude, and on both sides of every join between two Taylor series.
#[test]
fn falls_to_the_last_bit() {
    let mut random = Sequence(20_091_015);
    for order in Order::ALL {
        for k in 0..2_000_000 {
            let u = random.uniform();
            let alpha = match k % 4 {
                0 => -12.0 + 52.0 * u,
                1 => -1.0 + 2.0 * u,
                2 => (600.0 * u - 300.0).exp2() * if random.bits() & 1 == 0 { 1.0 } else { -1.0 },
                _ => {
                    // Nodes are a quarter apart, joins halfway between them.
                    let mut alpha = 0.125 * ((160.0 * u).floor() - 82.0);
                    for _ in 0..random.bits() % 3 {
                        alpha = alpha.next_down();
                    }
                    alpha
                }
            };
            let (near, far) = (value(order, alpha), value(order, alpha.next_up()));
            assert!(far <= near, "{order:?} at {alpha:e}: {near:e} then {far:e}");
        }
    }
}
