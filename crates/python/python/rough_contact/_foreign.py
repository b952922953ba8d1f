"""Heights of other packages, told by what they have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _units
from ._errors import SurfaceError, UnitError

#: Largest deviation of the steps of a coordinate from equal ones.
UNEVEN = 1e-6

#: What dimensions are called that lie along the rows of a map (x) and down its columns (y).
_ALONG_X = ("x", "column", "columns", "col", "cols", "longitude", "lon")
_ALONG_Y = ("y", "row", "rows", "latitude", "lat")


@dataclass(frozen=True)
class Foreign:
    """What an object says of a surface, rows first; lengths in its own units."""

    heights: Any
    unit: str | None
    steps: tuple[float | None, float | None]
    #: Of the steps; ``''`` where it is that of the heights, None where it is not said.
    step_units: tuple[str | None, str | None]
    name: str

    def pixel(self, unit: str | None, given: tuple[float, float] | None, name: str = "pixel") -> tuple[float, float]:
        """``(dy, dx)`` in metres: as given, by the argument `name`, which may not contradict the object, or as the object says."""
        found = []
        for axis, step, own, wanted in zip("yx", self.steps, self.step_units, given or (None, None)):
            known = None
            named = unit if own == "" else own
            if step is not None and named is not None:
                try:
                    known = float(_units.scaled(step, _units.factor(named)))
                except UnitError as error:
                    raise UnitError(f"the coordinates along {axis}: {error}", error.kind) from None
            if wanted is None and step is None:
                raise UnitError("the object has no spacing of points; give pixel='1um'", "unit")
            if wanted is None and known is None:
                raise UnitError(f"the coordinates along {axis} have no unit; give pixel='1um', or give them attrs['units']", "unit")
            if wanted is not None and known is not None and abs(wanted - known) > UNEVEN * known:
                raise SurfaceError(
                    f"{name} = {wanted:g} m along {axis}, and the object's own coordinates are {known:g} m apart; give "
                    f"{name} as they say, or a plain array",
                    "pixel",
                )
            found.append(known if wanted is None else wanted)
        dy, dx = found
        assert dy is not None and dx is not None
        return dy, dx


def heights_of(obj: Any) -> Foreign:
    """What SurfaceTopography, surfalize or xarray say."""
    if hasattr(obj, "physical_sizes") and callable(getattr(obj, "heights", None)):
        return _surface_topography(obj)
    if hasattr(obj, "step_x") and hasattr(obj, "step_y") and hasattr(obj, "data"):
        pixel = (float(obj.step_y), float(obj.step_x))
        return Foreign(np.asarray(obj.data), "um", pixel, ("um", "um"), "")
    if _units.is_xarray(obj):
        return of_xarray(obj)
    raise TypeError(
        f"{type(obj).__name__} is none of SurfaceTopography, surfalize and xarray; "
        "give its heights to Surface(heights, pixel=, height_unit=)"
    )


def _surface_topography(obj: Any) -> Foreign:
    if len(obj.physical_sizes) != 2:
        raise SurfaceError("a line scan is a profile, and no map", "profile")
    # x comes first there.
    heights = _units.plain(obj.heights(), "heights").T
    nx, ny = obj.nb_grid_pts
    width, height = obj.physical_sizes
    # Whether it is periodic is said by most readers for want of anything better: the edges tell.
    return Foreign(heights, getattr(obj, "unit", None), (height / ny, width / nx), ("", ""), "")


def of_xarray(obj: Any, *, traces: bool = False) -> Foreign:
    """What an array of xarray says: its dimensions are told by their names, else they are rows and columns; `traces` lie in rows,
    wherever those are."""
    if traces and len(obj.dims) == 1:
        obj = obj.rename({obj.dims[0]: "x"}).expand_dims("trace")
    if len(obj.dims) != 2:
        raise SurfaceError(f"the array has {len(obj.dims)} dimensions; a map has 2", "shape")
    first, second = (str(dim).lower() for dim in obj.dims)
    if first in _ALONG_X or second in _ALONG_Y:
        if first in _ALONG_Y or second in _ALONG_X:
            raise SurfaceError(f"dimensions {first!r} and {second!r} lie along one axis; call them 'y' and 'x'", "shape")
        obj = obj.transpose(*reversed(obj.dims))
    steps: list[float | None] = []
    units: list[str | None] = []
    for dim in obj.dims:
        steps.append(None)
        units.append(None)
        if dim not in obj.coords or len(obj.coords[dim]) < 2 or traces and dim != obj.dims[1]:
            continue
        along = np.asarray(obj.coords[dim], dtype=float)
        step = (along[-1] - along[0]) / (len(along) - 1)
        if not np.max(np.abs(np.diff(along) - step)) <= UNEVEN * abs(step):
            raise SurfaceError(f"coordinate {dim!r} is not evenly spaced; interpolate it first", "uneven")
        unit = obj.coords[dim].attrs.get("units")
        steps[-1], units[-1] = abs(float(step)), None if unit is None else str(unit)
    return Foreign(obj, _units.own_unit(obj), (steps[0], steps[1]), (units[0], units[1]), str(obj.name or ""))
