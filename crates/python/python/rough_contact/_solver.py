"""A solver for loops of one's own: it starts from where it ended."""

from __future__ import annotations

from typing import Any, Literal

from . import _bodies
from . import _rough_contact as _rust
from ._bodies import Bodies
from ._errors import SettingError
from ._progress import ProgressArgument
from ._results import LoadCurve, Point
from ._solve import Method, asked, how, loads, section
from ._surface import Level, Surface, check
from ._units import Q

__all__ = ["Solver"]


class Solver:
    """Solves again and again, each time from the last solution: for wear, fitting and control loops.

    On surfaces of one grid the transforms are planned and the memory is taken once, and a solve that
    differs little from the last one takes fewer iterations; the answer is the same within the tolerance. A
    surface of another grid starts anew.

    Parameters
    ----------
    modulus : quantity
        Contact modulus E*; or `bodies`.
    bodies : Body or (Body, Body)
        What E* is made of.
    level : {'auto', 'none', 'mean', 'plane', 'quadratic'}
        Form that is taken off each surface first; 'auto' is the plane, but the mean of a map that repeats.
    boundary : {'periodic', 'free'}
        What lies beyond the edges: the map again, or nothing.
    method, precision, tolerance
        How to solve; ``'f64'`` and 1e-4 by default.
    hardness : quantity or 'elastic', optional
        Highest pressure (Pa) that the softer body bears; by default what `bodies` know of it.
    maps : bool or 'pressure'
        Whether pressure (Pa) and gap (m) of every point are kept; both by default.
    threads : int, optional
        `default_threads` by default. Results do not depend on it beyond the tolerance.

    Notes
    -----
    It works for one thread at a time, and is not pickled: make one in each worker.

    Examples
    --------
    >>> import rough_contact as rc
    >>> s = rc.synth((128, 128), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=1)
    >>> solver = rc.Solver(modulus='110 GPa')
    >>> cold = solver.solve(s, pressure='100 MPa')
    >>> warm = solver.solve(s, pressure='101 MPa')
    >>> warm.iterations <= cold.iterations, warm.pressure.shape
    (True, (128, 128))
    """

    __slots__ = ("_how", "_keep")

    def __init__(
        self,
        *,
        modulus: Q | None = None,
        bodies: Bodies | None = None,
        level: Level = "auto",
        boundary: Literal["periodic", "free"] = "periodic",
        method: Method = "auto",
        precision: Literal["f64", "f32"] = "f64",
        tolerance: float = 1e-4,
        hardness: Q | Literal["elastic"] | None = None,
        maps: bool | Literal["pressure"] = True,
        threads: int | None = None,
    ) -> None:
        self._keep = _rust.Keep()
        made_of = _bodies.given(modulus, bodies, hardness)
        self._how = how(made_of, level, boundary, method, precision, tolerance, maps, threads)

    def __reduce__(self) -> Any:
        raise TypeError("an rc.Solver is not pickled; make one in each worker")

    def __repr__(self) -> str:
        return f"Solver({'warm' if self.is_warm else 'cold'})"

    @property
    def is_warm(self) -> bool:
        """Whether it has a solution to start from."""
        return self._keep.is_warm()

    def forget(self) -> None:
        """Lets the last solution go: the next solve starts from nothing."""
        self._keep.forget()

    def solve(
        self,
        surface: Surface,
        *,
        pressure: Q | None = None,
        gap: Q | None = None,
        load: Q | None = None,
        progress: ProgressArgument = None,
    ) -> Point:
        """Solves for one load.

        Parameters
        ----------
        surface : Surface
            The map.
        pressure, gap, load : quantity
            Exactly one: nominal pressure (Pa), mean gap (m), or force (N) on the map.
        progress : bool or callable, optional
            As in `solve`.

        Returns
        -------
        Point
            With its error intervals, and pressure and gap if `maps` are kept.

        Raises
        ------
        NotConverged
            With the loads in ``.result``.
        Interrupted
            Ctrl-C. The solver keeps the iterate it had reached: the next call starts from it.
        """
        found = self.curve(surface, pressure=pressure, gap=gap, load=load, progress=progress)
        if len(found) != 1:
            raise SettingError(f"solve takes one load, and {len(found)} were given; see curve", "setting")
        return found[0]

    def curve(
        self,
        surface: Surface,
        *,
        pressure: Q | None = None,
        gap: Q | None = None,
        load: Q | None = None,
        progress: ProgressArgument = None,
        on_failure: Literal["raise", "keep"] = "raise",
    ) -> LoadCurve:
        """Solves for many loads, each from the one below it, as `rough_contact.solve` does.

        Parameters
        ----------
        surface : Surface
            The map.
        pressure, gap, load : quantity or list
            Exactly one: nominal pressures (Pa), mean gaps (m), or forces (N) on the map.
        progress : bool or callable, optional
            As in `solve`.
        on_failure : {'raise', 'keep'}
            What to do if a load has no complete answer.

        Returns
        -------
        LoadCurve
            In the order of the loads.
        """
        check("on_failure", on_failure, ("raise", "keep"))
        request = {**self._how, "loads": loads(pressure, gap, load)}
        return asked(section(surface, False), request, (None, "columns", None), progress, on_failure, self._keep)
