"""Pictures on matplotlib axes; matplotlib is imported on first use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib.pyplot as plt

from . import _units

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._results import LoadCurve
    from ._surface import Surface

_NAMES = {
    "area_fraction_corrected": "area fraction",
    "area_fraction": "area fraction, counted",
    "mean_gap": "mean gap (m)",
    "real_pressure_corrected": "real pressure (Pa)",
}


def heights(surface: Surface, ax: Axes | None = None, unit: str = "um", **imshow: Any) -> Axes:
    """A map of heights: row 0 on top, x to the right."""
    axes = plt.gca() if ax is None else ax
    scale = _units.factor(unit)
    height, width = surface.size
    options = {"extent": (0, width / scale, height / scale, 0), "interpolation": "nearest", **imshow}
    picture = axes.imshow(surface.heights / scale, **options)
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"y ({unit})")
    axes.figure.colorbar(picture, ax=axes, label=f"height ({unit})")
    return axes


def curve(
    found: LoadCurve, ax: Axes | None = None, y: str = "area_fraction_corrected", bars: bool = True,
    unit: str = "MPa", **errorbar: Any,
) -> Axes:
    """A number over the mean pressure, with its bars where it has them."""
    axes = plt.gca() if ax is None else ax
    scale = _units.factor(unit, "pressure")
    options: dict[str, Any] = {"fmt": "o-", "capsize": 3, **errorbar}
    try:
        half = found.bars(y) if bars else None
    except KeyError:
        half = None
    axes.errorbar(found.mean_pressure / scale, getattr(found, y), yerr=half, **options)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(f"mean pressure ({unit})")
    axes.set_ylabel(_NAMES.get(y, f"{y.replace('_', ' ')} ({found.units().get(y, '')})"))
    return axes
