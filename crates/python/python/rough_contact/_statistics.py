"""Roughness statistics."""

from __future__ import annotations

import copy
from dataclasses import dataclass, field, fields
from html import escape
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _units
from ._extras import extra
from ._findings import Finding, findings_html

__all__ = ["Statistics"]


@dataclass(frozen=True, repr=False)
class Statistics(_units.Kept):
    """Roughness statistics of a map: the keys of ``rough-contact stats --json``. SI units.

    What a map does not have is None. `units` gives the unit of every number.
    """

    shape: tuple[int, int]
    pixel: tuple[float, float] = field(metadata={"unit": "m"})
    level: str = field(metadata={"unit": ""})
    boundary: str = field(metadata={"unit": ""})
    missing: int = field(metadata={"unit": "1"})
    # <!-- begin numbers -->
    rms_height: float = field(metadata={"unit": "m"})
    mean_abs_height: float = field(metadata={"unit": "m"})
    skewness: float | None = field(metadata={"unit": "1"})
    kurtosis: float | None = field(metadata={"unit": "1"})
    peak_height: float = field(metadata={"unit": "m"})
    pit_depth: float = field(metadata={"unit": "m"})
    rms_gradient: float = field(metadata={"unit": "1"})
    m0: float = field(metadata={"unit": "m2"})
    m2: float = field(metadata={"unit": "1"})
    m4: float = field(metadata={"unit": "m-2"})
    m2_x: float = field(metadata={"unit": "1"})
    m2_y: float = field(metadata={"unit": "1"})
    m4_x: float = field(metadata={"unit": "m-2"})
    m4_y: float = field(metadata={"unit": "m-2"})
    m0_spectral: float = field(metadata={"unit": "m2"})
    m2_spectral: float = field(metadata={"unit": "1"})
    m4_spectral: float = field(metadata={"unit": "m-2"})
    bandwidth: float | None = field(metadata={"unit": "1"})
    anisotropy: float | None = field(metadata={"unit": "1"})
    hurst: float | None = field(metadata={"unit": "1"})
    dimension: float | None = field(metadata={"unit": "1"})
    roughness: float | None = field(metadata={"unit": "m"})
    rolloff: float | None = field(metadata={"unit": "m"})
    cutoff: float | None = field(metadata={"unit": "m"})
    max_amplitude_ratio: float = field(metadata={"unit": "1"})
    record_length: float = field(metadata={"unit": "m"})
    height_step: float | None = field(metadata={"unit": "m"})
    noise_rms: float | None = field(metadata={"unit": "m"})
    reliable_wavelength: float | None = field(metadata={"unit": "m"})
    # <!-- end numbers -->
    asperities: dict[str, float] | None = field(metadata={"unit": ""})
    summits: dict[str, Any] = field(metadata={"unit": ""})
    fractal_range: tuple[float, float] | None = field(metadata={"unit": "m"})
    warnings: tuple[dict[str, Any], ...] = field(metadata={"unit": ""})
    findings: tuple[Finding, ...] = field(metadata={"unit": ""})
    cleaning: tuple[dict[str, Any], ...] = field(metadata={"unit": ""})
    #: Areal parameters of ISO 25178-2 by their symbols (SI units, Std in degrees), if they were asked for.
    iso25178: dict[str, float | None] | None = field(metadata={"unit": ""})
    #: If asked for, along ``'x'`` and ``'y'``, arrays over ``'distance'`` (m): rms ``'slope'``, rms ``'curvature'`` (1/m) and
    #: ``'autocorrelation'``; NaN where there is none.
    scales: dict[str, dict[str, NDArray[np.float64]]] | None = field(compare=False, metadata={"unit": ""})
    json: dict[str, Any] = field(repr=False, compare=False, default_factory=dict)

    @classmethod
    def _of(cls, json: dict[str, Any]) -> Statistics:
        values: dict[str, Any] = {}
        for f in fields(cls):
            value = json.get(f.name)
            if f.name in ("shape", "pixel", "fractal_range", "warnings", "cleaning"):
                value = None if value is None else tuple(value)
            elif f.name == "findings":
                value = tuple(Finding._of(x) for x in json["findings"])
            elif f.name == "scales" and value is not None:
                value = {axis: {k: np.array([d[k] for d in all_], dtype=float) for k in all_[0]} for axis, all_ in value.items()}
                _units.read_only(value)
            elif f.name == "json":
                value = json
            values[f.name] = value
        return cls(**values)

    @classmethod
    def units(cls) -> dict[str, str]:
        """The unit of every number; ``'1'`` for pure ones."""
        return {f.name: f.metadata["unit"] for f in fields(cls) if f.metadata.get("unit")}

    def to_dict(self) -> dict[str, Any]:
        """The object of ``rough-contact stats --json``."""
        return copy.deepcopy(self.json)

    def to_pandas(self) -> Any:
        """A `pandas.Series` of the plain numbers, units in ``attrs``."""
        pandas = extra("pandas", "tables")

        series = pandas.Series({name: getattr(self, name) for name in self.units() if name != "pixel"}, dtype=object)
        series = series[[isinstance(x, (int, float)) for x in series]].astype(float)
        series.attrs["units"] = self.units()
        return series

    def __repr__(self) -> str:
        ny, nx = self.shape
        open_ = sum(f.weight != "passed" for f in self.findings)
        return (
            f"Statistics({ny} x {nx} points, rms height {self.rms_height:.4g} m, "
            f"rms gradient {self.rms_gradient:.4g}, {open_} findings)"
        )

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><td>{name}</td><td style='text-align:right'>{getattr(self, name):.5g}</td>"
            f"<td>{escape(unit) if unit != '1' else ''}</td></tr>"
            for name, unit in self.units().items()
            if isinstance(getattr(self, name), (int, float))
        )
        return f"{findings_html(self.findings)}<table>{rows}</table>"
