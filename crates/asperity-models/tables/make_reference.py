"""Makes fixtures/reference/summit_models.csv and extremes_summit_models.csv with mpmath (34 digits, 20 printed).

Independent of the crate: tanh-sinh quadrature over the curvature t, partial moments from mpmath's
parabolic cylinder function, elliptic Hertz kernels by quadrature over the ellipse, Greenwood's from 1F1.
Takes about twenty minutes.

    python3 crates/asperity-models/tables/make_reference.py
"""
from pathlib import Path
from mpmath import cosh, ellipe, ellipk, exp, fsum, gamma, hyp1f1, log, mp, mpf, nstr, pcfu, pi, quad, sinh, sqrt

mp.dps = 34
HALF = mpf(1) / 2
OUT = Path(__file__).parents[3] / "fixtures" / "reference"


def ellipse(k):
    m = (1 - k) * (1 + k)
    K, E = ellipk(m), ellipe(m)
    num, den = k * k * (K - E), E - k * k * K
    dK, dE = -den / (m * k), -k * (E - K) / m
    q = num / den
    dq = ((2 * k * (K - E) + k * k * (dK - dE)) - q * (dE - 2 * k * K - k * k * dK)) / den
    return (1 - q) / (1 + q), -2 * dq / (1 + q) ** 2, E / (K * k), sqrt(E) / (K * sqrt(K) * k)


RULE = []
mp.dps = 60
for i in range(-110, 111):
    s = mpf(i) / 28
    k = 1 / (1 + exp(-pi * sinh(s)))
    if mpf(10) ** -20 < k < 1 - mpf(10) ** -20:
        u, du, fa, fp = ellipse(k)
        RULE.append((u * u, -du * pi * cosh(s) * k * (1 - k) / 28 * u * (1 - u * u), fa, fp))
mp.dps = 34


def j(n, a):
    if a < -40:  # exp(-800) beyond
        x = -a
        total, term, i = mpf(0), mpf(1), 0
        while abs(term) > mpf(10) ** -36:
            total += term
            m = 2 * i - n
            term *= m * (m + 1) / ((i + 1) * 2 * x * x)
            i += 1
        return x**n * total
    return gamma(n + 1) / sqrt(2 * pi) * exp(-a * a / 4) * pcfu(n + HALF, a)


def row(bandwidth, h):
    rho, s2 = sqrt(mpf(3) / 2 / bandwidth), 1 - mpf(3) / 2 / bandwidth
    s = sqrt(s2)
    c, w = h / rho, s / rho

    def overlap(n, t):
        if s == 0:
            return (t - h) ** n if t > h else mpf(0)
        return s**n * j(n, (h - rho * t) / s)

    lead = h * h / 2 if h > 0 else mpf(0)  # quad's error control is absolute: keep values near 1
    memo = {}

    def integrand(t):
        if t in memo:
            return memo[t]
        if t <= 0:
            return [mpf(0)] * 5
        x = t * t
        e = [wt * exp(-x * u2) for u2, wt, _, _ in RULE]
        wa = fsum(v * r[2] for v, r in zip(e, RULE))
        wp = fsum(v * r[3] for v, r in zip(e, RULE))
        ga, gp = hyp1f1(1, mpf(5) / 2, -x) / 3, 4 / (7 * pi) * hyp1f1(1, mpf(11) / 4, -x)
        phi = exp(lead - x / 2) / sqrt(2 * pi)
        j12, j1, j32 = (overlap(n, t) for n in (HALF, mpf(1), 3 * HALF))
        t3, t35 = 4 * t**3 * phi, 4 * t**3 * sqrt(t) * phi
        memo[t] = [v for a, p in ((wa, wp), (ga, gp)) for v in (t3 * a * j1, t35 * p * j32)]
        memo[t].append(t35 * wp * 3 * HALF * j12)  # -dp/dh of Bush, Gibson and Thomas
        return memo[t]

    center, reach = rho * h, 13
    low = max(mpf(0), center - reach * s) if h > 0 else mpf(0)
    high = sqrt(h * h + reach**2) if h > 0 and h * s / rho < reach else (center + reach * s if h > 0 else mpf(reach))
    if s == 0 and h > 0:
        low = mpf(h)
    cuts = {low, high} | {low + (high - low) * k / 6 for k in range(1, 6)}
    if h > 0 or rho > HALF:
        d = 4 * w
        while 0 < d < high - low:
            cuts |= {v for v in (c - d, c + d) if low < v < high}
            d *= 6
        if low < c < high:
            cuts.add(c)
    cuts = sorted(cuts)
    out = [quad(lambda t, i=i: integrand(t)[i], cuts) for i in range(5)]
    area, load = sqrt(bandwidth / 24), (mpf(3) / 2) ** (mpf(1) / 4) / 9 * bandwidth ** (mpf(3) / 4)
    scale = [area, load] * 2 + [load]
    return [a * v * exp(-lead) for a, v in zip(scale, out)]


def at_pressure(bandwidth, pressure):
    """h and area at which the Bush-Gibson-Thomas load is `pressure`, by Newton's iteration."""
    h = mpf(37) if pressure < 1e-100 else mpf(5) if pressure < 1 else -mpf(pressure) ** (mpf(2) / 3)
    while True:
        r = row(bandwidth, h)
        step = (log(r[1]) - log(mpf(pressure))) * r[1] / r[4]
        h += step
        if abs(step) < mpf(10) ** -12 * abs(h):  # quadratic: the next is below 1e-22
            return h, row(bandwidth, h)[0]


def write(path, note, header, lines):
    origin = "# Made by crates/asperity-models/tables/make_reference.py: mpmath, 34 digits; "
    path.write_text("\n".join([origin + note, header, *lines]) + "\n")


if __name__ == "__main__":
    exact = "m0 = m2 = E* = 1, m4 = bandwidth; bandwidth and argument are exact doubles"
    bandwidths = [1.5, 1.5 * (1 + 1e-12), 1.5 * (1 + 1e-6), 1.5001, 1.53, 1.9, 3.3, 13.7, 1e3, 1e5, 1e8]
    heights = [-6.0, -0.37, 0.001, 1.3, 9.0, 25.0, 37.5, 40.0]
    names = [f"{m}_{q}" for m in ("bgt", "geometric") for q in ("area", "pressure")]
    header = ",".join(["bandwidth", "h", *names])
    lines, extremes = [], []
    for b in bandwidths:
        for h in heights:
            r = row(mpf(b), mpf(h))
            lines.append(",".join([repr(b), repr(h)] + [nstr(v, 20) for v in r[:4]]))
            if b in (1.5, 1.5 * (1 + 1e-12), 1e8):
                for quantity, value in (("area", r[0]), ("pressure", r[1])):
                    extremes.append(f"{quantity},{b!r},{h!r},{nstr(value, 20)}")
    write(OUT / "summit_models.csv", exact, header, lines)
    for b in (1.5, 2.0, 1e8):
        for pressure in (2.2250738585072014e-308, 1e-6, 1e3):
            h, area = at_pressure(mpf(b), pressure)
            extremes.append(f"separation at pressure,{b!r},{pressure!r},{nstr(h, 20)}")
            extremes.append(f"area at pressure,{b!r},{pressure!r},{nstr(area, 20)}")
    write(OUT / "extremes_summit_models.csv", exact, "quantity,bandwidth,argument,reference", extremes)
