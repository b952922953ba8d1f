"""The deterministic solution."""

from __future__ import annotations

import json
import math
import time
import warnings
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import _bodies, _progress, _units
from . import _rough_contact as _rust
from ._bodies import Bodies
from ._errors import ContactWarning, NotConverged, SettingError, SurfaceError, dumped, made, sorted_as, stopped
from ._foreign import of_xarray
from ._profile import Profile
from ._progress import ProgressArgument
from ._results import LoadCurve
from ._surface import LEVELS, Flip, Level, Surface, check, laid
from ._threads import count
from ._units import Q

__all__ = ["displacement", "solve"]

Method = Literal["auto", "chord", "polonsky-keer", "stanley-kato"]


def solve(
    surface: Surface | Profile,
    *,
    modulus: Q | None = None,
    bodies: Bodies | None = None,
    pressure: Q | None = None,
    gap: Q | None = None,
    load: Q | None = None,
    area: Q | None = None,
    level: Level = "auto",
    boundary: Literal["periodic", "free"] = "periodic",
    edges: Literal["periodic", "mirrored"] = "periodic",
    method: Method = "auto",
    precision: Literal["f64", "f32"] | None = None,
    tolerance: float | None = None,
    accuracy: float | str | None = None,
    fast: bool = False,
    certify: bool = False,
    stiffness: bool = False,
    hardness: Q | Literal["elastic"] | None = None,
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
    distributions: bool = False,
    plane_strain: bool = False,
    maps: bool | Literal["pressure"] = False,
    against: Surface | None = None,
    flip: Flip = "columns",
    shift: Q | None = None,
    threads: int | None = None,
    progress: ProgressArgument = None,
    on_failure: Literal["raise", "keep"] = "raise",
) -> LoadCurve:
    """Solves the contact of a rough surface at one load or many.

    Parameters
    ----------
    surface : Surface
        The map; one body against a rigid flat, or both elastic. With `plane_strain` a `Profile` of one trace.
    modulus : quantity
        Contact modulus E*; or `bodies`.
    bodies : Body or (Body, Body)
        What E* is made of.
    pressure, gap, load : quantity or list
        Exactly one: nominal pressures, mean gaps, or forces on `area` (that of the map by default). NaN among several gives NaN.
    level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
        Form that is taken off first; 'auto' is the plane, but the mean of a map that repeats.
    boundary : {'periodic', 'free'}
        What lies beyond the edges: the map again, or nothing.
    edges : {'periodic', 'mirrored'}
        Of a periodic map: the map again, or its mirror images (four times the points).
    method, precision, tolerance
        How to solve; ``'f64'`` and 1e-4 by default.
    accuracy : float or str, optional
        Uncertainty of the area to stay within, as ``'3%'``: grid, precision and tolerance are chosen for it.
    fast : bool
        Every second point of the map at once, with its wider uncertainty.
    certify, stiffness, distributions : bool
        As the options of the command.
    hardness : quantity or 'elastic', optional
        Highest pressure that the softer body bears; by default what `bodies` know of it, ``'elastic'`` leaves that out.
    resistivity, conductivity : quantity, optional
        Of both bodies, or a pair: what the joint conducts, and the resistance of `area` (that of the map by default).
    gas : str or dict, optional
        In the gap, beside `conductivity`: ``'air'``, ``'helium'``, ``'argon'`` or ``'nitrogen'``, or a dict of ``gas``,
        ``temperature`` (K), ``pressure`` and ``accommodation``; vacuum by default.
    leak : {'x', 'y', 'both'}, optional
        The permeability of the gap for a flow along an axis, in ``json['points'][i]['leak']``.
    viscosity, pressure_drop, seal_length, seal_width : quantity, optional
        All four: the leak rate too.
    plane_strain : bool
        The profile is the cross-section of long parallel ridges (Westergaard 1939, doi:10.1115/1.4008919).
    work_of_adhesion, attraction_range : quantity, optional
        Whether the bodies stick is said, by formulas: a finding, and ``json['adhesion']``.
    maps : bool or 'pressure'
        Whether pressure and gap of every point are kept.
    against : Surface, optional
        A second body that lies face down on `surface`: the sum of both heights is solved.
    flip : {'columns', 'rows', 'none'}
        How it is turned over: as a book is closed, as a page of a wall calendar is turned, or not at all.
    shift : quantity, optional
        How far it is moved then, a pair ``(dy, dx)`` or ``'DX,DY'``, in whole points.
    threads : int, optional
        `default_threads` by default. Results do not depend on it.
    progress : bool or callable, optional
        True shows a bar; a callable gets a `Progress`, on this thread, and ends the call by raising.
    on_failure : {'raise', 'keep'}
        What to do if a load has no complete answer: raise with ``.result``, or return it as it is.

    Returns
    -------
    LoadCurve
        With an error interval for each number that has one, and what may change a conclusion.

    Raises
    ------
    NotConverged, AccuracyNotMet
        With what was found in ``.result``.
    Interrupted
        Ctrl-C; the loads that were done are in ``.partial``, also of an exception that `progress` raises.

    Notes
    -----
    Warns with a `ContactWarning` if a finding may change a conclusion. The method is described in the book,
    https://github.com/rough-contact/rough-contact, and by Polonsky and Keer, doi:10.1016/S0043-1648(99)00113-1.

    Examples
    --------
    >>> import rough_contact as rc
    >>> s = rc.synth((128, 128), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=1)
    >>> curve = rc.solve(s, modulus='110 GPa', pressure='100MPa,300MPa', hardness='20 GPa')
    >>> curve.area_fraction.shape
    (2,)
    """
    check("edges", edges, ("periodic", "mirrored"))
    check("on_failure", on_failure, ("raise", "keep"))
    conduction = resistivity is not None or conductivity is not None
    made_of = _bodies.given(modulus, bodies, hardness)
    _refuse(
        ("accuracy", accuracy is not None, "tolerance", tolerance is not None),
        ("accuracy", accuracy is not None, "precision", precision is not None),
        ("accuracy", accuracy is not None, "fast", fast),
        ("edges='mirrored'", edges == "mirrored", "boundary='free'", boundary == "free"),
        ("gap", gap is not None, "boundary='free'", boundary == "free"),
        # Ridges have a load on a length, do not end, and have no more answers than these.
        ("plane_strain", plane_strain, "load", load is not None),
        ("plane_strain", plane_strain, "boundary='free'", boundary == "free"),
        ("plane_strain", plane_strain, "against", against is not None),
        ("plane_strain", plane_strain, "accuracy", accuracy is not None),
        ("plane_strain", plane_strain, "fast", fast),
        ("plane_strain", plane_strain, "stiffness", stiffness),
        ("plane_strain", plane_strain, "resistivity or conductivity", conduction),
        ("plane_strain", plane_strain, "work_of_adhesion", work_of_adhesion is not None),
    )
    of_part = None if area is None else _units.scalar(area, "area", "area")
    request = how(made_of, level, boundary, method, precision, tolerance, maps, threads)
    request.update(loads=loads(pressure, gap, load), area=of_part, accuracy=_accuracy(accuracy))
    request["request"].update(
        certify=_units.flag(certify, "certify"),
        stiffness=_units.flag(stiffness, "stiffness"),
        distributions=_units.flag(distributions, "distributions"),
        plane_strain=_units.flag(plane_strain, "plane_strain"),
    )
    request["request"]["settings"].update(
        edges=edges,
        fast=_units.flag(fast, "fast"),
        **_bodies.joint(resistivity, conductivity, gas, None),
        load_area=of_part if conduction else None,
        leak=_bodies.leak(leak, viscosity, pressure_drop, seal_length, seal_width),
        adhesion=_bodies.adhesion(work_of_adhesion, attraction_range),
    )
    if area is not None and load is None and not conduction:
        raise TypeError("area is that load presses on or whose resistance is asked for, and neither load nor conductivity is given")
    return asked(section(surface, plane_strain), request, (against, flip, shift), progress, on_failure)


def how(
    made_of: dict[str, Any],
    level: Level,
    boundary: str,
    method: Method,
    precision: str | None,
    tolerance: float | None,
    maps: bool | str,
    threads: int | None,
) -> dict[str, Any]:
    """How to solve for these bodies, checked, as the extension takes it."""
    check("level", level, LEVELS)
    check("boundary", boundary, ("periodic", "free"))
    check("method", method, ("auto", "chord", "polonsky-keer", "stanley-kato"))
    check("precision", precision, (None, "f64", "f32"))
    check("maps", maps, (False, True, "pressure"))
    settings = {
        **made_of,
        "level": level,
        "method": method,
        "precision": precision or "f64",
        "tolerance": 1e-4 if tolerance is None else _units.number(tolerance, "tolerance"),
        "threads": count(threads),
    }
    keep_gap = maps not in (False, "pressure")
    return {"maps": bool(maps), "request": {"boundary": boundary, "keep_gap": keep_gap, "settings": settings}}


def displacement(
    pressure: Q,
    *,
    pixel: Q,
    modulus: Q | None = None,
    bodies: Bodies | None = None,
    boundary: Literal["periodic", "free"] = "periodic",
    threads: int | None = None,
) -> NDArray[np.float64]:
    """Elastic displacement of a half-space under a pressure: the forward operator of `solve`.

    Parameters
    ----------
    pressure : quantity, shape (ny, nx)
        Pressure of each point, as ``array * rc.units.MPa``.
    pixel : quantity
        Distance of the points, ``'1 um'`` or a pair ``(dy, dx)``.
    modulus, bodies
        As of `solve`; of two bodies it is the sum of both displacements.
    boundary : {'periodic', 'free'}
        Beyond the map the pressure repeats, u(q) = 2 p(q)/(E* q) with mean 0; or there is none, and u vanishes far away.
    threads : int, optional
        `default_threads` by default.

    Returns
    -------
    ndarray, shape (ny, nx)
        Displacement (m), positive into the body, rows first.

    Examples
    --------
    >>> import numpy as np, rough_contact as rc
    >>> wave = np.cos(2 * np.pi * np.arange(64) / 64)
    >>> u = rc.displacement(np.tile(wave, (64, 1)) * rc.units.MPa, pixel='1um', modulus='100 GPa')
    >>> bool(np.isclose(u.max(), 2 * 1e6 / (100e9 * 2 * np.pi / 64e-6)))
    True
    """
    check("boundary", boundary, ("periodic", "free"))
    distance = _units.pixel(pixel)
    if _units.is_xarray(pressure):
        found = of_xarray(pressure)
        pressure, distance = found.heights, found.pixel(None, distance)
    field = _units.array(pressure, "pressure", "pressure")
    if field.ndim != 2 or not np.isfinite(field).all():
        raise SurfaceError("pressure takes a map of rows and columns without holes", "shape")
    elastic = _bodies.given(modulus, bodies)["modulus"]
    with sorted_as(SurfaceError):
        return _rust.displacement(field, distance, elastic, boundary == "free", count(threads))


def section(surface: Surface | Profile, plane_strain: bool) -> Surface:
    """The map, or the one trace that is to be solved in plane strain."""
    if isinstance(surface, Profile):
        if not plane_strain:
            raise SettingError(
                "this is a profile, and a surface has no deterministic answer from one line of it; give rc.solve plane_strain=True if it is "
                "the cross-section of long parallel ridges, or see rc.model and rc.compare_profiles",
                "profile",
            )
        return Surface._made(surface.heights, surface._facts, "{}")
    if plane_strain:
        raise SettingError("plane_strain is for a profile, and this is a map; leave it out", "profile")
    return surface


def asked(
    surface: Surface,
    request: dict[str, Any],
    second: tuple[Surface | None, Flip, Q | None],
    progress: ProgressArgument,
    on_failure: str,
    keep: _rust.Keep | None = None,
) -> LoadCurve:
    """Asks the extension, and raises or warns of what it says."""
    if not isinstance(surface, Surface):
        raise TypeError(f"surface takes an rc.Surface, not {type(surface).__name__}; see rc.Surface.of")
    start = time.perf_counter()
    kind, values = request["loads"]
    places = [i for i, value in enumerate(values) if not math.isnan(value)]
    request = {**request, "loads": (kind, [values[i] for i in places])}
    with sorted_as(SettingError):
        text, kept, trouble, stopped_by = _rust.solve(
            surface._heights,
            surface._facts,
            dumped(request),
            _progress.listener(progress),
            laid(*second),
            keep,
        )
    if stopped_by is not None and not text:
        raise stopped(stopped_by, "no load was done", None)
    answer = json.loads(text)
    if stopped_by is None and len(places) < len(values):
        found = dict(zip(places, answer["points"]))
        answer["points"] = [found.get(i, _hole(kind)) for i in range(len(values))]
        kept = [(places[index], p, g) for index, p, g in kept]
    curve = LoadCurve(answer, {index: (p, g) for index, p, g in kept}, time.perf_counter() - start)
    if stopped_by is not None:
        raise stopped(stopped_by, f"{len(curve)} of {len(values)} loads were done", curve)
    for finding in curve.findings:
        if finding.weight == "check":
            warnings.warn(f"{finding.claim} {finding.text}".strip(), ContactWarning, stacklevel=3)
    if trouble is not None and on_failure == "raise":
        kind, message = trouble
        raise made(kind, message, NotConverged if _some(curve) else SettingError, curve)
    return curve


def _hole(kind: str) -> dict[str, Any]:
    """What a load that is NaN gives."""
    error = {"kind": "not_a_number", "message": f"the {kind} is NaN"}
    return {"mean_pressure": None, "area_fraction": None, "converged": False, "error": error}


def _some(curve: LoadCurve) -> bool:
    return any(point["area_fraction"] is not None for point in curve.json["points"])


def _refuse(*pairs: tuple[str, bool, str, bool]) -> None:
    for first, is_first, second, is_second in pairs:
        if is_first and is_second:
            raise SettingError(f"{first} cannot be combined with {second}; leave one of them out", "combination")


def loads(pressure: Q | None, gap: Q | None, load: Q | None) -> tuple[str, list[float]]:
    given = [(n, v) for n, v in (("pressure", pressure), ("gap", gap), ("load", load)) if v is not None]
    if len(given) != 1:
        raise TypeError("give exactly one of pressure, gap and load")
    name, value = given[0]
    kind = {"pressure": "pressure", "gap": "length", "load": "force"}[name]
    values = _units.several(value, kind, name, holes=True)
    bad = [v for v in values if v <= 0]
    if bad:
        raise SettingError(f"{name} = {bad[0]} must be greater than 0", "bad_load")
    return name, values


def _accuracy(accuracy: float | str | None) -> str | None:
    if accuracy is None or isinstance(accuracy, str):
        return accuracy
    return f"{100 * _units.number(accuracy, 'accuracy'):.12g}%"
