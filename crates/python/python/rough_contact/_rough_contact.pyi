"""Private: use the package `rough_contact`."""

from collections.abc import Callable
from typing import Any, TypeAlias, final

import numpy as np
from numpy.typing import NDArray

_Heights: TypeAlias = NDArray[np.float64]
_Made: TypeAlias = tuple[_Heights, str, str]
_Second: TypeAlias = tuple[_Heights, str, str]

__all__ = [
    "Closed",
    "Keep",
    "Refused",
    "__version__",
    "bodies",
    "bodies_line",
    "digest",
    "displacement",
    "encode",
    "given",
    "info",
    "leak",
    "material",
    "model",
    "model_inputs",
    "models",
    "modulus",
    "parse",
    "percent_within",
    "pressure_within",
    "profile",
    "profile_model",
    "profile_study",
    "psd",
    "read",
    "reshape",
    "run_file",
    "run_file_in",
    "solve",
    "spots",
    "statistics",
    "study",
    "study_pressures",
    "summary",
    "synth",
    "validate",
]

__version__: str

class Refused(Exception): ...

@final
class Keep:
    def __new__(cls) -> Keep: ...
    def is_warm(self) -> bool: ...
    def forget(self) -> None: ...

@final
class Closed:
    def __new__(cls, request: str, surface: tuple[_Heights, str] | None, threads: int) -> Closed: ...
    def at(self, pressures: _Heights) -> tuple[_Heights, _Heights]: ...

def parse(text: str, dimension: str, many: bool) -> list[float]: ...
def bodies(given: str) -> str: ...
def material(name: str | None) -> str: ...
def leak(along: str | None, seal: tuple[float | None, float | None, float | None, float | None]) -> str: ...
def read(path: str, request: str, threads: int, content: bytes | None = None) -> _Made: ...
def profile(
    path: str, request: str, level: str, threads: int, content: bytes | None = None, rows: _Heights | None = None
) -> tuple[_Heights, float, str, str, str]: ...
def displacement(pressure: _Heights, pixel: tuple[float, float], modulus: float, free: bool, threads: int) -> _Heights: ...
def spots(pressure: _Heights, pixel: tuple[float, float], repeats: bool) -> NDArray[np.int32]: ...
def profile_model(
    request: str, heights: _Heights, facts: str, threads: int
) -> tuple[str, tuple[str, str] | None]: ...
def profile_study(
    profiles: list[tuple[_Heights, str, str]], settings: str
) -> dict[str, str]: ...
def run_file(text: str) -> str: ...
def run_file_in(text: str, folder: str) -> str: ...
def percent_within(fraction: float, interval: tuple[float, float] | None) -> str: ...
def pressure_within(pascals: float | None, interval: tuple[float, float] | None) -> str: ...
def bodies_line(modulus: float, bodies: str) -> str: ...
def validate(method: str, finest: int) -> str: ...
def info(path: str, request: str, content: bytes | None = None) -> str: ...
def given(heights: _Heights, request: str, threads: int) -> _Made: ...
def synth(recipe: str, threads: int) -> _Made: ...
def reshape(heights: _Heights, facts: str, level: str, threads: int) -> _Made: ...
def encode(heights: _Heights, facts: str, format: str, comment: str) -> bytes: ...
def statistics(
    heights: _Heights, facts: str, request: str, threads: int, against: _Second | None = None
) -> str: ...
def psd(heights: _Heights, facts: str, level: str, threads: int) -> list[NDArray[np.float64]]: ...
def solve(
    heights: _Heights,
    facts: str,
    request: str,
    progress: Callable[[dict[str, Any]], object] | None = None,
    against: _Second | None = None,
    keep: Keep | None = None,
) -> tuple[
    str,
    list[tuple[int, _Heights | None, _Heights | None]],
    tuple[str, str] | None,
    BaseException | None,
]: ...
def model_inputs() -> str: ...
def models() -> str: ...
def digest(surface: str) -> str: ...
def summary(
    maps: list[tuple[str, str]], failed: list[tuple[str, str]], settings: str, seconds: float
) -> str: ...
def study_pressures(settings: str, rms_gradient: float) -> list[float]: ...
def study(
    surfaces: list[tuple[_Heights, str, str]],
    settings: str,
    own: str,
    progress: Callable[[dict[str, Any]], object] | None = None,
    against: _Second | None = None,
) -> tuple[dict[str, str], tuple[str, str] | None, BaseException | None]: ...
def model(
    request: str, surface: tuple[_Heights, str] | None, threads: int, against: _Second | None = None
) -> tuple[str, tuple[str, str] | None]: ...
