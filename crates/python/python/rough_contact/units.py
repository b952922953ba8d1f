"""Units: ``110 * units.GPa``, ``np.geomspace(1, 1000, 16) * units.MPa``, ``3e12 / units.m**2``."""

from ._units import Quantity

__all__ = ["A", "GPa", "J", "K", "MPa", "N", "Pa", "Quantity", "W", "bar", "kN", "kPa", "kg", "m", "mJ", "mN", "mm", "nm", "ohm", "s", "um"]

m, kg, s, A, K = (Quantity(1.0, tuple(int(i == k) for i in range(5))) for k in range(5))


def _prefixed(unit: Quantity, exponent: int) -> Quantity:
    return Quantity(1.0, unit._powers, exponent)


mm, um, nm = (_prefixed(m, -n) for n in (3, 6, 9))
N = kg * m / s**2
kN, mN = _prefixed(N, 3), _prefixed(N, -3)
Pa = N / m**2
kPa, MPa, GPa, bar = (_prefixed(Pa, n) for n in (3, 6, 9, 5))
J = N * m
mJ = _prefixed(J, -3)
W = J / s
ohm = W / A**2
