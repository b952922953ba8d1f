"""Progress of long calls."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Union

__all__ = ["Progress", "ProgressArgument"]


@dataclass(frozen=True)
class Progress:
    """Where a call stands.

    Attributes
    ----------
    stage : str
        ``'iteration'``, ``'load'`` (a load is done), and of a study ``'surface'`` (one begins), ``'models'`` (they are asked).
    surface : str
        Name of the surface.
    index, count : int
        Place of the load in the order asked, from 0, and how many there are.
    iteration : int
        Iterations on this load.
    residual, tolerance : float
        Estimated error, and where the iteration ends.
    mean_pressure, area_fraction : float or None
        Of a load that is done.
    """

    stage: str
    surface: str
    index: int
    count: int
    iteration: int
    residual: float
    tolerance: float
    mean_pressure: float | None
    area_fraction: float | None


ProgressArgument = Union[None, bool, Callable[[Progress], object]]


def listener(progress: ProgressArgument) -> Callable[[dict[str, Any]], object] | None:
    """What the extension calls, on the thread of the caller."""
    if progress is None or progress is False:
        return None
    if progress is True:
        tell = _bar()
    elif callable(progress):
        tell = progress
    else:
        raise TypeError("progress takes None, True or a callable")
    return lambda news: tell(Progress(**news))


def _bar() -> Callable[[Progress], object]:
    done, surface = 0, ""

    def line(news: Progress) -> None:
        nonlocal done, surface
        if news.surface != surface:
            done, surface = 0, news.surface
        if news.stage == "load":
            done += 1
            end = "\n" if done == news.count else ""
            print(f"\r{news.surface}: {done} of {news.count} loads", end=end, file=sys.stderr, flush=True)

    try:
        from tqdm.auto import tqdm
    except ImportError:
        return line
    bar: Any = None

    def step(news: Progress) -> None:
        nonlocal bar
        if bar is None or bar.desc != news.surface:
            if bar is not None:
                bar.close()
            bar = tqdm(total=news.count, desc=news.surface, unit="load")
        if news.stage == "load":
            bar.update(1)
            if bar.n == bar.total:
                bar.close()

    return step
