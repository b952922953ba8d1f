"""Makes fixtures/reference/gw_*.csv and extremes_gw.csv with mpmath (60 digits, 22 printed).

Independent of the crate: J_n from mpmath's parabolic cylinder function U, or for |alpha| > 30 from
its expansions summed in 60 digits.

    python3 crates/gw-closed-form/tables/make_reference.py
"""
import random
from pathlib import Path
from mpmath import erfc, exp, findroot, gamma, log, log1p, mp, mpf, nstr, pcfu, pi, sqrt

mp.dps = 60
OUT = Path(__file__).parents[3] / "fixtures" / "reference"
ORIGIN = "# Made by crates/gw-closed-form/tables/make_reference.py: mpmath, 60 digits; alpha is that exact double"
HALF = mpf(1) / 2
ORDERS = [mpf(0), HALF, mpf(1), 3 * HALF]


def scaled(n, a):
    """exp(a^2/2) J_n(a)."""
    c = gamma(n + 1) / sqrt(2 * pi)
    if a > 1e4:
        total, term, k = mpf(0), mpf(1), 0
        while abs(term) > mpf(10) ** -58:
            total += term
            term *= -(n + 1 + 2 * k) * (n + 2 + 2 * k) / (2 * (k + 1) * a * a)
            k += 1
        return c * total / a ** (n + 1)
    if a < -30:
        return j(n, a) * exp(a * a / 2)
    return c * exp(a * a / 4) * pcfu(n + HALF, a)


def j(n, a):
    if a < -30:
        if n in (0, 1):
            return 1 - j(0, -a) if n == 0 else -a + j(1, -a)
        total, term, k = mpf(0), mpf(1), 0
        while abs(term) > mpf(10) ** -58:
            total += term
            m = 2 * k - n
            term *= m * (m + 1) / ((k + 1) * 2 * a * a)
            k += 1
        return (-a) ** n * total
    return exp(-a * a / 2) * scaled(n, a)


def ln(n, a):
    if n == 0 and a < -5:
        return log1p(-j(0, -a))
    return log(scaled(n, a)) - a * a / 2 if a > 0 else log(j(n, a))


def slope(n, a):
    return -exp(-a * a / 2) / sqrt(2 * pi) if n == 0 else -n * j(n - 1, a)


def ln_slope(n, a):
    return -1 / (sqrt(2 * pi) * scaled(n, a)) if n == 0 else -n * scaled(n - 1, a) / scaled(n, a)


def write(name, header, rows, origin=ORIGIN):
    lines = [origin, ",".join(header)]
    lines += [",".join(x if isinstance(x, str) else nstr(x, 22, strip_zeros=True) for x in r) for r in rows]
    (OUT / name).write_text("\n".join(lines) + "\n")


def ln_slope_any(n, a):
    if a < -1e4:  # the scaled functions overflow even mpmath's patience
        return slope(n, a) / j(n, a)
    return ln_slope(n, a)


random.seed(20091)
alphas = [float(k) for k in range(-40, 42, 4)]
alphas += [s * x for x in (1e-300, 1e-12, 1e-5, 0.01, 0.25, 0.5, 0.75, 1.0, 1.5, 2.5, 3.5, 5.0) for s in (-1, 1)]
alphas += [37.0, 37.25, 38.25, 50.0, 100.0, 1000.0, -100.0, -1000.0, 1e8, -1e8, 1e100, -1e100, 1e150]
alphas += [random.uniform(-11, 9) for _ in range(40)] + [random.uniform(-45, 39) for _ in range(20)]
alphas += [-0.67, -0.6697, -1.2, -0.9, -0.29]  # logarithms near zero
rows = []
for a in sorted(alphas):
    for n in ORDERS:
        x = mpf(a)
        g = scaled(n, x) if x > -1e4 else mpf(10) ** 400
        rows.append([nstr(n, 3), repr(a), j(n, x), g, ln(n, x), ln_slope_any(n, x)])
write("gw_partial_moments.csv", ["n", "alpha", "value", "scaled", "ln", "ln_derivative"], rows)


def solve(n, target_ln):
    if target_ln > 60:
        y = exp(target_ln / n)
        return findroot(lambda a: ln(n, a) - target_ln, (-y, -y * (1 - mpf(10) ** -20)), tol=mpf(10) ** -70) if y < 1e20 else -y
    t = target_ln
    start = sqrt(max(mpf(1) / 4, -2 * t - 2)) if t < -2 else -HALF - t / 2
    if t > 3:
        start = -exp(t / n)
    a = start
    for _ in range(60):
        step = (ln(n, a) - t) / ln_slope_any(n, a)
        a -= step
        if abs(step) < mpf(10) ** -45 * max(1, abs(a)):
            return a
    raise ValueError(t)


rows = []
loads = ["1e-307", "1e-300", "1e-200", "1e-100", "1e-50", "1e-20", "1e-10", "1e-6", "1e-4", "1e-3", "0.01", "0.1"]
loads += ["0.3", "0.43", "0.5", "1", "2", "5", "10", "100", "1e4", "1e8", "1e50", "1e300"]
loads += [repr(10 ** random.uniform(-12, 12)) for _ in range(30)]
for text in loads:
    p = mpf(float(text))
    rows.append(["load", text, solve(3 * HALF, log(p))])
for text in ["-1e300", "-1e5", "-2000", "-745", "-3.5", "-1", "0.5", "20", "700", "1000"]:
    t = mpf(float(text))
    if t < -1e6:
        # ln J = -a^2/2 - (5/2) ln a + ln(Gamma(5/2)/sqrt(2 pi)): the rest is far below 1e-60
        a = sqrt(-2 * t)
    else:
        a = solve(3 * HALF, t)
    rows.append(["ln_load", text, a])
write("gw_inverse.csv", ["kind", "value", "alpha"], rows, ORIGIN.replace("alpha is", "value is"))

rows = []
for _ in range(30):
    density, radius, std = 10 ** random.uniform(8, 13), 10 ** random.uniform(-7, -4), 10 ** random.uniform(-9, -5)
    offset, modulus = std * random.uniform(-2, 3), 10 ** random.uniform(6, 12)
    separation = offset + std * random.uniform(-3, 12)
    eta, r, s, y, e, d = map(mpf, (density, radius, std, offset, modulus, separation))
    a = (d - y) / s
    rows.append([repr(v) for v in (density, radius, std, offset, modulus, separation)] + [
        e * 4 / 3 * eta * sqrt(r) * s ** (3 * HALF) * j(3 * HALF, a),
        pi * eta * r * s * j(mpf(1), a),
        e * 2 * eta * sqrt(r) * sqrt(s) * j(HALF, a),
    ])
header = ["density", "radius", "height_std", "mean_offset", "modulus", "separation", "pressure", "area", "stiffness"]
write("gw_units.csv", header, rows, ORIGIN.replace("alpha is that exact double", "SI units, inputs are those exact doubles"))

def beyond(x):
    """Largest and smallest doubles are 1.8e308 and 4.9e-324; the rest is written as 1e+400 or 0."""
    return mpf(10) ** 400 if x > mpf(10) ** 320 else mpf(0) if 0 < x < mpf(10) ** -330 else x


rows = []
for text in ["-1e308", "-1e200", "-1e8", "-1000", "-40", "-1e-300", "0", "5e-324", "1", "30", "37.3", "38.3", "39", "1000", "1e8", "1e154", "1e308"]:
    x = mpf(float(text))
    if x < -1e4:
        load, area, log_load = (-x) ** (3 * HALF) * (1 + 3 / (8 * x * x)), -x, 3 * HALF * log(-x) + 3 / (8 * x * x)
    elif x > 1e4:
        load, area = mpf(0), mpf(0)
        log_load = log(scaled(3 * HALF, x)) - x * x / 2
    else:
        load, area, log_load = j(3 * HALF, x), j(mpf(1), x), ln(3 * HALF, x)
    rows += [["load", text, beyond(load)], ["area", text, beyond(area)]]
    rows.append(["ln load", text, log_load if abs(log_load) < mpf(10) ** 308 else mpf(-10) ** 399])
    if 0 <= x < 1e100:
        rows.append(["scaled load", text, scaled(3 * HALF, x)])
for text in ["2.2250738585072014e-308", "5e-324", "1e-3", "0.43001999366225977", "1e3", "1.7e308"]:
    p = mpf(float(text))
    a = solve(3 * HALF, log(p)) if p < 1e100 else -p ** (mpf(2) / 3)
    rows.append(["alpha from load", text, a])
for text in ["-1e300", "-1e5", "1000"]:
    t = mpf(float(text))
    rows.append(["alpha from ln load", text, sqrt(-2 * t) if t < -1e6 else solve(3 * HALF, t)])
write("extremes_gw.csv", ["quantity", "argument", "reference"], rows, ORIGIN.replace("alpha is", "the argument is"))
