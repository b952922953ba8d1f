"""What is raised, and why."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from . import _rough_contact as _rust

__all__ = [
    "AccuracyNotMet",
    "ContactWarning",
    "Error",
    "InternalError",
    "Interrupted",
    "MissingPoints",
    "ModelError",
    "NotConverged",
    "ReadError",
    "SettingError",
    "SurfaceError",
    "UnitError",
]

ISSUES = "https://github.com/rough-contact/rough-contact/issues"


class Error(Exception):
    """Why there is no answer, or no complete one.

    Attributes
    ----------
    kind : str
        One word for scripts, the ``kind`` of the command's JSON.
    result : object or None
        What was found all the same, where something was.
    """

    def __init__(self, message: str, kind: str = "", result: Any = None) -> None:
        super().__init__(message)
        self.kind = kind
        self.result = result

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.kind, self.result)

    def to_dict(self) -> dict[str, str]:
        """Kind and message, as in the command's JSON."""
        return {"kind": self.kind, "message": str(self)}


class UnitError(Error, ValueError):
    """A bare number where a unit is needed, a unit of another kind, or a unit on a pure number."""


class ReadError(Error, ValueError):
    """A file that cannot be read, or that leaves something open."""


class MissingPoints(ReadError):
    """Points are missing, and ``fill='refuse'`` keeps none."""


class SurfaceError(Error, ValueError):
    """Heights that are no surface."""


class SettingError(Error, ValueError):
    """A setting, a load or a combination that is refused: exit status 2 of the command."""


class ModelError(Error, ValueError):
    """A closed form without meaning for these inputs."""


class NotConverged(Error, RuntimeError):
    """Loads without a solution to the tolerance; ``result`` has what was found."""


class AccuracyNotMet(Error, RuntimeError):
    """The accuracy asked for is not reached; ``result`` has what was found."""

class InternalError(Error, RuntimeError):
    """A bug of this package. Please report it."""


class Interrupted(KeyboardInterrupt):
    """Stopped by Ctrl-C.

    Attributes
    ----------
    partial : object or None
        The loads that were done.
    """

    def __init__(self, message: str = "", partial: Any = None) -> None:
        super().__init__(message)
        self.partial = partial

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (str(self), self.partial)


def stopped(by: BaseException, message: str, partial: Any) -> BaseException:
    """What ended a call, with what was done in ``.partial``."""
    if isinstance(by, KeyboardInterrupt):
        interrupted = Interrupted(message, partial)
        interrupted.__cause__ = by
        return interrupted
    by.partial = partial  # type: ignore[attr-defined]
    return by


class ContactWarning(UserWarning):
    """A finding that may change a conclusion."""


_KINDS: dict[str, type[Error]] = {
    "unit": UnitError,
    "missing": MissingPoints,
    "setting": SettingError,
    "combination": SettingError,
    "not_converged": NotConverged,
    "stopped_at_rounding": NotConverged,
    "accuracy_not_met": AccuracyNotMet,
    "model": ModelError,
}


def made(kind: str, message: str, default: type[Error], result: Any = None) -> Exception:
    """The exception of this kind of trouble."""
    if kind in ("internal", "panic"):
        text = f"rough_contact {_rust.__version__}: {message}; please report it at {ISSUES}"
        return InternalError(text, kind, result)
    return _KINDS.get(kind, default)(message, kind, result)


def dumped(value: Any) -> str:
    """JSON for the extension."""
    try:
        return json.dumps(value, allow_nan=False, default=_of_numpy)
    except ValueError:
        raise SettingError("a number of the request is not finite", "setting") from None


def _of_numpy(value: Any) -> Any:
    """A number of numpy, or of what has the same way out, as one of Python."""
    if getattr(value, "shape", None) == () and callable(getattr(value, "item", None)):
        return value.item()
    raise SettingError(f"{value!r} is no text and no number", "setting")


_UNREAD: dict[type[OSError], type[OSError]] = {}


def unread(number: int, why: str, path: str) -> OSError:
    """A file that the system does not give: an `Error` that is also the error of the system."""
    found = OSError(number, why, path)
    kind = type(found)
    if kind not in _UNREAD:
        members: dict[str, Any] = {"kind": "unreadable", "result": None, "__module__": __name__}
        members["__reduce__"] = lambda self: (unread, (self.errno, self.strerror, self.filename))
        _UNREAD[kind] = type(kind.__name__, (kind, ReadError), members)
    return _UNREAD[kind](number, why, path)


@contextmanager
def of_file() -> Iterator[None]:
    """As `sorted_as`, of a file."""
    try:
        with sorted_as(ReadError):
            yield
    except OSError as error:
        raise unread(error.errno or 0, error.strerror or str(error), str(error.filename or "")) from None


@contextmanager
def sorted_as(default: type[Error]) -> Iterator[None]:
    """What the extension refuses, as an exception of its kind, or of `default`."""
    try:
        yield
    except _rust.Refused as refused:
        kind, message, _ = refused.args
        raise made(kind, message, default) from None
