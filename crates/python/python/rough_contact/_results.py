"""What the solver found: loads on one map."""

from __future__ import annotations

import copy
import json
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, fields
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _rough_contact as _rust
from . import _units, plotting
from ._extras import extra
from ._findings import Finding, findings_html
from ._threads import count

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["LoadCurve", "Point"]

Interval = tuple[float, float]


def _n(unit: str = "", meaning: str = "") -> Any:
    return field(default=None, metadata={"unit": unit, "meaning": meaning})


@dataclass(frozen=True, repr=False, eq=False)
class Point(_units.Kept):
    """One load: the keys of a point of ``rough-contact solve --json``. SI units; None where there is no number."""

    mean_pressure: float | None = _n("Pa", "nominal pressure: load over nominal area")
    touching_fraction: float | None = _n("1", "points that carry pressure over all points; too high by what the contact line adds")
    area_fraction: float | None = _n("1", "real over nominal contact area: `touching_fraction` less 0.1013 points for each edge of the contact line")
    area_interval: Interval | None = _n("1", "error interval of `area_fraction` by grid and iteration")
    area_prediction_interval: Interval | None = _n("1", "the same for another map of the surface: with the sampling variability")
    area_interval_reason: Any = _n("", "why there is no interval")
    mean_gap: float | None = _n("m", "mean distance of the deformed surfaces")
    mean_gap_interval: Interval | None = _n("m", "error interval of `mean_gap` by grid and iteration")
    mean_gap_prediction_interval: Interval | None = _n("m", "error interval of `mean_gap` for another map of the surface")
    mean_pressure_interval: Interval | None = _n("Pa", "error interval of `mean_pressure` by grid and iteration")
    mean_pressure_prediction_interval: Interval | None = _n("Pa", "error interval of `mean_pressure` for another map of the surface")
    real_pressure: float | None = _n("Pa", "load over the area in contact")
    real_pressure_interval: Interval | None = _n("Pa", "error interval of `real_pressure` by grid and iteration")
    real_pressure_prediction_interval: Interval | None = _n("Pa", "error interval of `real_pressure` for another map of the surface")
    max_pressure: float | None = _n("Pa", "highest pressure of a point")
    approach: float | None = _n("m", "displacement since first touch")
    load: float | None = _n("N", "force, if forces were given")
    stiffness: float | None = _n("Pa/m", "contact stiffness per nominal area, if asked for")
    stiffness_interval: Interval | None = _n("Pa/m", "error interval of `stiffness` by grid and iteration")
    stiffness_prediction_interval: Interval | None = _n("Pa/m", "error interval of `stiffness` for another map of the surface")
    electrical_conductance: float | None = _n("S/m2", "per nominal area, if resistivities were given")
    thermal_conductance: float | None = _n("W/m2/K", "per nominal area, if conductivities were given")
    gas_conductance: float | None = _n("W/m2/K", "of the gas in the gap, per nominal area, if one was given")
    joint_conductance: float | None = _n("W/m2/K", "of solid and gas together, per nominal area")
    electrical_resistance: float | None = _n("ohm", "of the whole joint")
    thermal_resistance: float | None = _n("K/W", "of the whole joint")
    contact_set: str | None = _n("", "which contact the stiffness is of")
    conduction: dict[str, Any] | None = _n("", "what the conductances are made of")
    saturated_fraction: float | None = _n("1", "area at the hardness over the whole area")
    plastic_load_fraction: float | None = _n("1", "share of the load on it")
    elastic_area_fraction: float | None = _n("1", "contact area below the hardness over the whole area")
    contact_pixels: int | None = _n("1", "points that carry pressure")
    contact_perimeter: float | None = _n("1", "edges of the contact line over all points")
    converged: bool = field(default=False, metadata={"unit": "", "meaning": "whether the tolerance was reached"})
    stopped_at_rounding: bool = field(default=False, metadata={"unit": "", "meaning": "whether rounding kept it from that"})
    iterations: int | None = _n("1", "iterations of the solver")
    transforms: float | None = _n("1", "FFT convolutions")
    solver_seconds: float | None = _n("s", "time of the solver on all grids; that of the call is ``LoadCurve.seconds``")
    residuals: dict[str, float] | None = _n("", "what is left: of the pressure, of complementarity, of penetration")
    duality_gap: float | None = _n("J/m2", "upper bound of the energy error per nominal area")
    energy_bound: Any = _n("", "proven relative error in the energy norm, with ``certify=True``")
    exact: Any = _n("", "why no iteration was needed")
    budget: dict[str, Any] | None = _n("", "parts of the uncertainty")
    coarser: Any = _n("", "the same load on thinned maps")
    finer: dict[str, Any] | None = _n("", "the same load on twice the points along each side, where that was needed")
    interpolation_indicator: float | None = _n("1", "how far the answer depends on what lies between the points; above 0.05 measure finer")
    distributions: dict[str, Any] | None = _n("", "of pressure, gap and spots, if asked for")
    error: dict[str, str] | None = _n("", "why there is no answer: kind and message")
    pressure: NDArray[np.float64] | None = _n("Pa", "of every point, shape (ny, nx), if maps were kept")
    gap: NDArray[np.float64] | None = _n("m", "of every point, if maps were kept; 0 where it touches")

    @classmethod
    def _of(
        cls,
        json: dict[str, Any],
        pressure: NDArray[np.float64] | None = None,
        gap: NDArray[np.float64] | None = None,
    ) -> Point:
        known = {f.name for f in fields(cls)}
        json = {**json, "solver_seconds": json.get("seconds")}
        values: dict[str, Any] = {
            k: ends(copy.deepcopy(v)) if isinstance(v, list) else copy.deepcopy(v) for k, v in json.items() if k in known
        }
        return cls(**values, pressure=pressure, gap=gap)

    @classmethod
    def units(cls) -> dict[str, str]:
        """The unit of every number; ``'1'`` for pure ones."""
        return {f.name: f.metadata["unit"] for f in fields(cls) if f.metadata["unit"]}

    def __repr__(self) -> str:
        if self.area_fraction is None:
            why = self.error["message"] if self.error else "no answer"
            return f"Point({pressure(self.mean_pressure)}: {why})"
        shown = [pressure(self.mean_pressure), f"area {percent(self.area_fraction, self.area_interval)}"]
        if self.mean_gap is not None:
            shown.append(f"mean gap {self.mean_gap:.4g} m")
        return f"Point({', '.join(shown)}{'' if self.converged else ', not converged'})"


def _table(names: Iterable[str]) -> str:
    """Fields with units and meaning, as numpydoc lists them."""
    facts = {f.name: f.metadata for f in fields(Point)}
    lines = [f"{n} : {facts[n]['unit'] or '-'}\n    {facts[n]['meaning'].capitalize()}." for n in names]
    return "\n\nAttributes\n----------\n" + "\n".join(lines)


Point.__doc__ = f"{Point.__doc__}{_table(f.name for f in fields(Point))}"

#: Which interval belongs to which number.
_INTERVALS = {
    "area_fraction": "area",
    "mean_gap": "mean_gap",
    "mean_pressure": "mean_pressure",
    "real_pressure": "real_pressure",
    "stiffness": "stiffness",
}

_SCALARS = [f.name for f in fields(Point) if f.metadata["unit"] and "interval" not in f.name and f.name not in ("pressure", "gap")]
_PAIRS = [f.name for f in fields(Point) if f.name.endswith("_interval")]


def ends(pair: Sequence[Any]) -> tuple[Any, ...]:
    """An interval of JSON, which has no infinity: an upper end that is not known is ``None`` there."""
    return tuple(float("inf") if end is None else end for end in pair)


class _Column(cached_property[NDArray[np.float64]]):
    """A number of each load, NaN where there is none, or the ends of its interval; made when it is first looked at."""

    def __init__(self) -> None:
        super().__init__(self._of)

    def _of(self, curve: LoadCurve) -> NDArray[np.float64]:
        points, name = curve.json["points"], self.attrname
        if name in _PAIRS:
            pairs = [ends(point.get(name) or (np.nan, np.nan)) for point in points]
            return _units.read_only(np.array(pairs, dtype=np.float64).reshape(len(points), 2))
        key = "seconds" if name == "solver_seconds" else name
        return _units.read_only(np.array([point.get(key) for point in points], dtype=np.float64))  # of None NaN


@dataclass(frozen=True, repr=False, eq=False)
class LoadCurve:
    """The deterministic solution of one map at its loads, in the order asked: what ``rough-contact solve`` answers.

    Numbers are vectors of one entry for each load under the keys of the JSON, SI units, NaN where there is none;
    intervals have shape (n, 2). ``curve[i]`` is a `Point`, ``curve[a:b]`` a shorter curve.
    """

    json: dict[str, Any] = field(repr=False)
    maps: dict[int, tuple[NDArray[np.float64] | None, NDArray[np.float64] | None]] = field(repr=False)
    #: Time of the whole call (s); ``solver_seconds`` is that of the solver for each load.
    seconds: float = field(default=math.nan, repr=False)

    mean_pressure = _Column()
    touching_fraction = _Column()
    area_fraction = _Column()
    area_interval = _Column()
    area_prediction_interval = _Column()
    mean_gap = _Column()
    mean_gap_interval = _Column()
    mean_gap_prediction_interval = _Column()
    mean_pressure_interval = _Column()
    mean_pressure_prediction_interval = _Column()
    real_pressure = _Column()
    real_pressure_interval = _Column()
    real_pressure_prediction_interval = _Column()
    max_pressure = _Column()
    approach = _Column()
    load = _Column()
    stiffness = _Column()
    stiffness_interval = _Column()
    stiffness_prediction_interval = _Column()
    electrical_conductance = _Column()
    thermal_conductance = _Column()
    gas_conductance = _Column()
    joint_conductance = _Column()
    electrical_resistance = _Column()
    thermal_resistance = _Column()
    saturated_fraction = _Column()
    plastic_load_fraction = _Column()
    elastic_area_fraction = _Column()
    contact_pixels = _Column()
    contact_perimeter = _Column()
    iterations = _Column()
    transforms = _Column()
    solver_seconds = _Column()
    duality_gap = _Column()
    interpolation_indicator = _Column()

    @cached_property
    def converged(self) -> NDArray[np.bool_]:
        """Whether each load reached the tolerance."""
        return _units.read_only(np.array([point["converged"] for point in self.json["points"]], dtype=np.bool_))

    @cached_property
    def findings(self) -> tuple[Finding, ...]:
        """What may change a conclusion, worst first."""
        return tuple(Finding._of(finding) for finding in self.json["findings"])

    def __reduce__(self) -> tuple[Any, ...]:
        return LoadCurve._restored, (self.json, self.maps, self.seconds)

    @classmethod
    def _restored(cls, json: dict[str, Any], maps: dict[int, Any], seconds: float) -> LoadCurve:
        for kept in maps.values():
            for array in kept:
                if array is not None:
                    array.setflags(write=False)
        return cls(json, maps, seconds)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns that were solved."""
        ny, nx = self.json["shape"]
        return ny, nx

    @property
    def pixel(self) -> tuple[float, float]:
        """Distance of the points that were solved (dy, dx) in metres."""
        dy, dx = self.json["pixel"]
        return dy, dx

    @property
    def accuracy(self) -> dict[str, Any] | None:
        """What was chosen for the accuracy asked for, and whether it is met."""
        return self.json.get("accuracy")

    @property
    def settings(self) -> dict[str, Any]:
        """How it was solved: the keys of the JSON beside the points."""
        left_out = ("points", "findings", "cleaning", "accuracy", "shape", "pixel")
        return {k: copy.deepcopy(v) for k, v in self.json.items() if k not in left_out}

    def __len__(self) -> int:
        return len(self.json["points"])

    @overload
    def __getitem__(self, index: int) -> Point: ...
    @overload
    def __getitem__(self, index: slice) -> LoadCurve: ...
    def __getitem__(self, index: int | slice) -> Point | LoadCurve:
        if isinstance(index, slice):
            places = range(len(self))[index]
            points = [self.json["points"][i] for i in places]
            maps = {new: self.maps[old] for new, old in enumerate(places) if old in self.maps}
            return LoadCurve({**self.json, "points": points}, maps, self.seconds)
        place = range(len(self))[index]
        return Point._of(self.json["points"][place], *self.maps.get(place, (None, None)))

    def __iter__(self) -> Iterator[Point]:
        return (self[i] for i in range(len(self)))

    def _map(self, index: int, which: int, name: str) -> NDArray[np.float64]:
        place = range(len(self))[index]
        found = self.maps.get(place, (None, None))[which]
        if found is None:
            raise LookupError(f"the {name} of load {place} was not kept; solve with maps=True")
        return found

    def pressure(self, index: int) -> NDArray[np.float64]:
        """Pressure (Pa) of every point at a load, shape (ny, nx), read-only."""
        return self._map(index, 0, "pressure")

    def gap(self, index: int) -> NDArray[np.float64]:
        """Gap (m) of every point at a load, shape (ny, nx), read-only."""
        return self._map(index, 1, "gap")

    def displacement(self, index: int) -> NDArray[np.float64]:
        """Elastic displacement (m) of every point at a load, as `rough_contact.displacement`, from the pressure that was kept."""
        pressure = self.pressure(index)
        ny, nx = pressure.shape
        if self.json["edges"] == "mirrored":
            pressure = np.pad(pressure, ((0, ny), (0, nx)), "symmetric")
        is_free = self.json["boundary"] == "free"
        return _rust.displacement(pressure, self.pixel, self.json["modulus"], is_free, count(None))[:ny, :nx]

    def spots(self, index: int) -> NDArray[np.int32]:
        """The number of the contact spot of every point at a load: 1, 2, ... in the order of rows, 0 where nothing touches.

        Points are connected over edges and corners; of a periodic map across its edges too.
        """
        repeats = self.json["boundary"] == "periodic" and self.json["edges"] == "periodic"
        return _rust.spots(self.pressure(index), self.pixel, repeats)

    def bars(self, name: str = "area_fraction", *, prediction: bool = False) -> NDArray[np.float64]:
        """Half widths below and above, shape (2, n), for `errorbar`; NaN where there is no interval.

        Parameters
        ----------
        name : str
            A number that has intervals.
        prediction : bool
            The interval for another map of the same surface, rather than for this one.
        """
        if name not in _INTERVALS:
            raise KeyError(f"{name!r} has no interval; {', '.join(_INTERVALS)} have one")
        kind = "prediction_interval" if prediction else "interval"
        low, high = getattr(self, f"{_INTERVALS[name]}_{kind}").T
        value = getattr(self, name)
        # The value may stand at an end of its interval, but for rounding.
        made: NDArray[np.float64] = np.maximum([value - low, high - value], 0.0)
        return _units.read_only(made)

    @classmethod
    def units(cls) -> dict[str, str]:
        """The unit of every number; ``'1'`` for pure ones."""
        return Point.units()

    def to_dict(self) -> dict[str, Any]:
        """The object of ``rough-contact solve --json``."""
        return copy.deepcopy(self.json)

    def records(self) -> list[dict[str, Any]]:
        """A flat dict for each load: intervals as ``_low`` and ``_high``, nested keys and places in a list with a dot."""
        return [flat(point) for point in self.json["points"]]

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of one line for each load, units in ``attrs['units']``."""
        pandas = extra("pandas", "tables")

        frame = pandas.DataFrame(self.records())
        frame.attrs["units"] = self.units()
        return frame

    def to_xarray(self) -> Any:
        """An `xarray.Dataset` over the loads: numbers, intervals (``end`` is low or high) and the maps that were kept.

        Each variable has its unit and meaning in ``attrs``; ``mean_pressure`` is a coordinate.
        """
        xarray = extra("xarray", "tables")

        about = {f.name: {"units": f.metadata["unit"], "long_name": f.metadata["meaning"]} for f in fields(Point)}
        data: dict[str, Any] = {n: ("load", getattr(self, n), about[n]) for n in _SCALARS if n not in ("mean_pressure", "load")}
        data["force"] = ("load", self.load, about["load"])
        data |= {n: (("load", "end"), getattr(self, n), about[n]) for n in _PAIRS}
        coords: dict[str, Any] = {"mean_pressure": ("load", self.mean_pressure, about["mean_pressure"]), "end": ["low", "high"]}
        ny, nx = self.shape
        for which, name in enumerate(("pressure", "gap")):
            kept = [self.maps.get(i, (None, None))[which] for i in range(len(self))]
            if any(k is not None for k in kept):
                empty = np.full((ny, nx), np.nan)
                stack = np.stack([empty if k is None else k for k in kept])
                data[name] = (("load", "y", "x"), stack, about[name])
                for axis, n, step in (("y", ny, self.pixel[0]), ("x", nx, self.pixel[1])):
                    coords[axis] = (axis, np.arange(n) * step, {"units": "m"})
        return xarray.Dataset(data, coords, attrs={"modulus": self.json["modulus"], "units": "SI"})

    def plot(
        self,
        ax: Axes | None = None,
        *,
        y: str = "area_fraction",
        bars: bool = True,
        unit: str = "MPa",
        **errorbar: Any,
    ) -> Axes:
        """A number over the mean pressure on matplotlib axes, with its bars."""
        half = self.bars(y) if bars and y in _INTERVALS else None
        names = (y, self.units().get(y, ""))
        return plotting.curve(self.mean_pressure, getattr(self, y), half, names, ax, unit, **errorbar)

    def __repr__(self) -> str:
        ny, nx = self.shape
        loads = "1 load" if len(self) == 1 else f"{len(self)} loads"
        lines = [f"LoadCurve({loads} on {ny} x {nx} points, {self.json['method']}; {made_of(self.json)})"]
        lines += [f"  {finding}" for finding in self.findings if finding.weight == "check"]
        lines += [f"  {repr(point)[6:-1]}" for point in self]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        head = ("mean pressure", "area", "mean gap", "real pressure", "residual", "time")
        rows = []
        for p in self:
            if p.area_fraction is None:
                why = escape(p.error["message"]) if p.error else "no answer"
                rows.append(f"<tr><td>{pressure(p.mean_pressure)}</td><td colspan=5>{why}</td></tr>")
                continue
            residual = p.residuals["preconditioned"] if p.residuals else float("nan")
            cells = (
                pressure(p.mean_pressure),
                percent(p.area_fraction, p.area_interval) + ("" if p.converged else " (not converged)"),
                "–" if p.mean_gap is None else f"{p.mean_gap * 1e9:.4g} nm",
                _rust.pressure_within(p.real_pressure, p.real_pressure_interval),
                f"{residual:.1e}",
                f"{p.solver_seconds or 0:.2g} s",
            )
            rows.append("<tr>" + "".join(f"<td style='text-align:right'>{escape(c)}</td>" for c in cells) + "</tr>")
        heads = "".join(f"<th>{h}</th>" for h in head)
        about = f"<p>{escape(made_of(self.json))}</p>"
        return f"{findings_html(self.findings)}{about}<table><tr>{heads}</tr>{''.join(rows)}</table>"


LoadCurve.__doc__ = f"{LoadCurve.__doc__}{_table([*_SCALARS, *_PAIRS, 'converged'])}"


def flat(value: dict[str, Any], above: str = "") -> dict[str, Any]:
    """One level of keys."""
    found: dict[str, Any] = {}
    for key, item in value.items():
        name = f"{above}{key}"
        if key.endswith("interval") and (item is None or isinstance(item, list)):
            low, high = item or (None, None)
            found[f"{name}_low"], found[f"{name}_high"] = low, high
        elif isinstance(item, list):
            found.update(flat({str(place): each for place, each in enumerate(item)}, f"{name}."))
        elif isinstance(item, dict):
            found.update(flat(item, f"{name}."))
        else:
            found[name] = item
    return found


def pressure(pascals: float | None) -> str:
    """A pressure as people read it."""
    if pascals is None:
        return "–"
    for scale, unit in ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")):
        if abs(pascals) >= 0.9995 * scale:
            return f"{pascals / scale:.4g} {unit}"
    return f"{pascals:.4g} Pa"


def percent(value: float | None, interval: Interval | None) -> str:
    """A fraction and the ends between which it lies, as the command says them."""
    if value is None:
        return "–"
    return _rust.percent_within(value, interval) + (" (no ±)" if interval is None else "")


def made_of(answer: dict[str, Any]) -> str:
    """E*, and which bodies press on each other."""
    elastic = [body for body in answer.get("bodies") or [] if not body["rigid"]]
    bodies = [{"young": body["young"], "poisson": body["poisson"]} for body in elastic]
    return "rigid bodies" if answer["modulus"] is None else _rust.bodies_line(answer["modulus"], json.dumps(bodies))
