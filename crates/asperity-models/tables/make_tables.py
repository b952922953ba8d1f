"""Makes src/kernel_tables.rs and src/gauss_legendre.rs with mpmath (50 digits).

    python3 crates/asperity-models/tables/make_tables.py
"""
from pathlib import Path
from mpmath import cos, ellipe, ellipk, exp, fsum, hyp1f1, legendre, mp, mpf, pi, polyroots, sinh, cosh, sqrt, tanh, findroot, diff

mp.dps = 50
OUT = Path(__file__).parent.parent / "src"
HEAD = "// Made by tables/make_tables.py (mpmath, 50 digits). Do not edit.\n"


def ellipse(k):
    """u, du/dk, F_A, F_P of an elliptic Hertz contact with axis ratio k = b/a."""
    m = 1 - k * k
    K, E = ellipk(m), ellipe(m)
    num, den = k * k * (K - E), E - k * k * K
    dK = -2 * k * den / (2 * m * k * k)
    dE = -2 * k * (E - K) / (2 * m)
    q = num / den  # curvature ratio kappa_2 / kappa_1
    dq = ((2 * k * (K - E) + k * k * (dK - dE)) - q * (dE - 2 * k * K - k * k * dK)) / den
    return (1 - q) / (1 + q), -2 * dq / (1 + q) ** 2, E / (K * k), sqrt(E) / (K * sqrt(K) * k)


# Tanh-sinh rule on k in (0, 1), shared by all arguments.
RULE = []
step = mpf(1) / 40
for i in range(-180, 181):
    s = i * step
    k = 1 / (1 + exp(-pi * sinh(s)))
    if k < mpf(10) ** -22 or 1 - k < mpf(10) ** -22:
        continue
    u, du, fa, fp = ellipse(k)
    weight = step * pi * cosh(s) * k * (1 - k)
    RULE.append((u, -du * weight * u * (1 - u * u), fa, fp))


def bgt_area(x):
    return fsum(w * fa * exp(-x * u * u) for u, w, fa, fp in RULE)


def bgt_load(x):
    return fsum(w * fp * exp(-x * u * u) for u, w, fa, fp in RULE)


KERNELS = [
    # name, function of x = t^2, leading factor, shift
    ("ELLIPTIC_AREA", bgt_area, "2.0", mpf(2), "1.5", mpf(3) / 2),
    ("ELLIPTIC_LOAD", bgt_load, "PI", pi, "1.65", mpf(165) / 100),
    ("GEOMETRIC_AREA", lambda x: hyp1f1(1, mpf(5) / 2, -x) / 3, "2.0", mpf(2), "1.5", mpf(3) / 2),
    ("GEOMETRIC_LOAD", lambda x: 4 / (7 * pi) * hyp1f1(1, mpf(11) / 4, -x), "PI", pi, "1.75", mpf(7) / 4),
]
COUNT = 56
out = [HEAD + "//! Chebyshev coefficients of the curvature kernels: `W = T(y) / (lead (x + shift))`,"]
out.append("//! `x = t^2`, `y = (x - 14)/(x + 14)`.\n\nuse crate::kernels::Kernel;\nuse std::f64::consts::PI;\n")
for name, f, lead_text, lead, shift_text, shift in KERNELS:
    xs = [cos(pi * (i + mpf(1) / 2) / COUNT) for i in range(COUNT)]
    ys = []
    for y in xs:
        x = 14 * (1 + y) / (1 - y)
        ys.append(f(x) * lead * (x + shift))
    c = [2 * fsum(ys[i] * cos(pi * j * (i + mpf(1) / 2) / COUNT) for i in range(COUNT)) / COUNT for j in range(COUNT)]
    c[0] /= 2
    last = max(j for j in range(COUNT) if abs(c[j]) > mpf(10) ** -17)
    print(name, last, "W(0) =", f(mpf(0)), "truncation", float(abs(c[min(last + 1, COUNT - 1)])))
    out.append(f"pub(crate) static {name}: Kernel = Kernel {{ lead: {lead_text}, shift: {shift_text}, coefficients: &[")
    out += [f"    {float(v)!r}," for v in c[: last + 1]]
    out.append("] };\n")
(OUT / "kernel_tables.rs").write_text("\n".join(out))

rules = [HEAD + "//! Positive half of the Gauss-Legendre rule on [-1, 1]: node, weight.\n"]
for n in (32,):
    rules.append(f"pub(crate) static GAUSS_{n}: [[f64; 2]; {n // 2}] = [")
    for i in range(n // 2):
        x = findroot(lambda v: legendre(n, v), cos(pi * (i + mpf(3) / 4) / (n + mpf(1) / 2)))
        d = n * (x * legendre(n, x) - legendre(n - 1, x)) / (x * x - 1)
        rules.append(f"    [{float(x)!r}, {float(2 / ((1 - x * x) * d * d))!r}],")
    rules.append("];\n")
(OUT / "gauss_legendre.rs").write_text("\n".join(rules))
