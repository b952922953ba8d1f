"""Quantities: text or unit objects in, SI floats out.

A bare number where a unit is needed is refused: 50 could be pascals or megapascals, and the answer would look
equally reasonable.
"""

from __future__ import annotations

from collections.abc import Iterable
from numbers import Real
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

from . import _rough_contact as _rust
from ._errors import UnitError, sorted_as

__all__ = [
    "GPa",
    "J_per_m2",
    "MPa",
    "N",
    "Pa",
    "Q",
    "Quantity",
    "Unit",
    "W_per_m_K",
    "bar",
    "kN",
    "kPa",
    "m",
    "mN",
    "mm",
    "nm",
    "ohm_m",
    "um",
]

#: The unit of SI of each kind of quantity, for packages of units.
_SI = {
    "length": "m",
    "area": "m**2",
    "per_area": "m**-2",
    "pressure": "Pa",
    "force": "N",
    "resistivity": "ohm*m",
    "conductivity": "W/(m*K)",
    "energy_per_area": "J/m**2",
}

_EXAMPLE = {
    "length": ("1.5 um", "um"),
    "area": ("2 mm2", "mm * mm"),
    "per_area": ("3e12 m^-2", None),
    "pressure": ("110 GPa", "GPa"),
    "force": ("10 N", "N"),
    "resistivity": ("22 nohm.m", "ohm_m"),
    "conductivity": ("50 W/m/K", "W_per_m_K"),
    "energy_per_area": ("50 mJ/m^2", "J_per_m2"),
}


class Quantity:
    """A number or an array with a unit: what ``110 * rc.GPa`` makes.

    Attributes
    ----------
    si : float or ndarray
        The value in SI units.
    dimension : str
        Kind of quantity.
    """

    __slots__ = ("dimension", "si")
    __array_ufunc__ = None

    def __init__(self, si: Any, dimension: str) -> None:
        self.si = si
        self.dimension = dimension

    def __mul__(self, other: Any) -> Quantity:
        if isinstance(other, (Quantity, Unit)):
            return NotImplemented
        return Quantity(self.si * np.asarray(other, dtype=float)[()], self.dimension)

    __rmul__ = __mul__

    def __repr__(self) -> str:
        return f"{self.si} {_SI.get(self.dimension, '')}"


class Unit:
    """A unit: multiply numbers, lists or arrays with it, as in ``np.geomspace(1, 1000, 16) * rc.MPa``."""

    __slots__ = ("_down", "_up", "dimension", "name")
    __array_ufunc__ = None

    def __init__(self, name: str, dimension: str, exponent: int) -> None:
        self.name = name
        self.dimension = dimension
        # A power of ten is exact, its inverse is not: 1.5 um is the double nearest to 1.5e-6.
        self._up = 10.0 ** max(exponent, 0)
        self._down = 10.0 ** max(-exponent, 0)

    def __rmul__(self, number: Any) -> Quantity:
        if isinstance(number, (str, bytes)):
            return NotImplemented
        value = np.asarray(number, dtype=float)[()] * self._up / self._down
        return Quantity(float(value) if np.ndim(value) == 0 else value, self.dimension)

    __mul__ = __rmul__

    def __repr__(self) -> str:
        return f"rough_contact.{self.name}"

    def __reduce__(self) -> str:
        return self.name


Pa = Unit("Pa", "pressure", 0)
kPa = Unit("kPa", "pressure", 3)
MPa = Unit("MPa", "pressure", 6)
GPa = Unit("GPa", "pressure", 9)
bar = Unit("bar", "pressure", 5)
m = Unit("m", "length", 0)
mm = Unit("mm", "length", -3)
um = Unit("um", "length", -6)
nm = Unit("nm", "length", -9)
N = Unit("N", "force", 0)
kN = Unit("kN", "force", 3)
mN = Unit("mN", "force", -3)
J_per_m2 = Unit("J_per_m2", "energy_per_area", 0)
ohm_m = Unit("ohm_m", "resistivity", 0)
W_per_m_K = Unit("W_per_m_K", "conductivity", 0)

#: What is taken where a unit is needed: text such as ``'110 GPa'`` or ``'1 MPa..1 GPa:16'``; a number or an array
#: times a unit of this package; a quantity of pint or astropy; an `xarray.DataArray` with ``attrs['units']``.
Q = Union[str, Quantity, Any]


def parsed(text: str, dimension: str, many: bool = False) -> list[float]:
    """What the command reads from `text`."""
    with sorted_as(UnitError):
        return _rust.parse(text, dimension, many)


def factor(unit: str, dimension: str = "length") -> float:
    """A unit standing alone, in SI units."""
    return parsed(f"1{unit}", dimension)[0]


def _bare(name: str, value: Any, dimension: str) -> UnitError:
    text, unit = _EXAMPLE[dimension]
    shown = repr(value) if np.ndim(value) == 0 else "an array"
    other = f" or {value if np.ndim(value) == 0 else 'array'} * rc.{unit}" if unit else ""
    return UnitError(f"{name} = {shown} has no unit; write {name}={text!r}{other}", "unit")


def _other(name: str, value: Any, dimension: str, found: object) -> UnitError:
    return UnitError(f"{name} = {value!r} is no {dimension.replace('_', ' ')}: {found}", "unit")


def _si(value: Any, dimension: str, name: str, many: bool) -> Any:
    """The value in SI units, as a number or an array."""
    if isinstance(value, str):
        try:
            found = parsed(value, dimension, many)
        except UnitError as error:
            raise UnitError(f"{name}: {error}", error.kind) from None
        return found if many else found[0]
    if isinstance(value, Unit):
        value = 1 * value
    if isinstance(value, Quantity):
        if value.dimension != dimension:
            raise _other(name, value, dimension, f"its unit is one of {value.dimension}")
        return value.si
    for method in ("m_as", "to_value"):  # pint, astropy
        convert = getattr(value, method, None)
        if convert is not None:
            try:
                return convert(_SI[dimension])
            except Exception as error:  # whatever the package raises of a wrong dimension
                raise _other(name, value, dimension, error) from error
    units = getattr(getattr(value, "attrs", None), "get", lambda _: None)("units")
    if units is not None:  # xarray
        return np.asarray(value, dtype=float) * factor(str(units), dimension)
    if many and isinstance(value, Iterable) and not isinstance(value, np.ndarray):
        items = [_si(item, dimension, name, many) for item in value]
        arrays = [np.atleast_1d(np.asarray(item, dtype=float)) for item in items]
        return np.concatenate(arrays) if arrays else np.empty(0)
    raise _bare(name, value, dimension)


def scalar(value: Q, dimension: str, name: str) -> float:
    """One quantity in SI units."""
    found = np.asarray(_si(value, dimension, name, many=False), dtype=float)
    if found.ndim != 0:
        raise UnitError(f"{name} takes one quantity, and {found.size} were given", "unit")
    return float(found)


def several(value: Q, dimension: str, name: str) -> list[float]:
    """One quantity or more in SI units; the order is kept."""
    found = np.atleast_1d(np.asarray(_si(value, dimension, name, many=True), dtype=float))
    if found.ndim != 1:
        raise UnitError(f"{name} takes a list of quantities, not {found.ndim} dimensions", "unit")
    if found.size == 0:
        raise UnitError(f"{name} is empty; give at least one quantity", "unit")
    return [float(x) for x in found]


def array(value: Q, dimension: str, name: str) -> NDArray[np.float64]:
    """An array of quantities in SI units."""
    return np.asarray(_si(value, dimension, name, many=True), dtype=float)


def number(value: Any, name: str) -> float:
    """A pure number: a float, or text such as ``'3%'``."""
    if isinstance(value, str):
        try:
            return parsed(value, "number")[0]
        except UnitError as error:
            raise UnitError(f"{name}: {error}", error.kind) from None
    if isinstance(value, (Quantity, Unit)) or hasattr(value, "m_as") or hasattr(value, "to_value"):
        raise UnitError(f"{name} is a pure number and takes no unit; write {name}=0.8", "unit")
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (Real, np.ndarray)):
        raise TypeError(f"{name} takes a number, not {type(value).__name__}")
    return float(value)


def pixel(value: Q) -> tuple[float, float]:
    """``(dy, dx)`` in metres: one quantity for both, a pair ``(dy, dx)``, or the command's text ``'DX,DY'``."""
    found = several(value, "length", "pixel")
    if len(found) == 1:
        return found[0], found[0]
    if len(found) == 2:
        # The text is the command's, x first; a pair is as everywhere in Python, rows first.
        return (found[1], found[0]) if isinstance(value, str) else (found[0], found[1])
    raise UnitError(f"pixel takes one length or a pair (dy, dx), and {len(found)} were given", "unit")


def shift(value: Q) -> tuple[float, float]:
    """``(dy, dx)`` in metres: a pair ``(dy, dx)``, or the command's text ``'DX,DY'``."""
    found = several(value, "length", "shift")
    if len(found) != 2:
        raise UnitError(f"shift takes a pair (dy, dx), and {len(found)} were given", "unit")
    return (found[1], found[0]) if isinstance(value, str) else (found[0], found[1])


def pair(value: Q, dimension: str, name: str) -> list[float]:
    """One quantity for both bodies, or one for each."""
    found = several(value, dimension, name)
    if len(found) > 2 or min(found) < 0:
        raise UnitError(f"{name} takes one value for both bodies or two, none negative", "unit")
    return [found[0], found[-1]]
