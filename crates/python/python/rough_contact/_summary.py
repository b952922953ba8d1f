"""Many studies on one page."""

from __future__ import annotations

import copy
import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Union

from . import _rough_contact as _rust
from ._errors import SettingError, dumped
from ._extras import extra
from ._results import flat
from ._study import Comparison

__all__ = ["Summary", "summary"]


@dataclass(frozen=True, repr=False)
class Summary:
    """Many maps: a few numbers of each, and the page of how they are spread.

    Attributes
    ----------
    maps : dict
        Of each map with an answer what `Comparison.digest` keeps, SI units.
    failed : dict
        The others, and why they have none.
    html : str
        The page of ``rough-contact compare --summary``; it needs nothing else.
    """

    maps: dict[str, dict[str, Any]]
    failed: dict[str, str]
    html: str

    def __len__(self) -> int:
        return len(self.maps)

    def __repr__(self) -> str:
        return f"Summary({len(self.maps)} maps, {len(self.failed)} without an answer)"

    def to_dict(self) -> dict[str, Any]:
        """The maps and what failed, as plain objects."""
        return copy.deepcopy({"maps": self.maps, "failed": self.failed})

    def records(self) -> list[dict[str, Any]]:
        """A flat dict for each map, without curves and checks: ``models.gw.area_error`` is its signed error at the headline."""
        left_out = ("curve", "checks")
        return [{"map": name, **flat({k: v for k, v in kept.items() if k not in left_out})} for name, kept in self.maps.items()]

    def to_pandas(self) -> Any:
        """A `pandas.DataFrame` of one line for each map."""
        pandas = extra("pandas", "tables")

        return pandas.DataFrame(self.records())

    def write(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
        """Writes the page.

        Raises
        ------
        FileExistsError
            If the file exists, unless `overwrite`.
        """
        with open(path, "w" if overwrite else "x", encoding="utf-8", newline="") as file:
            file.write(self.html)


def summary(
    studies: Iterable[Union[Comparison, Mapping[str, Any]]],
    *,
    failed: Mapping[str, object] | None = None,
) -> Summary:
    """One page over many maps, as ``rough-contact compare --summary`` makes it.

    Parameters
    ----------
    studies : iterable of Comparison or of what `Comparison.digest` keeps
        In any order; the same settings, names that tell the maps apart.
    failed : mapping, optional
        Maps without an answer, and why: text or an exception.

    Raises
    ------
    SettingError
        The studies were not asked the same, or two maps have one name.

    Examples
    --------
    >>> import rough_contact as rc
    >>> def one(seed):
    ...     s = rc.synth((64, 64), pixel='1um', hurst=0.8, rolloff='32um', cutoff='8um', rms_gradient=0.1, seed=seed)
    ...     return rc.compare(s, modulus='110 GPa', pressure='100MPa,1GPa', models=['gw', 'persson']).digest()
    >>> rc.summary([one(seed) for seed in (1, 2, 3)], failed={'4.x3p': 'it is cut off'})
    Summary(3 maps, 1 without an answer)
    """
    maps: dict[str, dict[str, Any]] = {}
    without: dict[str, str] = {name: str(why) for name, why in (failed or {}).items()}
    asked: dict[str, Any] | None = None
    seconds = 0.0
    for study in studies:
        kept = study.digest() if isinstance(study, Comparison) else study
        settings = {k: v for k, v in kept["settings"].items() if k != "threads"}
        if asked is None:
            asked = settings
        elif settings != asked:
            other = sorted(k for k in {*settings, *asked} if settings.get(k) != asked.get(k))
            raise SettingError(f"the studies differ in {', '.join(other)}; a page is over maps that were asked the same", "combination")
        twice = sorted({*maps} & {*kept["maps"]})
        if twice:
            raise SettingError(f"two maps are called {twice[0]}; name them with rc.compare({{name: surface}}, ...)", "combination")
        maps.update(kept["maps"])
        without.update(kept["refused"])
        seconds += kept["seconds"]
    if asked is None:
        raise SettingError("a page needs at least one study", "combination")
    html = _rust.summary(
        [(name, dumped(kept)) for name, kept in maps.items()],
        list(without.items()),
        dumped({**asked, "threads": 1}),
        seconds,
    )
    return Summary(maps, without, html)
