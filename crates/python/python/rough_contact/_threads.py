"""How many threads a call takes."""

from __future__ import annotations

import os

from . import _units

__all__ = ["default_threads"]


def default_threads() -> int:
    """Threads that are used where none are given: ``OMP_NUM_THREADS``, else the processors of this process.

    Results do not depend on the number. joblib, Dask and most schedulers set the variable in their workers.
    """
    try:
        asked = int(os.environ.get("OMP_NUM_THREADS", ""))
    except ValueError:
        asked = 0
    if asked > 0:
        return min(asked, 1024)
    affinity = getattr(os, "sched_getaffinity", None)
    return len(affinity(0)) if affinity else os.cpu_count() or 1


def count(threads: int | None) -> int:
    """The threads asked for, checked."""
    if threads is None:
        return default_threads()
    return _units.whole(threads, "threads", 1, 1024)
