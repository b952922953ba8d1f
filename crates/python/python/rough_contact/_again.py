"""What is repeated: a run file, and the solver against exact solutions."""

from __future__ import annotations

import copy
import json
import os
from dataclasses import dataclass
from typing import Any, Literal

from . import _rough_contact as _rust
from . import _units
from ._errors import SettingError, dumped, of_file, sorted_as
from ._extras import extra
from ._progress import ProgressArgument
from ._solve import Method
from ._study import Comparison, studied
from ._surface import Surface, check
from ._threads import count

__all__ = ["Validation", "rerun", "validate"]


def rerun(
    path: str | os.PathLike[str],
    *,
    threads: int | None = None,
    progress: ProgressArgument = None,
    on_failure: Literal["raise", "keep"] = "raise",
) -> Comparison:
    """Repeats the study of a ``run.toml``: ``rough-contact compare --from``.

    Parameters
    ----------
    path : str or path
        The run file. Measurements are looked for where it says, relative to the working directory; one that has changed
        since is refused.
    threads, progress, on_failure
        As of `compare`.

    Returns
    -------
    Comparison
        With the numbers of the first run.

    Raises
    ------
    SettingError
        It is no run file, has heights or models that only the program had that made them, or a second body; or a
        measurement has changed.
    """
    check("on_failure", on_failure, ("raise", "keep"))
    with of_file(), open(path, encoding="utf-8") as file:
        text = file.read()
    with sorted_as(SettingError):
        run = json.loads(_rust.run_file(text))
    used = count(threads)
    named = {}
    for surface in run["surfaces"]:
        if surface["recipe"] is not None:
            named[surface["name"]] = Surface._made(*_rust.synth(dumped(surface["recipe"]), used))
            continue
        at, content, reading = surface["file"]
        beside = os.path.join(os.path.dirname(os.fspath(path)), at)
        at = beside if os.path.exists(beside) else at
        with of_file():
            heights, facts, said = _rust.read(at, dumped(reading), used)
        made = Surface._made(heights, facts, said)
        if made._said["sha256"] != content:
            raise SettingError(f"{at} has changed since {os.fspath(path)} was written; compare it anew", "changed_file")
        named[surface["name"]] = made
    return studied(named, {**run["settings"], "threads": used}, ([], None), progress, on_failure)


@dataclass(frozen=True, repr=False)
class Validation:
    """The solver against exact solutions.

    Attributes
    ----------
    rows : list of dict
        For each case, quantity and grid: ``computed`` and ``exact`` (SI; of a field the rms), relative ``error`` (of a field the rms of the
        difference), ``uncertainty`` of the exact value, ``observed_order`` and ``expected_order`` of the error in the distance of
        points, with the ``source``.
    """

    rows: list[dict[str, Any]]

    def __len__(self) -> int:
        return len(self.rows)

    def to_dict(self) -> dict[str, Any]:
        """The object of ``rough-contact validate --json``."""
        return copy.deepcopy({"rows": self.rows})

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of one line for each row."""
        pandas = extra("pandas", "tables")

        return pandas.DataFrame(self.rows)

    def __repr__(self) -> str:
        finest = {(row["case"], row["quantity"]): row for row in self.rows}
        lines = [f"Validation({len(finest)} quantities)"]
        for (case, quantity), row in finest.items():
            ny, nx = row["shape"]
            lines.append(f"  {case}, {quantity}: error {100 * row['error']:.2g} % on {ny} x {nx} points")
        return "\n".join(lines)


def validate(*, method: Method = "auto", finest: int = 256) -> Validation:
    """The solver against exact solutions, on this machine: ``rough-contact validate``.

    Parameters
    ----------
    method : {'auto', 'chord', 'polonsky-keer', 'stanley-kato'}
        How to solve.
    finest : int
        Points per side of the finest map; profiles have 16 times as many.

    Examples
    --------
    >>> import rough_contact as rc
    >>> found = rc.validate(finest=64)
    >>> abs(found.rows[-1]["error"]) < 0.1
    True
    """
    check("method", method, ("auto", "chord", "polonsky-keer", "stanley-kato"))
    finest = _units.whole(finest, "finest", 1, 1 << 14)
    with sorted_as(SettingError):
        return Validation(json.loads(_rust.validate(method, finest))["rows"])
