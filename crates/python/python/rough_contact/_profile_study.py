"""Closed forms on profiles, beside each other."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Union

from . import _bodies, _units
from . import _named as _names
from . import _rough_contact as _rust
from ._bodies import Bodies
from ._documents import Documents
from ._errors import SettingError, dumped, sorted_as
from ._profile import Profile
from ._results import pressure as shown
from ._surface import LEVELS, Level, check
from ._threads import count
from ._units import Q

__all__ = ["ProfileComparison", "compare_profiles"]

Profiles = Union[Profile, list[Profile], tuple[Profile, ...], Mapping[str, Profile]]


@dataclass(frozen=True, repr=False)
class ProfileComparison(Documents):
    """What closed forms say of profiles, beside each other: a profile has no deterministic contact to judge them by.

    Attributes
    ----------
    files : dict
        The documents by their names: ``results.json``, ``report.html``, ``curves.csv``, ``run.toml``, figures.
    """

    @property
    def profiles(self) -> dict[str, dict[str, Any]]:
        """The profiles by name, as in ``results.json``."""
        return {profile["name"]: profile for profile in self.to_dict()["profiles"]}

    def __getitem__(self, name: str) -> dict[str, Any]:
        return self.profiles[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.profiles)

    def __len__(self) -> int:
        return len(self.json["profiles"])

    def __repr__(self) -> str:
        lines = [f"ProfileComparison({'1 profile' if len(self) == 1 else f'{len(self)} profiles'})"]
        for name, profile in self.profiles.items():
            span = profile["span"]
            said = "no model answers"
            if span is not None:
                low, high = (100 * area for area in span["area_fraction"])
                said = f"area {low:.3g} to {high:.3g} % by {span['models']} models"
            lines.append(f"  {name}: {said} at {shown(profile['headline_pressure'])}")
        return "\n".join(lines)


def compare_profiles(
    profiles: Profiles,
    *,
    modulus: Q | None = None,
    bodies: Bodies | None = None,
    pressure: Q | None = None,
    headline: Q | None = None,
    models: str | Sequence[str] | None = None,
    hardness: Q | Literal["elastic"] | None = None,
    level: Level = "auto",
    fractal_range: Q | None = None,
) -> ProfileComparison:
    """What the closed forms say of the traces of a stylus: ``rough-contact compare`` of profiles.

    Parameters
    ----------
    profiles : Profile, list, tuple or mapping
        The keys of a mapping name them.
    modulus : quantity
        Contact modulus E*; or `bodies`.
    pressure : quantity or list, optional
        Nominal pressures; by default those at which 0.1 % to about half of the surface touches.
    headline : quantity, optional
        The pressure of the headline, one of `pressure`.
    models : str or list, optional
        Names of built-in models; every one by default.
    hardness : 'elastic', optional
        Leaves out what `bodies` know of it: the models of profiles are of elastic bodies.
    level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
        Polynomial that levels each trace: a line (also 'auto'), none but the mean, a parabola.
    fractal_range : quantity, optional
        As the option of the command.

    Returns
    -------
    ProfileComparison
        With 95 % intervals of the areas by the length of the traces.

    Examples
    --------
    >>> import numpy as np, rough_contact as rc
    >>> rng = np.random.default_rng(1)
    >>> heights = np.convolve(rng.normal(size=8200), np.hanning(60), 'same')[100:8100] * 0.05
    >>> trace = rc.Profile.of(heights, spacing='0.5um', height_unit='um')
    >>> len(rc.compare_profiles(trace, modulus='110 GPa', pressure='10MPa,100MPa'))
    1
    """
    check("level", level, LEVELS)
    named = _names.named(profiles, Profile, "; see rc.read_profile")
    settings: dict[str, Any] = {
        **_bodies.given(modulus, bodies, hardness),
        "level": level,
        "edges": "periodic",
        "method": "auto",
        "precision": "f64",
        "tolerance": 1e-4,
        "threads": count(None),
    }
    if pressure is not None:
        settings["pressures"] = sorted(set(_units.several(pressure, "pressure", "pressure")))
    if headline is not None:
        settings["headline"] = _units.scalar(headline, "pressure", "headline")
    if models is not None:
        names = [models] if isinstance(models, str) else models
        settings["models"] = [_units.text(name, "models", "gw") for name in names]
    if fractal_range is not None:
        settings["fractal_range"] = _units.ends(fractal_range, "fractal_range")
    given = [(p.heights, p._facts, name) for name, p in named.items()]
    with sorted_as(SettingError):
        files = _rust.profile_study(given, dumped(settings))
    return ProfileComparison(files)
