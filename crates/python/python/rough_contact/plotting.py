"""Pictures on matplotlib axes, of arrays; matplotlib is imported on first use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _units
from ._extras import extra

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_NAMES = {
    "area_fraction": "area fraction",
    "touching_fraction": "touching points over all points",
    "mean_gap": "mean gap (m)",
    "real_pressure": "real pressure (Pa)",
}


def _axes(ax: Axes | None) -> Axes:
    plt = extra("matplotlib.pyplot", "plot")
    return plt.gca() if ax is None else ax


def heights(values: NDArray[np.float64], size: tuple[float, float], ax: Axes | None, unit: str, **imshow: Any) -> Axes:
    """A map of heights (m) on a rectangle (y, x) in metres: row 0 on top, x to the right."""
    axes = _axes(ax)
    scale = _units.unit_alone(unit, "unit")
    height, width = size
    options = {"extent": (0, width / scale, height / scale, 0), "interpolation": "nearest", **imshow}
    picture = axes.imshow(values / scale, **options)
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"y ({unit})")
    axes.figure.colorbar(picture, ax=axes, label=f"height ({unit})")
    return axes


def curve(
    pressure: NDArray[np.float64],
    values: NDArray[np.float64],
    half: NDArray[np.float64] | None,
    names: tuple[str, str],
    ax: Axes | None,
    unit: str,
    **errorbar: Any,
) -> Axes:
    """A number, of this name and unit, over the mean pressure (Pa), with half widths below and above."""
    axes = _axes(ax)
    options: dict[str, Any] = {"fmt": "o-", "capsize": 3, **errorbar}
    axes.errorbar(pressure / _units.unit_alone(unit, "unit", "pressure"), values, yerr=half, **options)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(f"mean pressure ({unit})")
    name, own = names
    axes.set_ylabel(_NAMES.get(name, f"{name.replace('_', ' ')} ({own})"))
    return axes


def traces(values: NDArray[np.float64], spacing: float, ax: Axes | None, unit: str, **line: Any) -> Axes:
    """Heights (m), one trace in each row, over their length."""
    axes = _axes(ax)
    scale = _units.unit_alone(unit, "unit")
    axes.plot(np.arange(values.shape[1]) * spacing / scale, values.T / scale, **line)
    axes.set_xlabel(f"x ({unit})")
    axes.set_ylabel(f"height ({unit})")
    return axes
