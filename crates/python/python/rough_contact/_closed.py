"""One closed form, from a surface or from numbers."""

from __future__ import annotations

import copy
import json
import math
from dataclasses import dataclass, field
from html import escape
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

from . import _bodies, _units
from . import _rough_contact as _rust
from ._bodies import Bodies
from ._errors import ModelError, SettingError, dumped, made, sorted_as
from ._extras import extra
from ._findings import Finding, findings_html
from ._models import Citation
from ._profile import Profile
from ._results import flat, made_of, pressure as shown
from ._surface import LEVELS, Flip, Level, Surface, check, laid
from ._threads import count
from ._units import Q

__all__ = ["Asperities", "ClosedForm", "Fractal", "ModelCurve", "Moments", "Numbers", "SelfAffine", "model"]


def _kinds() -> dict[str, tuple[str, str]]:
    """Unit and meaning of every number that a model may be made from, by its name here."""
    found = json.loads(_rust.model_inputs())
    return {fact["name"].replace("-", "_"): (fact["unit"], fact["help"]) for fact in found}


class _Roughness:
    """Numbers typed in; SI floats as attributes."""

    _fields: dict[str, str] = {}  # attribute: name of the input

    def _set(self, **values: Q | float | None) -> None:
        kinds = _kinds()
        for name, value in values.items():
            object.__setattr__(self, name, None if value is None else _one(value, kinds[self._fields[name]][0], name))

    def _given(self) -> dict[str, list[float]]:
        named = ((name, getattr(self, name)) for name in self._fields)
        return {self._fields[name].replace("_", "-"): [value] for name, value in named if value is not None}


def _one(value: Any, unit: str, name: str) -> float:
    return _units.number(value, name) if unit == "number" else _units.scalar(value, unit, name)


@dataclass(frozen=True, init=False)
class Moments(_Roughness):
    """Spectral moments of profiles (Nayak, 1971), mean of both axes: mean square height (an area), slope (a number), second
    derivative (per area). Persson's theories need m2 only."""

    m0: float | None
    m2: float
    m4: float | None
    _fields = {"m0": "m0", "m2": "m2", "m4": "m4"}

    def __init__(self, *, m0: Q | None = None, m2: float, m4: Q | None = None) -> None:
        self._set(m0=m0, m2=m2, m4=m4)


@dataclass(frozen=True, init=False)
class Asperities(_Roughness):
    """Asperities: number per area, radius, standard deviation of their heights, mean height above the mean plane."""

    density: float
    radius: float
    height_std: float
    mean_offset: float
    _fields = {
        "density": "asperity_density",
        "radius": "asperity_radius",
        "height_std": "asperity_height_std",
        "mean_offset": "mean_offset",
    }

    def __init__(self, *, density: Q, radius: Q, height_std: Q, mean_offset: Q = "0m") -> None:
        self._set(density=density, radius=radius, height_std=height_std, mean_offset=mean_offset)


@dataclass(frozen=True, init=False)
class SelfAffine(_Roughness):
    """A self-affine spectrum: Hurst exponent, longest and shortest wavelength of its power law, mean square height, and the longest
    wavelength of all where a plateau lies above the power law."""

    hurst: float
    rolloff: float
    cutoff: float
    m0: float
    longest: float | None
    _fields = {"hurst": "hurst", "rolloff": "rolloff", "cutoff": "cutoff", "m0": "m0", "longest": "longest"}

    def __init__(self, *, hurst: float, rolloff: Q, cutoff: Q, m0: Q, longest: Q | None = None) -> None:
        self._set(hurst=hurst, rolloff=rolloff, cutoff=cutoff, m0=m0, longest=longest)


@dataclass(frozen=True, init=False)
class Fractal(_Roughness):
    """A fractal surface: dimension (of a profile, 1 to 2, for majumdar-bhushan; of the surface, 2 to 3, for yan-komvopoulos), roughness
    G, nominal area, area below which spots carry nothing."""

    dimension: float
    roughness: float
    area: float
    critical_area: float | None
    _fields = {"dimension": "dimension", "roughness": "roughness", "area": "area", "critical_area": "critical_area"}

    def __init__(self, *, dimension: float, roughness: Q, area: Q, critical_area: Q | None = None) -> None:
        self._set(dimension=dimension, roughness=roughness, area=area, critical_area=critical_area)


class Numbers(_Roughness):
    """Any numbers that a model is made from, by the names of the command's options with underscores, lists as lists.

    Examples
    --------
    >>> import rough_contact as rc
    >>> spheres = rc.Numbers(sphere_radius='1mm,10um', sphere_density='1mm^-2,1e4mm^-2')
    >>> found = rc.model('archard', spheres, modulus='110 GPa', pressure='1MPa')
    """

    def __init__(self, **values: Q | float) -> None:
        kinds = _kinds()
        unknown = [name for name in values if name not in kinds]
        if unknown:
            raise TypeError(f"{unknown[0]} is no input of a model; there are {', '.join(kinds)}")
        self._values = {}
        each: dict[str, Any] = values
        for name, value in each.items():
            unit = kinds[name][0]
            if unit == "numbers":
                several = value.split(",") if isinstance(value, str) else np.atleast_1d(value).tolist()
                found = [_units.number(one, name) for one in several]
            elif unit.endswith("s"):
                found = _units.several(value, {"lengths": "length", "per_areas": "per_area"}[unit], name)
            else:
                found = [_one(value, unit, name)]
            self._values[name] = found

    def __repr__(self) -> str:
        return f"Numbers({', '.join(f'{k}={v if len(v) > 1 else v[0]!r}' for k, v in self._values.items())})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Numbers) and self._values == other._values

    def __hash__(self) -> int:
        return hash(repr(self))

    def _given(self) -> dict[str, list[float]]:
        return {name.replace("_", "-"): values for name, values in self._values.items()}


Source = Union[Surface, Profile, Moments, Asperities, SelfAffine, Fractal, Numbers]

_NUMBERS = ("mean_pressure", "area_fraction", "real_pressure", "separation", "mean_gap")


@dataclass(frozen=True, repr=False, eq=False)
class ModelCurve:
    """What a closed form answers: the keys of ``rough-contact model --json`` as vectors, SI units, NaN without answer."""

    json: dict[str, Any] = field(repr=False)

    mean_pressure: NDArray[np.float64] = field(init=False)
    area_fraction: NDArray[np.float64] = field(init=False)
    real_pressure: NDArray[np.float64] = field(init=False)
    separation: NDArray[np.float64] = field(init=False)
    mean_gap: NDArray[np.float64] = field(init=False)

    def __post_init__(self) -> None:
        for name in _NUMBERS:
            vector = np.array([point[name] for point in self.json["points"]], dtype=np.float64)  # of None NaN
            vector.setflags(write=False)
            object.__setattr__(self, name, vector)

    def __reduce__(self) -> tuple[Any, ...]:
        return ModelCurve, (self.json,)

    def __len__(self) -> int:
        return len(self.json["points"])

    @property
    def name(self) -> str:
        """Name of the model."""
        return str(self.json["model"])

    @property
    def citation(self) -> Citation:
        """Where it was published."""
        return Citation(**self.json["citation"])

    @property
    def inputs(self) -> dict[str, Any]:
        """What it was given."""
        return copy.deepcopy(self.json["inputs"])

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What may change a conclusion, worst first."""
        return tuple(Finding._of(finding) for finding in self.json["findings"])

    @property
    def caveats(self) -> list[str | None]:
        """Of each answer, what strains an assumption."""
        return [point["caveat"] and point["caveat"]["message"] for point in self.json["points"]]

    @property
    def errors(self) -> list[ModelError | None]:
        """Of each question without an answer, why."""
        found = [point["error"] for point in self.json["points"]]
        return [e and ModelError(e["message"], e["kind"]) for e in found]

    def to_dict(self) -> dict[str, Any]:
        """The object of ``rough-contact model --json``."""
        return copy.deepcopy(self.json)

    def records(self) -> list[dict[str, Any]]:
        """A flat dict for each question."""
        return [flat(point) for point in self.json["points"]]

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of one line for each question."""
        pandas = extra("pandas", "tables")

        return pandas.DataFrame(self.records())

    def _rows(self) -> list[str]:
        rows = []
        for point, error, caveat in zip(self.json["points"], self.errors, self.caveats):
            area = point["area_fraction"]
            what = str(error) if area is None else f"area {100 * area:.4g} %" + (f" (caution: {caveat})" if caveat else "")
            rows.append(f"{shown(point['mean_pressure'])}: {what}")
        return rows

    def __repr__(self) -> str:
        c = self.citation
        doi = f", doi:{c.doi}" if c.doi else ""
        head = f"ModelCurve({self.name!r}, {c.authors} {c.year}{doi}; {made_of(self.json)})"
        checks = [f"  {finding}" for finding in self.findings if finding.weight == "check"]
        return "\n".join([head, *checks, *(f"  {row}" for row in self._rows())])

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{escape(row)}</td></tr>" for row in self._rows())
        return f"{findings_html(self.findings)}<table>{rows}</table>"


def model(
    name: str,
    source: Source,
    *,
    modulus: Q | None = None,
    bodies: Bodies | None = None,
    pressure: Q | None = None,
    separation: Q | None = None,
    hardness: Q | Literal["elastic"] | None = None,
    gamma: float | None = None,
    resistivity: Q | None = None,
    conductivity: Q | None = None,
    gas: str | dict[str, Any] | None = None,
    area: Q | None = None,
    level: Level = "auto",
    against: Surface | None = None,
    flip: Flip = "columns",
    shift: Q | None = None,
) -> ModelCurve:
    """A closed form at pressures or separations: what ``rough-contact model`` answers.

    Parameters
    ----------
    name : str
        Which model; `models` lists them.
    source : Surface, Profile, Moments, Asperities, SelfAffine, Fractal or Numbers
        The roughness. Of traces the model is that of the isotropic surface with their moments.
    modulus : quantity
        Contact modulus E*; or `bodies`. Not for cmy, whose bodies have no elasticity.
    pressure, separation : quantity or list
        Nominal pressures, or distances of the undeformed planes; exactly one. NaN among several gives NaN.
    hardness : quantity or 'elastic', optional
        Of the softer body, for elastic–plastic models; by default what `bodies` know of it.
    gamma : float, optional
        Weight of partial contact in Persson's mean gap: 0.45 (Yang & Persson 2008, the default) or 1 (Persson 2007).
    resistivity, conductivity, gas, area
        What the joint conducts, as in `solve`: in ``json['points']``.
    level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
        Form that is taken off a surface first, or off each trace; 'auto' is the plane, but the mean of a map that repeats.
    against, flip, shift
        A second body, as in `solve`, that `source` is pressed on.

    Raises
    ------
    ModelError
        The formula has no meaning at any of the questions; where it has at some, see ``.errors``.

    Examples
    --------
    >>> import rough_contact as rc
    >>> moments = rc.Moments(m0='0.36um^2', m2=0.006, m4='4e9m^-2')
    >>> found = rc.model('gw', moments, modulus='110 GPa', pressure='10MPa,100MPa')
    >>> print(found.citation.doi, found.area_fraction.round(5))
    10.1098/rspa.1966.0242 [0.00121 0.01078]
    """
    if (pressure is None) == (separation is None):
        raise TypeError("give exactly one of pressure and separation")
    kind = "separation" if pressure is None else "pressure"
    asked: Any = separation if pressure is None else pressure
    values = _units.several(asked, "length" if pressure is None else "pressure", kind, holes=True)
    numbers = [value for value in values if not math.isnan(value)]
    of_part = None if area is None else _units.scalar(area, "area", "area")
    joint = _bodies.joint(resistivity, conductivity, gas, of_part)
    request, surface, second = _asked(name, source, modulus, bodies, hardness, gamma, joint, level, (against, flip, shift))
    request["pressures" if kind == "pressure" else "separations"] = numbers
    with sorted_as(SettingError):
        if isinstance(source, Profile):
            text, trouble = _rust.profile_model(dumped(request), source.heights, source._facts, count(None))
        else:
            text, trouble = _rust.model(dumped(request), surface, count(None), second)
    answer = json.loads(text)
    found = iter(answer["points"])
    hole = {**dict.fromkeys((*_NUMBERS, "caveat")), "error": {"kind": "not_a_number", "message": f"the {kind} is NaN"}}
    answer["points"] = [hole if math.isnan(value) else next(found) for value in values]
    curve = ModelCurve(answer)
    if trouble is not None and np.isnan(curve.area_fraction).all():
        kind, message = trouble
        raise made(kind, message, ModelError, curve)
    return curve


def _asked(
    name: str,
    source: Source,
    modulus: Q | None,
    bodies: Bodies | None,
    hardness: Q | Literal["elastic"] | None,
    gamma: float | None,
    joint: dict[str, Any],
    level: Level,
    laid_on: tuple[Surface | None, Flip, Q | None],
) -> tuple[dict[str, Any], Any, Any]:
    """What the extension is asked of a model, the surface and the second body, if there are such."""
    check("level", level, LEVELS)
    surface, roughness, second = None, None, None
    if isinstance(source, Surface):
        surface = (source._heights, source._facts)
        second = laid(*laid_on)
    elif laid_on != (None, "columns", None):
        raise TypeError("against, flip and shift are for a second body on a surface; add the moments of two bodies that are typed in")
    elif isinstance(source, _Roughness):
        roughness = source._given()
    elif not isinstance(source, Profile):
        raise TypeError(f"source takes a surface or roughness typed in, not {type(source).__name__}")
    if modulus is None and bodies is None:  # refused there, but of bodies without elasticity
        if _bodies.is_elastic(hardness):
            raise SettingError(f"hardness='elastic' leaves out what bodies know of it; give {name} modulus or bodies, or a hardness", "setting")
        own = None if hardness is None else _units.scalar(hardness, "pressure", "hardness")
        made_of: dict[str, Any] = {"modulus": None, "bodies": [], "hardness": own, "materials": []}
    else:
        made_of = _bodies.given(modulus, bodies, hardness)
    request = {
        "name": name,
        **made_of,
        "joint": joint,
        "hardness_is_given": hardness is not None,
        "gamma": None if gamma is None else _units.number(gamma, "gamma"),
        "pressures": None,
        "separations": None,
        "level": level,
        "roughness": roughness,
    }
    return request, surface, second


class ClosedForm:
    """A closed form that is built once and asked on arrays: ``f(pressure)`` is the area fraction at each.

    Parameters are those of `model`, without the pressures; a `Profile` is no source.

    Examples
    --------
    >>> import numpy as np, rough_contact as rc
    >>> f = rc.ClosedForm('persson', rc.Moments(m2=0.006), modulus='110 GPa')
    >>> f(np.array([[10, 100], [200, 400]]) * rc.units.MPa).round(4)
    array([[0.0013, 0.0132],
           [0.0265, 0.0529]])
    """

    __slots__ = ("_arguments", "_model")

    def __init__(
        self,
        name: str,
        source: Source,
        *,
        modulus: Q | None = None,
        bodies: Bodies | None = None,
        hardness: Q | Literal["elastic"] | None = None,
        gamma: float | None = None,
        level: Level = "auto",
    ) -> None:
        if isinstance(source, Profile):
            raise TypeError("a profile has intervals beside the areas; see rc.model")
        joint = _bodies.joint(None, None, None, None)
        request, surface, _ = _asked(name, source, modulus, bodies, hardness, gamma, joint, level, (None, "columns", None))
        self._set(dumped(request), surface)

    def _set(self, request: str, surface: Any) -> None:
        self._arguments = (request, surface)
        with sorted_as(ModelError):
            self._model = _rust.Closed(request, surface, count(None))

    @classmethod
    def _made(cls, *arguments: Any) -> ClosedForm:
        made = cls.__new__(cls)
        made._set(*arguments)
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return ClosedForm._made, self._arguments

    def _at(self, pressure: Q, which: int) -> NDArray[np.float64]:
        asked = _units.array(pressure, "pressure", "pressure")
        return _units.read_only(self._model.at(np.ascontiguousarray(asked.ravel()))[which].reshape(asked.shape))

    def __call__(self, pressure: Q) -> NDArray[np.float64]:
        """Area fraction at nominal pressures of any shape; NaN where there is no answer."""
        return self._at(pressure, 0)

    def mean_gap(self, pressure: Q) -> NDArray[np.float64]:
        """Mean gap (m) at nominal pressures of any shape; NaN where there is no answer."""
        return self._at(pressure, 1)
