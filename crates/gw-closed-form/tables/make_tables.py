"""Makes src/partial_moments/nodes.rs and far_field.rs with mpmath (60 digits).

J_n(alpha) = Gamma(n+1)/sqrt(2 pi) exp(-alpha^2/4) U(n + 1/2, alpha), U the parabolic cylinder function.

    python3 crates/gw-closed-form/tables/make_tables.py
"""
from pathlib import Path
from mpmath import mp, mpf, cos, exp, findroot, fsum, gamma, nstr, pcfu, pi, sqrt

mp.dps = 60
ORDERS = [
    ("ZERO", mpf(0)),
    ("HALF", mpf(1) / 2),
    ("ONE", mpf(1)),
    ("THREE_HALVES", mpf(3) / 2),
]
FAR = 8  # from here on exp(alpha^2/2) J_n is a polynomial in 64/alpha^2
OUT = Path(__file__).parent.parent / "src" / "partial_moments"
HEAD = "// Made by tables/make_tables.py (mpmath, 60 digits). Do not edit.\n//! "


def j(n, a):
    return gamma(n + 1) / sqrt(2 * pi) * exp(-a * a / 4) * pcfu(n + mpf(1) / 2, a)


def slope(n, a):
    if n == 0:
        return -exp(-a * a / 2) / sqrt(2 * pi)
    return -n * j(n - 1, a)


def double(x):
    return repr(float(x))


def split(x):
    hi = mpf(float(x))
    return double(hi), double(x - hi)


nodes = [HEAD + "Value, its rounding error, and slope of `J_n` every quarter from -10, of `J_0` from 0, to 8.\n"]
nodes.append("pub(super) type Node = [f64; 3];\n")
roots = []
for name, n in ORDERS:
    first = 0 if n == 0 else -10
    nodes.append(f"pub(super) static {name}: [Node; {4 * (FAR - first) + 1}] = [")
    for k in range(4 * first, 4 * FAR + 1):
        a = mpf(k) / 4
        hi, lo = split(j(n, a))
        nodes.append(f"    [{hi}, {lo}, {double(slope(n, a))}],")
    nodes.append("];\n")
    if n > 0:
        root = findroot(lambda a: j(n, a) - 1, -mpf(2) / 3)
        hi, lo = split(root)
        roots.append(f"pub(super) const UNITY_{name}: Node = [{hi}, {lo}, {double(slope(n, root))}];")
nodes.append("// Where `J_n` = 1: argument, its rounding error, and slope of `J_n` there.")
nodes += roots
(OUT / "nodes.rs").write_text("\n".join(nodes) + "\n")


def chebyshev(f, count=40):
    x = [cos(pi * (k + mpf(1) / 2) / count) for k in range(count)]
    y = [f(v) for v in x]
    c = [2 * fsum(y[k] * cos(pi * i * (k + mpf(1) / 2) / count) for k in range(count)) / count for i in range(count)]
    c[0] /= 2
    return c


far = [HEAD + "Chebyshev coefficients in `w = 2 (8/alpha)^2 - 1` of `g`, where"]
far.append("//! `exp(alpha^2/2) J_n(alpha) = Gamma(n+1)/sqrt(2 pi) g(w) / alpha^(n+1)` for `alpha >= 8`.\n")
for name, n in ORDERS:
    def g(v):
        w = (v + 1) / 2
        a = FAR / sqrt(w)
        return exp(a * a / 2) * j(n, a) * a ** (n + 1) * sqrt(2 * pi) / gamma(n + 1)

    c = [x for x in chebyshev(g) if abs(x) > mpf(10) ** -18]
    far.append(f"pub(super) static {name}: [f64; {len(c)}] = [")
    far += [f"    {double(x)}," for x in c]
    far.append("];\n")
(OUT / "far_field.rs").write_text("\n".join(far))
