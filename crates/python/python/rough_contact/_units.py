"""Quantities: text or unit objects in, SI floats out.

A bare number where a unit is needed is refused: 50 could be pascals or megapascals, and the answer would look
equally reasonable.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Sequence
from numbers import Real
from typing import TYPE_CHECKING, Any, Protocol, TypeVar, Union, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from . import _rough_contact as _rust
from ._errors import SettingError, UnitError, sorted_as

__all__ = ["Q", "Quantity"]

_T = TypeVar("_T")

#: Of each kind of quantity: powers of m, kg, s, A and K; its unit of SI for packages of units; an example as text
#: and as a unit of this package.
_KINDS: dict[str, tuple[tuple[int, ...], str, str, str]] = {
    "number": ((0, 0, 0, 0, 0), "", "0.8", "1"),
    "length": ((1, 0, 0, 0, 0), "m", "1.5 um", "um"),
    "area": ((2, 0, 0, 0, 0), "m**2", "2 mm2", "mm**2"),
    "per_area": ((-2, 0, 0, 0, 0), "m**-2", "3e12 m^-2", "m**-2"),
    "pressure": ((-1, 1, -2, 0, 0), "Pa", "110 GPa", "GPa"),
    "force": ((1, 1, -2, 0, 0), "N", "10 N", "N"),
    "resistivity": ((3, 1, -3, -2, 0), "ohm*m", "22 nohm.m", "ohm * rc.units.m"),
    "conductivity": ((1, 1, -3, 0, -1), "W/(m*K)", "50 W/m/K", "W / rc.units.m / rc.units.K"),
    "energy_per_area": ((0, 1, -2, 0, 0), "J/m**2", "50 mJ/m^2", "J / rc.units.m**2"),
    "viscosity": ((-1, 1, -1, 0, 0), "Pa*s", "1 mPa.s", "Pa * rc.units.s"),
}
_NAMES = {powers: (kind, unit) for kind, (powers, unit, _, _) in _KINDS.items()}


#: A number in front of a unit.
_COUNTED = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")


class Quantity:
    """A number or an array with a unit: ``110 * rc.units.GPa``.

    Quantities multiply, divide, take powers and compare; adding or comparing those of different kinds is refused.
    Masked and missing entries of an array are NaN.

    Attributes
    ----------
    si : float or ndarray
        The value in SI units.
    """

    __slots__ = ("_exponent", "_magnitude", "_powers")
    # Operators of numpy, pandas and xarray leave the work to this class, which knows masks.
    __array_ufunc__ = None
    __pandas_priority__ = 10_000
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, magnitude: Any, powers: tuple[int, ...], exponent: int = 0) -> None:
        self._magnitude = magnitude
        self._powers = powers
        self._exponent = exponent

    @property
    def si(self) -> Any:
        # A power of ten is exact, its inverse is not: 1.5 um is the double nearest to 1.5e-6.
        ten = 10.0 ** abs(self._exponent)
        return self._magnitude * ten if self._exponent >= 0 else self._magnitude / ten

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the array; ``()`` of a number."""
        return np.shape(self._magnitude)

    @property
    def ndim(self) -> int:
        """Dimensions of the array."""
        return np.ndim(self._magnitude)

    @property
    def dtype(self) -> np.dtype[Any]:
        """That of doubles."""
        return np.dtype(np.float64)

    if not TYPE_CHECKING:  # for a type checker what has these is an array

        def __array_function__(self, *_: Any) -> Any:  # how xarray tells what it may keep
            return NotImplemented

        def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
            raise UnitError("a quantity is no bare array; take .si, its value in SI units", "unit")

    def __getitem__(self, key: Any) -> Quantity:
        return Quantity(self._magnitude[key], self._powers, self._exponent)

    def __len__(self) -> int:
        return len(self._magnitude)

    def transpose(self, *axes: Any) -> Quantity:
        """As of an array."""
        return Quantity(self._magnitude.transpose(*axes), self._powers, self._exponent)

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, (str, bytes)) or hasattr(other, "dims"):  # xarray, its arrays and their variables
            return NotImplemented
        if isinstance(other, Quantity):
            powers = tuple(a + b for a, b in zip(self._powers, other._powers))
            return Quantity(self._magnitude * other._magnitude, powers, self._exponent + other._exponent)
        return Quantity(self._magnitude * _value(other), self._powers, self._exponent)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Any:
        if isinstance(other, Quantity):
            return self * other**-1
        return self * (1.0 / _value(other))

    def __rtruediv__(self, other: Any) -> Any:
        return (self**-1).__mul__(other)

    def __pow__(self, power: int) -> Quantity:
        n = operator.index(power)
        return Quantity(self._magnitude**n if n >= 0 else 1.0 / self._magnitude**-n, tuple(n * p for p in self._powers), n * self._exponent)

    def __neg__(self) -> Quantity:
        return Quantity(-self._magnitude, self._powers, self._exponent)

    def _same(self, other: Any) -> Any:
        if not isinstance(other, Quantity):
            other = Quantity(_value(other), (0,) * 5)
        if other._powers != self._powers:
            raise UnitError(f"{self!r} and {other!r} are of different kinds", "unit")
        return other.si

    def __add__(self, other: Any) -> Quantity:
        return Quantity(self.si + self._same(other), self._powers)

    def __sub__(self, other: Any) -> Quantity:
        return Quantity(self.si - self._same(other), self._powers)

    def __eq__(self, other: object) -> Any:
        if not isinstance(other, Quantity):
            return NotImplemented
        return self._powers == other._powers and self.si == other.si

    def __lt__(self, other: Any) -> Any:
        return self.si < self._same(other)

    def __le__(self, other: Any) -> Any:
        return self.si <= self._same(other)

    def __gt__(self, other: Any) -> Any:
        return self.si > self._same(other)

    def __ge__(self, other: Any) -> Any:
        return self.si >= self._same(other)

    def __repr__(self) -> str:
        named = zip(("m", "kg", "s", "A", "K"), self._powers)
        base = " ".join(n if p == 1 else f"{n}^{p}" for n, p in named if p)
        return f"{self.si} {_NAMES[self._powers][1] if self._powers in _NAMES else base}".strip()


@runtime_checkable
class _PintLike(Protocol):
    def m_as(self, unit: str, /) -> Any: ...


@runtime_checkable
class _AstropyLike(Protocol):
    def to_value(self, unit: str, /) -> Any: ...


@runtime_checkable
class _XarrayLike(Protocol):
    @property
    def dims(self) -> Any: ...
    @property
    def coords(self) -> Any: ...
    @property
    def attrs(self) -> Any: ...


#: What is taken where a unit is needed: text such as ``'110 GPa'`` or ``'1 MPa..1 GPa:16'``; a number or an array
#: times a unit of `rough_contact.units`; a quantity of pint or astropy; an `xarray.DataArray` with ``attrs['units']``; a
#: list or a tuple of these.
Q = Union[str, Quantity, _PintLike, _AstropyLike, _XarrayLike, Sequence["Q"]]


def is_xarray(value: object) -> bool:
    """Whether it is like an `xarray.DataArray`."""
    return hasattr(value, "dims") and hasattr(value, "coords") and hasattr(value, "attrs")


def read_only(value: _T) -> _T:
    """The array, or the arrays of a dict, made read-only."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif isinstance(value, dict):
        for item in value.values():
            read_only(item)
    return value


class Kept:
    """What has arrays among its attributes, which stay read-only when it is copied or comes out of a pickle."""

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(read_only(state))


def plain(values: Any, name: str) -> NDArray[np.float64]:
    """Real numbers as doubles, NaN where they are masked or missing."""
    mask: Any = None
    if isinstance(values, (list, tuple)):
        values = np.ma.array(values)  # which keeps the masks of its rows
    if is_xarray(values):
        values = values.data
    if callable(getattr(values, "to_numpy", None)):  # pandas, polars
        try:
            array = np.asarray(values.to_numpy(na_value=np.nan))
        except TypeError:
            array = np.asarray(values.to_numpy())
    else:
        mask = getattr(values, "mask", None)  # of numpy, or of astropy
        array = np.asarray(getattr(values, "unmasked", values))
    if array.dtype == object:
        for item in array.flat:
            if not (isinstance(item, Real) and not isinstance(item, (bool, np.bool_)) or item is None or item is np.ma.masked or str(item) == "<NA>"):
                raise TypeError(f"{name} takes real numbers, not {type(item).__name__}{_other_way(item)}")
        floats = [np.nan if item is None or not isinstance(item, Real) else float(item) for item in array.flat]
        array = np.array(floats, dtype=np.float64).reshape(array.shape)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} takes real numbers, not {array.dtype}")
    made = array.astype(np.float64)
    if mask is not None and np.any(mask):
        made = np.where(mask, np.nan, made)
    return made


def _other_way(item: object) -> str:
    return " in an array; multiply the unit by the array, not the array by the unit" if isinstance(item, _PintLike) else ""


def _value(other: Any) -> Any:
    made = plain(other, "a quantity")
    return float(made) if made.ndim == 0 else made


def parsed(text: str, dimension: str, many: bool = False) -> list[float]:
    """What the command reads from `text`."""
    with sorted_as(UnitError):
        return _rust.parse(text, dimension, many)


def factor(unit: str, dimension: str = "length") -> float:
    """What a unit is in SI units; one with a number in front, as of a scale in a file, is that many: ``'1e-9 m'``."""
    text = unit.strip()
    found = parsed(text if _COUNTED.match(text) else f"1 {text}", dimension)[0]
    if not 0 < found < float("inf"):
        raise UnitError(f"the unit {unit!r} must be greater than 0 and finite", "unit")
    return found


def unit_alone(unit: Any, name: str, dimension: str = "length") -> float:
    """A unit that a person types: as for the command one without a number in front."""
    example = _KINDS[dimension][3]
    if not isinstance(unit, str) or not unit.strip():
        raise UnitError(f"{name} = {unit!r} is no unit; write {name}={example!r}", "unit")
    counted = _COUNTED.match(unit.strip())
    if counted:
        alone = unit.strip()[counted.end() :].strip() or example
        raise UnitError(
            f"{name} = {unit!r} has a number in front; write {name}={alone!r}, and multiply by {counted.group()} what it is the unit of", "unit"
        )
    try:
        return factor(unit, dimension)
    except UnitError as error:
        raise UnitError(f"{name}: {error}", error.kind) from None


def scaled(values: Any, factor: float) -> Any:
    """Values in SI units: 1 nm is 1e-9 only rounded, and division by an exact power of ten rounds once."""
    down = 1.0 / factor
    if down > 1.0 and abs(round(down) * factor - 1) < 1e-15:
        return values / round(down)
    return values * factor


def _bare(name: str, value: Any, dimension: str) -> UnitError:
    _, _, text, unit = _KINDS[dimension]
    is_one = np.ndim(value) == 0 and not is_xarray(value)
    shown = repr(value) if is_one else "an array"
    return UnitError(f"{name} = {shown} has no unit; write {name}={text!r} or {value if is_one else 'array'} * rc.units.{unit}", "unit")


def _other(name: str, value: Any, dimension: str, found: object) -> UnitError:
    return UnitError(f"{name} = {value!r} is no {dimension.replace('_', ' ')}: {found}", "unit")


def own_unit(value: Any) -> str | None:
    """The unit that an object carries: of an array of xarray its name, of a quantity ``''``; None of bare numbers."""
    if is_xarray(value):
        if own_unit(value.data) == "":
            return ""
        units = value.attrs.get("units")
        return None if units is None else str(units)
    return "" if isinstance(value, (Quantity, _PintLike, _AstropyLike)) else None


def _si(value: Any, dimension: str, name: str, many: bool) -> Any:
    """The value in SI units, as a number or an array."""
    powers, si, _, _ = _KINDS[dimension]
    if isinstance(value, str):
        try:
            found = parsed(value, dimension, many)
        except UnitError as error:
            raise UnitError(f"{name}: {error}", error.kind) from None
        return found if many else found[0]
    unit = own_unit(value)
    if is_xarray(value) and unit is not None:
        if unit == "" and "units" in value.attrs:
            raise UnitError(f"{name} has a unit in its data and another in attrs['units']; leave one out", "unit")
        if unit == "":
            return _si(value.data, dimension, name, many)
        try:
            return scaled(plain(value, name), factor(unit, dimension))
        except UnitError as error:
            raise UnitError(f"{name}: {error}", error.kind) from None
    if isinstance(value, Quantity):
        if value._powers != powers:
            other = _NAMES.get(value._powers, ("another kind",))[0].replace("_", " ")
            raise _other(name, value, dimension, f"its unit is one of {other}")
        return value.si
    if unit == "":
        try:  # pint has .units, astropy .unit
            is_pint = hasattr(value, "m_as")
            one = type(value)(1.0, value.units).m_as(si) if is_pint else value.unit.to(si)
            numbers = value.magnitude if is_pint else value.to_value(value.unit)
        except Exception as error:  # whatever the package raises of a wrong dimension
            raise _other(name, value, dimension, error) from error
        return scaled(plain(numbers, name), one)
    if many and isinstance(value, (list, tuple)):
        items = [np.atleast_1d(np.asarray(_si(item, dimension, name, many), dtype=float)) for item in value]
        return np.concatenate(items) if items else np.empty(0)
    raise _bare(name, value, dimension)


def _checked(found: NDArray[np.float64], name: str) -> NDArray[np.float64]:
    if not np.isfinite(found).all():
        bad = float(found[~np.isfinite(found)].flat[0]) if found.ndim else float(found)
        raise SettingError(f"{name} = {bad} is no finite number", "setting")
    return found


def scalar(value: Q, dimension: str, name: str, *, infinite: bool = False) -> float:
    """One quantity in SI units."""
    if isinstance(value, (list, tuple)):
        raise UnitError(f"{name} takes one quantity, and a list of {len(value)} was given; write {name}={_KINDS[dimension][2]!r}", "unit")
    found = np.asarray(_si(value, dimension, name, many=False), dtype=float)
    if found.ndim != 0:
        raise UnitError(f"{name} takes one quantity, and {found.size} were given", "unit")
    return float(found if infinite and found > 0 else _checked(found, name))


def several(value: Q, dimension: str, name: str, *, holes: bool = False) -> list[float]:
    """One quantity or more in SI units; the order is kept. NaN among others is one with `holes`."""
    found = np.atleast_1d(np.asarray(_si(value, dimension, name, many=True), dtype=float))
    if found.ndim != 1:
        raise UnitError(f"{name} takes a list of quantities, not {found.ndim} dimensions", "unit")
    if found.size == 0:
        raise UnitError(f"{name} is empty; give at least one quantity", "unit")
    is_hole = np.isnan(found)
    _checked(found[~is_hole] if holes and not is_hole.all() else found, name)
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
    if own_unit(value) is not None:
        raise UnitError(f"{name} is a pure number and takes no unit; write {name}=0.8", "unit")
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (Real, np.ndarray)) or isinstance(value, np.ndarray) and value.ndim:
        raise TypeError(f"{name} takes a number, not {type(value).__name__}")
    return float(_checked(plain(value, name), name))


def text(value: Any, name: str, example: str) -> str:
    """A word."""
    if not isinstance(value, str):
        raise SettingError(f"{name} = {value!r} is no text; write {name}={example!r}", "setting")
    return str(value)


def flag(value: Any, name: str) -> bool:
    """True or False, of numpy too."""
    if not isinstance(value, (bool, np.bool_, int)) or value not in (0, 1):
        raise SettingError(f"{name} = {value!r} must be True or False", "setting")
    return bool(value)


def whole(value: Any, name: str, least: int = 0, most: int = 2**63 - 1) -> int:
    """A whole number in a range."""
    if isinstance(value, (float, np.floating)) and float(value).is_integer():
        value = int(value)
    if isinstance(value, (bool, np.bool_)) or isinstance(value, Real) and not hasattr(value, "__index__"):
        raise SettingError(f"{name} = {value!r} is no whole number", "setting")
    found = operator.index(value)
    if not least <= found <= most:
        raise SettingError(f"{name} = {found} must be from {least} to {most}", "setting")
    return found


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


def ends(value: Q, name: str) -> list[float]:
    """Two lengths, the shorter first."""
    found = several(value, "length", name)
    if len(found) != 2 or not 0 < found[0] < found[1]:
        raise UnitError(f"{name} takes two lengths, the shorter first, and {value!r} is given", "unit")
    return found


def pair(value: Q, dimension: str, name: str) -> list[float]:
    """One quantity for both bodies, or one for each."""
    found = several(value, dimension, name)
    if len(found) > 2 or min(found) < 0:
        raise UnitError(f"{name} takes one value for both bodies or two, none negative", "unit")
    return [found[0], found[-1]]
