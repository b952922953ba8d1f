"""Profiles: traces of a stylus."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import _rough_contact as _rust
from . import _units, plotting
from ._errors import SurfaceError, dumped, of_file, sorted_as
from ._foreign import of_xarray
from ._surface import LEVELS, Crop, File, Fill, Level, check, cleaned_by, file_of, length, metres, opened, reading
from ._threads import count
from ._units import Q

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["Profile", "read_profile"]


@dataclass(frozen=True, repr=False, eq=False)
class Profile(_units.Kept):
    """Traces of one surface, complete and at equal distances, with what they say of it.

    A profile says nothing of what lies beside it; it has a deterministic contact only as the cross-section of long
    parallel ridges, ``rc.solve(profile, plane_strain=True)``.

    Attributes
    ----------
    heights : ndarray, shape (traces, points)
        Heights (m), one trace in each row, before form and filters are taken off; read-only.
    spacing : float
        Distance of neighbouring points (m).
    format : str
        Format of the file.
    json : dict
        What ``rough-contact stats --json`` answers.
    path : str
        The file.
    """

    heights: NDArray[np.float64]
    spacing: float
    format: str
    json: dict[str, Any]
    path: str
    _facts: str

    @classmethod
    def of(
        cls,
        heights: Any,
        *,
        spacing: Q,
        height_unit: str | None = None,
        outliers: float | None = None,
        form: str | None = None,
        s_filter: Q | None = None,
        l_filter: Q | None = None,
        fill: Fill = "refuse",
        level: Level = "auto",
    ) -> Profile:
        """Traces of an array, one or one in each row; the rest is as of `read_profile`.

        Examples
        --------
        >>> import numpy as np, rough_contact as rc
        >>> rc.Profile.of(np.sin(np.arange(8000) / 50), spacing='0.5 um', height_unit='um')
        Profile(1 trace of 8000 points, 500 nm apart)
        """
        apart = _units.scalar(spacing, "length", "spacing")
        if _units.is_xarray(heights):
            found = of_xarray(heights, traces=True)
            found.pixel(None, (apart, apart), "spacing")
            heights = found.heights
        rows = np.atleast_2d(metres(heights, height_unit))
        if rows.ndim != 2:
            raise SurfaceError(f"heights have {rows.ndim} dimensions; traces have 1, or 2 with one in each row", "shape")
        if rows.shape[1] < 2:
            many = f"{rows.shape[0]} rows of {rows.shape[1]} points, and each row is a trace"
            raise SurfaceError(f"heights have {many}; of one trace in a column give heights.T", "shape")
        said = {"pixel": [apart] * 2}
        request = {"file": file_of(said, fill, cleaned_by(False, outliers, form, s_filter, l_filter))}
        with sorted_as(SurfaceError):
            return cls._taken("heights", request, level, rows=rows)

    @classmethod
    def _taken(
        cls,
        file: str,
        request: dict[str, Any],
        level: Level,
        content: bytes | None = None,
        rows: NDArray[np.float64] | None = None,
    ) -> Profile:
        check("level", level, LEVELS)
        heights, spacing, format_, facts, text = _rust.profile(file, dumped(request), level, count(None), content, rows)
        return cls(heights, spacing, format_, json.loads(text), file, facts)

    def plot(self, ax: Axes | None = None, *, unit: str = "um", **line: Any) -> Axes:
        """The traces on matplotlib axes."""
        return plotting.traces(self.heights, self.spacing, ax, unit, **line)

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{escape(name)}</td><td style='text-align:right'>{'–' if value is None else f'{value:.4g}'}</td></tr>"
            for name, value in (self.roughness or self.primary).items()
        )
        return f"<p>{escape(repr(self))}</p><table>{rows}</table>"

    def __repr__(self) -> str:
        traces, points = self.heights.shape
        many = "1 trace" if traces == 1 else f"{traces} traces"
        return f"Profile({many} of {points} points, {length(self.spacing)} apart)"

    @property
    def name(self) -> str:
        """Name of the file."""
        return os.path.basename(self.path)

    @property
    def roughness(self) -> dict[str, float | None]:
        """Parameters of the roughness profile (ISO 21920-2), means over the traces, ``['Ra']`` (m); empty of a short trace."""
        found = self.json["roughness"]
        return {name: number["mean"] for name, number in found["parameters"].items()} if found else {}

    @property
    def primary(self) -> dict[str, float | None]:
        """Parameters of the whole trace without its form (ISO 21920-2), means over the traces: ``primary['Pq']`` (m)."""
        return {name: number["mean"] for name, number in self.json["primary"].items()}

    def to_dict(self) -> dict[str, Any]:
        """The object of ``rough-contact stats --json``."""
        return copy.deepcopy(self.json)


def read_profile(
    path: File,
    *,
    channel: str | None = None,
    pixel: Q | None = None,
    lateral_unit: str | None = None,
    height_unit: str | None = None,
    override_height_unit: str | None = None,
    layout: Literal["matrix", "list", "traces"] | None = None,
    decimal: Literal["point", "comma"] | None = None,
    missing: str | Sequence[str] = (),
    crop: Crop | None = None,
    outliers: float | None = None,
    form: str | None = None,
    s_filter: Q | None = None,
    l_filter: Q | None = None,
    fill: Fill = "refuse",
    level: Level = "auto",
) -> Profile:
    """Reads the traces of a stylus and takes their statistics, as ``rough-contact stats`` of a profile.

    Parameters
    ----------
    path : str or path
        The file.
    channel, pixel, lateral_unit, height_unit, override_height_unit, layout, decimal, missing, crop, outliers, fill
        As of `read`.
    form : str, optional
        Form to take off before: 'plane', 'quadratic', 'polynomial:N'.
    s_filter, l_filter : quantity, optional
        Cut-offs (m) of the Gaussian profile filters (ISO 16610-21); by default those of ISO 21920-3 for the trace.
    level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
        Polynomial that levels each trace: a line (also 'auto'), none but the mean, a parabola.

    Returns
    -------
    Profile
        Traces and statistics.

    Raises
    ------
    ReadError
        The file cannot be read, leaves something open, or is a map.
    MissingPoints
        Points are missing, and none are filled.
    """
    cleaning = cleaned_by(False, outliers, form, s_filter, l_filter)
    request = reading(
        channel, pixel, lateral_unit, height_unit, override_height_unit, layout, decimal, missing, crop, fill, cleaning
    )
    with of_file():
        file, content = opened(path)
        return Profile._taken(file, request, level, content)
