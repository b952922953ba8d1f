"""Heights of other packages, told by what they have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from . import _units
from ._errors import SurfaceError, UnitError

#: Largest deviation of the steps of a coordinate from equal ones.
UNEVEN = 1e-6


@dataclass(frozen=True)
class Foreign:
    """What an object says of a surface; lengths in its own units."""

    heights: Any
    unit: str | None
    pixel: tuple[float, float] | None
    pixel_units: tuple[str | None, str | None]
    repeats: bool | None
    name: str

    def pixel_in(self, unit: str) -> list[_units.Quantity]:
        """The pixel, in `unit` where the object gives no other."""
        if self.pixel is None:
            raise UnitError("the object has no spacing of points; give pixel='1um'", "unit")
        scales = [_units.factor(own or unit) for own in self.pixel_units]
        return [step * scale * _units.m for step, scale in zip(self.pixel, scales)]


def heights_of(obj: Any) -> Foreign:
    """What SurfaceTopography, surfalize or xarray say."""
    if hasattr(obj, "physical_sizes") and callable(getattr(obj, "heights", None)):
        return _surface_topography(obj)
    if hasattr(obj, "step_x") and hasattr(obj, "step_y") and hasattr(obj, "data"):
        return _surfalize(obj)
    if hasattr(obj, "coords") and hasattr(obj, "dims") and hasattr(obj, "attrs"):
        return _xarray(obj)
    raise TypeError(
        f"{type(obj).__name__} is none of SurfaceTopography, surfalize and xarray; "
        "give its heights to Surface(heights, pixel=, height_unit=)"
    )


def _surface_topography(obj: Any) -> Foreign:
    if len(obj.physical_sizes) != 2:
        raise SurfaceError("a line scan is a profile, and no map", "profile")
    # x comes first there.
    heights = np.ma.filled(np.ma.asarray(obj.heights()).astype(float), np.nan).T
    nx, ny = obj.nb_grid_pts
    width, height = obj.physical_sizes
    unit = getattr(obj, "unit", None)
    # Whether it is periodic is said by most readers for want of anything better: the edges tell.
    return Foreign(heights, unit, (height / ny, width / nx), (unit, unit), None, "")


def _surfalize(obj: Any) -> Foreign:
    pixel = (float(obj.step_y), float(obj.step_x))
    return Foreign(np.asarray(obj.data), "um", pixel, ("um", "um"), None, "")


def _xarray(obj: Any) -> Foreign:
    if len(obj.dims) != 2:
        raise SurfaceError(f"the array has {len(obj.dims)} dimensions; a map has 2", "shape")
    steps: list[float] = []
    units: list[str | None] = []
    for dim in obj.dims:
        if dim not in obj.coords:
            steps = []
            break
        along = np.asarray(obj.coords[dim], dtype=float)
        step = (along[-1] - along[0]) / (len(along) - 1)
        if np.max(np.abs(np.diff(along) - step)) > UNEVEN * abs(step):
            raise SurfaceError(f"coordinate {dim!r} is not evenly spaced; interpolate it first", "uneven")
        steps.append(abs(float(step)))
        units.append(obj.coords[dim].attrs.get("units"))
    pixel = (steps[0], steps[1]) if len(steps) == 2 else None
    own = (units[0], units[1]) if len(units) == 2 else (None, None)
    return Foreign(np.asarray(obj), obj.attrs.get("units"), pixel, own, None, str(obj.name or ""))
