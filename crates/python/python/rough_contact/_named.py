"""What a study is asked about, under names that tell its members apart."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Protocol, TypeVar, Union, cast

__all__ = ["named"]


class _Named(Protocol):
    @property
    def name(self) -> str: ...


T = TypeVar("T", bound=_Named)


def named(given: Union[T, Iterable[T], Mapping[str, T]], kind: type[T], way_out: str = "") -> dict[str, T]:
    """One of a kind, several, or a mapping whose keys name them; of those with one name the later ones are numbered."""
    what = kind.__name__.lower()
    found: dict[str, T] = {}
    if isinstance(given, Mapping):
        for key, one in given.items():
            if not isinstance(key, str):
                raise TypeError(f"the key {key!r} of {what}s is no text; name it {str(key)!r}")
            if not isinstance(one, kind):
                raise TypeError(f"{what}s[{key!r}] takes rc.{kind.__name__}, not {type(one).__name__}{way_out}")
        found = dict(given)
    else:
        # A surface could be taken for the rows of its heights.
        several = isinstance(given, Iterable) and not isinstance(given, kind)
        members = cast("Iterable[object]", given if several else [given])
        for one in members:
            if not isinstance(one, kind):
                raise TypeError(f"{what}s takes rc.{kind.__name__}, not {type(one).__name__}{way_out}")
            name, k = one.name, 1
            while name in found:
                k += 1
                name = f"{one.name} ({k})"
            found[name] = one
    if not found:
        raise TypeError(f"a study needs at least one {what}")
    return found
