//! Gauss-Legendre rules with 2, 4, 8 and 16 nodes.

/// Nodes and weights on [-1, 1]; only the positive half, the rule is symmetric.
type HalfRule = &'static [(f64, f64)];

const RULE_2: HalfRule = &[(0.57735026918962576451, 1.0)];
const RULE_4: HalfRule = &[
    (0.3399810435848562648, 0.65214515486254614263),
    (0.86113631159405257522, 0.34785484513745385737),
];
const RULE_8: HalfRule = &[
    (0.18343464249564980494, 0.36268378337836198297),
    (0.52553240991632898582, 0.31370664587788728734),
    (0.79666647741362673959, 0.22238103445337447054),
    (0.96028985649753623168, 0.10122853629037625915),
];
const RULE_16: HalfRule = &[
    (0.095012509837637440185, 0.18945061045506849629),
    (0.28160355077925891323, 0.18260341504492358887),
    (0.45801677765722738634, 0.16915651939500253819),
    (0.61787624440264374845, 0.14959598881657673208),
    (0.7554044083550030339, 0.12462897125553387205),
    (0.86563120238783174388, 0.09515851168249278481),
    (0.94457502307323257608, 0.062253523938647892863),
    (0.9894009349916499326, 0.027152459411754094852),
];

/// Integral of `f` from `lo` to `hi`. `strength` says how much the integrand changes between
/// them: the relative half width, or a twentieth of the change of its exponent, whichever is
/// larger. The rule is the smallest that is exact to rounding for it (to strength 0.4, the
/// largest that callers use).
pub(crate) fn gauss_legendre(
    lo: f64,
    hi: f64,
    strength: f64,
    mut f: impl FnMut(f64) -> f64,
) -> f64 {
    let rule = match strength {
        s if s < 2e-4 => RULE_2,
        s if s < 1e-2 => RULE_4,
        s if s < 1e-1 => RULE_8,
        _ => RULE_16,
    };
    let (middle, half) = (0.5 * (lo + hi), 0.5 * (hi - lo));
    let sum: f64 = rule
        .iter()
        .map(|&(t, weight)| weight * (f(middle - half * t) + f(middle + half * t)))
        .sum();
    half * sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::close;

    #[test]
    fn every_rule_is_exact_for_its_polynomials() {
        // n nodes integrate x^(2n-1) and x^(2n-2) over [0, 1] exactly.
        for (strength, n) in [(1e-5, 2), (1e-3, 4), (0.05, 8), (0.3, 16)] {
            for power in [2 * n - 2, 2 * n - 1] {
                let got = gauss_legendre(0.0, 1.0, strength, |x| x.powi(power));
                close(got, 1.0 / f64::from(power + 1), 4e-15);
            }
        }
    }
}
