//! The partial moments against their definition, and their order.

mod common;
use common::{Worst, relative_error};
use gw_closed_form::partial_moments::{Order, scaled, value};
use std::f64::consts::{PI, TAU};

const ORDERS: [Order; 4] = [Order::Zero, Order::Half, Order::One, Order::ThreeHalves];

/// exp(α²/2) J_n(α) = (2π)^{-1/2} ∫_0^∞ u^n exp(-αu - u²/2) du, by the double-exponential rule
/// u = exp((π/2) sinh t); for α < 0 the factor exp(-α²/2) is taken inside.
fn quadrature(n: f64, alpha: f64) -> f64 {
    let step = 1.0 / 64.0;
    let lead = if alpha < 0.0 { 0.5 * alpha * alpha } else { 0.0 };
    let mut sum = 0.0;
    for k in -320..=320 {
        let t = f64::from(k) * step;
        let u = (0.5 * PI * t.sinh()).exp();
        if !(1e-150..=1e3).contains(&u) {
            continue;
        }
        let gaussian = (-alpha * u - 0.5 * u * u - lead).exp();
        sum += u.powf(n) * gaussian * u * 0.5 * PI * t.cosh() * step;
    }
    sum / TAU.sqrt()
}

#[test]
fn definition() {
    let mut worst = Worst::of("J_n against quadrature");
    for (twice, order) in (0..).zip(ORDERS) {
        for alpha in [-9.3, -4.0, -1.7, -0.67, -0.1, 0.0, 0.3, 1.1, 2.9, 7.6, 8.4, 25.0, 400.0] {
            let direct = quadrature(0.5 * f64::from(twice), alpha);
            let ours = if alpha < 0.0 { value(order, alpha) } else { scaled(order, alpha) };
            worst.see(relative_error(ours, direct), || format!("{order:?} at {alpha}"));
        }
    }
    worst.at_most(2e-13); // the quadrature's exp(α²) rounding
}

/// Neighbouring doubles never come out in the wrong order: half a million pairs for each order and
/// kind of place, anywhere in use, around 0, at every magnitude, and on both sides of every join
/// between two Taylor series.
#[test]
fn falls_to_the_last_bit() {
    for order in ORDERS {
        for k in 0..2_000_000 {
            let u = (f64::from(k) * 0.618_033_988_749_894_9).fract();
            let alpha = match k % 4 {
                0 => -12.0 + 52.0 * u,
                1 => -1.0 + 2.0 * u,
                2 => (600.0 * (2.0 * u).fract() - 300.0).exp2().copysign(u - 0.5),
                _ => {
                    // Nodes are a quarter apart, joins halfway between them.
                    let join = 0.125 * ((160.0 * u).floor() - 82.0);
                    (0..k / 4 % 3).fold(join, |alpha, _| alpha.next_down())
                }
            };
            let (near, far) = (value(order, alpha), value(order, alpha.next_up()));
            assert!(far <= near, "{order:?} at {alpha:e}: {near:e} then {far:e}");
        }
    }
}
