"""Elastic bodies."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal, Union

import numpy as np

from . import _rough_contact as _rust
from . import _units
from ._errors import SettingError, dumped, sorted_as
from ._units import Q
from .units import Pa

__all__ = ["Bodies", "Body", "contact_modulus", "material", "materials"]


@dataclass(frozen=True, init=False)
class Body:
    """An elastic body.

    Parameters
    ----------
    young : quantity
        Young's modulus.
    poisson : float
        Poisson's ratio, above -1 and at most 0.5.
    hardness : quantity, optional
        Highest pressure it bears before it yields; that of the softer body is used wherever it is known.
    name : str, optional
        What it is.

    Attributes
    ----------
    young, hardness : float
        In pascals.
    material : str or None
        Name in the table of materials that it was taken from by `material`.
    """

    young: float
    poisson: float
    hardness: float | None
    name: str
    material: str | None

    def __init__(self, *, young: Q, poisson: float, hardness: Q | None = None, name: str = "") -> None:
        values = {
            "young": _units.scalar(young, "pressure", "young"),
            "poisson": _units.number(poisson, "poisson"),
            "hardness": None if hardness is None else _units.scalar(hardness, "pressure", "hardness"),
            "name": name,
            "material": None,
        }
        for key, value in values.items():
            object.__setattr__(self, key, value)
        contact_modulus(self)  # refuses constants out of their domain

    def __reduce__(self) -> tuple[Any, ...]:
        return _body, (self.young, self.poisson, self.hardness, self.name, self.material)


Bodies = Union[Body, Sequence[Body]]


def _body(young: float, poisson: float, hardness: float | None, name: str, material: str | None) -> Body:
    own = None if hardness is None else hardness * Pa
    body = Body(young=young * Pa, poisson=poisson, hardness=own, name=name)
    object.__setattr__(body, "material", material)
    return body


def listed(bodies: Bodies) -> list[Body]:
    """One body or two."""
    all_ = [bodies] if isinstance(bodies, Body) else list(bodies)
    if not 1 <= len(all_) <= 2 or not all(isinstance(b, Body) for b in all_):
        raise TypeError("bodies takes one rc.Body, against a rigid one, or a pair")
    return all_


def _given(body: Body) -> dict[str, Any]:
    """What the crates need of it: of a material its name, so that they know what is of the table."""
    if body.material is not None:
        return {"material": body.material}
    return {"young": body.young, "poisson": body.poisson, "hardness": body.hardness}


def contact_modulus(first: Body, second: Body | None = None) -> float:
    """Contact modulus E* (Pa): 1/E* is the sum of (1 - nu^2)/E; without `second` the other body is rigid."""
    return float(given(None, first if second is None else (first, second))["modulus"])


def is_elastic(hardness: object) -> bool:
    """Whether no hardness is wanted."""
    return isinstance(hardness, str) and hardness.strip().lower() == "elastic"


def given(modulus: Q | None, bodies: Bodies | None, hardness: Q | Literal["elastic"] | None = None) -> dict[str, Any]:
    """Contact modulus, bodies, hardness and what was taken from the table of materials, as every question has them."""
    if (modulus is None) == (bodies is None):
        raise TypeError("give exactly one of modulus, such as modulus='110 GPa', and bodies")
    elastic = is_elastic(hardness)
    asked = {
        "modulus": None if modulus is None else _units.scalar(modulus, "pressure", "modulus"),
        "bodies": [] if bodies is None else [_given(body) for body in listed(bodies)],
        "hardness": None if hardness is None or elastic else _units.scalar(hardness, "pressure", "hardness", infinite=True),
        "elastic": elastic,
    }
    if asked["hardness"] == float("inf"):
        asked.update(hardness=None, elastic=True)
    with sorted_as(SettingError):
        found: dict[str, Any] = json.loads(_rust.bodies(dumped(asked)))
    return found


def materials() -> list[str]:
    """Names of the materials of the table, as the command ``rough-contact materials`` shows it."""
    return list(json.loads(_rust.material(None)))


def material(name: str) -> Body:
    """A material of the table as a `Body`: typical values at room temperature, in one condition.

    Parameters
    ----------
    name : str
        As ``'copper'``; one that is not there lists those near it.

    Returns
    -------
    Body
        With the hardness, where the table has one; its name holds the condition.

    Raises
    ------
    SettingError
        An unknown name, or a material whose Poisson's ratio has no source: give `Body` your own numbers.

    Examples
    --------
    >>> import rough_contact as rc
    >>> copper = rc.material('copper')
    >>> copper.young, copper.poisson
    (117000000000.0, 0.34)
    """
    with sorted_as(SettingError):
        found = json.loads(_rust.material(name))
    numbers = {key: listed["value"] for key, listed in found["numbers"].items() if listed is not None}
    if "poisson" not in numbers:
        raise SettingError(f"{name}: the table has no Poisson's ratio that a source could be named for; give rc.Body", "material")
    title = f"{found['title']}, {found['condition']}"
    return _body(numbers["young"], numbers["poisson"], numbers.get("hardness"), title, found["name"])


def joint(
    resistivity: Q | None, conductivity: Q | None, gas: str | dict[str, Any] | None, area: float | None
) -> dict[str, Any]:
    """What is asked of the conduction of a joint, as the crates take it."""
    found: dict[str, Any] = {}
    if resistivity is not None:
        found["resistivities"] = _units.pair(resistivity, "resistivity", "resistivity")
    if conductivity is not None:
        found["conductivities"] = _units.pair(conductivity, "conductivity", "conductivity")
    if gas is not None and gas != "vacuum":
        if conductivity is None:
            raise TypeError("gas conducts heat beside the contact; give conductivity, too")
        given: dict[str, Any] = {"gas": gas} if isinstance(gas, str) else dict(gas)
        unknown = [key for key in given if key not in ("gas", "temperature", "pressure", "accommodation")]
        if given.get("gas") not in ("air", "helium", "argon", "nitrogen") or unknown:
            raise SettingError(
                "gas takes 'vacuum', 'air', 'helium', 'argon', 'nitrogen', or a dict of gas, temperature (K), pressure and "
                "accommodation",
                "gas",
            )
        if "pressure" in given:
            given["pressure"] = _units.scalar(given["pressure"], "pressure", "gas pressure")
        if "temperature" in given:
            given["temperature"] = _units.number(given["temperature"], "gas temperature, in kelvin,")
        if "accommodation" in given:
            both = given["accommodation"]
            numbers = [_units.number(one, "gas accommodation") for one in (both if isinstance(both, (list, tuple, np.ndarray)) else [both])]
            if not 1 <= len(numbers) <= 2:
                raise SettingError(f"gas accommodation = {both!r} takes one number for both bodies, or two", "gas")
            given["accommodation"] = [numbers[0], numbers[-1]]
        found["gas"] = given
    if found and area is not None:
        found["area"] = area
    return found


def adhesion(work: Q | None, reach: Q | None) -> dict[str, float] | None:
    """A work of adhesion, as the crates take it."""
    if work is None:
        if reach is not None:
            raise TypeError("attraction_range is that of a work_of_adhesion, and none is given")
        return None
    found = {
        "work": _units.scalar(work, "energy_per_area", "work_of_adhesion"),
        "range": 0.3e-9 if reach is None else _units.scalar(reach, "length", "attraction_range"),
    }
    if not (found["work"] >= 0 and found["range"] > 0):
        raise SettingError("work_of_adhesion takes 0 or more, attraction_range a distance above 0", "work_of_adhesion")
    return found


def leak(
    along: str | None, viscosity: Q | None, pressure_drop: Q | None, seal_length: Q | None, seal_width: Q | None
) -> dict[str, Any] | None:
    """What is asked of the leak, as the crates take it."""
    seal = (
        None if viscosity is None else _units.scalar(viscosity, "viscosity", "viscosity"),
        None if pressure_drop is None else _units.scalar(pressure_drop, "pressure", "pressure_drop"),
        None if seal_length is None else _units.scalar(seal_length, "length", "seal_length"),
        None if seal_width is None else _units.scalar(seal_width, "length", "seal_width"),
    )
    with sorted_as(SettingError):
        found: dict[str, Any] | None = json.loads(_rust.leak(along, seal))
    return found
