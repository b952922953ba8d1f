"""Closed forms: the built-in ones, and one's own."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _rough_contact as _rust
from . import _units
from ._errors import ModelError
from ._statistics import Statistics

__all__ = ["Citation", "ContactModel", "Inputs", "ModelInfo", "models"]


@dataclass(frozen=True)
class Citation:
    """Where a model was published."""

    authors: str
    year: int
    title: str
    journal: str
    doi: str


@dataclass(frozen=True)
class ModelInfo:
    """A built-in model: its name for `compare`, its source, what it needs and where it holds."""

    name: str
    title: str
    citation: Citation
    inputs: str
    domain: str
    separation: bool


def models() -> list[ModelInfo]:
    """Every built-in model."""
    return [ModelInfo(**{**card, "citation": Citation(**card["citation"])}) for card in json.loads(_rust.models())]


@dataclass(frozen=True)
class Inputs:
    """What a model of one's own may use: the numbers that the built-in ones get. SI units.

    Attributes
    ----------
    modulus : float
        Contact modulus E* (Pa).
    rms_height, rms_gradient, m0, m2, m4, bandwidth, hurst, rolloff, cutoff
        Statistics of the levelled map, moments by finite differences of profiles (Nayak, 1971); None where the
        map has none.
    asperities : dict or None
        ``density``, ``radius``, ``height_std``, ``mean_offset``.
    statistics : Statistics
        All the others.
    """

    modulus: float
    rms_height: float
    rms_gradient: float
    m0: float
    m2: float
    m4: float
    bandwidth: float | None
    hurst: float | None
    rolloff: float | None
    cutoff: float | None
    asperities: dict[str, float] | None
    statistics: Statistics

    @classmethod
    def _of(cls, modulus: float, s: Statistics) -> Inputs:
        names = ("rms_height", "rms_gradient", "m0", "m2", "m4", "bandwidth", "hurst", "rolloff", "cutoff", "asperities")
        return cls(modulus=modulus, statistics=s, **{name: getattr(s, name) for name in names})


@runtime_checkable
class ContactModel(Protocol):
    """A model of one's own: anything with a name and an area fraction.

    Optional: ``citation`` (str), ``title`` (str), ``mean_gap(pressure, inputs)`` in metres, and ``applies(inputs)``,
    which returns True, or False or the reason why not.
    """

    name: str

    def area_fraction(self, pressure: NDArray[np.float64], inputs: Inputs) -> ArrayLike:
        """Area fraction at nominal pressures (Pa), shape (n,) to (n,); NaN where there is no answer, which stays without one."""


def curve(model: ContactModel, pressures: list[float], inputs: Inputs) -> dict[str, Any]:
    """What a model says of one surface, as the crates take it: points, or the reason why there are none."""
    applies: Callable[[Inputs], bool | str] | None = getattr(model, "applies", None)
    if applies is not None:
        answer = applies(inputs)
        if not isinstance(answer, (bool, np.bool_, str)):
            raise ModelError(f"{model.name}: applies returned {answer!r}; return True, or False or the reason why not as text", "model")
        if isinstance(answer, str) or not answer:
            return {"Err": answer if isinstance(answer, str) else "a surface of another kind"}
    asked = np.array(pressures)
    asked.setflags(write=False)
    areas = _vector(model, "area_fraction", asked, inputs)
    gaps = _vector(model, "mean_gap", asked, inputs) if hasattr(model, "mean_gap") else None
    points, holes = [], []
    for i, (pressure, area) in enumerate(zip(pressures, areas)):
        if np.isnan(area):
            holes.append(pressure)
            continue
        if not 0.0 <= area <= 1.0:
            raise ModelError(f"{model.name}: area fraction {area} at {pressure} Pa is not from 0 to 1", "model")
        gap = None if gaps is None or np.isnan(gaps[i]) else float(gaps[i])
        if gap is not None and not 0.0 <= gap < np.inf:
            raise ModelError(f"{model.name}: mean gap {gap} m at {pressure} Pa is no distance", "model")
        points.append({"mean_pressure": pressure, "area_fraction": float(area), "mean_gap": gap})
    if not points:
        raise ModelError(f"{model.name}: NaN at every load; a model that does not apply says so by applies(inputs)", "model")
    return {"Ok": {"points": points, "holes": holes}}


def _vector(model: ContactModel, method: str, pressures: NDArray[np.float64], inputs: Inputs) -> NDArray[np.float64]:
    found = getattr(model, method)(pressures, inputs)
    kind = "number" if method == "area_fraction" else "length"
    try:
        name = f"{model.name}: {method}"
        values = _units.plain(found, name) if _units.own_unit(found) is None else _units.array(found, kind, name)
    except TypeError as error:
        raise ModelError(str(error), "model") from None
    if values.shape != pressures.shape:
        raise ModelError(f"{model.name}: {method} has shape {values.shape} for {pressures.shape[0]} loads", "model")
    return values
