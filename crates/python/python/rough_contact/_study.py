"""The study: every model beside the deterministic solution."""

from __future__ import annotations

import copy
import json
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

from . import _bodies, _progress, _units
from . import _named as _names
from . import _rough_contact as _rust
from ._bodies import Bodies
from ._documents import Documents
from ._errors import NotConverged, SettingError, dumped, made, sorted_as, stopped
from ._extras import extra
from ._findings import Finding, findings_html
from ._models import Citation, ContactModel, Inputs, curve, models
from ._progress import ProgressArgument
from ._results import flat, percent, pressure
from ._statistics import Statistics
from ._surface import LEVELS, Flip, Level, Surface, check, laid
from ._threads import count
from ._units import Q

__all__ = ["AreaError", "Comparison", "ModelComparison", "SurfaceComparison", "compare"]

Surfaces = Union[Surface, Sequence[Surface], Mapping[str, Surface]]


@dataclass(frozen=True)
class AreaError(_units.Kept):
    """Errors of the area against the deterministic solution, relative; None where there is no answer."""

    headline: float | None
    mean_absolute: float | None
    worst: float | None
    signed: NDArray[np.float64]


@dataclass(frozen=True, repr=False)
class ModelComparison:
    """A model on one surface, as in ``results.json``."""

    name: str
    json: dict[str, Any]

    def __repr__(self) -> str:
        mean = self.area_error.mean_absolute
        error = "no answer" if mean is None else f"mean |area error| {100 * mean:.3g} %"
        return f"ModelComparison({self.name!r}, {error}, applies: {self.verdict})"

    @property
    def title(self) -> str:
        """Its name in full."""
        known = {info.name: info.title for info in models()}
        # Of one's own it stands where others have their authors.
        return known.get(self.name, self.citation.authors)

    @property
    def citation(self) -> Citation:
        """Where it was published."""
        return Citation(**self.json["citation"])

    @property
    def applicable(self) -> bool:
        """Whether it answers on this surface at all."""
        return bool(self.json["applicable"])

    @property
    def verdict(self) -> str:
        """Whether it applies, in one word."""
        return str(self.json["verdict"])

    @property
    def reason(self) -> str | None:
        """Why it does not apply, or with what caution."""
        reason: str | None = self.json["reason"]
        return reason

    @property
    def seconds(self) -> float | None:
        """Time for one load."""
        seconds: float | None = self.json["seconds"]
        return seconds

    @property
    def points(self) -> list[dict[str, Any]]:
        """An answer for each load, or its error."""
        return copy.deepcopy(self.json["points"]) if self.json["points"] else []

    @property
    def area_fraction(self) -> NDArray[np.float64]:
        """Area fraction at each load; NaN where there is no answer."""
        return _units.read_only(np.array([point.get("area_fraction") for point in self.points], dtype=np.float64))  # of None NaN

    @cached_property
    def area_error(self) -> AreaError:
        """Its errors against the deterministic solution."""
        found = self.json["area_error"] or {}
        return AreaError(
            found.get("headline"),
            found.get("mean_absolute"),
            found.get("worst"),
            _units.read_only(np.array(found.get("signed") or [], dtype=np.float64)),
        )


@dataclass(frozen=True, repr=False)
class SurfaceComparison:
    """One surface of a study."""

    name: str
    json: dict[str, Any]

    def __repr__(self) -> str:
        return f"SurfaceComparison({self.name!r}, {len(self.deterministic)} loads, {len(self.models)} models)"

    @property
    def statistics(self) -> Statistics:
        """Its roughness, as the models got it."""
        known = {**self.json["statistics"], "findings": self.json["findings"], "cleaning": self.json["cleaning"]}
        return Statistics._of(copy.deepcopy(known))

    @property
    def deterministic(self) -> list[dict[str, Any]]:
        """The deterministic solution at each load, as in the JSON."""
        return copy.deepcopy(self.json["deterministic"]["points"])

    @property
    def models(self) -> dict[str, ModelComparison]:
        """The models by name."""
        return {model["model"]: ModelComparison(model["model"], model) for model in self.json["models"]}

    @property
    def distributions(self) -> dict[str, Any] | None:
        """How pressure, gap and contact spots are distributed at the headline, as in the JSON; None if nothing touches."""
        found: dict[str, Any] | None = copy.deepcopy(self.json["distributions"])
        return found

    def digest(self) -> dict[str, Any]:
        """What a page over many maps keeps of it: keys as in the table of ``rough-contact compare --summary``."""
        kept: dict[str, Any] = json.loads(_rust.digest(dumped(self.json)))
        return kept

    @property
    def headline_pressure(self) -> float:
        """Nominal pressure (Pa) that the headline is for."""
        return float(self.json["headline_pressure"])

    @property
    def findings(self) -> tuple[Finding, ...]:
        """What may change a conclusion, worst first."""
        return tuple(Finding._of(finding) for finding in self.json["findings"])

    def cheapest(self, within: float = 0.10) -> ModelComparison | None:
        """The cheapest model whose mean absolute error of the area is at most `within`; None if there is none."""
        fitting = [
            m for m in self.models.values()
            if m.area_error.mean_absolute is not None and m.area_error.mean_absolute <= within and m.seconds is not None
        ]
        return min(fitting, key=lambda m: m.seconds or 0.0, default=None)


@dataclass(frozen=True, repr=False)
class Comparison(Documents):
    """A study: every surface solved, and the models beside it; ``study['ground']`` is one surface.

    Attributes
    ----------
    files : dict
        The documents by their names: ``results.json``, ``report.html``, ``curves.csv``, ``area.svg``,
        ``pressure.svg``, ``run.toml``.
    """

    @property
    def surfaces(self) -> dict[str, SurfaceComparison]:
        """The surfaces by name."""
        return {s["name"]: SurfaceComparison(s["name"], s) for s in self.json["surfaces"]}

    @property
    def refused(self) -> dict[str, str]:
        """Surfaces without an answer, and why."""
        return {r["name"]: r["reason"] for r in self.json["refused"]}

    def __getitem__(self, name: str) -> SurfaceComparison:
        return self.surfaces[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.surfaces)

    def __len__(self) -> int:
        return len(self.json["surfaces"])

    def digest(self) -> dict[str, Any]:
        """What `summary` keeps of it: of each surface a few numbers, a curve and the errors of the models.

        Small, plain and picklable: what a worker sends back instead of the study.
        """
        maps = {name: surface.digest() for name, surface in self.surfaces.items()}
        return {"maps": maps, "refused": self.refused, "settings": self.to_dict()["settings"], "seconds": self.json["seconds"]}

    def records(self) -> list[dict[str, Any]]:
        """A flat dict for each surface, model and load; ``area_error`` is signed."""
        rows = []
        for name, surface in self.surfaces.items():
            for model in surface.models.values():
                head = {"surface": name, "model": model.name}
                errors = model.area_error.signed.tolist()
                rows += [{**head, **flat(p), "area_error": e} for p, e in zip(model.points, errors)]
                if not model.points:
                    nothing = {"area_fraction": None, "area_error": None, "reason": model.reason}
                    rows += [{**head, "mean_pressure": p["mean_pressure"], **nothing} for p in surface.deterministic]
        return rows

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of one line for each surface, model and load."""
        pandas = extra("pandas", "tables")

        frame = pandas.DataFrame(self.records())
        frame.attrs["units"] = {"mean_pressure": "Pa", "area_fraction": "1", "area_error": "1", "mean_gap": "m"}
        return frame

    def _lines(self) -> list[tuple[str, list[tuple[str, str, str]]]]:
        found = []
        for name, surface in self.surfaces.items():
            rows = []
            for model in surface.models.values():
                mean = model.area_error.mean_absolute
                rows.append((model.title, "–" if mean is None else f"{100 * mean:.3g} %", model.verdict))
            points = surface.json["deterministic"]["points"]
            at = [p for p in points if p["mean_pressure"] == surface.headline_pressure]
            interval = (at[0]["area_prediction_interval"] or at[0]["area_interval"]) if at else None
            area = percent(at[0]["area_fraction"], interval) if at else "–"
            found.append((f"{name}: area {area} at {pressure(surface.headline_pressure)}", rows))
        return found

    def __repr__(self) -> str:
        settings = self.json["settings"]
        about = _rust.bodies_line(settings["modulus"], dumped(settings.get("bodies", [])))
        lines = [f"Comparison({'1 surface' if len(self) == 1 else f'{len(self)} surfaces'}; {about})"]
        for head, rows in self._lines():
            lines.append(f"  {head}")
            lines += [f"    {title}: mean |area error| {mean}, {verdict}" for title, mean, verdict in rows]
        lines += [f"  {name}: no answer: {why}" for name, why in self.refused.items()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        parts = []
        for (head, rows), surface in zip(self._lines(), self.surfaces.values()):
            cells = "".join(
                f"<tr><td>{escape(t)}</td><td style='text-align:right'>{m}</td><td>{escape(v)}</td></tr>" for t, m, v in rows
            )
            table = f"<table><tr><th>model</th><th>mean |area error|</th><th>applies</th></tr>{cells}</table>"
            parts.append(f"<p><b>{escape(head)}</b></p>{findings_html(surface.findings[:3])}{table}")
        parts += [f"<p>{escape(name)}: no answer: {escape(why)}</p>" for name, why in self.refused.items()]
        return "".join(parts)


def compare(
    surfaces: Surfaces,
    *,
    modulus: Q | None = None,
    bodies: Bodies | None = None,
    pressure: Q | None = None,
    headline: Q | None = None,
    models: str | ContactModel | Sequence[str | ContactModel] | None = None,
    level: Level = "auto",
    edges: Literal["periodic", "mirrored"] = "periodic",
    hardness: Q | Literal["elastic"] | None = None,
    gamma: float | None = None,
    resistivity: Q | None = None,
    conductivity: Q | None = None,
    gas: str | dict[str, Any] | None = None,
    leak: Literal["x", "y", "both"] | None = None,
    viscosity: Q | None = None,
    pressure_drop: Q | None = None,
    seal_length: Q | None = None,
    seal_width: Q | None = None,
    work_of_adhesion: Q | None = None,
    attraction_range: Q | None = None,
    precision: Literal["f64", "f32"] = "f64",
    tolerance: float = 1e-4,
    accuracy: float | str | None = None,
    fractal_range: Q | None = None,
    against: Surface | None = None,
    flip: Flip = "columns",
    shift: Q | None = None,
    threads: int | None = None,
    progress: ProgressArgument = None,
    on_failure: Literal["raise", "keep"] = "raise",
) -> Comparison:
    """Which model on my surface? Every model beside the deterministic solution: ``rough-contact compare``.

    Parameters
    ----------
    surfaces : Surface, sequence or mapping
        The keys of a mapping name the surfaces.
    modulus : quantity
        Contact modulus E*; or `bodies`.
    pressure : quantity or list, optional
        Nominal pressures; by default those at which 0.1 % to about half of each surface touches.
    headline : quantity, optional
        The pressure of headline and contact map, one of `pressure`.
    models : str, model or list, optional
        Names of built-in models and models of one's own (`ContactModel`); every built-in one by default. Those of one's
        own are called once for each surface, with all loads, on this thread, before the solver.
    level, edges, hardness, gamma, precision, tolerance, accuracy, fractal_range
        As the options of the command.
    resistivity, conductivity, gas, leak, viscosity, pressure_drop, seal_length, seal_width, work_of_adhesion, attraction_range
        As of `solve`.
    against, flip, shift
        A second body, as in `solve`, that each surface is pressed on.
    on_failure : {'raise', 'keep'}
        What to do if a load or a surface has no answer, or a model of one's own raises or has none at any load: raise, with the
        study in ``.result`` where there is one, or keep it as a reason.

    Raises
    ------
    Interrupted
        Ctrl-C; mean pressure and area fraction of the loads that were done are in ``.partial``, by surface. So they are in
        ``.partial`` of an exception that `progress` raises.

    Examples
    --------
    >>> import rough_contact as rc
    >>> s = rc.synth((128, 128), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=1)
    >>> study = rc.compare(s, modulus='110 GPa', pressure='100MPa,1GPa', models=['persson', 'gw'])
    >>> sorted(study['synth 1'].models)
    ['gw', 'persson']
    """
    check("level", level, LEVELS)
    check("edges", edges, ("periodic", "mirrored"))
    check("precision", precision, ("f64", "f32"))
    check("on_failure", on_failure, ("raise", "keep"))
    named = _names.named(surfaces, Surface)
    made_of = _bodies.given(modulus, bodies, hardness)
    pressures = None if pressure is None else sorted(set(_units.several(pressure, "pressure", "pressure")))
    settings: dict[str, Any] = {
        **made_of,
        "level": level,
        "edges": edges,
        "leak": _bodies.leak(leak, viscosity, pressure_drop, seal_length, seal_width),
        "adhesion": _bodies.adhesion(work_of_adhesion, attraction_range),
        "method": "auto",
        "precision": precision,
        "tolerance": _units.number(tolerance, "tolerance"),
        "threads": count(threads),
    }
    if pressures is not None:
        settings["pressures"] = pressures
    if headline is not None:
        settings["headline"] = _units.scalar(headline, "pressure", "headline")
    if gamma is not None:
        settings["gamma"] = _units.number(gamma, "gamma")
    settings.update(_bodies.joint(resistivity, conductivity, gas, None))
    if accuracy is not None:
        settings["accuracy"] = _units.number(accuracy, "accuracy")
    if fractal_range is not None:
        settings["fractal_range"] = _units.ends(fractal_range, "fractal_range")
    own: list[ContactModel] = []
    if models is not None:
        models = [models] if isinstance(models, (str, ContactModel)) else list(models)
        own = [model for model in models if not isinstance(model, str)]
        for model in own:
            if not isinstance(model, ContactModel):
                raise TypeError(f"{model!r} is no model: it needs a name and area_fraction(pressure, inputs)")
        settings["models"] = [m if isinstance(m, str) else m.name for m in models]
    if own and against is not None:
        raise SettingError("a model of one's own is asked about one surface, and against= makes two; leave one of them out", "combination")
    curves = [_own(model, named, settings, on_failure) for model in own]
    second = laid(against, flip, shift)
    return studied(named, settings, (curves, second), progress, on_failure)


def studied(
    named: Mapping[str, Surface],
    settings: dict[str, Any],
    beside: tuple[list[dict[str, Any]], Any],
    progress: ProgressArgument,
    on_failure: str,
) -> Comparison:
    """Asks the extension for a study with curves and a second body beside it, and raises what it says."""
    curves, second = beside
    tell = _progress.listener(progress)
    done: dict[str, list[dict[str, float | None]]] = {name: [] for name in named}

    def listen(news: dict[str, Any]) -> None:
        if news["stage"] == "load":
            done.setdefault(news["surface"], []).append({k: news[k] for k in ("mean_pressure", "area_fraction")})
        if tell is not None:
            tell(news)

    with sorted_as(SettingError):
        files, trouble, stopped_by = _rust.study(
            [(s._heights, s._facts, name) for name, s in named.items()],
            dumped(settings),
            dumped(curves),
            listen,
            second,
        )
    if stopped_by is not None:
        raise stopped(stopped_by, f"the study was stopped after {sum(map(len, done.values()))} loads", done)
    study = Comparison(files)
    if trouble is not None and on_failure == "raise":
        kind, message = trouble
        raise made(kind, message, NotConverged, study)
    return study


def _own(
    model: ContactModel,
    named: Mapping[str, Surface],
    settings: dict[str, Any],
    on_failure: str,
) -> dict[str, Any]:
    """The curves of a model of one's own on all surfaces."""
    curves: dict[str, Any] = {}
    seconds: dict[str, float] = {}
    for name, surface in named.items():
        # As the built-in ones get them.
        request = {"level": settings["level"], "fractal_range": settings.get("fractal_range"), "iso": False, "scales": False}
        statistics = surface._asked(request)
        asked = _rust.study_pressures(dumped(settings), statistics.rms_gradient)
        start = time.perf_counter()
        try:
            curves[name] = curve(model, asked, Inputs._of(settings["modulus"], statistics))
            seconds[name] = (time.perf_counter() - start) / len(asked)
        except Exception as error:
            if on_failure == "raise":
                raise
            curves[name] = {"Err": f"{type(error).__name__}: {error}"}
    title = getattr(model, "title", None)
    citation = getattr(model, "citation", None)
    return {
        "name": model.name,
        "title": model.name if title is None else str(title),
        "citation": "a model given in Python" if citation is None else str(citation),
        "year": time.localtime().tm_year,
        "curves": curves,
        "seconds": seconds,
    }
