"""Surfaces: heights with what is known of them."""

from __future__ import annotations

import copy
import json
import operator
import os
import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, Protocol, Union, get_args

import numpy as np
from numpy.typing import NDArray

from . import _rough_contact as _rust
from . import _units, plotting
from ._errors import SettingError, SurfaceError, UnitError, dumped, of_file, sorted_as
from ._extras import extra
from ._foreign import heights_of, of_xarray
from ._statistics import Statistics
from ._threads import count
from ._units import Q
from .units import m as _metre

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Fill", "Flip", "Surface", "info", "read", "synth"]

Fill = Literal["refuse", "harmonic", "nearest"]
Level = Literal["auto", "none", "mean", "plane", "quadratic"]
LEVELS = get_args(Level)
Flip = Literal["columns", "rows", "none"]
Crop = Union[tuple[int, int, int, int], Literal["complete", "middle"]]
PathLike = Union[str, "os.PathLike[str]"]
#: A file: its path, its bytes, or an object that gives them.
File = Union[PathLike, bytes, bytearray, memoryview, "Readable"]


class Readable(Protocol):
    """A file object, open for bytes."""

    def read(self) -> bytes: ...


class Surface:
    """The heights of a rough surface: complete, in metres, rows first.

    Parameters
    ----------
    heights : array_like, shape (ny, nx)
        Heights, positive out of the material: a real array with `height_unit`, or a quantity without. Masked points
        and NaN are missing. Axis 0 is y, axis 1 is x.
    pixel : quantity
        Distance of neighbouring points, ``'1 um'``, or a pair ``(dy, dx)``.
    height_unit : str, optional
        Unit of `heights` if they are bare numbers, such as ``'um'``.
    fill : {'refuse', 'harmonic', 'nearest'}
        What to do with missing points.
    name : str, optional
        What messages and reports call it.
    repeats : bool, optional
        Whether the map is one cell of a surface that repeats: of one that does ``level='auto'`` is the mean, and slopes
        go on across its edges. By default nothing is known beyond them, and whether they meet tells 'auto'.

    Examples
    --------
    >>> import numpy as np, rough_contact as rc
    >>> x = np.arange(64) * 1e-6
    >>> waves = 1e-7 * np.cos(2 * np.pi * x / 64e-6)[:, None] * np.cos(2 * np.pi * x / 64e-6)
    >>> rc.Surface(waves, pixel='1 um', height_unit='m')
    Surface(64 x 64 points, 1.00 um apart, rms height 50.0 nm)
    """

    __slots__ = ("_facts", "_heights", "_kept", "_said")

    _heights: NDArray[np.float64]
    _facts: str
    _said: dict[str, Any]
    _kept: dict[str, str]

    def __init__(
        self,
        heights: Any,
        *,
        pixel: Q,
        height_unit: str | None = None,
        fill: Fill = "refuse",
        name: str = "",
        repeats: bool | None = None,
    ) -> None:
        if _units.is_xarray(heights):
            found = of_xarray(heights)
            heights, pixel = found.heights, [step * _metre for step in found.pixel(None, _units.pixel(pixel))]
        values = metres(heights, height_unit)
        if values.ndim != 2:
            raise SurfaceError(f"heights have {values.ndim} dimensions; a map has 2, rows and columns", "shape")
        known = None if repeats is None else _units.flag(repeats, "repeats")
        self._set(*_given(values, _units.pixel(pixel), name or "heights", fill, known, {}))

    def _set(self, heights: NDArray[np.float64], facts: str, said: str) -> None:
        object.__setattr__(self, "_heights", heights)
        object.__setattr__(self, "_facts", facts)
        object.__setattr__(self, "_said", json.loads(said))
        object.__setattr__(self, "_kept", {})

    @classmethod
    def _made(cls, heights: NDArray[np.float64], facts: str, said: str) -> Surface:
        heights.setflags(write=False)
        surface = cls.__new__(cls)
        surface._set(heights, facts, said)
        return surface

    def _with(self, heights: NDArray[np.float64], fill: Fill = "refuse", cleaning: dict[str, Any] = {}) -> Surface:
        # A part of a period is none, nor what filters leave, which do not look across its edges.
        is_period = heights.shape == self.shape and not (cleaning.get("s_filter") or cleaning.get("l_filter"))
        repeats = self._said.get("repeats") if is_period else None
        return Surface._made(*_given(heights, self.pixel, self.name, fill, repeats, cleaning, self._facts))

    @classmethod
    def of(
        cls,
        obj: Any,
        *,
        height_unit: str | None = None,
        pixel: Q | None = None,
        fill: Fill = "refuse",
        name: str = "",
    ) -> Surface:
        """A surface of SurfaceTopography or surfalize, or an `xarray.DataArray`.

        What the object does not say is asked for. SurfaceTopography keeps x first: its heights are transposed.
        """
        if isinstance(obj, Surface):
            return obj
        found = heights_of(obj)
        unit = _agreed(found.unit, height_unit)
        if unit is None:
            raise UnitError(f"{type(obj).__name__} has no unit; give height_unit='um'", "unit")
        dy, dx = found.pixel(unit or None, None if pixel is None else _units.pixel(pixel))
        bare = None if _units.own_unit(found.heights) is not None else unit
        return cls(found.heights, pixel=[dy * _metre, dx * _metre], height_unit=bare, fill=fill, name=name or found.name)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a Surface does not change: {name} cannot be set")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"a Surface does not change: {name} cannot be deleted")

    def __reduce__(self) -> tuple[Any, ...]:
        return Surface._made, (self._heights, self._facts, json.dumps(self._said))

    @property
    def heights(self) -> NDArray[np.float64]:
        """Heights in metres, shape (ny, nx), read-only; `.copy()` to change them."""
        return self._heights

    @property
    def pixel(self) -> tuple[float, float]:
        """Distance of neighbouring points (dy, dx) in metres."""
        dy, dx = self._said["pixel"]
        return dy, dx

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns (ny, nx)."""
        ny, nx = self._heights.shape
        return ny, nx

    @property
    def size(self) -> tuple[float, float]:
        """Extent (y, x) in metres: points times their distance."""
        return self.shape[0] * self.pixel[0], self.shape[1] * self.pixel[1]

    @property
    def name(self) -> str:
        """What messages and reports call it."""
        return str(self._said["name"])

    @property
    def missing(self) -> int:
        """Points that were filled; of a part of a map those of the whole map, as which ones they were is not kept."""
        return int(self._said["missing"])

    @property
    def height_step(self) -> float | None:
        """Step in which the heights came, if they have one (m)."""
        step = self._said["height_step"]
        return None if step is None else float(step)

    @property
    def cleaning(self) -> list[dict[str, Any]]:
        """What each step of cleaning did, as in the JSON."""
        return copy.deepcopy(list(self._said["cleaning"]))

    @property
    def metadata(self) -> Mapping[str, str]:
        """What the file says of itself; empty without one."""
        return MappingProxyType(dict(self._said.get("metadata") or {}))

    @property
    def channel(self) -> str | None:
        """Name of the channel that was read."""
        return self._said.get("channel")

    @property
    def ambiguity(self) -> str | None:
        """How a text was read that could mean something else."""
        return self._said.get("ambiguity")

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        array: NDArray[Any] = np.asarray(self._heights, dtype=dtype)
        return array.copy() if copy and array is self._heights else array

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Surface):
            return NotImplemented
        return self.pixel == other.pixel and np.array_equal(self._heights, other._heights)

    def __hash__(self) -> int:
        return hash((self.pixel, self._heights.tobytes()))

    def __repr__(self) -> str:
        ny, nx = self.shape
        dy, dx = self.pixel
        apart = length(dx) if dy == dx else f"{length(dy)} x {length(dx)}"
        name = f"{self.name!r}: " if self.name != "heights" else ""
        filled = f", {self.missing} filled" if self.missing else ""
        rms = length(float(np.std(self._heights)))
        return f"Surface({name}{ny} x {nx} points, {apart} apart, rms height {rms}{filled})"

    def statistics(
        self,
        *,
        level: Level = "auto",
        boundary: Literal["auto", "open", "periodic"] = "auto",
        iso: bool = False,
        scales: bool = False,
        against: Surface | None = None,
        flip: Flip = "columns",
        shift: Q | None = None,
    ) -> Statistics:
        """Roughness statistics: what ``rough-contact stats`` answers.

        Parameters
        ----------
        level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
            Form that is taken off first; 'auto' is the plane, but the mean of a map that repeats.
        boundary : {'auto', 'open', 'periodic'}
            What lies beyond the edges where slopes are taken; 'auto' is the map again if it was made so, by `synth` or with
            ``repeats=True``, as in `compare`.
        iso : bool
            The areal parameters of ISO 25178-2 too: ``.iso25178['Sdr']``.
        scales : bool
            Slope, curvature and autocorrelation by distance too.
        against, flip, shift
            A second body, as in `solve`: the statistics are those of the sum of both.
        """
        check("level", level, LEVELS)
        check("boundary", boundary, ("auto", "open", "periodic"))
        request = {
            "level": level,
            "boundary": None if boundary == "auto" else boundary,
            "iso": _units.flag(iso, "iso"),
            "scales": _units.flag(scales, "scales"),
        }
        return self._asked(request, laid(against, flip, shift))

    def _asked(self, request: dict[str, Any], second: Any = None) -> Statistics:
        """Statistics, taken once; what is handed out belongs to who asked."""
        asked = dumped(request)
        text = None if second is not None else self._kept.get(asked)
        if text is None:
            with sorted_as(SurfaceError):
                text = _rust.statistics(self._heights, self._facts, asked, count(None), second)
            if second is None:
                self._kept[asked] = text
        return Statistics._of(json.loads(text))

    def levelled(self, form: Level = "plane") -> Surface:
        """A new surface with a form taken off by least squares."""
        check("form", form, LEVELS)
        with sorted_as(SurfaceError):
            heights, facts, said = _rust.reshape(self._heights, self._facts, form, count(None))
        return Surface._made(heights, facts, _repeating(said, self._said.get("repeats")))

    def cleaned(
        self,
        *,
        align_rows: bool = False,
        outliers: float | None = None,
        form: str | None = None,
        s_filter: Q | None = None,
        l_filter: Q | None = None,
        fill: Fill = "refuse",
    ) -> Surface:
        """A new surface, cleaned as `read` does it, in the order of the parameters; ``.cleaning`` says what each step did.

        Filters leave out what they cannot reach at the edges: after them a map that repeats does so no more.
        """
        return self._with(self._heights, fill, cleaned_by(align_rows, outliers, form, s_filter, l_filter))

    def scaled(self, factor: float) -> Surface:
        """A new surface with all heights times a number, as for a calibration."""
        return self._with(self._heights * _units.number(factor, "factor"))

    def psd(self, *, level: Level = "auto") -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Wavenumbers q (rad/m) and the isotropic power spectrum C(q) (m^4), ``rms_height**2`` = integral of C d^2q: of the map as it
        repeats if it was made so, else under a Hann window."""
        check("level", level, LEVELS)
        with sorted_as(SurfaceError):
            wavenumbers, spectrum = _rust.psd(self._heights, self._facts, level, count(None))
        return _units.read_only(wavenumbers), _units.read_only(spectrum)

    def bearing_curve(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Heights (m), highest first, and the fraction of the points at or above each (ISO 25178-2: areal material ratio)."""
        heights = np.sort(self._heights, axis=None)[::-1]
        return _units.read_only(heights), _units.read_only(np.arange(1, heights.size + 1) / heights.size)

    def cropped(self, y0: int, x0: int, ny: int, nx: int) -> Surface:
        """A new surface of ny x nx points from row y0, column x0."""
        rows, columns = self.shape
        y0, x0, ny, nx = (_units.whole(n, "crop", -(2**31)) for n in (y0, x0, ny, nx))
        if min(y0, x0) < 0 or min(ny, nx) < 2 or y0 + ny > rows or x0 + nx > columns:
            raise SurfaceError(
                f"{ny} x {nx} points from row {y0}, column {x0} are no part of {rows} x {columns}", "crop"
            )
        return self._with(np.ascontiguousarray(self._heights[y0 : y0 + ny, x0 : x0 + nx]))

    def write(self, path: PathLike, *, overwrite: bool = False) -> None:
        """Writes the heights; the ending chooses the format: .x3p, .npy, .sdf, .txt or .vti.

        Raises
        ------
        FileExistsError
            If the file exists, unless `overwrite`.
        """
        ending = os.path.splitext(os.fspath(path))[1].lstrip(".").lower()
        ending = {"asc": "txt"}.get(ending, ending)
        with sorted_as(SettingError):
            content = _rust.encode(self._heights, self._facts, ending, f"rough_contact: {self.name}")
        with open(path, "wb" if overwrite else "xb") as file:
            file.write(content)

    def to_xarray(self) -> Any:
        """An `xarray.DataArray` of the heights with coordinates in metres."""
        xarray = extra("xarray", "tables")

        dy, dx = self.pixel
        coords = {"y": np.arange(self.shape[0]) * dy, "x": np.arange(self.shape[1]) * dx}
        made = xarray.DataArray(self._heights, coords, ("y", "x"), name="height", attrs={"units": "m"})
        for axis in ("y", "x"):
            made[axis].attrs["units"] = "m"
        return made

    def plot(self, ax: Axes | None = None, *, unit: str = "um", **imshow: Any) -> Axes:
        """A map of the heights on matplotlib axes."""
        return plotting.heights(self._heights, self.size, ax, unit, **imshow)


def read(
    path: File,
    *,
    channel: str | None = None,
    pixel: Q | None = None,
    lateral_unit: str | None = None,
    height_unit: str | None = None,
    override_height_unit: str | None = None,
    layout: Literal["matrix", "list"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    missing: str | Sequence[str] = (),
    crop: Crop | None = None,
    align_rows: bool = False,
    outliers: float | None = None,
    form: str | None = None,
    s_filter: Q | None = None,
    l_filter: Q | None = None,
    fill: Fill = "refuse",
) -> Surface:
    """Reads a surface file of any of the known formats, recognised by its content.

    Parameters
    ----------
    path : str, path, bytes or file object
        The file, or what it holds.
    channel : str, optional
        Name of the channel, a part of it, or ``'#2'``; the topography by default.
    pixel : quantity, optional
        Distance of neighbouring points if the file does not say, ``'1 um'`` or a pair ``(dy, dx)``.
    lateral_unit, height_unit : str, optional
        Units the file does not give, such as ``'um'``.
    override_height_unit : str, optional
        Unit of the heights, whatever the file says.
    layout : {'matrix', 'list'}, optional
        What the columns of a text file are.
    decimal : {'point', 'comma'}, optional
        Decimal mark of a text file, where ``1,855`` can be below two or thousands.
    missing : str or sequence of str, optional
        What stands where a point is missing, beside NaN, empty cells and the usual words.
    crop : (y0, x0, ny, nx), 'complete' or 'middle', optional
        The part to read: a rectangle of points, the largest one without missing points, or the middle half of each side.
    align_rows : bool
        Put rows in line that stand at heights of their own.
    outliers : float, optional
        Points more than so many robust standard deviations from their neighbours become missing; 8 is usual.
    form : str, optional
        Form to take off: 'plane', 'quadratic', 'polynomial:N', 'sphere', 'cylinder'.
    s_filter, l_filter : quantity, optional
        Cut-offs of Gaussian filters (ISO 16610-61): shorter, longer waves are taken off.
    fill : {'refuse', 'harmonic', 'nearest'}
        What to do with missing points. The order of all this is that of the parameters, as in the command.

    Raises
    ------
    ReadError
        The file cannot be read, or leaves something open; the message says what to give.
    MissingPoints
        Points are missing, and none are filled.
    """
    cleaning = cleaned_by(align_rows, outliers, form, s_filter, l_filter)
    request = reading(
        channel, pixel, lateral_unit, height_unit, override_height_unit, layout, decimal, missing, crop, fill, cleaning
    )
    with of_file():
        file, content = opened(path)
        heights, facts, said = _rust.read(file, dumped(request), count(None), content)
    return Surface._made(heights, facts, said)


def info(
    path: File,
    *,
    channel: str | None = None,
    pixel: Q | None = None,
    lateral_unit: str | None = None,
    height_unit: str | None = None,
    override_height_unit: str | None = None,
    layout: Literal["matrix", "list"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    missing: str | Sequence[str] = (),
    crop: Crop | None = None,
) -> dict[str, Any]:
    """What a surface file holds, as ``rough-contact info`` says it: format, shape, pixel, missing points, channels."""
    request = reading(
        channel, pixel, lateral_unit, height_unit, override_height_unit, layout, decimal, missing, crop
    )
    with of_file():
        file, content = opened(path)
        found: dict[str, Any] = json.loads(_rust.info(file, dumped(request), content))
    return found


def synth(
    shape: tuple[int, int],
    *,
    pixel: Q,
    hurst: float,
    rolloff: Q,
    cutoff: Q,
    rms_height: Q | None = None,
    rms_gradient: float | None = None,
    seed: int,
    quantise: Q | None = None,
    name: str = "",
) -> Surface:
    """A random self-affine surface: the same seed gives the same surface everywhere.

    Parameters
    ----------
    shape : (int, int)
        Rows and columns.
    pixel : quantity
        Distance of neighbouring points.
    hurst : float
        Hurst exponent, above 0 and at most 1.
    rolloff, cutoff : quantity
        Wavelength above which the spectrum is flat; shortest wavelength.
    rms_height : quantity
        Rms height to scale to; or `rms_gradient`, a number.
    seed : int
        Seed of the random phases.
    quantise : quantity, optional
        Step to which the heights are rounded.

    Examples
    --------
    >>> import rough_contact as rc
    >>> rc.synth((64, 48), pixel='1um', hurst=0.8, rolloff='20um', cutoff='4um', rms_height='0.4um', seed=7)
    Surface('synth 7': 64 x 48 points, 1.00 um apart, rms height 400 nm)
    """
    if (rms_height is None) == (rms_gradient is None):
        raise TypeError("give exactly one of rms_height and rms_gradient")
    if np.shape(shape) != (2,):
        raise SettingError(f"shape = {shape!r} must be (rows, columns)", "setting")
    ny, nx = (_units.whole(n, "shape", 2, 1 << 20) for n in shape)
    seed = _units.whole(seed, "seed")
    recipe = {
        "name": _units.text(name, "name", "ground") or f"synth {seed}",
        "shape": [ny, nx],
        "pixel": _units.pixel(pixel),
        "hurst": _units.number(hurst, "hurst"),
        "rolloff": _units.scalar(rolloff, "length", "rolloff"),
        "cutoff": _units.scalar(cutoff, "length", "cutoff"),
        "rms_height": None if rms_height is None else _units.scalar(rms_height, "length", "rms_height"),
        "rms_gradient": None if rms_gradient is None else _units.number(rms_gradient, "rms_gradient"),
        "seed": seed,
        "quantise": None if quantise is None else _units.scalar(quantise, "length", "quantise"),
    }
    with sorted_as(SettingError):
        heights, facts, said = _rust.synth(dumped(recipe), count(None))
    return Surface._made(heights, facts, _repeating(said, True))


def opened(file: File) -> tuple[str, bytes | None]:
    """The path of a file; or a name for it and what it holds."""
    if isinstance(file, (str, os.PathLike)):
        return os.fspath(file), None
    if isinstance(file, (bytes, bytearray, memoryview)):
        return "bytes", bytes(file)
    content = file.read()
    if not isinstance(content, bytes):
        raise TypeError(f"{type(file).__name__} gives {type(content).__name__}; open the file for bytes, with mode 'rb'")
    name = getattr(file, "name", None)
    return os.path.basename(name) if isinstance(name, str) else "bytes", content


def reading(
    channel: str | None,
    pixel: Q | None,
    lateral_unit: str | None,
    height_unit: str | None,
    override_height_unit: str | None,
    layout: str | None,
    decimal: str | None,
    missing: str | Sequence[str],
    crop: Crop | None,
    fill: str = "refuse",
    cleaning: dict[str, Any] = {},
) -> dict[str, Any]:
    """What is said of a file, as the extension takes it."""

    def unit(text: str | None, name: str) -> float | None:
        return None if text is None else _units.unit_alone(text, name)

    marks = missing if isinstance(missing, (list, tuple)) else [missing]
    if height_unit is not None and override_height_unit is not None:
        raise TypeError("give one of height_unit and override_height_unit")
    if layout is not None:
        check("layout", layout, ("matrix", "list", "traces"))
    if decimal is not None:
        check("decimal", decimal, ("point", "comma"))
    said = {
        "channel": None if channel is None else _units.text(channel, "channel", "#2"),
        "pixel": None if pixel is None else _units.pixel(pixel),
        "lateral_unit": unit(lateral_unit, "lateral_unit"),
        "height_unit": unit(height_unit, "height_unit"),
        "override_height_unit": unit(override_height_unit, "override_height_unit"),
        "layout": layout,
        "decimal": decimal,
        "missing_marks": [_units.text(mark, "missing", str(mark)) for mark in marks],
    }
    cut = crop if crop is None or isinstance(crop, str) else ",".join(str(operator.index(n)) for n in crop)
    return {"file": file_of(said, fill, cleaning), "crop": cut}


def file_of(said: dict[str, Any], fill: str, cleaning: dict[str, Any]) -> dict[str, Any]:
    """A file as a run file has it, before it is read."""
    check("fill", fill, get_args(Fill))
    return {**said, "fill": fill, "cleaning": cleaning, "path": "", "sha256": "", "format": "", "missing": 0}


def metres(heights: Any, unit: str | None) -> NDArray[np.float64]:
    """Heights as a C-ordered array of doubles in metres, NaN where they are missing."""
    if isinstance(heights, Surface):
        raise TypeError("heights is an rc.Surface already, in metres; take it as it is, or its .heights with height_unit='m'")
    own = _units.own_unit(heights)
    agreed = _agreed(own, unit)
    if agreed is None:
        raise UnitError("heights have no unit; write height_unit='um', or heights * rc.units.um", "unit")
    if own is None:
        made = _units.scaled(_units.plain(heights, "heights"), _units.unit_alone(agreed, "height_unit"))
    else:
        made = _units.array(heights, "length", "heights")
    return np.ascontiguousarray(made)


def _agreed(own: str | None, given: str | None) -> str | None:
    """The unit of heights: that which they carry or that which is given; two that differ are refused."""
    if own is None or given is None:
        return given if own is None else own
    if own == "" or _units.factor(own) != _units.unit_alone(given, "height_unit"):
        shown = "their unit" if own == "" else f"the unit {own!r}"
        raise UnitError(f"height_unit = {given!r}, and the heights carry {shown}; leave height_unit out, or give a plain array", "unit")
    return own


def _given(
    heights: NDArray[np.float64],
    pixel: tuple[float, float],
    name: str,
    fill: Fill,
    repeats: bool | None,
    cleaning: dict[str, Any],
    before: str | None = None,
) -> tuple[NDArray[np.float64], str, str]:
    """An array as the extension makes a surface of it, with what is known of the surface before."""
    check("fill", fill, get_args(Fill))
    ny, nx = heights.shape
    name = _units.text(name, "name", "ground")
    note = f"an array of {ny} x {nx} heights handed over by a Python program"
    given = {"name": name, "note": note, "pixel": pixel, "fill": fill, "repeats": repeats, "cleaning": cleaning, "before": before}
    with sorted_as(SurfaceError):
        made, facts, said = _rust.given(heights, dumped(given), count(None))
    return made, facts, _repeating(said, repeats)


def _repeating(said: str, repeats: bool | None) -> str:
    """What is said of a surface, with whether it repeats."""
    return json.dumps({**json.loads(said), "repeats": repeats})


def check(name: str, value: object, known: tuple[object, ...]) -> None:
    """Refuses a choice that is none."""
    if not isinstance(value, (str, int, np.bool_, type(None))) or value not in known:
        raise SettingError(f"{name} = {value!r} is none of {', '.join(map(repr, known))}", "setting")


def length(metres: float) -> str:
    """A length as people read it."""
    for scale, unit in ((1.0, "m"), (1e-3, "mm"), (1e-6, "um"), (1e-9, "nm")):
        if abs(metres) >= 0.9995 * scale or unit == "nm":
            shown = metres / scale
            places = max(0, 2 - int(np.floor(np.log10(abs(shown))))) if shown else 0
            return f"{shown:.{min(places, 4)}f} {unit}"
    return f"{metres:g} m"


def laid(
    against: Surface | None, flip: Flip, shift: Q | None
) -> tuple[NDArray[np.float64], str, str] | None:
    """A second body, as the extension takes it; None without one."""
    check("flip", flip, ("columns", "rows", "none"))
    if against is None:
        if flip != "columns" or shift is not None:
            raise TypeError("flip and shift are for a second body; give against= too")
        return None
    if not isinstance(against, Surface):
        raise TypeError(f"against takes an rc.Surface, not {type(against).__name__}")
    placing = {"flip": flip, "shift": (0.0, 0.0) if shift is None else _units.shift(shift)}
    return against._heights, against._facts, dumped(placing)


def cleaned_by(
    align_rows: bool, outliers: float | None, form: str | None, s_filter: Q | None, l_filter: Q | None
) -> dict[str, Any]:
    """Cleaning, as the extension takes it."""
    if form is not None:
        form = _units.text(form, "form", "plane").strip()
        if not re.fullmatch("plane|quadratic|sphere|cylinder|polynomial:0*([0-9]|1[0-2])", form):
            known = "'plane', 'quadratic', 'polynomial:N' with N from 0 to 12, 'sphere', 'cylinder'"
            raise SettingError(f"form = {form!r} is none of {known}", "setting")
    return {
        "align_rows": _units.flag(align_rows, "align_rows"),
        "outliers": None if outliers is None else _units.number(outliers, "outliers"),
        "form": form,
        "s_filter": None if s_filter is None else _units.scalar(s_filter, "length", "s_filter"),
        "l_filter": None if l_filter is None else _units.scalar(l_filter, "length", "l_filter"),
    }
